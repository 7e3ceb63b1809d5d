// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results in a directory: which are complete, and how those that are missing are
// computed by a team.

#include "tiling/results.h"

#include <pcl/tiling/point_source.h>

#include <algorithm>
#include <sstream>
#include <utility>

namespace pcl::tiling {
namespace {

/** Those that need a result, the largest first. */
std::vector<std::size_t>
allOf(const Tasks& tasks)
{
  std::vector<std::size_t> all;
  for (std::size_t number = 0; number < tasks.sizes.size(); ++number)
    if (tasks.sizes[number] > 0)
      all.push_back(number);
  std::stable_sort(all.begin(), all.end(), [&](auto a, auto b) {
    return tasks.sizes[a] > tasks.sizes[b];
  });
  return all;
}

} // namespace

Results::Results(const std::string& directory,
                 const Record& begin,
                 const std::set<std::string>& names,
                 Team& team)
: directory_(directory)
, team_(team)
, names_(names)
{
  if (team.isFirst()) {
    own_.emplace(directory);
    manifest_.emplace(manifestPath(directory), true);
    useRecords(manifestPath(directory), [&] { this->begin(begin); });
  }
  team.meet();
  if (!team.isFirst())
    manifest_.emplace(manifestPath(directory), false);
  readRecords();
}

void
Results::compute(const std::string& name, const Tasks& tasks, const Team::Work& task)
{
  team_.meet(); // before the first one adds files that others count as missing
  // What is missing is asked by each rank for itself, and file systems may answer
  // differently: the list of the first one counts, so that all of them run.
  const std::vector<std::size_t> missing = missingOf(name, tasks);
  if (!tasks.sizes.empty())
    makePlaceFor(name);
  std::string failure;
  run(name, missing, task, [&](std::size_t number, const std::string& error) {
    failure = name + " of " + tasks.kind + ' ' + std::to_string(number) + ": " + error;
  });
  requireAll(name, tasks, failure);
}

void
Results::computeAtOnce(const std::string& name,
                       const Tasks& tasks,
                       const std::function<void(const Write& write)>& function)
{
  team_.meet();
  std::vector<std::size_t> once;
  if (isMissing(name, tasks))
    once.push_back(0);
  makePlaceFor(name);
  std::string failure = name + " of some " + tasks.kind + "s were not written";
  const auto work = [&](std::size_t) {
    std::string written;
    function([&](std::size_t number, const Bytes& bytes) {
      written += write(name, number, bytes);
    });
    return written;
  };
  run(name, once, work, [&](std::size_t, const std::string& error) {
    failure = name + ": " + error;
  });
  if (isMissing(name, tasks))
    throw TilingError(failure);
}

template <typename Fail>
void
Results::run(const std::string& name,
             const std::vector<std::size_t>& numbers,
             const Team::Work& work,
             const Fail& fail)
{
  bool has_failed = false;
  const auto report =
      [&](std::size_t number, const std::string& written, const std::string& error) {
        if (error.empty())
          complete(name, written);
        else if (!std::exchange(has_failed, true))
          fail(number, error);
      };
  team_.run(numbers, work, report);
  refresh();
}

std::string
Results::write(const std::string& name,
               std::size_t number,
               const std::function<void(WholeFile& file)>& fill) const
{
  WholeFile file(filePath(directory_, name, number));
  fill(file);
  file.commit();
  return std::to_string(number) + ' ' + std::to_string(file.size()) + ' ' +
         toText(file.checksum()) + '\n';
}

std::string
Results::write(const std::string& name, std::size_t number, const Bytes& bytes) const
{
  return write(
      name, number, [&](WholeFile& file) { file.write(bytes.data(), bytes.size()); });
}

void
Results::makePlaceFor(const std::string& name)
{
  names_.insert(name);
  makeDirectory(directory_ + '/' + name);
}

void
Results::complete(const std::string& name, const std::string& written)
{
  std::istringstream words(written);
  Complete now;
  for (std::size_t number = 0; words >> number >> now.bytes >> now.check;) {
    const Complete* const before = find(name, number);
    if (!before || before->bytes != now.bytes || before->check != now.check)
      add({{"event", "result"},
           {"name", name},
           {"number", number},
           {"bytes", now.bytes},
           {"check", now.check}});
  }
}

bool
Results::isMissing(const std::string& name, const Tasks& tasks) const
{
  return !missingOf(name, tasks).empty();
}

void
Results::check(const std::string& name, const Tasks& tasks)
{
  std::string failure;
  const auto work = [&](std::size_t number) {
    read(name, number);
    return std::string();
  };
  run(name, allOf(tasks), work, [&](std::size_t, const std::string& error) {
    failure = error;
  });
  if (!failure.empty())
    throw TilingError(failure);
  requireAll(name, tasks, failure); // what is damaged was removed
}

Bytes
Results::read(const std::string& name, std::size_t number) const
{
  const std::string path = filePath(directory_, name, number);
  const Complete& complete = completeAt(name, number);
  Bytes bytes = readWhole(path);
  if (bytes.size() != complete.bytes ||
      toText(checksumOf(bytes.data(), bytes.size())) != complete.check)
    failDamaged(path);
  return bytes;
}

void
Results::copyTo(
    const std::string& name,
    std::size_t number,
    const std::function<void(const void* data, std::size_t size)>& sink) const
{
  const std::string path = filePath(directory_, name, number);
  const Complete& complete = completeAt(name, number);
  constexpr std::uint64_t bytes_at_a_time = 1 << 22;
  std::uint32_t checksum = 0;
  Bytes bytes;
  for (std::uint64_t at = 0; at < complete.bytes; at += bytes.size()) {
    bytes.resize(std::min(bytes_at_a_time, complete.bytes - at));
    readAt(path, at, bytes.data(), bytes.size());
    checksum = checksumOf(bytes.data(), bytes.size(), checksum);
    sink(bytes.data(), bytes.size());
  }
  if (toText(checksum) != complete.check)
    failDamaged(path);
}

void
Results::remove(const std::string& name)
{
  if (own_)
    own_->removeFilesOf(name);
}

void
Results::removeAll()
{
  team_.meet();
  if (!own_)
    return;
  for (const auto& [name, files] : complete_)
    names_.insert(name);
  for (const std::string& name : names_)
    own_->removeFilesOf(name);
  own_->remove();
}

std::optional<std::string>
Results::decision(const std::string& name) const
{
  const auto found = decisions_.find(name);
  return found == decisions_.end() ? std::nullopt : std::optional(found->second);
}

std::string
Results::decide(const std::string& name, const std::function<std::string()>& find)
{
  if (!decision(name) && team_.isFirst())
    add({{"event", "decision"}, {"name", name}, {"value", find()}});
  refresh();
  const std::optional<std::string> found = decision(name);
  if (!found)
    throw TilingError(directory_ + ": has no decision on " + name +
                      "; expected the first rank to write one");
  return *found;
}

void
Results::add(const Record& record)
{
  manifest_->add(record);
  take(record);
}

void
Results::refresh()
{
  team_.meet();
  if (team_.isFirst())
    return;
  manifest_.emplace(manifestPath(directory_), false);
  readRecords();
}

/** Writes what the results depend on, or compares it with the existing record. */
void
Results::begin(const Record& now)
{
  if (manifest_->records().empty()) {
    manifest_->add(now);
    return;
  }
  const Record& before = manifest_->records().front();
  for (const auto& [key, value] : now.items())
    if (!before.contains(key) || before.at(key) != value)
      throw TilingError(directory_ + ": was begun with other " + key + ", " +
                        before.value(key, Record()).dump() + ", now " + value.dump() +
                        "; expected the same, or another directory, or this one "
                        "removed");
}

void
Results::readRecords()
{
  useRecords(manifestPath(directory_), [&] {
    for (const Record& record : manifest_->records())
      take(record);
  });
}

void
Results::take(const Record& record)
{
  const std::string event = record.at("event");
  if (event == "decision")
    decisions_[record.at("name")] = record.at("value");
  else if (event == "result")
    complete_[record.at("name")][record.at("number")] = {record.at("bytes"),
                                                         record.at("check")};
}

const Results::Complete*
Results::find(const std::string& name, std::size_t number) const
{
  const auto of_name = complete_.find(name);
  if (of_name == complete_.end())
    return nullptr;
  const auto found = of_name->second.find(number);
  return found == of_name->second.end() ? nullptr : &found->second;
}

const Results::Complete&
Results::completeAt(const std::string& name, std::size_t number) const
{
  const Complete* const complete = find(name, number);
  if (!complete)
    throw TilingError(filePath(directory_, name, number) +
                      ": is not computed yet; expected run() before");
  return *complete;
}

/** Those whose file is missing, or not as long as it was. */
std::vector<std::size_t>
Results::missingOf(const std::string& name, const Tasks& tasks) const
{
  std::vector<std::size_t> missing = allOf(tasks);
  const auto is_complete = [&](std::size_t number) {
    const Complete* const complete = find(name, number);
    return complete && sizeOfFile(filePath(directory_, name, number)) ==
                           static_cast<std::int64_t>(complete->bytes);
  };
  missing.erase(std::remove_if(missing.begin(), missing.end(), is_complete),
                missing.end());
  return missing;
}

void
Results::requireAll(const std::string& name,
                    const Tasks& tasks,
                    const std::string& failure) const
{
  if (const std::size_t left = missingOf(name, tasks).size(); left > 0)
    throw TilingError(failure.empty()
                          ? "another rank has failed"
                          : failure + "; " + std::to_string(left) + " of " +
                                std::to_string(tasks.sizes.size()) + ' ' + tasks.kind +
                                "s are left for the next run of the "
                                "same command");
}

} // namespace pcl::tiling
