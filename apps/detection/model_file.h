// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A model file that samples are added to.

#pragma once

#include "cli/arguments.h"
#include "cli/report.h"
#include "detection/sample_options.h"
#include "io/cloud_file.h"

#include <pcl/features/shape_model.h>

#include <string>
#include <vector>

namespace pcl::app {

/** \brief Read a model file. \throws InputError that names it and what is wrong */
pcl::ShapeModel loadModel(const std::string& path);

/** \brief A model file that is made, or extended, with labeled samples. */
class ModelFile {
public:
  /** \param[in] classes what each sample may have
   * \throws InputError if the file exists and disagrees with the command line */
  ModelFile(const std::string& path,
            const Arguments& arguments,
            std::vector<SampleOptions> classes);

  /** \brief Count the INAD of a sample. \throws InputError if no point counts */
  void add(CloudFile& sample, Report& report);

  /** \brief Write the file, and report its parameters and the class that was added to,
   * of several the first. \throws InputError if a class has no point in any sample */
  void save(Report& report);

  const pcl::ShapeModel&
  model() const
  {
    return model_;
  }

private:
  double priorOf(const SampleOptions& options) const;

  void addClasses();

  std::string path_;
  const Arguments& arguments_;
  pcl::ShapeModel model_;
  std::vector<SampleOptions> classes_;
  std::vector<pcl::ShapeHistogram> histograms_; ///< one a class
};

} // namespace pcl::app
