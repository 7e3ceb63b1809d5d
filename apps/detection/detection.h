// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which method detects with which settings, and the field that it makes.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "detection/inad.h"
#include "io/cloud_file.h"

#include <pcl/features/shape_model.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_detection.h>
#include <pcl/segmentation/shape_field.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

void addResolutionOption(CommandLine& command_line);

/** \brief Meters, 0 if it is not given, for setResolution(). */
double resolutionOf(const Arguments& arguments);

/** \brief Why a result is of another resolution than what was asked for. \param[in]
 * resolution meters */
std::string noteOfResolution(double resolution);

using PointsPtr = pcl::PointCloud<pcl::PointXYZ>::ConstPtr;

/** \brief The options of pcl_shape_back_projection and pcl_shape_edge_detection. */
void addDetectionOptions(CommandLine& command_line);

/** \brief The method, and its settings. */
struct DetectionSettings {
  bool paper = false;
  bool has_model = false; ///< one was given with -model
  double threshold = 0.5;
  double resolution = 0.0;     ///< meters, 0 for the cloud's own; default method
  bool one_resolution = false; ///< for all of the cloud
  INADParameters parameters;   ///< of the paper's method
  pcl::ShapeModel model;       ///< of the paper's method, or the one given
};

/** \brief Settings from the command line and the model file.
 * \param[in] paper the parameters of the paper's method
 * \throws UsageError for an option of the other method
 * \throws InputError for a bad model file, or one that disagrees with the command line
 */
DetectionSettings detectionSettings(const Arguments& arguments,
                                    const INADParameters& paper);

/** \brief What the default method finds in a cloud; the settings are noted, and with
 * -normals these are added. \param[in] edges_only whether classes are left out; a model
 * is then that of edges \throws InputError with the reason if the cloud is refused */
pcl::ShapeField::ConstPtr fieldOf(CloudFile& file,
                                  const PointsPtr& points,
                                  const DetectionSettings& settings,
                                  bool edges_only,
                                  const Arguments& arguments,
                                  Report& report);

/** \brief What ShapeBackProjection and ShapeEdgeDetection share. */
using Detector = pcl::ShapeDetection<pcl::PointXYZ, pcl::Normal>;

/** \brief Give a detector its mode, threshold and points, and for the paper's method
 * all that it needs besides; the default method's field is set by the caller. \return
 * the points */
PointsPtr prepare(Detector& detector,
                  CloudFile& file,
                  const DetectionSettings& settings,
                  const Arguments& arguments,
                  Report& report);

/** \brief Note how many points are of each class, and how many of none. */
void reportClasses(const std::vector<std::string>& names,
                   const std::vector<pcl::PointIndices>& members,
                   Report& report);

/** \brief What the default method finds in a cloud. If many points are unknown, or
 * means stand for them that were not asked for, it is said why. \throws InputError with
 * the reason if the cloud is refused */
pcl::ShapeField::ConstPtr surfaceFieldOf(const CloudFile& file,
                                         const PointsPtr& points,
                                         const std::optional<pcl::ShapeModel>& model,
                                         double resolution,
                                         unsigned threads,
                                         Report& report);

} // namespace pcl::app
