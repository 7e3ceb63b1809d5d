#!/usr/bin/env bash
# Install the packages of packages.txt that are missing.
# Usage: scripts/install_packages.sh [--without-tests | --site] [LOG]
# --without-tests leaves those out that only tests and benchmarks need; --site adds those of
# packages-site.txt, for the documentation site and tests in a browser. With LOG what
# apt-get says goes to that file, and is shown if it fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

source scripts/packages.sh
wanted=packages.txt
if [[ ${1:-} == --without-tests ]]; then
  shift
  wanted=$(mktemp)
  trap 'rm -f "$wanted"' EXIT
  sed '/# tests$/d' packages.txt >"$wanted"
fi
if [[ ${1:-} == --site ]]; then
  shift
  wanted=$(mktemp)
  trap 'rm -f "$wanted"' EXIT
  cat packages.txt packages-site.txt >"$wanted"
fi
missing=() versions=()
while read -r package version; do
  # Node's own packages bring npm, and do not go together with Debian's.
  if [[ $package == npm ]] && command -v npm >/dev/null; then
    continue
  fi
  # Ubuntu has Chromium as a snap only: tests in a browser then say that they are skipped.
  if [[ $package == chromium ]] && grep -qs '^ID=ubuntu$' /etc/os-release; then
    continue
  fi
  is_installed "$package" || missing+=("$package")
  [[ -z $version ]] || versions+=("$package" "$version")
done < <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "$wanted")
if [[ ${#missing[@]} -eq 0 ]]; then
  require_versions "${versions[@]}"
  exit 0
fi

sudo=()
if [[ $(id -u) -ne 0 ]]; then
  sudo=(sudo)
fi
install() {
  "${sudo[@]}" apt-get -q update &&
    require_versions "${versions[@]}" &&
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get -q -y --no-install-recommends install "${missing[@]}"
}
if [[ $# -eq 0 ]]; then
  install
else
  echo "Installing ${#missing[@]} packages (log: $1)"
  install >"$1" 2>&1 || { tail -n 20 "$1" >&2; exit 1; }
fi
