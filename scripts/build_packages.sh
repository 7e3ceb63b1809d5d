#!/usr/bin/env bash
# Build the Debian packages, check them with lintian, install them in a clean tree of Debian
# and try them there: a scene, its edges and surfaces beside the truth, a picture, Python, and
# a CMake project outside. Needs root; makes the tree with debootstrap if it is not there.
# Usage: scripts/build_packages.sh OUT TREE
# The packages go to OUT; they are for the release of Debian that this system has, and TREE has
# the same.
set -euo pipefail
usage='usage: scripts/build_packages.sh OUT TREE'
out=$(realpath -m "${1:?$usage}")
tree=$(realpath -m "${2:?$usage}")
cd "$(dirname "${BASH_SOURCE[0]}")/.."
suite=$(. /etc/os-release && echo "$VERSION_CODENAME")

source scripts/packages.sh
require_packages debhelper debootstrap dh-python dpkg-dev lintian
if [[ $(id -u) -ne 0 ]]; then
  echo "debootstrap and chroot need root: sudo scripts/build_packages.sh $out $tree" >&2
  exit 2
fi
source scripts/debian_tree.sh

echo "Building (log: $out/build.log)"
mkdir -p "$out"
rm -f "$out"/*.deb "$out"/*.changes "$out"/*.buildinfo
copy_sources "$out/pcl-shape"
if command -v ccache >/dev/null; then
  export CMAKE_CXX_COMPILER_LAUNCHER=ccache
fi
(cd "$out/pcl-shape" && DEB_BUILD_OPTIONS="parallel=${JOBS:-$(nproc)} nocheck noautodbgsym ${DEB_BUILD_OPTIONS:-}" \
  dpkg-buildpackage --build=binary --unsigned-changes --unsigned-source) >"$out/build.log" 2>&1 ||
  { tail -n 30 "$out/build.log" >&2; exit 1; }
ls -1 "$out"/*.deb

echo "lintian:"
lintian --allow-root --fail-on error --tag-display-limit 0 "$out"/*.changes

echo "A clean tree (log: $out/install.log)"
make_tree "$suite" "$tree" >"$out/install.log" 2>&1
rm -rf "$tree/packages"
mkdir "$tree/packages"
cp "$out"/*.deb "$tree/packages"
copy_sources "$tree/src"
in_tree "$tree" 'apt-get -q update && cd /packages && export DEBIAN_FRONTEND=noninteractive &&
  apt-get -q -y --no-install-recommends --reinstall install ./*.deb &&
  apt-get -q -y --no-install-recommends install xvfb xauth cmake ninja-build g++' \
  >>"$out/install.log" 2>&1 || { tail -n 30 "$out/install.log" >&2; exit 1; }
in_tree "$tree" 'cd /src && scripts/try_packages.sh'
echo "The packages are in $out."
