# How Eigen aligns with the flags of this build: a header for programs that use the library
# compares it with theirs.
include(CheckCXXSourceCompiles)

function(pcl_shape_find_alignment macro variable)
  find_package(Eigen3 REQUIRED)
  set(CMAKE_REQUIRED_LIBRARIES Eigen3::Eigen)
  set(CMAKE_REQUIRED_QUIET ON)
  set(CMAKE_TRY_COMPILE_CONFIGURATION ${CMAKE_BUILD_TYPE})
  # The flags are part of the names of what is cached: other flags, another search.
  string(MD5 flags "${CMAKE_CXX_FLAGS} ${CMAKE_BUILD_TYPE}")
  foreach(bytes 16 32 64 128 0)
    check_cxx_source_compiles(
      "#include <Eigen/Core>
       static_assert(${macro} == ${bytes}, \"\");
       int main() {}"
      PCL_SHAPE_${macro}_IS_${bytes}_${flags})
    if(PCL_SHAPE_${macro}_IS_${bytes}_${flags})
      set(${variable} ${bytes} PARENT_SCOPE)
      return()
    endif()
  endforeach()
  message(FATAL_ERROR "${macro} is none of 16, 32, 64, 128, 0 with these flags: ${CMAKE_CXX_FLAGS}")
endfunction()

pcl_shape_find_alignment(EIGEN_MAX_ALIGN_BYTES PCL_SHAPE_MAX_ALIGN_BYTES)
pcl_shape_find_alignment(EIGEN_MAX_STATIC_ALIGN_BYTES PCL_SHAPE_MAX_STATIC_ALIGN_BYTES)
configure_file(${CMAKE_CURRENT_LIST_DIR}/pcl_shape_alignment.h.in
               ${PROJECT_BINARY_DIR}/include/pcl/pcl_shape_alignment.h @ONLY)
