#!/usr/bin/env bash
# Draw the picture of the tutorial about ground: a generated street, its ground, from above.
# Usage: scripts/draw_ground.sh BUILD_DIR [seed] [out.png]
set -euo pipefail
build=${1:?usage: scripts/draw_ground.sh BUILD_DIR [seed] [out.png]}
seed=${2:-1}
scripts=$(dirname "${BASH_SOURCE[0]}")
picture=${3:-$scripts/../doc/tutorials/content/images/shape_ground_segmentation.png}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
for beams in 64 16; do
  "$build"/apps/pcl_shape_scene "$work/street.pcd" -sensor lidar -beams $beams -seed "$seed"
  "$build"/apps/pcl_shape_ground "$work/street.pcd" "$work/$beams.pcd" -format ascii
done
"${PYTHON:-python3}" "$scripts/draw_ground.py" "$work/64.pcd" "$work/16.pcd" "$picture"
