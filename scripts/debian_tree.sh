# Trees of other Debian releases, to build and test in; to be sourced. Needs root.

# make_tree SUITE TREE: a minimal system, unless it is there.
make_tree() {
  [[ -e $2/etc/debian_version ]] || debootstrap --variant=minbase "$1" "$2"
  mkdir -p "$2/src"
  cp /etc/resolv.conf "$2/etc/resolv.conf"
}

# copy_sources DIRECTORY: the files of the repository, with what is not committed yet.
copy_sources() {
  rm -rf "$1"
  mkdir -p "$1"
  git ls-files -z --cached --others --exclude-standard | while IFS= read -r -d '' file; do
    [[ ! -e $file ]] || printf '%s\0' "$file"
  done | tar -c --null --files-from=- | tar -x -C "$1"
}

# in_tree TREE SCRIPT [ARGUMENT...]: run a script of bash in the tree. What is mounted for it
# is gone when it ends, also if it fails. PCL_SHAPE_TEST_DATA has the same path in there.
in_tree() {
  unshare --mount --propagation private bash -euo pipefail -c '
    tree=$1 script=$2
    shift 2
    mount -t proc proc "$tree/proc"
    mount --rbind /dev "$tree/dev"
    data=${PCL_SHAPE_TEST_DATA:-}
    if [[ -n $data ]]; then
      mkdir -p "$tree$data"
      mount --bind "$data" "$tree$data"
    fi
    exec chroot "$tree" /usr/bin/env -i HOME=/root LANG=C.UTF-8 TERM="${TERM:-dumb}" \
      PATH=/usr/sbin:/usr/bin:/sbin:/bin bash -euo pipefail -c "$script" bash "$@"
  ' bash "$@"
}
