// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_label: labels clouds for training.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/detection.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/ply.h"
#include "labels/label_directory.h"
#include "labels/labeled_cloud.h"

#include <filesystem>

namespace {

using namespace pcl::app;
namespace fs = std::filesystem;

/** The format that -format or the ending of the output says. */
std::string
formatOfFile(const Arguments& arguments, const std::string& output)
{
  if (!arguments.has("format"))
    return endingOf(output) == ".ply" ? "ply" : "pcd";
  const std::string format = arguments.choice("format", labelFormats());
  if (format == "kitti")
    throw UsageError("-format 'kitti' of a single file; expected pcd or ply, or a "
                     "directory of clouds");
  return format;
}

int
labelFile(const Arguments& arguments)
{
  const auto& operands = arguments.operands(2);
  if (arguments.has("overwrite"))
    throw UsageError("-overwrite of a single file; expected a directory of clouds");
  const LabelSettings settings = labelSettings(arguments);
  const std::string format = formatOfFile(arguments, operands[1]);
  checkJsonPath(arguments, operands);
  checkCloudOutput(arguments, operands[1]);
  AtomicFile output(operands[1]);
  Report report;
  report.setText("", "input", operands[0]);
  report.setText("", "output", operands[1]);
  CloudFile cloud =
      report.time("read", [&] { return readInput(arguments, operands[0], report); });
  const std::vector<std::uint32_t> labels = labelCloud(cloud, settings, report);
  if (format == "ply")
    warnOfFieldsLeftOut(arguments, operands[1], fieldsWithoutPly(cloud));
  report.time("write",
              [&] { output.write(encodeLabeled(format, cloud, labels).front()); });
  commitWithJson(arguments, toJson(arguments.app(), report), output);
  printSummary(operands[0], report, operands[1]);
  return 0;
}

int
run(const Arguments& arguments)
{
  checkInputOptions(arguments);
  if (arguments.hasBoth("input_dir", "output_dir")) {
    arguments.operands(0);
    return labelDirectory(
        arguments, arguments.text("input_dir"), arguments.text("output_dir"));
  }
  const auto& operands = arguments.operands(2);
  return fs::is_directory(operands[0])
             ? labelDirectory(arguments, operands[0], operands[1])
             : labelFile(arguments);
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_label",
      "in.pcd|DIR out.pcd|OUTDIR",
      "Label clouds for training: add the fields label (0 void, 1 planar, 2 curved, 3 "
      "edge) and\nconfidence. From a directory, with a manifest; a second run does "
      "what "
      "is missing.\nInput may be PCD, PLY or KITTI's .bin.");
  command_line
      .option("confidence",
              "C",
              "probability of being right from which a label is kept (0.95)")
      .option("format",
              "F",
              "pcd (default), ply, or kitti: velodyne/*.bin, labels/*.label, "
              "classes.yaml")
      .option("model", "F", "a model of other surfaces, made with -scale density")
      .flag("overwrite", "of a directory: label everything anew")
      .option("input_dir", "D", "a directory of clouds, instead of DIR ...")
      .option("output_dir", "D", "... and OUTDIR");
  addResolutionOption(command_line);
  addInputOptions(command_line);
  addCommonOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
