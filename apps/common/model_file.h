/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "arguments.h"
#include "cloud_file.h"
#include "report.h"

#include <pcl/features/shape_model.h>

#include <string>

namespace pcl::app {

/** \brief Read a model file. \throws InputError that names it, what is wrong and
 * allowed */
pcl::ShapeModel loadModel(const std::string& path);

/** \brief Which points of a sample are counted, and how its class is called. */
struct SampleOptions {
  std::string name = "plane";
  std::string field; ///< empty: all points
  std::uint32_t value = 0;
};

/** \throws UsageError for a name that could not be part of a field's name, or for one
 * of -field and -value without the other */
SampleOptions sampleOptions(const Arguments& arguments);

/** \brief A model file that is made, or extended, with samples of one class. */
class ModelFile {
public:
  /** \throws InputError if the file exists and disagrees with the command line */
  ModelFile(const std::string& path, const Arguments& arguments);

  /** \brief Count the INAD of a sample. \throws InputError if no point counts */
  void add(CloudFile& sample, const SampleOptions& options, Report& report);

  /** \brief Write the file, and report its parameters and the class that was added to.
   */
  void save(const SampleOptions& options, Report& report);

private:
  pcl::ShapeHistogram emptyHistogram() const;

  double priorOf(const std::string& name) const;

  std::string path_;
  const Arguments& arguments_;
  pcl::ShapeModel model_;
  pcl::ShapeHistogram histogram_;
};

} // namespace pcl::app
