// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What the parts of the module give to each other.

#pragma once

#include <pybind11/pybind11.h>

namespace pcl::python {

void bindModel(pybind11::module_& module);
void bindSweep(pybind11::module_& module);
void bindFeatures(pybind11::module_& module);
void bindField(pybind11::module_& module);
void bindInstances(pybind11::module_& module);
void bindGrasps(pybind11::module_& module);
void bindGround(pybind11::module_& module);
void bindLabels(pybind11::module_& module);

} // namespace pcl::python
