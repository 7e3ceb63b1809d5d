// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of an uneven cloud: from its points, and from means that even it out.

#pragma once

#include <pcl/segmentation/shape_field.h>

#include <cstdint>
#include <vector>

namespace pcl::detail {

/** \brief Which points of a field keep values of their own beside those of means: where
 * none stands for them, the one that does is unknown, or coarser than they are.
 * \param[in] stands_for the mean of each point, or -1 \param[in] spacings of the
 * points, as they are, meters */
std::vector<char> ownPoints(const ShapeField& means,
                            const std::vector<std::int32_t>& stands_for,
                            const std::vector<float>& spacings);

/** \brief Take the values of means that stand for a field's points, and their creases,
 * except where points keep their own: there the means serve the sparser points beside,
 * and only the classes of surfaces are taken. \param[in] stands_for the mean of each
 * point, or -1 \param[in] keeps_own see ownPoints(): if the field knows an edge there
 * \param[in,out] field with edges, without classes */
void takeFromMeans(const ShapeField& means,
                   const std::vector<std::int32_t>& stands_for,
                   const std::vector<char>& keeps_own,
                   ShapeField& field);

} // namespace pcl::detail
