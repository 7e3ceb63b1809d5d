#!/usr/bin/env python3
"""Print tables of what the paper prints beside what benchmarks measured, as Markdown.

Usage: scripts/evaluate/paper_rows.py edges|cylinders|times RESULTS
RESULTS is the output of compare_peers (edges: of the four scenes; cylinders: of scene 33) or of
k_sweep (times).
"""
import json
import pathlib
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from benchmark_tables import number, table  # noqa: E402
from peer_tables import share  # noqa: E402

# P, R, F1
PAPER_EDGES = {"4": (.05, 1.00, .09), "20": (.05, 1.00, .11), "33": (.05, 1.00, .09),
               "44": (.04, 1.00, .08)}
PAPER_CYLINDERS = {"paper mode, 20×20": (.66, .97, .79),
                   "RANSAC cylinders, true count": (.16, .92, .27)}


def beside(ours, printed):
    """Precision, recall and F1, with the paper's in brackets where it prints them."""
    theirs = [f" ({value:.2f})".replace("(0.", "(.") for value in printed] if printed else [""] * 3
    return [share(value) + text for value, text in zip(ours, theirs)]


def edges(results):
    rows = []
    for peer in results["edges"]:
        for cloud in peer["clouds"]:
            scene = cloud["cloud"].removeprefix("learn").removesuffix("_gt")
            has_defaults = "defaults" in peer["peer"]
            rows.append([scene, peer["peer"], peer["setting"],
                         *beside([cloud[f"edge_{key}"] for key in ("precision", "recall", "f1")],
                                 PAPER_EDGES.get(scene) if has_defaults else None)])
    return table(["scene", "method", "setting", "P", "R", "F1"], rows)


def cylinders(results):
    rows = [[peer["peer"], peer["setting"],
             *beside([peer["mean"][f"curved_{key}"] for key in ("precision", "recall", "f1")],
                     PAPER_CYLINDERS.get(peer["peer"]))]
            for peer in results["surfaces"]]
    return table(["method", "setting", "P", "R", "F1"], rows)


def times(results):
    rows = [[row["k"], number(row["paper_us"]), number(row["pcl_us"]),
             number(row["pcl_shape_us"])] for row in results["k_sweep"]]
    return table(["k", "the paper (µs)", "PCL (µs)", "pcl_shape (µs)"], rows)


def main():
    tables = {"edges": edges, "cylinders": cylinders, "times": times}
    if len(sys.argv) != 3 or sys.argv[1] not in tables:
        sys.exit("usage: scripts/evaluate/paper_rows.py edges|cylinders|times RESULTS")
    results = pathlib.Path(sys.argv[2]).read_text(encoding="utf-8").splitlines()[-1]
    print(tables[sys.argv[1]](json.loads(results)))


if __name__ == "__main__":
    main()
