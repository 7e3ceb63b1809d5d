#!/usr/bin/env python3
"""Rewrite the table of doc/grasps.md.

Usage: scripts/grasp_tables.py RESULTS [ROOT]
RESULTS is what scripts/compare_grasps.sh kept: a line of JSON for each run. ROOT is the repository
by default. The table stands between <!-- begin grasps --> and <!-- end grasps -->.
"""
import json
import pathlib
import sys

from benchmark_tables import rewrite, table, wrapped

NOISE = {"kinect": "a Kinect's", "none": "none"}


def part(count, whole):
    return f"{count} of {whole} ({100.0 * count / whole:.1f} %)" if whole else "–"


def rows(run):
    for kind, counts in run["with_a_face_of_twice_the_cup"].items():
        targets = counts["targets"]
        yield [NOISE[run["noise"]], f"{1000 * run['cup_radius']:.0f} mm", kind,
               part(counts["with_a_sealing_grasp"], targets),
               part(counts["first_ranked_on_one_face"], targets),
               part(counts["centroid_on_one_face"], targets)]


def main():
    root = pathlib.Path(sys.argv[2]) if len(sys.argv) > 2 else pathlib.Path(__file__).parents[1]
    lines = pathlib.Path(sys.argv[1]).read_text(encoding="utf-8").splitlines()
    runs = [json.loads(line) for line in lines]
    head = ["noise", "cup", "target", "has a grasp that seals", "first-ranked on one face",
            "centroid on one face"]
    text = table(head, [row for run in runs for row in rows(run)])
    seeds = runs[0]["first_seed"], runs[0]["first_seed"] + runs[0]["scenes"] - 1
    sealing = sum(run["first_ranked_that_seal"] for run in runs)
    good = sum(run["of_these_on_one_face"] for run in runs)
    note = (f"Seeds {seeds[0]} to {seeds[1]}. Of all targets, with or without such a face, {sealing} "
            f"first-ranked grasps are said to seal; {part(good, sealing)} are on one face.")
    rewrite(root / "doc" / "grasps.md", {"grasps": f"{text}\n\n{wrapped(note)}"})


if __name__ == "__main__":
    main()
