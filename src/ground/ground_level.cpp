// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Heights measured from the plane of the ground instead of the sensor.

#include "ground/ground_level.h"

#include "common/quiet.h"

#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <tuple>

namespace pcl::segmentation {
namespace {

// If a third of the bottoms is ground, one sample of 27 is: none of 200 is one in 2000.
constexpr int max_samples = 200;

/** The lowest point of each cell; of several the one with the smallest x, then y. */
PointCloud<PointXYZ>::Ptr
bottomsOf(const GroundCells& cells)
{
  const auto bottoms = pcl::make_shared<PointCloud<PointXYZ>>();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    const auto at = [&](std::size_t i) {
      return std::make_tuple(cells.z[i], cells.x[i], cells.y[i]);
    };
    std::size_t bottom = cells.begins[cell];
    for (std::size_t i = bottom + 1; i < cells.begins[cell + 1]; ++i)
      bottom = cells.z[i] > cells.z[bottom] || at(i) > at(bottom) ? bottom : i;
    bottoms->emplace_back(cells.x[bottom], cells.y[bottom], cells.z[bottom]);
  }
  return bottoms;
}

} // namespace

bool
level(const GroundParameters& parameters, unsigned threads, GroundCells& cells)
{
  const auto model = pcl::make_shared<SampleConsensusModelPerpendicularPlane<PointXYZ>>(
      bottomsOf(cells));
  model->setAxis(Eigen::Vector3f::UnitZ());
  model->setEpsAngle(parameters.max_slope);
  RandomSampleConsensus<PointXYZ> consensus(model, parameters.max_step);
  consensus.setMaxIterations(max_samples);
  Eigen::VectorXf plane;
  const detail::Quiet quiet;
  if (cells.size() < 4 || !consensus.computeModel())
    return false;
  consensus.getModelCoefficients(plane);
  cells.slope_x = -plane[0] / plane[2];
  cells.slope_y = -plane[1] / plane[2];
  const float height = -plane[3] / plane[2];
  forEachCell(cells, threads, [&](std::size_t cell) {
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i)
      cells.z[i] -= height + cells.slope_x * cells.x[i] + cells.slope_y * cells.y[i];
  });
  return true;
}

} // namespace pcl::segmentation
