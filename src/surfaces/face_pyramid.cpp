// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The faces of a cloud as linked means of cells, at several sizes of cells.

#include "surfaces/face_pyramid.h"

#include "common/disjoint_sets.h"
#include "common/finite.h"
#include "common/parallel.h"
#include "geometry/cell_order.h"
#include "geometry/point_choice.h"
#include "geometry/point_grid.h"
#include "geometry/principal_axes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace pcl::segmentation {
namespace {

using Eigen::Matrix3f;
using Eigen::Vector3f;

// A spacing is two mean distances: a cell of it holds some four points. With noise, as
// much larger as the radius of INAD for edges, or its points are not on one sheet.
constexpr float cell_spacings = 1.0f;
constexpr float cell_per_noise = 5.0f;
// The means of cells that share a corner are 1.4 cells apart on average. Bands of edge
// points are at least 2 spacings wide, so that links do not cross them.
constexpr float link_cells = 1.6f;
constexpr float same_face = 0.7071f; // cosine of 45 degrees: of two normals
// Sine of 37 degrees, from the tangent plane: above it is another sheet.
constexpr float max_rise = 0.6f;
// Spacings: with less noise, layers are nearer to each other than a fourteenth of a
// cell.
constexpr double layer_noise = 0.1;
// Of a layer's points: half of a sheet with normal noise is 2.7 of its own off the
// other.
constexpr float layer_deviations = 3.0f;
// Of both, and of the noise: halves of an even thickness are 3.5 of their own apart.
constexpr float sheet_deviations = 5.0f;
constexpr float one_sheet = std::numeric_limits<float>::infinity();

using Link = FaceLink;

/** Of two normals of either sign the second, on the side of the first. */
Vector3f
aligned(const Vector3f& first, const Vector3f& second)
{
  return second.dot(first) < 0.0f ? Vector3f(-second) : second;
}

/** The points on faces, cell by cell. */
std::vector<CellPoint>
facePoints(const XYZView& points, const ShapeField& field, float size, unsigned threads)
{
  auto chosen = kernels::collectForEach<CellPoint>(
      static_cast<std::uint32_t>(points.size),
      threads,
      [&](std::uint32_t i, std::vector<CellPoint>& of_part) {
        if (kernels::isFinite(points[i]) &&
            kernels::isFinite(field.normals[i].data()) &&
            field.edge_likelihood[i] <= 0.5f)
          of_part.push_back({cellOf(points[i], size), i});
      });
  sortByCell(chosen, threads);
  return chosen;
}

/** The mean of some points with similar normals. */
void
addNode(const XYZView& points,
        const ShapeField& field,
        const std::vector<std::uint32_t>& members,
        FaceLevel& level)
{
  FaceNode node;
  const Vector3f first = positionOf(points, members.front());
  for (const std::uint32_t i : members) {
    node.position += positionOf(points, i) - first;
    node.normal += aligned(field.normals[members.front()], field.normals[i]);
    node.spacing += field.spacings[i];
  }
  node.count = static_cast<float>(members.size());
  node.position = first + node.position / node.count;
  node.normal.normalize();
  node.spacing /= node.count;
  Scatter<float> scatter;
  for (const std::uint32_t i : members)
    scatter.add(positionOf(points, i) - node.position);
  level.nodes.push_back(node);
  level.scatters.push_back(scatter.matrix());
}

/** Nodes of some cells, and the point that stands for each. */
struct NodesOfCells {
  FaceLevel level;
  std::vector<std::uint32_t> point_of_node;
};

/** Where sorted heights are those of two sheets: how many are below. The squares of
 * heights about the means of both are least there. \return 0 where they are of one */
std::size_t
endOfLowerSheet(const std::vector<float>& heights, float min_distance)
{
  const auto count = static_cast<float>(heights.size());
  const float sum = std::accumulate(heights.begin(), heights.end(), 0.0f);
  const float squares =
      std::inner_product(heights.begin(), heights.end(), heights.begin(), 0.0f);
  std::size_t end = 0;
  float least = std::numeric_limits<float>::infinity(), apart = 0.0f, below = 0.0f;
  for (std::size_t k = 1; k < heights.size(); ++k) {
    below += heights[k - 1];
    const auto size = static_cast<float>(k);
    const float low = below / size, high = (sum - below) / (count - size);
    const float left = squares - size * low * low - (count - size) * high * high;
    if (left >= least)
      continue;
    least = left;
    apart = high - low;
    end = k;
  }
  const float deviation = std::sqrt(std::max(0.0f, least) / count);
  return apart > std::max(min_distance, sheet_deviations * deviation) ? end : 0;
}

/** Leaves of points with similar normals those on the sheet of the first one. */
void
keepFirstSheet(const XYZView& points,
               const ShapeField& field,
               float min_distance,
               std::vector<std::uint32_t>& members)
{
  const Vector3f first = positionOf(points, members.front());
  Vector3f normal = Vector3f::Zero();
  for (const std::uint32_t i : members)
    normal += aligned(field.normals[members.front()], field.normals[i]);
  normal.normalize();
  const auto height_of = [&](std::uint32_t i) {
    return normal.dot(positionOf(points, i) - first);
  };
  std::vector<float> heights;
  heights.reserve(members.size());
  for (const std::uint32_t i : members)
    heights.push_back(height_of(i));
  std::sort(heights.begin(), heights.end());
  while (const std::size_t end = endOfLowerSheet(heights, min_distance)) {
    const auto border = heights.begin() + static_cast<std::ptrdiff_t>(end);
    if (*border > 0.0f)
      heights.erase(border, heights.end());
    else
      heights.erase(heights.begin(), border);
  }
  members.erase(std::remove_if(members.begin(),
                               members.end(),
                               [&](std::uint32_t i) {
                                 const float height = height_of(i);
                                 return height < heights.front() ||
                                        height > heights.back();
                               }),
                members.end());
}

/** Adds the nodes of a cell: of its points those with similar normals, on one sheet. */
void
addNodes(const XYZView& points,
         const ShapeField& field,
         float min_distance,
         std::vector<CellPoint>::iterator begin,
         std::vector<CellPoint>::iterator end,
         std::vector<std::uint32_t>& node_of_point,
         NodesOfCells& nodes)
{
  std::sort(begin, end, [&](const CellPoint& a, const CellPoint& b) {
    return isBefore(points, a.point, b.point);
  });
  std::vector<std::uint32_t> members;
  for (auto rest = begin; rest != end;) {
    const Vector3f& normal = field.normals[rest->point];
    const auto is_similar = [&](const CellPoint& p) {
      return std::abs(field.normals[p.point].dot(normal)) > same_face;
    };
    members.clear();
    for (auto p = rest; p != end; ++p)
      if (is_similar(*p))
        members.push_back(p->point);
    if (members.empty()) { // a normal that is not of length 1
      ++rest;
      continue;
    }
    if (min_distance < one_sheet)
      keepFirstSheet(points, field, min_distance, members);
    for (const std::uint32_t i : members)
      node_of_point[i] = static_cast<std::uint32_t>(nodes.level.nodes.size());
    rest = std::stable_partition(rest, end, [&](const CellPoint& p) {
      return node_of_point[p.point] != FacePyramid::none;
    });
    nodes.point_of_node.push_back(members.front());
    addNode(points, field, members, nodes.level);
  }
}

template <typename T>
void
append(const std::vector<T>& more, std::vector<T>& all)
{
  all.insert(all.end(), more.begin(), more.end());
}

/** Nodes of the first level, cell by cell. */
void
collectNodes(const XYZView& points,
             const ShapeField& field,
             float min_distance,
             unsigned threads,
             FacePyramid& pyramid)
{
  constexpr std::size_t part = 4096; // cells of a thread at a time
  FaceLevel& level = pyramid.levels.front();
  std::vector<CellPoint> sorted = facePoints(points, field, level.cell, threads);
  const std::vector<std::size_t> begins = beginsOfCells(sorted, threads);
  const std::size_t cells = begins.size() - 1;
  const auto at = [&](std::size_t cell) {
    return sorted.begin() + static_cast<std::ptrdiff_t>(begins[cell]);
  };
  std::vector<NodesOfCells> parts((cells + part - 1) / part);
  kernels::parallelFor(parts.size(), threads, [&](std::size_t p) {
    for (std::size_t cell = p * part; cell < std::min(cells, (p + 1) * part); ++cell)
      addNodes(points,
               field,
               min_distance,
               at(cell),
               at(cell + 1),
               pyramid.node_of_point,
               parts[p]);
  });
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const auto before = static_cast<std::uint32_t>(level.nodes.size());
    for (auto i = at(p * part); i != at(std::min(cells, (p + 1) * part)); ++i)
      if (std::uint32_t& node = pyramid.node_of_point[i->point];
          node != FacePyramid::none)
        node += before;
    append(parts[p].level.nodes, level.nodes);
    append(parts[p].level.scatters, level.scatters);
    append(parts[p].point_of_node, pyramid.point_of_node);
  }
}

/** The standard deviation of a node's points along a direction. */
float
thickness(const FaceLevel& level, std::uint32_t node, const Vector3f& normal)
{
  const float squares = normal.dot(level.scatters[node] * normal);
  return std::sqrt(std::max(0.0f, squares) / level.nodes[node].count);
}

/** Whether one node may follow the other on a face. */
bool
areOfOneFace(const FaceLevel& level,
             std::uint32_t i,
             std::uint32_t j,
             float min_distance)
{
  const FaceNode &a = level.nodes[i], &b = level.nodes[j];
  const Vector3f offset = b.position - a.position;
  const float height =
      std::max(std::abs(offset.dot(a.normal)), std::abs(offset.dot(b.normal)));
  return std::abs(a.normal.dot(b.normal)) > same_face &&
         height < max_rise * offset.norm() &&
         (height < min_distance ||
          height < sheet_deviations * std::max(thickness(level, i, a.normal),
                                               thickness(level, j, b.normal)));
}

/** Layers of the sheet that a node is on, above or below it, in their order: sums over
 * them do not depend on the grid. */
std::vector<std::uint32_t>
layersAround(const FaceLevel& level, const PointGrid& grid, std::uint32_t i)
{
  const FaceNode& node = level.nodes[i];
  const float own = thickness(level, i, node.normal);
  std::vector<std::uint32_t> layers;
  grid.forEachWithin(
      node.position, link_cells * level.cell, [&](std::uint32_t j, float squared) {
        const FaceNode& other = level.nodes[j];
        const float height = std::abs(node.normal.dot(other.position - node.position));
        if (j != i && height > max_rise * std::sqrt(squared) &&
            std::abs(node.normal.dot(other.normal)) > same_face &&
            height < layer_deviations * std::max(own, thickness(level, j, node.normal)))
          layers.push_back(j);
      });
  std::sort(layers.begin(), layers.end());
  return layers;
}

/** How far a node is from the middle of its sheet, along its normal. */
float
heightOfSheet(const FaceLevel& level, const PointGrid& grid, std::uint32_t i)
{
  const FaceNode& node = level.nodes[i];
  float sum = 0.0f, count = node.count;
  for (const std::uint32_t j : layersAround(level, grid, i)) {
    const FaceNode& other = level.nodes[j];
    sum += other.count * node.normal.dot(other.position - node.position);
    count += other.count;
  }
  return sum / count;
}

/** Where noise makes a sheet as thick as a cell, walls between cells cut it to layers,
 * with no gap between them. These move to its middle, and their points with them:
 * scatters, which are about the means, stay. */
void
joinLayers(FaceLevel& level, unsigned threads)
{
  const PointGrid grid(positionsOf(level.nodes), link_cells * level.cell);
  std::vector<float> heights(level.nodes.size());
  kernels::parallelForEach(heights.size(), threads, [&](std::size_t i) {
    heights[i] = heightOfSheet(level, grid, static_cast<std::uint32_t>(i));
  });
  for (std::size_t i = 0; i < heights.size(); ++i)
    level.nodes[i].position += heights[i] * level.nodes[i].normal;
}

template <typename Visit>
void
forEachLink(const FaceLevel& level, const Visit& visit)
{
  for (std::uint32_t i = 0; i < level.nodes.size(); ++i)
    for (std::uint32_t k = level.link_begins[i]; k < level.link_begins[i + 1]; ++k)
      visit(i, level.links[k]);
}

void
linkFirst(FaceLevel& level, float min_distance, unsigned threads)
{
  const PointGrid grid(positionsOf(level.nodes), link_cells * level.cell);
  const auto reachOf = [&](const FaceNode& node) {
    return link_cells * std::max(level.cell, node.spacing);
  };
  const auto addLinks = [&](std::uint32_t i, std::vector<Link>& links) {
    const FaceNode& node = level.nodes[i];
    grid.forEachWithin(
        node.position, reachOf(node), [&](std::uint32_t j, float squared) {
          const FaceNode& other = level.nodes[j];
          const float back = reachOf(other);
          const bool is_found_from_there = squared < back * back;
          if (j == i || (is_found_from_there && j < i) ||
              !areOfOneFace(level, i, j, min_distance))
            return;
          links.emplace_back(i, j);
          links.emplace_back(j, i);
        });
  };
  const auto count = static_cast<std::uint32_t>(level.nodes.size());
  setLinks(kernels::collectForEach<Link>(count, threads, addLinks), level, threads);
}

/** visit(row, column) for the diagonal and what is below: all that solvers read. */
template <typename Visit>
void
forEachBelow(const Visit& visit)
{
  for (Eigen::Index r = 0; r < 3; ++r)
    for (Eigen::Index c = 0; c <= r; ++c)
      visit(r, c);
}

/** The normal of the points of a node and of those that follow it. */
Vector3f
normalAround(const FaceLevel& level, std::uint32_t i)
{
  const FaceNode& node = level.nodes[i];
  const std::uint32_t begin = level.link_begins[i], end = level.link_begins[i + 1];
  if (end - begin < 3)
    return node.normal;
  float count = node.count;
  Vector3f sum = Vector3f::Zero();
  Matrix3f scatter = level.scatters[i];
  for (std::uint32_t k = begin; k < end; ++k) {
    const FaceNode& other = level.nodes[level.links[k]];
    const Vector3f offset = other.position - node.position;
    count += other.count;
    sum += other.count * offset;
    const Matrix3f& of_other = level.scatters[level.links[k]];
    forEachBelow([&](Eigen::Index r, Eigen::Index c) {
      scatter(r, c) += of_other(r, c) + other.count * offset[r] * offset[c];
    });
  }
  forEachBelow([&](Eigen::Index r, Eigen::Index c) {
    scatter(r, c) -= sum[r] * sum[c] / count;
  });
  Eigen::SelfAdjointEigenSolver<Matrix3f> solver;
  solver.computeDirect(scatter);
  const Vector3f& values = solver.eigenvalues();
  const Vector3f normal = solver.eigenvectors().col(0);
  // As thick as it is wide: no plane.
  const bool is_plane = values[0] < 0.5f * values[1] && normal.allFinite();
  return is_plane ? aligned(node.normal, normal) : node.normal;
}

void
refineNormals(FaceLevel& level, unsigned threads)
{
  std::vector<Vector3f> normals(level.nodes.size());
  kernels::parallelForEach(normals.size(), threads, [&](std::size_t i) {
    normals[i] = normalAround(level, static_cast<std::uint32_t>(i));
  });
  for (std::size_t i = 0; i < normals.size(); ++i)
    level.nodes[i].normal = normals[i];
}

void
cutLinks(FaceLevel& level, float min_distance)
{
  std::size_t kept = 0;
  for (std::uint32_t i = 0, begin = 0; i < level.nodes.size(); ++i) {
    const std::uint32_t end = level.link_begins[i + 1];
    for (; begin < end; ++begin)
      if (areOfOneFace(level, i, level.links[begin], min_distance))
        level.links[kept++] = level.links[begin];
    level.link_begins[i + 1] = static_cast<std::uint32_t>(kept);
  }
  level.links.resize(kept);
}

/** Sets parents: linked nodes in one cell of twice the size have one. \return for each
 * parent its first child */
std::vector<std::uint32_t>
findParents(FaceLevel& level)
{
  const std::size_t size = level.nodes.size();
  std::vector<Cell> cells;
  cells.reserve(size);
  for (const FaceNode& node : level.nodes)
    cells.push_back(cellOf(node.position.data(), 2.0f * level.cell));
  DisjointSets sets(size);
  forEachLink(level, [&](std::uint32_t i, std::uint32_t j) {
    if (areSame(cells[i], cells[j]))
      sets.unite(i, j);
  });
  std::vector<std::uint32_t> firsts;
  level.parents.resize(size);
  for (std::uint32_t i = 0; i < size; ++i) { // roots come first
    const std::uint32_t root = sets.find(i);
    if (root == i) {
      level.parents[i] = static_cast<std::uint32_t>(firsts.size());
      firsts.push_back(i);
    }
    else
      level.parents[i] = level.parents[root];
  }
  return firsts;
}

FaceLevel
nextLevel(FaceLevel& level, unsigned threads)
{
  FaceLevel next;
  next.cell = 2.0f * level.cell;
  const std::vector<std::uint32_t> firsts = findParents(level);
  next.nodes.resize(firsts.size());
  next.scatters.assign(firsts.size(), Matrix3f::Zero());
  for (std::uint32_t i = 0; i < level.nodes.size(); ++i) {
    const FaceNode& node = level.nodes[i];
    const FaceNode& first = level.nodes[firsts[level.parents[i]]];
    FaceNode& sum = next.nodes[level.parents[i]];
    sum.position += node.count * (node.position - first.position);
    sum.normal += node.count * aligned(first.normal, node.normal);
    sum.spacing += node.count * node.spacing;
    sum.count += node.count;
  }
  for (std::size_t k = 0; k < firsts.size(); ++k) {
    FaceNode& node = next.nodes[k];
    node.position = level.nodes[firsts[k]].position + node.position / node.count;
    node.normal.normalize();
    node.spacing /= node.count;
  }
  for (std::uint32_t i = 0; i < level.nodes.size(); ++i) {
    const std::uint32_t parent = level.parents[i];
    const Vector3f offset = level.nodes[i].position - next.nodes[parent].position;
    next.scatters[parent] +=
        level.scatters[i] + level.nodes[i].count * offset * offset.transpose();
  }
  std::vector<Link> links;
  forEachLink(level, [&](std::uint32_t i, std::uint32_t j) {
    if (level.parents[i] != level.parents[j])
      links.emplace_back(level.parents[i], level.parents[j]);
  });
  setLinks(links, next, threads);
  return next;
}

} // namespace

void
setLinks(const std::vector<FaceLink>& links, FaceLevel& level, unsigned threads)
{
  std::vector<std::uint32_t> ends(level.nodes.size() + 1, 0);
  for (const FaceLink& link : links)
    ++ends[link.first + 1];
  std::partial_sum(ends.begin(), ends.end(), ends.begin());
  std::vector<std::uint32_t> of_nodes(links.size());
  for (const FaceLink& link : links)
    of_nodes[ends[link.first]++] = link.second;
  const auto beginOf = [&](std::size_t i) {
    return of_nodes.begin() + (i > 0 ? ends[i - 1] : 0);
  };
  level.link_begins.assign(level.nodes.size() + 1, 0);
  kernels::parallelForEach(level.nodes.size(), threads, [&](std::size_t i) {
    const auto begin = beginOf(i), end = of_nodes.begin() + ends[i];
    std::sort(begin, end);
    level.link_begins[i + 1] =
        static_cast<std::uint32_t>(std::unique(begin, end) - begin);
  });
  std::partial_sum(
      level.link_begins.begin(), level.link_begins.end(), level.link_begins.begin());
  level.links.resize(level.link_begins.back());
  kernels::parallelForEach(level.nodes.size(), threads, [&](std::size_t i) {
    const std::uint32_t begin = level.link_begins[i];
    std::copy_n(
        beginOf(i), level.link_begins[i + 1] - begin, level.links.begin() + begin);
  });
}

float
firstCell(double noise, float spacing)
{
  return (cell_spacings + cell_per_noise * static_cast<float>(noise)) * spacing;
}

double
firstLink(double cell, double max_spacing)
{
  return link_cells * std::max(cell, max_spacing);
}

double
layerReach(double noise, float spacing)
{
  return noise > layer_noise ? link_cells * firstCell(noise, spacing) : 0.0;
}

PlaceInOrder
inOrder(const std::array<float, 3>& place, float cell)
{
  return {cellOf(place.data(), cell), place};
}

FacePyramid
firstFaces(const XYZView& points,
           const ShapeField& field,
           float spacing,
           unsigned threads)
{
  FacePyramid pyramid;
  pyramid.node_of_point.assign(points.size, FacePyramid::none);
  pyramid.levels.resize(1);
  FaceLevel& first = pyramid.levels.front();
  first.cell = firstCell(field.noise, spacing);
  if (!(first.cell > 0.0f)) // half of the points share a place with 12 others
    return {};
  const bool are_thick = field.noise > layer_noise;
  const float min_distance =
      are_thick ? sheet_deviations * static_cast<float>(field.noise) * spacing
                : one_sheet;
  collectNodes(points, field, min_distance, threads, pyramid);
  if (are_thick)
    joinLayers(first, threads);
  linkFirst(first, min_distance, threads);
  refineNormals(first, threads);
  cutLinks(first, min_distance);
  refineNormals(first, threads);
  return pyramid;
}

void
addLevels(std::size_t levels, FacePyramid& pyramid, unsigned threads)
{
  while (pyramid.levels.size() < levels) {
    FaceLevel next = nextLevel(pyramid.levels.back(), threads);
    refineNormals(next, threads);
    cutLinks(next, one_sheet);
    pyramid.levels.push_back(std::move(next));
  }
}

const std::vector<std::uint32_t>&
FaceWindow::around(std::uint32_t node, float radius, float min_cosine)
{
  ++search_;
  found_.assign(1, node);
  visits_[node] = search_;
  // Local: what is written might be a member.
  const FaceNode* const nodes = level_.nodes.data();
  const std::uint32_t* const links = level_.links.data();
  std::uint32_t* const visits = visits_.data();
  const std::uint32_t search = search_;
  const Vector3f position = nodes[node].position, normal = nodes[node].normal;
  for (std::size_t at = 0; at < found_.size(); ++at) {
    const std::uint32_t from = found_[at];
    const std::uint32_t* const end = links + level_.link_begins[from + 1];
    for (const std::uint32_t* link = links + level_.link_begins[from]; link < end;
         ++link) {
      const std::uint32_t to = *link;
      if (visits[to] == search)
        continue;
      visits[to] = search;
      if ((nodes[to].position - position).squaredNorm() < radius * radius &&
          std::abs(nodes[to].normal.dot(normal)) > min_cosine)
        found_.push_back(to);
    }
  }
  return found_;
}

} // namespace pcl::segmentation
