include(CMakePackageConfigHelpers)

set(PCL_SHAPE_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/pcl_shape)

install(TARGETS pcl_shape pcl_shape_tiling EXPORT pcl_shapeTargets
  LIBRARY DESTINATION ${CMAKE_INSTALL_LIBDIR}
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
install(DIRECTORY include/pcl ${PROJECT_BINARY_DIR}/include/pcl
  DESTINATION ${PCL_SHAPE_INSTALL_INCLUDE_DIR})
# The library has them inside; these are to look at and to start own ones from.
install(FILES models/edges.json models/surfaces.json DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_shape/models)
install(EXPORT pcl_shapeTargets NAMESPACE pcl_shape:: DESTINATION ${PCL_SHAPE_PACKAGE_DIR})

configure_package_config_file(cmake/pcl_shapeConfig.cmake.in
  ${PROJECT_BINARY_DIR}/pcl_shapeConfig.cmake
  INSTALL_DESTINATION ${PCL_SHAPE_PACKAGE_DIR})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/pcl_shapeConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)
install(FILES ${PROJECT_BINARY_DIR}/pcl_shapeConfig.cmake
              ${PROJECT_BINARY_DIR}/pcl_shapeConfigVersion.cmake
  DESTINATION ${PCL_SHAPE_PACKAGE_DIR})

# The installed applications find the library relative to themselves: the prefix may move.
if(PCL_SHAPE_BUILD_APPS AND BUILD_SHARED_LIBS)
  file(RELATIVE_PATH pcl_shape_lib_from_bin
       /${CMAKE_INSTALL_BINDIR} /${CMAKE_INSTALL_LIBDIR})
  get_property(pcl_shape_app_targets DIRECTORY apps PROPERTY BUILDSYSTEM_TARGETS)
  foreach(target ${pcl_shape_app_targets})
    set_target_properties(${target} PROPERTIES INSTALL_RPATH "$ORIGIN/${pcl_shape_lib_from_bin}")
  endforeach()
endif()

include(cmake/PkgConfig.cmake)
# Where ROS looks for the description of a package.
install(FILES package.xml DESTINATION ${CMAKE_INSTALL_DATADIR}/pcl_shape)
