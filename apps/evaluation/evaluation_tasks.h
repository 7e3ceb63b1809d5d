// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What each task of pcl_shape_evaluate compares: fields, points, classes.

#pragma once

#include "evaluation/evaluation.h"
#include "io/cloud_file.h"

#include <string>
#include <vector>

namespace pcl::app {

/** \brief strict leaves out the points that are hard to tell by hand; paper counts
 * creases as curved and as edges. */
enum class Convention { strict, paper };

/** \brief The points that a task evaluates. */
struct TaskPoints {
  std::vector<LabelPair> points;
  std::vector<std::size_t> indices; ///< of these points in the cloud
  std::vector<ClassScore> classes;  ///< the task's own first; none for instances
  std::uint64_t unknown = 0;        ///< of the points, predictions without a class
  /** The predicted field has the truth's values at all points, also at those left out:
   * it may be a copy of it. Empty if not. */
  std::string copied_field;
};

/** \brief The tasks' names. */
const std::vector<std::string>& taskNames();

/** \brief The field that tells objects apart: generated scenes have instances, data
 * sets of objects call them labels. \throws InputError if there is none */
std::string fieldOfObjects(const CloudFile& truth);

/** \brief Select and label the points of a task other than grasps. Points without
 * coordinates in the truth are left out. \throws InputError for a missing field, or if
 * the clouds differ in size \throws UsageError for a task that has no paper convention
 */
TaskPoints selectPoints(const std::string& task,
                        Convention convention,
                        const CloudFile& predicted,
                        const CloudFile& truth);

/** \brief What became of a point, for the first class of a task. */
enum class Outcome : std::uint32_t {
  left_out = 0,
  rightly_not = 1,
  hit = 2,
  miss = 3,
  false_alarm = 4
};

/** \brief The field "outcome" of all points of the cloud, as numbers.
 * \param[in] selected with a class \param[in] points of the cloud */
std::vector<std::uint32_t> outcomesOf(const TaskPoints& selected, std::size_t points);

} // namespace pcl::app
