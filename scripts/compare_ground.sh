#!/usr/bin/env bash
# Compare the ground of generated streets with peers, and write the tables of doc/ground.md.
# Usage: scripts/compare_ground.sh BUILD_DIR
# SEED: of the first street (101). STREETS: for each sensor (10). SLOW_STREETS: of them for the
# morphological filter (3). RESULTS: keep the results in this file. ROOT: of the page to write.
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/compare_ground.sh BUILD_DIR}
scripts=$(dirname "${BASH_SOURCE[0]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
results=${RESULTS:-$work/results.json}

# compare THREADS SLOW_STREETS: a line of JSON
compare() {
  "$build"/benchmarks/compare_ground -seed "${SEED:-101}" -streets "${STREETS:-10}" \
    -threads "$1" -slow_streets "$2" | tail -n 1 >>"$work/runs"
}

compare 1 "${SLOW_STREETS:-3}"
compare 2 0 # the morphological filter has no threads
mv "$work/runs" "$results"
python3 "$scripts/ground_tables.py" "$results" "${ROOT:-$scripts/..}"
