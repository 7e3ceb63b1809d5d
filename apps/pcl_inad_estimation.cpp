// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_inad_estimation: adds mu and sigma of the angles between normals.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/inad.h"
#include "io/errors.h"

#include <cmath>

namespace {

using namespace pcl::app;

void
addInad(CloudFile& file,
        const Arguments& arguments,
        const pcl::INADParameters& parameters,
        Report& report)
{
  const InadCloud cloud = estimateInad(file, arguments, parameters, report);
  std::vector<float> mu;
  std::vector<float> sigma;
  std::uint64_t known = 0;
  for (const pcl::INAD& inad : *cloud.inad) {
    mu.push_back(inad.mu);
    sigma.push_back(inad.sigma);
    known += std::isfinite(inad.mu);
  }
  setField(file, "mu", mu);
  setField(file, "sigma", sigma);
  report.setCount("counts", "with_inad", known);
  report.setCount("counts", "unknown", report.count("", "finite_points") - known);
}

int
run(const Arguments& arguments)
{
  if (!arguments.has("radius") && !arguments.has("k"))
    throw UsageError("-radius and -k are missing; expected one of the two, -radius a "
                     "positive number of meters or -k a positive whole number");
  arguments.exclude("use_normals", "normals");
  const pcl::INADParameters parameters = inadParameters(arguments, {});
  return runFilter(arguments, [&](CloudFile& file, Report& report) {
    addInad(file, arguments, parameters, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line("pcl_inad_estimation",
                           "in.pcd out.pcd -radius R",
                           "Add the fields mu and sigma: mean and standard deviation, "
                           "in radians, of the angles "
                           "between\na point's normal and its neighbors'. NaN where "
                           "there are fewer than five.");
  addInadOptions(command_line);
  command_line.flag("normals", "write normal_x normal_y normal_z curvature too");
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
