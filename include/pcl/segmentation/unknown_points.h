/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_field.h>

#include <cstddef>
#include <vector>

namespace pcl {

/** \brief Why points got no answer; each counts for the first reason that holds.
 * \ingroup segmentation */
struct UnknownPoints {
  std::size_t finite = 0;  ///< points
  std::size_t unknown = 0; ///< of them

  /** \brief A float there is no finer than half of the cloud's spacing: positions are
   * rounded, and neighborhoods with them. */
  std::size_t rounded = 0;
  /** \brief Other points are at the same place, and nothing is around it. */
  std::size_t at_one_place = 0;
  /** \brief Fewer than NeighborhoodSweep::min_neighbors are within the radius. */
  std::size_t few_neighbors = 0;
  /** \brief The neighbors are on a line through the point. */
  std::size_t on_a_line = 0;
  /** \brief There are neighbors, but too few of them are known. */
  std::size_t unknown_neighbors = 0;

  /** \brief To the nearest point at another place, the median of all points, meters; 0
   * if there is no other place. */
  float spacing = 0.0f;
  /** \brief Of floats where a point without an answer is, the largest, meters. */
  float float_spacing = 0.0f;
  /** \brief Of the neighborhoods of points without an answer, the median, meters; 0 for
   * nearest points. */
  float radius = 0.0f;
};

/** \brief Find out why points have no value.
 * \param[in] points what the values are of
 * \param[in] values one for each point, NaN unknown
 * \param[in] size of the neighborhoods that the values are of; radii are one for each
 * point. Values of NeighborhoodSweep count points at one place more than once: here
 * each place counts once
 * \param[in] threads 0 for all cores
 * \throws std::invalid_argument as NeighborhoodSweep, or if there is another number of
 * values than of points */
PCL_SHAPE_EXPORTS UnknownPoints unknownPoints(const XYZView& points,
                                              const std::vector<float>& values,
                                              const NeighborhoodSize& size,
                                              unsigned threads = 0);

/** \brief The same for INAD, or what was made of it.
 * \param[in] points what the values are of
 * \param[in] values one for each point, NaN unknown
 * \param[in] parameters for the noise of the cloud; the smaller of the two radii counts
 * \param[in] threads 0 for all cores */
PCL_SHAPE_EXPORTS UnknownPoints unknownPoints(const XYZView& points,
                                              const std::vector<float>& values,
                                              const INADParameters& parameters,
                                              unsigned threads = 0);

/** \brief Find out why points of a field have no value: its likelihoods, if it has any,
 * else its edge likelihood. \param[in] field as it was computed
 * \param[in] threads 0 for all cores */
PCL_SHAPE_EXPORTS UnknownPoints unknownPoints(const ShapeField& field,
                                              unsigned threads = 0);

} // namespace pcl
