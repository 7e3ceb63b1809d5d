// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Voxel means that do not depend on the order of the points, and which mean stands for
// a point.

#include "geometry/voxel_means.h"

#include "common/finite.h"
#include "common/number_text.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "geometry/cell_loop.h"
#include "geometry/point_choice.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

using namespace segmentation;

constexpr double max_cell = 1 << 30;
constexpr double float_digits = 1 << std::numeric_limits<float>::digits;

/** The finite points, by cells whose numbers are of z, y and x. */
std::vector<CellPoint>
sortedByVoxel(const XYZView& points, double size, unsigned threads)
{
  const auto along = [size](float coordinate) {
    return floorOf(std::clamp(coordinate / size, -max_cell, max_cell));
  };
  return sortedByCell(points, threads, [&](const float* p) -> Cell {
    return {along(p[2]), along(p[1]), along(p[0])};
  });
}

/** As std::llround, which is a call, of what is not negative. */
std::int32_t
rounded(double value)
{
  const std::int32_t whole = floorOf(value);
  return value - whole >= 0.5 ? whole + 1 : whole;
}

struct Size {
  float coordinate = 0.0f; ///< the largest, of either sign
  float extent = 0.0f;     ///< the largest
};

Size
sizeOf(const XYZView& points)
{
  const auto [low, high] = Bounds::of(points);
  if (!(low <= high).all())
    return {};
  return {low.abs().max(high.abs()).maxCoeff(), (high - low).maxCoeff()};
}

} // namespace

std::string
problemOfResolution(double resolution, const XYZView& points)
{
  const std::string given = "resolution is " + numberText(resolution) + " m: ";
  if (!(resolution > 0.0 && std::isfinite(resolution)))
    return given + "it must be positive and finite, or 0 for the cloud's own";
  const Size size = sizeOf(points);
  const double least = static_cast<double>(size.coordinate) / float_digits;
  if (resolution < least)
    return given + "it must be " + numberText(least) +
           " or more, what a float holds at the cloud's largest "
           "coordinate, " +
           numberText(static_cast<double>(size.coordinate)) + " m";
  if (size.extent > 0.0f && resolution >= static_cast<double>(size.extent))
    return given + "it must be less than the cloud's extent, " +
           numberText(static_cast<double>(size.extent)) + " m";
  return {};
}

std::vector<float>
voxelMeans(const XYZView& points, double size, unsigned threads)
{
  // Offsets within a cell are added up as integers: whatever the order of the points.
  constexpr double steps = 1 << 24;
  const std::vector<CellPoint> sorted = sortedByVoxel(points, size, threads);
  const std::vector<std::size_t> begins = beginsOfCells(sorted, threads);
  std::vector<float> means(3 * (begins.size() - 1));
  const auto setMean = [&](const auto begin, const auto end, std::size_t k) {
    const Cell& cell = begin->cell;
    std::array<std::int64_t, 3> sums{};
    for (auto at = begin; at != end; ++at)
      for (std::size_t axis = 0; axis < 3; ++axis) {
        const double cells = points[at->point][axis] / size;
        const double offset = std::min(cells - cell[2 - axis], 1.0); // of a far point
        sums[axis] += rounded(std::max(offset, 0.0) * steps);
      }
    const auto count = static_cast<double>(end - begin);
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double offset = static_cast<double>(sums[axis]) / (count * steps);
      means[3 * k + axis] = static_cast<float>((cell[2 - axis] + offset) * size);
    }
  };
  forEachCell(sorted, begins, threads, setMean);
  return means;
}

std::vector<std::uint32_t>
firstInVoxels(const XYZView& points, double size, unsigned threads)
{
  const std::vector<CellPoint> sorted = sortedByVoxel(points, size, threads);
  const std::vector<std::size_t> begins = beginsOfCells(sorted, threads);
  std::vector<std::uint32_t> first(begins.size() - 1);
  forEachCell(
      sorted, begins, threads, [&](const auto begin, const auto end, std::size_t k) {
        const auto least =
            std::min_element(begin, end, [&](const CellPoint& a, const CellPoint& b) {
              return isBefore(points, a.point, b.point);
            });
        first[k] = least->point;
      });
  return first;
}

std::vector<std::int32_t>
representatives(const XYZView& queries,
                const XYZView& surface,
                const std::vector<float>& spacings,
                unsigned threads)
{
  std::vector<std::int32_t> result(queries.size, -1);
  if (spacings.empty())
    return result;
  const float usual = median(spacings);
  const float most = *std::max_element(spacings.begin(), spacings.end());
  // Most points are so near to what stands for them that a part of a spacing finds it.
  const float near = 0.25f * usual;
  const PointGrid grid(surface, 2.0f * near, threads);
  const auto nearestWithin = [&](const Eigen::Vector3f& query, float radius) {
    std::int32_t nearest = -1;
    float least = std::numeric_limits<float>::infinity();
    grid.forEachWithin(query, radius, [&](std::uint32_t i, float squared) {
      const bool is_nearer =
          squared < least ||
          (squared == least &&
           isBefore(surface, i, static_cast<std::uint32_t>(nearest)));
      if (is_nearer && squared < spacings[i] * spacings[i]) {
        least = squared;
        nearest = static_cast<std::int32_t>(i);
      }
    });
    return nearest;
  };
  kernels::parallelForEach(queries.size, threads, [&](std::size_t q) {
    if (!kernels::isFinite(queries[q]))
      return;
    for (const float radius : {near, 2.0f * near, usual, most})
      if (result[q] < 0)
        result[q] = nearestWithin(positionOf(queries, q), radius);
  });
  return result;
}

} // namespace pcl::detail
