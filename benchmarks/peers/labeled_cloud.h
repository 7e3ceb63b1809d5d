// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A cloud with the truth of one task.

#pragma once

#include "../common/clouds.h"
#include "evaluation/evaluation.h"
#include "io/cloud_file.h"

#include <cstdint>
#include <string>
#include <vector>

namespace peers {

/** \brief The points of a cloud that a task evaluates, strict convention. */
struct Truth {
  struct Point {
    std::uint32_t label;
    std::size_t index; ///< in the cloud
  };
  std::vector<Point> points;
  std::vector<pcl::app::ClassScore> classes; ///< the one looked for first

  /** \brief Whether there are points of the class that is looked for. */
  bool hasAny() const;
};

struct LabeledCloud {
  std::string name;
  Cloud::Ptr points;
  Truth edges;    ///< empty unless asked for
  Truth surfaces; ///< likewise
};

enum class Task { edges, surfaces };

/** \brief Read the finite points of a cloud with truth: the fields edge and surface; of
 * machined parts (with thin_s, radius_s and crease_s) without what may be called either
 * way; or only table, which is planar and no edge. \throws pcl::app::InputError if it
 * has none for these tasks */
LabeledCloud readLabeledCloud(const std::string& path, const std::vector<Task>& tasks);

/** \brief The connected parts of the truth's curved points, of 100 points or more. */
std::size_t countCurvedParts(const LabeledCloud& cloud);

} // namespace peers
