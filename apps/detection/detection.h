// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Prepares the detectors of surfaces and edges from the command line.

#pragma once

#include "cli/arguments.h"
#include "cli/command_line.h"
#include "cli/errors.h"
#include "cli/filter_app.h"
#include "detection/inad_options.h"
#include "detection/inad_stages.h"
#include "detection/resolution.h"

#include <pcl/features/shape_model.h>

#include <optional>
#include <string>

namespace pcl::app {

/** \brief The options of pcl_shape_back_projection and pcl_shape_edge_detection. */
void addDetectionOptions(CommandLine& command_line);

/** \brief What is to be looked for, and with which parameters. */
struct DetectionSettings {
  bool paper = false;
  bool adaptive = false; ///< the parameters are the detector's and the model's own
  double threshold = 0.5;
  double resolution = 0.0; ///< metres, 0 the cloud's own
  INADParameters parameters;
  pcl::ShapeModel model;
};

/** \brief Settings from the command line and the model file.
 * \param[in] defaults the detector's own
 * \throws InputError for a bad model file, or one that disagrees with the command line
 */
DetectionSettings detectionSettings(const Arguments& arguments,
                                    const INADParameters& defaults);

/** \brief A detector that is ready for compute(): it estimates what it needs itself. */
template <typename Detector>
void
prepareAdaptive(Detector& detector,
                CloudFile& file,
                const DetectionSettings& settings,
                const Arguments& arguments,
                Report& report)
{
  const auto points = pointsOf(file);
  reportPoints(*points, report);
  report.setText("parameters", "mode", "default");
  report.setText("parameters", "scale", "density");
  report.setNumber("parameters", "threshold", settings.threshold);
  report.setText("parameters", "model", arguments.text("model", "default"));
  report.setCount("parameters", "threads", arguments.threads());
  detector.setInputCloud(points);
  if (arguments.has("model"))
    detector.setModel(settings.model);
  detector.setResolution(settings.resolution);
  reportResolution(settings.resolution, report);
  detector.setThreshold(settings.threshold);
  detector.setNumberOfThreads(arguments.threads());
  if (arguments.has("normals"))
    addNormals(file, detector.getParameters(), arguments.threads());
}

/** \brief A detector that is ready for compute(): its INAD is computed, unless the
 * settings are adaptive. */
template <typename Detector>
void
prepare(Detector& detector,
        CloudFile& file,
        const DetectionSettings& settings,
        const Arguments& arguments,
        Report& report)
{
  if (settings.adaptive) {
    prepareAdaptive(detector, file, settings, arguments, report);
    return;
  }
  const InadCloud cloud = estimateInad(file, arguments, settings.parameters, report);
  report.setText("parameters", "mode", settings.paper ? "paper" : "default");
  report.setNumber("parameters", "threshold", settings.threshold);
  report.setText("parameters", "model", arguments.text("model", "ideal plane"));
  report.setCount(
      "parameters", "bins", settings.model.classes().front().histogram.muBins());
  detector.setMode(settings.paper ? Detector::PAPER : Detector::DEFAULT);
  detector.setInputCloud(cloud.points);
  detector.setInputNormals(cloud.normals);
  detector.setInputINAD(cloud.inad);
  detector.setModel(settings.model);
  detector.setThreshold(settings.threshold);
  detector.setIgnoreModelParameters(arguments.has("ignore_model_parameters"));
  detector.setNumberOfThreads(arguments.threads());
}

} // namespace pcl::app
