#!/usr/bin/env bash
# Make the tables of the default mode in doc/evaluation.md: strict convention, no options. Markdown goes to
# standard output.
# Usage: scripts/evaluate/evaluate_default.sh BUILD_DIR [DATA_DIR]
# DATA_DIR/osd has learn4_gt.pcd and so on, DATA_DIR/synthetic clouds with exact creases; without it only
# generated scenes are evaluated.
set -euo pipefail
export LC_ALL=C

usage="usage: scripts/evaluate/evaluate_default.sh BUILD_DIR [DATA_DIR]"
apps=${1:?$usage}/apps
data=${2:-}
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

edge_scores() { # CLOUD [OPTION ...]: P R F1
  local cloud=$1
  shift
  "$apps"/pcl_shape_edge_detection "$cloud" "$work/out.pcd" "$@" >/dev/null
  "$apps"/pcl_shape_evaluate "$work/out.pcd" "$cloud" -task edge |
    awk '$1 == "edge" { print $2, $3, $4 }'
}

surface_scores() { # CLOUD [OPTION ...]: planar F1, curved F1, class-mean IoU
  local cloud=$1
  shift
  "$apps"/pcl_shape_back_projection "$cloud" "$work/out.pcd" "$@" >/dev/null
  "$apps"/pcl_shape_evaluate "$work/out.pcd" "$cloud" -task planar | awk '
    $1 == "planar" { planar = $4 }
    $1 == "curved" { curved = $4; if ($3 ~ /nan/) none = 1 }
    /^class-mean/ { iou = $3 }
    END { print planar, none ? "– –" : curved " " iou }'
}

# table TITLE surfaces|edges CLOUD ...: default mode, and the paper's edges and curved points beside it
table() {
  local title=$1 kind=$2 cloud row
  shift 2
  echo "### $title"
  echo
  echo "| cloud | edge P | R | F1 | paper mode | planar F1 | curved F1 | paper mode | class-mean IoU |"
  echo "|---|---|---|---|---|---|---|---|---|"
  : >"$work/rows"
  for cloud in "$@"; do
    row="$(edge_scores "$cloud") $(edge_scores "$cloud" -mode paper | cut -d' ' -f3)"
    if [[ $kind == surfaces ]]; then
      read -r planar curved iou < <(surface_scores "$cloud")
      row+=" $planar $curved $(surface_scores "$cloud" -mode paper | cut -d' ' -f2) $iou"
    else
      row+=" – – – –"
    fi
    echo "$row" >>"$work/rows"
    echo "| $(basename "$cloud" .pcd) | ${row// / | } |"
  done
  awk '{ for (i = 1; i <= NF; ++i) if ($i != "–") { sum[i] += $i; ++rows[i] } columns = NF }
    END {
      printf "| mean |"
      for (i = 1; i <= columns; ++i)
        if (rows[i]) printf " %.3f |", sum[i] / rows[i]; else printf " – |"
      print ""
    }' "$work/rows"
  echo
}

if [[ -n $data ]]; then
  table "Given real scenes" surfaces "$data"/osd/learn{4,20,22,27,30,33,44}_gt.pcd
  table "Given clouds with exact creases" edges "$data"/synthetic/*.pcd
fi
for seed in 1 2 3 4 5 6 7 8 9 10; do
  "$apps"/pcl_shape_scene "$work/seed$seed.pcd" -seed $seed >/dev/null
done
table "Generated scenes" surfaces "$work"/seed{1,2,3,4,5,6,7,8,9,10}.pcd
