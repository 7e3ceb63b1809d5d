#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Draw the planar (blue), curved (orange) and edge (red) points of a cloud with matplotlib.

Usage: matplotlib_surfaces.py points.npy picture.png

points.npy: an array of shape (n, 3), meters, as numpy.save() writes it.
"""
import sys

import numpy as np

import pcl_shape

try:
    import matplotlib.pyplot as plt
except ImportError:
    sys.exit("this example needs matplotlib (Debian: python3-matplotlib)")

GRAY, BLUE, ORANGE, RED = "#b0b0b0", "#3b6fb6", "#f28e2b", "#d62728"


def colors_of(field):
    colors = np.array([GRAY, BLUE, ORANGE])[field.surface]
    colors[field.edges] = RED
    return colors


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    points = np.load(sys.argv[1])
    field = pcl_shape.detect(points)
    shown = np.isfinite(points).all(axis=1)
    axes = plt.figure(figsize=(8, 6)).add_subplot(projection="3d")
    axes.scatter(*points[shown].T, c=colors_of(field)[shown], s=1)
    for line in field.lines():
        axes.plot(*line.points.T, color="black", linewidth=1)
    axes.set_box_aspect(np.ptp(points[shown], axis=0))
    plt.savefig(sys.argv[2], dpi=120)
    print(f"{field.edges.sum()} edge points, {(field.surface == 1).sum()} planar, {(field.surface == 2).sum()} curved")


main()
