// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A number that changes with any label of a scene.

#pragma once

#include "scene/scene.h"

namespace pcl_shape_test {

/** \brief Of surface, edge and instance: the same on every machine. */
inline std::uint64_t
checksum(const pcl::scene::Scene& scene)
{
  std::uint64_t hash = 0xcbf29ce484222325ULL; // FNV-1a
  for (const auto* labels : {&scene.surface, &scene.edge, &scene.instance})
    for (const std::uint32_t value : *labels)
      hash = (hash ^ value) * 0x100000001b3ULL;
  return hash;
}

} // namespace pcl_shape_test
