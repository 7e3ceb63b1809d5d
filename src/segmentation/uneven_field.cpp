// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which points of an uneven cloud take the values of means, and which creases stay.

#include "segmentation/uneven_field.h"

#include "common/gathered.h"
#include "common/statistics.h"
#include "edges/edge_detection.h"
#include "geometry/point_grid.h"

#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

using namespace segmentation;

// The spacing of means over that of the points that they stand for: less is chance.
constexpr float coarser = 1.5f;
// Of the points around a crease, for a sparse face beside a dense one has few of them:
// less are strays.
constexpr double one_side = 0.1;

void
takeValues(const ShapeField& from, std::size_t at, std::size_t i, ShapeField& field)
{
  field.spacings[i] = from.spacings[at];
  field.normals[i] = from.normals[at];
  field.edge_likelihood[i] = from.edge_likelihood[at];
}

/** Joins a field and that of means which stand for its points. */
class Joined {
public:
  Joined(const ShapeField& means,
         const std::vector<std::int32_t>& stands_for,
         ShapeField& field)
  : means_(means)
  , field_(field)
  , grid_(field.points, 2.0f * medianSpacing(field.spacings))
  , stands_for_(stands_for)
  , is_own_(field.points.size, 1)
  , is_taken_(means.points.size, 0)
  {}

  void
  takeValuesOfMeans(const std::vector<char>& keeps_own)
  {
    for (std::size_t i = 0; i < is_own_.size(); ++i) {
      if (stands_for_[i] < 0)
        continue;
      if (keeps_own[i] && !std::isnan(field_.edge_likelihood[i]))
        continue;
      const auto mean = static_cast<std::size_t>(stands_for_[i]);
      takeValues(means_, mean, i, field_);
      is_own_[i] = 0;
      is_taken_[mean] = 1;
    }
  }

  /** Those of all points: they are of whole faces. */
  void
  takeClassesOfMeans()
  {
    field_.classes = means_.classes;
    for (const std::vector<float>& of_means : means_.likelihoods)
      field_.likelihoods.push_back(
          gathered(of_means, stands_for_, std::numeric_limits<float>::quiet_NaN()));
  }

  /** Where dense and sparse faces meet, it may be that only the means show the crease.
   */
  void
  takeCreasesOfMeans()
  {
    const PointGrid means(means_.points, 2.0f * medianSpacing(means_.spacings));
    const std::vector<CreasePoint> taken = along(means_.creases, means, is_taken_);
    field_.creases = along(field_.creases, grid_, is_own_);
    field_.creases.insert(field_.creases.end(), taken.begin(), taken.end());
    for (const CreasePoint& crease : taken)
      markAlong(crease);
  }

private:
  /** The creases with enough of the points around them among the chosen. */
  static std::vector<CreasePoint>
  along(const std::vector<CreasePoint>& creases,
        const PointGrid& grid,
        const std::vector<char>& is_chosen)
  {
    std::vector<CreasePoint> found;
    for (const CreasePoint& crease : creases) {
      std::size_t points = 0, chosen = 0;
      grid.forEachWithin(Eigen::Map<const Eigen::Vector3f>(crease.position.data()),
                         crease.spacing,
                         [&](std::uint32_t i, float) {
                           ++points;
                           chosen += is_chosen[i] ? 1 : 0;
                         });
      if (one_side * static_cast<double>(points) < static_cast<double>(chosen))
        found.push_back(crease);
    }
    return found;
  }

  /** Points with values of their own, in their own band of a crease. */
  void
  markAlong(const CreasePoint& crease)
  {
    const float band = edgeBand(field_.noise_level);
    grid_.forEachWithin(
        Eigen::Map<const Eigen::Vector3f>(crease.position.data()),
        band * crease.spacing,
        [&](std::uint32_t i, float squared) {
          const float reach = band * field_.spacings[i];
          if (is_own_[i] && stands_for_[i] >= 0 && squared < reach * reach)
            raise(field_.edge_likelihood[i],
                  means_.edge_likelihood[static_cast<std::size_t>(stands_for_[i])]);
        });
  }

  static void
  raise(float& likelihood, float other)
  {
    if (other > likelihood)
      likelihood = other;
  }

  const ShapeField& means_;
  ShapeField& field_;
  PointGrid grid_; ///< of the field's points
  const std::vector<std::int32_t>& stands_for_;
  std::vector<char> is_own_;   ///< of each point: it keeps its values
  std::vector<char> is_taken_; ///< of each mean: a point takes its values
};

} // namespace

std::vector<char>
ownPoints(const ShapeField& means,
          const std::vector<std::int32_t>& stands_for,
          const std::vector<float>& spacings)
{
  std::vector<char> is_own(stands_for.size(), 1);
  for (std::size_t i = 0; i < is_own.size(); ++i)
    if (stands_for[i] >= 0) {
      const auto mean = static_cast<std::size_t>(stands_for[i]);
      if (!std::isnan(means.edge_likelihood[mean]) &&
          means.spacings[mean] <= coarser * spacings[i])
        is_own[i] = 0;
    }
  return is_own;
}

void
takeFromMeans(const ShapeField& means,
              const std::vector<std::int32_t>& stands_for,
              const std::vector<char>& keeps_own,
              ShapeField& field)
{
  Joined joined(means, stands_for, field);
  joined.takeValuesOfMeans(keeps_own);
  joined.takeClassesOfMeans();
  joined.takeCreasesOfMeans();
}

} // namespace pcl::detail
