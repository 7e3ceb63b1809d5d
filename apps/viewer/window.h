// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Draws a scene into a window or a picture.

#pragma once

#include "viewer/scene.h"

#include <string>

namespace pcl::app {

/** \brief \throws InputError unless an X server can be reached, or if this application
 * was built without PCL's visualization */
void requireDisplay();

/** \brief Draw the scene without showing it. \return a PNG file */
std::string drawPicture(const Scene& scene);

/** \brief Show the scene until the user closes the window. */
void showWindow(const Scene& scene);

} // namespace pcl::app
