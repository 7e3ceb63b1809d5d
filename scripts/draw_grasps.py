#!/usr/bin/env python3
"""Draw grasps on the camera's view of a scene.

Usage: scripts/draw_grasps.py SCENE INSTANCE GRASPS PICTURE
SCENE is an ascii PCD file with the fields normal_z and instance, GRASPS what pcl_shape_grasp -json
wrote for the points of that instance. A cup that seals is green, one that leaks red; the line from
its middle goes to where the cup comes from.
"""
import json
import sys

import matplotlib

matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

from cup_rim import rim


def read(path):
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words[0] == "FIELDS":
                names = words[1:]
            if words[0] == "DATA":
                break
        values = np.loadtxt(file, ndmin=2)
    return {name: values[:, i] for i, name in enumerate(names)}


def seen(points):
    return points[..., 0] / points[..., 2], -points[..., 1] / points[..., 2]


def main():
    scene_path, instance, grasps_path, picture = sys.argv[1:]
    scene = read(scene_path)
    with open(grasps_path, encoding="utf-8") as file:
        result = json.load(file)
    radius = result["parameters"]["cup_radius"]
    points = np.stack([scene[c] for c in "xyz"], axis=1)
    light = np.clip(-scene["normal_z"], 0.0, 1.0)[:, None]
    target = (scene["instance"] == int(instance))[:, None]
    color = np.where(target, [0.45, 0.62, 0.88], [0.82, 0.82, 0.82]) * (0.45 + 0.55 * light)

    u, v = seen(points)
    figure, axes = plt.subplots(figsize=(6.4, 4.8), dpi=120)
    axes.scatter(u, v, c=color, s=3.0, marker="s", linewidths=0)
    for grasp in reversed(result["grasps"]):
        paint = "#1a9641" if grasp["seals"] else "#d7191c"
        axes.fill(*seen(rim(grasp, radius)), facecolor=paint, alpha=0.35)
        axes.plot(*seen(rim(grasp, radius)), color=paint, linewidth=1.5)
        start = np.array(grasp["position"])
        line = np.stack([start, start - 3.0 * radius * np.array(grasp["approach"])])
        axes.plot(*seen(line), color=paint, linewidth=1.5)
    place = target[:, 0]
    margin = 0.12
    axes.set_xlim(u[place].min() - margin, u[place].max() + margin)
    axes.set_ylim(v[place].min() - margin, v[place].max() + margin)
    axes.set_aspect("equal")
    axes.axis("off")
    figure.savefig(picture, bbox_inches="tight", pad_inches=0.02)


if __name__ == "__main__":
    main()
