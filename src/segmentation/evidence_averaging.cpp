/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "evidence_averaging.h"

#include "../kernels/finite.h"
#include "../kernels/parallel.h"
#include "evidence_nodes.h"

#include <algorithm>
#include <cmath>

namespace pcl::segmentation {
namespace {

using detail::AdaptiveEdges;
using detail::AdaptiveInput;

constexpr int rounds = 4; // doc/method.md has the reason

std::vector<bool>
knownPoints(const AdaptiveInput& input,
            const AdaptiveEdges& edges,
            const std::vector<float>& evidence,
            std::size_t classes)
{
  std::vector<bool> is_known(input.points.size);
  for (std::size_t i = 0; i < is_known.size(); ++i)
    is_known[i] = kernels::isFinite(input.points[i]) &&
                  !std::isnan(evidence[i * classes]) &&
                  kernels::isFinite(&edges.normals[3 * i]);
  return is_known;
}

/** A value for each node, class by class. */
using NodeValues = std::vector<std::vector<float>>;

float
sumOf(const std::vector<float>& weights)
{
  const std::size_t count = weights.size();
  const float* weight = weights.data();
  float sum = 0.0f;
#pragma omp simd reduction(+ : sum)
  for (std::size_t k = 0; k < count; ++k)
    sum += weight[k];
  return sum;
}

float
productOf(const std::vector<float>& weights, const float* values)
{
  const std::size_t count = weights.size();
  const float* weight = weights.data();
  float sum = 0.0f;
#pragma omp simd reduction(+ : sum)
  for (std::size_t k = 0; k < count; ++k)
    sum += weight[k] * values[k];
  return sum;
}

/** The mean over the nodes that a point hears of; false if there is none. */
bool
meanAt(std::size_t point,
       const EvidenceNodes& nodes,
       const NodeValues& values,
       std::vector<float>& scratch,
       float* mean)
{
  float total = 0.0f;
  std::fill_n(mean, values.size(), 0.0f);
  const auto add = [&](std::size_t first, const std::vector<float>& weights) {
    total += sumOf(weights);
    for (std::size_t c = 0; c < values.size(); ++c)
      mean[c] += productOf(weights, &values[c][first]);
  };
  nodes.forEachRange(point, scratch, add);
  for (std::size_t c = 0; c < values.size(); ++c)
    mean[c] /= total;
  return total > 0.0f;
}

NodeValues
averaged(const NodeValues& values, const EvidenceNodes& nodes, unsigned threads)
{
  NodeValues result(values.size(), std::vector<float>(nodes.size()));
  kernels::parallelForRanges(
      nodes.size(), threads, [&](std::size_t begin, std::size_t end) {
        std::vector<float> scratch, mean(values.size());
        for (std::size_t k = begin; k < end; ++k) {
          meanAt(nodes.point(k), nodes, values, scratch, mean.data());
          for (std::size_t c = 0; c < values.size(); ++c)
            result[c][k] = mean[c];
        }
      });
  return result;
}

} // namespace

std::vector<float>
averageEvidence(const AdaptiveInput& input,
                const AdaptiveEdges& edges,
                std::vector<float> evidence,
                std::size_t classes)
{
  const std::vector<bool> is_known = knownPoints(input, edges, evidence, classes);
  const EvidenceNodes nodes(input, edges, is_known);
  NodeValues values(classes);
  for (std::size_t c = 0; c < classes; ++c)
    for (std::size_t k = 0; k < nodes.size(); ++k)
      values[c].push_back(evidence[nodes.point(k) * classes + c]);
  for (int round = 1; round < rounds; ++round)
    values = averaged(values, nodes, input.threads);
  kernels::parallelForRanges(
      input.points.size, input.threads, [&](std::size_t begin, std::size_t end) {
        std::vector<float> scratch, mean(classes);
        for (std::size_t i = begin; i < end; ++i)
          if (is_known[i] && meanAt(i, nodes, values, scratch, mean.data()))
            std::copy_n(mean.data(), classes, &evidence[i * classes]);
      });
  return evidence;
}

} // namespace pcl::segmentation
