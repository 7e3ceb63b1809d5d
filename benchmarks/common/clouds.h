// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds to measure with: files, table scenes, sheets and laser scans.

#pragma once

#include "options.h"

#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <cstddef>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;

/** \brief The file or the generated cloud that the options name, as it is: organized
 * clouds have points that are not finite. */
Cloud::Ptr cloudOf(const Options& options);

/** \brief The same without such points, and shuffled if the options say so. */
Cloud::Ptr finiteCloudOf(const Options& options);

/** \brief A depth camera's view of a table with objects: 640 x 480, organized. */
Cloud::Ptr sceneCloud();

/** \brief A wavy sheet with noise, about as dense as a depth camera's cloud at 0.9 m,
 * line by line. Its area grows with the number of points, its density does not. */
Cloud::Ptr sheetCloud(std::size_t points);

/** \brief A turn of a laser scanner with 64 rings in a street, ring by ring: ground,
 * houses, cars, trunks. Points are millimeters apart near the scanner and meters far
 * away. */
Cloud::Ptr laserCloud();
