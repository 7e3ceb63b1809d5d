#!/usr/bin/env python3
"""Draw the first grasp of every labeled object on the images of each data set, a sheet for each.
Usage: scripts/draw/draw_object_grasps.py BUILD_DIR DATA_DIR|-generated OUT_DIR [CUP_RADIUS]
DATA_DIR is that of scripts/evaluate/evaluate_sensors.py; generated scenes are drawn in any case. A cup that seals is green, one that
leaks red. Needs xvfb-run without a display, python3-numpy, python3-scipy and python3-pil.
"""
import math
import os
import pathlib
import subprocess
import sys
import tempfile

import numpy

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent / "evaluate"))

from contact_sheet import main as make_sheet  # noqa: E402
from evaluate_grasps import GENERATED, grasps_of, real_clouds  # noqa: E402
from evaluate_sensors import fields_of, generate  # noqa: E402


def camera_of(points):
    """From the sensor; the points fill an image of 4:3."""
    seen = points[:, :2] / points[:, 2:]
    low, high = seen.min(0), seen.max(0)
    half = max(high[1] - low[1], 0.75 * (high[0] - low[0])) / 2
    x, y = (low + high) / 2
    return f"0,0,0,{x:g},{y:g},1,0,-1,0,{2 * math.degrees(math.atan(1.15 * half)):g}"


def draw(apps, cloud, field, parts, radius, picture):
    work = picture.parent
    grasps_of(apps, cloud, field, parts, radius, work / "grasps.json")
    subprocess.run([apps / "pcl_shape_edge_detection", cloud, work / "drawn.pcd", "-normals"], check=True,
                   stdout=subprocess.DEVNULL)
    fields = fields_of(work / "drawn.pcd")
    points = numpy.stack([fields[axis] for axis in "xyz"], axis=1)
    on_objects = (fields[field] >= max(parts, 1)) & numpy.isfinite(points).all(axis=1)
    subprocess.run([apps / "pcl_shape_viewer", work / "drawn.pcd", "-field", field, "-shade", "-grasps", work / "grasps.json",
                    "-camera", camera_of(points[on_objects]), "-size", "640x480", "-screenshot", picture], check=True,
                   stdout=subprocess.DEVNULL)


def main():
    if len(sys.argv) not in (4, 5):
        sys.exit("usage: scripts/draw/draw_object_grasps.py BUILD_DIR DATA_DIR|-generated OUT_DIR [CUP_RADIUS]")
    if not os.environ.get("DISPLAY"):
        os.execvp("xvfb-run", ["xvfb-run", "-a", "-s", "-screen 0 1280x1024x24 -noreset", sys.executable, *sys.argv])
    apps, out = pathlib.Path(sys.argv[1]) / "apps", pathlib.Path(sys.argv[3])
    radius = float(sys.argv[4]) if len(sys.argv) == 5 else 0.01
    out.mkdir(parents=True, exist_ok=True)
    sheets = {}
    with tempfile.TemporaryDirectory() as directory:
        work = pathlib.Path(directory)

        def add(data_set, name, cloud, field, parts):
            entries = sheets.setdefault(data_set, [])
            picture = work / f"{len(sheets)}_{len(entries)}.png"
            draw(apps, cloud, field, parts, radius, picture)
            entries.append(f"{name}={picture}")

        if sys.argv[2] != "-generated":
            for data_set, name, cloud, parts in real_clouds(pathlib.Path(sys.argv[2])):
                add(data_set, name, cloud, "label", parts)
        for name, seed, options in GENERATED:
            generate(apps, work / "scene.pcd", seed, options)
            add("generated", name, work / "scene.pcd", "instance", 1)
        for data_set, entries in sheets.items():
            make_sheet(out / f"grasps_{data_set.replace('/', '_')}.png", 3, 320, 64, *entries)


if __name__ == "__main__":
    main()
