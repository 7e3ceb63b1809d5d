#!/usr/bin/env bash
# Build everything and run all tests in a tree of Debian 13: PCL 1.15 and GCC 14, or Clang
# 19, with warnings as errors. Makes the tree with debootstrap if it is not there; needs
# root. Real scenes are tested if PCL_SHAPE_TEST_DATA names their directory.
# Usage: scripts/test_debian13.sh TREE [gcc|clang] [TARGET...]
# With targets only these are built, and no test is run. JOBS: how many at a time;
# OPTIONS: more of CMake's, such as -DPCL_SHAPE_BUILD_BENCHMARKS=OFF.
set -euo pipefail
tree=$(realpath -m "${1:?usage: scripts/test_debian13.sh TREE [gcc|clang] [TARGET...]}")
compiler=${2:-gcc}
targets=("${@:3}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."

source scripts/packages.sh
require_packages debootstrap
if [[ $(id -u) -ne 0 ]]; then
  echo "debootstrap and chroot need root: sudo scripts/test_debian13.sh $tree" >&2
  exit 2
fi
case $compiler in
  gcc) more=() compilers=(gcc g++) ;;
  clang) more=(clang-19 libomp-19-dev) compilers=(clang-19 clang++-19) ;;
  *) echo "compiler '$compiler': it must be gcc or clang" >&2; exit 2 ;;
esac

source scripts/debian_tree.sh
make_tree trixie "$tree"
copy_sources "$tree/src"
# Both compilers' packages need what packages.txt has; ccache makes a second run short.
in_tree "$tree" 'cd /src && scripts/install_packages.sh &&
  DEBIAN_FRONTEND=noninteractive apt-get -q -y --no-install-recommends install ccache "$@"' "${more[@]}"
jobs=${JOBS:-$(nproc)}
read -ra options <<<"${OPTIONS:-}"
in_tree "$tree" 'cmake -S /src -B "$1" -G Ninja -DCMAKE_BUILD_TYPE=Release -DPCL_SHAPE_WERROR=ON \
  -DCMAKE_C_COMPILER="$2" -DCMAKE_CXX_COMPILER="$3" -DCMAKE_CXX_COMPILER_LAUNCHER=ccache \
  -DPCL_SHAPE_BUILD_PYTHON=ON -DPCL_SHAPE_TEST_DATA="$4" "${@:5}"' \
  "/build-$compiler" "${compilers[@]}" "${PCL_SHAPE_TEST_DATA:-}" "${options[@]}"
if [[ ${#targets[@]} -gt 0 ]]; then
  in_tree "$tree" 'cmake --build "$1" --parallel "$2" --target "${@:3}" -- -k 0' "/build-$compiler" "$jobs" "${targets[@]}"
  exit
fi
in_tree "$tree" 'cmake --build "$1" --parallel "$2" -- -k 0 &&
  ctest --test-dir "$1" --parallel "$2" --output-on-failure --no-tests=error' "/build-$compiler" "$jobs"
