// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// normals() and inad(): the features of each point.

#include "interruptible.h"
#include "neighborhoods.h"
#include "parts.h"

#include <pcl/features/normal_3d_sweep.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

const std::vector<std::string> scales = {"fixed", "depth", "density"};

std::string
problemOf(const Cloud& cloud, double radius, int k)
{
  const XYZView points = detail::xyzOf(*cloud.points);
  return detail::problemOf({points, points, nullptr, radius, k});
}

template <typename Estimation>
void
setNeighborhood(Estimation& estimation, double radius, const INADParameters& parameters)
{
  estimation.setKSearch(parameters.k);
  estimation.setRadiusSearch(radius);
  estimation.setRadiusMode(parameters.radius_mode);
}

/** Rows of normals and their curvatures. */
py::tuple
normalArrays(const std::shared_ptr<const NormalCloud>& cloud)
{
  const auto size = static_cast<py::ssize_t>(cloud->size());
  std::vector<float> normals, curvatures;
  for (const pcl::Normal& n : *cloud) {
    normals.insert(normals.end(), {n.normal_x, n.normal_y, n.normal_z});
    curvatures.push_back(n.curvature);
  }
  return py::make_tuple(arrayOf(std::move(normals), {size, 3}),
                        arrayOf(std::move(curvatures)));
}

py::tuple
normals(const py::array& points,
        double radius,
        int k,
        const std::string& scale,
        const std::optional<std::array<double, 3>>& view_point,
        unsigned threads)
{
  const INADParameters parameters = parametersOf(radius, radius, k, 0.0, scale);
  const Cloud cloud = cloudOf(points, "points");
  const Eigen::Vector3f eye = placeOf(view_point, cloud.offset);
  return normalArrays(
      interruptibly([=] { return estimatedNormals(cloud, parameters, eye, threads); }));
}

py::array
inad(const py::array& points,
     double radius,
     int k,
     const std::optional<py::array>& given_normals,
     const std::optional<double>& normal_radius,
     double outlier_rate,
     const std::string& scale,
     unsigned threads)
{
  const INADParameters parameters =
      parametersOf(radius, normal_radius, k, outlier_rate, scale);
  const Cloud cloud = cloudOf(points, "points");
  NormalCloud::ConstPtr normals;
  if (given_normals)
    normals = normalsOf(*given_normals);
  const auto found =
      interruptibly([=] { return estimatedINAD(cloud, normals, parameters, threads); });
  std::vector<float> values;
  for (const pcl::INAD& of_point : *found)
    values.insert(values.end(), {of_point.mu, of_point.sigma});
  return arrayOf(std::move(values), {static_cast<py::ssize_t>(found->size()), 2});
}

constexpr const char* normals_text =
    R"(Estimate normals by principal component analysis.

points: float32 or float64 (n, 3), meters.
radius: of the neighborhoods; or k: the nearest points, the point itself included.
scale: of the radius: "fixed", meters; "depth", meters up to z = 0.8 m, growing with z
    beyond; "density", local spacings.
view_point: (3,), meters, where normals point to; None for the origin of the library's
    coordinates.
threads: 0 for all cores.

Returns (normals, curvature): float32 (n, 3), unit, and float32 (n,), the surface
variation, 0 to 1/3; NaN with fewer than five neighbors. Raises ValueError with the
library's message.)";

constexpr const char* inad_text =
    R"(The inter normal angle difference (INAD): mean and deviation of the angles between
a point's normal and those of its neighbors.

points: float32 or float64 (n, 3), meters.
radius: of the neighborhoods of the angles; or k: the nearest points, for normals too.
normals: (n, 3), of any length but 0 and either sign, instead of those estimated here.
normal_radius: of the neighborhoods of the normals; None for radius.
outlier_rate: angles further than this many deviations from the mean are left out once;
    0 for none.
scale: of the radii, as of normals().
threads: 0 for all cores.

Returns float32 (n, 2): mu and sigma, radians, 0 to pi/2; NaN unknown. Raises ValueError
with the library's message.)";

} // namespace

INADParameters
parametersOf(double radius,
             const std::optional<double>& normal_radius,
             int k,
             double outlier_rate,
             const std::string& scale)
{
  INADParameters parameters;
  parameters.radius = radius;
  parameters.normal_radius = normal_radius.value_or(radius);
  parameters.k = k;
  parameters.outlier_rate = outlier_rate;
  parameters.radius_mode =
      static_cast<AdaptiveRadius::RadiusMode>(choiceOf(scale, scales, "scale"));
  return parameters;
}

std::string
nameOf(AdaptiveRadius::RadiusMode scale)
{
  return scales[static_cast<std::size_t>(scale)];
}

NormalCloud::Ptr
estimatedNormals(const Cloud& cloud,
                 const INADParameters& parameters,
                 const Eigen::Vector3f& view_point,
                 unsigned threads)
{
  refuse(problemOf(cloud, parameters.normal_radius, parameters.k));
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(threads);
  estimation.setInputCloud(cloud.points);
  setNeighborhood(estimation, parameters.normal_radius, parameters);
  estimation.setViewPoint(view_point.x(), view_point.y(), view_point.z());
  const auto normals = pcl::make_shared<NormalCloud>();
  estimation.compute(*normals);
  return normals;
}

pcl::PointCloud<pcl::INAD>::Ptr
estimatedINAD(const Cloud& cloud,
              const NormalCloud::ConstPtr& given_normals,
              const INADParameters& parameters,
              unsigned threads)
{
  refuse(problemOf(cloud, parameters.radius, parameters.k));
  refuse(detail::problemOfOutlierRate(parameters.outlier_rate));
  NormalCloud::ConstPtr normals = given_normals;
  if (normals)
    refuse(detail::problemOfNormals(normals->size(), cloud.points->size()));
  else
    normals = estimatedNormals(cloud, parameters, Eigen::Vector3f::Zero(), threads);
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> estimation(threads);
  estimation.setInputCloud(cloud.points);
  estimation.setInputNormals(normals);
  estimation.setOutlierRate(parameters.outlier_rate);
  setNeighborhood(estimation, parameters.radius, parameters);
  const auto inad = pcl::make_shared<pcl::PointCloud<pcl::INAD>>();
  estimation.compute(*inad);
  return inad;
}

void
bindFeatures(py::module_& module)
{
  module.def("normals",
             &normals,
             py::arg("points"),
             py::kw_only(),
             py::arg("radius") = 0.0,
             py::arg("k") = 0,
             py::arg("scale") = "fixed",
             py::arg("view_point") = py::none(),
             py::arg("threads") = 0,
             normals_text);
  module.def("inad",
             &inad,
             py::arg("points"),
             py::kw_only(),
             py::arg("radius") = 0.0,
             py::arg("k") = 0,
             py::arg("normals") = py::none(),
             py::arg("normal_radius") = py::none(),
             py::arg("outlier_rate") = INADParameters().outlier_rate,
             py::arg("scale") = "fixed",
             py::arg("threads") = 0,
             inad_text);
}

} // namespace pcl::python
