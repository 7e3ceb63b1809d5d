#!/usr/bin/env python3
"""Draw an organized cloud, and the instances of others of the same points, side by side.

Usage: scripts/draw_instances.py scene.pcd instances.pcd ... out.png
scene.pcd has normals; all are PCD files in ascii.
"""
import sys

import matplotlib.pyplot as plt
import numpy as np

MARGIN = 25


class Cloud:
    def __init__(self, path):
        with open(path, encoding="ascii") as file:
            header = {}
            for line in file:
                name, *values = line.split()
                header[name] = values
                if name == "DATA":
                    break
            self.columns = dict(zip(header["FIELDS"], np.loadtxt(file).T))
        self.shape = int(header["HEIGHT"][0]), int(header["WIDTH"][0])

    def image(self, field):
        return self.columns[field].reshape(self.shape)


def light(scene):
    toward = -(0.35 * scene.image("normal_x") + 0.55 * scene.image("normal_y") + scene.image("normal_z"))
    return 0.3 + 0.7 * np.minimum(1, np.abs(toward) / 1.2)


def colored(labels, shade):
    palette = np.vstack([[0.82, 0.82, 0.82], plt.get_cmap("tab20").colors])
    indices = np.where(labels > 0, 1 + (2 * (labels - 1) + (labels - 1) // 10) % 20, 0).astype(int)
    picture = palette[indices] * shade[..., None]
    picture[np.isnan(shade)] = 1
    return picture


def main():
    if len(sys.argv) < 4:
        sys.exit("usage: scripts/draw_instances.py scene.pcd instances.pcd ... out.png")
    scene = Cloud(sys.argv[1])
    shade = light(scene)
    panels = [colored(np.zeros(scene.shape, int), shade)]
    panels += [colored(Cloud(path).image("instance").astype(int), shade) for path in sys.argv[2:-1]]
    rows, columns = np.nonzero(scene.image("instance"))
    part = np.s_[max(0, rows.min() - MARGIN):rows.max() + MARGIN,
                 max(0, columns.min() - MARGIN):columns.max() + MARGIN]
    gap = np.ones((panels[0][part].shape[0], 6, 3))
    joined = [piece for panel in panels for piece in (panel[part], gap)][:-1]
    plt.imsave(sys.argv[-1], np.clip(np.hstack(joined), 0, 1))


if __name__ == "__main__":
    main()
