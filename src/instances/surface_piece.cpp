// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "instances/surface_piece.h"

#include "common/disjoint_sets.h"
#include "common/statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr double least_share = 0.1;
constexpr std::size_t most_fitted = 2000;
constexpr double mostly_plane = 0.4;
constexpr double loose = 3.0;

/** About the first, in units of the mean spacing: PCL's fits have limits of their own.
 */
std::vector<SurfaceNode>
normalized(std::vector<SurfaceNode> nodes)
{
  const Eigen::Vector3f origin = nodes.front().center;
  double sum = 0.0;
  for (const SurfaceNode& node : nodes)
    sum += node.spacing;
  const auto unit = static_cast<float>(sum / static_cast<double>(nodes.size()));
  for (SurfaceNode& node : nodes) {
    node.center = (node.center - origin) / unit;
    node.spacing /= unit;
  }
  return nodes;
}

float
medianNoise(const std::vector<SurfaceNode>& nodes)
{
  std::vector<float> noises;
  for (const SurfaceNode& node : nodes)
    noises.push_back(node.noise);
  return median(std::move(noises));
}

} // namespace

SurfacePiece::SurfacePiece(std::vector<SurfaceNode> nodes, float least_noise)
: nodes_(normalized(std::move(nodes)))
, grid_(centersOf(nodes_), around_spacings)
{
  const float noise = std::max(least_noise, medianNoise(nodes_));
  tolerance_ = 0.15f + 0.5f * noise;
  gap_limit_ = 0.15f + 1.25f * noise;
  node_noise_ = 0.05f + 0.5f * noise;
}

NodeIndices
SurfacePiece::nodes() const
{
  NodeIndices all(nodes_.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

std::size_t
SurfacePiece::leastSize() const
{
  const auto share =
      static_cast<std::size_t>(least_share * static_cast<double>(nodes_.size()));
  return std::max(least_nodes, share);
}

bool
SurfacePiece::isOne(const NodeIndices& nodes) const
{
  const ShapePrimitive plane = fitTo(sampleOf(nodes), PrimitiveType::Plane);
  if (plane.type != PrimitiveType::None) {
    const auto size = static_cast<double>(nodes.size());
    const auto inliers = static_cast<double>(inliersOf(plane, nodes).size());
    if (inliers >= all_but_noise * size)
      return true;
    if (inliers > mostly_plane * size)
      return false;
  }
  return residualAsOne(nodes) < tolerance_;
}

float
SurfacePiece::residualAsOne(const NodeIndices& nodes) const
{
  const PrimitiveSample sample = sampleOf(nodes);
  float least = std::numeric_limits<float>::infinity();
  for (const PrimitiveType type : {PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    ShapePrimitive surface = fitTo(sample, type);
    if (surface.type == PrimitiveType::None)
      continue;
    refine(sample, surface);
    least = std::min(least, residualOf(surface, nodes));
  }
  return least < tolerance_ ? least
                            : std::min(least, static_cast<float>(coneResidual(sample)));
}

float
SurfacePiece::residualOf(const ShapePrimitive& surface, const NodeIndices& nodes) const
{
  float squares = 0.0f;
  for (const std::uint32_t k : nodes) {
    const SurfaceNode& node = nodes_[k];
    squares += (footOn(surface, node.center) - node.center).squaredNorm() /
               (node.spacing * node.spacing);
  }
  return std::sqrt(squares / static_cast<float>(nodes.size()));
}

void
SurfacePiece::refit(SurfacePart& part) const
{
  refine(sampleOf(part.nodes), part.surface);
}

float
SurfacePiece::distanceTo(const ShapePrimitive& surface, std::uint32_t node) const
{
  const auto& [center, normal, spacing, noise] = nodes_[node];
  if (!(std::abs(normalOf(surface, center).dot(normal)) > same_surface))
    return std::numeric_limits<float>::infinity();
  return (footOn(surface, center) - center).norm() / spacing;
}

PrimitiveSample
SurfacePiece::sampleOf(const NodeIndices& nodes) const
{
  PrimitiveSample sample;
  const std::size_t step = (nodes.size() + most_fitted - 1) / most_fitted;
  double spacings = 0.0;
  for (std::size_t k = 0; k < nodes.size(); k += step) {
    const SurfaceNode& node = nodes_[nodes[k]];
    sample.points->push_back({node.center.x(), node.center.y(), node.center.z()});
    sample.normals->push_back({node.normal.x(), node.normal.y(), node.normal.z()});
    spacings += node.spacing;
  }
  sample.tolerance = tolerance_ * spacings / static_cast<double>(sample.points->size());
  sample.first_tolerance = loose * sample.tolerance;
  return sample;
}

NodeIndices
SurfacePiece::inliersOf(const ShapePrimitive& surface, const NodeIndices& nodes) const
{
  NodeIndices inliers;
  for (const std::uint32_t k : nodes)
    if (distanceTo(surface, k) < tolerance_)
      inliers.push_back(k);
  return inliers;
}

} // namespace pcl::segmentation

// The parts of a piece, one primitive after the other (sequential RANSAC).
namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr std::size_t most_parts = 16;
constexpr double simpler = 1.5;

} // namespace

std::vector<SurfacePart>
SurfacePiece::parts() const
{
  NodeIndices left = nodes();
  std::vector<SurfacePart> parts;
  while (left.size() >= leastSize()) {
    SurfacePart part = largestPart(left);
    if (part.nodes.size() < least_nodes)
      break;
    if (parts.size() == most_parts)
      return {};
    NodeIndices others;
    std::set_difference(left.begin(),
                        left.end(),
                        part.nodes.begin(),
                        part.nodes.end(),
                        std::back_inserter(others));
    left = std::move(others);
    parts.push_back(std::move(part));
  }
  return parts;
}

/** The connected nodes of a primitive that are most; of the simplest if others have
 * not many more. */
SurfacePart
SurfacePiece::largestPart(const NodeIndices& nodes) const
{
  const PrimitiveSample sample = sampleOf(nodes);
  SurfacePart best;
  for (const PrimitiveType type :
       {PrimitiveType::Plane, PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    SurfacePart part;
    part.surface = fitTo(sample, type);
    if (part.surface.type == PrimitiveType::None)
      continue;
    part.nodes = mostConnected(inliersOf(part.surface, nodes));
    const double factor = best.nodes.empty() ? 0.0 : simpler;
    if (static_cast<double>(part.nodes.size()) >
        factor * static_cast<double>(best.nodes.size()))
      best = std::move(part);
    if (static_cast<double>(best.nodes.size()) >=
        all_but_noise * static_cast<double>(nodes.size()))
      break;
  }
  return best;
}

NodeIndices
SurfacePiece::mostConnected(const NodeIndices& nodes) const
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(nodes_.size(), none);
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    place[nodes[k]] = k;
  DisjointSets sets(nodes.size());
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    forEachAround(nodes[k], [&](std::uint32_t other) {
      if (place[other] != none)
        sets.unite(k, place[other]);
    });
  std::vector<std::size_t> sizes(nodes.size(), 0);
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    ++sizes[sets.find(k)];
  const auto largest = static_cast<std::uint32_t>(
      std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  NodeIndices connected;
  for (std::uint32_t k = 0; k < nodes.size(); ++k)
    if (sets.find(k) == largest)
      connected.push_back(nodes[k]);
  return connected;
}

} // namespace pcl::segmentation
