# What the scripts that build PCL from its source tree share; to be sourced. JOBS says how many
# compilers run at a time, PCL_OPTIONS more of CMake's options for PCL, such as
# -DPCL_NO_PRECOMPILE=ON: no templates in PCL's libraries, which then take a fraction of the time.

# begin_with_pcl_source NAME PCL_SOURCE [...]: check the command line of scripts/NAME.sh and
# BUILD; set pcl, build and jobs; go to the root of the repository.
begin_with_pcl_source() {
  if [[ -z ${2:-} ]]; then
    echo "expected PCL's source tree: $(sed -n 's/^# Usage: //p' "${BASH_SOURCE[1]}")" >&2
    return 2
  fi
  local root
  root=$(realpath "$(dirname "${BASH_SOURCE[0]}")/..")
  pcl=$(realpath -m "$2")
  build=$(realpath -m "${BUILD:-$root/build/$1}")
  jobs=${JOBS:-$(nproc)}
  check_pcl_source "$pcl"
  if [[ $build/ == "$pcl"/* || $pcl/ == "$build"/* ]]; then
    echo "BUILD is $build: it must not hold PCL's source tree $pcl, nor be in it" >&2
    return 2
  fi
  own_build "$1" "$build"
  cd "$root"
}

# check_pcl_source DIRECTORY: fail unless it is a source tree of PCL.
check_pcl_source() {
  if [[ ! -f $1/PCLConfig.cmake.in ]]; then
    echo "$1 is no source tree of PCL: expected one with PCLConfig.cmake.in, as of" \
      "'git clone https://github.com/PointCloudLibrary/pcl'" >&2
    return 2
  fi
}

# own_build NAME DIRECTORY: make it, with a mark of scripts/NAME.sh, which removes what earlier
# runs left there; fail if it has other files.
own_build() {
  local mark=$2/.made_by_$1
  if [[ ! -f $mark && -d $2 && -n $(ls -A "$2") ]]; then
    echo "BUILD is $2, which holds other files: expected a new or empty directory, or one of an earlier run" >&2
    return 2
  fi
  mkdir -p "$2"
  touch "$mark"
}

# configure_pcl SOURCE BUILD [OPTION OF CMAKE...]: for any processor, as Debian builds PCL.
# The files of a module share most of their headers: some at a time are one translation unit.
configure_pcl() {
  local source=$1 build=$2
  local options=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8
    "-DCMAKE_PROJECT_INCLUDE=$PWD/scripts/pcl_faster_build.cmake"
    -DPCL_ENABLE_SSE=OFF -DPCL_ENABLE_AVX=OFF -DPCL_ENABLE_MARCHNATIVE=OFF
    -DWITH_VTK=OFF -DWITH_CUDA=OFF -DWITH_OPENGL=OFF -DWITH_QT=NO -DWITH_LIBUSB=OFF -DWITH_PCAP=OFF -DWITH_PNG=OFF)
  local module more
  read -ra more <<<"${PCL_OPTIONS:-}"
  for module in keypoints outofcore people recognition registration simulation stereo surface tools tracking \
    visualization; do
    options+=("-DBUILD_$module=OFF")
  done
  configure "$source" "$build" "${options[@]}" "${@:3}" "${more[@]}"
}

# configure SOURCE BUILD [OPTION OF CMAKE...]: with ccache if there is one.
configure() {
  local launcher=()
  if command -v ccache >/dev/null; then
    launcher=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cmake -S "$1" -B "$2" -G Ninja "${launcher[@]}" "${@:3}"
}
