// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The places of a scan: its different points, in the frame of the sensor.

#include "ground/ground_places.h"

#include "common/parallel.h"

#include <Eigen/Geometry>

#include <array>
#include <cstring>

namespace pcl::segmentation {
namespace {

/** The places so far, by their coordinates: open addressing, at most two thirds full.
 */
class PlaceTable {
public:
  explicit PlaceTable(std::size_t points)
  {
    while (2 * (std::size_t{1} << bits_) < 3 * points)
      ++bits_;
    slots_.assign(std::size_t{1} << bits_, no_place);
  }

  /** The place of a point, a new one if it is the first there. */
  std::uint32_t
  placeOf(float x, float y, float z, GroundPlaces& places)
  {
    const auto next = static_cast<std::uint32_t>(places.x.size());
    for (std::size_t slot = slotOf(x, y, z);; slot = (slot + 1) & (slots_.size() - 1)) {
      std::uint32_t& place = slots_[slot];
      if (place == no_place) {
        place = next;
        places.x.push_back(x);
        places.y.push_back(y);
        places.z.push_back(z);
        return next;
      }
      if (places.x[place] == x && places.y[place] == y && places.z[place] == z)
        return place;
    }
  }

private:
  std::size_t
  slotOf(float x, float y, float z) const
  {
    // Odd numbers without a pattern, of the golden ratio and of splitmix64.
    constexpr std::uint64_t first = 0x9E3779B97F4A7C15U, second = 0xBF58476D1CE4E5B9U;
    const std::array<float, 3> values{x + 0.0f, y + 0.0f, z + 0.0f}; // -0 is 0
    std::array<std::uint32_t, 3> words{};
    std::memcpy(words.data(), values.data(), sizeof words);
    std::uint64_t hash = (words[0] | std::uint64_t{words[1]} << 32) * first;
    hash = ((hash ^ hash >> 32) + words[2]) * second;
    return static_cast<std::size_t>(hash >> (64 - bits_));
  }

  unsigned bits_ = 4;
  std::vector<std::uint32_t> slots_;
};

/** Where a driver may put rays that did not return. */
enum FillerPlace : std::size_t { AtSensor, AtZero, Elsewhere };

FillerPlace
fillerPlaceOf(const Eigen::Vector3f& point, const Eigen::Vector3f& sensor)
{
  if (point == sensor)
    return AtSensor;
  return point.isZero(0.0f) ? AtZero : Elsewhere;
}

/** Fillers are at one place, and more than twice as many as points are at a place on
 * average: one point there may have been measured, as may all if all are repeated. */
std::array<bool, 2>
fillersOf(const std::array<std::size_t, 3>& counts, std::size_t places)
{
  std::array<bool, 2> are{};
  for (const FillerPlace at : {AtSensor, AtZero})
    are[at] = counts[at] * places > 2 * counts[Elsewhere];
  return are;
}

} // namespace

GroundPlaces
groundPlaces(const detail::GroundQuery& query, const Eigen::Vector3f& up)
{
  const Eigen::Matrix3f turn =
      Eigen::Quaternionf::FromTwoVectors(up, Eigen::Vector3f::UnitZ())
          .toRotationMatrix();
  const Eigen::Vector3f origin(query.origin);
  GroundPlaces places;
  for (auto* values : {&places.x, &places.y, &places.z})
    values->reserve(query.size);
  places.of_points.assign(query.size, no_place);
  PlaceTable table(query.size);
  std::array<std::size_t, 3> counts{};
  std::array<std::vector<std::size_t>, 2> maybe_fillers;
  for (std::size_t i = 0; i < query.size; ++i) {
    const Eigen::Map<const Eigen::Vector3f> point(
        query.points[static_cast<std::size_t>(query.indices[i])]);
    const Eigen::Vector3f p = turn * (point - origin);
    const float squared = p.x() * p.x() + p.y() * p.y();
    if ((squared - squared) + (p.z() - p.z()) != 0.0f)
      continue; // not finite
    const FillerPlace at = fillerPlaceOf(point, origin);
    ++counts[at];
    if (at != Elsewhere)
      maybe_fillers[at].push_back(i);
    else
      places.of_points[i] = table.placeOf(p.x(), p.y(), p.z(), places);
  }
  const std::array<bool, 2> are_fillers = fillersOf(counts, places.x.size());
  for (const FillerPlace at : {AtSensor, AtZero})
    for (const std::size_t i : maybe_fillers[at]) {
      if (are_fillers[at])
        break;
      const Eigen::Vector3f p =
          at == AtSensor ? Eigen::Vector3f(Eigen::Vector3f::Zero()) : turn * -origin;
      places.of_points[i] = table.placeOf(p.x(), p.y(), p.z(), places);
    }
  return places;
}

} // namespace pcl::segmentation
