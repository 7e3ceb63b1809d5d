// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels of points, what speaks for them, and how sure they are.

#include "common/finite.h"
#include "common/gathered.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "features/spacing/some_points.h"
#include "geometry/point_grid.h"
#include "labels/label_evidence.h"
#include "labels/label_weights.h"

#include <Eigen/Cholesky>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <utility>

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// Lengths in spacings.
constexpr float reach = 3.0f;       // some 100 neighbors: enough for steady means
constexpr float wide_reach = 6.0f;  // steady fits; not far over small faces
constexpr float near_crease = 1.5f; // wider than a band without noise
constexpr float wide_crease = 6.0f; // a crease goes on for some time, an accident not
// What is beyond these is certain: it does not outweigh all other features.
constexpr float max_margin = 10.0f; // log odds of surfaces
constexpr float min_turn = 0.05f;   // of normals, 4 degrees: keeps the logarithm finite
constexpr float min_rest = 0.02f;   // of normals, 1 degree, likewise
// A turn of normals is fitted to one point in eight, some 50 within the wide reach;
// of small clouds to more.
constexpr std::size_t points_of_sample = 8, min_sample = 20000;
constexpr float same_side = 0.5f; // cosine: the opposite side of a wall turns by more

std::uint32_t
edgeLabel(const LabelInput& input)
{
  return static_cast<std::uint32_t>(input.field.likelihoods.size() + 1);
}

/** Fits normals that turn evenly, as on a smooth surface, to those around a point.
 * Noise, steps and creases leave a rest. Either sign of a normal will do. */
class NormalTurn {
public:
  explicit NormalTurn(const Vector3f& normal) : normal_(normal.cast<double>())
  {
    const Eigen::Vector3d u = normal_.unitOrthogonal();
    axes_.row(0) = u;
    axes_.row(1) = normal_.cross(u);
  }

  void
  add(const Vector3f& offset, const Vector3f& normal)
  {
    const Eigen::Vector3d other = normal.cast<double>();
    const Eigen::Vector2d tilt = axes_ * (other.dot(normal_) < 0.0 ? -other : other);
    const Eigen::Vector2d across = axes_ * offset.cast<double>();
    const Eigen::Vector3d place(1.0, across.x(), across.y());
    places_ += place * place.transpose();
    products_ += place * tilt.transpose();
    squares_ += tilt.squaredNorm();
    count_ += 1.0;
  }

  /** The root mean square of what the fit leaves, in radians where it is small; 0 for
   * fewer points than the fit has unknowns. */
  float
  rest() const
  {
    constexpr double unknowns = 3.0;
    constexpr double ridge = 1e-6; // keeps points on a line solvable
    if (count_ < unknowns)
      return 0.0f;
    const Eigen::Matrix3d places = places_ + ridge * Eigen::Matrix3d::Identity();
    const Eigen::Matrix<double, 3, 2> fit = places.ldlt().solve(products_);
    const double left = squares_ - fit.cwiseProduct(products_).sum();
    return static_cast<float>(std::sqrt(std::max(0.0, left) / count_));
  }

private:
  Eigen::Matrix<double, 2, 3> axes_; ///< across the normal
  Eigen::Vector3d normal_;
  Eigen::Matrix3d places_ = Eigen::Matrix3d::Zero(); ///< sums of products
  Eigen::Matrix<double, 3, 2> products_ = Eigen::Matrix<double, 3, 2>::Zero();
  double squares_ = 0.0;
  double count_ = 0.0;
};

/** Some points of a cloud, to visit those near a place. */
class SomeOfCloud {
public:
  SomeOfCloud(const XYZView& cloud, std::vector<std::uint32_t> indices, float cell)
  : indices_(std::move(indices))
  , grid_(viewOfPositions(positionsAt(cloud, indices_)), cell)
  {}

  /** visit(index in the cloud, squared distance) */
  template <typename Visit>
  void
  forEachWithin(const Vector3f& center, float radius, const Visit& visit) const
  {
    grid_.forEachWithin(center, radius, [&](std::uint32_t k, float squared) {
      visit(indices_[k], squared);
    });
  }

private:
  std::vector<std::uint32_t> indices_;
  PointGrid grid_;
};

class Evidence {
public:
  explicit Evidence(const LabelInput& input)
  : input_(input)
  , edge_label_(edgeLabel(input))
  , labels_(allLabels())
  , spacing_(medianSpacing(input.field.spacings))
  , grid_(input.field.points, 2.0f * spacing_)
  , edges_(input.field.points, edgePoints(), wide_reach * spacing_)
  , faces_(input.field.points, sampleOfFaces(), wide_reach * spacing_)
  , creases_(positionsOf(input.field.creases), 2.0f * spacing_)
  {}

  LabelEvidence
  run() const
  {
    LabelEvidence evidence{labels_, std::vector<LabelFeatures>(labels_.size())};
    kernels::parallelForEach(labels_.size(), input_.threads, [&](std::size_t i) {
      if (labels_[i] != 0)
        evidence.features[i] = featuresAt(i);
    });
    return evidence;
  }

private:
  /** What is around a point. */
  struct Around {
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< sum, meters
    double points = 0.0;
    double turn = 0.0, known = 0.0; ///< of an edge: sum of 1 - |cosine| of normals
  };

  /** What is around a point of a surface, wider. */
  struct Face {
    float squared_edge = wide_reach * wide_reach; ///< to the nearest edge point
    NormalTurn turn;
  };

  float
  posterior(std::size_t c, std::size_t i) const
  {
    return input_.field.likelihoods[c][i];
  }

  bool
  isEdge(std::size_t i) const
  {
    return labels_[i] == edge_label_;
  }

  std::uint32_t
  labelAt(std::size_t i) const
  {
    const float edge = input_.field.edge_likelihood[i];
    if (!kernels::isFinite(input_.field.points[i]) || std::isnan(edge) ||
        std::isnan(posterior(0, i)))
      return 0;
    if (edge > 0.5f)
      return edge_label_;
    std::uint32_t best = 0;
    for (std::uint32_t c = 1; c + 1 < edge_label_; ++c)
      if (posterior(c, i) > posterior(best, i))
        best = c;
    return best + 1;
  }

  std::vector<std::uint32_t>
  allLabels() const
  {
    std::vector<std::uint32_t> labels;
    for (std::size_t i = 0; i < input_.field.points.size; ++i)
      labels.push_back(labelAt(i));
    return labels;
  }

  std::vector<std::uint32_t>
  edgePoints() const
  {
    std::vector<std::uint32_t> edges;
    for (std::uint32_t i = 0; i < labels_.size(); ++i)
      if (isEdge(i))
        edges.push_back(i);
    return edges;
  }

  /** Some of the points on surfaces. */
  std::vector<std::uint32_t>
  sampleOfFaces() const
  {
    const std::size_t count = std::max(labels_.size() / points_of_sample, min_sample);
    std::vector<std::uint32_t> sample;
    for (const pcl::index_t index : somePoints(input_.field.points, count)) {
      const auto i = static_cast<std::uint32_t>(index);
      if (labels_[i] != 0 && !isEdge(i))
        sample.push_back(i);
    }
    return sample;
  }

  /** Logarithm of a surface's posterior at a point over that of the best other one. */
  float
  marginOf(std::uint32_t label, std::size_t i) const
  {
    float next = 0.0f;
    for (std::uint32_t c = 1; c < edge_label_; ++c)
      if (c != label)
        next = std::max(next, posterior(c - 1, i));
    return std::clamp(
        std::log(posterior(label - 1, i) / next), -max_margin, max_margin);
  }

  Vector3f
  normalAt(std::size_t i) const
  {
    return input_.field.normals[i];
  }

  Around
  lookAround(std::size_t i) const
  {
    Around around;
    const Vector3f center = positionOf(input_.field.points, i);
    const Vector3f normal = normalAt(i);
    const float radius = reach * input_.field.spacings[i];
    const bool is_edge = isEdge(i);
    grid_.forEachWithin(center, radius, [&](std::uint32_t j, float) {
      around.points += 1.0;
      around.offset += (positionOf(input_.field.points, j) - center).cast<double>();
      if (!is_edge || labels_[j] == 0)
        return;
      around.known += 1.0;
      around.turn += 1.0 - std::abs(normal.dot(normalAt(j)));
    });
    return around;
  }

  Face
  lookOverFace(std::size_t i) const
  {
    const Vector3f center = positionOf(input_.field.points, i);
    const Vector3f normal = normalAt(i);
    const float spacing = input_.field.spacings[i];
    Face face{wide_reach * wide_reach, NormalTurn(normal)};
    edges_.forEachWithin(
        center, wide_reach * spacing, [&](std::uint32_t, float squared) {
          face.squared_edge =
              std::min(face.squared_edge, squared / (spacing * spacing));
        });
    faces_.forEachWithin(center, wide_reach * spacing, [&](std::uint32_t j, float) {
      if (std::abs(normal.dot(normalAt(j))) > same_side)
        face.turn.add((positionOf(input_.field.points, j) - center) / spacing,
                      normalAt(j));
    });
    return face;
  }

  /** Logarithm of 1 + the crease points around. */
  float
  logCreases(std::size_t i, float spacings) const
  {
    float count = 1.0f;
    creases_.forEachWithin(positionOf(input_.field.points, i),
                           spacings * input_.field.spacings[i],
                           [&](std::uint32_t, float) { count += 1.0f; });
    return std::log(count);
  }

  LabelFeatures
  featuresAt(std::size_t i) const
  {
    const Around around = lookAround(i);
    const auto offset = static_cast<float>(around.offset.norm() / around.points) /
                        input_.field.spacings[i];
    if (isEdge(i)) {
      const auto turn = static_cast<float>(std::max(0.0, around.turn / around.known));
      return {logCreases(i, near_crease),
              logCreases(i, wide_crease),
              std::log(std::sqrt(turn) + min_turn),
              offset,
              0.0f};
    }
    const Face face = lookOverFace(i);
    return {marginOf(labels_[i], i),
            std::sqrt(face.squared_edge),
            -offset,
            -std::log(face.turn.rest() + min_rest),
            labels_[i] == input_.planar_label ? 1.0f : 0.0f};
  }

  const LabelInput& input_;
  std::uint32_t edge_label_;
  std::vector<std::uint32_t> labels_;
  float spacing_; ///< of the cloud
  PointGrid grid_;
  SomeOfCloud edges_, faces_;
  PointGrid creases_;
};

double
probabilityOf(const LabelFeatures& features, const LabelWeights& weights)
{
  double sum = weights.constant;
  for (std::size_t f = 0; f < features.size(); ++f)
    sum += weights.features[f] * static_cast<double>(features[f]);
  return 1.0 / (1.0 + std::exp(-sum));
}

float
confidenceOf(const LabelFeatures& features, bool is_edge)
{
  return static_cast<float>(is_edge ? probabilityOf(features, edge_weights)
                                    : probabilityOf(features, no_edge_weights) *
                                          probabilityOf(features, class_weights));
}

} // namespace

LabelEvidence
labelEvidence(const LabelInput& input)
{
  return Evidence(input).run();
}

PointLabels
labelPoints(const LabelInput& input, double confidence)
{
  LabelEvidence evidence = labelEvidence(input);
  PointLabels result{std::move(evidence.labels), {}};
  result.confidence.resize(result.labels.size(), 0.0f);
  for (std::size_t i = 0; i < result.labels.size(); ++i) {
    if (result.labels[i] == 0)
      continue;
    result.confidence[i] =
        confidenceOf(evidence.features[i], result.labels[i] == edgeLabel(input));
    if (result.confidence[i] < confidence)
      result.labels[i] = 0;
  }
  return result;
}

} // namespace pcl::detail
