#!/usr/bin/env bash
# Lay the pull requests of doc/upstream.md into a copy of a PCL source tree, build PCL's
# features and segmentation with them in PCL's own build, and run their tests, PCL's own of
# these modules included. The source tree stays as it is.
# Usage: scripts/upstream.sh PCL_SOURCE [PULL_REQUESTS]
# PULL_REQUESTS: only the first so many. BUILD: where to build (default: build/upstream);
# JOBS: how many compilers at a time; PCL_OPTIONS: more of CMake's, such as
# -DWITH_HIGHWAY=OFF, or -DPCL_NO_PRECOMPILE=ON for a shorter build.
set -euo pipefail
pcl=$(realpath -m "${1:?usage: scripts/upstream.sh PCL_SOURCE [PULL_REQUESTS]}")
build=$(realpath -m "${BUILD:-$(dirname "${BASH_SOURCE[0]}")/../build/upstream}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/pcl_source.sh
check_pcl_source "$pcl"
jobs=${JOBS:-$(nproc)}

if [[ $build/pcl/ == "$pcl"/* || $pcl/ == "$build"/pcl/* ]]; then
  echo "BUILD is $build: it must not hold PCL's source tree $pcl, nor be in it" >&2
  exit 2
fi
rm -rf "$build/pcl"
mkdir -p "$build"
cp -a "$pcl" "$build/pcl"
scripts/upstream/lay_out.py "$build/pcl" "${@:2}"
configure_pcl "$build/pcl" "$build/build" -DBUILD_global_tests=ON
targets=(pcl_features pcl_segmentation test/features/all test/segmentation/all)
cmake --build "$build/build" --parallel "$jobs" --target "${targets[@]}"
for module in features segmentation; do
  ctest --test-dir "$build/build/test/$module" --parallel "$jobs" --output-on-failure --no-tests=error
done
