#!/usr/bin/env bash
# Print the paper's tables as Markdown, computed in paper mode, beside the figures that the paper prints, and where
# these contradict each other. Builds what it needs first.
# Usage: doc/reproduce.sh DATA_DIR [BUILD_DIR]
# DATA_DIR/osd has learn4_gt.pcd, learn20_gt.pcd, learn33_gt.pcd and learn44_gt.pcd. BUILD_DIR: build.
# This takes some minutes, most of them PCL's. INAD is timed on one thread here, and on one of an i7-6850K in the paper.
set -euo pipefail
root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
source "$root/scripts/evaluate/paper_tables.sh"

data=${1:?usage: doc/reproduce.sh DATA_DIR [BUILD_DIR]}
build=${2:-$root/build}
apps=$build/apps
options=(-mode paper)
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

for scene in "${tables[@]}"; do
  cloud=$data/osd/learn${scene}_gt.pcd
  if [[ ! -r $cloud ]]; then
    echo "doc/reproduce.sh: $cloud cannot be read: the scenes ${tables[*]} are needed" >&2
    exit 2
  fi
  ln -s "$(realpath "$cloud")" "$work/learn$scene.pcd"
done

{
  "$root/scripts/install_packages.sh"
  [[ -f $build/CMakeCache.txt ]] || cmake -S "$root" -B "$build" -G Ninja
  cmake --build "$build" --target pcl_shape_back_projection pcl_shape_edge_detection pcl_shape_evaluate \
    compare_peers k_sweep
} >&2

# contradictions CLASS: keys with precision, recall and F1 on standard input, as printed
contradictions() {
  awk -v class="$1" 'NF {
      split($1, at, "-")
      f1 = 2 * $2 * $3 / ($2 + $3)
      # Precision and recall are rounded: F1 may differ by .01 for that reason alone.
      if (f1 - $4 > 0.0151 || $4 - f1 > 0.0151)
        printf "- Scene %s, %s×%s, %s: precision %s and recall %s give F1 %.2f; %s is printed.\n",
          at[1], at[2], at[2], class, $2, $3, f1, $4
    }'
}

# peers TABLE NAME ... -- ARGUMENT ...: a table of the results of the named peers, by compare_peers
peers() {
  local table=$1 names=()
  shift
  while [[ $1 != -- ]]; do names+=("$1"); shift; done
  shift
  "$build"/benchmarks/compare_peers "$@" -peers "${names[@]}" >"$work/$table"
  "$root"/scripts/evaluate/paper_rows.py "$table" "$work/$table"
}

for scene in "${tables[@]}"; do
  for bins in 10 20; do
    echo "scene $scene, $bins bins" >&2
    detect "learn$scene" $bins
  done
done
echo "## Planar and curved points, paper-like convention (in brackets: the paper)"
echo
surfaces_beside_paper
echo
echo "The number in brackets beside the accuracy is the paper's \"mIoU\"."
echo
echo "## Edges (in brackets: the paper)"
echo
edges_beside_paper
echo
echo "## Edges by surface variation with Bazazian's defaults, strict convention (in brackets: the paper)"
echo
echo "Below, with the radius and the threshold that are best for these four scenes together."
echo
peers edges "surface variation" -- "$data"/osd/learn{4,20,33,44}_gt.pcd -tasks edges
echo
echo "The paper's row for a synthetic cloud is left out: it does not say which cloud that was."
echo
echo "## All cylinders of scene 33, strict convention (in brackets: the paper)"
echo
echo "RANSAC is told how many there are, and takes the best of three settings for this scene."
echo
peers cylinders "pcl_shape" "paper mode" "RANSAC cylinders" -- "$data"/osd/learn33_gt.pcd -tasks surfaces
echo
echo "## Time of INAD for a point, k nearest points, one thread"
echo
echo "Search and INAD for the points of a scene; PCL's tree has the same loop over its neighbors. The paper's"
echo "cloud is synthetic."
echo
"$build"/benchmarks/k_sweep "$work/learn4.pcd" -k 10 100 200 300 400 500 -threads 1 -repeat 1 >"$work/times"
"$root"/scripts/evaluate/paper_rows.py times "$work/times"
echo
echo "## Where the printed figures contradict each other"
echo
awk 'NF { print $1, $2, $3, $4 }' <<<"$paper_surfaces" | contradictions planar
awk 'NF { print $1, $5, $6, $7 }' <<<"$paper_surfaces" | contradictions curved
awk 'NF { print $1, $2, $3, $4 }' <<<"$paper_edges" | contradictions edge
awk 'NF { split($1, at, "-"); iou = 1 / (1 / $2 + 1 / $3 - 1); curved = 1 / (1 / $5 + 1 / $6 - 1)
      printf "- Scene %s, %s×%s: precision and recall give a mean IoU of %.2f; mIoU %s is printed.\n",
        at[1], at[2], at[2], (iou + curved) / 2, $8 }' <<<"$paper_surfaces"
