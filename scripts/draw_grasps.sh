#!/usr/bin/env bash
# Draw doc/tutorials/content/images/suction_grasps.png: places for a suction cup on one object of a
# generated scene. PYTHON: one that has matplotlib (python3).
# Usage: scripts/draw_grasps.sh BUILD_DIR [seed] [instance] [out.png]
set -euo pipefail
build=${1:?usage: scripts/draw_grasps.sh BUILD_DIR [seed] [instance] [out.png]}
seed=${2:-5}
instance=${3:-2}
scripts=$(dirname "${BASH_SOURCE[0]}")
picture=${4:-$scripts/../doc/tutorials/content/images/suction_grasps.png}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build"/apps/pcl_shape_scene "$work/scene.pcd" -seed "$seed" -normals -format ascii
"$build"/apps/pcl_shape_grasp "$work/scene.pcd" -field instance -value "$instance" \
  -json "$work/grasps.json"
"${PYTHON:-python3}" "$scripts/draw_grasps.py" "$work/scene.pcd" "$instance" "$work/grasps.json" "$picture"
