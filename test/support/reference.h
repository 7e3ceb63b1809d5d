// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The paper's method in double and by brute force, to compare the library with.

#pragma once

#include <pcl/features/neighborhood_sweep.h>

#include <Eigen/Core>
#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <tuple>
#include <vector>

namespace pcl {
namespace test {

/** The method as the paper states it, in double and by brute force: what the library is
 * compared with. Slow and short. */

using Found = std::vector<std::uint32_t>;

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

inline Eigen::Vector3d
vectorAt(const XYZView& view, std::size_t i)
{
  return Eigen::Map<const Eigen::Vector3f>(view[i]).cast<double>();
}

/** \brief Squared distance in float, without fused operations. */
inline float
squaredDistance(const float* a, const float* b)
{
  const float dx = a[0] - b[0], dy = a[1] - b[1], dz = a[2] - b[2];
  return (dx * dx + dy * dy) + dz * dz;
}

inline Found
neighborsWithin(const XYZView& surface, const float* query, double radius)
{
  const auto r2 = static_cast<float>(radius * radius);
  Found found;
  for (std::uint32_t j = 0; j < surface.size; ++j)
    if (squaredDistance(surface[j], query) < r2)
      found.push_back(j);
  return found;
}

/** \brief The k nearest finite points; ties go to the smaller index. */
inline Found
neighborsNearest(const XYZView& surface, const float* query, std::size_t k)
{
  std::vector<std::tuple<float, std::uint32_t>> all;
  for (std::uint32_t j = 0; j < surface.size; ++j) {
    const float d2 = squaredDistance(surface[j], query);
    if (!std::isnan(d2))
      all.emplace_back(d2, j);
  }
  std::partial_sort(
      all.begin(), all.begin() + static_cast<std::ptrdiff_t>(k), all.end());
  Found found;
  for (std::size_t i = 0; i < k; ++i)
    found.push_back(std::get<1>(all[i]));
  return found;
}

inline Found
without(Found found, std::size_t own)
{
  found.erase(std::remove(found.begin(), found.end(), own), found.end());
  return found;
}

struct ReferenceNormal {
  Eigen::Vector3d normal = Eigen::Vector3d::Constant(unknown);
  double curvature = unknown;
  double gap = unknown; ///< between the two smallest eigenvalues, over their sum
};

/** \param[in] found the neighbors, the point itself among them */
inline ReferenceNormal
referenceNormal(const XYZView& surface, const Found& found)
{
  if (found.size() < 6)
    return {};
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  for (const std::uint32_t j : found)
    mean += vectorAt(surface, j) / static_cast<double>(found.size());
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  for (const std::uint32_t j : found) {
    const Eigen::Vector3d d = vectorAt(surface, j) - mean;
    covariance += d * d.transpose();
  }
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  const Eigen::Vector3d& l = solver.eigenvalues();
  return {solver.eigenvectors().col(0), l[0] / l.sum(), (l[1] - l[0]) / l.sum()};
}

/** \brief Between lines: in [0, pi/2]. */
inline double
acuteAngle(const Eigen::Vector3d& a, const Eigen::Vector3d& b)
{
  const Eigen::Vector3d u = a.normalized(), v = b.normalized();
  return 2 * std::asin(std::min((u - v).norm(), (u + v).norm()) / 2);
}

struct ReferenceINAD {
  double mu = unknown;
  double sigma = unknown;
};

inline ReferenceINAD
meanAndDeviation(const std::vector<double>& angles)
{
  const auto count = static_cast<double>(angles.size());
  double mean = 0, variance = 0;
  for (const double a : angles)
    mean += a / count;
  for (const double a : angles)
    variance += (a - mean) * (a - mean) / count;
  return {mean, std::sqrt(variance)};
}

/** \param[in] own the normal of the point
 * \param[in] found its neighbors, without the point itself */
inline ReferenceINAD
referenceINAD(const XYZView& normals,
              const Eigen::Vector3d& own,
              const Found& found,
              double outlier_rate)
{
  std::vector<double> angles;
  for (const std::uint32_t j : found) {
    const double angle = acuteAngle(own, vectorAt(normals, j));
    if (!std::isnan(angle))
      angles.push_back(angle);
  }
  if (angles.size() < 5)
    return {};
  const ReferenceINAD all = meanAndDeviation(angles);
  if (outlier_rate == 0 || all.sigma == 0)
    return all;
  std::vector<double> kept;
  for (const double a : angles)
    if (std::abs(a - all.mu) <= outlier_rate * all.sigma * (1 + 1e-5))
      kept.push_back(a);
  return kept.empty() ? all : meanAndDeviation(kept);
}

} // namespace test
} // namespace pcl
