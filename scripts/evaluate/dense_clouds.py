#!/usr/bin/env python3
"""Clouds of many points in default mode, with and without -resolution.

Usage: scripts/evaluate/dense_clouds.py BUILD_DIR [-seeds N] [-resolution L]
Depth images of several widths are generated (seeds 1 to N) for each kind of noise; the
means over the seeds go to standard output as a table in Markdown. Needs python3-numpy and python3-scipy.
"""
import argparse
import pathlib
import statistics
import tempfile

from evaluate_sensors import report

WIDTHS = (640, 1280, 1920)
NOISES = {"kinect": "a Kinect's", "none": "none", "0.002": "white, 2 mm"}
TASKS = (("pcl_shape_back_projection", "curved", "back_projection"),
         ("pcl_shape_edge_detection", "edge", "edge_detection"))


def measure(apps, scene, options):
    """F1 and seconds of each task, and the largest curved radius."""
    out = scene.with_name("out.pcd")
    result = {}
    for app, task, stage in TASKS:
        run = report(apps, app, scene, out, *options)
        score = report(apps, "pcl_shape_evaluate", out, scene, "-task", task)
        result[task] = score["classes"][task]["f1"]
        result[stage] = run["times_ms"][stage] / 1e3
        result.setdefault("radius", run.get("largest_curved_radius"))
    return result


def row(arguments, width, noise, directory):
    """Means over the seeds: the scene's own resolution, then the given one."""
    apps, scene = pathlib.Path(arguments.build) / "apps", pathlib.Path(directory) / "scene.pcd"
    points, own, given = [], [], []
    for seed in range(1, arguments.seeds + 1):
        points.append(report(apps, "pcl_shape_scene", scene, "-seed", str(seed), "-width", str(width), "-height",
                             str(width * 3 // 4), "-noise", noise)["points"])
        own.append(measure(apps, scene, []))
        given.append(measure(apps, scene, ["-resolution", arguments.resolution]))
    cells = [str(width), NOISES[noise], f"{statistics.mean(points):,.0f}"]
    for name, form in (("radius", "{:.0f}"), ("curved", "{:.3f}"),
                       ("back_projection", "{:.1f}"), ("edge", "{:.3f}"),
                       ("edge_detection", "{:.1f}")):
        factor = 1e3 if name == "radius" else 1.0
        cells += [form.format(factor * statistics.mean(r[name] for r in results))
                  for results in (own, given)]
    return "| " + " | ".join(cells) + " |"


def main():
    parser = argparse.ArgumentParser(allow_abbrev=False)
    parser.add_argument("build")
    parser.add_argument("-seeds", type=int, default=3)
    parser.add_argument("-resolution", default="0.002")
    arguments = parser.parse_args()
    names = ("curved up to (mm)", "curved F1", "(s)", "edge F1", "(s)")
    print("| pixels | noise | points | " + " | ".join(f"{n} | with" for n in names) + " |")
    print("|---" * (3 + 2 * len(names)) + "|")
    with tempfile.TemporaryDirectory() as directory:
        for noise in NOISES:
            for width in WIDTHS:
                print(row(arguments, width, noise, directory), flush=True)


if __name__ == "__main__":
    main()
