// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From clouds through a filter to clouds, and the checks of output files.

#include "cli/filter_app.h"

#include "cli/batch.h"
#include "io/any_cloud.h"
#include "io/errors.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

#include <algorithm>
#include <filesystem>
#include <iostream>
#include <optional>
#include <set>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

/** The output is complete in its temporary file when this returns. */
void
process(const Arguments& arguments,
        const std::string& input,
        const std::string& output_path,
        const Filter& filter,
        PCDFormat format,
        AtomicFile& output,
        Report& report)
{
  report.setText("", "input", input);
  report.setText("", "output", output_path);
  CloudFile cloud =
      report.time("read", [&] { return readInput(arguments, input, report); });
  filter(cloud, report);
  report.time("write", [&] {
    output.write(encodeOutput(arguments, output_path, cloud, format));
  });
}

int
runOne(const Arguments& arguments, const Filter& filter)
{
  const auto& operands = arguments.operands(2);
  const PCDFormat format = outputFormat(arguments);
  checkJsonPath(arguments, operands);
  checkCloudOutput(arguments, operands[1]);
  AtomicFile output(operands[1]);
  Report report;
  process(arguments, operands[0], operands[1], filter, format, output, report);
  commitWithJson(arguments, toJson(arguments.app(), report), output);
  printSummary(operands[0], report, operands[1]);
  return 0;
}

/** The output has the input's name; KITTI's .bin holds no fields, and becomes .pcd. */
std::string
outputName(const std::string& input)
{
  fs::path name = fs::path(input).filename();
  if (endingOf(input) == ".bin")
    name.replace_extension(endingOf(name.stem().string()) == ".pcd" ? "" : ".pcd");
  return name.string();
}

int
runDirectory(const Arguments& arguments, const Filter& filter)
{
  arguments.operands(0);
  const PCDFormat format = outputFormat(arguments);
  const std::string input_dir = arguments.text("input_dir");
  const fs::path output_dir = arguments.text("output_dir");
  const std::vector<std::string> inputs = cloudsIn(input_dir, cloudEndings());
  prepareOutputDirectory(output_dir, input_dir);
  const auto outputOf = [&](const std::string& input) {
    return (output_dir / outputName(input)).string();
  };
  std::vector<std::string> outputs;
  for (const std::string& input : inputs)
    outputs.push_back(outputOf(input));
  requireDifferent(inputs, outputs);
  checkJsonPath(arguments, inputs);
  checkJsonPath(arguments, outputs);
  checkOutputs(arguments, outputs);
  return runBatch(arguments, inputs, [&](const std::string& input, Report& report) {
    AtomicFile output(outputOf(input));
    process(arguments, input, outputOf(input), filter, format, output, report);
    output.commit();
    return true;
  });
}

bool
isAmong(const std::vector<std::string>& files, const std::string& path)
{
  return std::any_of(files.begin(),
                     files.end(),
                     [file = fs::weakly_canonical(path)](const std::string& other) {
                       return fs::weakly_canonical(other) == file;
                     });
}

bool
isModel(const Arguments& arguments, const std::string& path)
{
  return arguments.has("model") && isAmong({arguments.text("model")}, path);
}

} // namespace

void
keepFreedMemory()
{
#ifdef __GLIBC__
  constexpr int blocks_of_their_own = 0, never = -1;
  mallopt(M_MMAP_MAX, blocks_of_their_own);
  mallopt(M_TRIM_THRESHOLD, never);
#endif
}

void
addCommonOptions(CommandLine& command_line, bool is_parallel)
{
  command_line
      .option("threads",
              "N",
              is_parallel ? "0 (default) for all cores" : "no effect in this app")
      .option("json", "F", "write a summary for machines to the file F");
}

void
addFormatOption(CommandLine& command_line)
{
  command_line.option(
      "format",
      "F",
      "of the output: binary_compressed (default), binary, ascii; PLY by its ending");
}

void
addFilterOptions(CommandLine& command_line)
{
  addFormatOption(command_line);
  command_line
      .option("input_dir", "D", "process all clouds of D, instead of in.pcd ...")
      .option("output_dir", "D", "... and write them to D");
  addInputOptions(command_line);
  addCommonOptions(command_line);
}

PCDFormat
outputFormat(const Arguments& arguments)
{
  return *formatOf(
      arguments.choice("format", {"binary_compressed", "binary", "ascii"}));
}

int
runFilter(const Arguments& arguments, const Filter& filter)
{
  arguments.threads();
  checkInputOptions(arguments);
  keepFreedMemory();
  return arguments.hasBoth("input_dir", "output_dir") ? runDirectory(arguments, filter)
                                                      : runOne(arguments, filter);
}

void
reportPoints(const pcl::PointCloud<pcl::PointXYZ>& points, Report& report)
{
  report.setCount("", "points", points.size());
  report.setCount(
      "", "finite_points", points.is_dense ? points.size() : countFinite(points));
}

void
printSummary(const std::string& path, const Report& report)
{
  std::cout << path + ": " + report.summary() + '\n';
}

void
printSummary(const std::string& path, const Report& report, const std::string& output)
{
  if (output == standard_stream)
    logLine(path + ": " + report.summary());
  else
    printSummary(path, report);
}

void
warnOfFieldsLeftOut(const Arguments& arguments,
                    const std::string& path,
                    const std::vector<std::string>& fields)
{
  std::string names;
  for (const std::string& name : fields)
    names += " '" + name + "'";
  if (!names.empty())
    logLine(arguments.app() + ": " + path + ": warning: left out" + names +
            ": PLY has no integers of 64 bits; expected a .pcd file for them");
}

std::string
encodeOutput(const Arguments& arguments,
             const std::string& path,
             const CloudFile& cloud,
             PCDFormat format)
{
  warnOfFieldsLeftOut(arguments, path, fieldsLeftOut(path, cloud));
  return encodeAnyCloud(path, cloud, format);
}

void
checkJsonPath(const Arguments& arguments, const std::vector<std::string>& others)
{
  checkOutputPath(arguments, "json", others);
}

void
checkOutputPath(const Arguments& arguments,
                const std::string& option,
                const std::vector<std::string>& others)
{
  if (!arguments.has(option))
    return;
  const std::string path = arguments.text(option);
  if (path == standard_stream)
    throw UsageError("-" + option +
                     " '-' is standard output, which is for clouds; expected a file");
  if (isAmong(others, path) || isModel(arguments, path))
    throw UsageError("-" + option + " '" + path +
                     "' is an input or output file; expected another file");
  requireWritable(path);
}

void
checkOutputs(const Arguments& arguments, const std::vector<std::string>& outputs)
{
  for (const std::string& output : outputs)
    if (isModel(arguments, output))
      throw UsageError("output '" + output +
                       "' is the -model file; expected another file");
}

void
checkCloudOutput(const Arguments& arguments, const std::string& output)
{
  checkOutputs(arguments, {output});
  if (endingOf(output) == ".bin")
    throw UsageError("output '" + output +
                     "' is of KITTI's format, which has no fields; expected .pcd or "
                     ".ply");
  static const std::set<std::string> others{
      ".csv", ".e57", ".las", ".laz", ".obj", ".pts", ".stl", ".txt", ".xyz"};
  if (others.count(endingOf(output)) > 0)
    throw UsageError("output '" + output +
                     "' has the ending of another format; expected .pcd or .ply");
}

void
commitWithJson(const Arguments& arguments,
               const std::string& contents,
               AtomicFile& output)
{
  std::optional<AtomicFile> json;
  if (arguments.has("json"))
    json.emplace(arguments.text("json")).write(contents);
  output.commit();
  if (json)
    json->commit();
}

void
writeJson(const Arguments& arguments, const std::string& contents)
{
  if (!arguments.has("json"))
    return;
  AtomicFile json(arguments.text("json"));
  json.write(contents);
  json.commit();
}

} // namespace pcl::app
