#!/usr/bin/env python3
"""Compare what two builds of the applications compute, bit by bit.

Usage: scripts/compare_results.py OLD NEW [-data DIR] [-targets T,T] [-only REGEX] [-keep DIR] [-jobs N]
OLD and NEW are directories of applications, as build/apps. Every application runs with a table of options on
scenes that OLD generates, and on the clouds of DIR, for each instruction set of this machine. Point clouds are
compared field by field, JSON files without times, other files byte by byte. One line a comparison; the exit
status is 1 if anything differs. With -keep what OLD computed stays in DIR, and is not computed again.
"""
import argparse
import concurrent.futures
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile
import time

from pcd_fields import pcd_difference

# Scenes: name, kind, options of pcl_shape_scene. Those of the kind "other" are only generated, by both builds.
SCENES = [
    ("seed1", "table", "-seed 1 -width 320 -height 240"),
    ("seed2-exact", "table", "-seed 2 -width 320 -height 240 -noise none -normals -faces"),
    ("seed3-organized", "table", "-seed 3 -width 240 -height 180 -noise 0.002 -organized"),
    ("seed4-sampled", "table", "-seed 4 -sampling 0.006 -noise 0.0005"),
    ("street16", "street", "-sensor lidar -beams 16 -seed 1"),
    ("street64", "street", "-sensor lidar -beams 64 -seed 2 -noise none"),
    ("large", "dense", "-seed 5 -width 960 -height 720"),
]
SCENES += [(f"table{seed}", "other", f"-seed {seed} -width 160 -height 120 -normals -faces") for seed in range(6, 26)]
SCENES += [(f"turn{turn}", "other", f"-turn {turn} -width 160 -height 120 -organized") for turn in (-90, 20, 180)]
SCENES += [(shape, "other", f"-shapes {shape} -objects 12 -width 160 -height 120 -noise none")
           for shape in ("box", "cylinder", "sphere", "bowl", "cone", "bowl,box")]
SCENES += [(f"sampled{seed}", "other", f"-seed {seed} -sampling 0.01 -normals -faces") for seed in range(1, 9)]
SCENES += [(f"street{seed}-{noise}", "other", f"-sensor lidar -beams 16 -seed {seed} -noise {noise} -normals")
           for seed in range(3, 9) for noise in ("lidar", "0.01")]
SCENES += [("empty", "other", "-objects 0 -format ascii"), ("full", "other", "-objects 30 -seed 9 -format binary")]

# Cases: kinds of scenes, name, and commands that run one after another on in.pcd ("shape_" may be left out).
EVALUATE = "; evaluate out.pcd in.pcd -out outcome.pcd -task "
CASES = [
    ("table dense street", "edges", "edge_detection in.pcd out.pcd"),
    ("table", "edges-scores", "edge_detection in.pcd out.pcd -normals -threshold 0.4" + EVALUATE + "edge"),
    ("table dense street", "edge-lines", "edge_detection in.pcd out.pcd -types -lines lines.json"),
    ("table dense", "edges-coarse", "edge_detection in.pcd out.pcd -types -lines lines.json -resolution 0.006"),
    ("table", "edges-paper", "edge_detection in.pcd out.pcd -mode paper" + EVALUATE + "edge -convention paper"),
    ("table", "edges-paper-bins", "edge_detection in.pcd out.pcd -mode paper -bins 20 -format ascii"),
    ("table", "edges-paper-k", "edge_detection in.pcd out.pcd -mode paper -k 20 -outlier_rate 0 -format binary"),
    ("table", "edges-paper-radii", "edge_detection in.pcd out.pcd -mode paper -radius 0.02 -normal_radius 0.015"),
    ("table", "edges-paper-depth", "edge_detection in.pcd out.pcd -mode paper -radius 0.02 -scale depth"),
    ("table dense street", "surfaces", "back_projection in.pcd out.pcd -normals" + EVALUATE + "curved"),
    ("table dense", "surfaces-coarse", "back_projection in.pcd out.pcd -resolution 0.006" + EVALUATE + "planar"),
    ("table", "surfaces-paper", "back_projection in.pcd out.pcd -mode paper -radius 0.02" + EVALUATE + "planar"),
    ("table", "models", "histogram in.pcd model.json -radius 0.02 -field surface -classes flat=1,round=2:0.5; "
     "histogram in.pcd model.json -radius 0.02 -field surface -value 3 -name crease; "
     "back_projection in.pcd out.pcd -mode paper -model model.json; "
     "histogram in.pcd flat.json -radius 0.02 -field surface -value 1; edge_detection in.pcd edges.pcd -mode paper -model flat.json"),
    ("table", "density-model", "histogram in.pcd model.json -radius 4 -normal_radius 3 -scale density -field surface "
     "-classes planar=1,curved=2 -smoothing 1 -floor 0.1; back_projection in.pcd out.pcd -model model.json; "
     "instances in.pcd instances.pcd -model model.json -class curved"),
    ("table dense", "curved", "instances in.pcd out.pcd -primitive auto" + EVALUATE + "instance"),
    ("table", "planar", "instances in.pcd out.pcd -class planar -primitive plane -min_points 50 -high 0.7 -low 0.4"),
    ("table dense", "objects", "instances in.pcd out.pcd -class object -primitive auto" + EVALUATE + "instance"),
    ("table dense", "objects-coarse", "instances in.pcd out.pcd -class object -primitive auto -resolution 0.006"),
    ("table", "grasps", "grasp in.pcd; grasp in.pcd -surface curved -cup_radius 0.006 -compliance 0.4 -max_grasps 5"),
    ("table", "grasps-of", "grasp in.pcd -field instance -value 1 -surface planar; "
     "grasp in.pcd -box -0.2,-0.3,0.3,0.2,0.3,1.5 -viewpoint 0,0.1,0 -resolution 0.004"),
    ("table dense street", "labels", "label in.pcd out.pcd -confidence 0.8" + EVALUATE + "label"),
    ("table", "labels-coarse", "label in.pcd out.pcd -resolution 0.006; label in.pcd out.ply -format ply"),
    ("street", "ground", "ground in.pcd out.pcd; ground in.pcd steep.pcd -max_slope 10 -max_step 0.1 -threshold 0.7 "
     "-up 0,0.05,1" + EVALUATE + "ground"),
    ("table", "inad", "inad_estimation in.pcd out.pcd -radius 0.02 -normals; "
     "inad_estimation in.pcd k.pcd -k 15 -outlier_rate 0; "
     "inad_estimation out.pcd given.pcd -radius 0.03 -use_normals; "
     "inad_estimation in.pcd density.pcd -radius 4 -normal_radius 3 -scale density"),
    ("table street", "picture", "viewer in.pcd -screenshot picture.png -size 320x240"),
]
# Clouds of -data: these cases of tables.
REAL_CASES = ("edge-lines edges-coarse edges-paper edges-paper-k surfaces surfaces-paper curved planar objects "
              "objects-coarse grasps labels inad").split()
# Words of OLD's command lines and results that NEW spells otherwise.
NEW_OPTIONS = {}
NEW_NAMES = {}

# Makes an application use the target COMPARE_TARGET of the library, or list them.
CHOOSER = """
#include <cstdio>
#include <cstdlib>
#include <string>
#include <vector>
namespace pcl::kernels {
__attribute__((weak)) void chooseTarget(const std::string&);
__attribute__((weak)) std::vector<std::string> availableTargets();
}
__attribute__((constructor)) static void choose() {
  const char* const name = std::getenv("COMPARE_TARGET");
  if (!pcl::kernels::chooseTarget) // an application without the engine
    return;
  if (*name)
    return pcl::kernels::chooseTarget(name);
  for (const std::string& target : pcl::kernels::availableTargets())
    std::puts(target.c_str());
  std::fflush(stdout);
  std::_Exit(0);
}
"""


def without_times(value):
    """A JSON value with NEW's names, without what differs from run to run."""
    if isinstance(value, dict):
        return {NEW_NAMES.get(key, key): without_times(inner) for key, inner in value.items()
                if key not in ("times_ms", "version", "software")}
    if isinstance(value, list):
        return [without_times(inner) for inner in value]
    return NEW_NAMES.get(value, value) if isinstance(value, str) else value


def json_difference(old, new, place=""):
    """Where two JSON values differ, or None."""
    pairs = []
    if isinstance(old, dict) and isinstance(new, dict) and old.keys() == new.keys():
        pairs = [(old[key], new[key], f"{place}/{key}") for key in old]
    elif isinstance(old, list) and isinstance(new, list) and len(old) == len(new):
        pairs = [(a, b, f"{place}/{i}") for i, (a, b) in enumerate(zip(old, new))]
    elif old != new:
        return f"{place}: {str(old)[:80]} | {str(new)[:80]}"
    return next(filter(None, (json_difference(*pair) for pair in pairs)), None)


def difference(old, new):
    """What differs between the files of two directories, or None."""
    names, others = (sorted(path.name for path in side.iterdir() if not path.is_symlink()) for side in (old, new))
    if names != others:
        return f"files {names} | {others}"
    for name in names:
        a, b = old / name, new / name
        if name.endswith(".pcd"):
            found = pcd_difference(a, b, NEW_NAMES)
        elif name.endswith(".json"):
            found = json_difference(*(without_times(json.loads(path.read_text(), parse_float=str)) for path in (a, b)))
        else:
            found = None if a.read_bytes() == b.read_bytes() else "bytes"
        if found:
            return f"{name}: {found}"
    return None


def run(apps, commands, scene, directory, environment):
    """Run the commands in a directory of their own; the exit statuses are a file there."""
    shutil.rmtree(directory, ignore_errors=True)
    directory.mkdir(parents=True)
    if scene:
        (directory / "in.pcd").symlink_to(scene)
    statuses = ""
    for number, command in enumerate(commands.split(";")):
        name, *options = command.split()
        app = next(path for path in (apps / f"pcl_{name}", apps / f"pcl_shape_{name}") if path.exists())
        words = [app, *options, "-threads", "1", "-json", f"{number}.json"]
        if name == "viewer":
            words = ["xvfb-run", "-a", *words]
        done = subprocess.run(words, cwd=directory, env=environment, capture_output=True, text=True)
        statuses += f"{name}: {done.returncode}\n"
    (directory / "statuses").write_text(statuses)


def jobs_of(arguments, work, targets):
    """Target, scene, case, commands and input of every comparison; OLD makes the scenes."""
    for name, _, options in SCENES:
        yield "any", name, "scene", f"scene out.pcd {options}", None
    inputs = []
    for name, kind, options in SCENES:
        if kind != "other":
            run(arguments.old, f"scene out.pcd {options}", None, work / "scenes" / name, None)
            inputs.append((name, kind, work / "scenes" / name / "out.pcd"))
    for path in sorted(arguments.data.rglob("*.pcd")) if arguments.data else []:
        inputs.append((str(path.relative_to(arguments.data).with_suffix("")), "real", path.resolve()))
    for target in targets:
        for scene, kind, path in inputs:
            for kinds, case, commands in CASES:
                fits = case in REAL_CASES if kind == "real" else kind in kinds.split()
                if fits and (case != "picture" or (target == targets[0] and shutil.which("xvfb-run"))):
                    yield target, scene, case, commands, path


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    for side in ("old", "new"):
        parser.add_argument(side, type=lambda text: pathlib.Path(text).resolve())
    parser.add_argument("-data", type=pathlib.Path)
    parser.add_argument("-targets", help="as avx2,portable: not all of this machine's")
    parser.add_argument("-only", default="", help="comparisons whose line has this regular expression")
    parser.add_argument("-keep", type=pathlib.Path, help="for what OLD computed, and what differs")
    parser.add_argument("-jobs", type=int, default=os.cpu_count())
    arguments = parser.parse_args()
    temporary = tempfile.TemporaryDirectory()
    work = (arguments.keep or pathlib.Path(temporary.name)).resolve()
    work.mkdir(parents=True, exist_ok=True)
    library = work / "chooser.so"
    subprocess.run(["g++", "-shared", "-fPIC", "-xc++", "-", "-o", library], check=True, input=CHOOSER.encode())
    environment = {**os.environ, "LD_PRELOAD": str(library), "COMPARE_TARGET": ""}
    found = [subprocess.check_output([apps / "pcl_shape_edge_detection"], env=environment).decode().split()
             for apps in (arguments.old, arguments.new)]
    if found[0] != found[1]:
        sys.exit(f"compare_results.py: instruction sets {found[0]} | {found[1]}")
    targets = arguments.targets.split(",") if arguments.targets else found[0]

    def compare(job):
        target, scene, case, commands, cloud = job
        old, new = (work / side / target / scene / case for side in ("old", "new"))
        chosen = {**environment, "COMPARE_TARGET": target} if cloud else None
        if not (old / "statuses").exists():
            run(arguments.old, commands, cloud, old, chosen)
        run(arguments.new, " ".join(NEW_OPTIONS.get(word, word) for word in commands.split(" ")), cloud, new, chosen)
        found = difference(old, new)
        refused = "" if "1\n" not in (old / "statuses").read_text() else " (refused)"
        if not found:
            shutil.rmtree(new)
        return found, f"{target} {scene} {case}{refused}"

    begin = time.monotonic()
    jobs = [job for job in jobs_of(arguments, work, targets) if re.search(arguments.only, " ".join(job[:3]))]
    different = 0
    with concurrent.futures.ThreadPoolExecutor(arguments.jobs) as pool:
        for found, line in pool.map(compare, jobs):
            print(f"DIFFERENT {line}: {found}" if found else f"same {line}", flush=True)
            different += found is not None
    print(f"{len(jobs)} comparisons, {different} different, {time.monotonic() - begin:.0f} s")
    sys.exit(different > 0)


if __name__ == "__main__":
    main()
