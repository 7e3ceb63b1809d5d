#!/usr/bin/env bash
# Draw doc/figures/errors.png: where the default mode hits, misses and gives false alarms, for edges and
# for curved points, on generated scenes and, with DATA_DIR, on the given ones (DATA_DIR/osd,
# DATA_DIR/synthetic; see doc/evaluation.md).
# Usage: scripts/draw/draw_errors.sh BUILD_DIR [DATA_DIR] [OUT.png]
# Needs xvfb-run without a display, and python3-pil.
set -euo pipefail
export LC_ALL=C
[[ -n ${DISPLAY:-} ]] || exec xvfb-run -a -s "-screen 0 1280x1024x24 -noreset" "$0" "$@"

apps=${1:?usage: scripts/draw/draw_errors.sh BUILD_DIR [DATA_DIR] [OUT.png]}/apps
data=${2:-}
here=$(dirname "${BASH_SOURCE[0]}")
picture=${3:-$here/../../doc/figures/errors.png}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
entries=()

# outcomes NAME CLOUD edge|curved: a picture of the errors, titled with the score
outcomes() {
  local name=$1 cloud=$2 task=$3 app=pcl_shape_back_projection score
  [[ $task != edge ]] || app=pcl_shape_edge_detection
  "$apps/$app" "$cloud" "$work/found.pcd" >/dev/null
  score=$("$apps"/pcl_shape_evaluate "$work/found.pcd" "$cloud" -task "$task" \
            -out "$work/outcome.pcd" | awk -v task="$task" '$1 == task { print $4 }')
  "$apps"/pcl_shape_viewer "$work/outcome.pcd" -field outcome -size 640x480 \
    -screenshot "$work/$name-$task.png" >/dev/null
  entries+=("$name, $task points: F1 $score=$work/$name-$task.png")
}

for seed in 4 6 7; do
  "$apps"/pcl_shape_scene "$work/scene.pcd" -seed $seed >/dev/null
  outcomes "seed $seed" "$work/scene.pcd" edge
  outcomes "seed $seed" "$work/scene.pcd" curved
done
if [[ -n $data ]]; then
  for scene in learn4 learn20 learn22 learn27; do
    outcomes $scene "$data/osd/${scene}_gt.pcd" edge
  done
  for scene in learn30 learn33 learn44; do
    outcomes $scene "$data/osd/${scene}_gt.pcd" edge
    outcomes $scene "$data/osd/${scene}_gt.pcd" curved
  done
  for cloud in StairsCube ThreeCubeFractal3; do
    outcomes $cloud "$data/synthetic/$cloud.pcd" edge
  done
fi
"${PYTHON:-python3}" "$here"/contact_sheet.py "$picture" 3 320 64 "${entries[@]}"
