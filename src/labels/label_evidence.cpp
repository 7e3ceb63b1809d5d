// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/finite.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "edges/edge_types.h"
#include "geometry/point_grid.h"

#include "labels/label_evidence.h"

#include <algorithm>
#include <cmath>

namespace pcl::detail {
namespace {

using namespace segmentation;
using Eigen::Vector3f;

// Lengths in spacings; doc/labels.md has the reasons.
constexpr float reach = 3.0f;        // of the neighborhood that is looked at
constexpr float near_crease = 1.5f;  // wider than a band without noise
constexpr float wide_crease = 6.0f;  // a crease goes on for some time, an accident not
constexpr float most_margin = 10.0f; // log odds of surfaces
constexpr float least_edge = -4.0f, most_edge = 6.0f; // log odds of edges
constexpr float smallest_turn = 0.05f;                // of normals, about 4 degrees

float
logOdds(float likelihood)
{
  return std::clamp(std::log(likelihood / (1.0f - likelihood)), least_edge, most_edge);
}

/** Of the normals, in spacings, which grows with the noise. */
float
logNormalRadius(double noise)
{
  const INADParameters edges = ShapeModel::defaultEdges().parameters();
  return static_cast<float>(std::log(withNoise(edges, noise).normal_radius));
}

class Evidence {
public:
  explicit Evidence(const LabelInput& input)
  : input_(input)
  , edge_label_(static_cast<std::uint32_t>(input.field.likelihoods.size() + 1))
  , grid_(input.field.points, 2.0f * medianSpacing(input.field.spacings))
  , creases_(positionsOf(input.field.creases),
             2.0f * medianSpacing(input.field.spacings))
  , log_normal_radius_(logNormalRadius(input.field.noise))
  {
    for (std::size_t i = 0; i < input.field.points.size; ++i)
      labels_.push_back(labelAt(i));
  }

  LabelEvidence
  run() const
  {
    LabelEvidence evidence{labels_, std::vector<LabelFeatures>(labels_.size())};
    kernels::parallelForRanges(
        labels_.size(), input_.threads, [&](std::size_t begin, std::size_t end) {
          for (std::size_t i = begin; i < end; ++i)
            if (labels_[i] != 0)
              evidence.features[i] = featuresAt(i);
        });
    return evidence;
  }

private:
  /** What is around a point. */
  struct Around {
    float squared_border = reach * reach; ///< to the nearest point of another kind
    float edge = 0.0f;                    ///< the largest likelihood
    double turn = 0.0;                    ///< sum of 1 - |cosine| of normals
    Eigen::Vector3d offset = Eigen::Vector3d::Zero(); ///< sum, metres
    double points = 0.0, known = 0.0, surfaces = 0.0, same = 0.0;
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

  /** Logarithm of the label's posterior over that of the next best. */
  float
  marginAt(std::size_t i) const
  {
    const std::size_t best = labels_[i] - 1;
    float next = 0.0f;
    for (std::size_t c = 0; c + 1 < edge_label_; ++c)
      if (c != best)
        next = std::max(next, posterior(c, i));
    const float margin = std::log(posterior(best, i) / next);
    return std::min(margin, most_margin);
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
    const float spacing = input_.field.spacings[i];
    grid_.forEachWithin(center, reach * spacing, [&](std::uint32_t j, float squared) {
      around.points += 1.0;
      around.offset += (positionOf(input_.field.points, j) - center).cast<double>();
      if (labels_[j] == 0)
        return;
      around.known += 1.0;
      around.turn += 1.0 - std::abs(normal.dot(normalAt(j)));
      around.edge = std::max(around.edge, input_.field.edge_likelihood[j]);
      around.surfaces += isEdge(j) ? 0.0 : 1.0;
      around.same += labels_[j] == labels_[i] ? 1.0 : 0.0;
      if (isEdge(j) != isEdge(i))
        around.squared_border =
            std::min(around.squared_border, squared / (spacing * spacing));
    });
    return around;
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
    const auto turn = static_cast<float>(std::max(0.0, around.turn / around.known));
    if (isEdge(i))
      return {logCreases(i, near_crease),
              logCreases(i, wide_crease),
              std::log(std::sqrt(turn) + smallest_turn),
              offset,
              log_normal_radius_};
    return {marginAt(i),
            std::sqrt(around.squared_border),
            -logOdds(around.edge),
            -offset,
            static_cast<float>(around.same / around.surfaces)};
  }

  const LabelInput& input_;
  std::uint32_t edge_label_;
  std::vector<std::uint32_t> labels_;
  PointGrid grid_;
  PointGrid creases_;
  float log_normal_radius_;
};

} // namespace

LabelEvidence
labelEvidence(const LabelInput& input)
{
  return Evidence(input).run();
}

} // namespace pcl::detail
