// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How many instances were found.

#pragma once

#include "instance_cloud.h"

namespace instances {

/** \brief How well the instances of some clouds were found. Instances of less than 300
 * points are not counted, but their points are. */
struct Scores {
  std::size_t clouds = 0;
  double point_f1 = 0.0; ///< sum over the clouds: points of matches with an IoU of 0.5
  std::size_t instances = 0;
  std::size_t found = 0;  ///< with an IoU of 0.7 or more
  std::size_t merged = 0; ///< the instance that has most of it has most of another
  std::size_t split = 0;  ///< two instances or more have a fifth of it each
  std::size_t missed = 0; ///< the rest
  std::size_t extra = 0;  ///< instances found that are at no true one (IoU below 0.1)
  double milliseconds = 0.0; ///< sum

  Scores& operator+=(const Scores& other);
};

Scores scoresOf(const InstanceCloud& cloud, const Labels& predicted);

} // namespace instances
