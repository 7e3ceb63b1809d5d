#!/usr/bin/env python3
"""Compare with other methods on generated scenes, and write the tables of doc/.

Usage: scripts/evaluate/compare.py grasps|ground|instances|keypoints BUILD_DIR [CLOUD.pcd ...] [OPTION ...]
Clouds and options are those of BUILD_DIR/benchmarks/compare_grasps and so on; an option replaces the usual one only as
words of its own (-threads N, not -threads=N). RESULTS: keep the results in this file, or
make the tables of them if it is there. ROOT: of the pages to write (the repository). A table stands between
<!-- begin NAME --> and <!-- end NAME -->.
"""
import json
import os
import pathlib
import subprocess
import sys

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from benchmark_tables import number, rewrite, table, wrapped  # noqa: E402


def share(value):
    return f"{value:.4f}".removeprefix("0")


def part(count, whole):
    return f"{count} of {whole} ({100.0 * count / whole:.1f} %)" if whole else "–"


def grasp_tables(runs):
    noises = {"kinect": "a Kinect's", "none": "none"}
    rows = [[noises[run["noise"]], f"{1000 * run['cup_radius']:.0f} mm", kind,
             *(part(counts[key], counts["targets"])
               for key in ("with_a_sealing_grasp", "first_ranked_on_one_face", "centroid_on_one_face"))]
            for run in runs for kind, counts in run["with_a_face_of_twice_the_cup"].items()]
    text = table(["noise", "cup", "target", "has a grasp that seals", "first-ranked on one face", "centroid on one face"], rows)
    seeds = runs[0]["first_seed"], runs[0]["first_seed"] + runs[0]["scenes"] - 1
    sealing, good = (sum(run[key] for run in runs) for key in ("first_ranked_that_seal", "of_these_on_one_face"))
    note = (f"Seeds {seeds[0]} to {seeds[1]}. Of all targets, with or without such a face, {sealing} "
            f"first-ranked grasps are said to seal; {part(good, sealing)} are on one face.")
    return {"grasps": f"{text}\n\n{wrapped(note)}"}


def ground_tables(runs):
    accuracy = [[sensor["beams"], row["method"], row["setting"], row["streets"],
                 *(share(row[key]) for key in ("f1", "worst_f1", "precision", "recall"))]
                for sensor in runs[0]["sensors"] for row in sensor["methods"]]
    times = []
    for run in runs:
        for sensor in run["sensors"]:
            clouds = sensor["methods"][0]["clouds"]
            points = sorted(cloud["points"] for cloud in clouds)[len(clouds) // 2]
            times += [[sensor["beams"], run["threads"], number(points), row["method"], number(row["ms"])]
                      for row in sensor["methods"]]
    return {"accuracy": table(["beams", "method", "its best setting", "streets", "F1", "worst F1", "P", "R"], accuracy),
            "times": table(["beams", "threads", "points", "method", "time (ms)"], times)}


def instance_rows(group):
    names = {"boxes": "boxes, whole", "faces": "boxes, their faces", "mixed": "all kinds, whole",
             "mixed_curved": "all kinds, curved parts"}
    for index, row in enumerate(group["rows"]):
        title = f"{names.get(group['name'], group['name'])} ({group['clouds']})" if index == 0 else ""
        setting = f", {row['setting']}" if row["setting"] else ""
        found = row["found"] / max(1, row["instances"])
        yield [title, row["method"] + setting, f"{row['point_f1']:.3f}".removeprefix("0"),
               row["instances"], f"{row['found']} ({100 * found:.1f} %)",
               *(row[key] for key in ("merged", "split", "missed", "extra")), f"{row['milliseconds'] / 1000:.1f}"]


def instance_tables(runs):
    head = ["scenes", "method", "point F1", "instances", "found", "merged", "split", "missed", "extra", "time (s)"]
    return {"instances": table(head, [row for group in runs[0]["groups"] for row in instance_rows(group)])}


def keypoint_tables(runs):
    names = {"creases": "points of creases (`ShapeEdgeDetection`)",
             "uniform": "`pcl::UniformSampling`, as many",
             "uniform, ten times as many": "`pcl::UniformSampling`, ten times as many",
             "ISS": "`pcl::ISSKeypoint3D`"}
    result = runs[0]
    results = sorted(result["rows"], key=lambda r: (r["turn"], list(names).index(r["keypoints"])))
    rows = [[f"{r['turn']:.0f}°", names[r["keypoints"]], f"{r['count']:.0f}", f"{100 * r['aligned']:.0f} %",
             f"{r['degrees']:.2f}", f"{r['millimeters']:.1f}", f"{r['keypoints_ms'] / 1e3:.2f}", f"{r['align_ms'] / 1e3:.2f}"]
            for r in results]
    head = ["turned by", "keypoints", "number", "aligned", "error (degrees)", "error (mm)", "keypoints (s)", "the rest (s)"]
    note = (f"Seeds {result['seed']} to {result['seed'] + results[0]['pairs'] - 1}, {result['threads']} threads; medians over "
            "the pairs.")
    return {"keypoints": f"{table(head, rows)}\n\n{wrapped(note)}"}


# The page, its tables, and the options of each run; those that are given take their place.
COMPARISONS = {
    "grasps": ("grasps.md", grasp_tables,
               [{"-first_seed": "7001", "-scenes": "30", "-noise": noise, "-cup_radius": radius}
                for noise in ("kinect", "none") for radius in ("0.01", "0.015")]),
    # The morphological filter has no threads.
    "ground": ("ground.md", ground_tables, [{"-threads": "1"}, {"-threads": "2", "-slow_streets": "0"}]),
    "instances": ("evaluation.md", instance_tables, [{"-seeds": "301 302"}]),
    "keypoints": ("keypoints.md", keypoint_tables, [{"-threads": "2"}]),
}


def run(program, usual, given):
    """What it says last: a line of JSON."""
    options = [word for name, values in usual.items() if name not in given for word in (name, *values.split())]
    print(program, *given, *options, file=sys.stderr, flush=True)
    return subprocess.run([program, *given, *options], check=True, stdout=subprocess.PIPE, text=True).stdout.splitlines()[-1]


def main():
    if len(sys.argv) < 3 or sys.argv[1] not in COMPARISONS:
        sys.exit(__doc__)
    what, build, *given = sys.argv[1:]
    page, tables, runs = COMPARISONS[what]
    kept = pathlib.Path(os.environ.get("RESULTS", os.devnull))
    if kept.is_file():
        lines = kept.read_text(encoding="utf-8").splitlines()
    else:
        lines = [run(f"{build}/benchmarks/compare_{what}", usual, given) for usual in runs]
        kept.write_text("\n".join(lines) + "\n", encoding="utf-8")
    root = pathlib.Path(os.environ.get("ROOT", pathlib.Path(__file__).resolve().parent.parent.parent))
    rewrite(root / "doc" / page, tables([json.loads(line) for line in lines]))


if __name__ == "__main__":
    main()
