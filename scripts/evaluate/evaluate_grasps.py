#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the tables of suction grasps in doc/grasps.md and doc/evaluation.md: no options but the cup's radius. Markdown
goes to standard output. Objects are those of the truth; pcl_shape_evaluate -task grasps judges the first grasp of each.
Usage: scripts/evaluate/evaluate_grasps.py BUILD_DIR DATA_DIR [CUP_RADIUS]
       scripts/evaluate/evaluate_grasps.py BUILD_DIR -generated [CUP_RADIUS]   # generated scenes only, without data
DATA_DIR is that of scripts/evaluate/evaluate_sensors.py. Needs python3-numpy and python3-scipy.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

from evaluate_sensors import fields_of, generate, report

# Nothing was chosen by these seeds; sensors and kinds of objects vary.
GENERATED = [(f"generated {seed}, {sensor}", seed, ("-sensor", sensor, "-objects", "6"))
             for seed, sensor in ((951, "camera"), (952, "camera"), (953, "stereo"), (954, "tof"), (955, "structured"))]


def grasps_of(apps, cloud, field, parts, radius, path):
    """The first grasp of each object; pcl_shape_grasp writes them to a path."""
    subprocess.run([apps / "pcl_shape_grasp", cloud, "-each", field, "-parts", str(parts), "-cup_radius", str(radius),
                    "-max_grasps", "1", "-json", path], check=True, stdout=subprocess.DEVNULL)
    return json.loads(path.read_text())["grasps"]


def judged(apps, cloud, field, parts, radius):
    """The report of pcl_shape_evaluate."""
    with tempfile.TemporaryDirectory() as directory:
        grasps = pathlib.Path(directory) / "grasps.json"
        grasps_of(apps, cloud, field, parts, radius, grasps)
        return report(apps, "pcl_shape_evaluate", grasps, cloud, "-task", "grasps", "-parts", str(parts))


def real_clouds(data):
    """Data set, name, cloud, labels to an object."""
    clouds = [("osd", path) for path in data.glob("osd/learn*.pcd")]
    clouds += [("osd/objects", path) for path in data.glob("osd/objects/learn*.pcd")]
    clouds = [item for item in clouds if item[1].stem[len("learn"):].isdigit()]
    clouds.sort(key=lambda item: int(item[1].stem[len("learn"):]))
    yield from ((data_set, path.stem, path, 10) for data_set, path in clouds)
    for path in sorted(data.glob("rgbd/*.pcd")):
        if "label" in fields_of(path):
            yield "rgbd", path.stem, path, 1


def word(is_so):
    return "yes" if is_so else "no"


def rows_of(name, judgment):
    for of in judgment["objects"]:
        angle = "–" if of["angle_degrees"] is None else f"{of['angle_degrees']:.1f}°"
        yield (f"| {name} | {of['object']} | {word(of['has_face'])} | {of['first_grasp']} | {word(of['is_on_object'])} | "
               f"{word(of['is_whole'])} | {angle} |")


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: scripts/evaluate/evaluate_grasps.py BUILD_DIR DATA_DIR|-generated [CUP_RADIUS]")
    apps = pathlib.Path(sys.argv[1]) / "apps"
    radius = float(sys.argv[3]) if len(sys.argv) == 4 else 0.01
    sums = {}
    print("| cloud | object | has a face for the cup | first grasp | on the object | no hole | off its normal |")
    print("|---|---|---|---|---|---|---|")

    def add(data_set, name, judgment):
        for row in rows_of(name, judgment):
            print(row, flush=True)
        counts = sums.setdefault(data_set, [0, 0, 0])
        for k, count in enumerate(("objects", "with_face", "right")):
            counts[k] += judgment["counts"][count]

    if sys.argv[2] != "-generated":
        for data_set, name, cloud, parts in real_clouds(pathlib.Path(sys.argv[2])):
            add(data_set, name, judged(apps, cloud, "label", parts, radius))
    for name, seed, options in GENERATED:
        with tempfile.TemporaryDirectory() as directory:
            cloud = pathlib.Path(directory) / "scene.pcd"
            generate(apps, cloud, seed, options)
            add("generated", name, judged(apps, cloud, "instance", 1, radius))
    print("\n| data set | objects | with a face for the cup | of these with a right first grasp |\n|---|---|---|---|")
    for data_set, (objects, with_face, right) in sums.items():
        print(f"| {data_set} | {objects} | {with_face} | {right} |")


if __name__ == "__main__":
    main()
