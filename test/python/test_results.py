# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""The module gives what the C++ classes give, bit for bit."""
import numpy as np
import pytest

import pcl_shape
from conftest import Reference, same


@pytest.fixture(scope="module")
def field(scene):
    return pcl_shape.detect(scene)


def assert_same_field(field, reference):
    classes = len(field.classes)
    assert field.classes == ["planar", "curved"]
    assert same(field.edges.astype(np.uint32), reference("edges", np.uint32))
    assert same(field.edge_type, reference("edge_type", np.uint8))
    assert same(field.edge_likelihood, reference("edge_likelihood"))
    assert same(field.surface, reference("surface", np.uint32))
    assert same(field.likelihoods, reference("likelihoods", columns=classes))
    assert same(field.normals, reference("normals", columns=3))
    assert same(field.spacing, reference("spacing"))
    assert same(field.crease_points.astype(np.float32), reference("crease_points", columns=3))
    assert same(np.array([line.length for line in field.lines()], np.float32), reference("line_lengths"))


def assert_same_tasks(field, points, reference):
    instances = pcl_shape.instances(field, of="object", primitive="auto")
    assert same(instances.labels, reference("instances", np.uint32))
    coefficients = [i.coefficients for i in instances if i.coefficients is not None]
    assert same(np.concatenate([[], *coefficients]).astype(np.float32), reference("coefficients"))
    grasps = [[*g.position, g.score] for g in pcl_shape.grasps(field)]
    assert same(np.array(grasps, np.float32).reshape(-1, 4), reference("grasps", columns=4))
    labels, confidence, classes = pcl_shape.labels(field)
    assert classes == ["planar", "curved", "edge"]
    assert same(labels, reference("labels", np.uint32))
    assert same(confidence, reference("confidence"))
    ground, likelihood = pcl_shape.ground(points)
    assert same(likelihood, reference("ground_likelihood"))
    assert same(ground, likelihood >= 0.5)


def test_the_scene_has_everything(field):
    assert field.edges.any() and (field.surface == 1).any() and (field.surface == 2).any()
    assert set(np.unique(field.edge_type)) >= {0, 1}
    assert len(pcl_shape.instances(field, of="object", view_point=(0, 0, 2))) >= 2
    assert pcl_shape.grasps(field)[0].seals
    assert field.lines()[0].length > 0.1


def test_detect(field, reference):
    assert_same_field(field, reference)


def test_tasks(field, scene, reference):
    assert_same_tasks(field, scene, reference)


def test_tasks_make_a_field_of_their_own(field, scene):
    assert same(pcl_shape.instances(scene, of="object").labels, pcl_shape.instances(field, of="object").labels)
    assert same(pcl_shape.labels(scene)[1], pcl_shape.labels(field)[1])
    assert [g.score for g in pcl_shape.grasps(scene)] == [g.score for g in pcl_shape.grasps(field)]


def corner_of_a_kinect(distance, column, random):
    """Where two walls meet, the same 220 by 220 pixels at any distance in meters."""
    focal_length, disparity_step, pixels = 575.0, 0.00287, np.arange(-110, 110)
    y, x = np.meshgrid(pixels / focal_length, pixels / focal_length, indexing="ij")
    depth = np.minimum(distance / (1.0 - 0.6 * x), distance / (1.0 + 1.2 * x))
    steps = np.round(1.0 / (depth * disparity_step) + random.uniform(-0.2, 0.2, depth.shape))
    z = 1.0 / (disparity_step * steps)
    return np.stack([(x + column / focal_length) * z, y * z, z], axis=-1).reshape(-1, 3)


def test_one_resolution():
    random = np.random.default_rng(3)
    room = np.concatenate([corner_of_a_kinect(*at, random) for at in [(1.1, -220), (3.5, 0), (3.5, 220)]])
    zones = pcl_shape.detect(room, edges_only=True)
    assert zones.finest_resolution < zones.resolution
    one = pcl_shape.detect(room, edges_only=True, one_resolution=True)
    assert one.finest_resolution == one.resolution >= zones.resolution


def test_features(scene, reference):
    normals, curvature = pcl_shape.normals(scene, radius=0.02)
    assert same(np.c_[normals, curvature], reference("feature_normals", columns=4))
    assert same(pcl_shape.inad(scene, radius=0.02), reference("inad", columns=2))
    assert same(pcl_shape.inad(scene, radius=0.02, normals=normals), reference("inad", columns=2))


def test_sweep(scene, reference):
    sweep = pcl_shape.NeighborhoodSweep(scene)
    assert len(sweep) == len(scene)
    assert same(sweep.count_neighbors(radius=0.02), reference("counts", np.uint32))
    assert same(sweep.distance_to_nearest(12), reference("distances"))
    radii = np.full(len(scene), 0.02, np.float32)
    assert same(sweep.count_neighbors(radii=radii), reference("counts", np.uint32))
    some = slice(100, 200)
    assert same(sweep.count_neighbors(radius=0.02, queries=scene[some]), reference("counts", np.uint32)[some])
    normals, curvature = sweep.normals(radius=0.02)
    expected = reference("feature_normals", columns=4)
    assert same(np.abs(normals), np.abs(expected[:, :3]))
    assert same(curvature, expected[:, 3])
    assert same(sweep.inad(normals, radius=0.02), reference("inad", columns=2))


@pytest.mark.parametrize("threads", [1, 3])
def test_any_number_of_threads(field, scene, threads):
    other = pcl_shape.detect(scene, threads=threads)
    assert same(other.likelihoods, field.likelihoods)
    assert same(other.edge_type, field.edge_type)


def test_learn4(learn4, tmp_path):
    reference = Reference(learn4, tmp_path)
    field = pcl_shape.detect(learn4)
    assert_same_field(field, reference)
    assert_same_tasks(field, learn4, reference)
