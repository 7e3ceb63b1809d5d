// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Divides sources into tiles, and keeps results of tiles; the manifest says what is
// complete.

#include "tiling/checked_file.h"
#include "tiling/manifest.h"
#include "tiling/plan.h"
#include "tiling/section_file.h"
#include "tiling/tile_file.h"

#include <pcl/tiling/tiled_cloud.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <limits>
#include <map>
#include <numeric>
#include <optional>
#include <regex>
#include <set>
#include <sstream>
#include <unistd.h>

#include <sys/file.h>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace pcl::tiling {
namespace {

using Record = Manifest::Record;

constexpr int format_version = 2;
const std::string tiles_name = "tiles";
// Of sections: their counts, their points by tile, and which rows of tiles these are.
const std::string survey_name = "survey", sections_name = "sections",
                  rows_name = "rows";
const std::string manifest_name = "manifest.jsonl", lock_name = "lock";

/** Holds a file so that no other run does; it is released with the process. */
class Lock {
public:
  explicit Lock(const std::string& directory)
  {
    const std::string path = directory + '/' + lock_name;
    // The processes of a run that was killed a moment ago may take that long to end.
    constexpr int attempts = 20;
    constexpr useconds_t pause = 100000; // microseconds
    for (int attempt = 0;; ++attempt) {
      open(path);
      if (::flock(descriptor_, LOCK_EX | LOCK_NB) == 0) {
        if (isStillAt(path))
          return;
      }
      else if (errno != EWOULDBLOCK) {
        const int error = errno;
        ::close(descriptor_);
        throw TilingError(directory + ": cannot be locked: " + std::strerror(error));
      }
      ::close(descriptor_);
      if (attempt == attempts)
        throw TilingError(directory +
                          ": another run is using it; expected to be alone");
      ::usleep(pause);
    }
  }
  ~Lock() { ::close(descriptor_); }
  Lock(const Lock&) = delete;
  Lock& operator=(const Lock&) = delete;

private:
  void
  open(const std::string& path)
  {
    constexpr mode_t by_umask = 0666;
    descriptor_ = ::open(path.c_str(), O_RDWR | O_CREAT | O_CLOEXEC, by_umask);
    if (descriptor_ < 0)
      throw TilingError(path + ": cannot be written: " + std::strerror(errno));
  }

  /** A run that ended after the file was opened has removed it: then the lock is one of
   * a file that nobody else finds. */
  bool
  isStillAt(const std::string& path) const
  {
    struct stat locked {
    }, there{};
    return ::fstat(descriptor_, &locked) == 0 && ::stat(path.c_str(), &there) == 0 &&
           locked.st_ino == there.st_ino && locked.st_dev == there.st_dev;
  }

  int descriptor_ = -1;
};

void
makeDirectory(const std::string& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw TilingError(path + ": cannot be made: " + error.message());
}

std::vector<fs::path>
entriesOf(const std::string& directory)
{
  std::error_code error;
  std::vector<fs::path> entries;
  for (fs::directory_iterator entry(directory, error), end; !error && entry != end;
       entry.increment(error))
    entries.push_back(entry->path());
  if (error)
    throw TilingError(directory + ": cannot be read: " + error.message());
  return entries;
}

bool
isThere(const std::string& path)
{
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/** A directory with other files is that of somebody else: nothing there may be removed.
 */
void
requireOwn(const std::string& directory)
{
  const std::vector<fs::path> entries = entriesOf(directory);
  if (!isThere(directory + '/' + manifest_name) &&
      std::any_of(entries.begin(), entries.end(), [](const fs::path& entry) {
        return entry.filename() != lock_name;
      }))
    throw TilingError(directory +
                      ": holds other files; expected a new or empty directory");
}

void
removeFile(const fs::path& path)
{
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw TilingError(path.string() + ": cannot be removed: " + error.message());
}

enum class FileOfTile { none, complete, unfinished };

/** By its name: 000012.bin, or 000012.bin.345.tmp while process 345 writes it. */
FileOfTile
kindOf(const fs::path& path)
{
  static const std::regex names("[0-9]{6,}\\.bin(\\.[0-9]+\\.tmp)?");
  std::smatch parts;
  const std::string name = path.filename().string();
  if (!std::regex_match(name, parts, names))
    return FileOfTile::none;
  return parts[1].matched ? FileOfTile::unfinished : FileOfTile::complete;
}

/** A file that is complete. */
struct Complete {
  std::uint64_t bytes = 0;
  std::string check;
};

/** \return what completeOf() reads */
std::string
completeText(std::uint64_t bytes, std::uint32_t checksum)
{
  return std::to_string(bytes) + ' ' + toText(checksum);
}

Complete
completeOf(const std::string& text)
{
  Complete complete;
  std::istringstream(text) >> complete.bytes >> complete.check;
  return complete;
}

/** What has a result: tiles, or sections. */
struct Tasks {
  std::string kind;                 ///< for messages
  std::vector<std::uint64_t> sizes; ///< 0 for what needs no result
};

} // namespace

class TiledCloud::State {
public:
  State(const std::string& directory,
        const Sources& sources,
        const TileSettings& settings,
        Team& team)
  : directory_(directory)
  , sources_(sources)
  , settings_(settings)
  , team_(team)
  {
    if (sources.empty())
      throw TilingError("no sources are given; expected at least one");
    if (settings.max_points == 0)
      throw TilingError("0 points for a tile; expected at least one");
    for (std::size_t source = 0; source < sources.size(); ++source)
      for (std::size_t k = 0; k < sources[source]->countSections(); ++k)
        sections_.push_back({source, k});
    if (team.isFirst()) {
      makeDirectory(directory);
      requireOwn(directory);
      lock_.emplace(directory);
      removeUnfinished();
      manifest_.emplace(directory + '/' + manifest_name, true);
      begin();
    }
    team.meet();
    if (!team.isFirst())
      manifest_.emplace(directory + '/' + manifest_name, false);
    readRecords();
  }

  void
  partition()
  {
    if (!plan_)
      survey();
    removeResult(survey_name); // also that of a run which was killed after it
    const bool is_needed = !missingOf(tiles_name, tiles()).empty() ||
                           !missingOf(rows_name, sections()).empty();
    sortSections(is_needed);
    compute(tiles_name, tiles(), [&](std::size_t tile) {
      return written(tiles_name, tile, encodeTile(pointsOfSections(tile)));
    });
    removeResult(sections_name);
  }

  const std::vector<Section>&
  sectionList() const
  {
    return sections_;
  }

  const Plan&
  plan() const
  {
    if (!plan_)
      throw TilingError(directory_ + ": the cloud is not divided yet; expected "
                                     "partition() before");
    return *plan_;
  }

  const Position&
  offset() const
  {
    return plan_ ? plan_->offset : offset_;
  }

  void
  setOffset(const Position& offset)
  {
    offset_ = offset;
  }

  TilePoints
  load(std::size_t tile, double halo)
  {
    TilePoints points{fileOf(tile).points(), 0};
    points.own = points.points.size();
    const Box around = boxAround(tile, halo);
    for (const std::size_t other : tilesAround(tile, halo))
      fileOf(other).addPointsIn(around, points.points);
    return points;
  }

  std::vector<std::size_t>
  tilesAround(std::size_t tile, double halo)
  {
    const Box around = boxAround(tile, halo);
    std::vector<std::size_t> tiles;
    for (std::size_t other = 0; other < plan().points.size(); ++other)
      if (other != tile && plan().points[other] > 0 &&
          around.meets(fileOf(other).box()))
        tiles.push_back(other);
    return tiles;
  }

  void
  run(const std::string& name, double halo, const Function& function)
  {
    requireFree(name);
    compute(name, tiles(), [&](std::size_t tile) {
      return written(name, tile, function(tile, load(tile, halo)));
    });
  }

  void
  runOnResults(const std::string& name, const ResultFunction& function)
  {
    requireFree(name);
    compute(name, tiles(), [&](std::size_t tile) {
      return written(name, tile, function(tile));
    });
  }

  void
  runOnSections(const std::string& name, const SectionFunction& function)
  {
    requireFree(name);
    compute(name, sections(), [&](std::size_t section) {
      WholeFile file(pathOf(name, section));
      function(section,
               [&](const void* data, std::size_t size) { file.write(data, size); });
      file.commit();
      return completeText(file.size(), file.checksum());
    });
  }

  std::vector<Rows>
  rowsOf(std::size_t section) const
  {
    const Bytes bytes = resultOf(rows_name, section);
    std::vector<Rows> rows(bytes.size() / sizeof(Rows));
    if (!rows.empty())
      std::memcpy(rows.data(), bytes.data(), bytes.size());
    return rows;
  }

  void
  check(const std::string& name)
  {
    std::string failure;
    team_.run(
        allOf(tiles()),
        [&](std::size_t tile) {
          resultOf(name, tile);
          return std::string();
        },
        [&](std::size_t, const std::string&, const std::string& error) {
          failure = failure.empty() ? error : failure;
        });
    team_.meet();
    if (!failure.empty())
      throw TilingError(failure);
    requireAll(name, tiles(), failure); // what is damaged was removed
  }

  void
  copyTo(const std::string& name, std::size_t number, const Sink& sink) const
  {
    const std::string path = pathOf(name, number);
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
  removeFreeResult(const std::string& name)
  {
    requireFree(name);
    removeResult(name);
  }

  void
  removeResult(const std::string& name)
  {
    if (!team_.isFirst())
      return;
    const std::string directory = directory_ + '/' + name;
    if (!isThere(directory))
      return;
    for (const fs::path& file : entriesOf(directory))
      if (kindOf(file) != FileOfTile::none)
        removeFile(file);
    removeFile(directory);
  }

  void
  runAtOnce(const std::string& name,
            const std::function<void(const Write& write)>& function)
  {
    requireFree(name);
    team_.meet();
    const bool is_missing = !missingOf(name, tiles()).empty();
    makePlaceFor(name);
    std::string failure;
    const auto work = [&](std::size_t) {
      std::string results; // a line for each tile
      function([&](std::size_t tile, const Bytes& bytes) {
        results += std::to_string(tile) + ' ' + written(name, tile, bytes) + '\n';
      });
      return results;
    };
    team_.run(is_missing ? std::vector<std::size_t>{0} : std::vector<std::size_t>{},
              work,
              [&](std::size_t, const std::string& results, const std::string& error) {
                failure = error;
                std::istringstream lines(error.empty() ? results : std::string());
                std::size_t tile = 0;
                for (std::string result; lines >> tile && std::getline(lines, result);)
                  complete(name, tile, completeOf(result));
              });
    refresh();
    if (!missingOf(name, tiles()).empty())
      throw TilingError(failure.empty() ? name + " of some tiles were not written"
                                        : name + ": " + failure);
  }

  std::string
  pathOf(const std::string& name, std::size_t number) const
  {
    char file[32];
    std::snprintf(file, sizeof file, "/%06zu.bin", number);
    return directory_ + '/' + name + file;
  }

  Bytes
  resultOf(const std::string& name, std::size_t number) const
  {
    const std::string path = pathOf(name, number);
    const Complete& complete = completeAt(name, number);
    Bytes bytes = readWhole(path);
    if (bytes.size() != complete.bytes ||
        toText(checksumOf(bytes.data(), bytes.size())) != complete.check)
      failDamaged(path);
    return bytes;
  }

  std::string
  decide(const std::string& name, const std::function<std::string()>& find)
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

  /** What this class has made; the manifest is the last to go, so that a directory is
   * known until it is empty. */
  void
  remove()
  {
    team_.meet();
    if (!team_.isFirst())
      return;
    for (const auto& [name, results] : complete_)
      names_.insert(name);
    for (const std::string& name : names_)
      removeResult(name);
    removeFile(directory_ + '/' + manifest_name);
    removeFile(directory_ + '/' + lock_name);
    lock_.reset(); // NFS keeps a removed file in its directory until it is closed
    removeFile(directory_);
  }

private:
  void
  add(const Record& record)
  {
    manifest_->add(record);
    read(record);
  }

  /** The ranks that do not write the manifest read it again. */
  void
  refresh()
  {
    team_.meet();
    if (team_.isFirst())
      return;
    manifest_.emplace(directory_ + '/' + manifest_name, false);
    readRecords();
  }

  void
  readRecords()
  {
    try {
      for (const Record& record : manifest_->records())
        read(record);
    }
    catch (const Record::exception& error) {
      throw TilingError(directory_ + '/' + manifest_name + ": has an unknown record (" +
                        error.what() + "); expected a manifest of this version");
    }
  }

  void
  read(const Record& record)
  {
    const std::string event = record.at("event");
    if (event == "plan")
      plan_ = planOf(record);
    else if (event == "decision")
      decisions_[record.at("name")] = record.at("value");
    else if (event == "result")
      complete_[record.at("name")][record.at("number")] = {record.at("bytes"),
                                                           record.at("check")};
  }

  /** Writes what results depend on, or compares it with what is there. */
  void
  begin()
  {
    Record sources = Record::array();
    for (const auto& source : sources_)
      sources.push_back({{"name", source->name()},
                         {"state", source->state()},
                         {"sections", source->countSections()}});
    const Record now{{"event", "begin"},
                     {"version", format_version},
                     {"parameters", settings_.parameters},
                     {"max_points", settings_.max_points},
                     {"max_edge", settings_.max_edge},
                     {"sources", sources}};
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

  /** Files that a killed run has not renamed. */
  void
  removeUnfinished() const
  {
    for (const fs::path& entry : entriesOf(directory_)) {
      std::error_code error;
      if (!fs::is_directory(fs::symlink_status(entry, error)))
        continue;
      for (const fs::path& file : entriesOf(entry.string()))
        if (kindOf(file) == FileOfTile::unfinished)
          removeFile(file);
    }
  }

  /** The sections are counted, and then divided. */
  void
  survey()
  {
    compute(survey_name, sections(), [&](std::size_t section) {
      Survey survey = Survey::ofSection();
      readSection(section, [&](const Position& point) { survey.add(point, offset_); });
      return written(survey_name, section, survey.toBytes());
    });
    if (team_.isFirst()) {
      Survey all;
      for (std::size_t section = 0; section < sections_.size(); ++section)
        all.add(resultOf(survey_name, section));
      add(toJson(planOf(all, offset_, settings_.max_points, settings_.max_edge)));
    }
    refresh();
  }

  /** use(point) for each point of a section. */
  template <typename Use>
  void
  readSection(std::size_t section, const Use& use) const
  {
    const auto& [source, number] = sections_[section];
    sources_[source]->readSection(number,
                                  [&](const Position* points, std::size_t count) {
                                    std::for_each(points, points + count, use);
                                  });
  }

  /** The points of each section by tile, and which rows of the tiles they are. */
  void
  sortSections(bool is_needed)
  {
    compute(sections_name,
            is_needed ? sections() : Tasks{sections().kind, {}},
            [&](std::size_t section) {
              WholeFile file(pathOf(sections_name, section));
              SectionWriter writer(file, plan().points.size());
              readSection(section, [&](const Position& point) {
                const std::array<float, 3> floats = floatsOf(point, offset());
                if (isFinite(floats))
                  writer.add(point, plan().tree.tileOf(floats.data()));
              });
              writer.finish();
              file.commit();
              return completeText(file.size(), file.checksum());
            });
    if (is_needed && team_.isFirst())
      countRows();
    refresh();
  }

  void
  countRows()
  {
    makePlaceFor(rows_name);
    std::vector<std::uint64_t> next(plan().points.size());
    for (std::size_t section = 0; section < sections_.size(); ++section) {
      const std::vector<std::uint64_t> counts = sectionFile(section).counts();
      Bytes bytes;
      for (std::size_t tile = 0; tile < counts.size(); ++tile)
        if (counts[tile] > 0) {
          put(Rows{tile, next[tile], counts[tile]}, bytes);
          next[tile] += counts[tile];
        }
      complete(rows_name, section, completeOf(written(rows_name, section, bytes)));
    }
    if (next != plan().points)
      throw TilingError(directory_ + ": the sources have other points than before; "
                                     "expected sources that do not change");
  }

  SectionFile
  sectionFile(std::size_t section) const
  {
    return {pathOf(sections_name, section), plan().points.size()};
  }

  std::vector<Position>
  pointsOfSections(std::size_t tile) const
  {
    std::vector<Position> points;
    points.reserve(plan().points[tile]);
    for (std::size_t section = 0; section < sections_.size(); ++section)
      sectionFile(section).addPointsOf(tile, points);
    if (points.size() != plan().points[tile])
      throw TilingError(directory_ + ": tile " + std::to_string(tile) + " has " +
                        std::to_string(points.size()) + " points in " + sections_name +
                        "; expected " + std::to_string(plan().points[tile]));
    return points;
  }

  Tasks
  tiles() const
  {
    return {"tile", plan().points};
  }

  Tasks
  sections() const
  {
    return {"section", std::vector<std::uint64_t>(sections_.size(), 1)};
  }

  const Complete&
  completeAt(const std::string& name, std::size_t number) const
  {
    const auto of_name = complete_.find(name);
    if (of_name != complete_.end())
      if (const auto found = of_name->second.find(number);
          found != of_name->second.end())
        return found->second;
    throw TilingError(pathOf(name, number) +
                      ": is not computed yet; expected run() before");
  }

  bool
  isComplete(const std::string& name, std::size_t number) const
  {
    const auto of_name = complete_.find(name);
    if (of_name == complete_.end())
      return false;
    const auto found = of_name->second.find(number);
    return found != of_name->second.end() &&
           sizeOfFile(pathOf(name, number)) ==
               static_cast<std::int64_t>(found->second.bytes);
  }

  /** Those that need a result, the largest first. */
  static std::vector<std::size_t>
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

  /** Those of them that are not complete. */
  std::vector<std::size_t>
  missingOf(const std::string& name, const Tasks& tasks) const
  {
    std::vector<std::size_t> missing = allOf(tasks);
    const auto end =
        std::remove_if(missing.begin(), missing.end(), [&](std::size_t number) {
          return isComplete(name, number);
        });
    missing.erase(end, missing.end());
    return missing;
  }

  static void
  requireFree(const std::string& name)
  {
    for (const std::string& own : {tiles_name, survey_name, sections_name, rows_name})
      if (name == own)
        throw TilingError("a result is called '" + name +
                          "', as files of the partition are; expected another name");
  }

  void
  makePlaceFor(const std::string& name)
  {
    names_.insert(name);
    makeDirectory(directory_ + '/' + name);
  }

  /** \return bytes and checksum */
  std::string
  written(const std::string& name, std::size_t number, const Bytes& bytes) const
  {
    writeWhole(pathOf(name, number), bytes);
    return completeText(bytes.size(), checksumOf(bytes.data(), bytes.size()));
  }

  /** Compute the files of a name that are missing. \param[in] function writes the file
   * of a task, and returns bytes and checksum */
  void
  compute(const std::string& name,
          const Tasks& tasks,
          const std::function<std::string(std::size_t)>& function)
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
        function,
        [&](std::size_t number, const std::string& result, const std::string& error) {
          if (error.empty())
            complete(name, number, completeOf(result));
          else if (failure.empty())
            failure = name + " of " + tasks.kind + ' ' + std::to_string(number) + ": " +
                      error;
        });
    refresh();
    requireAll(name, tasks, failure);
  }

  void
  requireAll(const std::string& name,
             const Tasks& tasks,
             const std::string& failure) const
  {
    if (const std::size_t left = missingOf(name, tasks).size(); left > 0)
      throw TilingError(
          failure.empty() ? "another rank has failed"
                          : failure + "; " + std::to_string(left) + " of " +
                                std::to_string(tasks.sizes.size()) + ' ' + tasks.kind +
                                "s are left for the next run of the "
                                "same command");
  }

  /** Records what the manifest does not have yet: it may have been made anew. */
  void
  complete(const std::string& name, std::size_t number, const Complete& now)
  {
    const Complete& before = complete_[name][number];
    if (before.bytes == now.bytes && before.check == now.check)
      return;
    add({{"event", "result"},
         {"name", name},
         {"number", number},
         {"bytes", now.bytes},
         {"check", now.check}});
  }

  /** Neighbors are found in float: by how much two coordinates there may be nearer than
   * in double. Without a halo there are no neighbors. */
  double
  roundingOf(const Box& box, double halo) const
  {
    if (halo <= 0.0)
      return 0.0;
    double largest = 0.0;
    for (std::size_t axis = 0; axis < 3; ++axis)
      largest = std::max({largest,
                          std::abs(box.low[axis] - offset()[axis]),
                          std::abs(box.high[axis] - offset()[axis])});
    // Each of the two coordinates by half an epsilon, and their difference.
    constexpr double share = 2.0 * std::numeric_limits<float>::epsilon();
    return share * (largest + halo);
  }

  Box
  boxAround(std::size_t tile, double halo)
  {
    const Box own = fileOf(tile).box();
    return own.grown(halo + roundingOf(own, halo));
  }

  const TileFile&
  fileOf(std::size_t tile)
  {
    files_.resize(plan().points.size());
    if (!files_[tile])
      files_[tile] = std::make_unique<TileFile>(pathOf(tiles_name, tile));
    return *files_[tile];
  }

  std::string directory_;
  Sources sources_;
  std::vector<Section> sections_;
  TileSettings settings_;
  Team& team_;
  std::optional<Lock> lock_;
  std::optional<Manifest> manifest_;
  Position offset_{};
  std::optional<Plan> plan_;
  std::map<std::string, std::map<std::size_t, Complete>> complete_;
  std::set<std::string> names_{
      tiles_name, survey_name, sections_name, rows_name}; ///< of directories
  std::map<std::string, std::string> decisions_;
  std::vector<std::unique_ptr<TileFile>> files_;
};

TiledCloud::TiledCloud(const std::string& directory,
                       const Sources& sources,
                       const TileSettings& settings,
                       Team& team)
: state_(std::make_unique<State>(directory, sources, settings, team))
{}

TiledCloud::~TiledCloud() = default;

void
TiledCloud::partition()
{
  state_->partition();
}

std::size_t
TiledCloud::size() const
{
  return state_->plan().points.size();
}

std::uint64_t
TiledCloud::countNotFinite() const
{
  return state_->plan().not_finite;
}

std::uint64_t
TiledCloud::countFinite() const
{
  return state_->plan().finite;
}

std::uint64_t
TiledCloud::pointsOf(std::size_t tile) const
{
  return state_->plan().points.at(tile);
}

const Position&
TiledCloud::offset() const
{
  return state_->offset();
}

void
TiledCloud::setOffset(const Position& offset)
{
  state_->setOffset(offset);
}

double
TiledCloud::typicalDistance() const
{
  return state_->plan().typical_distance;
}

std::size_t
TiledCloud::tileOf(const Position& point) const
{
  return state_->plan().tree.tileOf(floatsOf(point, state_->offset()).data());
}

bool
TiledCloud::holds(const Position& point) const
{
  return isFinite(floatsOf(point, state_->offset()));
}

TilePoints
TiledCloud::load(std::size_t tile, double halo) const
{
  return state_->load(tile, halo);
}

std::vector<std::size_t>
TiledCloud::tilesAround(std::size_t tile, double halo) const
{
  return state_->tilesAround(tile, halo);
}

void
TiledCloud::run(const std::string& name, double halo, const Function& function)
{
  state_->run(name, halo, function);
}

void
TiledCloud::runOnResults(const std::string& name, const ResultFunction& function)
{
  state_->runOnResults(name, function);
}

void
TiledCloud::runAtOnce(const std::string& name,
                      const std::function<void(const Write& write)>& function)
{
  state_->runAtOnce(name, function);
}

const std::vector<TiledCloud::Section>&
TiledCloud::sections() const
{
  return state_->sectionList();
}

std::vector<TiledCloud::Rows>
TiledCloud::rowsOf(std::size_t section) const
{
  return state_->rowsOf(section);
}

void
TiledCloud::runOnSections(const std::string& name, const SectionFunction& function)
{
  state_->runOnSections(name, function);
}

void
TiledCloud::check(const std::string& name)
{
  state_->check(name);
}

void
TiledCloud::copyTo(const std::string& name, std::size_t number, const Sink& sink) const
{
  state_->copyTo(name, number, sink);
}

void
TiledCloud::removeResult(const std::string& name)
{
  state_->removeFreeResult(name);
}

std::vector<std::uint8_t>
TiledCloud::resultOf(const std::string& name, std::size_t tile) const
{
  return state_->resultOf(name, tile);
}

std::string
TiledCloud::pathOf(const std::string& name, std::size_t tile) const
{
  return state_->pathOf(name, tile);
}

std::string
TiledCloud::decide(const std::string& name, const std::function<std::string()>& find)
{
  return state_->decide(name, find);
}

void
TiledCloud::remove()
{
  state_->remove();
}

} // namespace pcl::tiling
