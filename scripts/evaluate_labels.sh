#!/usr/bin/env bash
# Make the tables of doc/labels.md: how many points pcl_shape_label keeps, and how many of these labels are
# right. Markdown goes to standard output.
# Usage: scripts/evaluate_labels.sh BUILD_DIR [DATA_DIR]
# DATA_DIR/osd has learn4_gt.pcd and so on; without it only generated scenes are evaluated. Seeds from 500001
# on are used for nothing else.
set -euo pipefail
export LC_ALL=C

apps=${1:?usage: scripts/evaluate_labels.sh BUILD_DIR [DATA_DIR]}/apps
data=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

heading() {
  echo "| $1 | kept | right | planar P | R | curved P | R | edge P | R |"
  echo "|---|---|---|---|---|---|---|---|---|"
}

row() { # NAME TRUTH
  "$apps"/pcl_shape_label "$2" "$work/out.pcd" >/dev/null
  "$apps"/pcl_shape_evaluate "$work/out.pcd" "$2" -task label | awk -v name="$1" '
    function show(value) { return value ~ /nan/ ? "–" : value }
    $1 == "planar" || $1 == "curved" || $1 == "edge" { scores = scores " | " show($2) " | " show($3) }
    $1 == "kept" { kept = substr($2, 1, 5); right = $6 }
    END { print "| " name " | " kept " | " right scores " |" }'
}

generated() { # NAME OPTION ...
  local name=$1
  shift
  "$apps"/pcl_shape_scene "$work/scene.pcd" "$@" >/dev/null
  row "$name" "$work/scene.pcd"
}

if [[ -n $data ]]; then
  heading "given scene"
  for scene in 4 20 22 27 30 33 44; do
    row "learn$scene" "$data/osd/learn${scene}_gt.pcd"
  done
  echo
fi
heading "generated scene"
for seed in 500001 500002 500003 500004 500005 500006 500007 500008 500009 500010; do
  generated "Kinect, seed $seed" -seed $seed
done
for sigma in none 0.0005 0.001 0.002; do
  generated "camera, noise $sigma, seed 500011" -seed 500011 -noise $sigma
done
for sigma in none 0.0002 0.0004; do
  generated "sampled at 2 mm, noise $sigma, seed 500012" -seed 500012 -sampling 0.002 -noise $sigma
done
