#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Draw the pictures of doc/mistakes.md: hits, misses and false alarms of the default mode.

Usage: scripts/draw/draw_kinds.py BUILD_DIR FOLDER [DATA_DIR]
FOLDER gets mistakes_parts.png, mistakes_cameras.png and mistakes_dense.png. DATA_DIR/parts has the sampled parts of
doc/evaluation.md; without it generated parts are drawn. Needs python3-numpy, python3-scipy, python3-matplotlib and python3-pil.
"""
import pathlib
import subprocess
import sys
import tempfile

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "evaluate"))

from evaluate_sensors import edge_points, f1, fields_of, run, surface_points  # noqa: E402

LEFT_OUT, RIGHTLY_NOT, HIT, MISS, FALSE_ALARM = range(5)
COLORS = numpy.array([[120, 120, 120], [215, 215, 215], [0, 150, 60], [220, 0, 0], [160, 0, 220]]) / 255
# Alone, all around; seeds that nothing was chosen on.
GENERATED_PARTS = {f"part {seed}": ("-place", "part", "-sensor", "samples", "-sampling", "0.001", "-seed", str(seed))
                   for seed in (951, 952, 953, 954, 955)}
NOISES = {"15": "0.00015", "40": "0.0004"}
CAMERAS = {"stereo": ("-sensor", "stereo"), "time of flight": ("-sensor", "tof"),
           "structured light": ("-sensor", "structured"), "parts, stereo": ("-sensor", "stereo", "-place", "part")}
DENSE = {"Kinect": (), "no noise": ("-noise", "none"), "white, 2 mm": ("-noise", "0.002")}


def outcomes(found, truth, counts):
    """What became of each point."""
    outcome = numpy.where(found, numpy.where(truth, HIT, FALSE_ALARM), numpy.where(truth, MISS, RIGHTLY_NOT))
    return numpy.where(counts, outcome, LEFT_OUT)


def edges_of(apps, cloud, truth):
    counts = edge_points(truth) if "thin_s" in truth else truth["edge"] != 255
    found = run(apps, "pcl_shape_edge_detection", cloud)["edge"] == 1
    return found, truth["edge"] == 1, counts


def curved_of(apps, cloud, truth):
    counts = surface_points(truth) if "thin_s" in truth else (truth["surface"] == 1) | (truth["surface"] == 2)
    found = run(apps, "pcl_shape_back_projection", cloud)["surface"] == 2
    return found, truth["surface"] == 2, counts


TASKS = {"edges": edges_of, "curved": curved_of}


def score(found, truth, counts):
    if not truth[counts].any():
        return f"{numpy.count_nonzero(found[counts])} false"
    return f"F1 {f1(found[counts], truth[counts]):.3f}"


def oblique(points):
    """A view from above and aside: right, up, and towards the viewer."""
    axis = numpy.array([0.5, -0.75, 0.6]) / numpy.linalg.norm([0.5, -0.75, 0.6])
    right = numpy.cross([0.0, 0.0, 1.0], axis)
    right /= numpy.linalg.norm(right)
    return points @ numpy.stack([right, numpy.cross(axis, right), axis], axis=1)


def draw_part(axes, cloud, outcome):
    """What is nearer is drawn later and hides what is behind it."""
    seen = oblique(numpy.stack([cloud[axis] for axis in "xyz"], axis=1).astype(float))
    order = numpy.argsort(seen[:, 2])
    extent = numpy.ptp(seen[:, :2], axis=0).max()
    points_of_inch = 72 * axes.figure.get_size_inches()[0] * axes.get_position().width
    size = (2.2 * 0.001 / extent * points_of_inch) ** 2  # discs of twice the spacing leave no gaps
    axes.scatter(seen[order, 0], seen[order, 1], s=size, c=COLORS[outcome[order]], linewidths=0)
    axes.set_aspect("equal")
    axes.axis("off")


def draw_image(axes, outcome, shape):
    axes.imshow(COLORS[outcome].reshape(*shape, 3), interpolation="nearest")
    axes.axis("off")


def made(apps, folder, name, *options):
    cloud = folder / f"{name}.pcd"
    subprocess.run([apps / "pcl_shape_scene", cloud, "-format", "binary", *options], check=True,
                   stdout=subprocess.DEVNULL)
    return cloud


def part_clouds(apps, folder, data, noise):
    if data:
        return {path.name[:-len(f"_pds{noise}.pcd")]: path
                for path in sorted((data / "parts").glob(f"*_pds{noise}.pcd"))}
    return {name: made(apps, folder, f"{name}_{noise}", *options, "-noise", NOISES[noise])
            for name, options in GENERATED_PARTS.items()}


def save(figure, path):
    figure.savefig(path, dpi=100)
    plt.close(figure)
    # A third of the bytes, and no difference that one sees.
    fewer = pathlib.Path(__file__).parent / "fewer_colors.py"
    subprocess.run([sys.executable, fewer, path, path, "64"], check=True)
    print(path)


def parts_picture(apps, data, path):
    """Edges with little and much noise, and curved points, a column for each part."""
    rows = (("15", "edges"), ("40", "edges"), ("15", "curved"))
    with tempfile.TemporaryDirectory() as directory:
        clouds = {noise: part_clouds(apps, pathlib.Path(directory), data, noise) for noise in NOISES}
        columns = len(clouds["15"])
        figure, grid = plt.subplots(len(rows), columns, figsize=(2.6 * columns, 2.5 * len(rows)), squeeze=False)
        figure.subplots_adjust(0, 0, 1, 0.91, 0.02, 0.14)
        for line, (noise, task) in zip(grid, rows):
            for axes, (name, cloud) in zip(line, clouds[noise].items()):
                truth = fields_of(cloud)
                judged = TASKS[task](apps, cloud, truth)
                draw_part(axes, truth, outcomes(*judged))
                axes.set_title(f"{name}, .{noise} s\n{task}: {score(*judged)}", fontsize=8, pad=2)
    save(figure, path)


def images_picture(apps, scenes, width, path):
    """Edges above, curved points below."""
    height = width * 3 // 4
    figure, grid = plt.subplots(2, len(scenes), figsize=(3.4 * len(scenes), 5.6), squeeze=False)
    figure.subplots_adjust(0, 0, 1, 0.96, 0.02, 0.06)
    with tempfile.TemporaryDirectory() as directory:
        for column, (name, options) in enumerate(scenes.items()):
            cloud = made(apps, pathlib.Path(directory), str(column), "-organized", "-width", str(width), "-height",
                         str(height), *options)
            truth = fields_of(cloud)
            for line, task in zip(grid, TASKS):
                judged = TASKS[task](apps, cloud, truth)
                draw_image(line[column], outcomes(*judged), (height, width))
                line[column].set_title(f"{name}, {task}: {score(*judged)}", fontsize=9, pad=3)
    save(figure, path)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: scripts/draw/draw_kinds.py BUILD_DIR FOLDER [DATA_DIR]")
    apps, folder = pathlib.Path(sys.argv[1]) / "apps", pathlib.Path(sys.argv[2])
    parts_picture(apps, pathlib.Path(sys.argv[3]) if len(sys.argv) == 4 else None, folder / "mistakes_parts.png")
    images_picture(apps, {name: (*options, "-seed", "956") for name, options in CAMERAS.items()}, 640,
                   folder / "mistakes_cameras.png")
    images_picture(apps, {name: (*options, "-seed", "957") for name, options in DENSE.items()}, 960,
                   folder / "mistakes_dense.png")


if __name__ == "__main__":
    main()
