# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Arrays of any layout and of both types; what is refused, and how."""
import gc
import warnings

import numpy as np
import pytest

import pcl_shape
from conftest import same, table_scene


def counts(points):
    return pcl_shape.NeighborhoodSweep(points).count_neighbors(radius=0.02)


def test_layouts(scene):
    expected = counts(scene)
    padded = np.zeros((len(scene), 7), np.float32)
    padded[:, 1:4] = scene
    assert same(counts(padded[:, 1:4]), expected)
    assert same(counts(np.asfortranarray(scene)), expected)
    assert same(counts(np.repeat(scene, 2, axis=0)[::2]), expected)
    assert same(counts(scene[::-1]), expected[::-1])
    packed = np.zeros(len(scene), [("flag", np.uint8), ("xyz", np.float32, 3)])  # not aligned
    packed["xyz"] = scene
    assert same(counts(packed["xyz"]), expected)
    locked = scene.copy()
    locked.setflags(write=False)
    assert same(counts(locked), expected)


def test_float64_of_small_coordinates_is_float32(scene):
    assert same(counts(scene.astype(np.float64)), counts(scene))


def test_float64_of_large_coordinates_gets_an_offset():
    points = table_scene()
    shift = np.array([4.5e5, 5.4e6, 120.0])
    field = pcl_shape.detect(points + shift)
    near = pcl_shape.detect(points)
    assert same(near.offset, np.zeros(3))
    assert np.abs(field.offset - shift)[:2].max() < 1.0
    # What is added to coordinates rounds them: to 1e-9 m in float64, to 0.5 m in float32.
    assert (field.surface == near.surface).mean() > 0.99
    assert np.abs(field.crease_points.mean(axis=0) - near.crease_points.mean(axis=0) - shift).max() < 0.01
    by_hand = pcl_shape.detect((points + shift - field.offset).astype(np.float32))
    assert same(by_hand.likelihoods, field.likelihoods)


def test_places_are_those_of_the_input():
    points = table_scene()
    shift = np.array([4.5e5, 5.4e6, 120.0])
    eye = np.array([0.0, 0.0, 2.0])
    far = pcl_shape.detect(points + shift)
    moved = pcl_shape.instances(far, of="curved", primitive="cylinder", view_point=eye + shift)
    cylinder = moved[0].coefficients
    assert moved[0].primitive == "cylinder"
    # The axis passes the middle of the cylinder, wherever its point is.
    to_middle = np.array([0.15, 0.05, 0.07]) + shift - cylinder[:3]
    assert np.linalg.norm(np.cross(to_middle, cylinder[3:6])) < 0.003
    assert abs(cylinder[6] - 0.06) < 0.003
    assert np.abs(moved[0].centroid - np.array([0.15, 0.05, 0.07]) - shift).max() < 0.03
    planes = pcl_shape.instances(far, of="planar", primitive="plane", view_point=eye + shift)
    a, b, c, d = planes[0].coefficients
    assert abs((a, b, c) @ shift + d) < 0.01  # the table is at z = 0
    best = pcl_shape.grasps(far, view_point=eye + shift)[0]
    assert np.abs(best.position - shift).max() < 0.5


def test_float32_of_large_coordinates_warns():
    points = (table_scene() + np.array([4.5e5, 5.4e6, 0.0])).astype(np.float32)
    with pytest.warns(RuntimeWarning, match="in steps of 0.5"):
        pcl_shape.NeighborhoodSweep(points)
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        pcl_shape.NeighborhoodSweep(table_scene().astype(np.float32))
        with pytest.raises(RuntimeWarning):
            pcl_shape.NeighborhoodSweep(points)


def test_results_are_views_that_outlive_the_field(scene):
    field = pcl_shape.detect(scene, edges_only=True)
    likelihood = field.edge_likelihood
    before = likelihood.copy()
    assert not likelihood.flags.writeable and not field.edges.flags.writeable
    del field
    gc.collect()
    assert same(likelihood, before)


def test_the_input_may_change_afterwards(scene):
    points = scene.copy()
    sweep = pcl_shape.NeighborhoodSweep(points)
    expected = sweep.count_neighbors(radius=0.02)
    points[:] = 0
    assert same(sweep.count_neighbors(radius=0.02), expected)


def test_edges_only(scene):
    field = pcl_shape.detect(scene, edges_only=True)
    assert field.classes == [] and field.likelihoods.shape == (len(scene), 0)
    assert not field.surface.any() and field.edges.any()
    with pytest.raises(ValueError, match="made for edges only"):
        pcl_shape.labels(field)
    with pytest.raises(ValueError, match="made for edges only"):
        pcl_shape.instances(field)


def test_target_of_grasps(scene):
    field = pcl_shape.detect(scene)
    on_box = (scene[:, 0] < -0.05) & (scene[:, 2] > 0.1)
    by_mask = pcl_shape.grasps(field, target=on_box)
    by_index = pcl_shape.grasps(field, target=np.flatnonzero(on_box))
    assert by_mask and [g.score for g in by_mask] == [g.score for g in by_index]
    assert all(g.position[2] > 0.1 for g in by_mask)


SOME = table_scene()[::10].astype(np.float32)
BAD = [
    (lambda: pcl_shape.detect(SOME[:, :2]), r"points has the shape \(1700, 2\): it must be \(n, 3\)"),
    (lambda: pcl_shape.detect(SOME.ravel()), r"points has the shape \(5100,\): it must be \(n, 3\)"),
    (lambda: pcl_shape.detect(SOME.astype(np.int64)), "points has the type int64: it must be float32 or float64"),
    (lambda: pcl_shape.detect(SOME.astype(">f4")), "points has the type >f4: it must be float32 or float64"),
    (lambda: pcl_shape.detect(SOME[:0]), "empty"),
    (lambda: pcl_shape.detect(SOME * np.nan), "finite"),
    (lambda: pcl_shape.detect(SOME, threshold=2.0), "threshold is 2"),
    (lambda: pcl_shape.detect(SOME, resolution=-1.0), "resolution"),
    (lambda: pcl_shape.detect(SOME, normals=SOME[:5]), "5 normals are given for a search surface of 1700 points"),
    (lambda: pcl_shape.instances(SOME, of="spherical"), "class 'spherical': it must be one of planar, curved"),
    (lambda: pcl_shape.instances(SOME, low=0.9), "thresholds are 0.6 and 0.9: 0 <= low <= high <= 1 must hold"),
    (lambda: pcl_shape.instances(SOME, min_points=0), "minimum number of points is 0"),
    (lambda: pcl_shape.instances(SOME, primitive="cone"), "primitive is 'cone': it must be none, auto, plane, cylinder"),
    (lambda: pcl_shape.grasps(SOME, cup_radius=0.0), "radius"),
    (lambda: pcl_shape.grasps(SOME, target=np.array([1700])), "target has 1700: it must be 0 to 1700 - 1"),
    (lambda: pcl_shape.grasps(SOME, target=np.ones(3, bool)), "target has 3 booleans for 1700 points"),
    (lambda: pcl_shape.grasps(SOME, target=np.ones(3)), "target has the type float64"),
    (lambda: pcl_shape.labels(SOME, confidence=-0.5), "confidence is -0.5: it must be 0 to 1"),
    (lambda: pcl_shape.ground(SOME, up=(0, 0, 0)), "up"),
    (lambda: pcl_shape.normals(SOME), "radius"),
    (lambda: pcl_shape.normals(SOME, radius=-1.0), "radius"),
    (lambda: pcl_shape.normals(SOME, radius=1.0, scale="feet"), "scale is 'feet': it must be fixed, depth or density"),
    (lambda: pcl_shape.inad(SOME, radius=1.0, outlier_rate=-1.0), "outlier rate is -1"),
    (lambda: pcl_shape.NeighborhoodSweep(SOME).normals(), "set one of radius, radii and k, not 0 of them"),
    (lambda: pcl_shape.NeighborhoodSweep(SOME).normals(k=1701), "k 1701: it must be 1 to 1700"),
    (lambda: pcl_shape.NeighborhoodSweep(SOME).normals(radii=SOME[:3, 0]), "3 radii are given for 1700 queries"),
]


@pytest.mark.parametrize("call,message", BAD)
def test_refusals(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_other_types():
    with pytest.raises(TypeError):
        pcl_shape.detect([[0, 0, 0]])
    with pytest.raises(TypeError, match="ShapeField or an array"):
        pcl_shape.labels("cloud.pcd")


def test_no_ground_warns():
    wall = SOME * np.float32([1, 1, 0])
    with pytest.warns(RuntimeWarning, match="no ground was found"):
        ground, likelihood = pcl_shape.ground(wall, up=(1, 0, 0), sensor=(0, 0, 1))
    assert not ground.any() and likelihood.shape == ground.shape == (1700,)
