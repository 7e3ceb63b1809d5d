# Only what pcl_shape_unite() names: a project around this one must not unite the SIMD kernels.
set(CMAKE_UNITY_BUILD OFF)

# pcl_shape_unite(<target> [APART <files>]): with PCL_SHAPE_UNITY_BUILD the files of a folder are
# one unit. APART: large files, and files that define a name which another file of their folder
# defines, too.
function(pcl_shape_unite target)
  cmake_parse_arguments(ARG "" "" "APART" ${ARGN})
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${PCL_SHAPE_UNITY_BUILD} UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  foreach(source ${ARG_APART})
    # PCL_SHAPE_ONLY_DETECTION leaves out files that are there.
    if(NOT source IN_LIST sources AND
       NOT (PCL_SHAPE_ONLY_DETECTION AND EXISTS ${CMAKE_CURRENT_SOURCE_DIR}/${source}))
      message(FATAL_ERROR "pcl_shape_unite(${target}): '${source}' of APART is none of its sources")
    endif()
  endforeach()
  list(FILTER sources INCLUDE REGEX "^[a-z].*[.]cpp$")
  list(REMOVE_ITEM sources ${ARG_APART} "")
  foreach(source ${sources})
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "unit_${folder}" unit)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
  endforeach()
endfunction()
