// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The one loop over many files: progress, failures, the summary of all.

#include "cli/batch.h"

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "io/any_cloud.h"
#include "io/errors.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <map>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

double
bytesOf(const std::string& file)
{
  std::error_code error;
  const auto bytes = fs::file_size(file, error);
  return error ? 0.0 : static_cast<double>(bytes);
}

} // namespace

std::vector<std::string>
cloudsIn(const std::string& directory, const std::vector<std::string>& endings)
{
  std::string names;
  for (const std::string& ending : endings)
    names += (names.empty() ? "" : " or ") + ending;
  std::error_code error;
  std::vector<std::string> clouds;
  for (const auto& entry : fs::directory_iterator(directory, error))
    if (std::count(endings.begin(), endings.end(), endingOf(entry.path())) > 0)
      clouds.push_back(entry.path().string());
  if (error)
    throw InputError(directory + ": cannot be listed: " + error.message() +
                     "; expected a directory with " + names + " files");
  if (clouds.empty())
    throw InputError(directory + ": has no " + names +
                     " file; expected a directory with at least one");
  std::sort(clouds.begin(), clouds.end());
  return clouds;
}

void
makeDirectory(const std::string& directory)
{
  std::error_code error;
  fs::create_directory(directory, error);
  if (!fs::is_directory(directory))
    throw InputError(directory + ": cannot be made a directory: " + error.message() +
                     "; expected a directory, or a new name in one");
}

void
prepareOutputDirectory(const std::string& output, const std::string& input)
{
  std::error_code error;
  if (fs::equivalent(input, output, error))
    throw UsageError("-output_dir '" + output +
                     "' is the input directory; expected another one");
  makeDirectory(output);
}

void
requireDifferent(const std::vector<std::string>& inputs,
                 const std::vector<std::string>& outputs)
{
  std::map<std::string, std::string> input_of;
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    const auto [other, is_new] = input_of.emplace(outputs[i], inputs[i]);
    if (!is_new)
      throw InputError(other->second + " and " + inputs[i] +
                       " would have the same output; expected different names before "
                       "the ending");
  }
}

int
runBatch(const Arguments& arguments,
         const std::vector<std::string>& inputs,
         const FileJob& job,
         const std::function<void()>& finish)
{
  using Clock = std::chrono::steady_clock;
  const std::string prefix = arguments.app() + ": ";
  const std::string of_all = " of " + std::to_string(inputs.size());
  double bytes_left = 0.0, bytes_processed = 0.0, seconds = 0.0;
  for (const std::string& input : inputs)
    bytes_left += bytesOf(input);
  std::vector<Report> reports;
  std::vector<Failure> failures;
  std::size_t begun = 0, done_before = 0;
  for (const std::string& input : inputs) {
    std::string line = prefix + std::to_string(++begun) + of_all + ": " + input;
    if (bytes_processed > 0.0)
      line += ", about " +
              std::to_string(
                  std::llround(std::ceil(seconds / bytes_processed * bytes_left))) +
              " s left";
    logLine(line);
    const auto start = Clock::now();
    const double bytes = bytesOf(input);
    bytes_left = std::max(0.0, bytes_left - bytes);
    try {
      Report report;
      if (!job(input, report)) {
        ++done_before;
        continue; // took no time to speak of
      }
      printSummary(input, report);
      reports.push_back(std::move(report));
    }
    catch (const UsageError&) {
      throw;
    }
    catch (const std::exception& error) {
      failures.push_back({input, error.what()});
      logLine(prefix + error.what());
    }
    bytes_processed += bytes;
    seconds += std::chrono::duration<double>(Clock::now() - start).count();
  }
  finish();
  writeJson(arguments, toJson(arguments.app(), reports, failures));
  std::string line =
      prefix + std::to_string(failures.size()) + of_all + " files failed";
  if (done_before > 0)
    line += ", " + std::to_string(done_before) + " were done before";
  logLine(line);
  return failures.empty() ? 0 : 1;
}

} // namespace pcl::app
