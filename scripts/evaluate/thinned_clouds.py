#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""How many points change their class when a cloud is thinned. Markdown goes to standard output.
Usage: scripts/evaluate/thinned_clouds.py BUILD_DIR [-seeds N] [-width W]
Depth images are generated (seeds 1 to N) for each kind of noise, and thinned at random to 1/2, 1/4 and 1/16 of their points. The
classes of the points that are left, planar or curved, are compared with those that they have in the whole image: of all, and
of those that the truth knows (not within 10 mm of a crease). Needs python3-numpy.
"""
import argparse
import pathlib
import subprocess
import tempfile

import numpy

from evaluate_sensors import fields_of, run, share, write_pcd

NOISES = {"kinect": "a Kinect's", "none": "none", "0.002": "white, 2 mm"}
PARTS = (2, 4, 16)


def changes(apps, cloud, rng):
    """For each thinned cloud two shares: of all points, and of those with a truth."""
    whole = run(apps, "pcl_shape_back_projection", cloud, "-threads", "1")
    truth = fields_of(cloud)["surface"]
    order = rng.permutation(len(truth))
    for part in PARTS:
        kept = numpy.sort(order[:len(order) // part])
        thinned = cloud.with_name("thinned.pcd")
        write_pcd(thinned, {axis: whole[axis][kept] for axis in "xyz"})
        surface = run(apps, "pcl_shape_back_projection", thinned, "-threads", "1")["surface"]
        changed = surface != whole["surface"][kept]
        is_known = (truth[kept] == 1) | (truth[kept] == 2)
        yield changed.mean(), changed[is_known].mean()


def main():
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("build", type=pathlib.Path)
    parser.add_argument("-seeds", type=int, default=1)
    parser.add_argument("-width", type=int, default=1280)
    arguments = parser.parse_args()
    apps = arguments.build / "apps"
    print("| noise | " + " | ".join(f"1/{part} | away from creases" for part in PARTS) + " |")
    print("|---" * (1 + 2 * len(PARTS)) + "|")
    for noise, title in NOISES.items():
        rows = []
        for seed in range(1, arguments.seeds + 1):
            with tempfile.TemporaryDirectory() as directory:
                cloud = pathlib.Path(directory) / "scene.pcd"
                subprocess.run([apps / "pcl_shape_scene", cloud, "-seed", str(seed), "-width", str(arguments.width),
                                "-height", str(arguments.width * 3 // 4), "-noise", noise], check=True,
                               stdout=subprocess.DEVNULL)
                rows.append(list(changes(apps, cloud, numpy.random.default_rng(seed))))
        print(f"| {title} | " + " | ".join(share(s) for s in numpy.mean(rows, 0).ravel()) + " |", flush=True)


if __name__ == "__main__":
    main()
