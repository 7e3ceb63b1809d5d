// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fewer points where dense parts of a cloud meet sparse ones.

#include "features/spacing/even_sampling.h"

#include "common/finite.h"
#include "common/gathered.h"
#include "common/parallel.h"
#include "geometry/cells_around.h"
#include "geometry/point_grid.h"
#include "geometry/voxel_means.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <limits>
#include <map>

namespace pcl::detail {
namespace {

// Spacings are sorted into levels, two to an octave.
constexpr double levels_per_octave = 2.0;
// A change by more than a factor of 1.4 to 2 over this many spacings of the sparser
// part is a step: neighborhoods are up to 7 spacings wide, on either side of a point.
constexpr double reach_spacings = 6.0;
constexpr int max_level_step = 1;
constexpr std::size_t min_points = 4;  // fewer within reach are strays
constexpr double voxel_spacings = 0.5; // the mean distance of points at random
constexpr int no_level = std::numeric_limits<int>::min();

double
spacingOf(int level)
{
  return std::exp2(level / levels_per_octave);
}

int
levelOf(float spacing)
{
  return spacing > 0.0f && std::isfinite(spacing)
             ? static_cast<int>(std::floor(levels_per_octave *
                                           std::log2(static_cast<double>(spacing))))
             : no_level;
}

/** Points of a level, to find the denser ones near them. */
class Level {
public:
  Level(const XYZView& points,
        const std::vector<std::size_t>& members,
        double spacing,
        unsigned threads)
  : reach_(static_cast<float>(reach_spacings * spacing))
  , grid_(viewOfPositions(positionsAt(points, members)), reach_, threads)
  , cells_(reach_spacings * spacing, 1, members.size())
  {
    for (const std::size_t i : members)
      cells_.add(segmentation::positionOf(points, i));
  }

  bool
  isNear(const float* point) const
  {
    std::size_t count = 0;
    const Eigen::Map<const Eigen::Vector3f> place(point);
    return cells_.mayHold(place) &&
           grid_.anyWithin(place, reach_, [&](std::uint32_t, const Eigen::Vector3f&) {
             return ++count == min_points;
           });
  }

private:
  float reach_; ///< meters
  segmentation::PointGrid grid_;
  segmentation::CellsAround cells_; ///< most points are near none
};

/** The level that each point should have: its own, or a step below that of sparser
 * points near it; a step above points that are denser still, as far as these are near.
 */
std::vector<int>
wantedLevels(const XYZView& points, const std::vector<int>& levels, unsigned threads)
{
  std::map<int, std::vector<std::size_t>, std::greater<>> members;
  for (std::size_t i = 0; i < levels.size(); ++i)
    if (levels[i] != no_level)
      members[levels[i]].push_back(i);
  std::vector<int> wanted = levels;
  for (auto& [level, of_level] : members) {
    const auto is_raised = [&, here = level](std::size_t i) {
      return wanted[i] != here;
    };
    of_level.erase(std::remove_if(of_level.begin(), of_level.end(), is_raised),
                   of_level.end());
    if (of_level.size() < min_points)
      continue;
    const int below = level - max_level_step;
    const auto is_denser = [below](int wanted_level) {
      return wanted_level != no_level && wanted_level < below;
    };
    if (std::none_of(wanted.begin(), wanted.end(), is_denser))
      continue;
    const Level sparse(points, of_level, spacingOf(level), threads);
    std::vector<char> is_near_sparse(wanted.size());
    kernels::parallelForEach(wanted.size(), threads, [&](std::size_t i) {
      is_near_sparse[i] = is_denser(wanted[i]) && sparse.isNear(points[i]);
    });
    for (std::size_t i = 0; i < wanted.size(); ++i)
      if (is_near_sparse[i]) {
        wanted[i] = below;
        members[below].push_back(i);
      }
  }
  return wanted;
}

} // namespace

std::vector<float>
evenSampling(const XYZView& points,
             const std::vector<float>& spacings,
             unsigned threads)
{
  std::vector<int> levels(points.size);
  for (std::size_t i = 0; i < points.size; ++i)
    levels[i] = kernels::isFinite(points[i]) ? levelOf(spacings[i]) : no_level;
  const std::vector<int> wanted = wantedLevels(points, levels, threads);
  std::vector<float> even;
  std::map<int, std::vector<float>> too_dense;
  for (std::size_t i = 0; i < points.size; ++i) {
    if (!kernels::isFinite(points[i]))
      continue;
    std::vector<float>& to = wanted[i] == levels[i] ? even : too_dense[wanted[i]];
    to.insert(to.end(), points[i], points[i] + 3);
  }
  for (const auto& [level, positions] : too_dense) {
    const XYZView view = viewOfPositions(positions);
    const double size = voxel_spacings * spacingOf(level);
    const std::vector<float> means = problemOfResolution(size, view).empty()
                                         ? voxelMeans(view, size, threads)
                                         : positions;
    even.insert(even.end(), means.begin(), means.end());
  }
  return even;
}

} // namespace pcl::detail
