# The target "site": the repository's pages, the tutorials and the reference, as pages with one search.
find_package(Doxygen QUIET)
find_package(Python3 QUIET COMPONENTS Interpreter)
find_program(PCL_SHAPE_SPHINX sphinx-build)
mark_as_advanced(PCL_SHAPE_SPHINX)
set(pcl_shape_site_problem "")
if(NOT DOXYGEN_FOUND)
  set(pcl_shape_site_problem "Doxygen was not found")
elseif(NOT Python3_FOUND OR NOT PCL_SHAPE_SPHINX)
  set(pcl_shape_site_problem "sphinx-build was not found (packages-site.txt)")
endif()
set(pcl_shape_site_directory ${PROJECT_BINARY_DIR}/doc/site)
set(pcl_shape_site ${pcl_shape_site_directory}/html)

if(pcl_shape_site_problem)
  add_custom_target(site
    COMMAND ${CMAKE_COMMAND} -E echo "the site cannot be made: ${pcl_shape_site_problem}"
    COMMAND ${CMAKE_COMMAND} -E false
    VERBATIM)
else()
  configure_file(${PROJECT_SOURCE_DIR}/doc/site/Doxyfile.in ${pcl_shape_site_directory}/Doxyfile @ONLY)
  if(PCL_SHAPE_VIEWER_MAKES_PAGES)
    set(pcl_shape_site_pictures -b $<TARGET_FILE_DIR:pcl_shape_viewer>)
    set(pcl_shape_site_applications pcl_shape_scene pcl_shape_edge_detection pcl_shape_back_projection pcl_shape_instances
                                  pcl_shape_label pcl_shape_viewer)
  endif()
  add_custom_target(site
    COMMAND ${Python3_EXECUTABLE} ${PROJECT_SOURCE_DIR}/doc/site/make_site.py -o ${pcl_shape_site_directory}
            -v ${PROJECT_VERSION} -s ${PCL_SHAPE_SPHINX} -d ${pcl_shape_site_directory}/Doxyfile ${pcl_shape_site_pictures}
    COMMENT "Site in ${pcl_shape_site}"
    VERBATIM)
  if(pcl_shape_site_applications)
    add_dependencies(site ${pcl_shape_site_applications})
  endif()
endif()
