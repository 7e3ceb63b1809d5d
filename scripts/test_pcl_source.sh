#!/usr/bin/env bash
# Build PCL from its source tree, pcl_shape with that PCL, and run the tests: once with PCL's
# default indices and once with signed ones of 64 bits. Warnings are errors in pcl_shape.
# The source tree stays as it is.
# Usage: scripts/test_pcl_source.sh PCL_SOURCE [default|64]
# BUILD: where to build (default: build/test_pcl_source); JOBS: how many compilers at a time;
# OPTIONS, PCL_OPTIONS: more of CMake's for pcl_shape and for PCL (-DPCL_NO_PRECOMPILE=ON makes
# its build shorter); TARGETS: build only these, and run the tests of those that are test
# programs; TESTS: a regular expression, only these tests.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/pcl_source.sh"
begin_with_pcl_source test_pcl_source "$@"
read -ra more <<<"${OPTIONS:-}"
read -ra targets <<<"${TARGETS:-all}"
selected=(-R "${TESTS:-.}")
if [[ -n ${TARGETS:-} ]]; then
  selected+=(-L "^($(IFS='|' && echo "${targets[*]}"))\$")
fi

# test_with NAME [OPTION OF PCL...]
test_with() {
  local directory=$build/$1
  # What an earlier PCL installed, and this one does not, must not be found.
  rm -rf "$directory/prefix"
  configure_pcl "$pcl" "$directory/pcl" "-DCMAKE_INSTALL_PREFIX=$directory/prefix" "${@:2}"
  cmake --build "$directory/pcl" --parallel "$jobs" --target install
  configure . "$directory/shape" -DCMAKE_BUILD_TYPE=Release -DPCL_SHAPE_WERROR=ON \
    "-DCMAKE_PREFIX_PATH=$directory/prefix" \
    "-DPCL_DIR=$(dirname "$(find "$directory/prefix" -name PCLConfig.cmake)")" \
    -DPCL_SHAPE_WITH_VISUALIZATION=OFF -DPCL_SHAPE_BUILD_BENCHMARKS=OFF -DPCL_SHAPE_BUILD_EXAMPLES=OFF \
    "-DPCL_SHAPE_TEST_DATA=${PCL_SHAPE_TEST_DATA:-}" "${more[@]}"
  cmake --build "$directory/shape" --parallel "$jobs" --target "${targets[@]}"
  ctest --test-dir "$directory/shape" --parallel "$jobs" --output-on-failure --no-tests=error \
    --no-label-summary "${selected[@]}"
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
