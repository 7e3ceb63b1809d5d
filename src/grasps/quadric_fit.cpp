// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The plane or quadric under a suction cup.

#include "grasps/quadric_fit.h"

#include <Eigen/Dense>

#include <cmath>

namespace pcl::segmentation {
namespace {

using Eigen::Vector3f;
using Moments = Eigen::Matrix<double, 6, 6>;
using Terms = Eigen::Matrix<double, 6, 1>;

// In cup radii: the curvature of noisy points needs more than the cup's own area.
constexpr float fit_radius = 1.5f;
constexpr std::size_t min_points = 12; // twice the unknowns
// Of a plane's variance that a quadric leaves: noise that neighbors share lets it take
// a fifth, a curve that matters takes more.
constexpr double curved_share = 0.7;
constexpr double ridge = 1e-9; // for points on a line
// Twice the noise, whose long waves are not in it, and what a soft lip closes.
constexpr float residual_per_noise = 2.0f, residual_per_radius = 0.05f;
constexpr float band_residuals = 2.0f; // of one point: two standard deviations

/** Sums over points, in units of the fit's radius. */
struct Sums {
  Moments moments = Moments::Zero();
  Terms heights = Terms::Zero();
  double squares = 0.0, spacings = 0.0;
  std::size_t count = 0;

  void
  add(const Vector3f& local, double scale)
  {
    const double x = local.x() / scale, y = local.y() / scale, z = local.z() / scale;
    Terms terms;
    terms << 1.0, x, y, x * x, x * y, y * y;
    moments.noalias() += terms * terms.transpose();
    heights += z * terms;
    squares += z * z;
    ++count;
  }

  /** Coefficients of the first terms; the others are 0. */
  Terms
  solve(Eigen::Index terms) const
  {
    Moments regular = moments;
    regular.diagonal().array() += ridge * static_cast<double>(count);
    Terms solution = Terms::Zero();
    solution.head(terms) =
        regular.topLeftCorner(terms, terms).ldlt().solve(heights.head(terms));
    return solution;
  }

  double
  variance(const Terms& c) const
  {
    const double sum = squares - 2.0 * c.dot(heights) + c.dot(moments * c);
    return std::max(0.0, sum / static_cast<double>(count));
  }
};

Eigen::Matrix3f
frameOf(const Vector3f& normal)
{
  Eigen::Matrix3f axes;
  axes.col(2) = normal;
  axes.col(0) = normal.unitOrthogonal();
  axes.col(1) = normal.cross(axes.col(0));
  return axes;
}

/** Sums over the points near a surface that face its way.
 * \param[in] band how near, meters */
Sums
sumsOf(const TargetSurface& surface, const SurfaceFit& near, float radius, float band)
{
  Sums sums;
  surface.forEachWithin(
      near.origin, std::hypot(radius, radius), [&](std::uint32_t i, float) {
        const auto& point = surface.points()[i];
        const Vector3f local = near.toLocal(point.position);
        const float r2 = local.head<2>().squaredNorm();
        if (r2 < radius * radius &&
            point.normal.dot(near.axes.col(2)) > same_direction &&
            std::abs(local.z() - near.height(local.x(), local.y())) < band) {
          sums.add(local, radius);
          sums.spacings += point.spacing;
        }
      });
  return sums;
}

/** The plane or the quadric of the sums, in the frame of `near`. */
SurfaceFit
solved(const SurfaceFit& near, const Sums& sums, float radius)
{
  const Terms plane = sums.solve(3), quadric = sums.solve(6);
  const double of_plane = sums.variance(plane), of_quadric = sums.variance(quadric);
  SurfaceFit fit = near;
  fit.is_plane = of_quadric >= curved_share * of_plane;
  const Terms& chosen = fit.is_plane ? plane : quadric;
  const float scale[] = {
      radius, 1.0f, 1.0f, 1.0f / radius, 1.0f / radius, 1.0f / radius};
  for (Eigen::Index t = 0; t < 6; ++t)
    fit.coefficients[static_cast<std::size_t>(t)] =
        static_cast<float>(chosen[t]) * scale[t];
  fit.variance =
      static_cast<float>(fit.is_plane ? of_plane : of_quadric) * (radius * radius);
  fit.spacing = static_cast<float>(sums.spacings / static_cast<double>(sums.count));
  return fit;
}

} // namespace

float
SurfaceFit::sag(float radius) const
{
  const float mean = coefficients[3] + coefficients[5];
  const float split = std::hypot(coefficients[3] - coefficients[5], coefficients[4]);
  return radius * radius * std::max(0.5f * (std::abs(mean) + split), split);
}

Tolerance
toleranceOf(float noise, float spacing, float radius)
{
  const float residual =
      residual_per_noise * noise * spacing + residual_per_radius * radius;
  return {residual, band_residuals * residual};
}

std::optional<SurfaceFit>
fitSurface(const TargetSurface& surface,
           const Vector3f& center,
           const Vector3f& normal,
           float radius)
{
  constexpr int rounds = 3; // each with the points near the last fit
  const float reach = fit_radius * radius;
  SurfaceFit fit;
  fit.origin = center;
  fit.axes = frameOf(normal);
  float band = radius;
  for (int round = 0; round < rounds; ++round) {
    const Sums sums = sumsOf(surface, fit, reach, band);
    if (sums.count < min_points)
      return std::nullopt;
    fit = solved(fit, sums, reach);
    band = toleranceOf(surface.noise(), fit.spacing, radius).band;
    if (round + 1 < rounds) {
      const Vector3f up = fit.normal();
      fit.origin = fit.at(0.0f, 0.0f);
      fit.axes = frameOf(up);
      fit.coefficients[0] = fit.coefficients[1] = fit.coefficients[2] = 0.0f;
    }
  }
  fit.origin = fit.at(0.0f, 0.0f);
  fit.coefficients[0] = 0.0f;
  return fit;
}

} // namespace pcl::segmentation
