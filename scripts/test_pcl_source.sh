#!/usr/bin/env bash
# Build PCL from its source tree, pcl_shape with that PCL, and run the tests: once with PCL's
# default indices and once with signed ones of 64 bits. Warnings are errors in pcl_shape.
# The source tree stays as it is.
# Usage: scripts/test_pcl_source.sh PCL_SOURCE [default|64]
# BUILD: where to build (default: build/pcl_source); JOBS: how many compilers at a time;
# OPTIONS, PCL_OPTIONS: more of CMake's for pcl_shape and for PCL (-DPCL_NO_PRECOMPILE=ON makes
# its build shorter); TARGETS: build only these; TESTS: a regular expression, only these tests.
set -euo pipefail
pcl=$(realpath -m "${1:?usage: scripts/test_pcl_source.sh PCL_SOURCE [default|64]}")
build=$(realpath -m "${BUILD:-$(dirname "${BASH_SOURCE[0]}")/../build/pcl_source}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
source scripts/pcl_source.sh
check_pcl_source "$pcl"
jobs=${JOBS:-$(nproc)}
read -ra more <<<"${OPTIONS:-}"
read -ra targets <<<"${TARGETS:-all}"

# test_with NAME [OPTION OF PCL...]
test_with() {
  local directory=$build/$1
  configure_pcl "$pcl" "$directory/pcl" "-DCMAKE_INSTALL_PREFIX=$directory/prefix" "${@:2}"
  cmake --build "$directory/pcl" --parallel "$jobs" --target install
  local options=(-DCMAKE_BUILD_TYPE=Release -DPCL_SHAPE_WERROR=ON "-DCMAKE_PREFIX_PATH=$directory/prefix"
    "-DPCL_DIR=$(dirname "$(find "$directory/prefix" -name PCLConfig.cmake)")"
    -DPCL_SHAPE_WITH_VISUALIZATION=OFF -DPCL_SHAPE_BUILD_BENCHMARKS=OFF -DPCL_SHAPE_BUILD_EXAMPLES=OFF
    "-DPCL_SHAPE_TEST_DATA=${PCL_SHAPE_TEST_DATA:-}")
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cmake -S . -B "$directory/shape" -G Ninja "${options[@]}" "${more[@]}"
  cmake --build "$directory/shape" --parallel "$jobs" --target "${targets[@]}"
  ctest --test-dir "$directory/shape" --parallel "$jobs" --output-on-failure --no-tests=error -R "${TESTS:-.}"
}

case ${2:-both} in
  default) test_with default ;;
  64) test_with 64 -DPCL_INDEX_SIZE=64 -DPCL_INDEX_SIGNED=true ;;
  both)
    test_with default
    test_with 64 -DPCL_INDEX_SIZE=64 -DPCL_INDEX_SIGNED=true
    ;;
  *)
    echo "indices '$2': it must be default or 64" >&2
    exit 2
    ;;
esac
