// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_histogram: makes a model file from samples of surfaces.

#include "cli/batch.h"
#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/inad.h"
#include "detection/model_file.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/files.h"

#include <iostream>

namespace {

using namespace pcl::app;

std::vector<std::string>
samplesOf(const Arguments& arguments)
{
  if (arguments.has("input_dir"))
    return cloudsIn(arguments.text("input_dir"), cloudEndings());
  const auto& operands = arguments.operandsFrom(2);
  return {operands.begin(), operands.end() - 1};
}

void
printHistogram(const Report& report)
{
  std::cout << report.text("", "model") << ": class "
            << report.text("parameters", "name") << ", "
            << report.count("histogram", "total") << " points, "
            << report.count("histogram", "outside") << " beyond the bins, peak "
            << report.count("histogram", "peak") << " at mu "
            << report.number("histogram", "peak_mu") << ", sigma "
            << report.number("histogram", "peak_sigma") << " degrees\n";
}

int
run(const Arguments& arguments)
{
  const std::string model_path = arguments.has("input_dir")
                                     ? arguments.operands(1).back()
                                     : arguments.operandsFrom(2).back();
  const std::vector<SampleOptions> classes = sampleOptions(arguments);
  arguments.threads();
  checkInputOptions(arguments);
  const std::vector<std::string> samples = samplesOf(arguments);
  std::vector<std::string> others = samples;
  others.push_back(model_path);
  checkJsonPath(arguments, others);
  requireWritable(model_path);

  ModelFile model(model_path, arguments, classes);
  std::vector<Report> reports;
  for (const std::string& sample : samples) {
    Report& report = reports.emplace_back();
    report.setText("", "input", sample);
    CloudFile cloud =
        report.time("read", [&] { return readInput(arguments, sample, report); });
    model.add(cloud, report);
  }
  Report result;
  model.save(result);
  for (const Report& report : reports)
    printSummary(report.text("", "input"), report);
  result.setCount("", "samples", samples.size());
  for (const Report& report : reports)
    result.setCount(
        "counted", report.text("", "input"), report.count("counts", "counted"));
  printHistogram(result);
  writeJson(arguments, toJson(arguments.app(), result));
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line("pcl_shape_histogram",
                           "sample.pcd ... model.json -radius R",
                           "Make a model file of the shape of a sample surface, or add "
                           "the sample to one.\nAll "
                           "points of the sample are neighbors; -field and -value "
                           "choose those that are counted.\nWith -field and -classes "
                           "several classes are counted at once.");
  addInadOptions(command_line);
  command_line.option("name", "NAME", "of the class (plane)")
      .option("field", "F", "count only the points where the field F ...")
      .option("value", "V", "... has the value V")
      .option(
          "classes", "N=V:P,...", "several classes: N, where -field is V; prior P (1)")
      .option("normal_radius_noise",
              "X",
              "with -scale density: what the noise, in spacings, adds (0)")
      .option("radius_noise", "X", "likewise")
      .option("smoothing", "B", "bins, of densities, with -scale density (0)")
      .option("floor", "D", "density, 1/rad^2, below which a class says nothing (0)")
      .option("bins", "N", "N x N bins (10, or as in the model file)")
      .option("mu_range", "A", "degrees, angles from there are beyond the bins (90)")
      .option("sigma_range", "A", "degrees, the same for sigma (90)")
      .option("prior", "P", "how frequent the class is, relative to the others (1)")
      .option("input_dir", "D", "all clouds of D instead of sample.pcd");
  addInputOptions(command_line);
  addCommonOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
