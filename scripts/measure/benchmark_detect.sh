#!/usr/bin/env bash
# Time edges and surfaces of one cloud: pcl_shape_detect against the two applications for one of them
# each, whole processes in turns.
# Usage: scripts/measure/benchmark_detect.sh SCENE.pcd BUILD_DIR [OPTION ...]
# RUNS: of each (9). More options are given to all three.
set -euo pipefail
usage="usage: scripts/measure/benchmark_detect.sh SCENE.pcd BUILD_DIR [OPTION ...]"
scene=${1:?$usage}
apps=${2:?$usage}/apps
shift 2
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

python3 - "${RUNS:-9}" "$apps" "$scene" "$work/out.pcd" "$@" <<'PYTHON'
import statistics
import subprocess
import sys
import time

runs, apps, *arguments = sys.argv[1:]
names = ("detect", "edge_detection", "back_projection")
seconds = {name: [] for name in names}
for _ in range(int(runs)):
    for name in names:
        begin = time.perf_counter()
        subprocess.run([f"{apps}/pcl_shape_{name}", *arguments], check=True, stdout=subprocess.DEVNULL)
        seconds[name].append(time.perf_counter() - begin)
median = {name: statistics.median(times) for name, times in seconds.items()}
for name in names:
    print(f"{name:16} {1e3 * median[name]:7.0f} ms, the fastest {1e3 * min(seconds[name]):.0f} ms")
print(f"detect / (edge_detection + back_projection) = {median['detect'] / (median[names[1]] + median[names[2]]):.3f}")
PYTHON
