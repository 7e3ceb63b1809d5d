# Run by ctest, with the compiler of the build; see CMakeLists.txt.

# A command succeeds, or, if a message is expected, fails with it.
function(expect message)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  string(REGEX REPLACE "[ \n]+" " " written "${output}") # CMake breaks lines
  list(JOIN ARGN " " command)
  if(message STREQUAL "" AND NOT status EQUAL 0)
    message(FATAL_ERROR "failed (${status}): ${command}\n${output}")
  elseif(NOT message STREQUAL "" AND (status EQUAL 0 OR NOT written MATCHES "${message}"))
    message(FATAL_ERROR "expected '${message}' (${status}): ${command}\n${output}")
  endif()
endfunction()

function(configure message source build)
  expect("${message}" ${CMAKE_COMMAND} -S ${source} -B ${WORK_DIR}/${build} -G ${GENERATOR}
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER} -DPCL_DIR=${PCL_DIR}
    -DPCL_SHAPE_WITH_HIGHWAY=${WITH_HIGHWAY} ${ARGN})
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
configure("" ${SOURCE_DIR} detection -DPCL_SHAPE_ONLY_DETECTION=ON)
expect("configure with -DPCL_SHAPE_ONLY_DETECTION=OFF"
  ${CMAKE_COMMAND} --install ${WORK_DIR}/detection --prefix ${WORK_DIR}/installed)
if(EXISTS ${WORK_DIR}/installed)
  message(FATAL_ERROR "a part of the library was installed in ${WORK_DIR}/installed")
endif()
configure("" ${SOURCE_DIR} detection -DPCL_SHAPE_ONLY_DETECTION=ON -DBUILD_SHARED_LIBS=OFF)
configure("is ON: PCL_SHAPE_BUILD_TESTS\\." ${SOURCE_DIR} refused
  -DPCL_SHAPE_ONLY_DETECTION=ON -DPCL_SHAPE_BUILD_TESTS=ON)

# As a part of another project.
file(WRITE ${WORK_DIR}/project/CMakeLists.txt "cmake_minimum_required(VERSION 3.22)
project(other LANGUAGES C CXX)
add_subdirectory(${SOURCE_DIR} pcl_shape)
")
configure("" ${WORK_DIR}/project whole -DBUILD_SHARED_LIBS=OFF)
configure("another project cannot link" ${WORK_DIR}/project part -DPCL_SHAPE_ONLY_DETECTION=ON)
