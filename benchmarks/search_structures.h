// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A search structure, with one loop over its neighbors for all.

#pragma once

#include "common/clouds.h"
#include "common/pcl_inad.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

struct SearchResult {
  std::vector<float> mu;       ///< NaN for points that are not finite
  std::uint64_t neighbors = 0; ///< the points themselves not counted
};

/** \brief A structure that was built over a cloud, for one radius. */
class RadiusSearch {
public:
  virtual ~RadiusSearch() = default;

  /** \brief Radius search and INAD for each finite point. */
  virtual SearchResult run(const Normals& normals, int threads) const = 0;
};

struct SearchStructure {
  std::string name;
  std::function<std::unique_ptr<RadiusSearch>(const Cloud::ConstPtr&, double radius)>
      build;
};

/** \brief The structures that can search this cloud. */
std::vector<SearchStructure> searchStructures(const Cloud& cloud);
