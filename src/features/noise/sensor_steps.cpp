// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether points lie on the steps of a sensor that are wider than their neighborhoods.

#include "features/noise/sensor_steps.h"

#include "common/gathered.h"
#include "features/noise/edge_radii.h"
#include "features/noise/normal_scatter.h"
#include "features/noise/thin_plates.h"
#include "features/spacing/points_near.h"
#include "geometry/voxel_means.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace pcl::detail {
namespace {

using namespace segmentation;
using edge_radii::inad_radius, edge_radii::normal_radius;

// The means of the next resolution, and of coarser ones for wider steps: a Kinect's at
// 9 meters, the widest of a common sensor, are eight spacings wide.
constexpr double voxel = 0.8; // spacings
constexpr std::array<double, std::tuple_size_v<AreasOfMeans>> growths{1.0, 2.0};
constexpr double means_spacing = 1.9; // voxels: to the 12th mean on a plane

// To what the normal of a mean beside the place depends on, and more, in their
// spacings.
constexpr double normal_reach = 1.5;

constexpr float bent = 0.09f;    // radians, 5 degrees: means on a plane differ by less
constexpr float parallel = 0.5f; // of that angle: of a shape the points' is larger

/** Some points of a cloud, and what tells a step from a shape there. */
class Samples {
public:
  Samples(const pcl::Indices& chosen,
          const Neighborhoods& neighborhoods,
          const std::vector<float>& spacings,
          double spacing,
          unsigned threads)
  : chosen_(chosen)
  , neighborhoods_(neighborhoods)
  , spacings_(spacings)
  , spacing_(spacing)
  , places_(positionsAt(neighborhoods.input(), chosen))
  , threads_(threads)
  {}

  /** As means show them. \param[in] size of the means' voxels, meters */
  StepAreas
  areas(const std::vector<float>& means, double size) const
  {
    const double radius = means_spacing * size;
    const std::vector<float> of_means = anglesOfMeans(means, radius);
    const std::vector<float> of_points =
        NormalScatter(neighborhoods_, spacings_, chosen_, radius / spacing_, threads_)(
            normal_radius, radius / spacing_);
    StepAreas areas;
    pcl::Indices on_steps;
    for (std::size_t k = 0; k < chosen_.size(); ++k) {
      if (!std::isfinite(of_means[k]) || !std::isfinite(of_points[k]))
        continue;
      areas.all += areaOf(chosen_[k]);
      if (of_means[k] <= bent)
        continue;
      areas.bent += areaOf(chosen_[k]);
      if (of_points[k] < parallel * of_means[k])
        on_steps.push_back(chosen_[k]);
    }
    const std::vector<float> thicknesses =
        thicknessesAt(on_steps,
                      neighborhoods_,
                      spacings_,
                      static_cast<float>(normal_reach * radius),
                      threads_);
    for (std::size_t k = 0; k < on_steps.size(); ++k) {
      areas.on_steps += areaOf(on_steps[k]);
      areas.thick += thicknesses[k] > 0.0f ? areaOf(on_steps[k]) : 0;
    }
    return areas;
  }

private:
  /** What a point stands for, in thousandths of a square of the cloud's spacing: sums
   * of whole numbers do not depend on the order. */
  std::int64_t
  areaOf(pcl::index_t point) const
  {
    constexpr double parts = 1000.0;
    const double spacings =
        static_cast<double>(spacings_[static_cast<std::size_t>(point)]) / spacing_;
    return std::llround(parts * spacings * spacings);
  }

  /** Between the normals of means around the mean that is nearest to each sample; NaN
   * where there is none. */
  std::vector<float>
  anglesOfMeans(const std::vector<float>& means, double radius) const
  {
    const XYZView view = viewOfPositions(means);
    const std::vector<float> spacings(view.size, static_cast<float>(radius));
    const std::vector<std::int32_t> nearest =
        representatives(viewOfPositions(places_), view, spacings, threads_);
    pcl::Indices near(nearest.begin(), nearest.end());
    std::sort(near.begin(), near.end());
    near.erase(std::unique(near.begin(), near.end()), near.end());
    near.erase(near.begin(), std::lower_bound(near.begin(), near.end(), 0));
    const Neighborhoods neighborhoods(view, threads_);
    const std::vector<float> angles =
        NormalScatter(neighborhoods, spacings, near, inad_radius, threads_)(
            normal_radius, inad_radius);
    std::vector<std::int32_t> at;
    at.reserve(nearest.size());
    for (const std::int32_t mean : nearest)
      at.push_back(mean < 0 ? -1
                            : static_cast<std::int32_t>(
                                  std::lower_bound(near.begin(), near.end(), mean) -
                                  near.begin()));
    return gathered(angles, at, std::numeric_limits<float>::quiet_NaN());
  }

  const pcl::Indices& chosen_;
  const Neighborhoods& neighborhoods_;
  const std::vector<float>& spacings_;
  double spacing_; ///< of the cloud, meters
  std::vector<float> places_;
  unsigned threads_;
};

/** On steps is a quarter of the area at least (of parts without noise it was at most a
 * seventh), and half of that where means bend. Of it two thirds at most are thick: on
 * steps these are their ends, on thin walls it is all. */
bool
areSteps(const StepAreas& areas)
{
  return areas.on_steps > 0 && 4 * areas.on_steps >= areas.all &&
         2 * areas.on_steps >= areas.bent && 3 * areas.thick <= 2 * areas.on_steps;
}

} // namespace

double
stepReach(double spacing)
{
  const double size = voxel * growths.back() * spacing;
  // To a mean, to those around it, and to what their normals are of. Each is of finer
  // means, of which some may have been rounded into its voxel.
  const double means = (1.0 + inad_radius + normal_radius) * means_spacing * size;
  return means + std::sqrt(3.0) * (size + voxel * spacing);
}

AreasOfMeans
stepAreas(const pcl::Indices& chosen,
          const Neighborhoods& neighborhoods,
          const std::vector<float>& spacings,
          double spacing,
          unsigned threads)
{
  const Samples samples(chosen, neighborhoods, spacings, spacing, threads);
  constexpr int cells = 3;
  const PointsNear near(
      neighborhoods.input(), chosen, stepReach(spacing), cells, threads);
  AreasOfMeans areas;
  std::vector<float> means;
  for (std::size_t k = 0; k < growths.size(); ++k) {
    const double size = voxel * growths[k] * spacing;
    means = voxelMeans(k == 0 ? near.view() : viewOfPositions(means), size, threads);
    areas[k] = samples.areas(means, size);
  }
  return areas;
}

bool
areOnWideSteps(const AreasOfMeans& areas)
{
  return std::any_of(areas.begin(), areas.end(), areSteps);
}

} // namespace pcl::detail
