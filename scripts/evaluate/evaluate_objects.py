#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the table of whole objects in generated scenes in doc/evaluation.md: objects of all kinds that touch and stand on
each other, on a table and in a bin, seen by four cameras, no options. Markdown goes to standard output, a line for each
scene to standard error.
Usage: scripts/evaluate/evaluate_objects.py BUILD_DIR [FIRST_SEED [SEEDS]]
Seeds are 961 to 968 unless others are given; nothing was chosen by them. Scenes have 4, 8 and 12 objects in turn.
Needs python3-numpy and python3-scipy.
"""
import pathlib
import sys
import tempfile

from evaluate_sensors import generate, report

CAMERAS = ("camera", "stereo", "tof", "structured")
COUNTS = (4, 8, 12)
PLACES = ("table", "bin")


def score(apps, cloud):
    """The report of pcl_shape_evaluate."""
    found = cloud.with_name("found.pcd")
    report(apps, "pcl_shape_instances", cloud, found, "-class", "object", "-format", "binary")
    return report(apps, "pcl_shape_evaluate", found, cloud, "-task", "objects")


def print_place(apps, place, first, seeds):
    rows = {}
    for camera in CAMERAS:
        for seed in range(first, first + seeds):
            count = COUNTS[seed % len(COUNTS)]
            with tempfile.TemporaryDirectory() as directory:
                cloud = pathlib.Path(directory) / "scene.pcd"
                generate(apps, cloud, seed,
                         ("-place", place, "-sensor", camera, "-objects", str(count), "-organized"))
                of_scene = score(apps, cloud)
            print(f"{place}, {camera}, seed {seed}: {of_scene['found']} of {of_scene['objects']}",
                  file=sys.stderr, flush=True)
            rows.setdefault((camera, count), []).append(
                (of_scene["found"], of_scene["objects"], of_scene["overlap"]["f1"]))
    found_sum = object_sum = 0
    for (camera, count), scores in sorted(rows.items()):
        found, objects = (sum(of[k] for of in scores) for k in (0, 1))
        found_sum, object_sum = found_sum + found, object_sum + objects
        overlap = sum(of[2] for of in scores) / len(scores)
        print(f"| {place} | {camera} | {count} | {found} of {objects} | {overlap:.3f} |")
    print(f"| {place} | all | | {found_sum} of {object_sum} ({100 * found_sum / object_sum:.1f} %) | |")


def main():
    if len(sys.argv) not in (2, 3, 4):
        sys.exit("usage: scripts/evaluate/evaluate_objects.py BUILD_DIR [FIRST_SEED [SEEDS]]")
    apps = pathlib.Path(sys.argv[1]) / "apps"
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 961
    seeds = int(sys.argv[3]) if len(sys.argv) > 3 else 8
    print("| place | camera | objects in a scene | found at IoU .7 | overlap F |")
    print("|---|---|---|---|---|")
    for place in PLACES:
        print_place(apps, place, first, seeds)


if __name__ == "__main__":
    main()
