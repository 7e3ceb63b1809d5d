#!/usr/bin/env bash
# Suction grasps beside the centroid method on generated scenes; writes the table of doc/grasps.md.
# Usage: scripts/compare_grasps.sh BUILD_DIR
# SCENES: of each kind, two targets each (30). RESULTS: keep the results in this file.
# ROOT: of the page to write (the repository).
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/compare_grasps.sh BUILD_DIR}
scripts=$(dirname "${BASH_SOURCE[0]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
results=${RESULTS:-$work/results.json}

: >"$work/runs"
for noise in kinect none; do
  for radius in 0.01 0.015; do
    echo "$noise, $radius m" >&2
    "$build"/benchmarks/compare_grasps -noise $noise -cup_radius $radius \
      -first_seed 7001 -scenes "${SCENES:-30}" >>"$work/runs"
  done
done
mv "$work/runs" "$results"
python3 "$scripts/grasp_tables.py" "$results" "${ROOT:-$scripts/..}"
