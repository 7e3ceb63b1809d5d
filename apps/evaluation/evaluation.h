// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Precision, recall, F1 and IoU of labels and of instances.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief How well one class was found. A ratio of 0 to 0 is NaN. */
struct Score {
  std::uint64_t true_positives = 0;
  std::uint64_t false_positives = 0;
  std::uint64_t false_negatives = 0;

  double precision() const;

  double recall() const;

  /** \brief Harmonic mean of precision and recall. */
  double f1() const;

  /** \brief Intersection over union, TP / (TP + FP + FN). */
  double iou() const;
};

struct ClassScore {
  std::string name;
  std::uint32_t label;
  Score score;
};

/** \brief What is known of one point. A predicted label that is no class is a negative
 * for every class. */
struct LabelPair {
  std::uint32_t truth;
  std::uint32_t predicted;
};

struct Evaluation {
  std::vector<ClassScore> classes;
  double accuracy = 0.0; ///< share of the points with the right label
  double mean_iou = 0.0; ///< over the classes
};

/** \param[in] classes names and labels, without scores */
Evaluation evaluateLabels(const std::vector<LabelPair>& points,
                          std::vector<ClassScore> classes);

/** \brief Instances, 0 for none. A predicted instance matches the true one that it
 * overlaps with an IoU of 0.5 or more; larger overlaps choose first, each instance
 * once. */
struct InstanceEvaluation {
  Score points;    ///< true positives: points in both instances of a match
  Score instances; ///< true positives: matches
  double mean_matched_iou = 0.0;
};

InstanceEvaluation evaluateInstances(const std::vector<LabelPair>& points);

} // namespace pcl::app
