#!/usr/bin/env bash
# Compare with the paper's method and with peers, and write the tables of doc/evaluation.md.
# Usage: scripts/compare_peers.sh BUILD_DIR [DATA_DIR]
# DATA_DIR/osd has learn4_gt.pcd and so on, DATA_DIR/synthetic clouds with exact creases; without it
# only generated scenes are compared. JOBS: clouds at a time, one thread each (1).
# RESULTS: keep the results in this file. ROOT: of the pages to write (the repository).
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/compare_peers.sh BUILD_DIR [DATA_DIR]}
data=${2:-}
scripts=$(dirname "${BASH_SOURCE[0]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
results=${RESULTS:-$work/results.json}

# compare GROUP ARGUMENT ...: append a line with the group's name and its results
compare() {
  local group=$1
  shift
  echo "$group" >&2
  "$build"/benchmarks/compare_peers "$@" -jobs "${JOBS:-1}" >"$work/result"
  printf '{"group": "%s", "result": %s}\n' "$group" "$(tail -n 1 "$work/result")" >>"$work/runs"
}

if [[ -n $data ]]; then
  compare real "$data"/osd/learn{4,20,22,27,30,33,44}_gt.pcd -tasks edges -edge_radii .012 .015
  # Only these have curved points outside creases.
  compare real "$data"/osd/learn{30,33,44}_gt.pcd -tasks surfaces
  # A millimeter between points, no noise: smaller radii are better.
  compare exact "$data"/synthetic/*.pcd -tasks edges -edge_radii .003 .005 -voronoi_radii .003 .005
fi
for seed in 1 2 3; do
  "$build"/apps/pcl_shape_scene "$work/seed$seed.pcd" -seed $seed >/dev/null
done
compare generated "$work"/seed{1,2,3}.pcd -edge_radii .008 .012 -surface_radii .025

mv "$work/runs" "$results"
python3 "$scripts/peer_tables.py" "$results" "${ROOT:-$scripts/..}"
