#!/usr/bin/env bash
# Make the tables of doc/evaluation.md: detect surfaces and edges in real and generated scenes, in paper
# mode, and compare them with the truth. Markdown goes to standard output.
# Usage: scripts/evaluate/evaluate.sh BUILD_DIR [DATA_DIR] [OPTION ...]
# DATA_DIR/osd has learn4_gt.pcd and so on; without it only generated scenes are evaluated.
# More options are given to both detectors, after "-mode paper".
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/paper_tables.sh"

usage="usage: scripts/evaluate/evaluate.sh BUILD_DIR [DATA_DIR] [OPTION ...]"
apps=${1:?$usage}/apps
data=
if [[ $# -gt 1 && $2 != -* ]]; then
  data=$2
  shift
fi
shift
options=(-mode paper "$@")

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

all=("${tables[@]}" 22 27 30)
seeds=(1 2 3 4 5 6 7 8 9 10)

mean_row() { # label, then rows of numbers on standard input
  local label=$1 cells
  read -ra cells < <(awk '{
      columns = NF
      for (i = 1; i <= NF; ++i) if ($i != "–") { sum[i] += $i; ++rows[i] }
    }
    END { for (i = 1; i <= columns; ++i) printf "%.3f ", sum[i] / rows[i]; print "" }')
  row "$label" "${cells[@]/#0./.}"
}

# all_scenes PREFIX BINS NAME ...: surfaces and edges, both conventions
all_scenes() {
  local prefix=$1 bins=$2 name file
  shift 2
  echo "| scene | planar F1 strict | paper-like | curved F1 strict | paper-like | edge P strict | R | F1 | edge F1 paper-like |"
  echo "|---|---|---|---|---|---|---|---|---|"
  for name in "$@"; do
    file=$work/$prefix$name-$bins
    {
      scores "$file-surfaces-strict" planar | cut -d' ' -f3
      scores "$file-surfaces-paper" planar | cut -d' ' -f3
      scores "$file-surfaces-strict" curved | f1_if_there_are_any
      scores "$file-surfaces-paper" curved | cut -d' ' -f3
      scores "$file-edges-strict" edge
      scores "$file-edges-paper" edge | cut -d' ' -f3
    } | tr '\n' ' ' >"$file-row"
    echo >>"$file-row"
    local -a cells
    read -ra cells <"$file-row"
    row "$name" "${cells[@]/#0./.}"
  done
  for name in "$@"; do cat "$work/$prefix$name-$bins-row"; done | mean_row "mean"
}

if [[ -n $data ]]; then
  for scene in "${all[@]}"; do
    ln -s "$(realpath "$data/osd/learn${scene}_gt.pcd")" "$work/learn$scene.pcd"
    for bins in 10 20; do
      echo "learn$scene, $bins bins" >&2
      detect "learn$scene" $bins
    done
  done
  echo "### Surfaces, paper-like convention (in brackets: the paper)"
  echo
  surfaces_beside_paper
  echo
  echo "### Edges (in brackets: the paper)"
  echo
  edges_beside_paper
  for bins in 10 20; do
    echo
    echo "### The seven scenes, $bins×$bins"
    echo
    all_scenes learn $bins "${all[@]}"
  done
  echo
fi

for seed in "${seeds[@]}"; do
  echo "generated scene $seed" >&2
  "$apps"/pcl_shape_scene "$work/seed$seed.pcd" -seed "$seed" >/dev/null
  for bins in 10 20; do detect "seed$seed" $bins; done
done
for bins in 10 20; do
  echo "### Generated scenes, seeds 1 to ${#seeds[@]}, $bins×$bins"
  echo
  all_scenes seed $bins "${seeds[@]}"
  echo
done
