#!/usr/bin/env python3
"""Rewrite the table of doc/evaluation.md about instances.

Usage: scripts/instance_tables.py RESULTS [ROOT]
RESULTS is the output of compare_instances. ROOT is the repository by default. The table stands
between <!-- begin instances --> and <!-- end instances -->.
"""
import json
import pathlib
import sys

from benchmark_tables import rewrite, table

GROUPS = {"cylinders": "cylinders", "boxes": "boxes, whole", "faces": "boxes, their faces",
          "mixed": "all kinds, whole", "mixed_curved": "all kinds, curved parts"}
HEAD = ["scenes", "method", "point F1", "instances", "found", "merged", "split", "missed", "extra",
        "time (s)"]


def rows(group):
    for index, row in enumerate(group["rows"]):
        title = f"{GROUPS.get(group['name'], group['name'])} ({group['clouds']})" if index == 0 else ""
        setting = f", {row['setting']}" if row["setting"] else ""
        share = row["found"] / max(1, row["instances"])
        yield [title, row["method"] + setting, f"{row['point_f1']:.3f}".removeprefix("0"),
               row["instances"], f"{row['found']} ({100 * share:.1f} %)",
               *(row[key] for key in ("merged", "split", "missed", "extra")),
               f"{row['milliseconds'] / 1000:.1f}"]


def main():
    if len(sys.argv) not in (2, 3):
        sys.exit("usage: scripts/instance_tables.py RESULTS [ROOT]")
    root = pathlib.Path(sys.argv[2]) if len(sys.argv) == 3 else \
        pathlib.Path(__file__).resolve().parent.parent
    results = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()[-1])
    lines = [row for group in results["groups"] for row in rows(group)]
    rewrite(root / "doc/evaluation.md", {"instances": table(HEAD, lines)})


if __name__ == "__main__":
    main()
