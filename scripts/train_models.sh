#!/usr/bin/env bash
# Make the default models, models/edges.json and models/surfaces.json, from generated scenes: depth camera
# and CAD-like sampling, several noise levels. Seeds from 100001 on are used for nothing else. No real scene
# is used.
# Usage: scripts/train_models.sh BUILD_DIR [OUTPUT_DIR]
set -euo pipefail
export LC_ALL=C

usage="usage: scripts/train_models.sh BUILD_DIR [OUTPUT_DIR]"
apps=${1:?$usage}/apps
output=${2:-$(dirname "${BASH_SOURCE[0]}")/../models}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

seed=100001
scene() {
  "$apps"/pcl_shape_scene "$work/$seed.pcd" -seed $seed "$@"
  seed=$((seed + 1))
}

# A depth camera: its own noise, and white noise of 0.5, 1 and 2 mm.
for _ in 1 2 3 4; do scene; done
for sigma in 0.0005 0.001 0.002; do scene -noise $sigma; done
# Surfaces sampled at random, 2 mm apart: exact, and with noise of a tenth and a fifth of that.
for sigma in none none 0.0002 0.0004; do scene -sampling 0.002 -objects 4 -noise $sigma; done

common=(-scale density -bins 40 -mu_range 60 -sigma_range 30 -smoothing 1 -floor 0.0003)
rm -f "$output/edges.json" "$output/surfaces.json"
"$apps"/pcl_shape_histogram "$work"/*.pcd "$output/edges.json" "${common[@]}" \
  -normal_radius 1.2 -normal_radius_noise 10 -radius 1 -radius_noise 5 \
  -field edge -classes edge=1,surface=0
# Planar surfaces are three times as frequent: else noise on a table turns into curved points.
"$apps"/pcl_shape_histogram "$work"/*.pcd "$output/surfaces.json" "${common[@]}" \
  -normal_radius 5 -radius 7 -field surface -classes planar=1:3,curved=2
