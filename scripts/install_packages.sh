#!/usr/bin/env bash
# Install the Debian packages of packages.txt that are missing; with --site also those of
# packages-site.txt, for the documentation site and tests in a browser.
# Usage: scripts/install_packages.sh [--site] [LOG]
# With LOG what apt-get says goes to that file, and is shown if it fails.
set -euo pipefail
cd "$(dirname "${BASH_SOURCE[0]}")/.."

source scripts/packages.sh
lists=(packages.txt)
if [[ ${1:-} == --site ]]; then
  lists+=(packages-site.txt)
  shift
fi
missing=()
while read -r package; do
  # Node's own packages bring npm, and do not go together with Debian's.
  if [[ $package == npm ]] && command -v npm >/dev/null; then
    continue
  fi
  is_installed "$package" || missing+=("$package")
done < <(sed -e 's/#.*//' -e '/^[[:space:]]*$/d' "${lists[@]}")
[[ ${#missing[@]} -gt 0 ]] || exit 0

sudo=()
if [[ $(id -u) -ne 0 ]]; then
  sudo=(sudo)
fi
install() {
  "${sudo[@]}" apt-get -q update &&
    "${sudo[@]}" env DEBIAN_FRONTEND=noninteractive \
      apt-get -q -y --no-install-recommends install "${missing[@]}"
}
if [[ $# -eq 0 ]]; then
  install
else
  echo "Installing ${#missing[@]} packages (log: $1)"
  install >"$1" 2>&1 || { tail -n 20 "$1" >&2; exit 1; }
fi
