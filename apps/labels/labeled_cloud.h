// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Labels one cloud for training, in the formats that trainers read.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_labeling.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief How clouds are labeled. */
struct LabelSettings {
  double confidence = pcl::ShapeLabeling<pcl::PointXYZ>::default_confidence;
  double resolution = 0.0; ///< meters, 0 the cloud's own
  std::optional<pcl::ShapeModel> model;
  unsigned threads = 0;
};

/** \brief The settings of -confidence, -resolution, -model and -threads. */
LabelSettings labelSettings(const Arguments& arguments);

/** \brief The names of the labels from 0 on: void, the classes, edge. */
std::vector<std::string> labelNames(const LabelSettings& settings);

/** \brief Set the fields label and confidence, and note the counts.
 * \return the labels \throws InputError if the cloud or the model is refused */
std::vector<std::uint32_t>
labelCloud(CloudFile& cloud, const LabelSettings& settings, Report& report);

/** \brief The names of what can be written: pcd, ply, kitti. */
const std::vector<std::string>& labelFormats();

/** \brief The names of the files of a cloud. \param[in] stem its name, without ending
 */
std::vector<std::string> outputNames(const std::string& format,
                                     const std::string& stem);

/** \brief The contents of the files that outputNames() names. */
std::vector<std::string> encodeLabeled(const std::string& format,
                                       const CloudFile& cloud,
                                       const std::vector<std::uint32_t>& labels);

} // namespace pcl::app
