// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "cli/filter_app.h"

#include "cli/app.h"
#include "cli/atomic_file.h"
#include "cli/errors.h"
#include "io/pcd.h"

#include <algorithm>
#include <filesystem>
#include <iomanip>
#include <iostream>
#include <optional>
#include <sstream>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

struct Job {
  std::string input;
  std::string output;
};

/** The output is complete in its temporary file when this returns. */
Report
process(const Job& job, const Filter& filter, PCDFormat format, AtomicFile& output)
{
  Report report;
  report.setText("", "input", job.input);
  report.setText("", "output", job.output);
  CloudFile cloud = report.time("read", [&] { return readCloud(job.input); });
  filter(cloud, report);
  report.time("write", [&] { output.write(encodeCloud(cloud, format)); });
  return report;
}

int
runOne(const Arguments& arguments, const Filter& filter)
{
  const auto& operands = arguments.operands(2);
  const Job job{operands[0], operands[1]};
  const PCDFormat format = outputFormat(arguments);
  checkJsonPath(arguments, operands);
  checkOutputs(arguments, {job.output});
  AtomicFile output(job.output);
  const Report report = process(job, filter, format, output);
  commitWithJson(arguments, toJson(arguments.app(), report), output);
  printSummary(job.input, report);
  return 0;
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

std::string
prepareOutputDirectory(const Arguments& arguments)
{
  std::string directory = arguments.text("output_dir");
  std::error_code error;
  fs::create_directory(directory, error);
  if (!fs::is_directory(directory))
    throw InputError(directory + ": cannot be made a directory: " + error.message() +
                     "; allowed is a directory, or a new name in one");
  if (fs::equivalent(directory, arguments.text("input_dir"), error))
    throw UsageError("-output_dir '" + directory +
                     "' is the -input_dir: allowed is another directory");
  return directory;
}

int
runDirectory(const Arguments& arguments, const Filter& filter)
{
  if (!arguments.has("input_dir") || !arguments.has("output_dir"))
    throw UsageError("-input_dir '" + arguments.text("input_dir") +
                     "' and -output_dir '" + arguments.text("output_dir") +
                     "': allowed is both or neither");
  arguments.operands(0);
  const PCDFormat format = outputFormat(arguments);
  const std::vector<std::string> inputs = cloudsIn(arguments.text("input_dir"));
  const fs::path output_directory = prepareOutputDirectory(arguments);
  std::vector<std::string> outputs;
  outputs.reserve(inputs.size());
  for (const std::string& input : inputs)
    outputs.push_back(output_directory / fs::path(input).filename());
  checkJsonPath(arguments, inputs);
  checkJsonPath(arguments, outputs);
  checkOutputs(arguments, outputs);

  std::vector<Report> reports;
  std::vector<Failure> failures;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const Job job{inputs[i], outputs[i]};
    logLine(arguments.app() + ": " + std::to_string(i + 1) + " of " +
            std::to_string(inputs.size()) + ": " + job.input);
    try {
      AtomicFile output(job.output);
      reports.push_back(process(job, filter, format, output));
      output.commit();
      printSummary(job.input, reports.back());
    }
    catch (const UsageError&) {
      throw;
    }
    catch (const std::exception& error) {
      failures.push_back({job.input, error.what()});
      logLine(arguments.app() + ": " + error.what());
    }
  }
  writeJson(arguments, toJson(arguments.app(), reports, failures));
  logLine(arguments.app() + ": " + std::to_string(failures.size()) + " of " +
          std::to_string(inputs.size()) + " files failed");
  return failures.empty() ? 0 : 1;
}

} // namespace

void
addCommonOptions(CommandLine& command_line)
{
  command_line.option("threads", "N", "0 (default) for all cores")
      .option("json", "F", "write a summary for machines to the file F");
}

void
addFormatOption(CommandLine& command_line)
{
  command_line.option(
      "format", "F", "of the output: binary_compressed (default), binary, ascii");
}

void
addFilterOptions(CommandLine& command_line)
{
  addFormatOption(command_line);
  command_line
      .option("input_dir", "D", "process all .pcd files of D, instead of in.pcd ...")
      .option("output_dir", "D", "... and write them to D");
  addCommonOptions(command_line);
}

PCDFormat
outputFormat(const Arguments& arguments)
{
  return *formatOf(
      arguments.choice("format", {"binary_compressed", "binary", "ascii"}));
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

int
runFilter(const Arguments& arguments, const Filter& filter)
{
  arguments.threads();
  if (arguments.has("input_dir") || arguments.has("output_dir"))
    return runDirectory(arguments, filter);
  return runOne(arguments, filter);
}

std::vector<std::string>
cloudsIn(const std::string& directory, const std::vector<std::string>& endings)
{
  std::string names;
  for (const std::string& ending : endings)
    names += (names.empty() ? "" : " or ") + ending;
  std::error_code error;
  std::vector<std::string> clouds;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (std::count(endings.begin(), endings.end(), entry.path().extension()) > 0)
      clouds.push_back(entry.path().string());
  if (error)
    throw InputError(directory + ": cannot be listed: " + error.message() +
                     "; allowed is a directory with " + names + " files");
  if (clouds.empty())
    throw InputError(directory + ": has no " + names +
                     " file: allowed is a directory with at least one");
  std::sort(clouds.begin(), clouds.end());
  return clouds;
}

void
reportPoints(const pcl::PointCloud<pcl::PointXYZ>& points, Report& report)
{
  report.setCount("", "points", points.size());
  report.setCount("", "finite_points", countFinite(points));
}

void
printSummary(const std::string& path, const Report& report)
{
  std::ostringstream line;
  line << path << ": " << report.count("", "points") << " points, "
       << report.count("", "finite_points") << " finite";
  for (const Report::Section& section : report.sections())
    if (section.name == "counts")
      for (const auto& [name, value] : section.entries)
        line << ", " << std::get<std::uint64_t>(value) << ' ' << name;
  for (const Report::Section& section : report.sections())
    for (const auto& [name, value] : section.entries)
      if (name == largest_radius)
        line << ", curved up to a radius of " << std::setprecision(2)
             << std::get<double>(value);
  line.precision(0);
  line << std::fixed << ", " << report.totalTime() << " ms\n";
  std::cout << line.str();
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
  if (isAmong(others, path) || isModel(arguments, path))
    throw UsageError("-" + option + " '" + path +
                     "' is an input or output file: allowed is another file");
  requireWritable(path);
}

void
checkOutputs(const Arguments& arguments, const std::vector<std::string>& outputs)
{
  for (const std::string& output : outputs)
    if (isModel(arguments, output))
      throw UsageError("output '" + output +
                       "' is the -model file: allowed is another file");
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
