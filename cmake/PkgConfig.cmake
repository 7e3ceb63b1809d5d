# pcl_shape.pc, for projects that do not use CMake. PCL has such files of its own.
file(RELATIVE_PATH PCL_SHAPE_PC_PREFIX /${CMAKE_INSTALL_LIBDIR}/pkgconfig /)
string(REGEX REPLACE "/$" "" PCL_SHAPE_PC_PREFIX ${PCL_SHAPE_PC_PREFIX})
set(PCL_SHAPE_PC_REQUIRES "eigen3 pcl_common pcl_features pcl_kdtree pcl_sample_consensus pcl_search")
set(PCL_SHAPE_PC_LIBS "")
if(NOT BUILD_SHARED_LIBS)
  # What a shared library brings itself.
  set(PCL_SHAPE_PC_LIBS " ${OpenMP_CXX_FLAGS}")
  if(PCL_SHAPE_WITH_HIGHWAY)
    string(APPEND PCL_SHAPE_PC_REQUIRES " libhwy")
  endif()
endif()
configure_file(cmake/pcl_shape.pc.in ${PROJECT_BINARY_DIR}/pcl_shape.pc @ONLY)
install(FILES ${PROJECT_BINARY_DIR}/pcl_shape.pc DESTINATION ${CMAKE_INSTALL_LIBDIR}/pkgconfig)
