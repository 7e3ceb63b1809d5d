#!/usr/bin/env python3
"""Draw clouds with the field ground, ASCII PCD, from above, one below the other.

Usage: scripts/draw_ground.py in.pcd ... out.png
"""
import sys

import matplotlib
import numpy as np

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402

LEFT, RIGHT, SIDE = -30.0, 45.0, 14.0  # meters
COLORS = {0: "#d1495b", 1: "#2e6f9e"}


def read(path):
    with open(path, encoding="ascii") as file:
        fields = []
        for line in file:
            name, *values = line.split()
            if name == "FIELDS":
                fields = values
            if name == "DATA":
                break
        values = np.loadtxt(file)
    return {field: values[:, column] for column, field in enumerate(fields)}


def draw(axes, cloud):
    order = np.argsort(cloud["z"])
    colors = [COLORS[int(ground)] for ground in cloud["ground"][order]]
    axes.scatter(cloud["x"][order], cloud["y"][order], s=0.35, c=colors, linewidths=0)
    axes.set(xlim=(LEFT, RIGHT), ylim=(-SIDE, SIDE), aspect="equal", ylabel="y (m)",
             facecolor="white")


def main():
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    clouds = [read(path) for path in sys.argv[1:-1]]
    figure, axes = pyplot.subplots(len(clouds), 1, figsize=(10, 4.1 * len(clouds)), sharex=True,
                                   squeeze=False, layout="constrained")
    for ax, cloud in zip(axes[:, 0], clouds):
        draw(ax, cloud)
    axes[-1, 0].set_xlabel("x (m), forward")
    marks = [pyplot.Line2D([], [], marker="o", linestyle="", color=COLORS[label], label=text)
             for label, text in ((1, "ground"), (0, "not ground"))]
    axes[0, 0].legend(handles=marks, loc="lower center", bbox_to_anchor=(0.5, 1.04), borderaxespad=0, ncols=2)
    figure.savefig(sys.argv[-1], dpi=110)


if __name__ == "__main__":
    main()
