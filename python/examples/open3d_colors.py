#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Color each object of a cloud, edges black, from an Open3D cloud to an Open3D cloud.

Usage: open3d_colors.py cloud.ply|cloud.pcd|points.npy colored.ply
"""
import sys

import numpy as np

import pcl_shape

try:
    import open3d
except ImportError:
    sys.exit("this example needs open3d (Debian: python3-open3d)")

GRAY, BLACK = (0.7, 0.7, 0.7), (0.0, 0.0, 0.0)


def read(path):
    if not path.endswith(".npy"):
        return open3d.io.read_point_cloud(path)
    return open3d.geometry.PointCloud(open3d.utility.Vector3dVector(np.load(path).astype(np.float64)))


def colored(cloud):
    """The cloud with a color for each object; what belongs to none is gray."""
    field = pcl_shape.detect(np.asarray(cloud.points))
    objects = pcl_shape.instances(field, of="object")
    palette = np.random.default_rng(1).uniform(0.2, 1.0, (len(objects) + 1, 3))
    palette[0] = GRAY
    colors = palette[objects.labels]
    colors[field.edges] = BLACK
    cloud.colors = open3d.utility.Vector3dVector(colors)
    cloud.normals = open3d.utility.Vector3dVector(field.normals.astype(np.float64))
    print(f"{len(objects)} objects, {field.edges.sum()} edge points")
    return cloud


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    cloud = colored(read(sys.argv[1]))
    if not open3d.io.write_point_cloud(sys.argv[2], cloud):
        sys.exit(f"cannot write {sys.argv[2]}")


main()
