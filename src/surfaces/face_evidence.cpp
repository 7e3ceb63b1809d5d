// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Whether a face bends by more than its noise explains, at any scale.

#include "surfaces/face_evidence.h"

#include "common/finite.h"
#include "common/parallel.h"
#include "common/statistics.h"
#include "features/spacing/local_spacing.h"
#include "surfaces/face_fit.h"
#include "surfaces/face_noise.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

namespace pcl::segmentation {
namespace {

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

// A window holds some 35 nodes, six times the coefficients of a quadric.
constexpr float window_cells = 3.3f;
// Parts of a cloud know the windows whose middles are within a cell of noise.
static_assert(window_cells < noise_cells_per_node);
constexpr float same_window = 0.5f; // cosine of 60 degrees: beyond, a quadric is steep
// Rounding and the sampling of exact data, in spacings: less is never noise.
constexpr float min_noise = 0.03f;

// A window's quadric holds for its middle if the residual is noise, or a small share of
// the bulge: of a fold between two planes it is a sixth, of a cylinder that turns by 90
// degrees a hundredth.
constexpr float max_residual = 2.5f;
constexpr float unexplained_share = 0.07f;
constexpr float min_inliers = 0.7f;
constexpr float max_offset = 4.0f; // in noise: what one node in 10,000 is off
constexpr float offset_share = 0.2f;
constexpr float min_cosine = 0.82f; // of 35 degrees, between node and quadric

// Curved: the normal turns by 16 degrees, a ball's window of 1/7 of its radius; and the
// bulge is five times what is not explained, since waves that a sensor makes bend
// windows as wide as half a wave, and by three times their own deviation; and it is
// four times its standard error, since there are many windows.
constexpr float min_turn = 0.28f; // radians
constexpr float min_bulge = 5.0f;
constexpr float min_errors = 4.0f;
constexpr float steepness = 3.0f; // of the evidence, for the logarithm of these ratios
constexpr float max_evidence = 4.0f;
// Few nodes may be on a quadric by chance: the noise around counts as degrees of
// freedom of their residual, half as many as a quadric has coefficients, for it may
// differ here; Student's distribution tells how large the error is.
constexpr double noise_freedom = 3.0;
// A bulge that is not certain says little against one: about as much as that curved
// surfaces are a third as frequent (ln 3 = 1.1). The model may decide.
constexpr float min_uncertain_evidence = -1.0f;
// Noise that averages out is in the standard error. What does not is at the next
// levels.
constexpr std::size_t noise_levels = 2;
constexpr float excess_residual = 1.5f; // squared, of the noise at the node's own level

// From one level to the next white noise falls by half, and what waves add to it grows,
// on images of depth cameras by up to 1.6.
constexpr float max_growth = 2.0f;

// What bends a large window must bend the small ones in it, where they can see it.
constexpr float visible_bulge = 4.0f; // in noise
constexpr float min_share = 0.3f;

// Waves that neighbors share bend small windows. A large one that holds many of them is
// flat: its bulge is no more than twice what its nodes are off it, and it turns by less
// than half of what is curved.
constexpr std::size_t flat_level = 2; // 13 spacings in radius, wider than waves
constexpr float flat_bulge = 2.0f;
constexpr float flat_turn = 0.5f * min_turn;

// Of averaging over a node and those linked to it: it reaches as far as a first window.
constexpr int averaging_rounds = 5;

// How far the nearest face may be: bands of edges are up to 2.2 to either side.
constexpr float nearest_face_spacings = 5.0f;

/** For each node the one whose window stands for it: of those with its parent the
 * nearest to its middle, for windows of the others hold nearly the same nodes. Where
 * windows may be flat each has its own: each tells which nodes are on it. */
std::vector<std::uint32_t>
middlesOf(const FacePyramid& pyramid, std::size_t of_level)
{
  const FaceLevel& level = pyramid.levels[of_level];
  std::vector<std::uint32_t> middles(level.nodes.size());
  std::iota(middles.begin(), middles.end(), 0);
  if (of_level >= flat_level || of_level + 1 == pyramid.levels.size())
    return middles;
  const FaceLevel& next = pyramid.levels[of_level + 1];
  std::vector<std::uint32_t> of_parents(next.nodes.size(), FacePyramid::none);
  const auto offset = [&](std::uint32_t i) {
    return (level.nodes[i].position - next.nodes[level.parents[i]].position)
        .squaredNorm();
  };
  for (std::uint32_t i = 0; i < middles.size(); ++i) {
    std::uint32_t& middle = of_parents[level.parents[i]];
    if (middle == FacePyramid::none || offset(i) < offset(middle))
      middle = i;
  }
  for (std::uint32_t& middle : middles)
    middle = of_parents[level.parents[middle]];
  return middles;
}

struct LevelFits {
  FaceFits fits;
  std::vector<std::uint32_t> middles; ///< see middlesOf()
  std::vector<const FaceFit*> flat;   ///< of each node in large cells, or none
  std::vector<float> noise,
      evidence; ///< of each node; NaN where its window is not used

  /** The flat window that a node is in, or none. */
  const FaceFit*
  flatAt(std::uint32_t node) const
  {
    return flat.empty() ? nullptr : flat[node];
  }
};

bool
holds(const FaceFit& fit, float noise)
{
  return (fit.residual <= max_residual * noise ||
          fit.residual < unexplained_share * fit.bulge) &&
         fit.inliers > min_inliers &&
         fit.center_offset <= std::max(max_offset * noise, offset_share * fit.bulge) &&
         fit.center_cosine > min_cosine;
}

/** The bulge that chance does not make. \param[in] noise at the node's level */
float
certainBulge(const FaceFit& fit, float noise)
{
  const double residual = fit.residual, freedom = fit.freedom + noise_freedom;
  const double pooled = std::sqrt(
      (fit.freedom * residual * residual + noise_freedom * noise * noise) / freedom);
  return static_cast<float>(fit.bulge_error * pooled / residual *
                            studentDeviations(min_errors, freedom));
}

/** \param[in] noise at the node's level \param[in] waves the noise at larger ones */
float
evidenceOf(const FaceFit& fit, float noise, float waves)
{
  const float excess = fit.residual * fit.residual - excess_residual * noise * noise;
  const float unexplained = std::max(waves, std::sqrt(std::max(0.0f, excess)));
  // Ratios are 0 for an exact plane: their logarithms are cut off like any other.
  const float bend =
      steepness *
      std::log(std::min(fit.turn() / min_turn, fit.bulge / (min_bulge * unexplained)));
  const float certain =
      std::max(steepness * std::log(fit.bulge / certainBulge(fit, noise)),
               min_uncertain_evidence);
  return std::clamp(std::min(bend, certain), -max_evidence, max_evidence);
}

bool
isFlat(const FaceFit& fit)
{
  return fit.inliers > min_inliers && fit.bulge <= flat_bulge * fit.residual &&
         fit.turn() <= flat_turn;
}

const std::vector<std::uint32_t>&
windowAt(const FaceLevel& level, std::size_t node, FaceWindow& window)
{
  return window.around(
      static_cast<std::uint32_t>(node),
      static_cast<float>(windowRadius(level.cell, level.nodes[node].spacing)),
      same_window);
}

/** The nodes on each flat window of a level; none for others. */
std::vector<std::vector<std::uint32_t>>
nodesOfFlatWindows(const FaceLevel& level, const FaceFits& fits, unsigned threads)
{
  std::vector<std::vector<std::uint32_t>> nodes(fits.size());
  kernels::parallelForRanges(
      fits.size(), threads, [&](std::size_t begin, std::size_t end) {
        FaceWindow window(level);
        FaceFitter fitter(level);
        for (std::size_t i = begin; i < end; ++i)
          if (fits[i] && isFlat(*fits[i])) {
            const std::vector<std::uint32_t>& around = windowAt(level, i, window);
            fitter.fit(around);
            nodes[i] = fitter.nodesOn(around);
          }
      });
  return nodes;
}

/** Finds the flat window that each node is in: of several the roughest. */
void
findFlatWindows(const FaceLevel& level, LevelFits& of_level, unsigned threads)
{
  const auto nodes = nodesOfFlatWindows(level, of_level.fits, threads);
  of_level.flat.assign(nodes.size(), nullptr);
  for (std::size_t window = 0; window < nodes.size(); ++window)
    for (const std::uint32_t i : nodes[window]) {
      const FaceFit& fit = *of_level.fits[window];
      const FaceFit*& flat = of_level.flat[i];
      const bool is_noise = fit.residual <= max_residual * of_level.noise[i];
      if (is_noise && (!flat || fit.residual > flat->residual))
        flat = &fit;
    }
}

/** By how much nodes are off the flat windows that a node is in, at the levels above
 * its own; 0 without any. */
float
flatResidual(const FacePyramid& pyramid,
             const std::vector<LevelFits>& levels,
             std::size_t level,
             std::uint32_t node)
{
  float most = 0.0f;
  while (level + 1 < levels.size()) {
    node = pyramid.levels[level++].parents[node];
    if (const FaceFit* const flat = levels[level].flatAt(node); flat)
      most = std::max(most, flat->residual);
  }
  return most;
}

/** \param[in] node of the first level */
bool
isInFlatWindow(const FacePyramid& pyramid,
               const std::vector<LevelFits>& levels,
               std::uint32_t node)
{
  return flatResidual(pyramid, levels, 0, node) > 0.0f; // a residual is never 0
}

/** The largest noise at the levels above a node. */
float
wavesAt(const FacePyramid& pyramid,
        const std::vector<LevelFits>& levels,
        std::size_t level,
        std::uint32_t node)
{
  if (level + 1 == levels.size())
    return levels[level].noise[node];
  float most = 0.0f;
  for (std::size_t up = 0; up < noise_levels && level + 1 < levels.size(); ++up) {
    node = pyramid.levels[level++].parents[node];
    most = std::max(most, levels[level].noise[node]);
  }
  return most;
}

void
findEvidence(const FacePyramid& pyramid, std::vector<LevelFits>& levels, float spacing)
{
  for (std::size_t l = 0; l < levels.size(); ++l) {
    LevelFits& level = levels[l];
    level.evidence.assign(level.fits.size(), nan);
    for (std::uint32_t i = 0; i < level.fits.size(); ++i)
      if (const auto& fit = level.fits[i]; fit) {
        const float least = min_noise * spacing;
        const float noise = level.noise[i];
        const float waves = std::max(least, wavesAt(pyramid, levels, l, i));
        if (holds(*fit, std::max(noise, waves)))
          level.evidence[i] = evidenceOf(
              *fit, noise, std::max(waves, flatResidual(pyramid, levels, l, i)));
      }
  }
}

/** Whether a small window sees nothing of what a large one around it finds. */
bool
contradicts(const FaceFit& small, float noise, const FaceFit& large)
{
  const float scale = small.half_width / large.half_width;
  const float expected = large.bulge * scale * scale;
  const float visible =
      visible_bulge * std::max({noise, small.residual, small.bulge_error});
  return expected > visible && small.bulge < min_share * expected;
}

/** The most of the evidence at a node and those above it, of windows that agree. */
float
mostAt(const FacePyramid& pyramid,
       const std::vector<LevelFits>& levels,
       std::uint32_t node,
       float spacing)
{
  float most = nan;
  std::vector<std::pair<const FaceFit*, float>> smaller; // and the noise of each
  for (std::size_t l = 0; l < levels.size(); ++l) {
    const LevelFits& level = levels[l];
    const float least = std::max(level.noise[node], min_noise * spacing);
    if (const FaceFit* const flat = level.flatAt(node); flat)
      smaller.emplace_back(flat, least);
    const std::uint32_t middle = level.middles[node];
    if (const float evidence = level.evidence[middle]; !std::isnan(evidence)) {
      const FaceFit& fit = *level.fits[middle];
      const bool agrees =
          std::none_of(smaller.begin(), smaller.end(), [&fit](const auto& other) {
            return contradicts(*other.first, other.second, fit);
          });
      if (agrees)
        most = std::isnan(most) ? evidence : std::max(most, evidence);
      smaller.emplace_back(&fit, least);
    }
    if (l + 1 < levels.size())
      node = pyramid.levels[l].parents[node];
  }
  return most;
}

/** The mean of the known values: NaN without any. */
class Mean {
public:
  void
  add(float value)
  {
    const bool is_known = !std::isnan(value);
    sum_ += is_known ? value : 0.0f;
    count_ += is_known ? 1.0f : 0.0f;
  }

  float
  value() const
  {
    return count_ > 0.0f ? sum_ / count_ : nan;
  }

private:
  float sum_ = 0.0f, count_ = 0.0f;
};

/** The means of each node and those that follow it. */
FaceEvidence
averaged(const FaceLevel& level, const FaceEvidence& values, unsigned threads)
{
  FaceEvidence means{std::vector<float>(values.curved.size()),
                     std::vector<float>(values.flat.size())};
  kernels::parallelForEach(values.curved.size(), threads, [&](std::size_t i) {
    Mean curved, flat;
    const auto add = [&](std::size_t node) {
      curved.add(values.curved[node]);
      flat.add(values.flat[node]);
    };
    add(i);
    for (std::uint32_t k = level.link_begins[i]; k < level.link_begins[i + 1]; ++k)
      add(level.links[k]);
    means.curved[i] = curved.value();
    means.flat[i] = flat.value();
  });
  return means;
}

/** The noise of the cloud at each level, 0 without a window, but no more than it can
 * grow from the levels below. Where it seems to grow faster, windows are so large that
 * each holds several faces: residuals are then of their shape. */
std::vector<float>
boundedNoise(std::vector<float> noise, float spacing)
{
  float bound = std::numeric_limits<float>::infinity();
  for (float& of_level : noise) {
    of_level = std::min(of_level, bound);
    if (of_level > 0.0f)
      bound = std::max(of_level, min_noise * spacing);
    bound *= max_growth;
  }
  return noise;
}

// A face that a point is off from is farther than one that it is beside.
constexpr float off_plane = 8.0f; // of squares

/** The nodes with evidence, to find the nearest. */
class NearestFace {
public:
  NearestFace(const FaceLevel& level, const FaceEvidence& evidence, float reach)
  : nodes_(knownOf(level, evidence))
  , grid_(positionsOf(nodes_), reach)
  , reach_(reach)
  {}

  /** \return the number of the nearest node, or none */
  std::uint32_t
  nodeAt(const Eigen::Vector3f& point) const
  {
    float nearest = std::numeric_limits<float>::infinity();
    std::uint32_t node = FacePyramid::none;
    grid_.forEachWithin(point, reach_, [&](std::uint32_t k, float squared) {
      const float off = nodes_[k].normal.dot(point - nodes_[k].position);
      if (const float distance = squared + off_plane * off * off; distance < nearest) {
        nearest = distance;
        node = nodes_[k].number;
      }
    });
    return node;
  }

private:
  struct Node {
    Eigen::Vector3f position, normal;
    std::uint32_t number;
  };

  static std::vector<Node>
  knownOf(const FaceLevel& level, const FaceEvidence& evidence)
  {
    std::vector<Node> nodes;
    for (std::uint32_t i = 0; i < evidence.curved.size(); ++i)
      if (!std::isnan(evidence.curved[i]))
        nodes.push_back({level.nodes[i].position, level.nodes[i].normal, i});
    return nodes;
  }

  std::vector<Node> nodes_;
  PointGrid grid_;
  float reach_;
};

} // namespace

double
windowRadius(double cell, double spacing)
{
  return window_cells * std::max(cell, spacing);
}

FaceFits
fitsOf(const FacePyramid& pyramid,
       std::size_t of_level,
       const std::vector<bool>& wanted,
       unsigned threads)
{
  const FaceLevel& level = pyramid.levels[of_level];
  const std::vector<std::uint32_t> middles = middlesOf(pyramid, of_level);
  FaceFits fits(level.nodes.size());
  kernels::parallelForRanges(
      fits.size(), threads, [&](std::size_t begin, std::size_t end) {
        FaceWindow window(level);
        FaceFitter fitter(level);
        for (std::size_t i = begin; i < end; ++i)
          if (wanted[i] && middles[i] == i)
            fits[i] = fitter.fit(windowAt(level, i, window));
      });
  return fits;
}

FaceEvidence
faceEvidence(const FacePyramid& pyramid, float spacing, unsigned threads)
{
  std::vector<FaceFits> fits;
  std::vector<float> noise;
  for (std::size_t l = 0; l < pyramid.levels.size(); ++l) {
    const std::size_t nodes = pyramid.levels[l].nodes.size();
    fits.push_back(fitsOf(pyramid, l, std::vector<bool>(nodes, true), threads));
    noise.push_back(noiseOfCloud(fits.back()));
  }
  return faceEvidence(pyramid, std::move(fits), noise, spacing, threads);
}

FaceEvidence
faceEvidence(const FacePyramid& pyramid,
             std::vector<FaceFits> fits,
             const std::vector<float>& noise_of_cloud,
             float spacing,
             unsigned threads)
{
  std::vector<LevelFits> levels;
  levels.reserve(fits.size());
  const std::vector<float> noise = boundedNoise(noise_of_cloud, spacing);
  for (std::size_t l = 0; l < fits.size(); ++l) {
    levels.push_back({std::move(fits[l]), middlesOf(pyramid, l), {}, {}, {}});
    levels.back().noise =
        faceNoise(pyramid.levels[l], levels.back().fits, spacing, noise[l]);
    if (l >= flat_level)
      findFlatWindows(pyramid.levels[l], levels.back(), threads);
  }
  findEvidence(pyramid, levels, spacing);
  const FaceLevel& first = pyramid.levels.front();
  const std::vector<float> unknown(first.nodes.size(), nan);
  FaceEvidence evidence{unknown, unknown};
  kernels::parallelForEach(unknown.size(), threads, [&](std::size_t i) {
    const auto node = static_cast<std::uint32_t>(i);
    if (levels.front().middles[i] != node)
      return;
    evidence.curved[i] = mostAt(pyramid, levels, node, spacing);
    evidence.flat[i] = isInFlatWindow(pyramid, levels, node) ? 1.0f : 0.0f;
  });
  for (int round = 0; round < averaging_rounds; ++round)
    evidence = averaged(first, evidence, threads);
  return evidence;
}

double
evidenceReach(const CloudNumbers& numbers)
{
  // Sums of floats are rounded; a neighbor at the very border must not be missed.
  constexpr double rounding = 1.001;
  const double most = rounding * detail::mostSpacing(numbers.distance);
  const double cell = rounding * firstCell(numbers.noise, numbers.spacing);
  const double nearest = nearest_face_spacings * numbers.spacing;
  const double layer = layerReach(numbers.noise, numbers.spacing);
  return rounding * std::max(cell + layer, nearest) +
         averaging_rounds * firstLink(cell, most);
}

FaceEvidence
evidenceOfFaces(const XYZView& points,
                const FacePyramid& faces,
                const FaceEvidence& of_nodes,
                float spacing,
                unsigned threads)
{
  const NearestFace nearest(
      faces.levels.front(), of_nodes, nearest_face_spacings * spacing);
  const std::vector<float> unknown(points.size,
                                   std::numeric_limits<float>::quiet_NaN());
  FaceEvidence evidence{unknown, unknown};
  kernels::parallelForEach(points.size, threads, [&](std::size_t i) {
    std::uint32_t node = faces.node_of_point[i];
    if (node == FacePyramid::none && kernels::isFinite(points[i]))
      node = nearest.nodeAt(positionOf(points, i));
    if (node == FacePyramid::none)
      return;
    evidence.curved[i] = of_nodes.curved[node];
    evidence.flat[i] = of_nodes.flat[node];
  });
  return evidence;
}

} // namespace pcl::segmentation
