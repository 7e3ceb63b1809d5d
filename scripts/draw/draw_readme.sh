#!/usr/bin/env bash
# Draw the pictures of README.md in doc/figures, from generated scenes: scene.png (a scene, its classes, its
# edges), lines.png (its creases as lines), heat_map.png (the histogram of its curved points).
# Usage: scripts/draw/draw_readme.sh BUILD_DIR [OUTPUT_DIR]
# Needs xvfb-run without a display, python3-matplotlib and python3-pil.
set -euo pipefail
[[ -n ${DISPLAY:-} ]] || exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$0" "$@"

apps=${1:?usage: scripts/draw/draw_readme.sh BUILD_DIR [OUTPUT_DIR]}/apps
here=$(dirname "${BASH_SOURCE[0]}")
figures=${2:-$here/../../doc/figures}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# The objects, without the borders of the table.
camera=0,0,0,-0.03,0.02,0.9,0,-1,0,31

"$apps"/pcl_shape_scene "$work/scene.pcd" -seed 2
"$apps"/pcl_shape_back_projection "$work/scene.pcd" "$work/surfaces.pcd"
"$apps"/pcl_shape_edge_detection "$work/surfaces.pcd" "$work/edges.pcd" -normals -lines "$work/lines.json"
"$apps"/pcl_shape_viewer "$work/edges.pcd" -field plain,surface,edge -shade -size 1440x400 \
  -camera $camera -screenshot "$work/scene.png"
"$apps"/pcl_shape_viewer "$work/edges.pcd" -field plain -shade -lines "$work/lines.json" -size 720x540 \
  -camera $camera -screenshot "$work/lines.png"
"$apps"/pcl_shape_histogram "$work/scene.pcd" "$work/model.json" -radius 0.025 -name curved \
  -field surface -value 2 -bins 60 -mu_range 45 -sigma_range 22.5
"${PYTHON:-python3}" "$here"/draw_histogram.py "$work/model.json" "$work/heat_map.png"

for picture in scene lines heat_map; do
  "${PYTHON:-python3}" "$here"/fewer_colors.py "$work/$picture.png" "$figures/$picture.png" 128
done
