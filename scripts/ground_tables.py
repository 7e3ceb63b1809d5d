#!/usr/bin/env python3
"""Rewrite the tables of doc/ground.md.

Usage: scripts/ground_tables.py RESULTS [ROOT]
RESULTS is what scripts/compare_ground.sh kept: a line of JSON for each run. ROOT is the repository
by default.
"""
import json
import pathlib
import sys

from benchmark_tables import number, rewrite, table


def share(value):
    return f"{value:.4f}".removeprefix("0")


def accuracy(run):
    head = ["beams", "method", "its best setting", "streets", "F1", "worst F1", "P", "R"]
    return table(head, [
        [sensor["beams"], row["method"], row["setting"], row["streets"],
         *(share(row[key]) for key in ("f1", "worst_f1", "precision", "recall"))]
        for sensor in run["sensors"] for row in sensor["methods"]])


def times(runs):
    head = ["beams", "threads", "points", "method", "time (ms)"]
    rows = []
    for run in runs:
        for sensor in run["sensors"]:
            clouds = sensor["methods"][0]["clouds"]
            points = sorted(cloud["points"] for cloud in clouds)[len(clouds) // 2]
            rows += [[sensor["beams"], run["threads"], number(points), row["method"],
                      number(row["ms"])] for row in sensor["methods"]]
    return table(head, rows)


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit(__doc__)
    root = pathlib.Path(sys.argv[2] if len(sys.argv) == 3 else pathlib.Path(__file__).parent.parent)
    lines = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    runs = [json.loads(line) for line in lines]
    rewrite(root / "doc" / "ground.md", {"accuracy": accuracy(runs[0]), "times": times(runs)})


if __name__ == "__main__":
    main()
