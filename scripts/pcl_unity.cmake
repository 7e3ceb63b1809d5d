# For CMAKE_PROJECT_INCLUDE of a PCL source tree that is configured with CMAKE_UNITY_BUILD:
# the files that cannot share a translation unit with others of their module.
function(pcl_shape_keep_single directory)
  get_filename_component(directory ${directory} ABSOLUTE BASE_DIR ${CMAKE_SOURCE_DIR})
  list(TRANSFORM ARGN PREPEND ${directory}/)
  set_source_files_properties(${ARGN} DIRECTORY ${directory}
    PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
endfunction()

function(pcl_shape_keep_singles)
  pcl_shape_keep_single(common src/fft/kiss_fft.c src/fft/kiss_fftr.c)
endfunction()
# Only when all directories are known.
cmake_language(DEFER DIRECTORY ${CMAKE_SOURCE_DIR} CALL pcl_shape_keep_singles)
