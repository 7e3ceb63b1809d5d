# Run by ctest, with the directories and the compiler of the build; see CMakeLists.txt.

function(run)
  execute_process(COMMAND ${ARGN} RESULT_VARIABLE status)
  if(NOT status EQUAL 0)
    list(JOIN ARGN " " command)
    message(FATAL_ERROR "failed (${status}): ${command}")
  endif()
endfunction()

# No file of the package may name a place that its user has not got.
function(check_contents file)
  file(READ ${file} contents)
  foreach(word ${SOURCE_DIR} ${BUILD_DIR} ${WORK_DIR} pcl_shape_warnings nlohmann_json::
          BUILD_INTERFACE)
    string(FIND "${contents}" "${word}" position)
    if(NOT position EQUAL -1)
      message(FATAL_ERROR "${file} contains '${word}'")
    endif()
  endforeach()
endfunction()

file(REMOVE_RECURSE ${WORK_DIR})
run(${CMAKE_COMMAND} --install ${BUILD_DIR} --config "${CONFIG}" --prefix ${WORK_DIR}/installed)
file(RENAME ${WORK_DIR}/installed ${WORK_DIR}/moved)

file(GLOB_RECURSE package_files ${WORK_DIR}/moved/*.cmake ${WORK_DIR}/moved/*.h
     ${WORK_DIR}/moved/*.hpp ${WORK_DIR}/moved/*.pc)
if(NOT package_files)
  message(FATAL_ERROR "nothing was installed in ${WORK_DIR}/moved")
endif()
foreach(file ${package_files})
  check_contents(${file})
  if(file MATCHES "/include/" AND NOT file MATCHES "/include/pcl_shape-[0-9]+\\.[0-9]+/pcl/")
    message(FATAL_ERROR "${file} is not in the project's own include directory")
  endif()
endforeach()

run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/consumer -G ${GENERATOR}
    -DCMAKE_PREFIX_PATH=${WORK_DIR}/moved -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
    -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
    -DCMAKE_CXX_FLAGS=${CXX_FLAGS} -DCMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON)
run(${CMAKE_COMMAND} --build ${WORK_DIR}/consumer)
run(${CMAKE_COMMAND} -E chdir ${WORK_DIR}/consumer ./consumer model.json)

# A project without CMake: pkg-config alone says how to compile and to link.
find_program(PKG_CONFIG pkg-config)
if(PKG_CONFIG)
  file(GLOB_RECURSE pc_file ${WORK_DIR}/moved/*/pcl_shape.pc)
  get_filename_component(pc_directory "${pc_file}" DIRECTORY)
  set(ENV{PKG_CONFIG_PATH} ${pc_directory})
  execute_process(COMMAND ${PKG_CONFIG} --modversion pcl_shape OUTPUT_VARIABLE version
    OUTPUT_STRIP_TRAILING_WHITESPACE)
  if(NOT version STREQUAL VERSION)
    message(FATAL_ERROR "pkg-config says that pcl_shape has version '${version}', expected ${VERSION}")
  endif()
  execute_process(COMMAND ${PKG_CONFIG} --cflags --libs pcl_shape OUTPUT_VARIABLE flags
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  separate_arguments(flags UNIX_COMMAND "${flags} ${CXX_FLAGS}")
  execute_process(COMMAND ${PKG_CONFIG} --variable=libdir pcl_shape OUTPUT_VARIABLE libdir
    OUTPUT_STRIP_TRAILING_WHITESPACE COMMAND_ERROR_IS_FATAL ANY)
  run(${CXX_COMPILER} -std=c++17 ${CONSUMER_DIR}/consumer.cpp -o ${WORK_DIR}/without_cmake ${flags}
      -Wl,-rpath,${libdir})
  run(${CMAKE_COMMAND} -E chdir ${WORK_DIR} ./without_cmake model.json)
else()
  message(STATUS "pkg-config was not found: pcl_shape.pc is not tested")
endif()

# ROS finds the package by its description, which has the same version.
file(STRINGS ${WORK_DIR}/moved/share/pcl_shape/package.xml described REGEX "<version>${VERSION}</version>")
if(NOT described)
  message(FATAL_ERROR "package.xml is not of version ${VERSION}")
endif()
file(STRINGS ${SOURCE_DIR}/CITATION.cff cited REGEX "^version: ${VERSION}$")
if(NOT cited)
  message(FATAL_ERROR "CITATION.cff is not of version ${VERSION}")
endif()

# Flags that change how Eigen aligns are refused, with a message that says what to do.
if(CMAKE_HOST_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64" AND NOT CXX_FLAGS MATCHES "-mavx|-march")
  run(${CMAKE_COMMAND} -S ${CONSUMER_DIR} -B ${WORK_DIR}/avx2 -G ${GENERATOR}
      -DCMAKE_PREFIX_PATH=${WORK_DIR}/moved -DCMAKE_BUILD_TYPE=${BUILD_TYPE}
      -DCMAKE_C_COMPILER=${C_COMPILER} -DCMAKE_CXX_COMPILER=${CXX_COMPILER}
      "-DCMAKE_CXX_FLAGS=${CXX_FLAGS} -mavx2" -DCMAKE_FIND_PACKAGE_NO_PACKAGE_REGISTRY=ON)
  execute_process(COMMAND ${CMAKE_COMMAND} --build ${WORK_DIR}/avx2
    RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status EQUAL 0 OR NOT output MATCHES "pcl_shape was built with EIGEN_MAX_ALIGN_BYTES")
    message(FATAL_ERROR "a program with -mavx2 was not refused (${status}): ${output}")
  endif()
endif()

# The installed applications find the library where it was moved to.
if(WITH_APPS)
  file(GLOB apps ${WORK_DIR}/moved/bin/pcl_*)
  if(NOT apps)
    message(FATAL_ERROR "no application was installed in ${WORK_DIR}/moved/bin")
  endif()
  foreach(app ${apps})
    run(${CMAKE_COMMAND} -E env --unset=LD_LIBRARY_PATH ${app} --version)
  endforeach()
endif()
