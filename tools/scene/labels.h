// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The truth about each pixel: planar or curved surface, edge, instance, face.

#pragma once

#include "scene/creases.h"
#include "scene/worlds/world.h"

#include <vector>

namespace pcl::scene {

constexpr double crease_band = 0.010; /**< meters; nearer than that surface is Crease */
constexpr double edge_band = 0.005;   /**< meters; nearer than that edge is Crease */
constexpr double crease_cap = 0.050;  /**< meters; crease_mm is never larger */
constexpr double silhouette_band = 3.5; /**< pixels of a picture 640 wide, void */

/** \brief Marks pixels whose neighbor belongs to a surface that it does not meet there:
 * one is in front of the other. The rim of the table is none of them. */
std::vector<char> silhouettes(const World& world, const View& view);

/** \brief Marks all pixels within a radius in pixels of a marked one. */
std::vector<char>
dilated(const std::vector<char>& marks, unsigned width, unsigned height, double radius);

/** \brief Adds surface, edge, instance, face and crease_mm of what is seen to a scene.
 *
 * \param[in] beside_gap marks pixels that are void because a silhouette or missing
 * depth is near, unless a crease is near as well */
void label(const World& world,
           const View& view,
           const Creases& creases,
           const std::vector<char>& beside_gap,
           Scene& scene);

} // namespace pcl::scene
