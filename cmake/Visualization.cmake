# PCL_VISUALIZATION_LIBRARIES for the viewer, if this PCL has them. In a function: a second
# find_package(PCL) may not change what the first one found.
function(pcl_shape_find_visualization)
  find_package(PCL 1.13 QUIET COMPONENTS visualization)
  set(PCL_VISUALIZATION_FOUND ${PCL_VISUALIZATION_FOUND} PARENT_SCOPE)
  set(PCL_VISUALIZATION_LIBRARIES ${PCL_VISUALIZATION_LIBRARIES} PARENT_SCOPE)
endfunction()

if(PCL_SHAPE_WITH_VISUALIZATION)
  pcl_shape_find_visualization()
endif()
if(PCL_VISUALIZATION_FOUND)
  message(STATUS "pcl_shape_viewer: with PCL's visualization")
else()
  set(PCL_VISUALIZATION_LIBRARIES "")
  message(STATUS "pcl_shape_viewer: without PCL's visualization; it will only say so")
endif()
