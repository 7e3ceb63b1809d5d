# PCL_SHAPE_VIEWER_MAKES_PAGES: whether pcl_shape_viewer has -html. Its page is made of
# apps/viewer/page and of three.js, which npm fetches when CMake configures: a build needs no network.
set(PCL_SHAPE_PAGE_DIR ${PROJECT_BINARY_DIR}/apps/viewer/page)
set(PCL_SHAPE_PAGE_SOURCES ${PROJECT_SOURCE_DIR}/apps/viewer/page)

# pcl_shape_npm_install(<package directory> <directory> <variable>): node_modules of the package's
# lock file in the directory, anew only when that file has changed; the variable says what went wrong.
function(pcl_shape_npm_install package directory problem)
  set(${problem} "" PARENT_SCOPE)
  file(MAKE_DIRECTORY ${directory})
  set_property(DIRECTORY ${PROJECT_SOURCE_DIR} APPEND PROPERTY
    CMAKE_CONFIGURE_DEPENDS ${package}/package-lock.json)
  file(SHA256 ${package}/package-lock.json wanted)
  if(EXISTS ${directory}/installed.sha256)
    file(READ ${directory}/installed.sha256 installed)
    if(installed STREQUAL wanted)
      return()
    endif()
  endif()
  configure_file(${package}/package.json ${directory}/package.json COPYONLY)
  configure_file(${package}/package-lock.json ${directory}/package-lock.json COPYONLY)
  # One retry, as a build may well have no network.
  execute_process(
    COMMAND ${PCL_SHAPE_NPM} ci --ignore-scripts --no-audit --no-fund --fetch-retries=1
            --fetch-retry-mintimeout=1000 --fetch-timeout=60000
    WORKING_DIRECTORY ${directory} RESULT_VARIABLE status OUTPUT_VARIABLE output ERROR_VARIABLE output)
  if(status EQUAL 0)
    file(WRITE ${directory}/installed.sha256 ${wanted})
  else()
    file(WRITE ${directory}/npm.log "${output}")
    set(${problem} "npm could not install (${directory}/npm.log)" PARENT_SCOPE)
  endif()
endfunction()

# The page without a cloud, as a source of the target.
function(pcl_shape_add_page target)
  file(GLOB sources CONFIGURE_DEPENDS ${PCL_SHAPE_PAGE_SOURCES}/src/*)
  list(FILTER sources EXCLUDE REGEX "\\.test\\.js$")
  list(APPEND sources ${PCL_SHAPE_PAGE_SOURCES}/build.mjs ${PCL_SHAPE_PAGE_SOURCES}/page.html)
  set(output ${PCL_SHAPE_PAGE_DIR}/page_template.cpp)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -E copy_directory ${PCL_SHAPE_PAGE_SOURCES} ${PCL_SHAPE_PAGE_DIR}
    COMMAND ${PCL_SHAPE_NODE} build.mjs ${PROJECT_SOURCE_DIR}/LICENSE ${output}
    WORKING_DIRECTORY ${PCL_SHAPE_PAGE_DIR}
    DEPENDS ${sources} ${PROJECT_SOURCE_DIR}/LICENSE ${PCL_SHAPE_PAGE_SOURCES}/package-lock.json
    COMMENT "Page of pcl_shape_viewer -html"
    VERBATIM)
  target_sources(${target} PRIVATE ${output})
endfunction()

find_program(PCL_SHAPE_NODE NAMES node nodejs)
find_program(PCL_SHAPE_NPM npm)
mark_as_advanced(PCL_SHAPE_NODE PCL_SHAPE_NPM)
set(PCL_SHAPE_VIEWER_MAKES_PAGES OFF)
if(PCL_SHAPE_BUILD_APPS)
  if(NOT PCL_SHAPE_WITH_HTML)
    set(pcl_shape_page_problem "PCL_SHAPE_WITH_HTML is OFF")
  elseif(NOT PCL_SHAPE_NODE OR NOT PCL_SHAPE_NPM)
    set(pcl_shape_page_problem "npm was not found")
  else()
    pcl_shape_npm_install(${PCL_SHAPE_PAGE_SOURCES} ${PCL_SHAPE_PAGE_DIR} pcl_shape_page_problem)
  endif()
  if(pcl_shape_page_problem)
    message(STATUS "pcl_shape_viewer: without -html; ${pcl_shape_page_problem}")
  else()
    message(STATUS "pcl_shape_viewer: with -html")
    set(PCL_SHAPE_VIEWER_MAKES_PAGES ON)
  endif()
endif()
