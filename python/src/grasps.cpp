// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// grasps(): places for a suction cup.

#include "detection.h"
#include "interruptible.h"
#include "parts.h"

#include <pcl/segmentation/suction_grasp_estimation.h>
#include <pcl/segmentation/impl/suction_grasp_estimation.hpp>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

/** Tells what is wrong with its input. */
struct Estimation : pcl::SuctionGraspEstimation<pcl::PointXYZ> {
  using pcl::ShapeFieldUser<pcl::PointXYZ>::findFieldProblem;
};

/** A grasp in the coordinates of the user. */
struct Grasp {
  pcl::SuctionGrasp grasp;
  Offset offset{};
};

using Target = std::optional<std::vector<std::int32_t>>;

struct Request {
  Estimation estimation;
  Target target;
  pcl::SuctionCup cup;
  Estimation::Surface surface = Estimation::ANY;
  std::size_t max_grasps = 0;
  Eigen::Vector3f view_point = Eigen::Vector3f::Zero();
  unsigned threads = 0;
};

/** What is wrong with the request for this cloud; empty if nothing is. */
std::string
problemOf(Request& request, const KnownCloud& known)
{
  std::string problem = detail::problemOfCup(request.cup);
  if (problem.empty())
    problem = request.estimation.findFieldProblem();
  if (!problem.empty())
    return problem;
  return detail::problemOf({*known.field,
                            *request.estimation.getIndices(),
                            request.cup,
                            request.surface != Estimation::CURVED,
                            request.surface != Estimation::PLANAR,
                            request.view_point,
                            request.threads});
}

std::vector<Grasp>
found(Request request, const KnownCloud& known)
{
  Estimation& estimation = request.estimation;
  estimation.setInputCloud(known.cloud.points);
  estimation.setShapeField(known.field);
  if (request.target)
    estimation.setIndices(
        pcl::make_shared<pcl::Indices>(request.target->begin(), request.target->end()));
  estimation.setCupRadius(request.cup.radius);
  estimation.setCompliance(request.cup.compliance);
  estimation.setSurface(request.surface);
  estimation.setMaximumGrasps(request.max_grasps);
  estimation.setViewPoint(
      request.view_point.x(), request.view_point.y(), request.view_point.z());
  estimation.setNumberOfThreads(request.threads);
  refuse(problemOf(request, known));
  std::vector<pcl::SuctionGrasp> grasps;
  estimation.compute(grasps);
  std::vector<Grasp> result;
  for (pcl::SuctionGrasp& grasp : grasps)
    result.push_back({std::move(grasp), known.cloud.offset});
  return result;
}

std::vector<Grasp>
grasps(const py::object& points,
       double cup_radius,
       double compliance,
       const std::string& surface,
       std::size_t max_grasps,
       const std::optional<py::array>& target,
       const std::optional<std::array<double, 3>>& view_point,
       double resolution,
       unsigned threads)
{
  FieldSettings settings;
  settings.resolution = resolution;
  settings.threads = threads;
  const Subject subject(points, settings);
  Request request;
  request.cup = {cup_radius, compliance};
  request.surface = static_cast<Estimation::Surface>(
      choiceOf(surface, {"any", "planar", "curved"}, "surface"));
  request.max_grasps = max_grasps;
  request.threads = threads;
  request.view_point = placeOf(view_point, subject.cloud().offset);
  if (target)
    request.target = indicesOf(*target, subject.cloud().points->size(), "target");
  refuse(detail::problemOfCup(request.cup));
  return interruptibly([request, subject] { return found(request, subject.known()); });
}

py::array
positionOf(const Grasp& grasp)
{
  std::vector<double> position;
  for (int c = 0; c < 3; ++c)
    position.push_back(static_cast<double>(grasp.grasp.position[c]) +
                       grasp.offset[static_cast<std::size_t>(c)]);
  return arrayOf(std::move(position));
}

py::array
approachOf(const Grasp& grasp)
{
  const Eigen::Vector3f& a = grasp.grasp.approach;
  return arrayOf(std::vector<float>{a.x(), a.y(), a.z()});
}

std::vector<std::string>
problemsOf(const Grasp& grasp)
{
  std::vector<std::string> names;
  for (const pcl::SealProblem problem : grasp.grasp.problems)
    names.emplace_back(pcl::nameOf(problem));
  return names;
}

template <typename T>
auto
member(T pcl::SuctionGrasp::*value)
{
  return [value](const Grasp& g) { return g.grasp.*value; };
}

constexpr const char* grasps_text =
    R"(Find places for a suction cup, the best first; those that seal come first.

points: a ShapeField, or float32 or float64 (n, 3), meters.
cup_radius: of the lip, meters.
compliance: how far the lip may bend out of its plane, in cup radii, 0 to 1.
surface: "any", "planar" or "curved".
max_grasps: how many at most; 0 for all.
target: bool (n,) or indices (m,) of the points to grasp at; the others are its
    surroundings. None for all.
view_point: (3,), meters, from where the cloud was seen: the side that a cup can reach;
    None for the origin of the library's coordinates.
resolution: as of detect(); not used with a ShapeField.
threads: 0 for all cores.

Returns a list of Grasp. Raises ValueError with the library's message.)";

} // namespace

void
bindGrasps(py::module_& module)
{
  using G = pcl::SuctionGrasp;
  py::class_<Grasp>(module, "Grasp", "A place for a suction cup. Lengths in meters.")
      .def_property_readonly(
          "position",
          &positionOf,
          "float64 (3,), on the surface, in the coordinates of the input.")
      .def_property_readonly(
          "approach", &approachOf, "float32 (3,): unit, into the surface.")
      .def_property_readonly(
          "score", member(&G::score), "0 to 1; above 0.5 if and only if the cup seals.")
      .def_property_readonly(
          "seals", [](const Grasp& g) { return g.grasp.seals(); }, "Whether it seals.")
      .def_property_readonly("problems",
                             &problemsOf,
                             "Why not: \"border\", \"edge\", \"obstacle\", \"bent\", "
                             "\"rough\".")
      .def_property_readonly("surface", member(&G::surface), "1 planar, 2 curved.")
      .def_property_readonly(
          "likelihood", member(&G::likelihood), "Of this class, mean under the cup.")
      .def_property_readonly(
          "covered", member(&G::covered), "Share of the area under the cup.")
      .def_property_readonly("border_distance",
                             member(&G::border_distance),
                             "To where the surface ends, meters.")
      .def_property_readonly("edge_distance",
                             member(&G::edge_distance),
                             "To the nearest edge point, meters.")
      .def_property_readonly("obstacle_distance",
                             member(&G::obstacle_distance),
                             "To the nearest obstacle, across the approach, meters.")
      .def_property_readonly(
          "sag", member(&G::sag), "By which the lip has to bend, meters.")
      .def_property_readonly("residual",
                             member(&G::residual),
                             "Root mean square distance from the surface, meters.")
      .def("__repr__", [](const Grasp& g) {
        return std::string("<Grasp: ") + (g.grasp.seals() ? "seals" : "leaks") +
               ", score " + std::to_string(g.grasp.score) + ">";
      });
  module.def("grasps",
             &grasps,
             py::arg("points"),
             py::kw_only(),
             py::arg("cup_radius") = pcl::SuctionCup().radius,
             py::arg("compliance") = pcl::SuctionCup().compliance,
             py::arg("surface") = "any",
             py::arg("max_grasps") = 0,
             py::arg("target") = py::none(),
             py::arg("view_point") = py::none(),
             py::arg("resolution") = 0.0,
             py::arg("threads") = 0,
             grasps_text);
}

} // namespace pcl::python
