# pcl_shape_unite(<target> [APART <files>]): with PCL_SHAPE_UNITY_BUILD the files of a folder are
# one unit. Apart are large ones, and those with names of others in their folder.
function(pcl_shape_unite target)
  cmake_parse_arguments(ARG "" "" "APART" ${ARGN})
  set_target_properties(${target} PROPERTIES
    UNITY_BUILD ${PCL_SHAPE_UNITY_BUILD} UNITY_BUILD_MODE GROUP)
  get_target_property(sources ${target} SOURCES)
  list(FILTER sources INCLUDE REGEX "^[a-z].*[.]cpp$")
  list(REMOVE_ITEM sources ${ARG_APART} "")
  foreach(source ${sources})
    get_filename_component(folder ${source} DIRECTORY)
    string(MAKE_C_IDENTIFIER "unit_${folder}" unit)
    set_source_files_properties(${source} PROPERTIES UNITY_GROUP ${unit})
  endforeach()
endfunction()
