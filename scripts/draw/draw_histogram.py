#!/usr/bin/env python3
"""Draw the histograms of a model file of pcl_shape_histogram, side by side.

Usage: scripts/draw/draw_histogram.py model.json out.png [CLASS ...]
Without CLASS all of the model's classes are drawn. Needs Debian's python3-matplotlib.
"""
import json
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402
from matplotlib.colors import LogNorm  # noqa: E402


def draw(axes, shape, bins):
    counts = np.array(shape["counts"], float).T  # sigma up, mu to the right
    extent = (0, np.degrees(bins["mu_range"]), 0, np.degrees(bins["sigma_range"]))
    image = axes.imshow(np.ma.masked_equal(counts, 0), origin="lower", extent=extent, aspect="auto",
                        interpolation="nearest", cmap="viridis", zorder=2,  # above the grid
                        norm=LogNorm(1, max(counts.max(), 2)))
    axes.set(title=shape["name"], xlabel="mean angle µ (degrees)", ylabel="deviation σ (degrees)")
    axes.grid(color="0.92", linewidth=0.6)
    axes.figure.colorbar(image, ax=axes, label="points a bin", format="%d")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    path, picture, *names = sys.argv[1:]
    with open(path, encoding="utf-8") as file:
        model = json.load(file)
    if model.get("format") != "pcl_shape model":
        sys.exit(f"{path}: is no model file; expected one that pcl_shape_histogram wrote")
    known = [shape["name"] for shape in model["classes"]]
    for name in names:
        if name not in known:
            sys.exit(f"{path}: has no class '{name}'; expected one of {', '.join(known)}")
    shapes = [shape for shape in model["classes"] if not names or shape["name"] in names]
    figure, axes = pyplot.subplots(1, len(shapes), figsize=(5.6 * len(shapes), 4.4), squeeze=False,
                                   layout="constrained")
    for ax, shape in zip(axes[0], shapes):
        draw(ax, shape, model["bins"])
    # Without the version of matplotlib a picture changes only with what it shows.
    figure.savefig(picture, dpi=110, metadata={"Software": None})


if __name__ == "__main__":
    main()
