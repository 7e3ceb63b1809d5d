#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the tables of scenes of other people in doc/evaluation.md. The applications run without options. Markdown goes to
standard output.
Usage: scripts/evaluate/evaluate_public.py BUILD_DIR CLONES_DIR
CLONES_DIR has clones of some of these public repositories, by their names; those that are missing are left out:
  pytorch_6dof-graspnet    github.com/jsll/pytorch_6dof-graspnet, demo/data/*.npy (a RealSense; points of an object)
  PoseCNN-PyTorch          github.com/NVlabs/PoseCNN-PyTorch, data/demo/*-depth.png
  UnseenObjectClustering   github.com/NVlabs/UnseenObjectClustering, data/demo/*-depth.png (a RealSense)
  graspnet-baseline        github.com/graspnet/graspnet-baseline, doc/example_data/depth.png
  data                     github.com/PointCloudLibrary/data, segmentation/mOSD (a Kinect, with labels of parts)
The .npy files are pickles, which run what they hold: use clones that you trust.
Needs python3-numpy, python3-scipy and python3-pil.
"""
import json
import pathlib
import re
import sys
import tempfile

import numpy
from PIL import Image
from scipy import ndimage
from scipy.io import loadmat
from scipy.spatial import cKDTree

from evaluate_sensors import best_iou, object_score, run, share, write_pcd

PLANE = 0.01  # meters: what is nearer is on the table
BORDER = 12  # pixels between the table that counts and anything else
NEAREST_TABLES = 2.0  # meters
ON_OBJECT = 0.005  # meters from the published points of the object


def points_of(depth, camera):
    """Three coordinates for each pixel, NaN where nothing was measured."""
    v, u = numpy.indices(depth.shape)
    z = numpy.where((depth > 0) & numpy.isfinite(depth), depth, numpy.nan)
    return numpy.stack([(u - camera[0, 2]) * z / camera[0, 0], (v - camera[1, 2]) * z / camera[1, 1], z], -1)


def matrix(fx, fy, x, y):
    return numpy.array([[fx, 0, x], [0, fy, y], [0, 0, 1]])


def table_of(points):
    """The pixels of the plane that most points are on, away from all others; none without a plane."""
    is_near = numpy.isfinite(points[..., 2]) & (points[..., 2] < NEAREST_TABLES)
    near = points[is_near]
    nowhere = numpy.zeros(is_near.shape, bool)
    if len(near) < 3:
        return nowhere
    random = numpy.random.default_rng(1)
    sample = near[random.integers(len(near), size=20000)]
    most, normal, center = 0, None, None
    for _ in range(800):
        a, b, c = near[random.integers(len(near), size=3)]
        cross = numpy.cross(b - a, c - a)
        length = numpy.linalg.norm(cross)
        if length < 1e-4:
            continue
        count = numpy.count_nonzero(abs((sample - a) @ (cross / length)) < PLANE)
        if count > most:
            most, normal, center = count, cross / length, a
    if normal is None:  # all points are at one place, or on a line
        return nowhere
    for _ in range(5):
        on = near[abs((near - center) @ normal) < PLANE]
        center = on.mean(0)
        normal = numpy.linalg.svd(on[::7] - center, full_matrices=False)[2][2]
    is_on = is_near & (abs((points - center) @ normal) < PLANE)
    return ndimage.distance_transform_edt(is_on) > BORDER


def depth_image(path):
    return numpy.asarray(Image.open(path)).astype(float) / 1000  # of millimeters


def graspnet_6dof(folder):
    for path in sorted((folder / "demo/data").glob("*.npy")):
        demo = numpy.load(path, allow_pickle=True, encoding="latin1").item()
        points = points_of(demo["depth"].astype(float), demo["intrinsics_matrix"])
        distances = cKDTree(demo["smoothed_object_pc"]).query(numpy.nan_to_num(points, nan=99.0))[0]
        yield path.stem, points, distances < ON_OBJECT


def posecnn(folder):
    text = (folder / "data/demo/meta.yml").read_text()
    numbers = re.search(r"INTRINSICS: \[([^\]]*)\]", text).group(1)
    camera = numpy.array([float(number) for number in numbers.split(",")]).reshape(3, 3)
    for k, path in enumerate(sorted((folder / "data/demo").glob("*-depth.png"))):
        yield f"PoseCNN {k}", points_of(depth_image(path), camera), None


def unseen_objects(folder):
    numbers = json.loads((folder / "data/demo/camera_params.json").read_text())
    camera = matrix(*(numbers[name] for name in ("fx", "fy", "x_offset", "y_offset")))
    for k, path in enumerate(sorted((folder / "data/demo").glob("*-depth.png"))):
        yield f"UnseenObjectClustering {k}", points_of(depth_image(path), camera), None


def graspnet(folder):
    camera = loadmat(folder / "doc/example_data/meta.mat")["intrinsic_matrix"]
    yield "GraspNet", points_of(depth_image(folder / "doc/example_data/depth.png"), camera), None


IMAGES = {"pytorch_6dof-graspnet": graspnet_6dof, "PoseCNN-PyTorch": posecnn, "UnseenObjectClustering": unseen_objects,
          "graspnet-baseline": graspnet}


def image_row(apps, name, points, truth):
    is_table = table_of(points).ravel()
    if not is_table.any():
        print(f"| {name} | no table was found | | | |", flush=True)
        return
    with tempfile.TemporaryDirectory() as directory:
        cloud = pathlib.Path(directory) / "cloud.pcd"
        write_pcd(cloud, {axis: points[..., k].ravel() for k, axis in enumerate("xyz")}, points.shape[:2])
        result = run(apps, "pcl_shape_detect", cloud, "-edges", "-surfaces", "-instances", "object")
    instances = result["instance"]
    iou = "–" if truth is None else f"{best_iou(instances, truth.ravel()):.3f}"
    print(f"| {name} | {share(result['surface'][is_table] == 2)} | {share(result['edge'][is_table] == 1)} | "
          f"{share(instances[is_table] > 0)} | {iou} |", flush=True)


def image_table(apps, clones):
    print("### Tables of other people's images\n")
    print("| image | table called curved | edge | in an object | IoU of the object |")
    print("|---|---|---|---|---|")
    for repository, images in IMAGES.items():
        if (clones / repository).is_dir():
            for name, points, truth in images(clones / repository):
                image_row(apps, name, points, truth)
    print()


def kinect_table(apps, folder):
    """Rules were chosen on scenes with even numbers."""
    print("### All scenes of the modified Object Segmentation Database\n")
    print("| scenes | overlap P | R | F | found at IoU .7 | table in an object, at most |")
    print("|---|---|---|---|---|---|")
    scores = {"even": [], "odd": []}
    for cloud in sorted(folder.rglob("*.pcd")):
        number = re.fullmatch(r"(?:learn|test)(\d+)", cloud.stem)
        if not number:
            continue
        result = run(apps, "pcl_shape_instances", cloud, "-class", "object")
        is_finite = numpy.isfinite(result["x"]) & (result["z"] > 0)
        label, instances = result["label"].astype(int)[is_finite], result["instance"].astype(int)[is_finite]
        score = object_score(numpy.where(label >= 10, label // 10, 0), instances)
        scores[("even", "odd")[int(number.group(1)) % 2]].append((*score, (instances[label == 1] > 0).mean()))
    for name, of_scenes in scores.items():
        means, sums = numpy.mean(of_scenes, 0), numpy.sum(of_scenes, 0)
        print(f"| {len(of_scenes)} {name} | " + " | ".join(f"{s:.3f}" for s in means[:3]) +
              f" | {int(sums[3])} of {int(sums[4])} | {numpy.max(of_scenes, 0)[5]:.3f} |")
    print()


def main():
    if len(sys.argv) != 3:
        sys.exit("usage: scripts/evaluate/evaluate_public.py BUILD_DIR CLONES_DIR")
    apps, clones = pathlib.Path(sys.argv[1]) / "apps", pathlib.Path(sys.argv[2])
    kinect = clones / "data/segmentation/mOSD"
    if not kinect.is_dir() and not any((clones / name).is_dir() for name in IMAGES):
        sys.exit(f"{clones}: it must have clones named {', '.join(IMAGES)} or data")
    if any((clones / name).is_dir() for name in IMAGES):
        image_table(apps, clones)
    if kinect.is_dir():
        kinect_table(apps, kinect)


if __name__ == "__main__":
    main()
