#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Lay the pull requests of doc/upstream.md into a source tree of PCL that has none of them yet.

Usage: scripts/upstream/lay_out.py PCL_SOURCE [PULL_REQUESTS]
PULL_REQUESTS: the first so many only. Prints the targets that were added: tests and tools.
"""
import pathlib
import re
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from upstream import build_files, tutorials  # noqa: E402
from upstream.places import SHAPE, place_of, text_of  # noqa: E402
from upstream.series import ROOT, files_of_series  # noqa: E402

# The test program of each pull request that has tests.
TESTS = {1: "neighborhood_sweep", 3: "inad_estimation", 4: "normal_estimation_sweep", 5: "shape_model",
         6: "shape_detection", 7: "shape_instance_segmentation"}
FIRST_WITH_JSON = 5
# The tools: behind which others they come, what they are linked with, whether they need JSON.
TOOLS = {
    "inad_estimation": ("pcl_normal_estimation pcl_common pcl_io pcl_kdtree pcl_features", "pcl_features", False),
    "shape_instance_segmentation": ("pcl_crf_segmentation pcl_common pcl_io pcl_segmentation",
                                    "pcl_features pcl_segmentation", True),
}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)
MADE_BY_CMAKE = {"pcl/pcl_shape_exports.h", "pcl/pcl_shape_alignment.h"}
SCENES = f"""
# Generated scenes, the same on every machine: no fused operations.
add_library(pcl_{SHAPE}_scenes STATIC EXCLUDE_FROM_ALL
            {{files}})
target_include_directories(pcl_{SHAPE}_scenes PUBLIC {SHAPE})
set_target_properties(pcl_{SHAPE}_scenes PROPERTIES UNITY_BUILD OFF)
if(NOT MSVC)
  target_compile_options(pcl_{SHAPE}_scenes PRIVATE -ffp-contract=off)
endif()
"""
FEATURES_SOURCES = "${PCL_SOURCE_DIR}/features/src/" + SHAPE
SEGMENTATION_SOURCES = "${PCL_SOURCE_DIR}/segmentation/src/" + SHAPE
TEST_SUPPORT = "${PCL_SOURCE_DIR}/test/features/" + SHAPE


def is_code(name):
    return name.endswith((".h", ".hpp", ".cpp", ".cpp.in"))


def find_missing(series):
    """What files include of the repository that no pull request up to theirs has."""
    known, missing = set(), []
    for title, names in series:
        known.update(names)
        for name in filter(is_code, names):
            beside = pathlib.PurePosixPath(name).parent
            for quote, written in INCLUDE.findall((ROOT / name).read_text(encoding="utf-8")):
                roots = ["include"] if quote == "<" else [str(beside), "src", "test", "tools"]
                found = [f"{root}/{written}" for root in roots if (ROOT / root / written).is_file()]
                if found and found[0] not in known and written not in MADE_BY_CMAKE:
                    missing.append(f"{name} of {title} includes {found[0]}, which comes later or never")
    return missing


def lay_files(names, tree):
    for name in names:
        path = tree / place_of(name)
        path.parent.mkdir(parents=True, exist_ok=True)
        text = (ROOT / name).read_text(encoding="utf-8")
        path.write_text(text_of(name, text) if is_code(name) else text, encoding="utf-8")


def test_of(number, names):
    """The test program of a pull request, in the terms of build_files.add_tests()."""
    places = [place_of(name) for name in names if name.startswith("test/") and name.endswith(".cpp")]
    module = "segmentation" if number >= 6 else "features"
    own = f"test/{module}/"
    files = [place[len(own):] if place.startswith(own) else f"${{PCL_SOURCE_DIR}}/{place}" for place in places]
    folders = [SHAPE, FEATURES_SOURCES]
    libraries = "pcl_gtest pcl_features pcl_search pcl_kdtree pcl_octree"
    if module == "segmentation":
        folders += [TEST_SUPPORT, SEGMENTATION_SOURCES]
        libraries += f" pcl_segmentation pcl_{SHAPE}_scenes"
    return module, {"name": TESTS[number], "files": files, "folders": folders, "libraries": libraries,
                    "json": number >= FIRST_WITH_JSON}


def lay_tests(series, tree):
    programs = [test_of(number, names) for number, (_, names) in enumerate(series, 1) if number in TESTS]
    scenes = [place_of(name)[len("test/segmentation/"):] for _, names in series for name in names
              if name.startswith("tools/scene/") and name.endswith(".cpp")]
    for module in sorted({module for module, _ in programs}):
        before = SCENES.format(files="\n            ".join(scenes)) if module == "segmentation" else ""
        build_files.add_tests(tree, module, [test for of, test in programs if of == module], before)


def lay_modules(series, tree):
    plain, json = ([place_of(name) for _, names in part for name in names if is_code(name)]
                   for part in (series[:FIRST_WITH_JSON - 1], series[FIRST_WITH_JSON - 1:]))
    if json:
        build_files.find_json(tree)
    build_files.extend_module(tree, build_files.Module("features", plain, json), [f"src/{SHAPE}"], models=bool(json))
    segmentation = build_files.Module("segmentation", plain, json)
    if segmentation.json["srcs"]:
        build_files.extend_module(tree, segmentation, [f"src/{SHAPE}", FEATURES_SOURCES])


def is_tool(name):
    return name.startswith("tools/upstream/") and name.endswith(".cpp")


def lay_extras(names, tree):
    """Tools and tutorials."""
    for name in names:
        path = pathlib.PurePosixPath(name)
        if is_tool(name):
            build_files.add_tool(tree, path.stem, *TOOLS[path.stem])
        elif name.startswith(tutorials.CONTENT):
            tutorials.lay_tutorial(path.stem, tree)


def count_of(written, most):
    """How many pull requests, of a command line."""
    if not re.fullmatch("[0-9]+", written) or not 1 <= int(written) <= most:
        sys.exit(f"'{written}' pull requests: it must be a number from 1 to {most}")
    return int(written)


def targets_of(series):
    tests = [f"test_{TESTS[number]}" for number in sorted(TESTS) if number <= len(series)]
    return tests + [f"pcl_{pathlib.PurePosixPath(name).stem}" for _, names in series for name in filter(is_tool, names)]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    tree = pathlib.Path(sys.argv[1])
    series = files_of_series()
    count = count_of(sys.argv[2], len(series)) if len(sys.argv) == 3 else len(series)
    missing = find_missing(series)
    if missing:
        sys.exit("\n".join(missing))
    series = series[:count]
    if not (tree / "features" / "CMakeLists.txt").is_file():
        sys.exit(f"{tree}: no source tree of PCL; expected one with features/CMakeLists.txt")
    if (tree / "features" / "src" / SHAPE).exists():
        sys.exit(f"{tree}: it has the files already; expected a tree without features/src/{SHAPE}")
    for _, names in series:
        lay_files([name for name in names if not name.startswith("doc/")], tree)
    lay_modules(series, tree)
    lay_tests(series, tree)
    for _, names in series:
        lay_extras(names, tree)
    print("\n".join(targets_of(series)))


if __name__ == "__main__":
    main()
