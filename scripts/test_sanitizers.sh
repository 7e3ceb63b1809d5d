#!/usr/bin/env bash
# Build the engine and its tests with Clang's sanitizers, without PCL, and run them: tests
# of threads under ThreadSanitizer, with Archer, which knows how OpenMP synchronizes; then
# all under AddressSanitizer and UndefinedBehaviorSanitizer. Likewise the readers of the
# apps, with 20,000 damaged files of each kind. Installs nothing: exit status 2 if a
# package is missing.
# Usage: scripts/test_sanitizers.sh [build directory]
# GTEST_FILTER selects tests instead.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/sanitizers}

source scripts/packages.sh
require_packages clang cmake googletest libeigen3-dev libhwy-dev liblzf-dev libomp-dev \
  libpcl-dev ninja-build

# build_with DIRECTORY COMPILER_FLAGS [LINKER_FLAGS]
build_with() {
  cmake -S test/engine -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
        -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
        -DCMAKE_CXX_FLAGS="$2" -DCMAKE_EXE_LINKER_FLAGS="${3:-}"
  cmake --build "$1" --parallel "$(nproc)" --target pcl_shape_test_engine
}

archer=$(dirname "$(readlink -f "$(command -v clang++)")")/../lib/libarcher.so
[[ -e $archer ]] || { echo "no $archer: it is part of libomp-dev" >&2; exit 2; }
# The tests count allocations with operators of their own, and so does the sanitizer.
build_with "$build/thread" -fsanitize=thread -Wl,--allow-multiple-definition
OMP_NUM_THREADS=4 OMP_TOOL_LIBRARIES=$archer TSAN_OPTIONS=ignore_noninstrumented_modules=1 \
  GTEST_FILTER=${GTEST_FILTER:-'*Thread*:*Index*:*Sort*-*FreesItsMemory'} \
  "$build/thread/pcl_shape_test_engine" --gtest_brief=1

build_with "$build/address" "-fsanitize=address,undefined -fno-sanitize-recover=undefined"
ASAN_OPTIONS=detect_leaks=0 "$build/address/pcl_shape_test_engine" --gtest_brief=1

cmake -S test/readers -B "$build/readers" -G Ninja -DCMAKE_BUILD_TYPE=RelWithDebInfo \
      -DCMAKE_C_COMPILER=clang -DCMAKE_CXX_COMPILER=clang++ \
      -DCMAKE_C_FLAGS="-fsanitize=address,undefined -fno-sanitize-recover=undefined" \
      -DCMAKE_CXX_FLAGS="-fsanitize=address,undefined -fno-sanitize-recover=undefined"
cmake --build "$build/readers" --parallel "$(nproc)" --target pcl_shape_test_readers
PCL_SHAPE_DAMAGED_FILES=20000 "$build/readers/pcl_shape_test_readers" --gtest_brief=1
