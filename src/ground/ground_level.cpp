// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Heights measured from the plane of the ground instead of the sensor.

#include "ground/ground_level.h"

#include "common/quiet.h"
#include "ground/ground_patches.h"

#include <pcl/sample_consensus/ransac.h>
#include <pcl/sample_consensus/sac_model_perpendicular_plane.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>

namespace pcl::segmentation {
namespace {

// If a third of the bottoms is ground, one sample of 27 is: none of 200 is one in 2000.
constexpr int max_samples = 200;
// A sensor is in the middle of what it sees, or looks at it from one side: it is nearer
// than a quarter of what it sees is wide. The zero of a map may be anywhere.
constexpr float max_gap = 0.25f;
// Of the bottoms near the best plane, those that a plane below the sensor has at least;
// else what is taken for the sensor is none, such as the zero of a map deep below it.
constexpr double min_below_share = 0.25;
// In steps, by how much ground below the sensor may differ from the height given: the
// plane is that of the ground in the large, beside a vehicle that may stand on a curb.
constexpr float height_steps = 2.0f;

/** Heights that the plane of the ground may have at the sensor. */
struct HeightRange {
  double min = -std::numeric_limits<double>::infinity();
  double max = std::numeric_limits<double>::infinity();
};

HeightRange
heightsBelow(const GroundParameters& parameters)
{
  const double step = parameters.max_step, height = parameters.sensor_height;
  if (height > 0.0)
    return {-height - height_steps * step, -height + height_steps * step};
  // The zero of a vehicle's frame may be on the ground, which is not quite level.
  return {-std::numeric_limits<double>::infinity(), step};
}

/** A plane that is level, but for an angle, passes the sensor at some height, and has
 * little below it: of two levels that hold as much, the lower one carries. */
class GroundPlaneModel : public SampleConsensusModelPerpendicularPlane<PointXYZ> {
public:
  GroundPlaneModel(const pcl::PointCloud<PointXYZ>::ConstPtr& bottoms,
                   float max_tilt,
                   const HeightRange& heights)
  : SampleConsensusModelPerpendicularPlane<PointXYZ>(bottoms)
  , heights_(heights)
  {
    setAxis(Eigen::Vector3f::UnitZ());
    setEpsAngle(max_tilt);
  }

  /** The bottoms near the plane, times the share of all that is not below it. */
  std::size_t
  countWithinDistance(const Eigen::VectorXf& plane,
                      const double distance) const override
  {
    if (!isModelValid(plane))
      return 0;
    const Eigen::Vector4f upward = plane * (plane[2] < 0.0f ? -1.0f : 1.0f);
    const auto limit = static_cast<float>(distance);
    std::size_t near = 0, below = 0;
    for (const PointXYZ& p : *input_) {
      const float above =
          upward[0] * p.x + upward[1] * p.y + upward[2] * p.z + upward[3];
      near += std::abs(above) < limit ? 1U : 0U;
      below += above <= -limit ? 1U : 0U;
    }
    return near * (input_->size() - below) / input_->size();
  }

protected:
  bool
  isModelValid(const Eigen::VectorXf& plane) const override
  {
    if (!SampleConsensusModelPerpendicularPlane<PointXYZ>::isModelValid(plane))
      return false;
    // Along the plane's normal: the sensor may be tilted.
    const double norm = double{plane.head<3>().norm()};
    const double height =
        std::copysign(double{plane[3]} / norm, -double{plane[3]} * double{plane[2]});
    return height >= heights_.min && height <= heights_.max;
  }

private:
  HeightRange heights_;
};

/** Radians: ground may be steep, and the sensor on it tilted as much again, but not by
 * more than 25 degrees. */
float
maxTilt(const GroundParameters& parameters)
{
  constexpr float max_of_sensor = 0.44f;
  constexpr float almost_upright = 1.5f; // the model wants less than a right angle
  return std::min({2.0f * parameters.max_slope,
                   parameters.max_slope + max_of_sensor,
                   almost_upright});
}

struct GroundPlane {
  double slope_x, slope_y, height;
  std::size_t bottoms; ///< near it
  double share;        ///< of all bottoms
};

std::optional<GroundPlane>
planeOf(const PointCloud<PointXYZ>::ConstPtr& bottoms,
        const GroundParameters& parameters,
        const HeightRange& heights)
{
  const auto model =
      pcl::make_shared<GroundPlaneModel>(bottoms, maxTilt(parameters), heights);
  RandomSampleConsensus<PointXYZ> consensus(model, parameters.max_step);
  consensus.setMaxIterations(max_samples);
  const detail::Quiet quiet;
  if (bottoms->size() < 4 || !consensus.computeModel())
    return std::nullopt;
  Eigen::VectorXf plane;
  Indices near;
  consensus.getModelCoefficients(plane);
  consensus.getInliers(near);
  const auto over = [&](int i) { return -double{plane[i]} / double{plane[2]}; };
  const double share =
      static_cast<double>(near.size()) / static_cast<double>(bottoms->size());
  return GroundPlane{over(0), over(1), over(3), near.size(), share};
}

/** Whether the sensor is in the middle of the bottoms, or looks at them from near. */
bool
isSensorNear(const PointCloud<PointXYZ>& bottoms)
{
  Eigen::AlignedBox2f box;
  for (const PointXYZ& p : bottoms)
    box.extend(Eigen::Vector2f(p.x, p.y));
  return box.exteriorDistance(Eigen::Vector2f(0.0f, 0.0f)) <=
         max_gap * box.sizes().norm();
}

/** Whether more points of a cell are above its bottom, as on a wall, than around it.
 * What is ten steps up may hang over the ground. */
bool
isUpright(const GroundCells& cells, std::size_t cell, float bottom, float max_step)
{
  constexpr float max_around = 0.5f, max_above = 10.0f; // steps
  std::uint32_t around = 0, above = 0;
  for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i) {
    const float up = cells.z[i] - bottom;
    const float range = std::sqrt(cells.x[i] * cells.x[i] + cells.y[i] * cells.y[i]);
    // Steep ground rises in a cell, whose depth is a share of the range.
    const bool is_around =
        up < max_around * max_step + static_cast<float>(ground_bend) * range;
    around += is_around ? 1U : 0U;
    above += !is_around && up < max_above * max_step ? 1U : 0U;
  }
  return above > around;
}

/** The lowest point of each cell that is not the side of something; of several the one
 * with the smallest x, then y. */
PointCloud<PointXYZ>::Ptr
bottomsOf(const GroundCells& cells, float max_step)
{
  const auto bottoms = pcl::make_shared<PointCloud<PointXYZ>>();
  for (std::size_t cell = 0; cell < cells.size(); ++cell) {
    if (cells.hangs[cell])
      continue;
    const auto at = [&](std::size_t i) {
      return std::make_tuple(cells.z[i], cells.x[i], cells.y[i]);
    };
    std::size_t bottom = cells.begins[cell];
    for (std::size_t i = bottom + 1; i < cells.begins[cell + 1]; ++i)
      bottom = cells.z[i] > cells.z[bottom] || at(i) > at(bottom) ? bottom : i;
    if (!isUpright(cells, cell, cells.z[bottom], max_step))
      bottoms->emplace_back(cells.x[bottom], cells.y[bottom], cells.z[bottom]);
  }
  return bottoms;
}

/** Whether a plane is above half of the points, as nothing is below the ground, and
 * what is near it above the sensor, as half of tilted ground may be. */
bool
isCeiling(const GroundCells& cells,
          const PointCloud<PointXYZ>& bottoms,
          const GroundPlane& plane,
          float max_step)
{
  const auto above = [&](const auto& x, const auto& y, const auto& z) {
    return z - (plane.height + plane.slope_x * x + plane.slope_y * y);
  };
  constexpr double almost_all = 0.9;
  std::size_t below = 0, near_above_sensor = 0;
  for (std::size_t i = 0; i < cells.z.size(); ++i)
    below += above(cells.x[i], cells.y[i], cells.z[i]) < -max_step ? 1U : 0U;
  for (const PointXYZ& p : bottoms)
    near_above_sensor +=
        p.z > 0.0f && std::abs(above(p.x, p.y, p.z)) < max_step ? 1U : 0U;
  return 2 * below > cells.z.size() &&
         static_cast<double>(near_above_sensor) >
             almost_all * static_cast<double>(plane.bottoms);
}

/** The plane of the ground below the sensor; without what is above it if that is a
 * ceiling. */
std::optional<GroundPlane>
planeBelow(const GroundCells& cells,
           const PointCloud<PointXYZ>::Ptr& bottoms,
           const GroundParameters& parameters)
{
  const auto below = planeOf(bottoms, parameters, heightsBelow(parameters));
  if (!below || !isCeiling(cells, *bottoms, *below, parameters.max_step))
    return below;
  bottoms->erase(std::remove_if(bottoms->begin(),
                                bottoms->end(),
                                [](const PointXYZ& p) { return p.z > 0.0f; }),
                 bottoms->end());
  return planeOf(bottoms, parameters, heightsBelow(parameters));
}

/** The plane of the ground, below the sensor if there is one. */
std::optional<GroundPlane>
groundPlane(const GroundParameters& parameters, GroundCells& cells)
{
  auto bottoms = bottomsOf(cells, parameters.max_step);
  cells.below_sensor =
      cells.around || parameters.sensor_height > 0.0f || isSensorNear(*bottoms);
  if (!cells.below_sensor)
    return planeOf(bottoms, parameters, HeightRange());
  const auto below = planeBelow(cells, bottoms, parameters);
  const auto isEnough = [&](std::size_t best) {
    return below && static_cast<double>(below->bottoms) >=
                        min_below_share * static_cast<double>(best);
  };
  if (parameters.sensor_height > 0.0f || isEnough(bottoms->size()))
    return below;
  // Without a sensor nothing is known to hang.
  std::vector<char> hangs(cells.size(), 0);
  std::swap(hangs, cells.hangs);
  bottoms = bottomsOf(cells, parameters.max_step);
  const auto any = planeOf(bottoms, parameters, HeightRange());
  cells.below_sensor = !any || isEnough(any->bottoms) ||
                       isCeiling(cells, *bottoms, *any, parameters.max_step);
  if (!cells.below_sensor)
    return any;
  std::swap(hangs, cells.hangs);
  return below;
}

} // namespace

double
level(const GroundParameters& parameters, unsigned threads, GroundCells& cells)
{
  const auto plane = groundPlane(parameters, cells);
  if (!plane)
    return 0.0;
  cells.slope_x = static_cast<float>(plane->slope_x);
  cells.slope_y = static_cast<float>(plane->slope_y);
  const auto height = static_cast<float>(plane->height);
  cells.sensor_z = -height;
  forEachCell(cells, threads, [&](std::size_t cell) {
    for (std::size_t i = cells.begins[cell]; i < cells.begins[cell + 1]; ++i)
      cells.z[i] -= height + cells.slope_x * cells.x[i] + cells.slope_y * cells.y[i];
  });
  return plane->share;
}

} // namespace pcl::segmentation
