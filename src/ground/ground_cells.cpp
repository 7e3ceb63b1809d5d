// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a scan, sorted into cells that follow their density.

#include "ground/ground_cells.h"

#include "common/gathered.h"

#include <pcl/features/distinct_points.h>

#include <Eigen/Geometry>

#include <array>
#include <cmath>
#include <cstring>

namespace pcl::segmentation {
namespace {

/** Where a driver may put rays that did not return. */
enum FillerPlace : std::size_t { AtSensor, AtZero, Elsewhere };

FillerPlace
fillerPlaceOf(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor)
{
  if (point == sensor)
    return AtSensor;
  return point.isZero(0.0f) ? AtZero : Elsewhere;
}

/** Points in the frame of the ground, and which ones of the query they are. */
struct PointsInFrame {
  std::vector<float> positions;
  std::vector<std::size_t> points;

  XYZView
  view() const
  {
    return detail::viewOfPositions(positions);
  }

  void
  add(const Eigen::Vector3f& position, std::size_t point)
  {
    positions.insert(positions.end(), position.data(), position.data() + 3);
    points.push_back(point);
  }

  void
  add(const PointsInFrame& others)
  {
    positions.insert(positions.end(), others.positions.begin(), others.positions.end());
    points.insert(points.end(), others.points.begin(), others.points.end());
  }
};

// The first bits of a squared range as a float, its exponent and three of its mantissa,
// are a scale of 8 steps per octave, 16 per octave of the range.
constexpr int key_shift = 20;
constexpr std::uint32_t keys_per_octave = bins_per_octave / 2;
constexpr std::uint32_t keys = 1U << (31 - key_shift);

constexpr std::uint32_t ring_bins = 16 * keys_per_octave; // ranges of 1 to 256
constexpr std::uint32_t sectors = 256; // 1.6 to 3.1 %: half as wide as cells are deep
// The range of half of the points over that of 95 %: an evenly sampled disc has 0.73, a
// straight road 0.53. A spinning laser has the same number in each octave of elevation.
constexpr double max_laser_ratio = 0.47;
constexpr double points_per_square = 8.0; // enough to have a lowest surface
constexpr float max_squares = 2048.0f;    // in a line, and lines: bounds the memory

/** Places and their cells. */
struct Points {
  const std::vector<float>&x, &y, &z;
  std::vector<std::uint32_t> cells; ///< first the keys of their ranges
};

std::uint32_t
keyOf(float squared_range)
{
  std::uint32_t bits = 0;
  std::memcpy(&bits, &squared_range, sizeof bits);
  return bits >> key_shift;
}

/** The smallest range of a key. */
float
rangeOf(std::uint32_t key)
{
  const std::uint32_t bits = key << key_shift;
  float squared_range = 0.0f;
  std::memcpy(&squared_range, &bits, sizeof bits);
  return std::sqrt(squared_range);
}

std::vector<std::uint32_t>
keysOf(const GroundPlaces& places, unsigned threads)
{
  std::vector<std::uint32_t> found(places.x.size());
  kernels::parallelForEach(found.size(), threads, [&](std::size_t i) {
    found[i] = keyOf(places.x[i] * places.x[i] + places.y[i] * places.y[i]);
  });
  return found;
}

struct Layout {
  std::uint32_t lines, bins; ///< bins in a line
};

template <typename CellOf>
void
assignCells(Points& points, unsigned threads, const CellOf& cellOf)
{
  kernels::parallelForEach(points.cells.size(), threads, [&](std::size_t i) {
    points.cells[i] = cellOf(points.x[i], points.y[i], points.cells[i]);
  });
}

/** Sectors by the angle on a square instead of a circle: no trigonometry. */
Layout
assignSectors(Points& points, unsigned threads, std::uint32_t last_key)
{
  const std::uint32_t first_key = last_key < ring_bins ? 0 : last_key + 1 - ring_bins;
  assignCells(points, threads, [=](float x, float y, std::uint32_t key) {
    constexpr float tiny = std::numeric_limits<float>::min();
    const float side = y / std::max(std::abs(x) + std::abs(y), tiny);
    const float turn = x >= 0.0f ? 1.0f + side : 3.0f - side; // 0 to 4
    const auto sector = static_cast<std::uint32_t>(turn * (sectors / 4.0f));
    const std::uint32_t bin = std::clamp(key, first_key, last_key) - first_key;
    return std::min(sector, sectors - 1) * ring_bins + bin;
  });
  return {sectors, ring_bins};
}

Layout
assignSquares(Points& points, unsigned threads, float limit)
{
  Eigen::AlignedBox2f box;
  for (std::size_t i = 0; i < points.cells.size(); ++i)
    box.extend(Eigen::Vector2f(std::clamp(points.x[i], -limit, limit),
                               std::clamp(points.y[i], -limit, limit)));
  const Eigen::Vector2f low = box.min();
  const Eigen::Vector2d size = box.max().cast<double>() - low.cast<double>();
  const double edge = std::max({std::sqrt(points_per_square * size.x() * size.y() /
                                          static_cast<double>(points.cells.size())),
                                size.maxCoeff() / max_squares,
                                double{std::numeric_limits<float>::min()}});
  const auto squares = [&](double length) {
    return static_cast<std::uint32_t>(std::min<double>(length / edge, max_squares)) + 1;
  };
  const Layout layout{squares(size.y()), squares(size.x())};
  const auto squares_per_meter = static_cast<float>(1.0 / edge);
  const auto square = [=](float from_low, std::uint32_t count) {
    return static_cast<std::uint32_t>(
        std::clamp(from_low * squares_per_meter, 0.0f, static_cast<float>(count - 1)));
  };
  assignCells(points, threads, [=](float x, float y, std::uint32_t) {
    return square(y - low.y(), layout.lines) * layout.bins +
           square(x - low.x(), layout.bins);
  });
  return layout;
}

/** Sort by counting. */
void
sortIntoCells(const Points& points, const Layout& layout, GroundCells& cells)
{
  std::vector<std::uint32_t> next(std::size_t{layout.lines} * layout.bins, 0);
  for (const std::uint32_t cell : points.cells)
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
  cells.places.resize(begin);
  for (std::size_t i = 0; i < points.cells.size(); ++i) {
    const std::uint32_t at = next[points.cells[i]]++;
    cells.places[at] = static_cast<std::uint32_t>(i);
    cells.x[at] = points.x[i];
    cells.y[at] = points.y[i];
    cells.z[at] = points.z[i];
  }
}

} // namespace

GroundPlaces
groundPlaces(const detail::GroundQuery& query, const Eigen::Vector3f& up)
{
  const Eigen::Matrix3f turn =
      Eigen::Quaternionf::FromTwoVectors(up, Eigen::Vector3f::UnitZ())
          .toRotationMatrix();
  const Eigen::Vector3f origin(query.origin);
  std::array<PointsInFrame, 3> found; // by FillerPlace
  for (std::size_t i = 0; i < query.size; ++i) {
    const Eigen::Map<const Eigen::Vector3f> point(
        query.points[static_cast<std::size_t>(query.indices[i])]);
    const Eigen::Vector3f p = turn * (point - origin);
    const float squared = p.x() * p.x() + p.y() * p.y();
    if ((squared - squared) + (p.z() - p.z()) == 0.0f) // finite
      found[fillerPlaceOf(point, origin)].add(p, i);
  }
  PointsInFrame& points = found[Elsewhere];
  DistinctPoints distinct = distinctPoints(points.view());
  const std::size_t count = points.points.size();
  const std::size_t places = distinct.hasRepeats() ? distinct.first.size() : count;
  // Fillers are at one place, and more than twice as many as points are at a place on
  // average: one point there may have been measured, as may all if all are repeated.
  for (const FillerPlace at : {AtSensor, AtZero})
    if (found[at].points.size() * places <= 2 * count)
      points.add(found[at]);
  if (points.points.size() > count)
    distinct = distinctPoints(points.view());
  GroundPlaces result;
  result.of_points.assign(query.size, no_place);
  for (std::size_t k = 0; k < points.points.size(); ++k) {
    const std::size_t place =
        distinct.hasRepeats() ? static_cast<std::size_t>(distinct.place[k]) : k;
    result.of_points[points.points[k]] = static_cast<std::uint32_t>(place);
    if (place < result.x.size())
      continue;
    const float* const p = points.view()[k];
    result.x.push_back(p[0]);
    result.y.push_back(p[1]);
    result.z.push_back(p[2]);
  }
  return result;
}

GroundCells
groundCells(const GroundPlaces& places, unsigned threads)
{
  Points points{places.x, places.y, places.z, keysOf(places, threads)};
  const auto size = static_cast<double>(points.cells.size());
  std::vector<std::uint32_t> counts(keys, 0);
  for (const std::uint32_t key : points.cells)
    ++counts[key];
  const auto keyAt = [&](double share) { // that a share of the points does not exceed
    std::uint64_t below = 0;
    std::uint32_t key = 0;
    while (key + 1 < keys && static_cast<double>(below += counts[key]) < share * size)
      ++key;
    return key;
  };
  const std::uint32_t last_key = keyAt(0.999); // without the few farthest
  GroundCells cells;
  cells.extent = rangeOf(std::min(last_key + 1, keys - keys_per_octave - 1));
  cells.around = rangeOf(keyAt(0.5)) < max_laser_ratio * rangeOf(keyAt(0.95));
  sortIntoCells(points,
                cells.around ? assignSectors(points, threads, last_key)
                             : assignSquares(points, threads, cells.extent),
                cells);
  return cells;
}

} // namespace pcl::segmentation
