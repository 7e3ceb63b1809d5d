# Builds the modules of a PCL source tree that pcl_shape needs; to be sourced. JOBS says how
# many compilers run at a time, PCL_OPTIONS more of CMake's options for PCL, such as
# -DPCL_NO_PRECOMPILE=ON: no templates in PCL's libraries, which then take a fraction of the time.

# configure_pcl SOURCE BUILD [OPTION OF CMAKE...]: for any processor, as Debian builds PCL.
# The files of a module share most of their headers: some at a time are one translation unit.
configure_pcl() {
  local source=$1 build=$2
  local options=(-DCMAKE_BUILD_TYPE=Release -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=8
    "-DCMAKE_PROJECT_INCLUDE=$PWD/scripts/pcl_unity.cmake"
    -DPCL_ENABLE_SSE=OFF -DPCL_ENABLE_AVX=OFF -DPCL_ENABLE_MARCHNATIVE=OFF
    -DWITH_VTK=OFF -DWITH_CUDA=OFF -DWITH_OPENGL=OFF -DWITH_QT=NO -DWITH_LIBUSB=OFF -DWITH_PCAP=OFF -DWITH_PNG=OFF)
  local module more
  read -ra more <<<"${PCL_OPTIONS:-}"
  for module in keypoints outofcore people recognition registration simulation stereo surface tools tracking \
    visualization; do
    options+=("-DBUILD_$module=OFF")
  done
  if command -v ccache >/dev/null; then
    options+=(-DCMAKE_CXX_COMPILER_LAUNCHER=ccache)
  fi
  cmake -S "$source" -B "$build" -G Ninja "${options[@]}" "${@:3}" "${more[@]}"
}

# check_pcl_source DIRECTORY: fail unless it is a source tree of PCL.
check_pcl_source() {
  if [[ ! -f $1/PCLConfig.cmake.in ]]; then
    echo "$1 is no source tree of PCL: expected one with PCLConfig.cmake.in, as of" \
      "'git clone https://github.com/PointCloudLibrary/pcl'" >&2
    return 2
  fi
}
