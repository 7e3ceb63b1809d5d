// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From NumPy's arrays to what the library takes, and back.

#include "arrays.h"

#include <pcl/features/coordinate_offset.h>

#include <cstdio>
#include <cstring>
#include <stdexcept>

namespace pcl::python {
namespace {

std::string
shapeText(const py::array& array)
{
  return py::str(array.attr("shape")).cast<std::string>();
}

std::string
typeText(const py::array& array)
{
  return py::str(array.dtype()).cast<std::string>();
}

template <typename T>
bool
holds(const py::array& array)
{
  return array.dtype().is(py::dtype::of<T>()) ||
         array.dtype().equal(py::dtype::of<T>());
}

void
requireShape(const py::array& array, py::ssize_t columns, const char* name)
{
  if (array.ndim() != 2 || array.shape(1) != columns)
    throw std::invalid_argument(std::string(name) + " has the shape " +
                                shapeText(array) + ": it must be (n, " +
                                std::to_string(columns) + ")");
}

void
requireFloats(const py::array& array, const char* name)
{
  if (!holds<float>(array) && !holds<double>(array))
    throw std::invalid_argument(std::string(name) + " has the type " + typeText(array) +
                                ": it must be float32 or float64");
}

/** The item at a place in memory, which need not be aligned. */
template <typename T>
T
itemAt(const char* place)
{
  T value;
  std::memcpy(&value, place, sizeof(T));
  return value;
}

/** take(row, column, value) for the items of an array (n, columns) of T. */
template <typename T, typename Take>
void
eachItem(const py::array& array, const Take& take)
{
  const char* const begin = static_cast<const char*>(array.data());
  for (py::ssize_t row = 0; row < array.shape(0); ++row)
    for (py::ssize_t column = 0; column < array.shape(1); ++column)
      take(static_cast<std::size_t>(row),
           static_cast<std::size_t>(column),
           itemAt<T>(begin + row * array.strides(0) + column * array.strides(1)));
}

template <typename T>
DoubleXYZ
doublesOf(const py::array& array)
{
  DoubleXYZ points(static_cast<std::size_t>(array.shape(0)));
  eachItem<T>(array, [&](std::size_t row, std::size_t column, T value) {
    points[row][column] = static_cast<double>(value);
  });
  return points;
}

/** Say so if the points were floats too soon. */
void
warnOfRounding(const py::array& array, const char* name)
{
  const DoubleXYZ points = doublesOf<float>(array);
  const double step = destructiveFloatSpacing(points);
  if (step == 0.0)
    return;
  char text[256]; // two numbers of up to 12 characters
  std::snprintf(
      text,
      sizeof(text),
      "%s: float32 holds these coordinates in steps of %.3g, while the points "
      "are about %.3g apart: give float64, or subtract an offset before they "
      "become float32",
      name,
      step,
      coordinateScale(points).spacing);
  if (PyErr_WarnEx(PyExc_RuntimeWarning, text, 1) != 0)
    throw py::error_already_set();
}

template <typename T, typename Take>
void
eachIndex(const py::array& array, const Take& take)
{
  const char* const begin = static_cast<const char*>(array.data());
  for (py::ssize_t i = 0; i < array.shape(0); ++i)
    take(static_cast<std::size_t>(i), itemAt<T>(begin + i * array.strides(0)));
}

std::vector<std::int32_t>
chosen(const py::array& mask, std::size_t size, const char* name)
{
  if (static_cast<std::size_t>(mask.shape(0)) != size)
    throw std::invalid_argument(
        std::string(name) + " has " + std::to_string(mask.shape(0)) + " booleans for " +
        std::to_string(size) + " points: it must have one for each");
  std::vector<std::int32_t> indices;
  eachIndex<bool>(mask, [&](std::size_t i, bool is_chosen) {
    if (is_chosen)
      indices.push_back(static_cast<std::int32_t>(i));
  });
  return indices;
}

} // namespace

Cloud
cloudWithOffset(const py::array& array, const Offset& offset, const char* name)
{
  requireShape(array, 3, name);
  requireFloats(array, name);
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>();
  points->resize(static_cast<std::size_t>(array.shape(0)));
  const auto take = [&](std::size_t row, std::size_t column, auto value) {
    (*points)[row].data[column] =
        static_cast<float>(static_cast<double>(value) - offset[column]);
  };
  if (holds<float>(array))
    eachItem<float>(array, take);
  else
    eachItem<double>(array, take);
  points->is_dense = false; // nobody looked
  return {points, offset};
}

Cloud
cloudOf(const py::array& array, const char* name)
{
  requireShape(array, 3, name);
  requireFloats(array, name);
  if (holds<double>(array))
    return cloudWithOffset(array, coordinateOffset(doublesOf<double>(array)), name);
  warnOfRounding(array, name);
  return cloudWithOffset(array, {}, name);
}

std::vector<float>
floatsOf(const py::array& array, py::ssize_t columns, const char* name)
{
  requireShape(array, columns, name);
  requireFloats(array, name);
  const auto width = static_cast<std::size_t>(columns);
  std::vector<float> values(static_cast<std::size_t>(array.shape(0)) * width);
  const auto take = [&](std::size_t row, std::size_t column, auto value) {
    values[row * width + column] = static_cast<float>(value);
  };
  if (holds<float>(array))
    eachItem<float>(array, take);
  else
    eachItem<double>(array, take);
  return values;
}

std::vector<float>
floatsOf(const py::array& array, const char* name)
{
  if (array.ndim() != 1)
    throw std::invalid_argument(std::string(name) + " has the shape " +
                                shapeText(array) + ": it must be (n,)");
  requireFloats(array, name);
  std::vector<float> values(static_cast<std::size_t>(array.shape(0)));
  const auto take = [&](std::size_t i, auto value) {
    values[i] = static_cast<float>(value);
  };
  if (holds<float>(array))
    eachIndex<float>(array, take);
  else
    eachIndex<double>(array, take);
  return values;
}

pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const py::array& array)
{
  const std::vector<float> values = floatsOf(array, 3, "normals");
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  normals->reserve(values.size() / 3);
  for (std::size_t i = 0; i < values.size(); i += 3)
    normals->push_back(pcl::Normal(values[i], values[i + 1], values[i + 2]));
  return normals;
}

std::vector<std::int32_t>
indicesOf(const py::array& array, std::size_t size, const char* name)
{
  if (array.ndim() != 1)
    throw std::invalid_argument(std::string(name) + " has the shape " +
                                shapeText(array) + ": it must be (m,)");
  if (holds<bool>(array))
    return chosen(array, size, name);
  const char kind = array.dtype().kind();
  if (kind != 'i' && kind != 'u')
    throw std::invalid_argument(std::string(name) + " has the type " + typeText(array) +
                                ": it must be of whole numbers or of booleans");
  std::vector<std::int32_t> indices(static_cast<std::size_t>(array.shape(0)));
  const py::array whole = py::array_t<std::int64_t, py::array::forcecast>(array);
  eachIndex<std::int64_t>(whole, [&](std::size_t i, std::int64_t index) {
    if (index < 0 || index >= static_cast<std::int64_t>(size))
      throw std::invalid_argument(std::string(name) + " has " + std::to_string(index) +
                                  ": it must be 0 to " + std::to_string(size) +
                                  " - 1, the number of points");
    indices[i] = static_cast<std::int32_t>(index);
  });
  return indices;
}

Eigen::Vector3f
placeOf(const std::optional<std::array<double, 3>>& given, const Offset& offset)
{
  Eigen::Vector3f place = Eigen::Vector3f::Zero();
  for (int c = 0; given && c < 3; ++c) {
    const auto axis = static_cast<std::size_t>(c);
    place[c] = static_cast<float>((*given)[axis] - offset[axis]);
  }
  return place;
}

void
refuse(const std::string& problem)
{
  if (!problem.empty())
    throw std::invalid_argument(problem);
}

std::size_t
choiceOf(const std::string& value,
         const std::vector<std::string>& allowed,
         const char* name)
{
  std::string names;
  for (std::size_t i = 0; i < allowed.size(); ++i) {
    if (value == allowed[i])
      return i;
    names += (i == 0 ? "" : i + 1 == allowed.size() ? " or " : ", ") + allowed[i];
  }
  throw std::invalid_argument(std::string(name) + " is '" + value + "': it must be " +
                              names);
}

} // namespace pcl::python
