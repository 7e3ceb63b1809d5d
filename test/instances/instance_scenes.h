// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Scenes with instances, and the comparison of found and true ones.

#pragma once

#include "segmentation/detection_scenes.h"

#include <pcl/segmentation/shape_instance_segmentation.h>

#include <map>
#include <numeric>
#include <string>
#include <utility>
#include <vector>

/** What the tests of instances share. */
namespace pcl::test {

/** \brief The instance of each point from 1 on, 0 for none. */
inline Labels
labelsOf(const std::vector<PointIndices>& instances, std::size_t points)
{
  Labels labels(points, 0);
  for (std::size_t k = 0; k < instances.size(); ++k)
    for (const index_t i : instances[k].indices)
      labels[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(k + 1);
  return labels;
}

inline Labels
instancesOf(const Cloud::Ptr& cloud, const std::string& of_class, unsigned threads = 0)
{
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass(of_class);
  segmentation.setNumberOfThreads(threads);
  std::vector<PointIndices> instances;
  segmentation.segment(instances);
  return labelsOf(instances, cloud->size());
}

inline std::vector<ShapeInstance>
describedIn(const Cloud::Ptr& cloud,
            const std::string& of_class,
            PrimitiveType primitive = PrimitiveType::None)
{
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setInputCloud(cloud);
  segmentation.setClass(of_class);
  segmentation.setPrimitive(primitive);
  std::vector<ShapeInstance> instances;
  segmentation.segment(instances);
  return instances;
}

/** \brief The same points in another order: order[k] is the old place of point k. */
inline Cloud::Ptr
reordered(const Cloud& cloud, const Indices& order)
{
  // Not copyPointCloud(): it leaves the order as it is when all points are asked for.
  const auto result = make_shared<Cloud>();
  for (const index_t i : order)
    result->push_back(cloud[i]);
  result->is_dense = cloud.is_dense;
  return result;
}

inline Indices
shuffled(std::size_t size)
{
  Indices order(size);
  std::iota(order.begin(), order.end(), 0);
  Random random(5);
  for (std::size_t i = size; i > 1; --i)
    std::swap(order[i - 1], order[random.index(i)]);
  return order;
}

/** \brief True instances, and those of them that were found. */
struct Found {
  std::size_t instances = 0;
  std::size_t found = 0; ///< with an IoU of 0.7
  double point_f1 = 0.0; ///< of the points in matches with an IoU of 0.5

  Found&
  operator+=(const Found& other)
  {
    instances += other.instances;
    found += other.found;
    return *this;
  }

  double
  share() const
  {
    return static_cast<double>(found) / static_cast<double>(instances);
  }
};

/** \brief Compare instances, 0 none, over the points that are evaluated. */
inline Found
compare(const Labels& truth,
        const Labels& predicted,
        const std::vector<bool>& evaluated)
{
  constexpr std::size_t least_points = 300;
  std::map<std::uint32_t, std::size_t> truths, predictions;
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::size_t> both;
  std::size_t true_points = 0, predicted_points = 0, hits = 0;
  for (std::size_t i = 0; i < truth.size(); ++i) {
    if (!evaluated[i])
      continue;
    ++truths[truth[i]];
    ++predictions[predicted[i]];
    ++both[{truth[i], predicted[i]}];
    true_points += truth[i] > 0 ? 1 : 0;
    predicted_points += predicted[i] > 0 ? 1 : 0;
  }
  Found result;
  for (const auto& [label, size] : truths)
    result.instances += label > 0 && size >= least_points ? 1 : 0;
  for (const auto& [labels, common] : both) {
    const auto [of_truth, of_prediction] = labels;
    if (of_truth == 0 || of_prediction == 0)
      continue;
    const std::size_t all = truths[of_truth] + predictions[of_prediction] - common;
    const double iou = static_cast<double>(common) / static_cast<double>(all);
    hits += iou >= 0.5 ? common : 0;
    result.found += iou >= 0.7 && truths[of_truth] >= least_points ? 1 : 0;
  }
  result.point_f1 = 2.0 * static_cast<double>(hits) /
                    static_cast<double>(true_points + predicted_points);
  return result;
}

} // namespace pcl::test
