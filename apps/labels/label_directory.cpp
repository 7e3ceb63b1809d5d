// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A directory of labeled clouds, and the manifest of those that are complete.

#include "labels/label_directory.h"

#include "cli/batch.h"
#include "cli/filter_app.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/files.h"
#include "io/kitti_file.h"
#include "io/ply.h"
#include "labels/labeled_cloud.h"

#include <pcl/pcl_config.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <deque>
#include <filesystem>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

/** A checksum, FNV-1a of 64 bits, in hexadecimal. */
std::string
checksumOf(std::string_view contents)
{
  std::uint64_t hash = 0xcbf29ce484222325u;
  for (const char c : contents)
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3u;
  constexpr std::size_t digits = 16;
  std::string text(digits, '0');
  for (std::size_t i = digits; i-- > 0; hash >>= 4u)
    text[i] = "0123456789abcdef"[hash & 15u];
  return text;
}

/** All that the labels depend on, besides the cloud. */
Json
parametersOf(const LabelSettings& settings,
             const Arguments& arguments,
             const std::string& format)
{
  Json parameters{
      {"confidence", settings.confidence}, {"format", format}, {"model", "default"}};
  if (settings.resolution > 0.0)
    parameters["resolution"] = settings.resolution;
  for (const char* const option : {"offset", "floats"})
    if (arguments.has(option))
      parameters[option] = arguments.text(option);
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

/** The manifest.json of a directory: what is in it and how it was made. It is
 * rewritten, whole or not at all, after each cloud. */
class Manifest {
public:
  /** \param[in] classes names of the labels from 0 on */
  Manifest(const fs::path& directory,
           const Json& parameters,
           const std::vector<std::string>& classes);

  static fs::path
  pathIn(const fs::path& directory)
  {
    return directory / "manifest.json";
  }

  /** Read the files of an existing manifest.
   * \throws InputError if it is no manifest, or one of other parameters */
  void resume();

  /** Whether a cloud was labeled and its files are still there. */
  bool isDone(const std::string& input, std::string_view contents) const;

  /** \param[in] outputs names of files in the directory */
  void add(const std::string& input,
           std::string_view contents,
           const std::vector<std::string>& outputs,
           const Json& details);

  /** The failures of this run; those of earlier runs are dropped. */
  void
  addFailure(const std::string& input, const std::string& error)
  {
    failures_.push_back({{"input", input}, {"error", error}});
  }

  void save() const;

  /** Points of all files by label. */
  std::vector<std::uint64_t> totals() const;

private:
  fs::path directory_;
  Json head_; ///< what must be the same to resume
  std::vector<std::string> classes_;
  Json files_ = Json::array(); ///< sorted by input
  Json failures_ = Json::array();
};

Manifest::Manifest(const fs::path& directory,
                   const Json& parameters,
                   const std::vector<std::string>& classes)
: directory_(directory)
, head_{{"format", "pcl_shape labels"},
        {"version", 1},
        {"software", {{"pcl_shape", PCL_SHAPE_VERSION}, {"pcl", PCL_VERSION_PRETTY}}},
        {"parameters", parameters}}
, classes_(classes)
{
  head_["classes"] = Json::array();
  for (std::size_t label = 0; label < classes.size(); ++label)
    head_["classes"].push_back({{"label", label}, {"name", classes[label]}});
}

/** Throws unless the members of a file are what isDone() and totals() read. */
void
checkFiles(const Json& files, const std::vector<std::string>& classes)
{
  for (const Json& file : files) {
    file.at("input").get_ref<const std::string&>();
    file.at("checksum").get_ref<const std::string&>();
    for (const Json& output : file.at("outputs")) {
      output.at("name").get_ref<const std::string&>();
      output.at("bytes").get<std::uint64_t>();
    }
    for (const std::string& name : classes)
      file.at("counts").at(name).get<std::uint64_t>();
  }
}

void
Manifest::resume()
{
  const std::string path = pathIn(directory_);
  if (!fs::exists(path))
    return;
  Json old;
  try {
    old = Json::parse(readFile(path, "a manifest of pcl_shape_label"));
    checkFiles(old.at("files"), {});
  }
  catch (const Json::exception& error) {
    throw InputError(path + ": is no manifest of labels: " + error.what() +
                     "; expected one, no file, or -overwrite");
  }
  for (const auto& [name, value] : head_.items())
    if (!old.contains(name) || old[name] != value)
      throw InputError(path + ": its clouds were labeled with other " + name + ", " +
                       (old.contains(name) ? old[name].dump() : "none") +
                       " instead of " + value.dump() +
                       "; expected the same, another directory, or -overwrite");
  try {
    checkFiles(old["files"], classes_);
  }
  catch (const Json::exception& error) {
    throw InputError(path + ": " + error.what() +
                     "; expected the counts of every class, or -overwrite");
  }
  files_ = old["files"];
}

bool
Manifest::isDone(const std::string& input, std::string_view contents) const
{
  const auto file = std::find_if(
      files_.begin(), files_.end(), [&](const Json& f) { return f["input"] == input; });
  if (file == files_.end() || (*file)["checksum"] != checksumOf(contents))
    return false;
  const Json& outputs = (*file)["outputs"];
  return std::all_of(outputs.begin(), outputs.end(), [&](const Json& output) {
    std::error_code error;
    const fs::path path = directory_ / output["name"].get<std::string>();
    return fs::is_regular_file(path, error) &&
           fs::file_size(path, error) == output["bytes"].get<std::uint64_t>();
  });
}

void
Manifest::add(const std::string& input,
              std::string_view contents,
              const std::vector<std::string>& outputs,
              const Json& details)
{
  Json file{{"input", input},
            {"bytes", contents.size()},
            {"checksum", checksumOf(contents)},
            {"outputs", Json::array()}};
  for (const std::string& output : outputs)
    file["outputs"].push_back(
        {{"name", output}, {"bytes", fs::file_size(directory_ / output)}});
  file.update(details);
  const auto place = std::find_if(files_.begin(), files_.end(), [&](const Json& f) {
    return f["input"].get_ref<const std::string&>() >= input;
  });
  if (place != files_.end() && (*place)["input"] == input)
    *place = std::move(file);
  else
    files_.insert(place, std::move(file));
}

std::vector<std::uint64_t>
Manifest::totals() const
{
  std::vector<std::uint64_t> totals(classes_.size(), 0);
  for (const Json& file : files_)
    for (std::size_t label = 0; label < classes_.size(); ++label)
      totals[label] += file["counts"][classes_[label]].get<std::uint64_t>();
  return totals;
}

void
Manifest::save() const
{
  Json json = head_;
  const std::vector<std::uint64_t> counts = totals();
  for (std::size_t label = 0; label < classes_.size(); ++label)
    json["counts"][classes_[label]] = counts[label];
  json["files"] = files_;
  json["failures"] = failures_;
  AtomicFile file(pathIn(directory_));
  file.write(dumpJson(json));
  file.commit();
}

class DirectoryRun {
public:
  DirectoryRun(const Arguments& arguments,
               const std::string& input,
               const std::string& output)
  : arguments_(arguments)
  , settings_(labelSettings(arguments))
  , names_(labelNames(settings_))
  , format_(arguments.choice("format", labelFormats()))
  , input_(input)
  , output_(output)
  , inputs_(cloudsIn(input, cloudEndings()))
  , manifest_(output, parametersOf(settings_, arguments, format_), names_)
  {}

  int run();

private:
  std::vector<std::string>
  outputsOf(const std::string& input) const
  {
    return outputNames(format_, fs::path(input).stem());
  }

  void prepare();

  /** \return whether there was something to do */
  bool label(const std::string& input, Report& report);

  void writeClasses() const;

  const Arguments& arguments_;
  LabelSettings settings_;
  std::vector<std::string> names_;
  std::string format_;
  std::string input_;
  fs::path output_;
  std::vector<std::string> inputs_;
  Manifest manifest_;
};

void
DirectoryRun::prepare()
{
  std::vector<std::string> stems, files = inputs_;
  files.push_back(Manifest::pathIn(output_));
  for (const std::string& input : inputs_) {
    stems.push_back(fs::path(input).stem());
    for (const std::string& name : outputsOf(input))
      files.push_back(output_ / name);
  }
  requireDifferent(inputs_, stems);
  checkJsonPath(arguments_, files);
  checkOutputs(arguments_, files);
  prepareOutputDirectory(output_, input_);
  if (!arguments_.has("overwrite"))
    manifest_.resume();
  if (format_ == "kitti")
    for (const char* const name : {"velodyne", "labels"})
      makeDirectory(output_ / name);
  removeOrphans(output_);
}

bool
DirectoryRun::label(const std::string& input, Report& report)
{
  const std::string name = fs::path(input).filename();
  const std::vector<std::string> outputs = outputsOf(input);
  report.setText("", "input", input);
  report.setText("", "output", output_ / outputs.front());
  const std::string contents = readFile(input, "a PCD, PLY or KITTI .bin file");
  if (manifest_.isDone(name, contents))
    return false;
  CloudFile cloud = report.time("read", [&] {
    CloudFile decoded = decodeAnyCloud(input, contents, floatsOfBin(arguments_));
    chooseOffset(arguments_, decoded, report);
    return decoded;
  });
  const std::vector<std::uint32_t> labels = labelCloud(cloud, settings_, report);
  report.time("write", [&] {
    std::deque<AtomicFile> files;
    const auto encoded = encodeLabeled(format_, cloud, labels);
    for (std::size_t i = 0; i < outputs.size(); ++i)
      files.emplace_back(output_ / outputs[i]).write(encoded[i]);
    for (AtomicFile& file : files)
      file.commit();
  });
  manifest_.add(name, contents, outputs, detailsOf(report, names_, cloud, format_));
  manifest_.save();
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
  AtomicFile file(output_ / "classes.yaml");
  file.write(encodeKittiClasses(classes));
  file.commit();
}

int
DirectoryRun::run()
{
  prepare();
  const auto job = [this](const std::string& input, Report& report) {
    try {
      return label(input, report);
    }
    catch (const std::exception& error) {
      manifest_.addFailure(fs::path(input).filename(), error.what());
      throw;
    }
  };
  return runBatch(arguments_, inputs_, job, [this] {
    manifest_.save();
    if (format_ == "kitti")
      writeClasses();
  });
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
