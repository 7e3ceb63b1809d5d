// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How a window of a face bends: a quadric that outliers do not move.

#include "surfaces/face_fit.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

using Eigen::Matrix2d;
using Eigen::Matrix3f;
using Eigen::Vector2d;
using Eigen::Vector3f;
using Vector6d = Eigen::Matrix<double, 6, 1>;

constexpr std::size_t min_nodes = 8; // two more than a quadric has coefficients
constexpr double coefficients = 6.0; // of a quadric
// A quadric can pass through six nodes exactly. Unless more than half are others, the
// median of the residuals tells nothing of them, and those that are off lose all
// weight.
constexpr std::size_t min_nodes_to_weigh = 13;
constexpr int rounds = 3;                // of weights: a fourth moves little
constexpr float biweight_reach = 4.685f; // 95 % efficient for normal noise
constexpr float deviation_of_median = 1.4826f;
constexpr float min_weight = 0.1f; // of a node that counts
// Least pivot of the normal equations, in cells: below it nodes are nearly on a curve.
constexpr double min_pivot = 1e-4;
// In cells: rounding of coordinates.
constexpr float min_residual = 1e-6f;

/** The sums that make the normal equations: of weight * x^i * y^j up to the fourth
 * order, and of the same times z up to the second. */
struct Sums {
  float s00 = 0, s10 = 0, s01 = 0, s20 = 0, s11 = 0, s02 = 0, s30 = 0, s21 = 0, s12 = 0,
        s03 = 0, s40 = 0, s31 = 0, s22 = 0, s13 = 0, s04 = 0;
  float z00 = 0, z10 = 0, z01 = 0, z20 = 0, z11 = 0, z02 = 0;
};

void
addUp(std::size_t count,
      const float* x,
      const float* y,
      const float* z,
      const float* weights,
      Sums& sums)
{
  float s00 = 0, s10 = 0, s01 = 0, s20 = 0, s11 = 0, s02 = 0, s30 = 0, s21 = 0, s12 = 0,
        s03 = 0, s40 = 0, s31 = 0, s22 = 0, s13 = 0, s04 = 0;
  float z00 = 0, z10 = 0, z01 = 0, z20 = 0, z11 = 0, z02 = 0;
#pragma omp simd reduction(+ : s00, s10, s01, s20, s11, s02, s30, s21, s12, s03, s40)   \
    reduction(+ : s31, s22, s13, s04, z00, z10, z01, z20, z11, z02)
  for (std::size_t k = 0; k < count; ++k) {
    const float w = weights[k], wx = w * x[k], wy = w * y[k];
    const float xx = x[k] * x[k], xy = x[k] * y[k], yy = y[k] * y[k];
    s00 += w;
    s10 += wx;
    s01 += wy;
    s20 += w * xx;
    s11 += w * xy;
    s02 += w * yy;
    s30 += wx * xx;
    s21 += wx * xy;
    s12 += wx * yy;
    s03 += wy * yy;
    s40 += w * xx * xx;
    s31 += w * xx * xy;
    s22 += w * xx * yy;
    s13 += w * xy * yy;
    s04 += w * yy * yy;
    z00 += w * z[k];
    z10 += wx * z[k];
    z01 += wy * z[k];
    z20 += w * xx * z[k];
    z11 += w * xy * z[k];
    z02 += w * yy * z[k];
  }
  sums = {s00, s10, s01, s20, s11, s02, s30, s21, s12, s03, s40,
          s31, s22, s13, s04, z00, z10, z01, z20, z11, z02};
}

} // namespace

float
ranked(const std::vector<float>& values, std::size_t rank)
{
  const float* const first = values.data();
  const std::size_t count = values.size();
  // In an unlucky order each is counted, and the time grows with the square.
  constexpr std::size_t max_counted = 256;
  if (count > max_counted) {
    std::vector<float> some = values;
    const auto at = some.begin() + static_cast<std::ptrdiff_t>(rank);
    std::nth_element(some.begin(), at, some.end());
    return *at;
  }
  float low = -1.0f; // the largest value known to be low enough
  float high =
      std::numeric_limits<float>::quiet_NaN(); // the least known to be too high
  for (const float value : values) {
    if (value <= low || value >= high)
      continue;
    int less = 0;
    for (std::size_t k = 0; k < count; ++k)
      less += first[k] < value ? 1 : 0;
    (static_cast<std::size_t>(less) <= rank ? low : high) = value;
    if (static_cast<std::size_t>(less) == rank)
      break;
  }
  return low;
}

void
FaceFitter::place(const std::vector<std::uint32_t>& window)
{
  const FaceNode& center = level_.nodes[window.front()];
  const Vector3f& z = center.normal;
  const Vector3f side = std::abs(z.x()) < 0.7f ? Vector3f::UnitX() : Vector3f::UnitY();
  Matrix3f axes;
  axes.row(0) = side.cross(z).normalized();
  axes.row(1) = z.cross(axes.row(0).transpose());
  axes.row(2) = z;
  for (std::vector<float>* const values : {&x_, &y_, &z_, &residuals_})
    values->resize(window.size());
  for (std::size_t k = 0; k < window.size(); ++k) {
    const Vector3f place =
        axes * (level_.nodes[window[k]].position - center.position) / level_.cell;
    x_[k] = place.x();
    y_[k] = place.y();
    z_[k] = place.z();
  }
}

/** A node of fewer points than others is as much less certain: most are the border of a
 * face, or what a cell cuts off a sheet that noise makes as thick as cells are. */
void
FaceFitter::setShares(const std::vector<std::uint32_t>& window)
{
  float sum = 0.0f;
  for (const std::uint32_t node : window)
    sum += level_.nodes[node].count;
  const float mean = sum / static_cast<float>(window.size());
  shares_.clear();
  for (const std::uint32_t node : window)
    shares_.push_back(std::min(1.0f, level_.nodes[node].count / mean));
}

bool
FaceFitter::solve()
{
  Sums s;
  addUp(x_.size(), x_.data(), y_.data(), z_.data(), weights_.data(), s);
  Eigen::Matrix<float, 6, 6> products;
  products << s.s00, s.s10, s.s01, s.s20, s.s11, s.s02, //
      s.s10, s.s20, s.s11, s.s30, s.s21, s.s12,         //
      s.s01, s.s11, s.s02, s.s21, s.s12, s.s03,         //
      s.s20, s.s30, s.s21, s.s40, s.s31, s.s22,         //
      s.s11, s.s21, s.s12, s.s31, s.s22, s.s13,         //
      s.s02, s.s12, s.s03, s.s22, s.s13, s.s04;
  Vector6d heights;
  heights << s.z00, s.z10, s.z01, s.z20, s.z11, s.z02;
  equations_.compute(products.cast<double>());
  if (!(equations_.vectorD().minCoeff() > min_pivot))
    return false;
  solution_ = equations_.solve(heights);
  const Eigen::Matrix<float, 6, 1> c = solution_.cast<float>();
  const float c0 = c[0], c1 = c[1], c2 = c[2], c3 = c[3], c4 = c[4], c5 = c[5];
  const float *x = x_.data(), *y = y_.data(), *z = z_.data();
  float* residuals = residuals_.data();
  const std::size_t count = x_.size();
#pragma omp simd
  for (std::size_t k = 0; k < count; ++k)
    residuals[k] =
        z[k] - (c0 + x[k] * (c1 + c3 * x[k] + c4 * y[k]) + y[k] * (c2 + c5 * y[k]));
  return true;
}

void
FaceFitter::setWeights()
{
  sizes_.clear();
  for (const float r : residuals_)
    sizes_.push_back(std::abs(r));
  const float middle = ranked(sizes_, sizes_.size() / 2);
  const auto count = static_cast<double>(sizes_.size());
  const auto freedom =
      static_cast<float>(std::sqrt(count / std::max(1.0, count - coefficients)));
  const float deviation = deviation_of_median * freedom * middle;
  const float reach = biweight_reach * std::max(min_residual, deviation);
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const float off = residuals_[k] / reach;
    const float near = std::max(0.0f, 1.0f - off * off);
    weights_[k] = shares_[k] * near * near;
  }
}

/** The covariance of the places in the tangent plane. */
Matrix2d
FaceFitter::spread() const
{
  double weight = 0.0;
  Vector2d mean = Vector2d::Zero();
  Matrix2d products = Matrix2d::Zero();
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    const Vector2d place(x_[k], y_[k]);
    const double w = weights_[k];
    weight += w;
    mean += w * place;
    products += w * place * place.transpose();
  }
  mean /= weight;
  return products / weight - mean * mean.transpose();
}

FaceFit
FaceFitter::describe() const
{
  constexpr double half_widths = 2.0; // deviations of a disc
  double weight = 0.0, squares = 0.0;
  double shares = 0.0, inliers = 0.0;
  for (std::size_t k = 0; k < weights_.size(); ++k) {
    weight += weights_[k];
    squares += static_cast<double>(weights_[k]) * residuals_[k] * residuals_[k];
    const auto share = static_cast<double>(shares_[k]);
    shares += share;
    inliers += weights_[k] > min_weight * shares_[k] ? share : 0.0;
  }
  const Vector6d& c = solution_;
  const double freedom = std::max(1.0, weight - coefficients);
  const double residual =
      std::max(std::sqrt(squares / freedom), static_cast<double>(min_residual));

  // In units of the spread along each direction the largest curvature is the largest
  // bulge, so that a strip does not bulge most across itself, where nodes say little.
  const Matrix2d root =
      Eigen::SelfAdjointEigenSolver<Matrix2d>(spread()).operatorSqrt();
  Matrix2d hessian;
  hessian << 2.0 * c[3], c[4], c[4], 2.0 * c[5];
  const Eigen::SelfAdjointEigenSolver<Matrix2d> bends(root * hessian * root);
  const Vector2d& values = bends.eigenvalues();
  const Eigen::Index most = std::abs(values[0]) > std::abs(values[1]) ? 0 : 1;
  const Vector2d along = half_widths * root * bends.eigenvectors().col(most);

  Vector6d gradient;
  gradient << 0.0, 0.0, 0.0, along.x() * along.x(), along.x() * along.y(),
      along.y() * along.y();
  FaceFit fit;
  const float cell = level_.cell;
  fit.half_width = cell * static_cast<float>(along.norm());
  fit.bulge = cell * static_cast<float>(std::abs(gradient.dot(c)));
  fit.bulge_error =
      cell * static_cast<float>(residual *
                                std::sqrt(gradient.dot(equations_.solve(gradient))));
  fit.residual = cell * static_cast<float>(residual);
  fit.freedom = static_cast<float>(freedom);
  fit.inliers = static_cast<float>(inliers / shares);
  fit.center_offset = cell * static_cast<float>(std::abs(c[0]));
  fit.center_cosine =
      static_cast<float>(1.0 / std::sqrt(1.0 + c[1] * c[1] + c[2] * c[2]));
  return fit;
}

std::optional<FaceFit>
FaceFitter::fit(const std::vector<std::uint32_t>& window)
{
  if (window.size() < min_nodes)
    return std::nullopt;
  place(window);
  setShares(window);
  weights_ = shares_;
  const int rounds_of_window = window.size() < min_nodes_to_weigh ? 1 : rounds;
  for (int round = 0; round < rounds_of_window; ++round) {
    if (round > 0)
      setWeights();
    if (!solve())
      return std::nullopt;
  }
  return describe();
}

std::vector<std::uint32_t>
FaceFitter::nodesOn(const std::vector<std::uint32_t>& window) const
{
  std::vector<std::uint32_t> nodes;
  for (std::size_t k = 0; k < window.size(); ++k)
    if (weights_[k] > min_weight * shares_[k])
      nodes.push_back(window[k]);
  return nodes;
}

} // namespace pcl::segmentation
