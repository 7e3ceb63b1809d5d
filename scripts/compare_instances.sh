#!/usr/bin/env bash
# Compare the instances found with those that PCL finds, and write the tables of doc/evaluation.md.
# Usage: scripts/compare_instances.sh BUILD_DIR [DATA_DIR]
# DATA_DIR/osd has learn33_gt.pcd; without it only generated scenes are compared.
# RESULTS: keep the results in this file. ROOT: of the pages to write (the repository). SEEDS, COUNTS: of the
# scenes and of the objects in them.
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/compare_instances.sh BUILD_DIR [DATA_DIR]}
data=${2:-}
scripts=$(dirname "${BASH_SOURCE[0]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
results=${RESULTS:-$work/results.json}

read -ra seeds <<<"${SEEDS:-301 302}"
read -ra counts <<<"${COUNTS:-1 2 3 4 5 6 7 8 9 10 11 12}"
clouds=()
if [[ -n $data ]]; then
  clouds+=("$data/osd/learn33_gt.pcd")
fi
"$build"/benchmarks/compare_instances "${clouds[@]}" -seeds "${seeds[@]}" -counts "${counts[@]}" >"$results"
python3 "$scripts/instance_tables.py" "$results" "${ROOT:-$scripts/..}"
