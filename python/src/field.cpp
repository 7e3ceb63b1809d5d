// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// detect() and ShapeField: edges and surfaces of a cloud.

#include "detection.h"
#include "interruptible.h"
#include "parts.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/segmentation/impl/shape_field_estimation.hpp>

#include <cmath>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

using Estimation = pcl::ShapeFieldEstimation<pcl::PointXYZ>;

/** Tells what is wrong with its settings. */
struct EdgeDetector : pcl::ShapeEdgeDetection<pcl::PointXYZ> {
  using pcl::ShapeDetectionSettings::problemOfModel;
};

void
addEdges(const FieldSettings& settings, EdgeDetector& detector, Detection& detection)
{
  detector.setInputCloud(detection.cloud.points);
  detector.setShapeField(detection.field);
  detector.setNumberOfThreads(settings.threads);
  pcl::Edges edges;
  detector.detect(edges);
  detection.types = std::move(edges.types);
  std::vector<std::vector<float>> likelihoods;
  detector.compute(likelihoods);
  const auto classes = detector.classesOf(likelihoods);
  detection.edges.assign(detection.field->points.size, 0);
  for (const pcl::index_t i : classes.front().indices)
    detection.edges[static_cast<std::size_t>(i)] = 1;
}

void
addSurfaces(Detection& detection)
{
  const std::size_t size = detection.field->points.size;
  const std::size_t classes = detection.field->likelihoods.size();
  detection.surface.assign(size, 0);
  if (classes == 0)
    return;
  pcl::ShapeBackProjection<pcl::PointXYZ> detector;
  detector.setInputCloud(detection.cloud.points);
  detector.setShapeField(detection.field);
  std::vector<std::vector<float>> likelihoods;
  detector.compute(likelihoods);
  const auto members = detector.classesOf(likelihoods);
  detection.likelihoods.resize(size * classes);
  for (std::size_t c = 0; c < classes; ++c) {
    for (const pcl::index_t i : members[c].indices)
      detection.surface[static_cast<std::size_t>(i)] =
          static_cast<std::uint32_t>(c + 1);
    for (std::size_t i = 0; i < size; ++i)
      detection.likelihoods[i * classes + c] = likelihoods[c][i];
  }
}

std::shared_ptr<const Detection>
detected(const Cloud& cloud, const FieldSettings& settings, double threshold)
{
  EdgeDetector detector;
  detector.setThreshold(threshold);
  refuse(detector.problemOfModel());
  const auto detection = std::make_shared<Detection>();
  static_cast<KnownCloud&>(*detection) = knownCloud(cloud, settings);
  addEdges(settings, detector, *detection);
  addSurfaces(*detection);
  return detection;
}

std::shared_ptr<const Detection>
detect(const py::array& points,
       double resolution,
       bool one_resolution,
       double threshold,
       bool edges_only,
       const std::optional<ShapeModel>& edge_model,
       const std::optional<ShapeModel>& surface_model,
       const std::optional<py::array>& normals,
       unsigned threads)
{
  FieldSettings settings{resolution,
                         one_resolution,
                         edges_only,
                         edge_model,
                         surface_model,
                         nullptr,
                         threads};
  if (normals)
    settings.normals = normalsOf(*normals);
  const Cloud cloud = cloudOf(points, "points");
  return interruptibly([=] { return detected(cloud, settings, threshold); });
}

std::shared_ptr<const void>
ownerOf(const std::shared_ptr<const Detection>& detection)
{
  return detection;
}

py::ssize_t
sizeOf(const Detection& detection)
{
  return static_cast<py::ssize_t>(detection.field->points.size);
}

/** A property that is one value for each point. */
template <typename T>
auto
perPoint(const std::vector<T> Detection::*values)
{
  return [values](const std::shared_ptr<const Detection>& d) {
    return viewOf((*d.*values).data(), {sizeOf(*d)}, ownerOf(d));
  };
}

template <typename T>
auto
perPoint(const std::vector<T> pcl::ShapeField::*values)
{
  return [values](const std::shared_ptr<const Detection>& d) {
    return viewOf((*d->field.*values).data(), {sizeOf(*d)}, ownerOf(d));
  };
}

/** A place of the library's in the coordinates of the user. */
void
addPlace(const std::array<float, 3>& place,
         const Offset& offset,
         std::vector<double>& places)
{
  for (std::size_t c = 0; c < 3; ++c)
    places.push_back(static_cast<double>(place[c]) + offset[c]);
}

py::array
creasePoints(const Detection& detection)
{
  std::vector<double> places;
  for (const CreasePoint& crease : detection.field->creases)
    addPlace(crease.position, detection.cloud.offset, places);
  return arrayOf(std::move(places),
                 {static_cast<py::ssize_t>(detection.field->creases.size()), 3});
}

py::array
creaseDirections(const Detection& detection)
{
  std::vector<float> directions;
  for (const CreasePoint& crease : detection.field->creases)
    directions.insert(
        directions.end(), crease.direction.begin(), crease.direction.end());
  return arrayOf(std::move(directions),
                 {static_cast<py::ssize_t>(detection.field->creases.size()), 3});
}

py::array
creaseAngles(const Detection& detection)
{
  std::vector<float> angles;
  for (const CreasePoint& crease : detection.field->creases)
    angles.push_back(crease.angle);
  return arrayOf(std::move(angles));
}

/** A crease line in the coordinates of the user. */
struct Line {
  CreaseLine line;
  Offset offset{};
};

std::vector<Line>
creaseLinesOf(const Detection& detection)
{
  const pcl::ShapeField::ConstPtr field = detection.field;
  std::vector<Line> lines;
  for (CreaseLine& line :
       interruptibly([field] { return creaseLines(field->creases); }))
    lines.push_back({std::move(line), detection.cloud.offset});
  return lines;
}

py::array
pointsOf(const Line& line)
{
  std::vector<double> places;
  for (const auto& point : line.line.points)
    addPlace(point, line.offset, places);
  return arrayOf(std::move(places),
                 {static_cast<py::ssize_t>(line.line.points.size()), 3});
}

void
bindLine(py::module_& module)
{
  py::class_<Line>(module, "CreaseLine", "A crease from one end to the other.")
      .def_property_readonly("points",
                             &pointsOf,
                             "float64 (m, 3), meters: at least two, in order, in the "
                             "coordinates of the input.")
      .def_property_readonly(
          "length", [](const Line& l) { return l.line.length; }, "Meters.")
      .def_property_readonly(
          "angle",
          [](const Line& l) { return l.line.angle; },
          "By which the surface turns, radians, 0 to pi.")
      .def_property_readonly(
          "spacing",
          [](const Line& l) { return l.line.spacing; },
          "Of the points of the cloud there, meters.")
      .def_property_readonly(
          "closed",
          [](const Line& l) { return l.line.closed; },
          "Whether the last point is the first.")
      .def("__repr__", [](const Line& l) {
        return "<CreaseLine: " + std::to_string(l.line.points.size()) + " points, " +
               std::to_string(l.line.length) + " m>";
      });
}

using FieldClass = py::class_<Detection, std::shared_ptr<Detection>>;

void
bindPoints(FieldClass& field)
{
  field
      .def_property_readonly(
          "edges",
          [](const std::shared_ptr<const Detection>& d) {
            return py::array(viewOf(d->edges.data(), {sizeOf(*d)}, ownerOf(d))
                                 .attr("view")(py::dtype::of<bool>()));
          },
          "bool (n,): whether a point is on a crease.")
      .def_property_readonly(
          "edge_type",
          [](const std::shared_ptr<const Detection>& d) {
            static_assert(sizeof(EdgeType) == sizeof(std::uint8_t), "bytes");
            return viewOf(reinterpret_cast<const std::uint8_t*>(d->types.data()),
                          {sizeOf(*d)},
                          ownerOf(d));
          },
          "uint8 (n,): 0 none, 1 crease, 2 corner, 3 open boundary.")
      .def_property_readonly("edge_likelihood",
                             perPoint(&pcl::ShapeField::edge_likelihood),
                             "float32 (n,), 0 to 1; NaN unknown.")
      .def_property_readonly(
          "surface",
          perPoint(&Detection::surface),
          "uint32 (n,): 0 unknown, else 1 + the position in `classes` "
          "of the likeliest; 1 planar, 2 curved without a model.")
      .def_property_readonly(
          "likelihoods",
          [](const std::shared_ptr<const Detection>& d) {
            return viewOf(
                d->likelihoods.data(),
                {sizeOf(*d), static_cast<py::ssize_t>(d->field->likelihoods.size())},
                ownerOf(d));
          },
          "float32 (n, c): the posterior of each of `classes`; NaN unknown.")
      .def_property_readonly(
          "normals",
          [](const std::shared_ptr<const Detection>& d) {
            static_assert(sizeof(Eigen::Vector3f) == 3 * sizeof(float), "rows of 3");
            return viewOf(reinterpret_cast<const float*>(d->field->normals.data()),
                          {sizeOf(*d), 3},
                          ownerOf(d));
          },
          "float32 (n, 3): unit, towards the origin of the library's coordinates (see "
          "`offset`); NaN unknown.")
      .def_property_readonly("spacing",
                             perPoint(&pcl::ShapeField::spacings),
                             "float32 (n,), meters: the local distance between points "
                             "that neighborhoods follow; NaN unknown.");
}

void
bindCloud(FieldClass& field)
{
  field
      .def_property_readonly(
          "classes",
          [](const Detection& d) { return d.field->classes; },
          "The names of the classes of surfaces; none with edges_only.")
      .def_property_readonly(
          "noise",
          [](const Detection& d) { return d.field->noise; },
          "Of the cloud, in spacings, 0 to 0.3.")
      .def_property_readonly(
          "resolution",
          [](const Detection& d) { return d.field->resolution; },
          "Meters; 0 for the cloud's own.")
      .def_property_readonly(
          "finest_resolution",
          [](const Detection& d) { return d.field->finest_resolution; },
          "Of its densest zone; less than resolution only if noise grows with spacing.")
      .def_property_readonly(
          "offset",
          [](const Detection& d) {
            return arrayOf(
                std::vector<double>(d.cloud.offset.begin(), d.cloud.offset.end()));
          },
          "float64 (3,), meters: what was subtracted from float64 coordinates that are "
          "too large for float32; 0 if nothing was.")
      .def_property_readonly(
          "largest_curved_radius",
          [](const Detection& d) { return largestCurvedRadius(*d.field); },
          "The largest radius of curvature that the default model tells from a plane, "
          "meters; 0 if no spacing is known.")
      .def_property_readonly("crease_points",
                             &creasePoints,
                             "float64 (m, 3), meters: points of creases, in the "
                             "coordinates of the input.")
      .def_property_readonly("crease_directions",
                             &creaseDirections,
                             "float32 (m, 3): of the creases there, unit, of either "
                             "sign.")
      .def_property_readonly("crease_angles",
                             &creaseAngles,
                             "float32 (m,): by which the surface turns there, radians, "
                             "0 to pi.")
      .def(
          "lines",
          &creaseLinesOf,
          "Join the crease points to lines, the longest first; lines of less than five "
          "spacings are left out.")
      .def("__len__", [](const Detection& d) { return d.field->points.size; })
      .def("__repr__", [](const Detection& d) {
        return "<ShapeField of " + std::to_string(d.field->points.size) + " points>";
      });
}

constexpr const char* detect_text =
    R"(Find the edges and the surfaces of a cloud.

Neighborhoods follow the density and the noise: there is no radius to choose.

points: float32 or float64 (n, 3), meters. Points with NaN or infinity are unknown.
resolution: meters between points; work as if none were closer. 0 for the cloud's own;
    a coarser one is taken where points lie on a sensor's steps, see ShapeField.
one_resolution: the same for all of the cloud, also where noise grows with the distances
    between points.
threshold: the edge likelihood above 1 - threshold makes an edge, 0 to 1.
edges_only: leave the classes of surfaces out, which saves half of the time.
edge_model, surface_model: ShapeModel of scale "density" instead of the default ones.
normals: (n, 3), of any length but 0, instead of those that are estimated.
threads: 0 for all cores.

Returns a ShapeField. Raises ValueError with the library's message.)";

} // namespace

KnownCloud
knownCloud(const Cloud& cloud, const FieldSettings& settings)
{
  Estimation estimation;
  estimation.setInputCloud(cloud.points);
  estimation.setResolution(settings.resolution);
  estimation.setOneResolution(settings.one_resolution);
  estimation.setEdgesOnly(settings.edges_only);
  if (settings.edge_model)
    estimation.setEdgeModel(*settings.edge_model);
  if (settings.surface_model)
    estimation.setSurfaceModel(*settings.surface_model);
  if (settings.normals)
    estimation.setInputNormals(settings.normals);
  estimation.setNumberOfThreads(settings.threads);
  refuse(estimation.findProblem());
  const auto field = pcl::make_shared<pcl::ShapeField>();
  estimation.compute(*field);
  return {cloud, field};
}

Subject::Subject(const py::object& points, const FieldSettings& settings)
: settings_(settings)
{
  if (py::isinstance<Detection>(points))
    detection_ = points.cast<std::shared_ptr<Detection>>();
  else if (py::isinstance<py::array>(points))
    cloud_ = cloudOf(points.cast<py::array>(), "points");
  else
    throw py::type_error("points must be a ShapeField or an array of the shape (n, 3)");
}

std::vector<std::string>
Subject::classes() const
{
  if (detection_)
    return detection_->field->classes;
  return detail::classNames(settings_.surface_model ? *settings_.surface_model
                                                    : ShapeModel::defaultSurfaces());
}

KnownCloud
Subject::known() const
{
  if (detection_)
    return *detection_;
  return knownCloud(cloud_, settings_);
}

void
bindField(py::module_& module)
{
  bindLine(module);
  FieldClass field(module,
                   "ShapeField",
                   "What is known of a cloud of n points: see detect().\n\nArrays are "
                   "read-only views, in the order of the points.");
  bindPoints(field);
  bindCloud(field);
  module.def("detect",
             &detect,
             py::arg("points"),
             py::kw_only(),
             py::arg("resolution") = 0.0,
             py::arg("one_resolution") = false,
             py::arg("threshold") = 0.5,
             py::arg("edges_only") = false,
             py::arg("edge_model") = py::none(),
             py::arg("surface_model") = py::none(),
             py::arg("normals") = py::none(),
             py::arg("threads") = 0,
             detect_text);
}

} // namespace pcl::python
