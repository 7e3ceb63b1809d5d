#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Write into doc/upstream.md how large the pull requests to PCL would be: files and lines of each.

Usage: scripts/upstream_sizes.py
A file belongs to the first pull request that names it; a name that no file has is an error.
"""
import pathlib
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
HEADERS, SEGMENTATION = "include/pcl/features/", "include/pcl/segmentation/"
SERIES = [
    ("`NeighborhoodSweep`, without SIMD", [
        HEADERS + "neighborhood_sweep.h", HEADERS + "sweep_index.h", HEADERS + "xyz_view.h", HEADERS + "cancellation.h",
        "src/common/*", "src/sweep/*.*", "src/sweep/index/*", "src/sweep/portable/*", "test/sweep/*", "test/support/*"]),
    ("its SIMD kernels, with Highway if it is found", ["src/sweep/simd/*"]),
    ("`NormalEstimationSweep`", [
        HEADERS + "adaptive_radius.h", HEADERS + "normal_3d_sweep.h", HEADERS + "impl/normal_3d_sweep.hpp",
        HEADERS + "impl/neighborhoods.hpp", "src/features/normal_3d_sweep.cpp", "src/features/*neighborhoods.*",
        "src/features/local_spacing.*", "test/features/test_normal_3d_sweep.cpp", "test/features/test_adaptive_radius.cpp",
        "test/features/test_search_methods.cpp", "test/features/test_listed_neighborhoods.cpp",
        "test/features/test_shared_index.cpp", "test/features/test_custom_point_type.cpp",
        "test/features/test_point_types.cpp", "test/features/test_feature_errors.cpp"]),
    ("`INAD` and `INADEstimation`", [
        HEADERS + "inad*.h", HEADERS + "impl/inad.hpp", "src/features/inad.cpp", "test/features/test_inad.cpp"]),
    ("`ShapeHistogram` and `ShapeModel`", [
        HEADERS + "shape_*.h", "src/features/shape_*", "src/features/default_models*", "models/*",
        "test/features/test_shape_*"]),
    ("`ShapeFieldEstimation`, `ShapeEdgeDetection`, `ShapeBackProjection`", [
        HEADERS + "*", "src/features/*", "src/geometry/*", "src/edges/*", "src/surfaces/*",
        SEGMENTATION + "*shape_field*", SEGMENTATION + "*shape_detection*", SEGMENTATION + "*shape_edge_detection*",
        SEGMENTATION + "*shape_back_projection*", SEGMENTATION + "*unknown_points*",
        SEGMENTATION + "*cloud_reach*", "src/segmentation/cloud_reach*",
        SEGMENTATION + "impl/shape_field*", SEGMENTATION + "impl/shape_detection*", SEGMENTATION + "impl/shape_edge*",
        SEGMENTATION + "impl/shape_back*", "src/segmentation/field_places*", "src/segmentation/shape_detection*",
        "src/segmentation/shape_field*", "src/segmentation/unknown_points*", "test/features/*",
        *(f"test/segmentation/{name}*" for name in (
            "crease_truth", "detect", "small_surfaces", "test_adaptive", "test_close", "test_coincident", "test_crease",
            "test_detection", "test_edge", "test_generated", "test_own", "test_paper", "test_point", "test_real_scenes",
            "test_resolution", "test_shape_detection", "test_shape_field", "test_uneven", "test_unknown"))]),
    ("`ShapeInstanceSegmentation`", [
        "src/instances/*", SEGMENTATION + "*instance*", SEGMENTATION + "impl/*instance*", "src/segmentation/*instance*",
        "test/segmentation/*instance*", "test/segmentation/*objects*", "test/segmentation/*face*",
        "test/segmentation/*primitive*"]),
]
KINDS = {"headers": ("include/",), "sources": ("src/", "models/"), "tests": ("test/",)}
BEGIN, END = "<!-- begin upstream -->\n", "<!-- end upstream -->"


def lines_of(path):
    return len(path.read_text(encoding="utf-8").splitlines())


def row(number, what, patterns, taken):
    """One line of the table; the files are taken from then on."""
    counts = {kind: [0, 0] for kind in KINDS}
    for pattern in patterns:
        found = [path for path in sorted(ROOT.glob(pattern)) if path.is_file()]
        if not found:
            sys.exit(f"{pattern}: no such file; expected those of the pull request {what}")
        for path in found:
            if path in taken:
                continue
            taken.add(path)
            name = path.relative_to(ROOT).as_posix()
            kind = next(kind for kind, folders in KINDS.items() if name.startswith(folders))
            counts[kind][0] += 1
            counts[kind][1] += lines_of(path)
    cells = " | ".join(f"{files} file{'s'[:files != 1]}, {lines:,} lines" if files else "–"
                       for files, lines in counts.values())
    return f"| {number} | {what} | {cells} |\n"


def main():
    page = ROOT / "doc" / "upstream.md"
    taken = set()
    table = "| | pull request | headers | sources | tests |\n|---|---|---|---|---|\n"
    for number, (what, patterns) in enumerate(SERIES, 1):
        table += row(number, what, patterns, taken)
    text = page.read_text(encoding="utf-8")
    before, rest = text.split(BEGIN)
    page.write_text(before + BEGIN + table + END + rest.split(END)[1], encoding="utf-8")


if __name__ == "__main__":
    main()
