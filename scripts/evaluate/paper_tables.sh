# What scripts/evaluate/evaluate.sh and doc/reproduce.sh share, to be sourced: paper mode on a scene, the paper's
# printed figures, and tables of both side by side. The caller sets apps (a directory), work (likewise,
# with the scenes) and options (an array, given to both detectors).
# shellcheck shell=bash disable=SC2154 # see above
export LC_ALL=C
TIMEFORMAT=%2U # processor time of the whole process, with reading and writing

tables=(4 20 33 44) # the scenes of the paper's tables
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
