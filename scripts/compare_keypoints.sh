#!/usr/bin/env bash
# Align generated views by several kinds of keypoints; writes the table of doc/keypoints.md.
# Usage: scripts/compare_keypoints.sh BUILD_DIR
# PAIRS: of views for each angle (10). THREADS: of everything (2).
# RESULTS: keep the results in this file. ROOT: of the page to write (the repository).
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/compare_keypoints.sh BUILD_DIR}
scripts=$(dirname "${BASH_SOURCE[0]}")
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
results=${RESULTS:-$work/results.json}

"$build"/benchmarks/compare_keypoints -pairs "${PAIRS:-10}" -threads "${THREADS:-2}" >"$work/out"
tail -n 1 "$work/out" >"$results"
python3 "$scripts/keypoint_tables.py" "$results" "${ROOT:-$scripts/..}"
