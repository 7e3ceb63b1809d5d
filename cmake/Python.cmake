# Python and pybind11, for the module and its tests. Choose one with -DPython_EXECUTABLE.
if(PCL_SHAPE_BUILD_PYTHON)
  set(PYBIND11_FINDPYTHON ON)
  find_package(Python 3.8 REQUIRED COMPONENTS Interpreter Development.Module)
  find_package(pybind11 2.9 CONFIG REQUIRED)
endif()
