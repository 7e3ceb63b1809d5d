// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A depth camera's noise grows with the range, as the spacing of points does. This
// divides such a cloud by spacing into zones, and finds the resolution that each needs:
// see doc/method.md, Zones.

#include "segmentation/resolution_zones.h"

#include "common/finite.h"
#include "common/gathered.h"
#include "common/number_text.h"
#include "common/statistics.h"
#include "features/noise/edge_radii.h"
#include "features/noise/noise_level.h"
#include "features/noise/normal_scatter.h"
#include "features/noise/part_noise.h"
#include "features/spacing/local_spacing.h"
#include "features/spacing/points_near.h"
#include "features/spacing/some_points.h"
#include "geometry/cell_loop.h"
#include "geometry/cells_around.h"
#include "geometry/point_grid.h"
#include "geometry/voxel_means.h"
#include "segmentation/field_stages.h"

#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/means_of_parts.h>

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <map>
#include <numeric>
#include <utility>

namespace pcl::detail {
namespace {

using namespace segmentation;

// From one to the next a depth camera's steps grow to twice their height. One
// resolution serves both: means are that much finer than what they would lose.
constexpr double bands_per_octave = 2.0;
constexpr int no_band = std::numeric_limits<int>::min();
// In distances to the 12th neighbor: a cell is small beside what stands before a wall,
// and its median does not follow the rims of objects.
constexpr double cell_distances = 8.0;
// Of the points, in a band: fewer, say a chair's leg, go with the next one.
constexpr double min_share = 0.02;
constexpr std::size_t min_places = 100; // whose noise can be told
// Radians; less is no noise that could be measured.
constexpr float silent = 1e-3f;
constexpr double flattest = 0.1; // of the angles, see noiseLevelOf()
// Ranges whose resolutions differ by less are one zone: each zone is a field.
constexpr double same_zone = 1.5;
// Local spacings over that of the cloud. They grow with the root of distances, which
// are 1.4 times as large in the next band.
constexpr float sparser = 1.2f;
constexpr std::size_t some_places = 300; // a tenth of them is known to 2 %

/** The band of each point: that of the cell that it is in, by spacing. */
std::vector<int>
bandsOf(const XYZView& points, const std::vector<float>& distances, unsigned threads)
{
  std::vector<int> bands(points.size, no_band);
  const auto usual = static_cast<double>(medianSpacing(distances));
  if (!(usual > 0.0)) // squares of such distances are less than a float can hold
    return bands;
  const double size = cell_distances * usual;
  const auto along = [size](float x) {
    constexpr double most = 1 << 30;
    return static_cast<std::int32_t>(std::clamp(std::floor(x / size), -most, most));
  };
  const std::vector<CellPoint> sorted =
      sortedByCell(points, threads, [&](const float* p) -> Cell {
        return {along(p[2]), along(p[1]), along(p[0])};
      });
  const auto setBand = [&](const auto begin, const auto end, std::size_t) {
    std::vector<float> known;
    for (auto at = begin; at != end; ++at)
      if (std::isfinite(distances[at->point]) && distances[at->point] > 0.0f)
        known.push_back(distances[at->point]);
    if (known.empty())
      return;
    const auto octaves = std::log2(static_cast<double>(median(known)) / usual);
    for (auto at = begin; at != end; ++at)
      bands[at->point] = static_cast<int>(std::lround(bands_per_octave * octaves));
  };
  forEachCell(sorted, beginsOfCells(sorted), threads, setBand);
  return bands;
}

/** Consecutive bands that have enough points: half an octave of spacing, or more. */
struct Range {
  int first = 0, last = 0;
  std::size_t points = 0;

  bool
  holds(int band) const
  {
    return band != no_band && first <= band && band <= last;
  }
};

/** The bands, from the densest on. One with too few points is joined with the next
 * sparser one; the last, if it has too few, with the one before it. */
std::vector<Range>
rangesOf(const std::vector<int>& bands)
{
  std::map<int, std::size_t> counts;
  std::size_t all = 0;
  for (const int band : bands)
    if (band != no_band) {
      ++counts[band];
      ++all;
    }
  const auto enough = min_share * static_cast<double>(all);
  std::vector<Range> ranges;
  bool is_open = false;
  for (const auto& [band, count] : counts) {
    if (!is_open)
      ranges.push_back({band, band});
    ranges.back().last = band;
    ranges.back().points += count;
    is_open = static_cast<double>(ranges.back().points) < enough;
  }
  if (is_open && ranges.size() > 1) {
    const Range rest = ranges.back();
    ranges.pop_back();
    ranges.back().last = rest.last;
    ranges.back().points += rest.points;
  }
  return ranges;
}

/** The places of a zone, and some around them. */
struct Places {
  std::vector<float> positions;
  std::vector<bool> is_own;
};

struct Measured {
  CloudNumbers numbers;
  std::size_t places = 0;
  bool is_silent = false; ///< no noise at all
};

/** \param[in] angles between the normals of neighbors, radians */
bool
isSilent(const std::vector<float>& angles)
{
  return !angles.empty() && quantile(angles, flattest) < silent;
}

/** Noise of stereo and structured light is in disparities. Their steps overlap, and
 * look like both sides of a plate; but plates are not thicker where points are sparse.
 */
void
leavePlatesOut(NoiseMeasures& noise)
{
  for (StepAreas& areas : noise.steps)
    areas.thick = 0;
  noise.thicknesses.clear();
}

/** Whether neighbors' normals are the same at a tenth of a sample of the points. */
bool
isSilentAt(const std::vector<std::size_t>& indices,
           const XYZView& points,
           const std::vector<float>& spacings,
           unsigned threads)
{
  using edge_radii::inad_radius, edge_radii::normal_radius;
  const std::vector<float> positions = positionsAt(points, indices);
  pcl::Indices some;
  for (const pcl::index_t k : somePoints(viewOfPositions(positions), some_places))
    some.push_back(static_cast<pcl::index_t>(indices[static_cast<std::size_t>(k)]));
  const double reach = (normal_radius + inad_radius) *
                       mostSpacing(static_cast<double>(medianSpacing(spacings)));
  const PointsNear near(points, some, reach, 1, threads);
  const std::vector<float> near_spacings = gathered(spacings, near.indices());
  const std::vector<float> angles =
      finiteOf(NormalScatter(Neighborhoods(near.view(), threads),
                             near_spacings,
                             near.some(),
                             inad_radius,
                             threads)(normal_radius, inad_radius));
  return isSilent(angles);
}

/** All but the noise of places. \param[in] distances to the 12th neighbor of each */
Measured
spacingAt(const Places& places, const std::vector<float>& distances)
{
  std::vector<float> own;
  for (std::size_t i = 0; i < distances.size(); ++i)
    if (places.is_own[i] && std::isfinite(distances[i]) && distances[i] > 0.0f)
      own.push_back(distances[i]);
  Measured measured;
  measured.places = own.size();
  CloudNumbers& numbers = measured.numbers;
  numbers.spacing = medianSpacing(std::move(own));
  numbers.distance = static_cast<double>(numbers.spacing);
  return measured;
}

Measured
measuredAt(const Places& places, const std::vector<float>& distances, unsigned threads)
{
  Measured measured = spacingAt(places, distances);
  if (measured.places < min_places)
    return measured;
  CloudNumbers& numbers = measured.numbers;
  std::vector<float> spacings;
  spacings.reserve(distances.size());
  for (const float distance : distances)
    spacings.push_back(spacingOf(distance, numbers.distance));
  const auto spacingsNear = [&](const PointsNear& near, const Neighborhoods&) {
    return gathered(spacings, near.indices());
  };
  NoiseMeasures noise = noiseOfPart(viewOfPositions(places.positions),
                                    places.is_own,
                                    {0.0, spacingsNear},
                                    numbers,
                                    measured.places,
                                    threads);
  leavePlatesOut(noise);
  setNoise(noise, numbers);
  measured.is_silent = isSilent(noise.angles.front());
  return measured;
}

/** Finds the resolution that each part of a cloud needs. */
class Zones {
public:
  Zones(const FieldRequest& request, std::vector<float> distances)
  : request_(request)
  , distances_(std::move(distances))
  , bands_(bandsOf(request.surface, distances_, request.threads))
  , ranges_(rangesOf(bands_))
  {}

  /** Whether some of it has half of the usual spacing (at half of the range a depth
   * camera's noise is a quarter), and needs no more than half of a resolution. */
  bool
  showMoreThan(double resolution)
  {
    constexpr int half = static_cast<int>(-bands_per_octave);
    return !ranges_.empty() && ranges_.front().last <= half &&
           2.0 * resolutionOf(ranges_.front(), request_.resolution) <= resolution;
  }

  /** What is denser than the first noisy range keeps the resolution that is set; each
   * range from there on begins with that of the one before, as distances grow.
   * \param[in] most meters */
  std::vector<ResolutionZone>
  find(double most)
  {
    const std::size_t first = firstTooNoisy();
    if (first == ranges_.size())
      return {};
    std::vector<Zone> zones;
    if (first > 0)
      zones.push_back(
          {{ranges_.begin(), ranges_.begin() + static_cast<std::ptrdiff_t>(first)},
           request_.resolution});
    double resolution = request_.resolution;
    double finest = 0.0; // of the ranges of the last zone
    for (std::size_t k = first; k < ranges_.size(); ++k) {
      resolution = std::min(most, resolutionOf(ranges_[k], resolution));
      if (k == first || resolution > same_zone * finest) {
        zones.emplace_back();
        finest = resolution;
      }
      zones.back().ranges.push_back(ranges_[k]);
      zones.back().resolution = resolution;
      resolution =
          std::min(most, twoDigits(std::exp2(1.0 / bands_per_octave) * resolution));
    }
    std::vector<ResolutionZone> found;
    if (zones.size() < 2)
      return found;
    for (const Zone& zone : zones)
      found.push_back(zoneOf(zone));
    return found;
  }

private:
  struct Zone {
    std::vector<Range> ranges;
    double resolution = 0.0; ///< meters
  };

  /** The range at which noise begins to be beyond what radii can grow for: the one that
   * the fewest points contradict, those of denser ranges with such noise and of sparser
   * ones with less. What is silent contradicts nothing: it is a shape, or steps that
   * are wider than what is looked at. If fewer contradict none at all, there is none.
   */
  std::size_t
  firstTooNoisy()
  {
    const std::size_t bands = ranges_.size();
    std::vector<std::size_t> noisy(bands, 0), fine(bands, 0); // points
    for (std::size_t k = 0; k < bands; ++k) {
      const Measured& measured = measure(ranges_[k], request_.resolution);
      if (coarser(measured, ranges_[k], request_.resolution) > 0.0)
        noisy[k] = ranges_[k].points;
      else if (!measured.is_silent)
        fine[k] = ranges_[k].points;
    }
    std::size_t first = bands;
    std::size_t least = std::accumulate(noisy.begin(), noisy.end(), std::size_t{0});
    std::size_t contrary = least;
    for (std::size_t k = bands; k-- > 0;) {
      contrary = contrary + fine[k] - noisy[k];
      if (noisy[k] > 0 && contrary < least) {
        least = contrary;
        first = k;
      }
    }
    return first;
  }

  /** \param[in] least meters */
  double
  resolutionOf(const Range& range, double least)
  {
    double resolution = least;
    double next = coarser(measure(range, resolution), range, resolution);
    while (next > 0.0) {
      resolution = next;
      next = coarser(measure(range, resolution), range, resolution);
    }
    return resolution;
  }

  /** The next resolution, 0 for none. The number of places is that of the cloud if all
   * of it were like this range: it tells whether they are closer than a sensor can tell
   * apart. */
  double
  coarser(const Measured& measured, const Range& range, double resolution) const
  {
    if (measured.places < min_places)
      return 0.0;
    const double share = static_cast<double>(range.points) /
                         static_cast<double>(countFinite(request_.surface));
    return coarserResolution(
        measured.numbers,
        static_cast<std::uint64_t>(static_cast<double>(measured.places) / share),
        resolution);
  }

  /** Each range at each resolution is measured once. */
  const Measured&
  measure(const Range& range, double resolution)
  {
    const auto [found, is_new] = measured_.try_emplace({range.first, resolution});
    if (is_new)
      found->second = measuredNew(range, resolution);
    return found->second;
  }

  Measured
  measuredNew(const Range& range, double resolution) const
  {
    const Range around{range.first - 1, range.last + 1};
    pcl::Indices points;
    for (std::size_t i = 0; i < bands_.size(); ++i)
      if (around.holds(bands_[i]))
        points.push_back(static_cast<pcl::index_t>(i));
    const Places places = placesOf(range, points, resolution);
    return measuredAt(places,
                      resolution == 0.0 ? gathered(distances_, points)
                                        : distancesTo12th(places),
                      request_.threads);
  }

  /** Some points, or their means. */
  Places
  placesOf(const Range& range, const pcl::Indices& points, double resolution) const
  {
    Places places{positionsAt(request_.surface, points), {}};
    for (const pcl::index_t i : points)
      places.is_own.push_back(range.holds(bands_[static_cast<std::size_t>(i)]));
    if (resolution == 0.0)
      return places;
    const XYZView view = viewOfPositions(places.positions);
    return {voxelMeans(view, resolution, request_.threads),
            gathered(places.is_own, firstInVoxels(view, resolution, request_.threads))};
  }

  /** The points of a range and those that its edges depend on. */
  pcl::Indices
  pointsNear(const Range& range, double reach) const
  {
    CellsAround cells(reach, 1, bands_.size());
    for (std::size_t i = 0; i < bands_.size(); ++i)
      if (range.holds(bands_[i]))
        cells.add(positionOf(request_.surface, i));
    pcl::Indices near;
    for (std::size_t i = 0; i < bands_.size(); ++i)
      if (bands_[i] != no_band && cells.mayHold(positionOf(request_.surface, i)))
        near.push_back(static_cast<pcl::index_t>(i));
    return near;
  }

  /** With the noise of its noisiest range: measured over all of them, it would be that
   * of the flattest one. */
  ResolutionZone
  zoneOf(const Zone& zone)
  {
    CloudNumbers noisiest;
    double most_distance = 0.0;
    for (const Range& range : zone.ranges) {
      const CloudNumbers& numbers = measure(range, zone.resolution).numbers;
      most_distance = std::max(most_distance, numbers.distance);
      if (numbers.noise_level >= noisiest.noise_level)
        noisiest = numbers;
    }
    noisiest.distance = most_distance;
    noisiest.spacing = static_cast<float>(most_distance);
    const Range all{zone.ranges.front().first, zone.ranges.back().last, 0};
    const double reach = reachOf(noisiest, request_.edge_model).edges +
                         reachOfMeans(most_distance, zone.resolution);
    Places places = placesOf(all, pointsNear(all, reach), zone.resolution);
    CloudNumbers numbers = spacingAt(places, distancesTo12th(places)).numbers;
    numbers.noise = noisiest.noise;
    numbers.noise_level = noisiest.noise_level;
    numbers.noise_correlation = noisiest.noise_correlation;
    return {zone.resolution,
            numbers,
            std::move(places.positions),
            std::move(places.is_own)};
  }

  std::vector<float>
  distancesTo12th(const Places& places) const
  {
    return distancesToTwelfth(neighborhoodsOf(request_, places.positions));
  }

  const FieldRequest& request_;
  std::vector<float> distances_; ///< of each point to its 12th neighbor
  std::vector<int> bands_;       ///< of each point
  std::vector<Range> ranges_;
  std::map<std::pair<int, double>, Measured> measured_; ///< by first band, resolution
};

} // namespace

bool
mayHaveZones(const XYZView& points,
             const std::vector<float>& spacings,
             unsigned threads)
{
  const float usual = medianSpacing(spacings);
  std::vector<std::size_t> dense, sparse;
  for (std::size_t i = 0; i < points.size; ++i)
    if (spacings[i] > sparser * usual)
      sparse.push_back(i);
    else if (spacings[i] * sparser < usual)
      dense.push_back(i);
  const double enough = min_share * static_cast<double>(countFinite(points));
  return static_cast<double>(std::min(dense.size(), sparse.size())) >= enough &&
         isSilentAt(sparse, points, spacings, threads) &&
         !isSilentAt(dense, points, spacings, threads);
}

std::vector<ResolutionZone>
resolutionZones(const FieldRequest& request,
                const std::vector<float>& distances,
                double coarse)
{
  Zones zones(request,
              distances.empty() ? distancesToTwelfth(neighborhoodsOf(request))
                                : distances);
  if (coarse == 0.0)
    return zones.find(std::numeric_limits<double>::infinity());
  return zones.showMoreThan(coarse) ? zones.find(coarse)
                                    : std::vector<ResolutionZone>();
}

} // namespace pcl::detail
