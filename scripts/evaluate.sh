#!/usr/bin/env bash
# Make the tables of doc/evaluation.md: detect surfaces and edges in real and generated scenes, in paper
# mode, and compare them with the truth. Markdown goes to standard output.
# Usage: scripts/evaluate.sh BUILD_DIR [DATA_DIR] [OPTION ...]
# DATA_DIR/osd has learn4_gt.pcd and so on; without it only generated scenes are evaluated.
# More options are given to both detectors, after "-mode paper".
set -euo pipefail
export LC_ALL=C
TIMEFORMAT=%2U # processor time of the whole process, with reading and writing

usage="usage: scripts/evaluate.sh BUILD_DIR [DATA_DIR] [OPTION ...]"
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

tables=(4 20 33 44)            # the scenes of the paper's tables
all=("${tables[@]}" 22 27 30)
seeds=(1 2 3 4 5 6 7 8 9 10)
lines=()

# What the paper prints: surfaces  scene-bins  planar P R F1  curved P R F1  "mIoU"
paper_surfaces="
4-10 .99 .95 .97 .50 .98 .66 .95
20-10 1.00 .95 .97 .63 1.00 .67 .95
33-10 .97 .95 .96 .74 .82 .78 .92
44-10 .98 .96 .97 .71 .89 .79 .95
4-20 .99 .93 .96 .38 .99 .55 .93
20-20 .92 .96 .92 .51 1.00 .68 .92
33-20 .99 .91 .95 .66 .97 .79 .91
44-20 .99 .93 .96 .61 .99 .76 .93"
# edges  scene-bins  P R F1  seconds
paper_edges="
4-10 .98 .51 .67 2.2
4-20 .94 .72 .82 2.2
20-10 .95 .63 .75 2.0
20-20 .90 .83 .86 2.0
33-10 .87 .48 .62 1.5
33-20 .78 .75 .77 1.5
44-10 .94 .62 .75 1.4
44-20 .84 .82 .83 1.4"

# detect NAME BINS: $work/NAME.pcd -> the output of pcl_shape_evaluate in
# $work/NAME-BINS-{surfaces,edges}-{strict,paper}, seconds in $work/NAME-BINS-edges-time
detect() {
  local in=$work/$1.pcd out=$work/$1-$2
  "$apps"/pcl_shape_back_projection "$in" "$out-surfaces.pcd" "${options[@]}" -bins "$2" >/dev/null
  { time "$apps"/pcl_shape_edge_detection "$in" "$out-edges.pcd" "${options[@]}" -bins "$2" \
    -threads 1 >/dev/null 2>&3; } 3>&2 2>"$out-edges-time"
  local convention
  for convention in strict paper; do
    "$apps"/pcl_shape_evaluate "$out-surfaces.pcd" "$in" -task planar \
      -convention $convention >"$out-surfaces-$convention"
    "$apps"/pcl_shape_evaluate "$out-edges.pcd" "$in" -task edge \
      -convention $convention >"$out-edges-$convention"
  done
  rm "$out-surfaces.pcd" "$out-edges.pcd"
}

# scores FILE CLASS: precision recall F1
scores() { awk -v class="$2" '$1 == class { print $2, $3, $4 }' "$1"; }

# Recall is not a number where the truth has no such point: some scenes have boxes only.
f1_if_there_are_any() { awk '{ print ($2 ~ /nan/) ? "–" : $3 }'; }

# overall FILE: accuracy and class-mean IoU
overall() { awk '/^class-mean/ { iou = $3 } /^accuracy/ { print $2, iou }' "$1"; }

# paper LIST KEY
paper() { awk -v key="$2" '$1 == key { $1 = ""; print }' <<<"$1"; }

row() {
  local cell
  printf '|'
  for cell in "$@"; do printf ' %s |' "${cell/#0./.}"; done
  printf '\n'
}

# beside OURS PAPERS: "ours (the paper's)", number by number
beside() {
  local -a ours papers
  read -ra ours <<<"$1"
  read -ra papers <<<"$2"
  local i
  for i in "${!ours[@]}"; do
    lines+=("${ours[i]/#0./.} (${papers[i]})")
  done
}

mean_row() { # label, then rows of numbers on standard input
  local label=$1 cells
  read -ra cells < <(awk '{
      columns = NF
      for (i = 1; i <= NF; ++i) if ($i != "–") { sum[i] += $i; ++rows[i] }
    }
    END { for (i = 1; i <= columns; ++i) printf "%.3f ", sum[i] / rows[i]; print "" }')
  row "$label" "${cells[@]/#0./.}"
}

surfaces_beside_paper() {
  echo "| scene | bins | planar P | R | F1 | curved P | R | F1 | accuracy | class-mean IoU |"
  echo "|---|---|---|---|---|---|---|---|---|---|"
  local bins scene file printed
  for bins in 10 20; do
    for scene in "${tables[@]}"; do
      file=$work/learn$scene-$bins-surfaces-paper
      read -r printed < <(paper "$paper_surfaces" "$scene-$bins")
      lines=()
      beside "$(scores "$file" planar) $(scores "$file" curved) $(overall "$file" | cut -d' ' -f1)" \
             "$printed"
      row "$scene" "$bins×$bins" "${lines[@]}" "$(overall "$file" | cut -d' ' -f2)"
    done
  done
}

edges_beside_paper() {
  echo "| scene | bins | strict P | R | F1 | paper-like P | R | F1 | the paper's P | R | F1 | time (s) |"
  echo "|---|---|---|---|---|---|---|---|---|---|---|---|"
  local bins scene name
  local -a strict like printed
  for bins in 10 20; do
    for scene in "${tables[@]}"; do
      name=$work/learn$scene-$bins-edges
      read -ra strict < <(scores "$name-strict" edge)
      read -ra like < <(scores "$name-paper" edge)
      read -ra printed < <(paper "$paper_edges" "$scene-$bins")
      row "$scene" "$bins×$bins" "${strict[@]/#0./.}" "${like[@]/#0./.}" "${printed[@]:0:3}" \
        "$(<"$name-time") (${printed[3]})"
    done
  done
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
