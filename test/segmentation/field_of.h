// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The field of a cloud, for tests that look into it.

#pragma once

#include <pcl/segmentation/shape_field_estimation.h>

#include <gtest/gtest.h>

namespace pcl::test {

inline ShapeField
fieldOf(const PointCloud<PointXYZ>::ConstPtr& cloud,
        ShapeFieldEstimation<PointXYZ>& estimation)
{
  estimation.setInputCloud(cloud);
  ShapeField field;
  EXPECT_TRUE(estimation.compute(field));
  return field;
}

inline ShapeField
fieldOf(const PointCloud<PointXYZ>::ConstPtr& cloud, unsigned threads = 0)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setNumberOfThreads(threads);
  return fieldOf(cloud, estimation);
}

/** \brief Without surfaces, which take most of the time. */
inline ShapeField
edgeFieldOf(const PointCloud<PointXYZ>::ConstPtr& cloud,
            double resolution = 0.0,
            unsigned threads = 0)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setEdgesOnly(true);
  estimation.setResolution(resolution);
  estimation.setNumberOfThreads(threads);
  return fieldOf(cloud, estimation);
}

/** \brief Of a part of a cloud. \param[in] numbers of the cloud */
inline ShapeField
edgeFieldOf(const PointCloud<PointXYZ>::ConstPtr& cloud, const CloudNumbers& numbers)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setEdgesOnly(true);
  estimation.setCloudNumbers(numbers);
  return fieldOf(cloud, estimation);
}

} // namespace pcl::test
