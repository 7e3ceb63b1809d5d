// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Garages, tunnels, bridges, fields and other places beside the streets of a town.

#pragma once

#include "scene/street_builder.h"

namespace pcl::scene {

/** \brief Changes the shape of a street to that of another place. */
void shapePlace(StreetPlace place, Random& random, StreetProfile& profile);

/** \brief Adds what a place has besides the traffic of a town. */
void fillPlace(StreetPlace place,
               Random& random,
               StreetBuilder& builder,
               const StreetProfile& profile);

} // namespace pcl::scene
