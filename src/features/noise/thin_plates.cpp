// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far the other side of a thin plate is from a point.

#include "features/noise/thin_plates.h"

#include "common/gathered.h"
#include "common/statistics.h"
#include "features/noise/edge_radii.h"
#include "features/spacing/local_spacing.h"
#include "features/spacing/points_near.h"
#include "features/spacing/some_points.h"
#include "geometry/point_grid.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

namespace pcl::detail {
namespace {

using namespace segmentation;
using edge_radii::normal_radius;
using Eigen::Vector3f;

// Of the column above and below a point, and of what belongs to its side in the noise
// that is measured at most, spacings.
constexpr float column = 0.5f, side = 0.6f;
// Of the points of the other side, halfway to it: with noise of 0.2 spacings on a plate
// 1.7 thick it is a tenth, in noise as thick as the plate a quarter and more.
constexpr double most_between = 0.15;

float
thicknessAt(const Vector3f& place,
            const Vector3f& normal,
            float spacing,
            float reach,
            const XYZView& points,
            const PointGrid& grid)
{
  if (!normal.allFinite())
    return 0.0f;
  std::vector<float> heights, others; // spacings
  grid.forEachWithin(place, reach, [&](std::uint32_t i, float squared) {
    const float height = std::abs((positionOf(points, i) - place).dot(normal));
    if (squared - height * height >= column * column * spacing * spacing)
      return;
    heights.push_back(height / spacing);
    if (heights.back() >= side)
      others.push_back(heights.back());
  });
  if (others.empty() || 3 * others.size() < heights.size())
    return 0.0f;
  const float thickness = median(others);
  const auto between = std::count_if(heights.begin(), heights.end(), [&](float height) {
    return height > thickness / 3.0f && height < 2.0f * thickness / 3.0f;
  });
  return static_cast<double>(between) >
                 most_between * static_cast<double>(others.size())
             ? 0.0f
             : thickness;
}

} // namespace

std::vector<float>
thicknessesAt(const pcl::Indices& chosen,
              const Neighborhoods& neighborhoods,
              const std::vector<float>& spacings,
              float reach,
              unsigned threads)
{
  if (chosen.empty())
    return {};
  const std::vector<float> normals = normalsWithCurvature(
      neighborhoods.among(chosen), times(normal_radius, gathered(spacings, chosen)));
  constexpr int cells = 1;
  const PointsNear near(
      neighborhoods.input(), chosen, static_cast<double>(reach), cells, threads);
  const PointGrid grid(near.view(), reach);
  std::vector<float> thicknesses;
  for (std::size_t k = 0; k < chosen.size(); ++k)
    thicknesses.push_back(
        thicknessAt(positionOf(near.view(), static_cast<std::size_t>(near.some()[k])),
                    Vector3f(&normals[4 * k]),
                    spacings[static_cast<std::size_t>(chosen[k])],
                    reach,
                    near.view(),
                    grid));
  return thicknesses;
}

double
plateThickness(std::vector<float> thicknesses)
{
  const std::size_t points = thicknesses.size();
  thicknesses.erase(std::remove(thicknesses.begin(), thicknesses.end(), 0.0f),
                    thicknesses.end());
  return 3 * thicknesses.size() > 2 * points
             ? static_cast<double>(median(std::move(thicknesses)))
             : 0.0;
}

double
plateThickness(const Neighborhoods& neighborhoods,
               const std::vector<float>& spacings,
               unsigned threads)
{
  return plateThickness(thicknessesAt(somePoints(neighborhoods.input(), plate_points),
                                      neighborhoods,
                                      spacings,
                                      plate_spacings * medianSpacing(spacings),
                                      threads));
}

} // namespace pcl::detail
