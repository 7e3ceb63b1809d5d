# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Models are made of samples, saved, loaded and used."""
import json
import pathlib

import numpy as np
import pytest

import pcl_shape
from conftest import same


def plane(count=4000):
    rng = np.random.default_rng(1)
    return np.c_[rng.uniform(0, 1, (count, 2)), np.zeros(count)]


def waves(count=4000):
    points = plane(count)
    points[:, 2] = 0.02 * np.sin(20 * points[:, 0])
    return points


@pytest.fixture(scope="module")
def model():
    return pcl_shape.ShapeModel.train({"flat": plane(), "wavy": [waves(), waves(3000)]}, radius=3.0, bins=30,
                                      priors={"wavy": 0.5}, smoothing=1.0, floor=0.01)


def test_train(model):
    assert model.classes == ["flat", "wavy"]
    assert model.priors == {"flat": 1.0, "wavy": 0.5}
    assert model.parameters["radius"] == model.parameters["normal_radius"] == 3.0
    assert model.parameters["scale"] == "density"
    assert (model.smoothing, model.floor) == (1.0, 0.01)
    flat, wavy = model.histogram("flat"), model.histogram("wavy")
    assert flat.shape == (30, 30) and flat.dtype == np.uint64
    assert flat[0, 0] == flat.sum() == 4000 and wavy.sum() > 6900 and wavy[1:].sum() > 6000
    assert model.ranges("flat") == (np.pi / 2, np.pi / 2)


def test_train_counts_what_inad_gives():
    points = waves()
    model = pcl_shape.ShapeModel.train({"wavy": points}, radius=0.06, scale="fixed")
    inad = pcl_shape.inad(points, radius=0.06)
    bins = (inad / np.float32(np.pi / 20)).astype(int)
    expected = np.zeros((10, 10), np.uint64)
    np.add.at(expected, (bins[:, 0], bins[:, 1]), 1)
    assert (model.histogram("wavy") == expected).all()


def test_a_mask_chooses_what_is_counted():
    points = waves()
    left = points[:, 0] < 0.5
    masked = pcl_shape.ShapeModel.train({"wavy": (points, left)}, radius=5.0)
    assert masked.histogram("wavy").sum() == left.sum()
    by_index = pcl_shape.ShapeModel.train({"wavy": (points, np.flatnonzero(left))}, radius=5.0)
    assert same(by_index.histogram("wavy"), masked.histogram("wavy"))


def test_save_and_load(model, tmp_path):
    path = tmp_path / "model.json"
    model.save(path)
    loaded = pcl_shape.ShapeModel.load(str(path))
    assert loaded.classes == model.classes and loaded.parameters == model.parameters
    assert same(loaded.histogram("wavy"), model.histogram("wavy"))
    assert "classes" in json.loads(path.read_text())


def test_detect_with_a_model(model):
    points = waves()
    field = pcl_shape.detect(points, surface_model=model)
    assert field.classes == ["flat", "wavy"]
    assert (field.surface == 2).mean() > 0.8
    instances = pcl_shape.instances(field, of="wavy")
    assert instances.classes == ["flat", "wavy"] and len(instances[0]) > 1000


def test_evaluate(model):
    pairs = np.array([[0.0, 0.0], [0.2, 0.1], [np.nan, 0.0]], np.float32)
    values = model.evaluate(pairs)
    assert values.shape == (3, 2) and values.dtype == np.float32
    assert values[0, 0] > 0.5 and values[1, 1] > 0.5 and np.isnan(values[2]).all()
    assert same(pcl_shape.ShapeModel.default_surfaces().evaluate(pairs[:1]).sum(axis=1), np.ones(1, np.float32))


def test_default_models():
    assert pcl_shape.ShapeModel.default_edges().classes == ["edge", "surface"]
    assert pcl_shape.ShapeModel.default_surfaces().classes == ["planar", "curved"]


BAD = [
    (lambda: pcl_shape.ShapeModel.load("no/such/file.json"), "no/such/file.json"),
    (lambda: pcl_shape.ShapeModel.train({"flat": plane()}), "radius"),
    (lambda: pcl_shape.ShapeModel.train({"": plane()}, radius=5.0), "^a class needs a name$"),
    (lambda: pcl_shape.ShapeModel.train({"flat": plane()}, radius=5.0, priors={"bent": 1.0}), "priors has the class 'bent'"),
    (lambda: pcl_shape.ShapeModel.train({"flat": plane()}, radius=5.0, bins=0), "bins"),
    (lambda: pcl_shape.ShapeModel.train({"flat": plane()}, radius=5.0, smoothing=-1.0), "smoothing"),
    (lambda: pcl_shape.ShapeModel.train({"flat": (plane(), plane(), plane())}, radius=5.0), "a tuple of 3"),
    (lambda: pcl_shape.ShapeModel.default_edges().histogram("curved"), "class 'curved': it must be one of edge, surface"),
    (lambda: pcl_shape.detect(plane(), edge_model=pcl_shape.ShapeModel.train({"flat": plane()}, radius=5.0)),
     "the edge model has 1 classes: it must have two"),
]


@pytest.mark.parametrize("call,message", BAD)
def test_refusals(call, message):
    with pytest.raises(ValueError, match=message):
        call()


def test_load_says_what_is_wrong(tmp_path):
    path = pathlib.Path(tmp_path) / "bad.json"
    path.write_text("{}")
    with pytest.raises(ValueError, match="bad.json"):
        pcl_shape.ShapeModel.load(path)
