#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Make the table of suction grasps on real objects in doc/grasps.md: no options but the cup's radius.
Markdown goes to standard output. Objects are those of the truth, by label; whether one has a face for the cup is judged
here, by fits of its own to the labeled points.
Usage: scripts/evaluate_grasps.py BUILD_DIR DATA_DIR [CUP_RADIUS]
DATA_DIR is that of scripts/evaluate_sensors.py. Needs python3-numpy and python3-scipy.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from scipy.spatial import cKDTree

from evaluate_sensors import MIN_OBJECT, fields_of, write_pcd

COMPLIANCE = 0.2  # of the app, in cup radii
FACE = 2 ** 0.5  # radius of a disc of twice the cup's area, in cup radii
SECTORS = 12  # of a ring, which must all have points where a face goes on
MAX_RESIDUAL = 0.15  # in cup radii: 1.5 mm for a cup of 10 mm, the noise of a Kinect at 1 m
MAX_ANGLE = 5.0  # degrees


def quadric(tree, center, radius):
    """The frame, the curvatures and the r.m.s. residual of a quadric over the points within 1.5 cup radii of a center; the
    normal is that of their plane: the noise of a Kinect at 1 m turns planes of smaller discs by degrees. None where
    there are too few points."""
    near = tree.data[tree.query_ball_point(center, 1.5 * radius)]
    if len(near) < 20:
        return None
    offsets = near - center
    axes = numpy.linalg.svd(offsets - offsets.mean(0), full_matrices=False)[2]
    local = offsets @ axes.T
    x, y = local[:, 0], local[:, 1]
    terms = numpy.stack([numpy.ones(len(x)), x, y, x * x, x * y, y * y], 1)
    values = numpy.linalg.lstsq(terms, local[:, 2], rcond=None)[0]
    residual = numpy.sqrt(numpy.mean((terms @ values - local[:, 2]) ** 2))
    curvatures = numpy.linalg.eigvalsh([[2 * values[3], values[4]], [values[4], 2 * values[5]]])
    return axes, curvatures, residual


def is_covered(tree, center, axes, radius):
    """Whether the disc has points in all sectors of its outer ring and of its middle."""
    local = (tree.data[tree.query_ball_point(center, 1.2 * radius)] - center) @ axes.T
    distance = numpy.hypot(local[:, 0], local[:, 1])
    turn = numpy.arctan2(local[:, 1], local[:, 0]) / (2 * numpy.pi)
    sector = numpy.floor(turn * SECTORS).astype(int) % SECTORS
    return all(len(set(sector[(distance > low * radius) & (distance < high * radius)])) == SECTORS
               for low, high in ((0.85, 1.1), (0.4, 0.7)))


def has_face(tree, radius):
    """Whether a disc of twice the cup's area lies on the object, no more bent than the cup allows."""
    for center in tree.data[::20]:
        fit = quadric(tree, center, radius)
        if fit is None:
            continue
        axes, (low, high), residual = fit
        sag = max(abs(low), abs(high), high - low) * radius ** 2 / 2
        if (sag <= COMPLIANCE * radius and residual <= MAX_RESIDUAL * radius and
                is_covered(tree, center, axes, FACE * radius)):
            return True
    return False


def first_grasp(apps, cloud, radius):
    """The best grasp on the points with target 1, or None."""
    with tempfile.TemporaryDirectory() as directory:
        out = pathlib.Path(directory) / "grasps.json"
        subprocess.run([apps / "pcl_shape_grasp", cloud, "-field", "target", "-value", "1", "-cup_radius", str(radius),
                        "-max_grasps", "1", "-json", out], check=True, stdout=subprocess.DEVNULL)
        grasps = json.loads(out.read_text())["grasps"]
        return grasps[0] if grasps else None


def judged(grasp, points, tree, target, radius):
    """Whether the grasp seals, is on the target, and its angle to the normal of the target there, degrees."""
    if grasp is None or not grasp["seals"]:
        return False, False, numpy.nan
    position = numpy.array(grasp["position"])
    is_on = bool(target[cKDTree(points).query(position)[1]])
    fit = quadric(tree, position, radius)
    if fit is None:
        return True, is_on, numpy.nan
    cosine = abs(fit[0][2] @ numpy.array(grasp["approach"]))
    return True, is_on, numpy.degrees(numpy.arccos(min(1.0, cosine)))


def rows_of(apps, cloud, parts, radius):
    fields = fields_of(cloud)
    finite = numpy.isfinite(fields["x"])
    points = numpy.stack([fields[axis][finite] for axis in "xyz"], 1).astype(float)
    labels = fields["label"][finite].astype(int) // parts
    for label in numpy.unique(labels[labels > 0]):
        target = labels == label
        if numpy.count_nonzero(target) < MIN_OBJECT:
            continue
        tree = cKDTree(points[target])
        with tempfile.TemporaryDirectory() as directory:
            one = pathlib.Path(directory) / "one.pcd"
            write_pcd(one, {**{axis: fields[axis][finite] for axis in "xyz"}, "target": target.astype(numpy.uint32)})
            grasp = first_grasp(apps, one, radius)
        yield label, has_face(tree, radius), grasp, *judged(grasp, points, tree, target, radius)


def main():
    if len(sys.argv) not in (3, 4):
        sys.exit("usage: scripts/evaluate_grasps.py BUILD_DIR DATA_DIR [CUP_RADIUS]")
    apps, data = pathlib.Path(sys.argv[1]) / "apps", pathlib.Path(sys.argv[2])
    radius = float(sys.argv[3]) if len(sys.argv) == 4 else 0.01
    clouds = [(cloud, 10) for cloud in [*data.glob("osd/learn*.pcd"), *data.glob("osd/objects/learn*.pcd")]
              if cloud.stem[len("learn"):].isdigit()]
    clouds.sort(key=lambda item: int(item[0].stem[len("learn"):]))
    clouds += [(cloud, 1) for cloud in sorted(data.glob("rgbd/*.pcd")) if "label" in fields_of(cloud)]
    print("| cloud | object | has a face for the cup | first grasp | on the object | off its normal |")
    print("|---|---|---|---|---|---|")
    with_face = right = 0
    for cloud, parts in clouds:
        for label, face, grasp, seals, is_on, angle in rows_of(apps, cloud, parts, radius):
            leak = "no grasp" if grasp is None else "leaks: " + ", ".join(grasp["problems"])
            with_face += face
            right += face and seals and is_on and angle <= MAX_ANGLE
            print(f"| {cloud.stem} | {label} | {'yes' if face else 'no'} | {'seals' if seals else leak} | "
                  f"{('yes' if is_on else 'no') if seals else '–'} | {f'{angle:.1f}°' if seals else '–'} |", flush=True)
    print(f"\nOf {with_face} objects with a face for the cup, {right} have a first grasp that seals, on the object and "
          f"within {MAX_ANGLE:.0f}° of its normal.")


if __name__ == "__main__":
    main()
