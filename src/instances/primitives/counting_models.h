// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCL's models of planes, cylinders, spheres and cones, with a faster count of the
// points on them and faster least squares.

#pragma once

#include <pcl/point_types.h>
#include <pcl/sample_consensus/sac_model_cone.h>
#include <pcl/sample_consensus/sac_model_cylinder.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/sample_consensus/sac_model_sphere.h>

#include <algorithm>
#include <cstddef>
#include <vector>

namespace pcl::segmentation {

/** \brief The points of a model, coordinate by coordinate, and the most that were on
 * one of its hypotheses. */
class CountedPoints {
public:
  explicit CountedPoints(const PointCloud<PointXYZ>& points);

  /** \brief The number of points for which is(x, y, z, i). RANSAC only asks whether it
   * is the largest so far: if it cannot be, the count ends early, and is no larger. */
  template <typename Is>
  std::size_t
  countWithIndex(const Is& is) const
  {
    constexpr std::size_t block = 256; // some 50 ns
    std::size_t count = 0;
    for (std::size_t begin = 0; begin < x_.size(); begin += block) {
      if (count + (x_.size() - begin) <= most_)
        return count;
      const std::size_t end = std::min(begin + block, x_.size());
      unsigned of_block = 0;
      for (std::size_t i = begin; i < end; ++i)
        of_block += is(x_[i], y_[i], z_[i], i) ? 1U : 0U;
      count += of_block;
    }
    most_ = std::max(most_, count);
    return count;
  }

  /** \brief Likewise, of is(x, y, z). */
  template <typename Is>
  std::size_t
  count(const Is& is) const
  {
    return countWithIndex(
        [&](float x, float y, float z, std::size_t) { return is(x, y, z); });
  }

private:
  std::vector<float> x_, y_, z_;
  mutable std::size_t most_ = 0;
};

/** \brief A model of PCL's, for clouds without NaN all of whose points count. */
template <typename Model>
class CountingModel : public Model {
public:
  explicit CountingModel(const typename Model::PointCloudConstPtr& points)
  : Model(points)
  , points_(*points)
  {}

  std::size_t countWithinDistance(const Eigen::VectorXf& coefficients,
                                  double threshold) const override;

  void optimizeModelCoefficients(const Indices& inliers,
                                 const Eigen::VectorXf& coefficients,
                                 Eigen::VectorXf& optimized) const override;

private:
  CountedPoints points_;
};

using PlaneModel = CountingModel<SampleConsensusModelPlane<PointXYZ>>;
using SphereModel = CountingModel<SampleConsensusModelSphere<PointXYZ>>;
/** \brief Normals weigh nothing. */
using CylinderModel = CountingModel<SampleConsensusModelCylinder<PointXYZ, Normal>>;
using ConeModel = CountingModel<SampleConsensusModelCone<PointXYZ, Normal>>;

template <>
std::size_t PlaneModel::countWithinDistance(const Eigen::VectorXf&, double) const;

/** \brief A plane that counts the points with its normal only, up to an angle and the
 * sign: not what it cuts through, such as four walls around it. */
class OrientedPlaneModel : public PlaneModel {
public:
  OrientedPlaneModel(const PointCloudConstPtr& points,
                     const pcl::PointCloud<Normal>& normals,
                     float min_cosine);

  std::size_t countWithinDistance(const Eigen::VectorXf& coefficients,
                                  double threshold) const override;

  void selectWithinDistance(const Eigen::VectorXf& coefficients,
                            double threshold,
                            Indices& inliers) override;

private:
  CountedPoints points_;
  std::vector<float> normal_x_, normal_y_, normal_z_;
  float min_cosine_;
};

template <>
std::size_t SphereModel::countWithinDistance(const Eigen::VectorXf&, double) const;
template <>
std::size_t CylinderModel::countWithinDistance(const Eigen::VectorXf&, double) const;
template <>
std::size_t ConeModel::countWithinDistance(const Eigen::VectorXf&, double) const;

} // namespace pcl::segmentation
