// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The stages from a file to INAD at all its points.

#include "detection/inad_stages.h"

#include "cli/filter_app.h"
#include "cli/pcl_errors.h"
#include "detection/inad_options.h"
#include "detection/unknown.h"

#include <pcl/features/distinct_points.h>
#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/segmentation/impl/shape_detection.hpp>

namespace pcl::app {
namespace {

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
addNormals(CloudFile& file,
           const pcl::PointCloud<pcl::PointXYZ>::ConstPtr& points,
           const INADParameters& parameters,
           unsigned threads)
{
  const pcl::DistinctPoints distinct = pcl::distinctPoints(pcl::detail::xyzOf(*points));
  auto places = points;
  if (distinct.hasRepeats())
    places = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(*points, distinct.first);
  pcl::PointCloud<pcl::Normal>::Ptr normals;
  withPclErrors(file.path, [&] {
    normals = estimateNormals(
        places,
        pcl::detail::withNoiseOfCloud(parameters, pcl::detail::xyzOf(*places), threads),
        threads);
    return normals->size() == places->size();
  });
  setNormals(file,
             distinct.hasRepeats()
                 ? pcl::PointCloud<pcl::Normal>(*normals, distinct.place)
                 : *normals);
}

InadCloud
estimateInad(CloudFile& file,
             const Arguments& arguments,
             const INADParameters& asked,
             Report& report)
{
  const unsigned threads = arguments.threads();
  const auto points = pointsOf(file);
  const INADParameters parameters =
      pcl::detail::withNoiseOfCloud(asked, pcl::detail::xyzOf(*points), threads);
  requireEnoughPoints(parameters, file, *points);
  reportPoints(*points, report);
  reportParameters(parameters, report);
  report.setCount("parameters", "threads", threads);
  report.setFlag("parameters", "use_normals", arguments.has("use_normals"));

  InadCloud cloud{points, nullptr, nullptr};
  if (arguments.has("use_normals"))
    cloud.normals = normalsOf(file);
  else
    withPclErrors(file.path, [&] {
      cloud.normals = report.time(
          "normals", [&] { return estimateNormals(points, parameters, threads); });
      return cloud.normals->size() == file.size();
    });
  withPclErrors(file.path, [&] {
    cloud.inad =
        report.time("inad", [&] { return estimateAngles(cloud, parameters, threads); });
    return cloud.inad->size() == file.size();
  });
  reportUnknown(file.path, *points, *cloud.inad, parameters, threads, report);
  if (arguments.has("normals"))
    setNormals(file, *cloud.normals);
  return cloud;
}

} // namespace pcl::app
