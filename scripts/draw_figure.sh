#!/usr/bin/env bash
# Draw doc/figures/scene.png: a generated scene, its classes, its edges.
# Usage: scripts/draw_figure.sh BUILD_DIR [seed] [out.png]
set -euo pipefail
build=${1:?usage: scripts/draw_figure.sh BUILD_DIR [seed] [out.png]}
seed=${2:-2}
picture=${3:-$(dirname "${BASH_SOURCE[0]}")/../doc/figures/scene.png}

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
"$build"/apps/pcl_shape_scene "$work/scene.pcd" -seed "$seed" -organized
"$build"/apps/pcl_shape_back_projection "$work/scene.pcd" "$work/surfaces.pcd"
"$build"/apps/pcl_shape_edge_detection "$work/surfaces.pcd" "$work/edges.pcd" -normals
"$build"/doc/figures/draw_scene "$work/edges.pcd" "$picture"
