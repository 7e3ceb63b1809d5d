#!/usr/bin/env bash
# Run all benchmarks and write their results to one JSON file, for scripts/measure/plot_benchmarks.py.
# Usage: scripts/measure/benchmark.sh BUILD_DIR OUT.json [DATA]
# DATA is a PCD file, or a directory whose osd/ has learn4.pcd and so on; without it a generated
# scene takes their place. Generated clouds (a sheet, a laser scan) are used in any case.
# REPEAT: runs of each, in turns (3). POINTS: the sizes of the sheet. SCALE: of the radii in the
# laser scan (30).
set -euo pipefail
export LC_ALL=C

usage="usage: scripts/measure/benchmark.sh BUILD_DIR OUT.json [DATA]"
build=${1:?$usage}
out=${2:?$usage}
data=${3:-}
repeat=${REPEAT:-3}
read -ra points <<<"${POINTS:-100000 200000 500000 1000000 2000000 5000000 10000000}"
load=$(cut -d ' ' -f 1 /proc/loadavg)
scripts=$(dirname "${BASH_SOURCE[0]}")/..
if [[ ! -x $build/benchmarks/structures ]]; then
  echo "$build/benchmarks/structures is missing: install libnanoflann-dev and build again" >&2
  exit 2
fi

work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
cloud=$work/scene.pcd
"$build"/apps/pcl_shape_scene "$cloud" -seed 1 -organized >/dev/null
clouds=("$cloud")
if [[ -d $data ]]; then
  clouds=("$data"/osd/learn{4,20,33,44}.pcd)
elif [[ -n $data ]]; then
  clouds=("$data")
fi

# record NAME CLOUD COMMAND [ARGUMENT ...]: the last line of what it prints, with its name
record() {
  local name=$1 cloud=$2
  shift 2
  echo "$name, $cloud: ${*##*/}" >&2
  "$@" 2>"$work/log" >"$work/result" || { cat "$work/log" >&2; return 1; }
  printf '{"benchmark": "%s", "cloud": "%s", "result": %s}\n' \
    "$name" "$cloud" "$(tail -n 1 "$work/result")" >>"$work/runs"
}

# bench NAME CLOUD_NAME PROGRAM [ARGUMENT ...]
bench() {
  local name=$1 cloud=$2 program=$3
  shift 3
  record "$name" "$cloud" "$build/benchmarks/$program" "$@" -repeat "$repeat"
}

# cached NAME: the value in CMake's cache
cached() { sed -n "s/^$1:[A-Z]*=//p" "$build/CMakeCache.txt"; }

machine() {
  printf '{"commit": "%s", "processor": "%s", "cores": %d, "compiler": "%s", "build_type": "%s", "pcl": "%s", ' \
    "$(git -C "$scripts" rev-parse --short HEAD)" "$(lscpu | sed -n 's/^Model name: *//p' | head -n 1)" "$(nproc)" \
    "$("$(cached CMAKE_CXX_COMPILER)" --version | head -n 1)" "$(cached CMAKE_BUILD_TYPE)" \
    "$(awk '/PCL_VERSION_PRETTY/ { print $3; exit }' \
         "$(cached PCL_COMMON_INCLUDE_DIR)/pcl/pcl_config.h" | tr -d '"')"
  printf '"repeat": %d, "load": %s}' "$repeat" "$load"
}

for cloud in "${clouds[@]}"; do
  name=$(basename "$cloud" .pcd)
  for threads in 1 2; do
    bench pipeline "$name" pipeline_vs_pcl "$cloud" -threads $threads
    bench edges "$name" pipeline_vs_pcl "$cloud" -task edges -threads $threads
  done
done
cloud=${clouds[0]}
name=$(basename "$cloud" .pcd)
for target in avx2 sse4; do
  if "$build"/benchmarks/pipeline_vs_pcl -help | grep -qw $target; then
    bench pipeline "$name" pipeline_vs_pcl "$cloud" -target $target
  fi
done
bench surfaces "$name" pipeline_vs_pcl "$cloud" -task surfaces
if [[ $name != scene ]]; then
  bench surfaces scene pipeline_vs_pcl -generate scene -task surfaces
  bench edges scene pipeline_vs_pcl -generate scene -task edges
fi
bench uneven "$name, shuffled" pipeline_vs_pcl "$cloud" -shuffle
bench uneven "laser scan" pipeline_vs_pcl -generate laser -scale "${SCALE:-30}"
bench k_sweep "$name" k_sweep "$cloud"
bench structures "$name" structures "$cloud"
bench cost_per_point sheet cost_per_point -points "${points[@]}"
record process "$name" python3 "$scripts/measure/process_share.py" "$build" "$cloud" -threads 2

{
  printf '{"machine": %s,\n "runs": [\n' "$(machine)"
  sed '$!s/$/,/' "$work/runs"
  echo ']}'
} >"$work/results"
python3 -m json.tool "$work/results" >"$work/out"
cp "$work/out" "$out"
