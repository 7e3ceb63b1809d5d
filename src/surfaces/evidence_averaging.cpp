// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Averages of evidence over a surface that do not cross its edges.

#include "surfaces/evidence_averaging.h"

#include "common/finite.h"
#include "common/gathered.h"
#include "common/parallel.h"
#include "geometry/point_choice.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::segmentation {
namespace {

using detail::FieldInput;
using Floats = std::vector<float>;

constexpr float node_spacings = 1.5f;  // about every eighth point: 35 in reach
constexpr float reach_spacings = 5.0f; // that of the surfaces' normals
constexpr int rounds = 4;              // the evidence spreads over a face
// Of an edge point, and of one on another face: faces do not speak for each other.
constexpr float across_weight = 0.05f;
constexpr float same_face = 0.7071f; // cosine of 45 degrees

/** The points that stand for all. Their values are in the order of a grid over them. */
struct Nodes {
  struct Node {
    Eigen::Vector3f position;
    std::uint32_t point;
    std::size_t rank; ///< among all that stand for others
    bool is_known;    ///< its evidence; else it has a place in the grid, no weight
  };

  Nodes(const FieldInput& input,
        const ShapeField& edges,
        const std::vector<Node>& nodes)
  : grid(positionsOf(nodes),
         reach_spacings * spacingOfCloud(input, edges.spacings),
         input.threads)
  {
    for (const std::uint32_t k : grid.order()) {
      const std::size_t i = nodes[k].point;
      points.push_back(nodes[k].point);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        positions[axis].push_back(input.points[i][axis]);
        normals[axis].push_back(edges.normals[i][static_cast<Eigen::Index>(axis)]);
      }
      weights.push_back(!nodes[k].is_known                ? 0.0f
                        : edges.edge_likelihood[i] > 0.5f ? across_weight
                                                          : 1.0f);
    }
  }

  PointGrid grid;
  std::vector<std::uint32_t> points;
  std::array<Floats, 3> positions, normals; ///< x, y, z of each
  Floats weights;                           ///< of each, whatever its direction
  std::vector<Floats> values;               ///< of each, class by class
};

/** Sums over nodes of their weights, and of values of two classes times these. */
struct Sums {
  float weights = 0.0f, first = 0.0f, second = 0.0f;
};

/** Where a mean is asked for. */
struct Center {
  const float *position, *normal;
  float squared_radius;
};

/** Adds nodes from one to another, by what they count at a center: nothing beyond its
 * radius. \param[in] classes two of which values are summed */
void
sumNodes(const Nodes& nodes,
         std::size_t begin,
         std::size_t end,
         const Center& center,
         const std::array<std::size_t, 2>& classes,
         Sums& sums)
{
  const float *x = &nodes.positions[0][begin], *y = &nodes.positions[1][begin],
              *z = &nodes.positions[2][begin];
  const float *nx = &nodes.normals[0][begin], *ny = &nodes.normals[1][begin],
              *nz = &nodes.normals[2][begin];
  const float* const own_weight = &nodes.weights[begin];
  const float *v = &nodes.values[classes[0]][begin],
              *w = &nodes.values[classes[1]][begin];
  const float px = center.position[0], py = center.position[1], pz = center.position[2];
  const float qx = center.normal[0], qy = center.normal[1], qz = center.normal[2];
  const float squared_radius = center.squared_radius;
  const std::size_t count = end - begin;
  float weights = 0.0f, first = 0.0f, second = 0.0f;
#pragma omp simd reduction(+ : weights, first, second)
  for (std::size_t k = 0; k < count; ++k) {
    const float dx = x[k] - px, dy = y[k] - py, dz = z[k] - pz;
    const float squared = dx * dx + (dy * dy + dz * dz);
    const float cosine = nx[k] * qx + (ny[k] * qy + nz[k] * qz);
    const float turn = std::abs(cosine) > same_face ? 1.0f : across_weight;
    const float near = squared < squared_radius ? 1.0f : 0.0f;
    const float weight = own_weight[k] * turn * near;
    weights += weight;
    first += weight * v[k];
    second += weight * w[k];
  }
  sums.weights += weights;
  sums.first += first;
  sums.second += second;
}

/** The mean of the nodes' values that count at a point.
 * \return false if no node is near */
bool
meanAt(const FieldInput& input,
       const ShapeField& edges,
       const Nodes& nodes,
       std::size_t point,
       Floats& mean)
{
  const float radius = reach_spacings * edges.spacings[point];
  const std::size_t classes = nodes.values.size();
  float weights = 0.0f;
  mean.resize(classes);
  for (std::size_t c = 0; c < classes; c += 2) {           // mostly two
    const std::size_t next = std::min(c + 1, classes - 1); // the last again if odd
    Sums sums;
    const Center center{
        input.points[point], edges.normals[point].data(), radius * radius};
    const auto add = [&](std::uint32_t begin, std::uint32_t end) {
      sumNodes(nodes, begin, end, center, {c, next}, sums);
    };
    nodes.grid.forEachRangeWithin(positionOf(input.points, point), radius, add);
    mean[c] = sums.first / sums.weights;
    mean[next] = sums.second / sums.weights;
    weights = sums.weights;
  }
  return weights > 0.0f;
}

/** Finds which of some points are near others, those that are near these, and so on. */
class NearPoints {
public:
  NearPoints(const FieldInput& input,
             const ShapeField& edges,
             const pcl::Indices& points)
  : input_(input)
  , spacings_(edges.spacings)
  , points_(points)
  , positions_(detail::positionsAt(input.points, points))
  , grid_(detail::viewOfPositions(positions_),
          reach_spacings * spacingOfCloud(input, spacings_),
          input.threads)
  , place_(points.size())
  , is_near_(points.size(), 0)
  , left_(points.size())
  {
    for (std::size_t at = 0; at < place_.size(); ++at)
      place_[grid_.order()[at]] = at;
  }

  /** Adds those that are nearer to a point of the cloud than so many of its spacings.
   * \return the points of the cloud that are new */
  template <typename Index>
  std::vector<std::uint32_t>
  add(const std::vector<Index>& around, double spacings)
  {
    constexpr double rounding = 1.001; // does not decide what is near
    std::vector<std::uint32_t> added;
    for (const Index point : around) {
      if (left_ == 0)
        break;
      const auto i = static_cast<std::size_t>(point);
      const Eigen::Vector3f center = positionOf(input_.points, i);
      const float radius = static_cast<float>(rounding * spacings) * spacings_[i];
      grid_.forEachRangeWithin(
          center, radius, [&](std::uint32_t begin, std::uint32_t end) {
            addWithin(center, radius * radius, begin, end, added);
          });
    }
    return added;
  }

  /** Adds a point by its number. */
  void
  add(std::size_t number)
  {
    mark(place_[number]);
  }

  /** Their numbers, ascending. */
  std::vector<std::uint32_t>
  numbers() const
  {
    std::vector<std::uint32_t> numbers;
    for (std::uint32_t k = 0; k < place_.size(); ++k)
      if (is_near_[place_[k]] != 0)
        numbers.push_back(k);
    return numbers;
  }

private:
  /** Of a range most are near already. */
  void
  addWithin(const Eigen::Vector3f& center,
            float squared_radius,
            std::uint32_t begin,
            std::uint32_t end,
            std::vector<std::uint32_t>& added)
  {
    const char *const first = is_near_.data(), *const last = first + end;
    for (const char* at = std::find(first + begin, last, 0); at != last;
         at = std::find(at + 1, last, 0)) {
      const std::uint32_t number = grid_.order()[static_cast<std::size_t>(at - first)];
      const Eigen::Vector3f offset = positionOf(view(), number) - center;
      if (offset.squaredNorm() < squared_radius) {
        mark(static_cast<std::size_t>(at - first));
        added.push_back(static_cast<std::uint32_t>(points_[number]));
      }
    }
  }

  void
  mark(std::size_t place)
  {
    left_ -= is_near_[place] == 0 ? 1 : 0;
    is_near_[place] = 1;
  }

  XYZView
  view() const
  {
    return detail::viewOfPositions(positions_);
  }

  const FieldInput& input_;
  const Floats& spacings_;
  const pcl::Indices& points_;
  const Floats positions_;
  const PointGrid grid_;
  std::vector<std::size_t> place_; ///< of each point, in the order of the grid
  std::vector<char> is_near_;      ///< of each place
  std::size_t left_;               ///< how many are not
};

/** use(k, mean) with the mean at each of some points, if nodes are near. */
template <typename Use>
void
forEachMean(const FieldInput& input,
            const ShapeField& edges,
            const Nodes& nodes,
            const std::vector<std::uint32_t>& points,
            const Use& use)
{
  kernels::parallelForRanges(
      points.size(), input.threads, [&](std::size_t begin, std::size_t end) {
        Floats mean;
        for (std::size_t k = begin; k < end; ++k)
          if (meanAt(input, edges, nodes, points[k], mean))
            use(k, mean);
      });
}

} // namespace

double
averagingReach(double spacing, double max_spacing)
{
  // Points that are beyond the radius, but in a cell within it, count nothing; sums
  // are rounded as they are where the same points are there.
  return rounds * reach_spacings * max_spacing + reach_spacings * spacing;
}

double
evidencePointReach(double spacing)
{
  return std::sqrt(3.0) * node_spacings * spacing;
}

std::vector<std::uint32_t>
knownPoints(const FieldInput& input, const ShapeField& edges)
{
  std::vector<std::uint32_t> known;
  for (std::uint32_t i = 0; i < input.points.size; ++i)
    if (kernels::isFinite(input.points[i]) &&
        kernels::isFinite(edges.normals[i].data()))
      known.push_back(i);
  return known;
}

pcl::Indices
evidencePoints(const FieldInput& input,
               const ShapeField& edges,
               const std::vector<std::uint32_t>& known)
{
  const std::vector<std::uint32_t> points =
      centralPoints(input.points,
                    known,
                    node_spacings * spacingOfCloud(input, edges.spacings),
                    input.threads);
  pcl::Indices indices(points.begin(), points.end());
  for (std::uint32_t i = 0; i < input.points.size; ++i)
    if (kernels::isFinite(input.points[i]) &&
        !kernels::isFinite(edges.normals[i].data()))
      indices.push_back(static_cast<pcl::index_t>(i));
  std::sort(indices.begin(), indices.end());
  return indices;
}

NeededPoints
neededPoints(const FieldInput& input,
             const ShapeField& edges,
             const pcl::Indices& points,
             const std::vector<std::uint32_t>& wanted,
             double inad_radius)
{
  NearPoints near(input, edges, points);
  std::vector<std::uint32_t> added = wanted;
  for (int round = 0; round < rounds; ++round)
    added = near.add(added, reach_spacings);
  for (std::size_t k = 0; k < points.size(); ++k)
    if (!kernels::isFinite(edges.normals[static_cast<std::size_t>(points[k])].data()))
      near.add(k);
  const std::vector<std::uint32_t> evidence = near.numbers();
  near.add(detail::gathered(points, evidence), inad_radius);
  NeededPoints needed{near.numbers(), {}};
  needed.evidence.reserve(evidence.size());
  for (const std::uint32_t k : evidence)
    needed.evidence.push_back(static_cast<pcl::index_t>(
        std::lower_bound(needed.points.begin(), needed.points.end(), k) -
        needed.points.begin()));
  return needed;
}

std::vector<float>
averageEvidence(const FieldInput& input,
                const ShapeField& edges,
                const pcl::Indices& points,
                const std::vector<float>& evidence,
                std::size_t classes,
                const std::vector<std::uint32_t>& wanted)
{
  std::vector<float> averages(input.points.size * classes,
                              std::numeric_limits<float>::quiet_NaN());
  std::vector<Nodes::Node> chosen;
  for (std::size_t k = 0; k < points.size(); ++k) {
    const auto i = static_cast<std::uint32_t>(points[k]);
    const float* own = &evidence[k * classes];
    if (!kernels::isFinite(edges.normals[i].data()))
      std::copy_n(own, classes, &averages[i * classes]);
    else
      chosen.push_back({positionOf(input.points, i), i, k, !std::isnan(*own)});
  }
  Nodes nodes(input, edges, chosen);
  nodes.values.resize(classes);
  for (const std::uint32_t k : nodes.grid.order())
    for (std::size_t c = 0; c < classes; ++c)
      nodes.values[c].push_back(
          chosen[k].is_known ? evidence[chosen[k].rank * classes + c] : 0.0f);
  std::vector<std::size_t> known;
  for (std::size_t k = 0; k < nodes.points.size(); ++k)
    if (nodes.weights[k] > 0.0f)
      known.push_back(k);
  const std::vector<std::uint32_t> known_points = detail::gathered(nodes.points, known);
  for (int round = 1; round < rounds; ++round) {
    std::vector<Floats> means = nodes.values;
    forEachMean(input, edges, nodes, known_points, [&](std::size_t k, const Floats& m) {
      for (std::size_t c = 0; c < classes; ++c)
        means[c][known[k]] = m[c];
    });
    nodes.values = std::move(means);
  }
  forEachMean(input, edges, nodes, wanted, [&](std::size_t k, const Floats& mean) {
    std::copy(mean.begin(), mean.end(), &averages[wanted[k] * classes]);
  });
  return averages;
}

} // namespace pcl::segmentation
