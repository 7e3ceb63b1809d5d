// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// instances(): parts and whole objects of a cloud.

#include "detection.h"
#include "interruptible.h"
#include "parts.h"

#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/impl/shape_instance_segmentation.hpp>

#include <cstdint>
#include <type_traits>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

/** Tells what is wrong with its input. */
struct Segmentation : pcl::ShapeInstanceSegmentation<pcl::PointXYZ> {
  using pcl::ShapeFieldUser<pcl::PointXYZ>::findFieldProblem;
};

const std::vector<std::string> primitive_names = {
    "none", "auto", "plane", "cylinder", "sphere"};

/** An instance in the coordinates of the user. */
struct Instance {
  std::shared_ptr<const pcl::ShapeInstance> found;
  Offset offset{};
};

struct Instances {
  std::vector<Instance> instances;
  std::vector<std::string> classes;
  std::size_t points = 0; ///< of the cloud
};

py::array
centroidOf(const Instance& instance)
{
  std::vector<double> centroid;
  for (int c = 0; c < 3; ++c)
    centroid.push_back(static_cast<double>(instance.found->centroid[c]) +
                       instance.offset[static_cast<std::size_t>(c)]);
  return arrayOf(std::move(centroid));
}

/** A primitive's coefficients in the coordinates of the user. */
py::object
coefficientsOf(const Instance& instance)
{
  const pcl::ShapePrimitive& primitive = instance.found->primitive;
  if (primitive.type == PrimitiveType::None)
    return py::none();
  std::vector<double> values(primitive.coefficients.begin(),
                             primitive.coefficients.end());
  for (std::size_t c = 0; c < 3; ++c)
    if (primitive.type == PrimitiveType::Plane)
      values[3] -= values[c] * instance.offset[c];
    else
      values[c] += instance.offset[c];
  return arrayOf(std::move(values));
}

py::array
indicesOf(const Instance& instance)
{
  const pcl::Indices& indices = instance.found->indices;
  // PCL may have indices of another type.
  if constexpr (!std::is_same_v<pcl::index_t, std::int32_t>)
    return arrayOf(std::vector<std::int32_t>(indices.begin(), indices.end()));
  return viewOf(
      indices.data(), {static_cast<py::ssize_t>(indices.size())}, instance.found);
}

py::array
labelsOf(const Instances& instances)
{
  std::vector<std::uint32_t> labels(instances.points, 0);
  for (std::size_t k = 0; k < instances.instances.size(); ++k)
    for (const pcl::index_t i : instances.instances[k].found->indices)
      labels[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(k + 1);
  return arrayOf(std::move(labels));
}

Instances
segmented(Segmentation segmentation, const KnownCloud& known)
{
  segmentation.setInputCloud(known.cloud.points);
  segmentation.setShapeField(known.field);
  refuse(segmentation.findFieldProblem());
  std::vector<pcl::ShapeInstance> found;
  segmentation.segment(found);
  Instances result;
  result.classes = segmentation.getClasses();
  result.points = known.field->points.size;
  for (pcl::ShapeInstance& instance : found)
    result.instances.push_back(
        {std::make_shared<const pcl::ShapeInstance>(std::move(instance)),
         known.cloud.offset});
  return result;
}

Instances
instances(const py::object& points,
          const std::string& of,
          const std::string& primitive,
          std::size_t min_points,
          double high,
          double low,
          const std::optional<std::array<double, 3>>& view_point,
          double resolution,
          const std::optional<ShapeModel>& surface_model,
          unsigned threads)
{
  FieldSettings settings;
  settings.resolution = resolution;
  settings.surface_model = surface_model;
  settings.threads = threads;
  const Subject subject(points, settings);
  Segmentation segmentation;
  segmentation.setClass(of);
  segmentation.setPrimitive(
      static_cast<PrimitiveType>(choiceOf(primitive, primitive_names, "primitive")));
  segmentation.setMinPoints(min_points);
  segmentation.setThresholds(high, low);
  segmentation.setNumberOfThreads(threads);
  refuse(detail::problemOfInstances(subject.classes(), of, segmentation.getLimits()));
  const Eigen::Vector3f eye = placeOf(view_point, subject.cloud().offset);
  segmentation.setViewPoint(eye.x(), eye.y(), eye.z());
  return interruptibly(
      [segmentation, subject] { return segmented(segmentation, subject.known()); });
}

void
bindInstance(py::module_& module)
{
  py::class_<Instance>(module, "Instance", "One instance, and what it is like.")
      .def_property_readonly(
          "indices", &indicesOf, "int32 (m,): of its points, ascending.")
      .def_property_readonly("centroid",
                             &centroidOf,
                             "float64 (3,), meters, in the coordinates of the input.")
      .def_property_readonly(
          "shares",
          [](const Instance& i) { return arrayOf(i.found->shares); },
          "float32 (c,): the share of its points that are of each of the classes.")
      .def_property_readonly(
          "primitive",
          [](const Instance& i) {
            return primitive_names[static_cast<std::size_t>(i.found->primitive.type)];
          },
          "What was fitted: \"plane\", \"cylinder\", \"sphere\" or \"none\".")
      .def_property_readonly(
          "coefficients",
          &coefficientsOf,
          "float64, meters, in the coordinates of the input. Plane: a, b, c, d of ax + "
          "by + cz + d = 0. Cylinder: a point of the axis, its direction, the radius. "
          "Sphere: center, radius. None if nothing was fitted.")
      .def_property_readonly(
          "residual",
          [](const Instance& i) { return i.found->primitive.residual; },
          "Root mean square distance of the points from the primitive, meters.")
      .def("__len__", [](const Instance& i) { return i.found->indices.size(); })
      .def("__repr__", [](const Instance& i) {
        return "<Instance of " + std::to_string(i.found->indices.size()) + " points>";
      });
}

constexpr const char* instances_text =
    R"(Find all instances of a kind of surface, or whole objects.

points: a ShapeField, or float32 or float64 (n, 3), meters.
of: "curved", "planar", a class of the model, or "object".
primitive: what to fit to each: "none", "auto", "plane", "cylinder" or "sphere".
min_points: instances with fewer are left out.
high, low: likelihoods of some and of all points of an instance; not used for objects.
view_point: (3,), meters, from where the points were seen; None for the origin of the
    library's coordinates (0, 0, 0, or the offset of large ones).
resolution, surface_model: as of detect(); not used with a ShapeField.
threads: 0 for all cores.

Returns Instances, the largest first. Raises ValueError with the library's message.)";

} // namespace

void
bindInstances(py::module_& module)
{
  bindInstance(module);
  py::class_<Instances>(
      module, "Instances", "A sequence of Instance, the largest first.")
      .def_property_readonly(
          "labels",
          &labelsOf,
          "uint32 (n,): 0 none, else 1 + the position of the point's instance.")
      .def_readonly("classes", &Instances::classes, "The names of Instance.shares.")
      .def("__len__", [](const Instances& i) { return i.instances.size(); })
      .def("__getitem__", [](const Instances& i, py::ssize_t position) {
        const auto size = static_cast<py::ssize_t>(i.instances.size());
        const py::ssize_t from_begin = position < 0 ? position + size : position;
        if (from_begin < 0 || from_begin >= size)
          throw py::index_error("instance " + std::to_string(position) + " of " +
                                std::to_string(size));
        return i.instances[static_cast<std::size_t>(from_begin)];
      });
  module.def("instances",
             &instances,
             py::arg("points"),
             py::kw_only(),
             py::arg("of") = "curved",
             py::arg("primitive") = "none",
             py::arg("min_points") = InstanceLimits().min_points,
             py::arg("high") = InstanceLimits().high,
             py::arg("low") = InstanceLimits().low,
             py::arg("view_point") = py::none(),
             py::arg("resolution") = 0.0,
             py::arg("surface_model") = py::none(),
             py::arg("threads") = 0,
             instances_text);
}

} // namespace pcl::python
