# For CMAKE_PROJECT_INCLUDE of a PCL source tree: what makes its build, and that of the pull
# requests in it, shorter.

# Files that cannot share a translation unit with others of their module.
function(pcl_shape_keep_single directory)
  get_filename_component(directory ${directory} ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
  list(TRANSFORM ARGN PREPEND ${directory}/)
  set_source_files_properties(${ARGN} DIRECTORY ${directory}
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

# Precompiled headers where most files are those of the pull requests.
function(pcl_shape_precompile target)
  if(TARGET ${target})
    target_precompile_headers(${target} PRIVATE
      <algorithm> <cmath> <string> <vector> <Eigen/Core> <Eigen/Eigenvalues> <Eigen/Geometry> ${ARGN})
  endif()
endfunction()

function(pcl_shape_build_faster)
  pcl_shape_keep_single(common src/fft/kiss_fft.c src/fft/kiss_fftr.c)
  if(TARGET test_shape_detection)
    pcl_shape_precompile(pcl_segmentation
      <pcl/features/feature.h> <pcl/impl/instantiate.hpp> <pcl/point_types.h>)
    pcl_shape_precompile(test_shape_detection
      <pcl/test/gtest.h> <pcl/point_cloud.h> <pcl/point_types.h> <pcl/search/kdtree.h>)
  endif()
  if(TARGET test_shape_instance_segmentation)
    target_precompile_headers(test_shape_instance_segmentation REUSE_FROM test_shape_detection)
  endif()
endfunction()
# Only when all directories are known.
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL pcl_shape_build_faster)
