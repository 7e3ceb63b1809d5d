# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Scenes for the tests of the Python module, and what the C++ classes compute of them."""
import os
import pathlib
import subprocess
import sys

import numpy as np
import pytest


def box(rng, center, size, count):
    """Points on the five faces of a box that can be seen."""
    faces = rng.integers(0, 5, count)
    points = rng.uniform(-0.5, 0.5, (count, 3))
    for axis, side, face in ((0, -0.5, 0), (0, 0.5, 1), (1, -0.5, 2), (1, 0.5, 3), (2, 0.5, 4)):
        points[faces == face, axis] = side
    return points * size + center


def cylinder(rng, center, radius, height, count):
    angles = rng.uniform(0, 2 * np.pi, count)
    heights = rng.uniform(0, height, count)
    return np.stack([radius * np.cos(angles), radius * np.sin(angles), heights], axis=1) + center


def table_scene():
    """A table with a box and a cylinder on it, seen from above: meters, float64."""
    rng = np.random.default_rng(7)
    table = np.c_[rng.uniform(-0.4, 0.4, (9000, 2)), np.zeros(9000)]
    return np.concatenate([table, box(rng, (-0.15, 0.0, 0.06), (0.14, 0.16, 0.12), 4500),
                           cylinder(rng, (0.15, 0.05, 0.0), 0.06, 0.15, 3500)])


@pytest.fixture(scope="session")
def scene():
    """float32 (n, 3) with points that are not finite."""
    points = table_scene().astype(np.float32)
    points[5] = np.nan
    points[17, 2] = np.inf
    return points


class Reference:
    """Arrays that pcl_shape_python_reference wrote for points."""

    def __init__(self, points, directory):
        self.directory = directory
        path = directory / "points"
        path.write_bytes(np.ascontiguousarray(points, np.float32).tobytes())
        subprocess.run([os.environ["PCL_SHAPE_PYTHON_REFERENCE"], path, directory], check=True)

    def __call__(self, name, dtype=np.float32, columns=None):
        values = np.fromfile(self.directory / name, dtype)
        return values if columns is None else values.reshape(-1, columns)


@pytest.fixture(scope="session")
def reference(scene, tmp_path_factory):
    return Reference(scene, tmp_path_factory.mktemp("reference"))


@pytest.fixture(scope="session")
def learn4():
    """The real scene learn4 of PCL_SHAPE_TEST_DATA."""
    data = os.environ.get("PCL_SHAPE_TEST_DATA")
    if not data:
        pytest.skip("PCL_SHAPE_TEST_DATA is not set: no real scenes")
    sys.path.insert(0, str(pathlib.Path(os.environ["PCL_SHAPE_SOURCE_DIR"]) / "scripts"))
    from pcd_fields import read_pcd
    columns = read_pcd(pathlib.Path(data) / "osd" / "learn4_gt.pcd")[1]
    return np.stack([np.frombuffer(columns[axis], np.float32) for axis in "xyz"], axis=1)


def same(a, b):
    """Whether two arrays have the same bits."""
    a, b = np.asarray(a), np.asarray(b)
    return a.dtype == b.dtype and a.shape == b.shape and a.tobytes() == b.tobytes()
