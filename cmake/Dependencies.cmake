# PCL 1.13's PCLConfig does not find OpenMP; 1.14 and later do.
find_package(OpenMP REQUIRED COMPONENTS CXX)
find_package(PCL 1.13 REQUIRED COMPONENTS
  common kdtree search features sample_consensus filters segmentation io keypoints registration)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Boost REQUIRED)

# The Debian package of Highway has no complete CMake package: look for its parts.
if(PCL_SHAPE_WITH_HIGHWAY)
  find_path(PCL_SHAPE_HWY_INCLUDE_DIR hwy/highway.h)
  find_library(PCL_SHAPE_HWY_LIBRARY hwy)
  mark_as_advanced(PCL_SHAPE_HWY_INCLUDE_DIR PCL_SHAPE_HWY_LIBRARY)
  if(NOT PCL_SHAPE_HWY_INCLUDE_DIR OR NOT PCL_SHAPE_HWY_LIBRARY)
    message(FATAL_ERROR "Google Highway (libhwy-dev) was not found: install it, or configure with "
                        "-DPCL_SHAPE_WITH_HIGHWAY=OFF for the portable kernels")
  endif()
endif()
