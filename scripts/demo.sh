#!/usr/bin/env bash
# Install what is needed (Debian 12), build the applications, make a table scene, find
# its planar, curved and edge points, and compare them with the scene's truth.
# Usage: scripts/demo.sh [seed]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
seed=${1:-1}
build=build/demo

scripts/install_packages.sh
mkdir -p $build
echo "Building (log: $build/build.log) ..."
if ! {
  cmake -S . -B $build -G Ninja -DCMAKE_BUILD_TYPE=Release -DPCL_SHAPE_BUILD_TESTS=OFF \
    -DPCL_SHAPE_BUILD_BENCHMARKS=OFF -DPCL_SHAPE_BUILD_EXAMPLES=OFF &&
    cmake --build $build
} >$build/build.log 2>&1; then
  tail -n 40 $build/build.log >&2
  exit 1
fi

apps=$build/apps
scene=$build/scene.pcd
$apps/pcl_shape_scene $scene -seed "$seed"
$apps/pcl_shape_back_projection $scene $build/surfaces.pcd
$apps/pcl_shape_edge_detection $scene $build/edges.pcd

echo
echo "Planar and curved points against the truth:"
$apps/pcl_shape_evaluate $build/surfaces.pcd $scene -task planar
echo
echo "Edge points against the truth:"
$apps/pcl_shape_evaluate $build/edges.pcd $scene -task edge
