#!/usr/bin/env python3
"""Check who includes whom, and how files begin.

Usage: scripts/check_includes.py [-closure FILE]
The rooms of src and of apps, and those inside of a room, know only those before them, the engine (src/sweep) knows
neither PCL nor Eigen, and applications know only public headers. Every C++ file begins with the license and one line
that says what it is for. Prints what is wrong; exit status 1 if anything is. With -closure: all that FILE includes,
directly or not.
"""
import argparse
import functools
import pathlib
import re
import subprocess
import sys

ROOT = pathlib.Path(__file__).resolve().parent.parent
# Rooms of src and of apps; those in the same brackets do not know each other.
ORDER = [["common"], ["geometry", "tiling"], ["sweep"], ["features"], ["edges"], ["surfaces"],
         ["instances", "grasps", "ground", "labels"], ["segmentation"]]
APPS_ORDER = [["io"], ["cli"], ["results"], ["detection", "evaluation", "scene", "viewer"], ["labels", "tiles"]]
# Rooms inside of a room; files beside them know all of these and are known to all.
INNER_ORDERS = {"src/features": [["spacing"], ["noise"], ["models"]],
                "src/instances": [["primitives"], ["pieces", "faces"], ["supports", "objects"]],
                "tools/scene": [["parts"], ["worlds"], ["sensors"]]}


def ranked(order):
    return {room: rank for rank, rooms in enumerate(order) for room in rooms}


RANK, APPS_RANK = ranked(ORDER), ranked(APPS_ORDER)
INNER_RANKS = {folder: ranked(order) for folder, order in INNER_ORDERS.items()}
# A public header counts as the room that implements it; others as the folder that they are in.
PUBLIC = {"xyz_view": "common", "cancellation": "common", "neighborhood_sweep": "sweep", "sweep_index": "sweep",
          "shape_field": "edges",
          "shape_instance_segmentation": "instances", "instances_of_parts": "instances", "suction_grasp_estimation": "grasps",
          "shape_labeling": "labels", "shape_ground_segmentation": "ground", "ground_likelihoods": "ground"}
# What folders outside of src may include besides themselves; tests may include everything.
KNOWS = {"include": [], "python": ["include"], "tools": ["include", "src/labels/"], "apps": ["include", "tools"],
         "doc": ["include", "benchmarks/keypoints/align.h"],
         "benchmarks": ["include", "tools", "apps", "test/support", "src/sweep/portable/targets.h"]}
FROM_ROOT = {"src": ["src"], "tools": ["tools", "src"], "apps": ["apps", "tools"]}
INCLUDE = re.compile(r'^\s*#\s*include\s+([<"])([^>"]+)[>"]', re.M)
HEADER = re.compile(r"// SPDX-License-Identifier: BSD-3-Clause\n// SPDX-FileCopyrightText: .+\n// (?!PURPOSE)\S.*\n")
MACHINE_PATH = re.compile(r"(?<![\w.$}~])/(?:home|root|work|tmp)/\w+")


def listed(*folders):
    """The repository's files."""
    names = subprocess.check_output(["git", "ls-files", "-co", "--exclude-standard", *folders], cwd=ROOT, text=True)
    return [name for name in names.split("\n") if name and (ROOT / name).is_file()]


def is_code(name):
    return name.endswith((".cpp", ".h", ".hpp", ".cpp.in"))


def found(name, written):
    """The repository's file that an include means, or None."""
    roots = FROM_ROOT.get(name.split("/")[0]) or [str(pathlib.Path(name).parent), "test", "test/apps", "test/viewer",
                                                  "benchmarks", "benchmarks/keypoints", "src", "apps",
                                                  "tools"]
    for root in roots + ["include"]:
        path = (ROOT / root / written).resolve()
        if path.is_file() and ROOT in path.parents:
            return str(path.relative_to(ROOT))
    return None


@functools.cache
def includes(name):
    """Pairs of what is written in a file's includes and the file that it means."""
    text = (ROOT / name).read_text()
    return [(quote + written, found(name, written)) for quote, written in INCLUDE.findall(text)]


def closure(name):
    """All that a file includes: the repository's files, and others' headers with who includes them."""
    inside, outside, todo = {name: None}, {}, [name]
    while todo:
        current = todo.pop()
        for written, target in includes(current):
            if not target:
                outside.setdefault(written[1:], current)
            elif target not in inside:
                inside[target] = current
                todo.append(target)
    return inside, outside


def room(name):
    """The room of src or apps that a file belongs to, or None."""
    parts = name.split("/")
    if parts[0] in ("src", "apps") and len(parts) > 2:
        return parts[1]
    if parts[0] == "include":
        return PUBLIC.get(pathlib.Path(name).stem, parts[2])
    return None


def is_inner_allowed(name, target):
    """Whether a file of a room inside of another one may include a file of its neighbor."""
    (*outer, inner), (*other_outer, other) = name.split("/")[:3], target.split("/")[:3]
    ranks = INNER_RANKS.get("/".join(outer), {}) if outer == other_outer else {}
    return inner == other or inner not in ranks or other not in ranks or ranks[other] < ranks[inner]


def is_allowed(name, target):
    """Whether a file may include another one of the repository."""
    folder = name.split("/")[0]
    if not is_inner_allowed(name, target):
        return False
    if folder in ("src", "include") and target.startswith(("src/", "include/")):
        if folder == "include" and target.startswith("src/"):
            return False
        here, there = room(name), room(target)
        # A class's header knows the class that it builds on; its room knows only the header.
        return folder == "include" or here == there or RANK[there] < RANK[here]
    if folder == "apps" and target.startswith("apps/") and room(name):
        return room(name) == room(target) or APPS_RANK[room(target)] < APPS_RANK[room(name)]
    return folder == "test" or any(target.startswith(start) for start in [folder + "/", *KNOWS.get(folder, [])])


def wrong_includes(name):
    for written, target in includes(name):
        if target and not is_allowed(name, target):
            yield f"{name}: includes {target}, which it must not know"
        elif not target and written[0] == '"':
            yield f"{name}: \"{written[1:]}\" is not found from the root of its folder"
    if room(name) == "sweep":
        for header, by in closure(name)[1].items():
            if re.match(r"(pcl|Eigen|boost)/", header) and header != "pcl/pcl_shape_exports.h":
                yield f"{name}: the engine includes <{header}>, by {by}"


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("-closure", metavar="FILE")
    arguments = parser.parse_args()
    if arguments.closure:
        inside, outside = closure(str(pathlib.Path(arguments.closure).resolve().relative_to(ROOT)))
        print("\n".join([*sorted(inside), *(f"<{header}>" for header in sorted(outside))]))
        return
    problems = []
    for name in filter(is_code, listed("src", "include", "python", "apps", "tools", "test", "benchmarks", "doc")):
        problems += wrong_includes(name)
        if not name.startswith(("include/", "doc/")) and not HEADER.match((ROOT / name).read_text()):
            problems.append(f"{name}: begins without the license's two lines and one that says what it is for")
    for name in listed():
        if not name.endswith((".png", ".pcd", ".gif")):
            for path in MACHINE_PATH.findall((ROOT / name).read_text()):
                problems.append(f"{name}: path of one machine, {path}")
    print("\n".join(problems) or "includes and first lines are right")
    sys.exit(bool(problems))


if __name__ == "__main__":
    main()
