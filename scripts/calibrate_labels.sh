#!/usr/bin/env bash
# Make src/labels/label_weights.h, the confidence of labels, from generated worlds: parts, tables and rooms, several
# sensors, densities and noise levels. Standard error says how many labels are kept and right on other seeds and sensors. No
# real scene is used. It takes some six minutes of processor time. Build again to use it.
# Usage: scripts/calibrate_labels.sh BUILD_DIR [OUTPUT_FILE]
set -euo pipefail
export LC_ALL=C

build=${1:?usage: scripts/calibrate_labels.sh BUILD_DIR [OUTPUT_FILE]}
output=${2:-$(dirname "${BASH_SOURCE[0]}")/../src/labels/label_weights.h}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

"$build"/tools/calibrate_labels >"$work/weights"
# The numbers are replaced, the rest of the file stays.
awk 'NR == FNR { split($0, word, /[ {]/); line[word[3]] = $0; next }
  { split($0, word, /[ {]/) }
  word[1] == "constexpr" && word[3] in line { print line[word[3]]; next }
  { print }' "$work/weights" "$output" >"$work/header"
cp "$work/header" "$output"
