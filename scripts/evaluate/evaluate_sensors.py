#!/usr/bin/env python3
"""Make the tables of machined parts, of other depth cameras, of whole objects and of generated parts and sensors in
doc/evaluation.md: no options.
Markdown goes to standard output. Beside it, as a peer, the surface variation of the k nearest points with one threshold for each part,
the best for the other parts.
Usage: scripts/evaluate/evaluate_sensors.py BUILD_DIR DATA_DIR
       scripts/evaluate/evaluate_sensors.py BUILD_DIR -generated [GENERATOR_BUILD_DIR]   # the last table only, without data
DATA_DIR/parts has PART_SAMPLING.pcd with edge, crease_s, surface, radius_s, thin_s; DATA_DIR/rgbd clouds with table and
perhaps label, DATA_DIR/osd and osd/objects learnN.pcd with labels of parts, ten to an object (doc/evaluation.md says
what these are). Needs python3-numpy and python3-scipy.
"""
import json
import pathlib
import subprocess
import sys
import tempfile

import numpy
from scipy.optimize import linear_sum_assignment
from scipy.spatial import cKDTree

sys.path.insert(0, str(pathlib.Path(__file__).resolve().parent.parent))

from pcd_fields import CODES, read_pcd  # noqa: E402

SAMPLINGS = {"pds0": "even", "pds15": "even, .15 s", "pds40": "even, .40 s", "rnd15": "random, .15 s"}
MIN_OBJECT = 300  # points; smaller ones do not count
BESIDE_CREASE = 4  # spacings; the given parts have no class there
NEAREST = 24  # the peer's neighbors: about as many as the default mode's normals see without noise


def fields_of(path):
    lines, columns = read_pcd(path)
    kinds = dict(zip(lines["FIELDS"].split(), zip(lines["TYPE"].split(), map(int, lines["SIZE"].split()))))
    return {name: numpy.frombuffer(data, "<" + CODES[kinds[name]]) for name, data in columns.items()}


def write_pcd(path, fields, shape=None):
    """Binary: floats, and unsigned labels. Unorganized without rows and columns."""
    kinds = {name: "F" if values.dtype.kind == "f" else "U" for name, values in fields.items()}
    rows = numpy.rec.fromarrays([values.astype("<f4" if kinds[name] == "F" else "<u4")
                                 for name, values in fields.items()])
    size = len(rows)
    height, width = shape or (1, size)
    header = "\n".join(["VERSION 0.7", "FIELDS " + " ".join(fields), "SIZE" + " 4" * len(fields),
                        "TYPE " + " ".join(kinds.values()), "COUNT" + " 1" * len(fields), f"WIDTH {width}", f"HEIGHT {height}",
                        "VIEWPOINT 0 0 0 1 0 0 0", f"POINTS {size}", "DATA binary\n"])
    path.write_bytes(header.encode() + rows.tobytes())


def run(apps, app, cloud, *options):
    """The fields of the output, among them those of the input."""
    with tempfile.TemporaryDirectory() as directory:
        out = pathlib.Path(directory) / "out.pcd"
        subprocess.run([apps / app, cloud, out, "-format", "binary", *options], check=True, stdout=subprocess.DEVNULL)
        return fields_of(out)


def report(apps, app, *words):
    """What it writes with -json."""
    with tempfile.TemporaryDirectory() as directory:
        path = pathlib.Path(directory) / "report.json"
        subprocess.run([apps / app, *words, "-json", path], check=True, stdout=subprocess.DEVNULL)
        return json.loads(path.read_text())


def f1(found, truth):
    both = numpy.count_nonzero(found & truth)
    return 2 * both / max(1, numpy.count_nonzero(found) + numpy.count_nonzero(truth))


def edge_points(part):
    """Those that count: no thin walls, no sharp curves that are not creases."""
    is_curve = (part["radius_s"] < 10) & (part["crease_s"] > 3)
    return (part["edge"] != 255) & (part["thin_s"] > 4) & ~is_curve


def surface_points(part):
    is_curved = part["surface"] == 2
    is_measured = (part["radius_s"] >= 10) & (part["radius_s"] <= 40)
    return (part["surface"] > 0) & (part["thin_s"] > 4) & (~is_curved | is_measured)


def class_score(part):
    """The mean F1 of planar and curved, of those that the part has."""
    counts = surface_points(part)
    truth = numpy.digitize(part["surface"], [1, 2])
    scores = []
    for number in (1, 2):
        of_class = truth[counts] == number
        if numpy.count_nonzero(of_class) > 500:
            scores.append(f1(part["found_surface"][counts] == number, of_class))
    return numpy.mean(scores)


def variation(part):
    points = numpy.stack([part[axis] for axis in "xyz"], axis=1).astype(float)
    near = points[cKDTree(points).query(points, NEAREST)[1]]
    near -= near.mean(axis=1, keepdims=True)
    values = numpy.linalg.eigvalsh(numpy.einsum("nki,nkj->nij", near, near))
    return values[:, 0] / values.sum(axis=1)


def peer_scores(parts):
    """F1 of each part at the threshold that is best for the others."""
    thresholds = numpy.geomspace(1e-4, 0.2, 60)
    table = []
    for part in parts.values():
        counts = edge_points(part)
        values = variation(part)[counts]
        table.append([f1(values > t, part["edge"][counts] == 1) for t in thresholds])
    table = numpy.array(table)
    return [table[i][numpy.argmax(numpy.delete(table, i, 0).mean(0))] for i in range(len(table))]


def part_tables(apps, folder):
    names = sorted(path.name[:-len("_pds0.pcd")] for path in folder.glob("*_pds0.pcd"))
    rows = {"edge F1": {}, "surface variation, edge F1": {}, "planar and curved F1": {}}
    for sampling, title in SAMPLINGS.items():
        parts = {}
        for name in names:
            cloud = folder / f"{name}_{sampling}.pcd"
            parts[name] = run(apps, "pcl_shape_edge_detection", cloud)
            # The output's field replaces the truth of the same name.
            parts[name]["found_edge"] = parts[name]["edge"]
            parts[name]["found_surface"] = run(apps, "pcl_shape_back_projection", cloud)["surface"]
            truth = fields_of(cloud)
            parts[name].update({field: truth[field] for field in ("edge", "surface")})
        rows["edge F1"][title] = [f1(part["found_edge"][edge_points(part)] == 1, part["edge"][edge_points(part)] == 1)
                                  for part in parts.values()]
        rows["surface variation, edge F1"][title] = peer_scores(parts)
        rows["planar and curved F1"][title] = [class_score(part) for part in parts.values()]
    print("### Machined parts\n")
    for what, by_sampling in rows.items():
        print("| " + " | ".join([what, *names, "mean"]) + " |")
        print("|---" * (len(names) + 2) + "|")
        for title, scores in by_sampling.items():
            print("| " + " | ".join([title, *(f"{score:.3f}" for score in (*scores, numpy.mean(scores)))]) + " |")
        print()


def share(values):
    return f"{values.mean():.4f}"


def table_tables(apps, folder):
    print("### Tables of other depth cameras\n")
    print("| cloud | table called curved | edge | in an object | IoU of the object |")
    print("|---|---|---|---|---|")
    for cloud in sorted(folder.glob("*.pcd")):
        surfaces = run(apps, "pcl_shape_back_projection", cloud)
        table = surfaces["table"] == 1
        edges = run(apps, "pcl_shape_edge_detection", cloud)["edge"]
        instances = run(apps, "pcl_shape_instances", cloud, "-class", "object")["instance"]
        iou = "–"
        if "label" in surfaces:
            truth = surfaces["label"] > 0
            iou = f"{best_iou(instances, truth):.3f}"
        print(f"| {cloud.stem} | {share(surfaces['surface'][table] == 2)} | {share(edges[table] == 1)} | "
              f"{share(instances[table] > 0)} | {iou} |")
    print()


def halves(path):
    """The points of each half of an organized cloud, and every second one."""
    lines, _ = read_pcd(path)
    rows, columns = int(lines["HEIGHT"]), int(lines["WIDTH"])
    of_image = numpy.arange(rows * columns).reshape(rows, columns)
    return {"left": of_image[:, :columns // 2], "right": of_image[:, columns // 2:], "top": of_image[:rows // 2],
            "bottom": of_image[rows // 2:], "every second point": of_image[:, ::2]}


def half_table(apps, folder):
    """Points without coordinates are left out: halves are clouds without a grid."""
    print("### Halves of these\n")
    print("| cloud | half | table in an object | IoU of the object |")
    print("|---|---|---|---|")
    for cloud in sorted(folder.glob("*.pcd")):
        fields = fields_of(cloud)
        for name, of_image in halves(cloud).items():
            points = of_image.ravel()[numpy.isfinite(fields["x"][of_image.ravel()])]
            if len(points) < MIN_OBJECT:
                continue  # nothing was measured there
            with tempfile.TemporaryDirectory() as directory:
                half = pathlib.Path(directory) / "half.pcd"
                write_pcd(half, {axis: fields[axis][points] for axis in "xyz"})
                instances = run(apps, "pcl_shape_instances", half, "-class", "object")["instance"]
            table = fields["table"][points] == 1
            truth = fields["label"][points] > 0 if "label" in fields else numpy.zeros(len(points), bool)
            iou = f"{best_iou(instances, truth):.3f}" if numpy.count_nonzero(truth) >= MIN_OBJECT else "–"
            in_object = share(instances[table] > 0) if table.any() else "–"
            print(f"| {cloud.stem} | {name} | {in_object} | {iou} |", flush=True)
    print()


def best_iou(instances, truth):
    return max((numpy.count_nonzero((instances == k) & truth) / numpy.count_nonzero((instances == k) | truth)
                for k in numpy.unique(instances[truth]) if k > 0), default=0.0)


def object_score(truth, found):
    """Overlap precision, recall and F over points, one instance for each object (Hungarian matching); how many objects
    are found with an IoU of .7, and how many there are."""
    objects = [k for k in numpy.unique(truth) if k > 0 and numpy.count_nonzero(truth == k) >= MIN_OBJECT]
    instances = [k for k in numpy.unique(found) if k > 0]
    both = numpy.array([[numpy.count_nonzero((truth == t) & (found == f)) for f in instances] for t in objects])
    sizes = numpy.array([numpy.count_nonzero(truth == t) for t in objects])
    found_sizes = numpy.array([numpy.count_nonzero(found == f) for f in instances])
    rows, columns = linear_sum_assignment(-both / (sizes[:, None] + found_sizes[None]))
    hits = both[rows, columns]
    precision, recall = hits.sum() / found_sizes.sum(), hits.sum() / sizes.sum()
    ious = hits / (sizes[rows] + found_sizes[columns] - hits)
    return precision, recall, 2 * precision * recall / (precision + recall), int((ious >= 0.7).sum()), len(objects)


def object_table(apps, folder):
    print("### Whole objects of labeled Kinect scenes\n")
    print("| cloud | overlap P | R | F | found at IoU .7 |")
    print("|---|---|---|---|---|")
    clouds = [path for path in (*folder.glob("learn*.pcd"), *folder.glob("objects/learn*.pcd"))
              if path.stem[len("learn"):].isdigit()]
    scores = []
    for cloud in sorted(clouds, key=lambda path: int(path.stem[len("learn"):])):
        result = run(apps, "pcl_shape_instances", cloud, "-class", "object")
        is_finite = numpy.isfinite(result["x"])
        label = result["label"].astype(int)
        truth = numpy.where(label >= 10, label // 10, 0)[is_finite]
        scores.append(object_score(truth, result["instance"][is_finite].astype(int)))
        print(f"| {cloud.stem} | " + " | ".join(f"{s:.3f}" for s in scores[-1][:3]) +
              f" | {scores[-1][3]} of {scores[-1][4]} |")
    means, sums = numpy.mean(scores, 0), numpy.sum(scores, 0)
    print("| mean | " + " | ".join(f"{s:.3f}" for s in means[:3]) + f" | {int(sums[3])} of {int(sums[4])} |\n")


def sampled_parts(spacing):
    """Title, options of pcl_shape_scene."""
    part = ("-place", "part", "-sensor", "samples", "-sampling", f"{spacing:g}")
    some, more = f"{0.15 * spacing:g}", f"{0.4 * spacing:g}"
    return {
        "part, even": part,
        "part, even, .15 s": (*part, "-noise", some),
        "part, even, .40 s": (*part, "-noise", more),
        "part, random, .15 s": (*part, "-noise", some, "-spread", "random"),
    }


GENERATED = {
    **sampled_parts(0.0007),  # their radii are 3 to 70 spacings
    "part, photogrammetry": ("-place", "part", "-sensor", "photogrammetry", "-sampling", "0.0007"),
    "room, one station": ("-place", "room", "-sensor", "station"),
    "room, three stations": ("-place", "room", "-sensor", "station", "-stations", "3", "-step", "0.5"),
    "house front, two stations": ("-place", "facade", "-sensor", "station", "-stations", "2", "-step", "0.25"),
    "table, stereo": ("-sensor", "stereo"),
    "table, stereo, 2 mm over 30 mm": ("-sensor", "stereo", "-waviness", "0.002,0.03"),
    "table, time of flight": ("-sensor", "tof"),
    "table, structured light": ("-sensor", "structured"),
    "parts on a table, stereo": ("-sensor", "stereo", "-place", "part"),
    "parts on a table, time of flight": ("-sensor", "tof", "-place", "part"),
    "parts on a table, structured light": ("-sensor", "structured", "-place", "part"),
}
SEEDS = (901, 902, 903)  # of no training or choosing


def generate(apps, cloud, seed, options):
    subprocess.run([apps / "pcl_shape_scene", cloud, "-seed", str(seed), "-format", "binary", *options],
                   check=True, stdout=subprocess.DEVNULL)


def generated_scores(apps, cloud):
    """Edge F1, planar F1, curved F1, share of planar called curved; NaN for what a cloud has less than 500 points of."""
    truth = fields_of(cloud)
    edge = run(apps, "pcl_shape_edge_detection", cloud)["edge"]
    surface = run(apps, "pcl_shape_back_projection", cloud)["surface"]
    is_part = "thin_s" in truth
    counts = edge_points(truth) if is_part else truth["edge"] != 255
    scores = [f1(edge[counts] == 1, truth["edge"][counts] == 1)]
    if is_part:
        counts = surface_points(truth) & (truth["crease_s"] > BESIDE_CREASE)
    else:
        counts = (truth["surface"] == 1) | (truth["surface"] == 2)
    for number in (1, 2):
        of_class = truth["surface"][counts] == number
        is_enough = numpy.count_nonzero(of_class) > 500
        scores.append(f1(surface[counts] == number, of_class) if is_enough else numpy.nan)
    planar = counts & (truth["surface"] == 1)
    scores.append((surface[planar] == 2).mean())
    return scores


def generated_table(apps, generator):
    print("### Generated parts and sensors\n")
    print("| what | edge F1 | planar F1 | curved F1 | planar called curved |")
    print("|---|---|---|---|---|")
    for title, options in GENERATED.items():
        scores = []
        for seed in SEEDS:
            with tempfile.TemporaryDirectory() as directory:
                cloud = pathlib.Path(directory) / "cloud.pcd"
                generate(generator, cloud, seed, options)
                scores.append(generated_scores(apps, cloud))
        print(f"| {title} | " + " | ".join(f"{mean:.3f}" for mean in numpy.nanmean(scores, 0)) + " |", flush=True)
    print()


def main():
    if len(sys.argv) not in (3, 4) or (len(sys.argv) == 4 and sys.argv[2] != "-generated"):
        sys.exit("usage: scripts/evaluate/evaluate_sensors.py BUILD_DIR DATA_DIR, or BUILD_DIR -generated [GENERATOR_BUILD_DIR]")
    apps = pathlib.Path(sys.argv[1]) / "apps"
    if sys.argv[2] == "-generated":
        return generated_table(apps, pathlib.Path(sys.argv[-1]) / "apps" if len(sys.argv) == 4 else apps)
    data = pathlib.Path(sys.argv[2])
    part_tables(apps, data / "parts")
    table_tables(apps, data / "rgbd")
    half_table(apps, data / "rgbd")
    object_table(apps, data / "osd")
    generated_table(apps, apps)


if __name__ == "__main__":
    main()
