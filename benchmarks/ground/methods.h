// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Methods that find the ground, with the settings to choose from.

#pragma once

#include "../common/clouds.h"

#include <pcl/types.h>

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

namespace ground {

/** \brief A laser scan of a street with its truth. */
struct Street {
  unsigned beams;
  std::uint64_t seed;
  Cloud::Ptr points;
  std::vector<std::uint32_t> truth; ///< 1 ground, 0 not, 255 left out
};

Street generateStreet(unsigned beams, std::uint64_t seed);

/** \brief One way to run a method: finds the indices of the ground. */
struct Setting {
  std::string text;
  std::function<pcl::Indices(const Cloud::ConstPtr&)> find;
};

struct Method {
  std::string name;
  std::vector<Setting> settings; ///< the best one of them is reported
};

/** \brief This library's, nothing to choose. */
Method ownMethod(unsigned threads);

/** \brief A plane by pcl::SACSegmentation and RANSAC, at several distances. */
Method planeMethod(unsigned threads);

/** \brief pcl::ProgressiveMorphologicalFilter; it has no threads. */
Method morphologicalMethod();

struct Score {
  double f1 = 0.0, precision = 0.0, recall = 0.0;
};

Score scoreOf(const Street& street, const pcl::Indices& found);

} // namespace ground
