# PCL_SHAPE_ONLY_DETECTION leaves out what these need, and what other projects may call.
if(NOT PCL_SHAPE_ONLY_DETECTION)
  return()
endif()
if(NOT PROJECT_IS_TOP_LEVEL)
  message(FATAL_ERROR "PCL_SHAPE_ONLY_DETECTION makes a part of the library, which another project cannot "
                      "link: turn it off")
endif()
set(pcl_shape_need_all PCL_SHAPE_BUILD_TESTS PCL_SHAPE_BUILD_BENCHMARKS PCL_SHAPE_BUILD_EXAMPLES
                       PCL_SHAPE_BUILD_PYTHON)
foreach(pcl_shape_option ${pcl_shape_need_all})
  if(NOT ${pcl_shape_option})
    list(REMOVE_ITEM pcl_shape_need_all ${pcl_shape_option})
  endif()
endforeach()
if(pcl_shape_need_all)
  list(JOIN pcl_shape_need_all ", " pcl_shape_need_all)
  message(FATAL_ERROR "PCL_SHAPE_ONLY_DETECTION leaves out what is needed by what is ON: ${pcl_shape_need_all}. "
                      "Turn it off, or these")
endif()
