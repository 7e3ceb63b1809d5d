// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// By how much the nodes of smooth faces are off them, place by place.

#pragma once

#include "surfaces/face_fit.h"

#include <cstdint>
#include <optional>
#include <vector>

namespace pcl::segmentation {

/** \brief Of each node's window; nothing where it does not determine a quadric. */
using FaceFits = std::vector<std::optional<FaceFit>>;

// In nodes' cells and in spacings: these are wider than most objects' faces, and 27 of
// them hold several; a depth camera's noise differs little across them. They are also
// larger than a window's radius, which flat windows rely on.
constexpr float noise_cells_per_node = 4.0f;
constexpr float noise_cell_spacings = 24.0f;

/** \brief The size of the cells that noise is measured in. \param[in] cell of a level
 */
double noiseCell(double cell, double spacing);

/** \brief The noise of a whole cloud at a level: what a tenth of its residuals are
 * below, or of few residuals the third or a quarter. */
float noiseOfCloud(const FaceFits& fits);

/** \brief How many residuals are below it. \param[in] residuals how many there are, at
 * least one */
std::uint64_t rankOfNoise(std::uint64_t residuals);

/** \brief The nodes whose residuals the noise at some nodes is made of. Among them are
 * the middles of all windows that these are in. \param[in] chosen of each node
 * \param[in] spacing of the cloud, median */
std::vector<bool>
nodesAround(const FaceLevel& level, const std::vector<bool>& chosen, float spacing);

/** \brief The noise at each node of a level: the first quartile of the residuals around
 * it, since windows that cross creases, or hold more than a quadric can follow, have
 * larger ones than the noise. A ripple of the sensor counts as noise at the levels
 * whose windows are as wide as its waves. \param[in] fits of each node's window
 * \param[in] spacing of the cloud, median \param[in] of_cloud see noiseOfCloud() */
std::vector<float>
faceNoise(const FaceLevel& level, const FaceFits& fits, float spacing, float of_cloud);

} // namespace pcl::segmentation
