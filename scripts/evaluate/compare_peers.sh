#!/usr/bin/env bash
# Compare with the paper's method and with peers, and write the tables of doc/evaluation.md.
# Usage: scripts/evaluate/compare_peers.sh BUILD_DIR [DATA_DIR]
# DATA_DIR/osd has learn4_gt.pcd and so on, DATA_DIR/synthetic clouds with exact creases, DATA_DIR/parts
# sampled parts, DATA_DIR/rgbd tables of depth cameras; without it only generated scenes are compared.
# GROUPS_ONLY="parts dense": these groups instead of "real exact generated"; also parts, rgbd and dense, whose tables are
# not in the page and go to standard output. JOBS: clouds at a time, one thread each (1).
# RESULTS: keep the results in this file. ROOT: of the pages to write (the repository).
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/evaluate/compare_peers.sh BUILD_DIR [DATA_DIR]}
data=${2:-}
scripts=$(dirname "${BASH_SOURCE[0]}")/..
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

groups=${GROUPS_ONLY:-real exact generated}
for group in $groups; do
  if [[ ! " real exact generated parts rgbd dense " == *" $group "* ]]; then
    echo "$0: '$group' in GROUPS_ONLY; expected real, exact, generated, parts, rgbd or dense" >&2
    exit 2
  fi
done

# wants GROUP: whether to run a group
wants() {
  [[ " $groups " == *" $1 "* ]]
}

# scenes NAME OPTION ...: one scene for each of SEEDS
scenes() {
  local name=$1 seed
  shift
  for seed in $SEEDS; do
    "$build"/apps/pcl_shape_scene "$work/$name$seed.pcd" -seed "$seed" "$@" >/dev/null
  done
}

if [[ -n $data ]] && wants real; then
  compare real "$data"/osd/learn{4,20,22,27,30,33,44}_gt.pcd -tasks edges -edge_radii .012 .015
  # Only these have curved points outside creases.
  compare real "$data"/osd/learn{30,33,44}_gt.pcd -tasks surfaces
fi
if [[ -n $data ]] && wants exact; then
  # A millimeter between points, no noise: smaller radii are better.
  compare exact "$data"/synthetic/*.pcd -tasks edges -edge_radii .003 .005 -voronoi_radii .003 .005
fi
SEEDS="1 2 3" scenes seed
if wants generated; then
  compare generated "$work"/seed{1,2,3}.pcd -edge_radii .008 .012 -surface_radii .025
fi
# In few settings: one for less noise, one for more.
local_peers=(-tasks edges -peers "default mode" "k nearest" Principal CGAL)
if [[ -n $data ]] && wants parts; then
  for sampling in pds0 pds15 pds40 rnd15; do
    compare parts_$sampling "$data"/parts/*_$sampling.pcd "${local_peers[@]}" -held_out -neighbors 12 24 48 \
      -edge_radii .003 .005 -voronoi_radii .003 .005
  done
fi
if [[ -n $data ]] && wants rgbd; then
  # Only the table is known there: settings come from generated tables of two cameras.
  SEEDS=4 scenes stereo -sensor stereo
  SEEDS=4 scenes tof -sensor tof
  compare rgbd "$data"/rgbd/*.pcd -tune_on "$work"/{seed1,stereo4,tof4}.pcd "${local_peers[@]}" -neighbors 48 96 \
    -edge_radii .008 .012 -voronoi_radii .012
fi
if wants dense; then
  # Three seeds and noises: which is which must not be known from the others.
  SEEDS=5 scenes dense_kinect_ -width 1280 -height 960
  SEEDS=6 scenes dense_none_ -width 1280 -height 960 -noise none
  SEEDS=7 scenes dense_white_ -width 1280 -height 960 -noise 0.001
  compare dense "$work"/dense_*.pcd "${local_peers[@]}" -held_out -neighbors 48 96 \
    -edge_radii .004 .008 -voronoi_radii .008
fi

mv "$work/runs" "$results"
python3 "$scripts/evaluate/peer_tables.py" "$results" "${ROOT:-$scripts/..}"
