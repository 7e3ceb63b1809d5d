# LibLZF, for compressed PCD files. It is compiled into the applications, because only
# so can its table be cleared first: otherwise the same points may compress to other
# bytes each time. Words are read at aligned places only, which is defined everywhere.
find_package(liblzf QUIET)
if(NOT TARGET liblzf::embed)
  message(FATAL_ERROR "LibLZF (liblzf-dev) was not found: install it, or configure with "
                      "-DPCL_SHAPE_BUILD_APPS=OFF for the library alone")
endif()
add_library(pcl_shape_lzf STATIC)
target_link_libraries(pcl_shape_lzf PRIVATE liblzf::embed)
target_compile_definitions(pcl_shape_lzf PRIVATE INIT_HTAB=1 STRICT_ALIGN=1)
target_include_directories(pcl_shape_lzf SYSTEM INTERFACE ${liblzf_INCLUDE_DIRS})
