# PCL 1.13's PCLConfig does not find OpenMP; 1.14 and later do.
find_package(OpenMP REQUIRED COMPONENTS CXX)
set(pcl_shape_components common kdtree search features sample_consensus)
if(PCL_SHAPE_BUILD_TESTS OR PCL_SHAPE_BUILD_EXAMPLES OR PCL_SHAPE_BUILD_BENCHMARKS)
  list(APPEND pcl_shape_components io segmentation)
endif()
if(PCL_SHAPE_BUILD_EXAMPLES OR PCL_SHAPE_BUILD_BENCHMARKS)
  list(APPEND pcl_shape_components filters registration)
endif()
if(PCL_SHAPE_BUILD_BENCHMARKS)
  list(APPEND pcl_shape_components keypoints)
endif()
find_package(PCL 1.13 REQUIRED COMPONENTS ${pcl_shape_components})
# For programs with point types of their own: PCL's trees of them are made of FLANN's
# templates, which on Debian call LZ4. FLANN::FLANN brings it.
add_library(pcl_shape_flann INTERFACE)
target_link_libraries(pcl_shape_flann INTERFACE $<TARGET_NAME_IF_EXISTS:FLANN::FLANN>)
find_package(nlohmann_json 3.11 REQUIRED)
find_package(Boost REQUIRED)
find_package(ZLIB REQUIRED) # checksums of tiles
if(PCL_SHAPE_BUILD_APPS AND PCL_SHAPE_WITH_MPI AND NOT PCL_SHAPE_ONLY_DETECTION)
  find_package(MPI QUIET COMPONENTS CXX)
endif()

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
