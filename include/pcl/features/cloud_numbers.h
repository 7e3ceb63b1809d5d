/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/xyz_view.h>
#include <pcl/pcl_shape_exports.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl {

/** \brief What the default method needs to know of a whole cloud, to give the points of
 * a part of it the same values, bit by bit. Points at the same place count once.
 * \ingroup features */
struct CloudNumbers {
  double distance = 1.0;    ///< to the 12th neighbor, the median of the positive ones
  float spacing = 1.0f;     ///< the median of the local spacings, see AdaptiveRadius
  double noise = 0.0;       ///< in spacings, see ShapeField
  double noise_level = 0.0; ///< see ShapeField
  double noise_correlation = 0.0; ///< how sure it is that neighbors share noise, 0 to 1
};

/** \brief Areas around some points, as means of one size show them: thousandths of a
 * square of the cloud's spacing. */
struct StepAreas {
  std::int64_t all = 0;      ///< around all of the points
  std::int64_t bent = 0;     ///< where normals of means differ
  std::int64_t on_steps = 0; ///< where those of points do not
  std::int64_t thick = 0;    ///< of these where another surface is behind
};

/** \brief What parts of a cloud add to its noise; the order of parts does not matter.
 */
struct NoiseMeasures {
  std::vector<float> variations;            ///< of the surface around some points
  std::array<std::vector<float>, 8> angles; ///< between normals, for several radii
  std::array<StepAreas, 2> steps;           ///< by means of two sizes
  std::vector<float> thicknesses; ///< of plates at some points, spacings; 0 none

  /** \brief Add those of another part. \param[in] other is kept */
  PCL_SHAPE_EXPORTS void add(const NoiseMeasures& other);
};

/** \brief Sets noise, noise level and correlation. */
PCL_SHAPE_EXPORTS void setNoise(const NoiseMeasures& of_all_parts,
                                CloudNumbers& numbers);

/** \brief The local spacing at the median of a cloud. \param[in] distance the
 * CloudNumbers::distance \param[in] middle the middle one of all distances */
PCL_SHAPE_EXPORTS float spacingAt(float middle, double distance);

/** \brief Places of a cloud, of which some are measured; the others are around them.
 * No two may be equal. */
class PCL_SHAPE_EXPORTS PartOfCloud {
public:
  /** \param[in] places they are not copied
   * \param[in] is_measured one for each place
   * \param[in] threads 0 for all \throws std::invalid_argument if sizes differ */
  PartOfCloud(const XYZView& places,
              const std::vector<bool>& is_measured,
              unsigned threads);

  /** \brief The distance to the 12th neighbor of each place that is measured; infinite
   * beyond the reach, since neighbors may be missing there. */
  std::vector<float> measureDistances(double reach) const;

  /** \param[in] numbers with distance and spacing
   * \param[in] places how many finite ones the cloud has */
  NoiseMeasures measureNoise(const CloudNumbers& numbers, std::uint64_t places) const;

  /** \brief Normals of all places, of either sign, and their curvature; four numbers
   * each, NaN unknown. \param[in] numbers of the whole cloud
   * \param[in] radius in local spacings */
  std::vector<float> normals(const CloudNumbers& numbers, double radius) const;

private:
  XYZView places_;
  std::vector<bool> is_measured_;
  unsigned threads_;
};

} // namespace pcl
