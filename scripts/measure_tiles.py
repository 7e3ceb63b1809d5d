#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The measured rows of doc/tiles.md: memory and cost, scaling, identity.

Usage: scripts/measure_tiles.py BUILD_DIR [-points N] [-files N] [-tile L]
           [-options="-edges -types"] [-memory M] [-what memory,scaling,identity] [-mpi]
A generated landscape (benchmarks/landscape) of about N points is written into strips in a
temporary directory, where there must be room for some 120 bytes a point. Tables in
Markdown go to standard output. Times are of the processor, so that other programs on the
machine count little.

memory    runs one process, and the same options on one strip in memory
scaling   runs one and two processes with the same tiles. What the first process does
          while there are two is serial; with this share, and the rest divided evenly, n
          processes are as much faster as the table says
identity  five sizes of tiles, three orders of the files and 1, 2 and 4 processes, with
          -mpi ranks of Open MPI: each output is compared with that of the whole
          cloud in memory, byte by byte. Some points are not finite, equal or far away
"""
import argparse
import json
import os
import pathlib
import shutil
import struct
import subprocess
import sys
import tempfile

STEPS = ("partition", "numbers", "fields", "join")
CLOCK = os.sysconf("SC_CLK_TCK")


class Usage:
    """What a process took, without and with the processes that it started."""

    def __init__(self, pid):
        os.waitid(os.P_PID, pid, os.WEXITED | os.WNOWAIT)
        stat = pathlib.Path(f"/proc/{pid}/stat").read_text().rpartition(")")[2].split()
        own, children = (sum(map(int, stat[i:i + 2])) / CLOCK for i in (11, 13))
        _, status, usage = os.wait4(pid, 0)
        self.exit = os.waitstatus_to_exitcode(status)
        self.first, self.others = own, children
        self.peak = usage.ru_maxrss * 1024

    @property
    def cpu(self):
        """Seconds of all processes."""
        return self.first + self.others


def run(*words):
    """Run a command, which must succeed."""
    process = subprocess.Popen([str(w) for w in words], stdout=subprocess.DEVNULL,
                               stderr=subprocess.PIPE)
    errors = process.stderr.read().decode()
    usage = Usage(process.pid)
    process.returncode = usage.exit  # it was waited for
    if usage.exit != 0:
        sys.exit(f"{' '.join(map(str, words))}: {errors}")
    return usage


class Landscape:
    """Strips of a landscape, and runs on them."""

    def __init__(self, arguments, directory):
        self.arguments, self.directory = arguments, pathlib.Path(directory)
        self.options = arguments.options.split()
        run(f"{arguments.build}/benchmarks/landscape", self.directory / "in",
            arguments.points, arguments.files)
        self.files = sorted((self.directory / "in").iterdir())
        self.points = sum(size_of(f) for f in self.files)

    def tiles(self, processes, tile, files=None, launcher=()):
        """Run pcl_shape_tiles. Returns what it took, and its report."""
        out = self.directory / "out"
        shutil.rmtree(out, ignore_errors=True)
        words = [*launcher, f"{self.arguments.build}/apps/pcl_shape_tiles",
                 *(files or self.files), "-output_dir", out, "-threads", 1,
                 "-memory", self.arguments.memory, *self.options,
                 "-json", self.directory / "report.json"]
        if tile:
            words += ["-tile", tile]
        if not launcher:
            words += ["-processes", processes]
        usage = run(*words)
        return usage, json.loads((self.directory / "report.json").read_text())

    def whole(self, cloud):
        """Run pcl_shape_detect in memory."""
        return run(f"{self.arguments.build}/apps/pcl_shape_detect", cloud,
                   self.directory / "whole.pcd", "-threads", 1, "-format", "binary",
                   *self.options)


def split(path):
    """The header and the points of a binary PCD file."""
    data = path.read_bytes()
    end = data.index(b"DATA binary\n") + len(b"DATA binary\n")
    return data[:end], data[end:]


def size_of(path):
    """How many points a PCD file has, by its header."""
    with open(path, "rb") as file:
        for line in file:
            if line.startswith(b"POINTS "):
                return int(line.split()[1])
    sys.exit(f"{path}: has no POINTS; expected a PCD file")


def micro(seconds, points):
    return f"{seconds:.1f} s, {1e6 * seconds / points:.1f} µs a point"


def print_memory(scene):
    whole = scene.whole(scene.files[0])
    strip = size_of(scene.files[0])
    usage, report = scene.tiles(1, scene.arguments.tile)
    print(f"`{' '.join(scene.options)}`, `-memory {scene.arguments.memory}`:\n")
    print("| | points | tiles | processor time | peak memory |\n|---|---|---|---|---|")
    print(f"| `pcl_shape_detect -threads 1`, one strip in memory | {strip:,} | | "
          f"{micro(whole.cpu, strip)} | {whole.peak / 1e6:.0f} MB |")
    print(f"| `pcl_shape_tiles -threads 1` | {scene.points:,} | "
          f"{report['counts']['tiles']} | {micro(usage.cpu, scene.points)} | "
          f"{usage.peak / 1e6:.0f} MB |\n")
    ratio = whole.cpu / strip / (usage.cpu / scene.points)
    print(f"Throughput is {ratio:.2f} times that in memory.\n")


def print_scaling(scene):
    one, report = scene.tiles(1, scene.arguments.tile)
    two, _ = scene.tiles(2, scene.arguments.tile)
    times = report["times_ms"]
    shares = ", ".join(f"{step} {times[step] / sum(times[s] for s in STEPS):.0%}"
                       for step in STEPS)
    print(f"{scene.points:,} points, {report['counts']['tiles']} tiles, "
          f"`{' '.join(scene.options)}`: {one.cpu:.1f} s with one process ({shares} of "
          f"the clock's time),\n{two.cpu:.1f} s with two, of which the first process "
          f"alone takes {two.first:.2f} s.\n")
    print("| processes | times as fast as one |\n|---|---|")
    for count in (2, 4, 8, 16):
        print(f"| {count} | {one.cpu / (two.first + two.others / count):.2f} |")
    print()


def trouble(files):
    """Makes some points not finite, some equal, some far away."""
    for path in files:
        header, body = split(path)
        points = bytearray(body)
        step = struct.calcsize("<3f")
        for number, at in enumerate(range(0, len(points) - step, 997 * step)):
            if number % 3 == 0:
                points[at:at + 4] = struct.pack("<f", float("nan"))
            elif number % 3 == 1:
                points[at:at + step] = points[at + step:at + 2 * step]
            elif number % 30 == 2:
                points[at + 8:at + step] = struct.pack("<f", 60.0 + number)
        path.write_bytes(header + points)


def join(files, path):
    """One file of all points."""
    header = split(files[0])[0]
    for word in (b"WIDTH", b"POINTS"):
        header = header.replace(b"%s %d\n" % (word, size_of(files[0])),
                                b"%s %d\n" % (word, sum(size_of(f) for f in files)))
    path.write_bytes(header + b"".join(split(f)[1] for f in files))


def print_identity(scene):
    trouble(scene.files)
    join(scene.files, scene.directory / "all.pcd")
    scene.whole(scene.directory / "all.pcd")
    body = split(scene.directory / "whole.pcd")[1]
    step = len(body) // scene.points
    expected, at = {}, 0
    for file in scene.files:
        expected[file.name] = body[at:at + size_of(file) * step]
        at += size_of(file) * step
    edge = scene.points ** 0.5 / 4.0  # of the landscape, in meters
    mpirun = shutil.which("mpirun") if scene.arguments.mpi else None
    if scene.arguments.mpi and not mpirun:
        sys.exit("-mpi: there is no mpirun; expected Open MPI")
    orders = (scene.files, scene.files[::-1], scene.files[1::2] + scene.files[::2])
    same = compared = 0
    for share in (1.1, 0.9, 0.6, 0.4, 0.25):
        for order in orders:
            for count in (1, 2, 4):
                launcher = (mpirun, "--allow-run-as-root", "--oversubscribe", "-n",
                            count) if mpirun else ()
                scene.tiles(count, f"{share * edge:.1f}", order, launcher)
                found = all(split(scene.directory / "out" / name)[1] == points
                            for name, points in expected.items())
                compared, same = compared + 1, same + found
                if not found:
                    print(f"other bytes: tiles of {share * edge:.1f} m, {count} of "
                          f"{[f.name for f in order]}", file=sys.stderr)
    print(f"{scene.points:,} points with NaN, equal and far ones, "
          f"`{' '.join(scene.options)}`: {same} of {compared} runs (5 sizes of tiles, "
          f"3 orders of {len(scene.files)} files,\n1, 2 and 4 "
          f"{'ranks' if mpirun else 'processes'}) have the bytes of the whole cloud.\n")
    return same == compared


def main():
    parser = argparse.ArgumentParser(description=__doc__, prefix_chars="-",
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("-points", type=int, default=3000000)
    parser.add_argument("-files", type=int, default=4)
    parser.add_argument("-tile")
    parser.add_argument("-options", default="-edges -types")
    parser.add_argument("-memory", default="2G")
    parser.add_argument("-what", default="memory,scaling,identity")
    parser.add_argument("-mpi", action="store_true")
    arguments = parser.parse_args()
    what = arguments.what.split(",")
    if unknown := set(what) - {"memory", "scaling", "identity"}:
        parser.error(f"-what is {','.join(sorted(unknown))}; expected memory, scaling or "
                     "identity")
    with tempfile.TemporaryDirectory(prefix="pcl_shape_tiles_") as directory:
        scene = Landscape(arguments, directory)
        if "memory" in what:
            print_memory(scene)
        if "scaling" in what:
            print_scaling(scene)
        if "identity" in what and not print_identity(scene):
            sys.exit("some runs have other bytes")


if __name__ == "__main__":
    main()
