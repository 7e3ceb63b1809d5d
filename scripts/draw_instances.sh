#!/usr/bin/env bash
# Draw doc/tutorials/content/images/shape_instances.png: a generated scene, its curved instances, its objects.
# Usage: scripts/draw_instances.sh BUILD_DIR [out.png]. Needs python3-matplotlib.
set -euo pipefail
build=${1:?usage: scripts/draw_instances.sh BUILD_DIR [out.png]}
scripts=$(dirname "${BASH_SOURCE[0]}")
picture=${2:-$scripts/../doc/tutorials/content/images/shape_instances.png}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build"/apps/pcl_shape_scene "$work/scene.pcd" -seed 7 -objects 9 -shapes cylinder,box,sphere -organized \
  -normals -format ascii
for class in curved object; do
  "$build"/apps/pcl_shape_instances "$work/scene.pcd" "$work/$class.pcd" -class "$class" -format ascii
done
python3 "$scripts/draw_instances.py" "$work/scene.pcd" "$work/curved.pcd" "$work/object.pcd" "$picture"
