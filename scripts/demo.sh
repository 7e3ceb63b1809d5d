#!/usr/bin/env bash
# Build what the demonstration needs (Debian or Ubuntu), make a table scene, find its planar,
# curved and edge points, and compare them with the scene's truth.
# Usage: scripts/demo.sh [seed]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seed=${1:-1}
build=build/demo
programs=(scene back_projection edge_detection evaluate)

# Ninja's lines over each other, as on a terminal.
progress() {
  if [[ -t 1 ]]; then
    awk '{ printf "\r\033[K%.78s", $0; fflush() } END { printf "\r\033[K" }'
  else
    cat >/dev/null
  fi
}

mkdir -p $build
scripts/install_packages.sh --without-tests $build/packages.log
echo "Building (log: $build/build.log)"
if ! {
  cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DPCL_SHAPE_ONLY_DETECTION=ON \
    -DPCL_SHAPE_UNITY_BUILD=ON &&
    NINJA_STATUS='[%f/%t] ' cmake --build $build --target "${programs[@]/#/pcl_shape_}"
} 2>&1 | tee $build/build.log | progress; then
  grep -A 20 -m 1 -E '^FAILED|CMake Error' $build/build.log >&2 || tail -n 20 $build/build.log >&2
  exit 1
fi

app=$build/apps/pcl_shape
scene=$build/scene.pcd
${app}_scene $scene -seed "$seed"
${app}_back_projection $scene $build/surfaces.pcd
${app}_edge_detection $scene $build/edges.pcd

echo
echo "Planar and curved points against the truth:"
${app}_evaluate $build/surfaces.pcd $scene -task planar
echo
echo "Edge points against the truth:"
${app}_evaluate $build/edges.pcd $scene -task edge
