#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
# SPDX-FileCopyrightText: 2026 pcl_shape contributors
"""Draw the first grasp of every labeled object on the images of each data set, a sheet for each.
Usage: scripts/draw_object_grasps.py BUILD_DIR DATA_DIR|-generated OUT_DIR [CUP_RADIUS]
DATA_DIR is that of scripts/evaluate_sensors.py; generated scenes are drawn in any case. A cup that seals is green, one that
leaks red; the line from its middle goes to where the cup comes from. Needs python3-numpy, python3-scipy and python3-pil.
"""
import pathlib
import sys
import tempfile

import numpy
from PIL import Image, ImageDraw

from contact_sheet import main as make_sheet
from cup_rim import rim
from evaluate_grasps import GENERATED, grasps_of, real_clouds
from evaluate_sensors import fields_of, generate
from pcd_fields import read_pcd

COLORS = numpy.array([[205, 205, 205], [114, 147, 203], [225, 151, 76], [132, 186, 91], [144, 103, 167], [171, 104, 87],
                      [204, 194, 16], [90, 180, 180], [215, 120, 160]])


def projection(points, pixels):
    """Focal length and middle of one axis of a pinhole camera, from points and the pixels that see them."""
    rows = numpy.stack([points, numpy.ones(len(points))], 1)
    return numpy.linalg.lstsq(rows, pixels, rcond=None)[0]


def shading(z, shape):
    """Brighter where the surface faces the camera: by the steps of the depth from pixel to pixel."""
    depth = z.reshape(shape)
    steps = numpy.hypot(*numpy.gradient(depth)) / depth * 600
    return numpy.nan_to_num(0.45 + 0.55 / numpy.sqrt(1.0 + steps ** 2), nan=0.0).reshape(-1, 1)


def draw(cloud, field, parts, grasps, radius, picture):
    fields = fields_of(cloud)
    header, _ = read_pcd(cloud)
    shape = int(header["HEIGHT"]), int(header["WIDTH"])
    x, y, z = (fields[axis].astype(float) for axis in "xyz")
    seen = numpy.isfinite(z) & (z > 0)
    objects = fields[field].astype(int) // parts
    ranks = numpy.where(objects > 0, 1 + objects % (len(COLORS) - 1), 0)
    image = numpy.where(seen[:, None], COLORS[ranks] * shading(z, shape), 30)
    image = Image.fromarray(image.reshape(*shape, 3).astype(numpy.uint8))
    v, u = numpy.divmod(numpy.arange(len(z)), shape[1])
    of_u, of_v = projection((x / z)[seen], u[seen]), projection((y / z)[seen], v[seen])
    canvas = ImageDraw.Draw(image)

    def place(p):
        return of_u[0] * p[0] / p[2] + of_u[1], of_v[0] * p[1] / p[2] + of_v[1]

    for grasp in grasps:
        color = (26, 150, 65) if grasp["seals"] else (215, 25, 28)
        canvas.line([place(p) for p in rim(grasp, radius)], fill=color, width=3)
        start = numpy.array(grasp["position"])
        canvas.line([place(start), place(start - 3 * radius * numpy.array(grasp["approach"]))], fill=color, width=3)
    on = numpy.nonzero((ranks > 0) & seen)[0]
    margin = 20
    image.crop((u[on].min() - margin, v[on].min() - margin, u[on].max() + margin, v[on].max() + margin)).save(picture)


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit("usage: scripts/draw_object_grasps.py BUILD_DIR DATA_DIR|-generated OUT_DIR [CUP_RADIUS]")
    apps, out = pathlib.Path(sys.argv[1]) / "apps", pathlib.Path(sys.argv[3])
    radius = float(sys.argv[4]) if len(sys.argv) == 5 else 0.01
    out.mkdir(parents=True, exist_ok=True)
    sheets = {}
    with tempfile.TemporaryDirectory() as directory:
        work = pathlib.Path(directory)

        def add(data_set, name, cloud, field, parts):
            picture = work / f"{len(sheets)}_{name.replace(' ', '_').replace(',', '')}.png"
            draw(cloud, field, parts, grasps_of(apps, cloud, field, parts, radius, work / "grasps.json"), radius, picture)
            sheets.setdefault(data_set, []).append(f"{name}={picture}")

        if sys.argv[2] != "-generated":
            for data_set, name, cloud, parts in real_clouds(pathlib.Path(sys.argv[2])):
                add(data_set, name, cloud, "label", parts)
        for name, seed, options in GENERATED:
            cloud = work / "scene.pcd"
            generate(apps, cloud, seed, (*options, "-organized"))
            add("generated", name, cloud, "instance", 1)
        for data_set, entries in sheets.items():
            make_sheet(out / f"grasps_{data_set.replace('/', '_')}.png", 3, 320, 64, *entries)


if __name__ == "__main__":
    main()
