#!/usr/bin/env bash
# Build the engine and its tests for 64-bit ARM with Debian's cross compiler, without PCL,
# and run them under the emulator of QEMU. Installs nothing: exit status 2 if a package is
# missing.
# Usage: scripts/test_arm64.sh [build directory]
# GTEST_FILTER selects tests.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/arm64}

source scripts/packages.sh
require_packages --architecture arm64 cmake g++-aarch64-linux-gnu googletest libeigen3-dev \
  libgomp1:arm64 libhwy-dev:arm64 ninja-build qemu-user-static

options=(-DCMAKE_BUILD_TYPE=Release
         -DCMAKE_SYSTEM_NAME=Linux -DCMAKE_SYSTEM_PROCESSOR=aarch64
         -DCMAKE_C_COMPILER=aarch64-linux-gnu-gcc -DCMAKE_CXX_COMPILER=aarch64-linux-gnu-g++)
if command -v ccache >/dev/null; then
  options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
cmake -S test/engine -B "$build" -G Ninja "${options[@]}"
cmake --build "$build" --parallel "$(nproc)" --target pcl_shape_test_engine

run=(qemu-aarch64-static "$build/pcl_shape_test_engine")
if [[ $("${run[@]}" --gtest_list_tests --gtest_filter='*') != *neon* ]]; then
  echo "no test of the NEON kernels: they are not compiled in" >&2
  exit 1
fi
"${run[@]}" --gtest_brief=1
