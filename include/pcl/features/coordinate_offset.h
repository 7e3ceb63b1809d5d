// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Coordinates too large for float: an offset to subtract in double.

#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>
#include <vector>

namespace pcl {

/** \brief Points in double, as files with large coordinates have them. */
using DoubleXYZ = std::vector<std::array<double, 3>>;

/** \brief What a cloud's coordinates need of float. */
struct CoordinateScale {
  std::array<double, 3> center{}; ///< the median along each axis
  double extent = 0.0;            ///< the largest along an axis, without outliers
  double largest = 0.0;           ///< coordinate, without its sign
  double spacing = 0.0;           ///< estimated as that of a surface of this extent

  /** \brief The distance between neighboring floats at the largest coordinate. */
  double
  floatSpacing() const
  {
    const auto value = static_cast<float>(largest);
    return static_cast<double>(
        std::nextafter(value, std::numeric_limits<float>::infinity()) - value);
  }
};

/** \brief The same from what is known of the finite points. \param[in] count of them
 * \param[in] of_points how many there are, if these are a sample of them \param[in]
 * quantile of an axis and a share, from 0 to 1: the value at the place share * (count -
 * 1), rounded down, of the sorted coordinates */
template <typename Quantile>
CoordinateScale
coordinateScaleOf(std::size_t count, std::size_t of_points, const Quantile& quantile)
{
  // Stray returns are far away; a percent on either side is more than their share.
  constexpr double outliers = 0.01;
  CoordinateScale scale;
  if (count == 0)
    return scale;
  std::array<double, 3> extents{};
  for (std::size_t c = 0; c < 3; ++c) {
    scale.center[c] = quantile(c, 0.5);
    const double low = quantile(c, outliers), high = quantile(c, 1.0 - outliers);
    extents[c] = high - low;
    scale.largest = std::max({scale.largest, std::abs(low), std::abs(high)});
  }
  std::sort(extents.begin(), extents.end());
  scale.extent = extents[2];
  // n points on a surface of a x b, or at least on a line of length a.
  const auto n = static_cast<double>(std::max(count, of_points));
  scale.spacing = std::max(std::sqrt(extents[2] * extents[1] / n), extents[2] / n);
  return scale;
}

/** \brief Measure the finite points; all zero if there is none. It does not depend on
 * their order. \param[in] points some may be NaN or infinite
 * \param[in] of_points how many there are, if these are a sample of them
 */
inline CoordinateScale
coordinateScale(const DoubleXYZ& points, std::size_t of_points = 0)
{
  const auto isFinite = [](const std::array<double, 3>& p) {
    return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
  };
  const auto count =
      static_cast<std::size_t>(std::count_if(points.begin(), points.end(), isFinite));
  std::vector<double> values; // along the axis that was asked for last
  values.reserve(count);
  std::size_t axis = 3;
  return coordinateScaleOf(count, of_points, [&](std::size_t c, double share) {
    if (axis != c) {
      axis = c;
      values.clear();
      for (const std::array<double, 3>& p : points)
        if (isFinite(p))
          values.push_back(p[c]);
    }
    const auto place = values.begin() + static_cast<std::ptrdiff_t>(
                                            share * static_cast<double>(count - 1));
    std::nth_element(values.begin(), place, values.end());
    return *place;
  });
}

/** \brief An offset for coordinates that are too large for float: 0 where float holds
 * them to a thousandth of the points' spacing, which is finer than any sensor, else the
 * median of the points, rounded to the power of ten above their extent.
 *
 * Subtract it in double, before anything becomes a float. */
inline std::array<double, 3>
coordinateOffset(const CoordinateScale& scale)
{
  constexpr double precision = 1e-3;
  std::array<double, 3> offset{};
  const bool is_held = scale.floatSpacing() <= precision * scale.spacing;
  if (is_held || scale.largest == 0.0)
    return offset;
  // All points at one place: to the unit.
  const double unit =
      scale.extent > 0.0 ? std::pow(10.0, std::ceil(std::log10(scale.extent))) : 1.0;
  for (std::size_t c = 0; c < offset.size(); ++c) {
    // Dividing by a whole number is exact where multiplying by 0.01 is not.
    const double rounded = unit < 1.0
                               ? std::round(scale.center[c] * std::round(1.0 / unit)) /
                                     std::round(1.0 / unit)
                               : std::round(scale.center[c] / unit) * unit;
    offset[c] = std::abs(rounded) <= scale.extent ? 0.0 : rounded;
  }
  return offset;
}

/** \brief Whether more than so many of the points share an x. */
inline bool
shareX(const DoubleXYZ& points, std::size_t most)
{
  std::vector<double> xs;
  xs.reserve(points.size());
  for (const std::array<double, 3>& p : points)
    xs.push_back(p[0]);
  std::sort(xs.begin(), xs.end());
  for (std::size_t i = most; i < xs.size(); ++i)
    if (xs[i] == xs[i - most])
      return true;
  return false;
}

/** \brief The finite points, without those of places where more than one and more than
 * a percent of them are, as the 0,0,0 or -9999 that stands for no return; sorted, if
 * there is such a place. All of them if no others are left. */
inline DoubleXYZ
withoutFillers(DoubleXYZ points)
{
  const auto isNotFinite = [](const std::array<double, 3>& p) {
    return !std::isfinite(p[0]) || !std::isfinite(p[1]) || !std::isfinite(p[2]);
  };
  points.erase(std::remove_if(points.begin(), points.end(), isNotFinite), points.end());
  const std::size_t most = std::max<std::size_t>(1, points.size() / 100);
  if (!shareX(points, most))
    return points;
  std::sort(points.begin(), points.end());
  DoubleXYZ others;
  for (auto place = points.begin(); place != points.end();) {
    const auto next = std::find_if(
        place, points.end(), [&](const auto& other) { return other != *place; });
    const bool are_fillers = static_cast<std::size_t>(next - place) > most;
    others.insert(others.end(), are_fillers ? next : place, next);
    place = next;
  }
  return others.empty() ? points : others;
}

/** \brief The same of points, without the fillers among them. */
inline std::array<double, 3>
coordinateOffset(DoubleXYZ points)
{
  return coordinateOffset(coordinateScale(withoutFillers(std::move(points))));
}

/** \brief The distance between neighboring floats at the largest coordinate of points
 * that were floats, if it has destroyed their neighborhoods: if it is a quarter or more
 * of the distance from a point to the nearest other place, in the median. Else 0.
 * \tparam PointAt a callable, from a std::size_t to a std::array of three doubles
 * \param[in] size how many points there are
 * \param[in] pointAt the coordinates of a point, which may be NaN
 * \return the distance, or 0
 */
template <typename PointAt>
double
destructiveFloatSpacing(std::size_t size, const PointAt& pointAt)
{
  const auto someFinite = [&](std::size_t stride) {
    DoubleXYZ some;
    for (std::size_t i = 0; i < size; i += stride)
      if (const std::array<double, 3> p = pointAt(i);
          std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]))
        some.push_back(p);
    return some;
  };
  constexpr std::size_t scale_samples = 4096; // enough for an order of magnitude
  const CoordinateScale scale =
      coordinateScale(someFinite(1 + size / scale_samples), size);
  const double step = scale.floatSpacing();
  // The estimate of the spacing is too large where points are in clusters or on few
  // lines, but not ten thousand times: look where there is any doubt.
  constexpr double surely_held = 1e-4;
  if (scale.largest == 0.0 || step < surely_held * scale.spacing)
    return 0.0;
  constexpr std::size_t median_samples = 15; // for an order of magnitude
  constexpr double destroyed = 0.25;
  const double reach = step / destroyed;
  DoubleXYZ samples = someFinite(std::max<std::size_t>(1, size / median_samples));
  const std::size_t count = samples.size();
  for (std::size_t i = 0; i < size && 2 * samples.size() >= count; ++i) {
    const std::array<double, 3> p = pointAt(i);
    const auto isNear = [&](const std::array<double, 3>& sample) {
      const double x = p[0] - sample[0];
      if (!(std::abs(x) <= reach))
        return false;
      const double y = p[1] - sample[1], z = p[2] - sample[2];
      const double squared = x * x + y * y + z * z;
      return squared > 0.0 && squared <= reach * reach;
    };
    samples.erase(std::remove_if(samples.begin(), samples.end(), isNear),
                  samples.end());
  }
  return 2 * samples.size() < count ? step : 0.0;
}

/** \brief The distance between neighboring floats that has destroyed the neighborhoods
 * of points, as above.
 * \param[in] points the coordinates, which may be NaN
 * \return the distance, or 0
 */
inline double
destructiveFloatSpacing(const DoubleXYZ& points)
{
  return destructiveFloatSpacing(points.size(),
                                 [&](std::size_t i) { return points[i]; });
}

} // namespace pcl
