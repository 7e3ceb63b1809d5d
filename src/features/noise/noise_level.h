// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far radii must grow for normals to be stable in the noise of a cloud.

#pragma once

#include "features/spacing/local_spacing.h"

#include <cstdint>
#include <vector>

namespace pcl::detail {

/** \brief The noise that the radii of edges are chosen for. */
struct NoiseLevel {
  double level = 0.0;       ///< spacings, 0 to max_noise
  double correlation = 0.0; ///< how sure it is that neighbors share noise, 0 to 1

  /** \brief Neighbors share noise that is beyond what radii can grow for: normals show
   * the sensor's steps, or agree at no radius. */
  bool
  isBeyondRadii() const
  {
    return level == max_noise && correlation == 1.0;
  }
};

/** \brief The level of noise for edges, and its color.
 *
 * What the thickness of neighborhoods says, if neighbors share their noise as those of
 * depth cameras do. White noise averages out within few points, and where creases are
 * crowded the thickness is that of the shape; then it is the least noise for whose
 * radii normals agree on the flattest tenth of the cloud, or the one for whose radii
 * they differ least. Steps that are wider than neighborhoods are noise beyond all
 * radii; the other side of thin plates is none. See doc/method.md. \param[in]
 * neighborhoods of all points of a cloud among themselves \param[in] spacings one for
 * each point \param[in] noise see noiseOf() \param[in] threads 0 for all cores */
PCL_SHAPE_EXPORTS NoiseLevel noiseLevelOf(const Neighborhoods& neighborhoods,
                                          const std::vector<float>& spacings,
                                          double noise,
                                          unsigned threads);

/** \brief The share of a cloud's points whose INAD is unknown with the radii of a noise
 * level, as far as some of them tell. \param[in] points about how many of them */
double shareUnknown(const Neighborhoods& neighborhoods,
                    const std::vector<float>& spacings,
                    std::size_t points,
                    double noise_level,
                    unsigned threads);

/** \brief The points that noiseLevelOf() looks at, of a cloud of so many points. */
pcl::Indices levelPoints(const XYZView& points, std::uint64_t of_points);

/** \brief What it measures of a part of a cloud: all but variations.
 * \param[in] chosen those of levelPoints() that are to be measured, ascending
 * \param[in] neighborhoods of all points of the part among themselves
 * \param[in] spacings one for each point
 * \param[in] numbers of the cloud, with distance, spacing and box
 * \param[in] places how many points the cloud has */
NoiseMeasures levelMeasures(const pcl::Indices& chosen,
                            const Neighborhoods& neighborhoods,
                            const std::vector<float>& spacings,
                            const CloudNumbers& numbers,
                            std::uint64_t places,
                            unsigned threads);

/** \brief How far levelMeasures() look from a point, meters. \param[in] numbers with
 * distance and spacing */
double noiseLevelReach(const CloudNumbers& numbers);

/** \brief noiseLevelOf() of a cloud, from measures of all of its parts. */
NoiseLevel noiseLevelOf(double noise, const NoiseMeasures& measures);

/** \brief Parameters for the noise of this cloud. */
PCL_SHAPE_EXPORTS INADParameters withNoiseOfCloud(const INADParameters& parameters,
                                                  const XYZView& cloud,
                                                  unsigned threads);

} // namespace pcl::detail
