// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A smooth piece of surface as planes, cylinders, spheres and cones see it.

#include "instances/pieces/surface_piece.h"

#include "common/disjoint_sets.h"
#include "common/statistics.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numeric>

namespace pcl::segmentation {
namespace {

constexpr double all_but_noise = 0.95;   // of the nodes of what is one plane
constexpr double mostly_plane = 0.4;     // all of a curved piece is never on a plane
constexpr double min_share = 0.1;        // of a piece: less is no surface of its own
constexpr std::size_t max_fitted = 2000; // more nodes take time and change little
constexpr std::size_t max_parts = 16;    // more are nothing that primitives describe
constexpr double simpler = 1.5;          // a large cylinder is nearly a plane
constexpr double loose = 3.0;            // a cylinder through two points is off

/** About the first, in units of the mean spacing, as PCL's fits need. */
std::vector<SurfaceNode>
normalized(std::vector<SurfaceNode> nodes)
{
  const Eigen::Vector3f origin = nodes.front().position;
  double sum = 0.0;
  for (const SurfaceNode& node : nodes)
    sum += node.spacing;
  const auto unit = static_cast<float>(sum / static_cast<double>(nodes.size()));
  for (SurfaceNode& node : nodes) {
    node.position = (node.position - origin) / unit;
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

std::size_t
minSize(std::size_t nodes)
{
  const auto share = static_cast<std::size_t>(min_share * static_cast<double>(nodes));
  return std::max(min_part_nodes, share);
}

PrimitiveSample
sampleOf(const SurfacePiece& piece, const NodeIndices& some)
{
  PrimitiveSample sample;
  const std::size_t step = (some.size() + max_fitted - 1) / max_fitted;
  double spacings = 0.0;
  for (std::size_t k = 0; k < some.size(); k += step) {
    const SurfaceNode& node = piece.nodes[some[k]];
    sample.add(node.position, node.normal);
    spacings += node.spacing;
  }
  sample.tolerance =
      piece.tolerance * spacings / static_cast<double>(sample.points->size());
  sample.first_tolerance = loose * sample.tolerance;
  return sample;
}

NodeIndices
inliersOf(const SurfacePiece& piece,
          const ShapePrimitive& surface,
          const NodeIndices& some)
{
  NodeIndices inliers;
  for (const std::uint32_t k : some)
    if (piece.distanceTo(surface, k) < piece.tolerance)
      inliers.push_back(k);
  return inliers;
}

NodeIndices
mostConnected(const SurfacePiece& piece, const NodeIndices& some)
{
  constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();
  std::vector<std::uint32_t> place(piece.nodes.size(), none);
  for (std::uint32_t k = 0; k < some.size(); ++k)
    place[some[k]] = k;
  DisjointSets sets(some.size());
  for (std::uint32_t k = 0; k < some.size(); ++k)
    piece.forEachAround(some[k], [&](std::uint32_t other) {
      if (place[other] != none)
        sets.unite(k, place[other]);
    });
  std::vector<std::size_t> sizes(some.size(), 0);
  for (std::uint32_t k = 0; k < some.size(); ++k)
    ++sizes[sets.find(k)];
  const auto largest = static_cast<std::uint32_t>(
      std::max_element(sizes.begin(), sizes.end()) - sizes.begin());
  NodeIndices connected;
  for (std::uint32_t k = 0; k < some.size(); ++k)
    if (sets.find(k) == largest)
      connected.push_back(some[k]);
  return connected;
}

} // namespace

SurfacePiece::SurfacePiece(std::vector<SurfaceNode> of_cloud, float min_noise)
: nodes(normalized(std::move(of_cloud)))
, noise(std::max(min_noise, medianNoise(nodes)))
, tolerance(0.15f + 0.5f * noise)
, node_noise(0.05f + 0.5f * noise)
, gap_limit(stepLimit(noise))
, min_size(minSize(nodes.size()))
{}

void
SurfacePiece::findAround() const
{
  const PointGrid grid(positionsOf(nodes), around_spacings);
  begins_.push_back(0);
  for (const SurfaceNode& node : nodes) {
    grid.forEachWithin(node.position,
                       around_spacings * node.spacing,
                       [&](std::uint32_t other, float) { around_.push_back(other); });
    begins_.push_back(static_cast<std::uint32_t>(around_.size()));
  }
}

NodeIndices
SurfacePiece::allNodes() const
{
  NodeIndices all(nodes.size());
  std::iota(all.begin(), all.end(), 0U);
  return all;
}

ShapePrimitive
SurfacePiece::fitted(const NodeIndices& some,
                     PrimitiveType type,
                     std::optional<PrimitiveSample>& sample) const
{
  const bool is_all = some.size() == nodes.size();
  if (const auto known = fits_of_all_.find(type); is_all && known != fits_of_all_.end())
    return known->second;
  if (!sample)
    sample = sampleOf(*this, some);
  const ShapePrimitive fit = fitTo(*sample, type);
  if (is_all)
    fits_of_all_.emplace(type, fit);
  return fit;
}

/** The primitive with the most connected nodes, or a simpler one with nearly as many.
 */
SurfacePart
SurfacePiece::largestPart(const NodeIndices& some) const
{
  std::optional<PrimitiveSample> sample;
  SurfacePart best;
  for (const PrimitiveType type :
       {PrimitiveType::Plane, PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    SurfacePart part;
    part.surface = fitted(some, type, sample);
    if (part.surface.type == PrimitiveType::None)
      continue;
    part.nodes = mostConnected(*this, inliersOf(*this, part.surface, some));
    const double factor = best.nodes.empty() ? 0.0 : simpler;
    if (static_cast<double>(part.nodes.size()) >
        factor * static_cast<double>(best.nodes.size()))
      best = std::move(part);
    if (static_cast<double>(best.nodes.size()) >=
        all_but_noise * static_cast<double>(some.size()))
      break;
  }
  return best;
}

bool
SurfacePiece::isOne(const NodeIndices& some) const
{
  std::optional<PrimitiveSample> sample;
  const ShapePrimitive plane = fitted(some, PrimitiveType::Plane, sample);
  if (plane.type != PrimitiveType::None) {
    const auto size = static_cast<double>(some.size());
    const auto inliers = static_cast<double>(inliersOf(*this, plane, some).size());
    if (inliers >= all_but_noise * size)
      return true;
    if (inliers > mostly_plane * size)
      return false;
  }
  return residualAsOne(some) < tolerance;
}

float
SurfacePiece::residualAsOne(const NodeIndices& some) const
{
  std::optional<PrimitiveSample> sample = sampleOf(*this, some);
  float residual = std::numeric_limits<float>::infinity();
  for (const PrimitiveType type : {PrimitiveType::Cylinder, PrimitiveType::Sphere}) {
    ShapePrimitive surface = fitted(some, type, sample);
    if (surface.type == PrimitiveType::None)
      continue;
    refine(*sample, surface);
    residual = std::min(residual, residualOf(surface, some));
  }
  if (residual < tolerance)
    return residual;
  return std::min(residual, static_cast<float>(coneResidual(*sample)));
}

float
SurfacePiece::residualOf(const ShapePrimitive& surface, const NodeIndices& some) const
{
  float squares = 0.0f;
  for (const std::uint32_t k : some) {
    const SurfaceNode& node = nodes[k];
    squares += (footOn(surface, node.position) - node.position).squaredNorm() /
               (node.spacing * node.spacing);
  }
  return std::sqrt(squares / static_cast<float>(some.size()));
}

void
SurfacePiece::refit(SurfacePart& part) const
{
  refine(sampleOf(*this, part.nodes), part.surface);
}

float
SurfacePiece::distanceTo(const ShapePrimitive& surface, std::uint32_t node) const
{
  const Eigen::Vector3f& position = nodes[node].position;
  if (!(std::abs(normalOf(surface, position).dot(nodes[node].normal)) > same_surface))
    return std::numeric_limits<float>::infinity();
  return (footOn(surface, position) - position).norm() / nodes[node].spacing;
}

std::vector<SurfacePart>
SurfacePiece::parts() const
{
  NodeIndices left = allNodes();
  std::vector<SurfacePart> parts;
  while (left.size() >= min_size) {
    SurfacePart part = largestPart(left);
    if (part.nodes.size() < min_part_nodes)
      break;
    if (parts.size() == max_parts)
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

} // namespace pcl::segmentation
