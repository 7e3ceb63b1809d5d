#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the table of streets of all kinds in doc/ground.md: F1 of the ground, no options, for each place and sensor, the mean of
two scans. Markdown goes to standard output, a line for each scan to standard error.
Usage: scripts/evaluate/evaluate_ground.py BUILD_DIR [FIRST_SEED [PEER]]
Seeds are 501 and 502 unless others are given. PEER is a program of another method, whose F1 then stands in brackets:
  PEER scan.bin ground.bin
reads a scan of four floats a point (KITTI's) and writes one byte a point, 1 for ground. Needs python3-numpy and
python3-scipy.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy

from evaluate_sensors import f1, fields_of, generate

PLACES = ("garage", "tunnel", "corridor", "hall", "bridge", "canopy", "bumps", "deck", "country", "town")
SENSORS = {
    **{f"{beams} beams": ("-beams", str(beams)) for beams in (16, 32, 64, 128)},
    "70° × 77°": ("-pattern", "rosette70"),
    "120° × 25°": ("-pattern", "rosette120"),
}
SCANS = 2


def score(truth, found):
    counts = truth <= 1  # the faces of curbs are left out
    return f1(found[counts] == 1, truth[counts] == 1)


def peer_score(peer, scan):
    points = numpy.stack([scan[axis] for axis in "xyz"] + [numpy.zeros_like(scan["x"])], axis=1)
    with tempfile.TemporaryDirectory() as directory:
        cloud, ground = (pathlib.Path(directory) / name for name in ("scan.bin", "ground.bin"))
        cloud.write_bytes(points.astype("<f4").tobytes())
        ran = subprocess.run([peer, cloud, ground], stdout=subprocess.DEVNULL, stderr=subprocess.PIPE)
        if ran.returncode:
            sys.exit(f"{peer}: exit status {ran.returncode}\n{ran.stderr.decode(errors='replace')}")
        found = numpy.frombuffer(ground.read_bytes(), numpy.uint8)
    if len(found) != len(points):
        sys.exit(f"{peer}: wrote {len(found)} bytes for {len(points)} points: expected one a point")
    return score(scan["ground"], found)


def scores(apps, options, seed, peer):
    """Ours, and that of the peer if there is one."""
    with tempfile.TemporaryDirectory() as directory:
        cloud, out = (pathlib.Path(directory) / name for name in ("scan.pcd", "out.pcd"))
        generate(apps, cloud, seed, ("-sensor", "lidar", *options))
        scan = fields_of(cloud)
        subprocess.run([apps / "pcl_shape_ground", cloud, out, "-format", "binary"], check=True, stdout=subprocess.DEVNULL)
        own = score(scan["ground"], fields_of(out)["ground"])
    return [own] + ([peer_score(peer, scan)] if peer else [])


def text(means):
    own, *others = (f"{mean:.4f}".removeprefix("0") for mean in means)
    return own + "".join(f" ({other})" for other in others)


def main():
    if len(sys.argv) not in (2, 3, 4):
        sys.exit("usage: scripts/evaluate/evaluate_ground.py BUILD_DIR [FIRST_SEED [PEER]]")
    apps = pathlib.Path(sys.argv[1]) / "apps"
    first = int(sys.argv[2]) if len(sys.argv) > 2 else 501
    peer = sys.argv[3] if len(sys.argv) > 3 else None
    print("| " + " | ".join(["place", *SENSORS]) + " |")
    print("|---" * (len(SENSORS) + 1) + "|")
    columns = {}
    for place in PLACES:
        row = []
        for sensor, options in SENSORS.items():
            of_scans = [scores(apps, ("-place", place, *options), seed, peer) for seed in range(first, first + SCANS)]
            print(f"{place}, {sensor}: {' '.join(map(text, of_scans))}", file=sys.stderr, flush=True)
            row.append(numpy.mean(of_scans, 0))
            columns.setdefault(sensor, []).append(row[-1])
        print("| " + " | ".join([f"`{place}`", *map(text, row)]) + " |", flush=True)
    print("| " + " | ".join(["mean", *(text(numpy.mean(of, 0)) for of in columns.values())]) + " |")


if __name__ == "__main__":
    main()
