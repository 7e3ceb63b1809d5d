#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The measured rows of doc/tiles.md: memory and cost, scaling, identity, faults.

Usage: scripts/measure/measure_tiles.py BUILD_DIR [-what memory,scaling,identity,faults]
           [-scene landscape|room|street|sheet] [-points N] [-files N] [-tile L]
           [-options="-edges -types"] [-memory M] [-mpi] [-runs N | -only K,...]
           [-kills N] [-whole N]
A scene of about N points (scripts/measure/tile_scenes.py, needs NumPy; a landscape unless -scene
names another) is written into strips in a temporary directory, where there must be room
for some 120 bytes a point. Tables in Markdown go to standard output. Times are of the
processor, so that other programs on the machine count little.

memory    runs one process, and the same options in memory: on one strip, or with
          -whole N on a landscape of about N points
scaling   runs one and two processes with the same tiles, by turns. What the first process does
          while there are two is serial; with this share, and the rest divided evenly, n
          processes are as much faster as the table says
identity  five sizes of tiles, three orders of the files and 1, 2 and 4 processes, with
          -mpi ranks of Open MPI: each output is compared with that of the whole
          cloud in memory, byte by byte. Some points are not finite, equal or far away.
          With -runs 15 only these: each pair of size, order and processes is among
          them, with -runs 5 each of the values; -only names some by their numbers, from 0
faults    runs two processes, or ranks, and kills one or all of them at a random time, -kills
          times (30); each is run again, and must give the bytes of a run that was
          not killed, without computing again what was complete
"""
import argparse
import collections
import json
import os
import pathlib
import random
import shutil
import signal
import statistics
import struct
import subprocess
import sys
import tempfile
import time

import tile_scenes

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


class Scene:
    """Files of a scene, and runs on them."""

    def __init__(self, arguments, directory):
        self.arguments, self.directory = arguments, pathlib.Path(directory)
        self.options = arguments.options.split()
        inputs = self.directory / "in"
        if arguments.scene == "landscape":
            self.edge = tile_scenes.write_landscape(inputs, arguments.points, arguments.files)
        else:
            self.edge = tile_scenes.write(arguments.scene, inputs, arguments.points,
                                          arguments.files)
        self.files = sorted(inputs.iterdir())
        self.points = sum(size_of(f) for f in self.files)

    def words(self, processes, tile, files=None):
        """The command line of pcl_shape_tiles, with as many processes or ranks."""
        words = [f"{self.arguments.build}/apps/pcl_shape_tiles", *(files or self.files),
                 "-output_dir", self.directory / "out", "-threads", 1,
                 "-memory", self.arguments.memory, *self.options,
                 "-json", self.directory / "report.json"]
        if tile:
            words += ["-tile", tile]
        if self.arguments.mpi:
            return ["mpirun", "--allow-run-as-root", "--oversubscribe", "-n", processes,
                    *words]
        return [*words, "-processes", processes]

    @property
    def workers(self):
        return "ranks" if self.arguments.mpi else "processes"

    def title(self, more):
        """What figures are of."""
        return (f"{self.arguments.scene}, {self.points:,} points{more}, "
                f"`{' '.join(self.options)}`")

    def remove_outputs(self):
        shutil.rmtree(self.directory / "out", ignore_errors=True)

    def tiles(self, processes, tile, files=None):
        """Run pcl_shape_tiles. Returns what it took, and its report."""
        self.remove_outputs()
        usage = run(*self.words(processes, tile, files))
        return usage, json.loads((self.directory / "report.json").read_text())

    def whole(self, cloud):
        """Run the same in memory, with pcl_shape_detect or pcl_inad_estimation."""
        common = [cloud, self.directory / "whole.pcd", "-threads", 1, "-format", "binary"]
        if self.options[0] == "-inad":
            return run(f"{self.arguments.build}/apps/pcl_inad_estimation", *common,
                       "-radius", *self.options[1:])
        return run(f"{self.arguments.build}/apps/pcl_shape_detect", *common,
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


def shares(report):
    """What each step took of the clock's time."""
    times = report["times_ms"]
    return ", ".join(f"{step} {times[step] / sum(times[s] for s in STEPS):.0%}"
                     for step in STEPS)


def print_memory(scene):
    cloud = scene.files[0]
    if scene.arguments.whole:
        tile_scenes.write_landscape(scene.directory / "whole", scene.arguments.whole, 1)
        cloud = next((scene.directory / "whole").iterdir())
    whole = scene.whole(cloud)
    strip = size_of(cloud)
    (scene.directory / "whole.pcd").unlink()
    usage, report = scene.tiles(1, scene.arguments.tile)
    print(f"{scene.title('')}, `-memory {scene.arguments.memory}`:\n")
    print("| | points | tiles | processor time | peak memory |\n|---|---|---|---|---|")
    print(f"| `pcl_shape_detect -threads 1`, in memory | {strip:,} | | "
          f"{micro(whole.cpu, strip)} | {whole.peak / 1e6:.0f} MB |")
    print(f"| `pcl_shape_tiles -threads 1` | {scene.points:,} | "
          f"{report['counts']['tiles']} | {micro(usage.cpu, scene.points)} | "
          f"{usage.peak / 1e6:.0f} MB |\n")
    ratio = whole.cpu / strip / (usage.cpu / scene.points)
    print(f"Throughput is {ratio:.2f} times that in memory ({shares(report)} of the "
          "clock's time).\n")


TURNS = 3  # of one and two processes: on a busy machine one may be off by a fifth


def print_scaling(scene):
    ones, twos = [], []
    for _ in range(TURNS):
        one, report = scene.tiles(1, scene.arguments.tile)
        ones.append(one)
        twos.append(scene.tiles(2, scene.arguments.tile)[0])
    alone = statistics.median(one.cpu for one in ones)
    first = statistics.median(two.first for two in twos)
    others = statistics.median(two.others for two in twos)
    title = scene.title(f", {report['counts']['tiles']} tiles")
    print(f"{title}: {alone:.1f} s with one process ({shares(report)} of the clock's "
          f"time),\n{others:.1f} s that two share, and {first:.2f} s of the first process "
          f"alone, the middle ones of {TURNS} turns:\n"
          f"{', '.join(f'{one.cpu:.1f}' for one in ones)} s, and "
          f"{', '.join(f'{two.others:.1f} + {two.first:.2f}' for two in twos)} s.\n")
    print("| processes | times as fast as one |\n|---|---|")
    for count in (2, 4, 8, 16):
        print(f"| {count} | {alone / (first + others / count):.2f} |")
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


SHARES = (1.1, 0.9, 0.6, 0.4, 0.25)  # of the scene: edges of tiles
PROCESSES = (1, 2, 4)


def combinations(files):
    """All of sizes of tiles, orders of files and numbers of processes: each value is
    among the first five, each pair of values among the first fifteen."""
    orders = (files, files[::-1], files[1::2] + files[::2])
    for i in range(len(SHARES) * len(orders) * len(PROCESSES)):
        share, order = i % len(SHARES), i % len(orders)
        count = (share + order + i // (len(SHARES) * len(orders))) % len(PROCESSES)
        yield SHARES[share], orders[order], PROCESSES[count]


def expected_points(scene):
    """Of each output, from the whole cloud."""
    join(scene.files, scene.directory / "all.pcd")
    scene.whole(scene.directory / "all.pcd")
    body = split(scene.directory / "whole.pcd")[1]
    step = len(body) // scene.points
    expected, at = {}, 0
    for file in scene.files:
        expected[file.name] = body[at:at + size_of(file) * step]
        at += size_of(file) * step
    return expected


def print_identity(scene):
    if scene.arguments.scene == "landscape":
        trouble(scene.files)
    expected = expected_points(scene)
    everything = list(combinations(scene.files))
    chosen = scene.arguments.only or range(scene.arguments.runs)
    print(f"{scene.title(' with NaN, equal and far ones')}:\n\n"
          f"| `-only` | tiles | order of files | {scene.workers} | bytes |\n"
          "|---|---|---|---|---|", flush=True)
    same = 0
    for number in chosen:
        share, order, count = everything[number]
        _, report = scene.tiles(count, f"{share * scene.edge:.2f}", order)
        found = all(split(scene.directory / "out" / name)[1] == points
                    for name, points in expected.items())
        same += found
        print(f"| {number} | {report['counts']['tiles']} of {share * scene.edge:.2f} m | "
              f"{' '.join(str(scene.files.index(f)) for f in order)} | {count} | "
              f"{'the same' if found else '**others**'} |", flush=True)
    print(f"\n{same} of {len(chosen)} runs have the bytes of the whole cloud.\n")
    return same == len(chosen)


def processes_below(pid):
    """The processes that one has started, and those that they have."""
    children = collections.defaultdict(list)
    for stat in pathlib.Path("/proc").glob("[0-9]*/stat"):
        try:
            name, _, rest = stat.read_text().rpartition(")")
        except OSError: # it has ended
            continue
        children[int(rest.split()[1])].append((int(stat.parent.name), name))
    found = []
    for child, name in children[pid]:
        found += [(child, name), *processes_below(child)]
    return found


def killed(words, seconds, kills_all, choice):
    """Run a command, and kill one of its processes, or all of them. Returns whether it
    was still running."""
    process = subprocess.Popen([str(w) for w in words], stdout=subprocess.DEVNULL,
                               stderr=subprocess.DEVNULL, start_new_session=True)
    time.sleep(seconds)
    was_running = process.poll() is None
    if was_running:
        workers = [child for child, name in [(process.pid, words[0]),
                                             *processes_below(process.pid)]
                   if "mpirun" not in str(name)]
        if not workers:  # no rank yet: with mpirun goes what it starts meanwhile
            os.killpg(process.pid, signal.SIGKILL)
        elif not kills_all:
            workers = [choice.choice(workers)]
        for worker in workers:
            try:
                os.kill(worker, signal.SIGKILL)
            except ProcessLookupError:
                pass  # it has ended meanwhile
    process.wait()
    return was_running


def complete_results(scene):
    """When the results of tiles and sections were written that are complete, by path."""
    tiles = scene.directory / "out" / "tiles"
    manifest = tiles / "manifest.jsonl"
    lines = manifest.read_text().split("\n")[:-1] if manifest.exists() else []
    records = [json.loads(line)["record"] for line in lines]
    paths = [tiles / r["name"] / f"{r['number']:06}.bin" for r in records
             if r["event"] == "result"]
    return {path: path.stat().st_mtime_ns for path in paths if path.exists()}


def print_faults(scene):
    words = [*scene.words(2, scene.arguments.tile), "-keep_tiles"]
    outputs = [scene.directory / "out" / f.name for f in scene.files]
    scene.remove_outputs()
    begin = time.monotonic()
    run(*words)
    seconds = time.monotonic() - begin
    expected = [output.read_bytes() for output in outputs]
    tiles = json.loads((scene.directory / "report.json").read_text())["counts"]["tiles"]
    choice = random.Random(1)
    same = ended = kills = 0
    results = set()
    while kills < scene.arguments.kills:
        scene.remove_outputs()
        if not killed(words, choice.uniform(0.0, seconds), kills % 2, choice):
            ended += 1
            continue
        kills += 1
        before = complete_results(scene)
        results.add(len(before))
        run(*words)
        after = complete_results(scene)
        again = [str(path) for path, written in before.items()
                 if after.get(path, written) != written]
        found = not again and [output.read_bytes() for output in outputs] == expected
        same += found
        if not found:
            print(f"after a kill at {len(before)} results: other bytes, or computed again: "
                  f"{again}", file=sys.stderr)
    print(f"{scene.title(f', {tiles} tiles')}: of {kills} runs of two {scene.workers},\n"
          f"of which one or all were killed when {min(results)} to {max(results)} results "
          f"were complete, {same} had the same bytes after\nthe same command, without "
          f"computing one of them again ({ended} more had ended before).\n")
    return same == kills


def main():
    parser = argparse.ArgumentParser(description=__doc__, prefix_chars="-",
                                     formatter_class=argparse.RawTextHelpFormatter)
    parser.add_argument("build")
    parser.add_argument("-scene", default="landscape",
                        choices=("landscape", "room", "street", "sheet"))
    parser.add_argument("-points", type=int, default=3000000)
    parser.add_argument("-files", type=int, default=4)
    parser.add_argument("-tile")
    parser.add_argument("-options", default="-edges -types")
    parser.add_argument("-memory", default="2G")
    parser.add_argument("-what", default="memory,scaling,identity")
    parser.add_argument("-mpi", action="store_true")
    parser.add_argument("-runs", type=int, default=45)
    parser.add_argument("-only", type=lambda text: [int(i) for i in text.split(",")])
    parser.add_argument("-kills", type=int, default=30)
    parser.add_argument("-whole", type=int)
    arguments = parser.parse_args()
    what = arguments.what.split(",")
    if unknown := set(what) - {"memory", "scaling", "identity", "faults"}:
        parser.error(f"-what is {','.join(sorted(unknown))}; expected memory, scaling, "
                     "identity or faults")
    combinations_of_all = len(list(combinations([])))
    if any(not 0 <= i < combinations_of_all for i in arguments.only or []):
        parser.error(f"-only is {arguments.only}; expected numbers from 0 to "
                     f"{combinations_of_all - 1}")
    if arguments.mpi and not shutil.which("mpirun"):
        parser.error("-mpi: there is no mpirun; expected Open MPI")
    with tempfile.TemporaryDirectory(prefix="pcl_shape_tiles_") as directory:
        scene = Scene(arguments, directory)
        if "memory" in what:
            print_memory(scene)
        if "scaling" in what:
            print_scaling(scene)
        if "faults" in what and not print_faults(scene):
            sys.exit("some runs that were killed gave other bytes")
        if "identity" in what and not print_identity(scene):
            sys.exit("some runs have other bytes")


if __name__ == "__main__":
    main()
