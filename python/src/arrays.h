// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From NumPy's arrays to what the library takes, and back.

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include <pybind11/numpy.h>

namespace pcl::python {

namespace py = pybind11;

using Offset = std::array<double, 3>;

/** \brief A cloud of the library's own floats, and what was subtracted in double from
 * the coordinates that were given. */
struct Cloud {
  pcl::PointCloud<pcl::PointXYZ>::ConstPtr points;
  Offset offset{};
};

/** \brief Copy an array of shape (n, 3), float32 or float64, of any strides. float64 is
 * brought within the reach of float by the library's pcl::coordinateOffset().
 * \param[in] name of the array, for messages
 * \throws std::invalid_argument for another shape or type */
Cloud cloudOf(const py::array& array, const char* name);

/** \brief The same with an offset that is known. */
Cloud cloudWithOffset(const py::array& array, const Offset& offset, const char* name);

/** \brief Three floats for each row of an array (n, 3), or as many as there are
 * columns. */
std::vector<float>
floatsOf(const py::array& array, py::ssize_t columns, const char* name);

/** \brief One float for each item of an array (n,). */
std::vector<float> floatsOf(const py::array& array, const char* name);

/** \brief A cloud of normals from an array (n, 3). */
pcl::PointCloud<pcl::Normal>::Ptr normalsOf(const py::array& array);

/** \brief Positions from an array of whole numbers, or of booleans of which there is
 * one for each of `size` points. \throws std::invalid_argument for another type, or a
 * position out of range */
std::vector<std::int32_t>
indicesOf(const py::array& array, std::size_t size, const char* name);

/** \brief A place in the coordinates of the user as the library has it. */
Eigen::Vector3f placeOf(const std::optional<std::array<double, 3>>& given,
                        const Offset& offset);

/** \brief An array that is a view of values which `owner` keeps alive; read-only. */
template <typename T>
py::array
viewOf(const T* values,
       const std::vector<py::ssize_t>& shape,
       std::shared_ptr<const void> owner)
{
  auto* const held = new std::shared_ptr<const void>(std::move(owner));
  const py::capsule base(
      held, [](void* p) { delete static_cast<std::shared_ptr<const void>*>(p); });
  py::array array(py::dtype::of<T>(), shape, {}, values, base);
  array.attr("setflags")(py::arg("write") = false);
  return array;
}

/** \brief An array that owns values; writable. */
template <typename T>
py::array
arrayOf(std::vector<T> values, const std::vector<py::ssize_t>& shape)
{
  auto* const held = new std::vector<T>(std::move(values));
  const py::capsule base(held, [](void* p) { delete static_cast<std::vector<T>*>(p); });
  return py::array(py::dtype::of<T>(), shape, {}, held->data(), base);
}

template <typename T>
py::array
arrayOf(std::vector<T> values)
{
  const auto size = static_cast<py::ssize_t>(values.size());
  return arrayOf(std::move(values), {size});
}

/** \brief Refuse what the library found wrong. \throws std::invalid_argument */
void refuse(const std::string& problem);

/** \brief The position of a name among those that are allowed.
 * \throws std::invalid_argument that names them */
std::size_t choiceOf(const std::string& value,
                     const std::vector<std::string>& allowed,
                     const char* name);

} // namespace pcl::python
