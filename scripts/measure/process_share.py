#!/usr/bin/env python3
"""What a whole process of pcl_shape_edge_detection spends its time on.

Usage: scripts/measure/process_share.py BUILD_DIR CLOUD.pcd [-threads N] [-repeat N]
One line of JSON goes to standard output: medians in milliseconds. `start` is the process
that only prints its version, `other` what no stage of the application's report covers.
`share` is the part of the wall time that is not reading, writing or process start.
"""
import argparse
import json
import pathlib
import statistics
import subprocess
import tempfile
import time


def wall_ms(command):
    start = time.perf_counter()
    subprocess.run(command, check=True, capture_output=True)
    return 1e3 * (time.perf_counter() - start)


def run_once(app, arguments, directory):
    """Wall time, stages, and process start of one run."""
    report = pathlib.Path(directory) / "report.json"
    start = wall_ms([app, "--version"])
    wall = wall_ms([app, arguments.cloud, f"{directory}/out.pcd",
                    "-threads", str(arguments.threads), "-json", report])
    stages = json.loads(report.read_text())["times_ms"]
    return {"wall": wall, "start": start, **stages,
            "other": wall - start - sum(stages.values())}


def main():
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("build")
    parser.add_argument("cloud")
    parser.add_argument("-threads", type=int, default=2)
    parser.add_argument("-repeat", type=int, default=11)
    arguments = parser.parse_args()
    app = f"{arguments.build}/apps/pcl_shape_edge_detection"
    with tempfile.TemporaryDirectory() as directory:
        runs = [run_once(app, arguments, directory) for _ in range(arguments.repeat)]
    shares = [1 - (r["start"] + r["read"] + r["write"]) / r["wall"] for r in runs]
    medians = {name: statistics.median(r[name] for r in runs) for name in runs[0]}
    print(json.dumps({"threads": arguments.threads, "ms": medians,
                      "share": statistics.median(shares)}))


if __name__ == "__main__":
    main()
