#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""How much longer pcl_shape_edge_detection takes on a cloud with repeated points, in CPU time.

Usage: scripts/measure/measure_repeats.py BUILD_DIR CLOUD.pcd [-threads N] [-repeat N]
CLOUD.pcd has x y z of float. Clouds take turns. One line of JSON goes to standard output: the
least seconds for its finite points, and for each kind of repeats the ratio to these.
Needs python3-numpy.
"""
import argparse
import json
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from pcd_fields import read_pcd  # noqa: E402

HEADER = ("VERSION 0.7\nFIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\nWIDTH {0}\nHEIGHT 1\n"
          "VIEWPOINT 0 0 0 1 0 0 0\nPOINTS {0}\nDATA binary\n")


def with_fillers(points):
    """Six of 16 points at 0, 0, 0, as where a lidar had no return."""
    rows = numpy.arange(len(points) * 16 // 10)
    mixed = numpy.zeros((len(rows), 3), points.dtype)
    places = numpy.flatnonzero(rows * 10 % 16 < 10)[:len(points)]
    mixed[places] = points[:len(places)]
    return mixed


KINDS = {"once": lambda points: points,
         "each 13 times": lambda points: numpy.repeat(points, 13, axis=0),
         "8 frames": lambda points: numpy.tile(points, (8, 1)),
         "fillers": with_fillers}


def cpu_seconds(command):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    try:
        run = subprocess.run(command, capture_output=True, text=True)
    except OSError as error:
        sys.exit(f"{command[0]}: {error.strerror}")
    if run.returncode != 0:
        sys.exit(run.stderr.strip())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def main():
    parser = argparse.ArgumentParser(allow_abbrev=False, description=__doc__.partition("\n")[0])
    parser.add_argument("build")
    parser.add_argument("cloud", type=pathlib.Path)
    parser.add_argument("-threads", default="1")
    parser.add_argument("-repeat", type=int, default=5)
    arguments = parser.parse_args()
    if arguments.repeat < 1:
        parser.error(f"-repeat {arguments.repeat}: it must be at least 1")
    try:
        lines, columns = read_pcd(arguments.cloud)
    except OSError as error:
        sys.exit(f"{arguments.cloud}: {error.strerror}")
    kinds = dict(zip(lines["FIELDS"].split(), zip(lines["TYPE"].split(), lines["SIZE"].split())))
    if any(kinds.get(axis) != ("F", "4") for axis in "xyz"):
        sys.exit(f"{arguments.cloud}: it must have x y z of TYPE F and SIZE 4")
    points = numpy.stack([numpy.frombuffer(columns[axis], "<f4") for axis in "xyz"], axis=1)
    points = points[numpy.isfinite(points).all(axis=1)]
    if not len(points):
        sys.exit(f"{arguments.cloud}: it has no finite points")
    seconds = {kind: [] for kind in KINDS}
    with tempfile.TemporaryDirectory() as directory:
        for kind, repeated in KINDS.items():
            cloud = repeated(points)
            pathlib.Path(directory, f"{kind}.pcd").write_bytes(HEADER.format(len(cloud)).encode() + cloud.tobytes())
        for _ in range(arguments.repeat):
            for kind in KINDS:
                seconds[kind].append(cpu_seconds(
                    [f"{arguments.build}/apps/pcl_shape_edge_detection", f"{directory}/{kind}.pcd",
                     f"{directory}/out.pcd", "-threads", arguments.threads]))
    least = {kind: min(of_kind) for kind, of_kind in seconds.items()}
    once = least.pop("once")
    print(json.dumps({"points": len(points), "seconds": round(once, 3),
                      "ratios": {kind: round(value / once, 2) for kind, value in least.items()}}))


if __name__ == "__main__":
    main()
