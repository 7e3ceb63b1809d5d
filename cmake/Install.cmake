include(CMakePackageConfigHelpers)

set(PCL_SHAPE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_shape)

install(TARGETS pcl_shape EXPORT pcl_shapeTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/pcl ${PCL_SHAPE_GENERATED_INCLUDE_DIR}/pcl
  DESTINATION ${PCL_SHAPE_INSTALL_INCLUDE_DIR})
install(EXPORT pcl_shapeTargets NAMESPACE pcl_shape:: DESTINATION ${PCL_SHAPE_PACKAGE_DIR})

configure_package_config_file(cmake/pcl_shapeConfig.cmake.in
  ${PROJECT_BINARY_DIR}/pcl_shapeConfig.cmake
  INSTALL_DESTINATION ${PCL_SHAPE_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pcl_shapeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pcl_shapeConfig.cmake
              ${PROJECT_BINARY_DIR}/pcl_shapeConfigVersion.cmake
  DESTINATION ${PCL_SHAPE_PACKAGE_DIR})
