// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points and normals of a scene as vectors.

#pragma once

#include "scene/vec.h"

#include <cstddef>
#include <vector>

namespace pcl_shape_test {

/** \brief The i-th three of coordinates that follow each other. */
inline pcl::scene::Vec3
vectorAt(const std::vector<float>& values, std::size_t i)
{
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

} // namespace pcl_shape_test
