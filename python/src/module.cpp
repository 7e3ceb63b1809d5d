// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The Python module: its parts, and what becomes of the library's exceptions.

#include "interruptible.h"
#include "parts.h"

#include <pcl/exceptions.h>

namespace py = pybind11;

namespace {

/** PCLException puts ": " before its message. */
const char*
messageOf(const pcl::PCLException& error)
{
  const char* const text = error.what();
  return text[0] == ':' && text[1] == ' ' ? text + 2 : text;
}

} // namespace

PYBIND11_MODULE(_pcl_shape, module)
{
  module.doc() = "The compiled part of pcl_shape.";
  module.attr("__version__") = PCL_SHAPE_VERSION;
  py::register_exception_translator([](std::exception_ptr error) {
    try {
      if (error)
        std::rethrow_exception(error);
    }
    catch (const pcl::PCLException& e) {
      PyErr_SetString(PyExc_ValueError, messageOf(e));
    }
  });
  py::module_::import("atexit").attr("register")(
      py::cpp_function(&pcl::python::waitForCanceled));
  pcl::python::bindModel(module);
  pcl::python::bindSweep(module);
  pcl::python::bindFeatures(module);
  pcl::python::bindField(module);
  pcl::python::bindInstances(module);
  pcl::python::bindGrasps(module);
  pcl::python::bindGround(module);
  pcl::python::bindLabels(module);
}
