// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "labels/label_manifest.h"

#include "cli/atomic_file.h"
#include "cli/errors.h"
#include "cli/read_file.h"

#include <pcl/pcl_config.h>

#include <algorithm>
#include <filesystem>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

using Json = LabelManifest::Json;

std::string
pathIn(const std::string& directory, const std::string& name)
{
  return fs::path(directory) / name;
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

} // namespace

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

LabelManifest::LabelManifest(const std::string& directory,
                             Json parameters,
                             const std::vector<std::string>& classes)
: directory_(directory)
, head_{{"format", "pcl_shape labels"},
        {"version", 1},
        {"software", {{"pcl_shape", PCL_SHAPE_VERSION}, {"pcl", PCL_VERSION_PRETTY}}},
        {"parameters", std::move(parameters)}}
, classes_(classes)
{
  head_["classes"] = Json::array();
  for (std::size_t label = 0; label < classes.size(); ++label)
    head_["classes"].push_back({{"label", label}, {"name", classes[label]}});
}

void
LabelManifest::resume()
{
  const std::string path = pathIn(directory_, file_name);
  if (!fs::exists(path))
    return;
  Json old;
  try {
    old = Json::parse(readFile(path, "a manifest of pcl_shape_label"));
    checkFiles(old.at("files"), {});
  }
  catch (const Json::exception& error) {
    throw InputError(path + ": is no manifest of labels: " + error.what() +
                     "; allowed is one, no file, or -overwrite");
  }
  for (const auto& [name, value] : head_.items())
    if (!old.contains(name) || old[name] != value)
      throw InputError(path + ": its clouds were labelled with other " + name + ", " +
                       (old.contains(name) ? old[name].dump() : "none") +
                       " instead of " + value.dump() +
                       ": allowed are the same, another directory, or -overwrite");
  try {
    checkFiles(old["files"], classes_);
  }
  catch (const Json::exception& error) {
    throw InputError(path + ": " + error.what() +
                     ": allowed are the counts of every class, or -overwrite");
  }
  files_ = old["files"];
}

bool
LabelManifest::isDone(const std::string& input, std::string_view contents) const
{
  const auto file = std::find_if(
      files_.begin(), files_.end(), [&](const Json& f) { return f["input"] == input; });
  if (file == files_.end() || (*file)["checksum"] != checksumOf(contents))
    return false;
  const Json& outputs = (*file)["outputs"];
  return std::all_of(outputs.begin(), outputs.end(), [&](const Json& output) {
    std::error_code error;
    const std::string path = pathIn(directory_, output["name"].get<std::string>());
    return fs::is_regular_file(path, error) &&
           fs::file_size(path, error) == output["bytes"].get<std::uint64_t>();
  });
}

void
LabelManifest::add(const std::string& input,
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
        {{"name", output}, {"bytes", fs::file_size(pathIn(directory_, output))}});
  file.update(details);
  const auto place = std::find_if(files_.begin(), files_.end(), [&](const Json& f) {
    return f["input"].get_ref<const std::string&>() >= input;
  });
  if (place != files_.end() && (*place)["input"] == input)
    *place = std::move(file);
  else
    files_.insert(place, std::move(file));
}

void
LabelManifest::addFailure(const std::string& input, const std::string& error)
{
  failures_.push_back({{"input", input}, {"error", error}});
}

std::vector<std::uint64_t>
LabelManifest::totals() const
{
  std::vector<std::uint64_t> totals(classes_.size(), 0);
  for (const Json& file : files_)
    for (std::size_t label = 0; label < classes_.size(); ++label)
      totals[label] += file["counts"][classes_[label]].get<std::uint64_t>();
  return totals;
}

void
LabelManifest::save() const
{
  Json json = head_;
  const std::vector<std::uint64_t> counts = totals();
  for (std::size_t label = 0; label < classes_.size(); ++label)
    json["counts"][classes_[label]] = counts[label];
  json["files"] = files_;
  json["failures"] = failures_;
  AtomicFile file(pathIn(directory_, file_name));
  file.write(json.dump(2, ' ', false, Json::error_handler_t::replace) + '\n');
  file.commit();
}

} // namespace pcl::app
