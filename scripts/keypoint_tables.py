#!/usr/bin/env python3
"""Rewrite the table of doc/keypoints.md.

Usage: scripts/keypoint_tables.py RESULTS [ROOT]
RESULTS is what scripts/compare_keypoints.sh kept. ROOT is the repository by default. The table
stands between <!-- begin keypoints --> and <!-- end keypoints -->.
"""
import json
import pathlib
import sys

from benchmark_tables import rewrite, table, wrapped

NAMES = {"creases": "points of creases (`ShapeEdgeDetection`)",
         "uniform": "`pcl::UniformSampling`, as many",
         "uniform, ten times as many": "`pcl::UniformSampling`, ten times as many",
         "ISS": "`pcl::ISSKeypoint3D`"}


def row(result):
    return [f"{result['turn']:.0f}°", NAMES[result["keypoints"]], f"{result['count']:.0f}",
            f"{100 * result['aligned']:.0f} %", f"{result['degrees']:.2f}",
            f"{result['millimeters']:.1f}", f"{result['keypoints_ms'] / 1e3:.2f}",
            f"{result['align_ms'] / 1e3:.2f}"]


def main():
    root = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parents[1]
    result = json.loads(pathlib.Path(sys.argv[1]).read_text(encoding="utf-8"))
    order = list(NAMES)
    results = sorted(result["rows"], key=lambda r: (r["turn"], order.index(r["keypoints"])))
    head = ["turned by", "keypoints", "number", "aligned", "error (degrees)", "error (mm)",
            "keypoints (s)", "the rest (s)"]
    last = result["seed"] + results[0]["pairs"] - 1
    note = f"Seeds {result['seed']} to {last}, {result['threads']} threads; medians over the pairs."
    rewrite(root / "doc" / "keypoints.md",
            {"keypoints": f"{table(head, [row(r) for r in results])}\n\n{wrapped(note)}"})


if __name__ == "__main__":
    main()
