// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Divides sources into tiles, and keeps results of tiles; the manifest says what is
// complete.

#include "tiling/checked_file.h"
#include "tiling/manifest.h"
#include "tiling/tile_file.h"
#include "tiling/tile_tree.h"

#include <pcl/tiling/tiled_cloud.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
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

constexpr int format_version = 1;
// Of points on their way to tiles; what is more goes to disk.
constexpr std::size_t buffered_bytes = std::size_t{128} << 20;
const std::string tiles_name = "tiles", buckets_name = "buckets";
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

std::array<float, 3>
floatsOf(const Position& point, const Position& offset)
{
  std::array<float, 3> floats;
  for (std::size_t axis = 0; axis < 3; ++axis)
    floats[axis] = static_cast<float>(point[axis] - offset[axis]);
  return floats;
}

/** What is finite in double may be too large for float. */
bool
isFinite(const std::array<float, 3>& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
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

/** How the sources are divided. */
struct Plan {
  Position offset{};
  TileTree tree;
  std::vector<std::uint64_t> points; ///< of each tile
  std::uint64_t finite = 0, not_finite = 0;
  double typical_distance = 0.0;
};

Record
toJson(const Plan& plan)
{
  Record nodes = Record::array();
  for (const TileTree::Node& node : plan.tree.nodes())
    nodes.push_back({node.axis, node.cut, node.first, node.second});
  return {{"event", "plan"},
          {"offset", plan.offset},
          {"cell", plan.tree.grid().exponent},
          {"nodes", nodes},
          {"points", plan.points},
          {"finite", plan.finite},
          {"not_finite", plan.not_finite},
          {"typical_distance", plan.typical_distance}};
}

Plan
planOf(const Record& record)
{
  std::vector<TileTree::Node> nodes;
  for (const Record& node : record.at("nodes"))
    nodes.push_back({node.at(0), node.at(1), node.at(2), node.at(3)});
  return {record.at("offset"),
          TileTree(CellGrid{record.at("cell")}, std::move(nodes)),
          record.at("points"),
          record.at("finite"),
          record.at("not_finite"),
          record.at("typical_distance")};
}

/** A file that is complete. */
struct Complete {
  std::uint64_t bytes = 0;
  std::string check;
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
    if (!plan_ && team_.isFirst())
      add(toJson(survey()));
    refresh();
    makeTiles();
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
    compute(name, [&](std::size_t tile) { return function(tile, load(tile, halo)); });
  }

  void
  runOnResults(const std::string& name, const ResultFunction& function)
  {
    compute(name, function);
  }

  void
  runAtOnce(const std::string& name,
            const std::function<void(const Write& write)>& function)
  {
    team_.meet();
    const bool is_missing = !missingOf(name).empty();
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
                  if (const Complete now = completeOf(result);
                      !isRecorded(name, tile, now))
                    complete(name, tile, now);
              });
    refresh();
    if (!missingOf(name).empty())
      throw TilingError(failure.empty() ? name + " of some tiles were not written"
                                        : name + ": " + failure);
  }

  std::string
  pathOf(const std::string& name, std::size_t tile) const
  {
    char file[32];
    std::snprintf(file, sizeof file, "/%06zu.bin", tile);
    return directory_ + '/' + name + file;
  }

  Bytes
  resultOf(const std::string& name, std::size_t tile) const
  {
    const std::string path = pathOf(name, tile);
    const auto of_name = complete_.find(name);
    const auto found = of_name == complete_.end()
                           ? decltype(of_name->second.find(tile)){}
                           : of_name->second.find(tile);
    if (of_name == complete_.end() || found == of_name->second.end())
      throw TilingError(path + ": is not computed yet; expected run() before");
    Bytes bytes = readWhole(path);
    if (bytes.size() != found->second.bytes ||
        toText(checksumOf(bytes.data(), bytes.size())) != found->second.check) {
      std::error_code error;
      fs::remove(path, error);
      throw TilingError(path + ": was damaged, and is removed; run the same command "
                               "again to make it anew");
    }
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
    for (const std::string& name : names_) {
      const std::string directory = directory_ + '/' + name;
      if (!isThere(directory))
        continue;
      for (const fs::path& file : entriesOf(directory))
        if (kindOf(file) != FileOfTile::none)
          removeFile(file);
      removeFile(directory);
    }
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
      complete_[record.at("name")][record.at("tile")] = {record.at("bytes"),
                                                         record.at("check")};
  }

  /** Writes what results depend on, or compares it with what is there. */
  void
  begin()
  {
    Record sources = Record::array();
    for (const auto& source : sources_)
      sources.push_back({{"name", source->name()}, {"state", source->state()}});
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

  Plan
  survey() const
  {
    DensityCells cells;
    std::uint64_t finite = 0, not_finite = 0;
    for (const auto& source : sources_)
      source->read([&](const Position* points, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
          const std::array<float, 3> floats = floatsOf(points[i], offset_);
          const bool is_finite = isFinite(floats);
          ++(is_finite ? finite : not_finite);
          if (is_finite)
            cells.add(floats.data());
        }
      });
    if (finite == 0)
      throw TilingError("none of " + std::to_string(not_finite) +
                        " points is finite; expected at least one");
    Plan plan{offset_,
              TileTree(cells, settings_.max_points, settings_.max_edge),
              {},
              finite,
              not_finite,
              cells.typicalDistance()};
    plan.points.resize(plan.tree.size());
    for (const auto& [key, count] : cells.counts().sorted())
      plan.points[plan.tree.tileOf(key)] += count;
    return plan;
  }

  bool
  isComplete(const std::string& name, std::size_t tile) const
  {
    const auto of_name = complete_.find(name);
    if (of_name == complete_.end())
      return false;
    const auto found = of_name->second.find(tile);
    return found != of_name->second.end() &&
           sizeOfFile(pathOf(name, tile)) ==
               static_cast<std::int64_t>(found->second.bytes);
  }

  /** Those that are not complete, the largest first. */
  std::vector<std::size_t>
  missingOf(const std::string& name) const
  {
    std::vector<std::size_t> missing;
    for (std::size_t tile = 0; tile < plan().points.size(); ++tile)
      if (plan().points[tile] > 0 && !isComplete(name, tile))
        missing.push_back(tile);
    std::stable_sort(missing.begin(), missing.end(), [&](auto a, auto b) {
      return plan().points[a] > plan().points[b];
    });
    return missing;
  }

  void
  makePlaceFor(const std::string& name)
  {
    names_.insert(name);
    makeDirectory(directory_ + '/' + name);
  }

  /** \return bytes and checksum */
  std::string
  written(const std::string& name, std::size_t tile, const Bytes& bytes) const
  {
    writeWhole(pathOf(name, tile), bytes);
    return std::to_string(bytes.size()) + ' ' +
           toText(checksumOf(bytes.data(), bytes.size()));
  }

  /** Compute the files of a name that are missing. */
  void
  compute(const std::string& name, const std::function<Bytes(std::size_t)>& function)
  {
    team_.meet(); // before the first one adds files that others count as missing
    // What is missing is asked by each rank for itself, and file systems may answer
    // differently: the list of the first one counts, so that all of them run.
    const std::vector<std::size_t> missing = missingOf(name);
    makePlaceFor(name);
    std::string failure;
    team_.run(
        missing,
        [&](std::size_t tile) { return written(name, tile, function(tile)); },
        [&](std::size_t tile, const std::string& result, const std::string& error) {
          if (error.empty())
            complete(name, tile, completeOf(result));
          else if (failure.empty())
            failure = name + " of tile " + std::to_string(tile) + ": " + error;
        });
    refresh();
    const std::size_t left = missingOf(name).size();
    if (left > 0)
      throw TilingError(failure.empty()
                            ? "another rank has failed"
                            : failure + "; " + std::to_string(left) + " of " +
                                  std::to_string(plan().points.size()) +
                                  " tiles are left for the next run of the "
                                  "same command");
  }

  /** \param[in] result what written() returned */
  static Complete
  completeOf(const std::string& result)
  {
    Complete complete;
    std::istringstream(result) >> complete.bytes >> complete.check;
    return complete;
  }

  bool
  isRecorded(const std::string& name, std::size_t tile, const Complete& now)
  {
    const Complete& before = complete_[name][tile];
    return before.bytes == now.bytes && before.check == now.check;
  }

  void
  complete(const std::string& name, std::size_t tile, const Complete& now)
  {
    add({{"event", "result"},
         {"name", name},
         {"tile", tile},
         {"bytes", now.bytes},
         {"check", now.check}});
    if (name == tiles_name)
      removeFile(pathOf(buckets_name, tile));
  }

  /** Points to buckets, one for each tile, in the order of the sources; a bucket
   * becomes a tile. */
  void
  makeTiles()
  {
    const std::vector<std::size_t> missing = missingOf(tiles_name);
    if (team_.isFirst() && !haveBuckets(missing))
      fillBuckets(missing);
    compute(tiles_name, [&](std::size_t tile) {
      const Bytes bytes = readWhole(pathOf(buckets_name, tile));
      std::vector<Position> points(bytes.size() / sizeof(Position));
      std::memcpy(points.data(), bytes.data(), bytes.size());
      return encodeTile(points);
    });
  }

  bool
  haveBuckets(const std::vector<std::size_t>& tiles) const
  {
    return std::all_of(tiles.begin(), tiles.end(), [&](std::size_t tile) {
      return sizeOfFile(pathOf(buckets_name, tile)) ==
             static_cast<std::int64_t>(plan().points[tile] * sizeof(Position));
    });
  }

  void
  fillBuckets(const std::vector<std::size_t>& tiles)
  {
    const std::string directory = directory_ + '/' + buckets_name;
    makeDirectory(directory);
    for (const fs::path& file : entriesOf(directory))
      if (kindOf(file) != FileOfTile::none)
        removeFile(file);
    constexpr std::size_t no_bucket = ~std::size_t{0};
    std::vector<std::size_t> bucket_of(plan().points.size(), no_bucket);
    for (std::size_t b = 0; b < tiles.size(); ++b)
      bucket_of[tiles[b]] = b;
    std::vector<std::vector<Position>> buckets(tiles.size());
    const std::size_t most =
        std::max<std::size_t>(64, buffered_bytes / sizeof(Position) / tiles.size());
    const auto flush = [&](std::size_t b) {
      appendTo(pathOf(buckets_name, tiles[b]),
               buckets[b].data(),
               buckets[b].size() * sizeof(Position));
      buckets[b].clear();
    };
    for (const auto& source : sources_)
      source->read([&](const Position* points, std::size_t count) {
        for (std::size_t i = 0; i < count; ++i) {
          const std::array<float, 3> floats = floatsOf(points[i], offset());
          if (!isFinite(floats))
            continue;
          const std::size_t b = bucket_of[plan().tree.tileOf(floats.data())];
          if (b == no_bucket)
            continue;
          buckets[b].push_back(points[i]);
          if (buckets[b].size() >= most)
            flush(b);
        }
      });
    for (std::size_t b = 0; b < buckets.size(); ++b)
      if (!buckets[b].empty())
        flush(b);
    if (!haveBuckets(tiles))
      throw TilingError(directory + ": the sources have other points than before; "
                                    "expected sources that do not change");
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
  TileSettings settings_;
  Team& team_;
  std::optional<Lock> lock_;
  std::optional<Manifest> manifest_;
  Position offset_{};
  std::optional<Plan> plan_;
  std::map<std::string, std::map<std::size_t, Complete>> complete_;
  std::set<std::string> names_{tiles_name, buckets_name}; ///< of directories
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
