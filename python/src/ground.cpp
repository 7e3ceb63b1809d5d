// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// ground(): the ground in a vehicle's laser scan.

#include "arrays.h"
#include "interruptible.h"
#include "parts.h"

#include <pcl/segmentation/shape_ground_segmentation.h>
#include <pcl/segmentation/impl/shape_ground_segmentation.hpp>

#include <numeric>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

struct Ground {
  std::vector<float> likelihood;
  std::vector<std::uint8_t> ground; ///< 0 or 1
};

struct Request {
  Cloud cloud;
  std::array<float, 3> sensor{};
  GroundParameters parameters;
  unsigned threads = 0;
};

Ground
found(const Request& request)
{
  pcl::Indices all(request.cloud.points->size());
  std::iota(all.begin(), all.end(), 0);
  const detail::GroundQuery query{detail::xyzOf(*request.cloud.points),
                                  all.data(),
                                  all.size(),
                                  request.sensor.data(),
                                  request.threads};
  refuse(detail::problemOf(query, request.parameters));
  Ground result;
  result.likelihood = detail::groundLikelihoods(query, request.parameters);
  for (const float likelihood : result.likelihood)
    result.ground.push_back(likelihood >= request.parameters.threshold ? 1 : 0);
  return result;
}

void
warnWithout(const std::vector<std::uint8_t>& ground)
{
  if (std::accumulate(ground.begin(), ground.end(), std::size_t{0}) == 0 &&
      PyErr_WarnEx(PyExc_RuntimeWarning,
                   "no ground was found: where is up in this cloud?",
                   1) != 0)
    throw py::error_already_set();
}

py::tuple
ground(const py::array& points,
       const std::array<float, 3>& up,
       float max_slope,
       float max_step,
       float threshold,
       float sensor_height,
       const std::optional<std::array<double, 3>>& sensor,
       unsigned threads)
{
  Request request;
  request.cloud = cloudOf(points, "points");
  const Eigen::Vector3f place = placeOf(sensor, request.cloud.offset);
  request.sensor = {place.x(), place.y(), place.z()};
  request.parameters = {Eigen::Vector3f(up[0], up[1], up[2]),
                        max_slope,
                        max_step,
                        threshold,
                        sensor_height};
  request.threads = threads;
  Ground result = interruptibly([request] { return found(request); });
  warnWithout(result.ground);
  return py::make_tuple(
      arrayOf(std::move(result.ground)).attr("view")(py::dtype::of<bool>()),
      arrayOf(std::move(result.likelihood)));
}

constexpr const char* ground_text =
    R"(Find the ground in a vehicle's laser scan: road, pavement, yards.

points: float32 or float64 (n, 3), meters.
up: (3,), where up is, roughly; of any length but 0.
max_slope: the steepest ground against its plane in the large, or up where that is no
    steeper than half of this; radians, below pi / 2.
max_step: the highest curb that ground continues over, meters.
threshold: the likelihood from which a point is ground, 0 to 1.
sensor_height: of the sensor above the ground, meters; 0 if it is not known.
sensor: (3,), meters, where the sensor is; None for the origin of the library's
    coordinates (0, 0, 0, or the offset of large ones).
threads: 0 for all cores.

Returns (ground, likelihood): bool (n,) and float32 (n,), 0 to 1, NaN unknown. Warns if
there is no ground. Raises ValueError with the library's message.)";

} // namespace

void
bindGround(py::module_& module)
{
  const GroundParameters usual;
  module.def("ground",
             &ground,
             py::arg("points"),
             py::kw_only(),
             py::arg("up") = std::array<float, 3>{0.0f, 0.0f, 1.0f},
             py::arg("max_slope") = usual.max_slope,
             py::arg("max_step") = usual.max_step,
             py::arg("threshold") = usual.threshold,
             py::arg("sensor_height") = usual.sensor_height,
             py::arg("sensor") = py::none(),
             py::arg("threads") = 0,
             ground_text);
}

} // namespace pcl::python
