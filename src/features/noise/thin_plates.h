// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How far the other side of a thin plate is from a point.

#pragma once

#include <pcl/types.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <cstddef>
#include <vector>

namespace pcl::detail {

/** \brief For each of some points of a cloud, how far straight above or below it the
 * points of another surface are, in its local spacing; 0 if there is none, if there
 * are less than half as many of them as around the point, or if many are halfway, as in
 * noise. \param[in] neighborhoods of
 * all points of the cloud among themselves \param[in] spacings one for each point
 * \param[in] chosen ascending \param[in] reach how far the other surface may be, meters
 */
std::vector<float> thicknessesAt(const pcl::Indices& chosen,
                                 const Neighborhoods& neighborhoods,
                                 const std::vector<float>& spacings,
                                 float reach,
                                 unsigned threads);

/** \brief About how many points of a cloud tell whether it is of thin plates, and how
 * far their other side may be. */
constexpr std::size_t plate_points = 100; // two thirds of them are known to 5 %
constexpr float plate_spacings = 3.0f;    // farther away it is in few neighborhoods

/** \brief The thickness of a cloud of thin plates, in local spacings (about two mean
 * distances of points each): the middle one, if two thirds of some points have another
 * side; else 0. \param[in] thicknesses at these points */
double plateThickness(std::vector<float> thicknesses);

/** \brief That of a cloud. \param[in] neighborhoods of all points among themselves
 * \param[in] spacings one for each point */
PCL_SHAPE_EXPORTS double plateThickness(const Neighborhoods& neighborhoods,
                                        const std::vector<float>& spacings,
                                        unsigned threads);

} // namespace pcl::detail
