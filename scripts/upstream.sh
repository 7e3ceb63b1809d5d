#!/usr/bin/env bash
# Lay the pull requests of doc/upstream.md into a copy of a PCL source tree, build PCL's
# features and segmentation with them in PCL's own build, and run their tests, PCL's own of
# these modules included. The source tree stays as it is.
# Usage: scripts/upstream.sh PCL_SOURCE [PULL_REQUESTS]
# PULL_REQUESTS: only the first so many. BUILD: where to build (default: build/upstream);
# JOBS: how many compilers at a time; PCL_OPTIONS: more of CMake's, such as
# -DWITH_HIGHWAY=OFF, or -DPCL_NO_PRECOMPILE=ON for a shorter build; PCL_TESTS=OFF: without
# PCL's own tests.
set -euo pipefail
source "$(dirname "${BASH_SOURCE[0]}")/pcl_source.sh"
begin_with_pcl_source upstream "$@"

rm -rf "$build/pcl"
cp -a "$pcl" "$build/pcl"
added=$(scripts/upstream/lay_out.py "$build/pcl" "${@:2}")
mapfile -t targets <<<"$added"
tests=$(sed -n 's/^test_//p' <<<"$added" | paste -sd '|')
configure_pcl "$build/pcl" "$build/build" -DBUILD_global_tests=ON -DBUILD_tools=ON

# run_tests DIRECTORY [OPTION OF CTEST...]: a program has all tests of a pull request, which
# take minutes on a busy machine.
run_tests() {
  ctest --test-dir "$build/build/test/$1" --parallel "$jobs" --timeout 3600 --output-on-failure \
    --no-tests=error "${@:2}"
}

if [[ ${PCL_TESTS:-ON} == OFF ]]; then
  cmake --build "$build/build" --parallel "$jobs" --target "${targets[@]}"
  run_tests . -R "^($tests)\$"
else
  targets+=(pcl_features pcl_segmentation test/features/all test/segmentation/all)
  cmake --build "$build/build" --parallel "$jobs" --target "${targets[@]}"
  run_tests features
  run_tests segmentation
fi
