#!/usr/bin/env bash
# Install what is needed (Debian or Ubuntu), check who includes whom, build everything with
# warnings as errors, run all tests. Real scenes are tested if PCL_SHAPE_TEST_DATA names
# their directory.
# Usage: scripts/test.sh [build directory]
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."
build=${1:-build/test}

scripts/install_packages.sh --site
scripts/check_includes.py
options=(-DCMAKE_BUILD_TYPE=Release -DPCL_SHAPE_WERROR=ON
         -DPCL_SHAPE_BUILD_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3
         "-DPCL_SHAPE_TEST_DATA=${PCL_SHAPE_TEST_DATA:-}")
if command -v ccache >/dev/null; then
  options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
fi
jobs=$(nproc)
cmake -S . -B "$build" -G Ninja "${options[@]}"
cmake --build "$build" --parallel "$jobs"
ctest --test-dir "$build" --parallel "$jobs" --output-on-failure --no-tests=error --no-label-summary
