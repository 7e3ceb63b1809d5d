// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results in a directory: which are complete, and how those that are missing are
// computed by a team.

#include "tiling/results.h"

#include <pcl/tiling/point_source.h>

#include <algorithm>
#include <sstream>

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

/** Use a record, which may be in the form of another version. */
template <typename Use>
void
useRecord(const std::string& directory, const Use& use)
{
  try {
    use();
  }
  catch (const Manifest::Record::exception& error) {
    throw TilingError(manifestPath(directory) + ": has an unknown record (" +
                      error.what() + "); expected a manifest of this version");
  }
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
    this->begin(begin);
  }
  team.meet();
  if (!team.isFirst())
    manifest_.emplace(manifestPath(directory), false);
  readRecords();
}

void
Results::compute(const std::string& name, const Tasks& tasks, const Task& task)
{
  team_.meet(); // before the first one adds files that others count as missing
  // What is missing is asked by each rank for itself, and file systems may answer
  // differently: the list of the first one counts, so that all of them run.
  const std::vector<std::size_t> missing = missingOf(name, tasks);
  if (!tasks.sizes.empty())
    makePlaceFor(name);
  std::string failure;
  team_.run(
      missing,
      task,
      [&](std::size_t number, const std::string& written, const std::string& error) {
        if (error.empty())
          complete(name, number, written);
        else if (failure.empty())
          failure =
              name + " of " + tasks.kind + ' ' + std::to_string(number) + ": " + error;
      });
  refresh();
  requireAll(name, tasks, failure);
}

void
Results::computeAtOnce(const std::string& name,
                       const Tasks& tasks,
                       const std::function<void(const Write& write)>& function)
{
  team_.meet();
  const bool is_missing = isMissing(name, tasks);
  makePlaceFor(name);
  std::string failure;
  const auto work = [&](std::size_t) {
    std::string all; // a line for each file
    function([&](std::size_t number, const Bytes& bytes) {
      all += std::to_string(number) + ' ' + write(name, number, bytes) + '\n';
    });
    return all;
  };
  team_.run(is_missing ? std::vector<std::size_t>{0} : std::vector<std::size_t>{},
            work,
            [&](std::size_t, const std::string& all, const std::string& error) {
              failure = error;
              std::istringstream lines(error.empty() ? all : std::string());
              std::size_t number = 0;
              for (std::string written;
                   lines >> number && std::getline(lines, written);)
                complete(name, number, written);
            });
  refresh();
  if (isMissing(name, tasks))
    throw TilingError(failure.empty()
                          ? name + " of some " + tasks.kind + "s were not written"
                          : name + ": " + failure);
}

std::string
Results::write(const std::string& name,
               std::size_t number,
               const std::function<void(WholeFile& file)>& fill) const
{
  WholeFile file(filePath(directory_, name, number));
  fill(file);
  file.commit();
  return std::to_string(file.size()) + ' ' + toText(file.checksum());
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
Results::complete(const std::string& name,
                  std::size_t number,
                  const std::string& written)
{
  Complete now;
  std::istringstream(written) >> now.bytes >> now.check;
  const Complete* const before = find(name, number);
  if (!before || before->bytes != now.bytes || before->check != now.check)
    add({{"event", "result"},
         {"name", name},
         {"number", number},
         {"bytes", now.bytes},
         {"check", now.check}});
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
  team_.run(
      allOf(tasks),
      [&](std::size_t number) {
        read(name, number);
        return std::string();
      },
      [&](std::size_t, const std::string&, const std::string& error) {
        failure = failure.empty() ? error : failure;
      });
  team_.meet();
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
    checksum = checksumOf(checksum, bytes.data(), bytes.size());
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

std::string
Results::decide(const std::string& name, const std::function<std::string()>& find)
{
  if (!decisions_.count(name) && team_.isFirst())
    add({{"event", "decision"}, {"name", name}, {"value", find()}});
  refresh();
  const auto found = decisions_.find(name);
  if (found == decisions_.end())
    throw TilingError(directory_ + ": has no decision on " + name +
                      "; expected the first rank to write one");
  return found->second;
}

void
Results::add(const Record& record)
{
  manifest_->add(record);
  take(record);
}

void
Results::readLast(const std::string& event,
                  const std::function<void(const Record& record)>& use) const
{
  const std::vector<Record>& records = manifest_->records();
  useRecord(directory_, [&] {
    const auto last =
        std::find_if(records.rbegin(), records.rend(), [&](const Record& record) {
          return record.at("event") == event;
        });
    if (last != records.rend())
      use(*last);
  });
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
  useRecord(directory_, [&] {
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
