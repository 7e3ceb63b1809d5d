// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "labels/label_directory.h"

#include "cli/app.h"
#include "cli/atomic_file.h"
#include "cli/errors.h"
#include "cli/filter_app.h"
#include "cli/progress.h"
#include "cli/read_file.h"
#include "io/any_cloud.h"
#include "io/kitti_file.h"
#include "io/ply.h"
#include "labels/label_manifest.h"
#include "labels/labelled_cloud.h"

#include <algorithm>
#include <deque>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

using Json = LabelManifest::Json;

/** Two clouds that differ in their endings only would share an output. */
void
requireDistinctNames(const std::vector<std::string>& inputs)
{
  std::map<std::string, std::string> stems;
  for (const std::string& input : inputs) {
    const auto [other, is_new] = stems.emplace(fs::path(input).stem(), input);
    if (!is_new)
      throw InputError(other->second + " and " + input +
                       " would have the same output: allowed are different names "
                       "before the ending");
  }
}

void
makeDirectory(const fs::path& directory)
{
  std::error_code error;
  fs::create_directory(directory, error);
  if (!fs::is_directory(directory))
    throw InputError(directory.string() +
                     ": cannot be made a directory: " + error.message() +
                     "; allowed is a directory, or a new name in one");
}

Json
parametersOf(const Arguments& arguments, const std::string& format)
{
  const LabelSettings settings = labelSettings(arguments);
  Json parameters{
      {"confidence", settings.confidence}, {"format", format}, {"model", "default"}};
  if (settings.resolution > 0.0)
    parameters["resolution"] = settings.resolution;
  if (arguments.has("model"))
    parameters["model"] = checksumOf(readFile(arguments.text("model"), "a model file"));
  return parameters;
}

/** What the manifest says of one cloud. */
Json
detailsOf(const Report& report,
          const std::vector<std::string>& names,
          const CloudFile& cloud,
          const std::string& format)
{
  Json details{{"points", report.count("", "points")},
               {"finite_points", report.count("", "finite_points")},
               {"mean_confidence", report.number("", "mean_confidence")}};
  for (const std::string& name : names)
    details["counts"][name] = report.count("counts", name);
  if (format == "ply")
    details["fields_left_out"] = fieldsWithoutPly(cloud);
  return details;
}

class DirectoryRun {
public:
  DirectoryRun(const Arguments& arguments, std::string input, std::string output)
  : arguments_(arguments)
  , settings_(labelSettings(arguments))
  , names_(labelNames(settings_))
  , format_(arguments.choice("format", labelFormats()))
  , input_(std::move(input))
  , output_(std::move(output))
  , inputs_(cloudsIn(input_, cloudEndings()))
  , manifest_(output_, parametersOf(arguments, format_), names_)
  {}

  int run();

private:
  void prepare();

  /** \return whether there was something to do */
  bool label(const std::string& input);

  void writeClasses() const;

  const Arguments& arguments_;
  LabelSettings settings_;
  std::vector<std::string> names_;
  std::string format_;
  std::string input_, output_;
  std::vector<std::string> inputs_;
  LabelManifest manifest_;
  std::vector<Report> reports_;
  std::vector<Failure> failures_;
};

void
DirectoryRun::prepare()
{
  requireDistinctNames(inputs_);
  std::vector<std::string> files = inputs_;
  files.push_back(fs::path(output_) / LabelManifest::file_name);
  for (const std::string& input : inputs_)
    for (const std::string& name : outputNames(format_, fs::path(input).stem()))
      files.push_back(fs::path(output_) / name);
  checkJsonPath(arguments_, files);
  checkOutputs(arguments_, files);
  std::error_code error;
  if (fs::equivalent(input_, output_, error))
    throw UsageError("output directory '" + output_ +
                     "' is the input directory: allowed is another directory");
  makeDirectory(output_);
  if (!arguments_.has("overwrite"))
    manifest_.resume();
  if (format_ == "kitti") {
    makeDirectory(fs::path(output_) / "velodyne");
    makeDirectory(fs::path(output_) / "labels");
  }
  removeOrphans(output_);
}

bool
DirectoryRun::label(const std::string& input)
{
  const std::string name = fs::path(input).filename();
  const std::vector<std::string> outputs = outputNames(format_, fs::path(input).stem());
  Report report;
  report.setText("", "input", input);
  report.setText("", "output", fs::path(output_) / outputs.front());
  const std::string contents = readFile(input, "a PCD, PLY or KITTI .bin file");
  if (manifest_.isDone(name, contents))
    return false;
  CloudFile cloud =
      report.time("read", [&] { return decodeAnyCloud(input, contents); });
  const std::vector<std::uint32_t> labels = labelCloud(cloud, settings_, report);
  report.time("write", [&] {
    std::deque<AtomicFile> files;
    const auto encoded = encodeLabelled(format_, cloud, labels);
    for (std::size_t i = 0; i < outputs.size(); ++i)
      files.emplace_back(fs::path(output_) / outputs[i]).write(encoded[i]);
    for (AtomicFile& file : files)
      file.commit();
  });
  manifest_.add(name, contents, outputs, detailsOf(report, names_, cloud, format_));
  manifest_.save();
  printSummary(input, report);
  reports_.push_back(std::move(report));
  return true;
}

void
DirectoryRun::writeClasses() const
{
  const std::vector<std::uint64_t> totals = manifest_.totals();
  double sum = 0.0;
  for (const std::uint64_t total : totals)
    sum += static_cast<double>(total);
  std::vector<KittiClass> classes;
  for (std::size_t label = 0; label < names_.size(); ++label)
    classes.push_back({label == 0 ? "unlabeled" : names_[label],
                       sum > 0.0 ? static_cast<double>(totals[label]) / sum : 0.0});
  AtomicFile file(fs::path(output_) / "classes.yaml");
  file.write(encodeKittiClasses(classes));
  file.commit();
}

int
DirectoryRun::run()
{
  prepare();
  std::size_t done_before = 0;
  Progress progress(arguments_.app(), inputs_);
  for (const std::string& input : inputs_) {
    progress.begin(input);
    try {
      const bool is_new = label(input);
      done_before += is_new ? 0 : 1;
      progress.end(input, is_new);
    }
    catch (const UsageError&) {
      throw;
    }
    catch (const std::exception& error) {
      failures_.push_back({input, error.what()});
      manifest_.addFailure(fs::path(input).filename(), error.what());
      logLine(arguments_.app() + ": " + error.what());
      progress.end(input, true);
    }
  }
  manifest_.save();
  if (format_ == "kitti")
    writeClasses();
  writeJson(arguments_, toJson(arguments_.app(), reports_, failures_));
  logLine(arguments_.app() + ": " + std::to_string(failures_.size()) + " of " +
          std::to_string(inputs_.size()) + " files failed, " +
          std::to_string(done_before) + " were done before");
  return failures_.empty() ? 0 : 1;
}

} // namespace

int
labelDirectory(const Arguments& arguments,
               const std::string& input,
               const std::string& output)
{
  return DirectoryRun(arguments, input, output).run();
}

} // namespace pcl::app
