// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "ground/ground_cells.h"

#include "common/parallel.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::segmentation {
namespace {

std::uint32_t
keyOf(float squared_range)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &squared_range, sizeof bits);
  return bits >> key_shift;
}

} // namespace

float
leastOf(std::uint32_t key)
{
  const std::uint32_t bits = key << key_shift;
  float squared_range = 0.0f;
  std::memcpy(&squared_range, &bits, sizeof bits);
  return squared_range;
}

Turned
turned(const detail::GroundQuery& input, const std::array<float, 3>& direction)
{
  const Eigen::Vector3f up = Eigen::Map<const Eigen::Vector3f>(direction.data());
  const Eigen::Matrix3f turn =
      Eigen::Quaternionf::FromTwoVectors(up, Eigen::Vector3f::UnitZ())
          .toRotationMatrix();
  const Eigen::Vector3f origin = Eigen::Map<const Eigen::Vector3f>(input.origin.data());
  const auto make = [&](auto& values) { values.resize(input.size); };
  Turned t;
  make(t.x), make(t.y), make(t.z), make(t.cells);
  kernels::parallelForRanges(
      input.size, input.threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
          const std::size_t at =
              input.indices ? static_cast<std::size_t>(input.indices[i]) : i;
          const Eigen::Vector3f p =
              turn * (Eigen::Map<const Eigen::Vector3f>(input.points[at]) - origin);
          t.x[i] = p.x();
          t.y[i] = p.y();
          t.z[i] = p.z();
          const float squared = p.x() * p.x() + p.y() * p.y();
          const bool is_finite = (squared - squared) + (p.z() - p.z()) == 0.0f;
          t.cells[i] = is_finite ? keyOf(squared) : no_cell;
        }
      });
  return t;
}

std::vector<std::uint32_t>
countKeys(const Turned& points)
{
  std::vector<std::uint32_t> counts(keys, 0);
  for (const std::uint32_t key : points.cells)
    if (key != no_cell)
      ++counts[key];
  return counts;
}

std::uint32_t
keyAt(const std::vector<std::uint32_t>& counts, std::uint64_t points, double share)
{
  std::uint64_t sum = 0;
  std::uint32_t key = 0;
  while (key + 1 < keys &&
         static_cast<double>(sum += counts[key]) < share * static_cast<double>(points))
    ++key;
  return key;
}

namespace {

constexpr std::uint32_t ring_octaves = 16; // of the squared range: 1 to 256
constexpr std::uint32_t sectors = 256;     // about half as wide as cells are deep
// An evenly sampled disc has half of its points within 0.73 of the range of 95 %, a
// straight road 0.53. A spinning laser has the same number in each octave of elevation.
constexpr double laser_ratio = 0.47;
constexpr double points_a_square = 8.0;
constexpr float most_squares = 2048.0f; // in a line, and lines

struct Layout {
  std::uint32_t lines = 0;
  std::uint32_t bins = 0; ///< in a line
};

template <typename CellOf>
void
assignCells(Turned& points, unsigned threads, const CellOf& cellOf)
{
  kernels::parallelForRanges(
      points.cells.size(), threads, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
          if (points.cells[i] != no_cell)
            points.cells[i] = cellOf(points.x[i], points.y[i], points.cells[i]);
      });
}

/** Sectors by the angle on a square instead of a circle: no trigonometry. */
Layout
assignSectors(Turned& points, unsigned threads, std::uint32_t last_key)
{
  constexpr std::uint32_t bins = ring_octaves * keys_an_octave;
  const std::uint32_t first_key = last_key < bins ? 0 : last_key + 1 - bins;
  assignCells(points, threads, [=](float x, float y, std::uint32_t key) {
    constexpr float least = std::numeric_limits<float>::min();
    const float side = y / std::max(std::abs(x) + std::abs(y), least);
    const float turn = x >= 0.0f ? 1.0f + side : 3.0f - side; // 0 to 4
    const auto sector = static_cast<std::uint32_t>(turn * (sectors / 4.0f));
    const std::uint32_t bin = std::clamp(key, first_key, last_key) - first_key;
    return std::min(sector, sectors - 1) * bins + bin;
  });
  return {sectors, bins};
}

/** The bounds of a coordinate, within a limit. */
struct Bounds {
  float low = std::numeric_limits<float>::infinity();
  float high = -std::numeric_limits<float>::infinity();

  Bounds(const std::vector<float>& values, const Turned& points, float limit)
  {
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (points.cells[i] != no_cell) {
        const float value = std::clamp(values[i], -limit, limit);
        low = std::min(low, value);
        high = std::max(high, value);
      }
    }
  }
};

Layout
assignSquares(Turned& points, unsigned threads, std::uint64_t count, float limit)
{
  const Bounds x(points.x, points, limit), y(points.y, points, limit);
  const double width = double{x.high} - x.low, height = double{y.high} - y.low;
  const double edge = std::max(
      {std::sqrt(points_a_square * width * height / static_cast<double>(count)),
       std::max(width, height) / most_squares,
       double{std::numeric_limits<float>::min()}});
  const auto cells = [&](double length) {
    return static_cast<std::uint32_t>(std::min<double>(length / edge, most_squares)) +
           1;
  };
  const Layout layout{cells(height), cells(width)};
  const auto a_metre = static_cast<float>(1.0 / edge);
  const auto cell = [=](float value, float low, std::uint32_t size) {
    const float at =
        std::clamp((value - low) * a_metre, 0.0f, static_cast<float>(size - 1));
    return static_cast<std::uint32_t>(at);
  };
  assignCells(points, threads, [=](float px, float py, std::uint32_t) {
    return cell(py, y.low, layout.lines) * layout.bins + cell(px, x.low, layout.bins);
  });
  return layout;
}

/** Sort by counting. */
void
sortIntoCells(const Turned& points, const Layout& layout, GroundCells& cells)
{
  std::vector<std::uint32_t> next(std::size_t{layout.lines} * layout.bins, 0);
  for (const std::uint32_t cell : points.cells)
    if (cell != no_cell)
      ++next[cell];
  std::uint32_t begin = 0;
  for (std::uint32_t line = 0; line < layout.lines; ++line) {
    cells.lines.push_back(static_cast<std::uint32_t>(cells.size()));
    for (std::uint32_t bin = 0; bin < layout.bins; ++bin) {
      std::uint32_t& of_cell = next[std::size_t{line} * layout.bins + bin];
      if (of_cell == 0)
        continue;
      cells.begins.push_back(begin);
      cells.bins.push_back(bin);
      begin += of_cell;
      of_cell = cells.begins.back();
    }
  }
  cells.lines.push_back(static_cast<std::uint32_t>(cells.size()));
  cells.begins.push_back(begin);
  for (auto* values : {&cells.x, &cells.y, &cells.z})
    values->resize(begin);
  cells.positions.resize(begin);
  for (std::size_t i = 0; i < points.cells.size(); ++i) {
    if (points.cells[i] == no_cell)
      continue;
    const std::uint32_t at = next[points.cells[i]]++;
    cells.positions[at] = static_cast<std::uint32_t>(i);
    cells.x[at] = points.x[i];
    cells.y[at] = points.y[i];
    cells.z[at] = points.z[i];
  }
}

} // namespace

GroundCells
groundCells(const detail::GroundQuery& query, const std::array<float, 3>& up)
{
  Turned points = turned(query, up);
  const std::vector<std::uint32_t> counts = countKeys(points);
  std::uint64_t finite = 0;
  for (const std::uint32_t count : counts)
    finite += count;
  const auto rangeAt = [&](double share) {
    return std::sqrt(leastOf(keyAt(counts, finite, share)));
  };
  GroundCells cells;
  const std::uint32_t last_key = keyAt(counts, finite, 0.999);
  cells.extent = std::sqrt(leastOf(std::min(last_key + 1, keys - keys_an_octave - 1)));
  cells.around = rangeAt(0.5) < laser_ratio * rangeAt(0.95);
  const Layout layout =
      cells.around ? assignSectors(points, query.threads, last_key)
                   : assignSquares(points, query.threads, finite, cells.extent);
  sortIntoCells(points, layout, cells);
  return cells;
}

} // namespace pcl::segmentation
