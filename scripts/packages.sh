# What scripts ask of Debian packages; to be sourced.

# is_installed PACKAGE: in some architecture, if the name has none.
is_installed() {
  local states
  states=$(dpkg-query --show --showformat='${db:Status-Status}\n' "$1" 2>/dev/null || true)
  grep -qx installed <<<"$states"
}

# require_packages [--architecture A] PACKAGE...: if some are missing say how to install them
# and exit with status 2.
require_packages() {
  local before='' package missing=()
  if [[ $1 == --architecture ]]; then
    before="dpkg --add-architecture $2 && apt-get update && "
    shift 2
  fi
  for package in "$@"; do
    is_installed "$package" || missing+=("$package")
  done
  if [[ ${#missing[@]} -gt 0 ]]; then
    echo "missing: ${missing[*]}; to install them:" >&2
    echo "  ${before}apt-get install --no-install-recommends ${missing[*]}" >&2
    exit 2
  fi
}

# version_of PACKAGE: what is installed, or would be.
version_of() {
  local version
  version=$(dpkg-query --show --showformat='${Version}' "$1" 2>/dev/null || true)
  [[ -n $version ]] || version=$(apt-cache policy "$1" | sed -n 's/^ *Candidate: \([^(]\)/\1/p')
  echo "$version"
}

# require_versions [PACKAGE VERSION]...: fail if this distribution's packages are older.
require_versions() {
  local version
  while [[ $# -gt 0 ]]; do
    version=$(version_of "$1")
    if dpkg --compare-versions "$version" lt "$2"; then
      echo "$1 is ${version:-not known here}: $2 or newer is needed; use Debian 12 or 13, Ubuntu 24.04," \
        "or a newer one" >&2
      return 1
    fi
    shift 2
  done
}
