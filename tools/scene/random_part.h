// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Machined parts of random shape.

#pragma once

#include "scene/part.h"
#include "scene/random.h"

#include <cstdint>

namespace pcl::scene {

/** \brief The random numbers of the shape of a part that is alone. */
constexpr std::uint64_t part_stream = 20;

/** \brief A plate, block, disc or profile with what a mill and a drill make of it:
 * pockets, holes, ribs, bosses, steps, letters, chamfers, fillets and thin walls, from
 * above and sometimes from below. The middle of its plan is at x = y = 0.
 * \param[in] size meters, about its longest side */
Part randomPart(double size, Random& random);

} // namespace pcl::scene
