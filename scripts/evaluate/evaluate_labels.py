#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the tables of doc/labels.md: how many labels pcl_shape_label keeps, and how many of these are right. Markdown goes to
standard output.
Usage: scripts/evaluate/evaluate_labels.py BUILD_DIR [DATA_DIR]
DATA_DIR/parts has the sampled parts of doc/evaluation.md, DATA_DIR/osd learn4_gt.pcd and so on; without it only generated
worlds and scenes are labeled. Seeds from 460001 and from 500001 on are used for nothing else. Needs python3-numpy and python3-scipy.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy

from evaluate_sensors import GENERATED, SAMPLINGS, edge_points, fields_of, generate, sampled_parts, surface_points

NAMES = {1: "planar", 2: "curved", 3: "edge"}
WORLDS = {
    **sampled_parts(0.001),
    "part, photogrammetry": ("-place", "part", "-sensor", "photogrammetry"),
    **{title: GENERATED[title] for title in (
        "parts on a table, stereo", "parts on a table, structured light", "table, stereo", "table, time of flight",
        "table, structured light")},
    "room, one station": ("-place", "room", "-sensor", "station", "-step", "0.4"),
    "room, three stations": ("-place", "room", "-sensor", "station", "-stations", "3", "-step", "0.6"),
    "house front": ("-place", "facade", "-sensor", "station"),
}
SEEDS = (460001, 460002)
SCENES = {
    **{f"Kinect, seed {seed}": (seed, ()) for seed in range(500001, 500011)},
    **{f"camera, noise {sigma}, seed 500011": (500011, ("-noise", sigma)) for sigma in ("none", "0.0005", "0.001", "0.002")},
    **{f"sampled at 2 mm, noise {sigma}, seed 500012": (500012, ("-sampling", "0.002", "-noise", sigma))
       for sigma in ("none", "0.0002", "0.0004")},
}


def truth_of(cloud):
    """Planar 1, curved 2, edge 3; 0 where it may be called either way."""
    edge, surface = cloud["edge"], cloud["surface"]
    is_surface = (edge == 0) & ((surface == 1) | (surface == 2))
    if "thin_s" in cloud:
        is_surface &= surface_points(cloud) & edge_points(cloud)
        edge = numpy.where(edge_points(cloud), edge, 255)
    return numpy.where(edge == 1, 3, numpy.where(is_surface, surface, 0))


def labeled(apps, cloud):
    """(truth, label) of the points whose truth counts."""
    truth = truth_of(fields_of(cloud))
    with tempfile.TemporaryDirectory() as directory:
        out = pathlib.Path(directory) / "out.pcd"
        subprocess.run([apps / "pcl_shape_label", cloud, out], check=True, stdout=subprocess.DEVNULL)
        label = fields_of(out)["label"]
    return numpy.stack([truth, label])[:, truth > 0].astype(int)


def share(part, whole, digits):
    return f"{numpy.count_nonzero(part) / numpy.count_nonzero(whole):.{digits}f}" if whole.any() else "–"


def row(name, pairs):
    truth, label = pairs
    kept, right = label > 0, label == truth
    cells = [share(kept, truth > 0, 3), share(right, kept, 4)]
    for number in NAMES:
        cells += [share(right & (label == number), label == number, 3), share(right & (truth == number), truth == number, 3)]
    print(f"| {name} | " + " | ".join(cells) + " |", flush=True)


def heading(what):
    print(f"| {what} | kept | right | " + " | ".join(f"{name} P | R" for name in NAMES.values()) + " |")
    print("|---" * 9 + "|")


def given_parts(apps, folder):
    heading("given part")
    of_all = []
    for sampling, title in SAMPLINGS.items():
        for path in sorted(folder.glob(f"*_{sampling}.pcd")):
            of_all.append(labeled(apps, path))
            row(f"{path.name[:-len(f'_{sampling}.pcd')]}, {title}", of_all[-1])
    row("all", numpy.concatenate(of_all, axis=1))
    print()


def generated_worlds(apps):
    heading("generated world")
    of_all = []
    with tempfile.TemporaryDirectory() as directory:
        cloud = pathlib.Path(directory) / "cloud.pcd"
        for title, options in WORLDS.items():
            of_kind = []
            for seed in SEEDS:
                generate(apps, cloud, seed, options)
                of_kind.append(labeled(apps, cloud))
            of_all += of_kind
            row(title, numpy.concatenate(of_kind, axis=1))
    row("all", numpy.concatenate(of_all, axis=1))


def given_scenes(apps, folder):
    print()
    heading("given scene")
    for scene in (4, 20, 22, 27, 30, 33, 44):
        row(f"learn{scene}", labeled(apps, folder / f"learn{scene}_gt.pcd"))


def generated_scenes(apps):
    print()
    heading("generated scene")
    with tempfile.TemporaryDirectory() as directory:
        cloud = pathlib.Path(directory) / "cloud.pcd"
        for title, (seed, options) in SCENES.items():
            generate(apps, cloud, seed, options)
            row(title, labeled(apps, cloud))


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: scripts/evaluate/evaluate_labels.py BUILD_DIR [DATA_DIR]")
    apps = pathlib.Path(sys.argv[1]) / "apps"
    if len(sys.argv) == 3:
        given_parts(apps, pathlib.Path(sys.argv[2]) / "parts")
    generated_worlds(apps)
    if len(sys.argv) == 3:
        given_scenes(apps, pathlib.Path(sys.argv[2]) / "osd")
    generated_scenes(apps)


if __name__ == "__main__":
    main()
