// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A model file that samples are added to, and which points count for which class.

#pragma once

#include "cli/command_line.h"
#include "cli/report.h"
#include "io/cloud_file.h"

#include <pcl/features/shape_model.h>

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief Read a model file. \throws InputError that names it and what is wrong */
pcl::ShapeModel loadModel(const std::string& path);

/** \brief Which points of a sample are counted, and how its class is called. */
struct SampleOptions {
  std::string name = "plane";
  std::string field; ///< empty: all points
  std::uint32_t value = 0;
  std::optional<double> prior; ///< else that of -prior, or of the model
};

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

/** \brief One for each class: that of -name and -value, or those of -classes.
 * \throws UsageError for a name that could not be part of a field's name, for one of
 * -field and -value without the other, or for -classes that are not
 * NAME=VALUE[:PRIOR],... */
std::vector<SampleOptions> sampleOptions(const Arguments& arguments);

} // namespace pcl::app
