// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Kinds of keypoints to compare.

#pragma once

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>
#include <functional>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using KeypointsOf = std::function<Cloud::Ptr(const Cloud::ConstPtr&)>;

/** \brief The median distance of a point to the nearest other one, meters. */
float spacingOf(const Cloud& cloud);

/** \brief Points of creases, four local spacings (see AdaptiveRadius) apart. */
Cloud::Ptr creaseKeypoints(const Cloud::ConstPtr& cloud, unsigned threads);

/** \brief About this many points at equal distances. */
Cloud::Ptr uniformKeypoints(const Cloud::ConstPtr& cloud, std::size_t count);

/** \brief Intrinsic Shape Signatures (Zhong 2009), with the radii of PCL's
 * documentation: 6 spacings, and 4 for the suppression of others.
 * \param[in] spacing that of spacingOf() */
Cloud::Ptr issKeypoints(const Cloud::ConstPtr& cloud, float spacing, unsigned threads);
