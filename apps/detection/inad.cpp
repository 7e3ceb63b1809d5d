// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// INAD of a cloud: its options, and the stages from the file to all points.

#include "detection/inad.h"

#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/unknown.h"
#include "io/errors.h"

#include <pcl/features/distinct_points.h>
#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/impl/shape_detection.hpp>

#include <algorithm>
#include <limits>
#include <optional>

namespace pcl::app {
namespace {

const std::vector<std::string> scales{
    "fixed", "depth", "density"}; // RadiusMode's order

using Points = pcl::PointCloud<pcl::PointXYZ>;

/** Each place of a cloud once, however many points are there. */
class PlacesOf {
public:
  explicit PlacesOf(const Points::ConstPtr& points)
  : distinct_(pcl::distinctPoints(pcl::detail::xyzOf(*points)))
  , places_(distinct_.hasRepeats() ? pcl::make_shared<Points>(*points, distinct_.first)
                                   : points)
  {}

  const Points::ConstPtr&
  cloud() const
  {
    return places_;
  }

  /** What the places have, for each point. */
  template <typename T>
  typename pcl::PointCloud<T>::ConstPtr
  toPoints(const typename pcl::PointCloud<T>::ConstPtr& of_places) const
  {
    return distinct_.hasRepeats()
               ? pcl::make_shared<pcl::PointCloud<T>>(*of_places, distinct_.place)
               : of_places;
  }

private:
  pcl::DistinctPoints distinct_;
  Points::ConstPtr places_;
};

/** \param[in] points those that count, which may be one for each place
 * \throws InputError if k is above the number of those that are finite */
void
requireEnoughPoints(const INADParameters& parameters,
                    const CloudFile& cloud,
                    const Points& all,
                    const Points& points)
{
  const std::size_t finite = countFinite(all), count = countFinite(points);
  if (parameters.k > 0 && static_cast<std::size_t>(parameters.k) > count)
    throw InputError(cloud.path + ": -k '" + std::to_string(parameters.k) +
                     "': expected 1 to the number of its " +
                     (count < finite
                          ? "distinct points, " + std::to_string(count) + " of "
                          : "finite points, ") +
                     std::to_string(finite));
}

template <typename Estimation>
void
setNeighborhood(Estimation& estimation, double radius, const INADParameters& parameters)
{
  if (parameters.k > 0)
    estimation.setKSearch(parameters.k);
  else
    estimation.setRadiusSearch(radius);
  estimation.setRadiusMode(parameters.radius_mode);
}

pcl::PointCloud<pcl::Normal>::Ptr
estimateNormals(const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
                const INADParameters& parameters,
                unsigned threads)
{
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> estimation(threads);
  estimation.setInputCloud(points);
  setNeighborhood(estimation, parameters.normal_radius, parameters);
  pcl::PointCloud<pcl::Normal>::Ptr normals(new pcl::PointCloud<pcl::Normal>);
  estimation.compute(*normals);
  return normals;
}

pcl::PointCloud<pcl::INAD>::Ptr
estimateAngles(const InadCloud& cloud,
               const INADParameters& parameters,
               unsigned threads)
{
  pcl::INADEstimation<pcl::PointXYZ, pcl::Normal> estimation(threads);
  estimation.setInputCloud(cloud.points);
  estimation.setInputNormals(cloud.normals);
  estimation.setOutlierRate(parameters.outlier_rate);
  setNeighborhood(estimation, parameters.radius, parameters);
  pcl::PointCloud<pcl::INAD>::Ptr inad(new pcl::PointCloud<pcl::INAD>);
  estimation.compute(*inad);
  return inad;
}

} // namespace

void
addInadOptions(CommandLine& command_line, const std::string& condition)
{
  command_line.option("radius", "R", condition + "of the neighborhoods of INAD")
      .option("normal_radius", "R", condition + "of the neighborhoods of the normals")
      .option("scale",
              "S",
              condition + "of the radii: fixed (meters), depth (meters up to\n0.8 m "
                          "away, growing with z), density (local spacings)")
      .option("k", "N", condition + "the nearest N points instead of both radii")
      .option("outlier_rate",
              "C",
              condition + "leave angles out beyond C sigma, 0 for none (2)")
      .flag("use_normals", "take the file's normals instead of estimating them");
}

std::string
nameOfScale(AdaptiveRadius::RadiusMode mode)
{
  return scales[static_cast<std::size_t>(mode)];
}

INADParameters
inadParameters(const Arguments& arguments, const INADParameters& defaults)
{
  arguments.exclude("k", "radius");
  arguments.exclude("k", "normal_radius");
  arguments.exclude("use_normals", "normal_radius");
  arguments.exclude("k", "scale");
  constexpr std::uint64_t most = std::numeric_limits<int>::max();
  const auto radius = arguments.number("radius", positive_length);
  const auto normal_radius = arguments.number("normal_radius", positive_length);
  const auto k = arguments.integer("k", 1, most);
  INADParameters parameters = defaults;
  if (arguments.has("scale"))
    parameters.radius_mode = static_cast<AdaptiveRadius::RadiusMode>(
        std::find(scales.begin(), scales.end(), arguments.choice("scale", scales)) -
        scales.begin());
  parameters.outlier_rate =
      arguments.number("outlier_rate", non_negative).value_or(defaults.outlier_rate);
  if (k) {
    parameters.k = static_cast<int>(*k);
    parameters.radius_mode = AdaptiveRadius::FIXED;
    parameters.radius = 0.0;
    parameters.normal_radius = 0.0;
  }
  else if (radius || normal_radius) {
    if (!radius && defaults.radius <= 0.0)
      throw UsageError("-normal_radius '" + arguments.text("normal_radius") +
                       "' without -radius; expected both, or -radius alone");
    const bool one_radius = defaults.normal_radius == defaults.radius;
    parameters.k = 0;
    parameters.radius = radius.value_or(defaults.radius);
    parameters.normal_radius =
        normal_radius.value_or(one_radius ? parameters.radius : defaults.normal_radius);
  }
  return parameters;
}

void
reportParameters(const INADParameters& parameters, Report& report)
{
  if (parameters.k > 0)
    report.setCount("parameters", "k", static_cast<std::uint64_t>(parameters.k));
  else {
    report.setNumber("parameters", "normal_radius", parameters.normal_radius);
    report.setNumber("parameters", "radius", parameters.radius);
  }
  report.setText("parameters", "scale", nameOfScale(parameters.radius_mode));
  report.setNumber("parameters", "outlier_rate", parameters.outlier_rate);
}

void
addNormals(CloudFile& file,
           const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
           const INADParameters& parameters,
           unsigned threads)
{
  const PlacesOf places(points);
  pcl::PointCloud<pcl::Normal>::Ptr normals;
  withPclErrors(file.path, [&] {
    normals =
        estimateNormals(places.cloud(),
                        pcl::detail::withNoiseOfCloud(
                            parameters, pcl::detail::xyzOf(*places.cloud()), threads),
                        threads);
    return normals->size() == places.cloud()->size();
  });
  setNormals(file, *places.toPoints<pcl::Normal>(normals));
}

InadCloud
estimateInad(CloudFile& file,
             const Arguments& arguments,
             const INADParameters& asked,
             Report& report)
{
  const unsigned threads = arguments.threads();
  const auto points = pointsOf(file);
  const bool has_normals = arguments.has("use_normals");
  // Points at one place may have different normals.
  const std::optional<PlacesOf> places =
      has_normals ? std::nullopt : std::make_optional<PlacesOf>(points);
  InadCloud cloud{has_normals ? Points::ConstPtr(points) : places->cloud(), {}, {}};
  const INADParameters parameters =
      pcl::detail::withNoiseOfCloud(asked, pcl::detail::xyzOf(*cloud.points), threads);
  requireEnoughPoints(parameters, file, *points, *cloud.points);
  reportPoints(*points, report);
  reportParameters(parameters, report);
  report.setCount("parameters", "threads", threads);
  report.setFlag("parameters", "use_normals", has_normals);

  const std::size_t size = cloud.points->size();
  if (has_normals)
    cloud.normals = normalsOf(file);
  else
    withPclErrors(file.path, [&] {
      cloud.normals = report.time("normals", [&] {
        return estimateNormals(cloud.points, parameters, threads);
      });
      return cloud.normals->size() == size;
    });
  withPclErrors(file.path, [&] {
    cloud.inad =
        report.time("inad", [&] { return estimateAngles(cloud, parameters, threads); });
    return cloud.inad->size() == size;
  });
  if (places)
    cloud = {points,
             places->toPoints<pcl::Normal>(cloud.normals),
             places->toPoints<pcl::INAD>(cloud.inad)};
  reportUnknown(file.path, *points, *cloud.inad, parameters, threads, report);
  if (arguments.has("normals"))
    setNormals(file, *cloud.normals);
  return cloud;
}

} // namespace pcl::app
