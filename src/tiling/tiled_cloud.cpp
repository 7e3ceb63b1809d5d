// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Divides sources into tiles, and gives their points to those who compute results.

#include "tiling/plan.h"
#include "tiling/results.h"
#include "tiling/section_file.h"
#include "tiling/tile_file.h"

#include <pcl/tiling/tiled_cloud.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <optional>

namespace pcl::tiling {
namespace {

constexpr int format_version = 9;
const std::string tiles_name = "tiles";
// Of sections: their counts, their points by tile, and which rows of tiles these are.
const std::string survey_name = "survey", sections_name = "sections",
                  rows_name = "rows";
const std::set<std::string> own_names{
    tiles_name, survey_name, sections_name, rows_name};

/** What results depend on. */
Results::Record
beginning(const TiledCloud::Sources& sources, const TileSettings& settings)
{
  if (sources.empty())
    throw TilingError("no sources are given; expected at least one");
  if (settings.max_points == 0)
    throw TilingError("0 points for a tile; expected at least one");
  auto of_sources = Results::Record::array();
  for (const auto& source : sources)
    of_sources.push_back({{"name", source->name()},
                          {"state", source->state()},
                          {"sections", source->countSections()}});
  return {{"event", "begin"},
          {"version", format_version},
          {"parameters", settings.parameters},
          {"max_points", settings.max_points},
          {"max_edge", settings.max_edge},
          {"sources", of_sources}};
}

std::vector<TiledCloud::Section>
sectionsOf(const TiledCloud::Sources& sources)
{
  std::vector<TiledCloud::Section> sections;
  for (std::size_t source = 0; source < sources.size(); ++source)
    for (std::size_t k = 0; k < sources[source]->countSections(); ++k)
      sections.push_back({source, k});
  return sections;
}

void
requireFree(const std::string& name)
{
  if (own_names.count(name))
    throw TilingError("a result is called '" + name +
                      "', as files of the partition are; expected another name");
}

} // namespace

struct TiledCloud::State {
  State(const std::string& in_directory,
        const Sources& of_points,
        const TileSettings& how,
        Team& of_processes)
  : directory(in_directory)
  , sources(of_points)
  , sections(sectionsOf(of_points))
  , settings(how)
  , results(in_directory, beginning(of_points, how), own_names, of_processes)
  {
    if (const auto decided = results.decision(tiles_name))
      setPlan(*decided);
  }

  void
  setPlan(const std::string& decided)
  {
    useRecords(manifestPath(directory),
               [&] { optional_plan = planOf(Results::Record::parse(decided)); });
  }

  const Plan&
  plan() const
  {
    if (!optional_plan)
      throw TilingError(directory + ": the cloud is not divided yet; expected "
                                    "partition() before");
    return *optional_plan;
  }

  const Position&
  offset() const
  {
    return optional_plan ? optional_plan->offset : given_offset;
  }

  Tasks
  tileTasks() const
  {
    return {"tile", plan().points};
  }

  Tasks
  sectionTasks() const
  {
    return {"section", std::vector<std::uint64_t>(sections.size(), 1)};
  }

  /** The sections are counted, and then divided. */
  void
  survey()
  {
    results.compute(survey_name, sectionTasks(), [&](std::size_t section) {
      return results.write(survey_name, section, surveyOf(section).toBytes());
    });
    setPlan(results.decide(tiles_name, [&] {
      Survey all;
      for (std::size_t section = 0; section < sections.size(); ++section)
        all.add(results.read(survey_name, section));
      return toJson(planOf(all, given_offset, settings.max_points, settings.max_edge))
          .dump();
    }));
  }

  /** The counts of a section in the smallest cells that are few enough. Most sections
   * are as dense as those before them: growing from a micrometer takes longer than the
   * rest. */
  Survey
  surveyOf(std::size_t section)
  {
    constexpr int smaller = 2; // than those of the section before
    for (int exponent = std::max(last_exponent - smaller, DensityCells::min_exponent);;
         exponent = DensityCells::min_exponent) {
      Survey survey = Survey::ofSection(exponent);
      readParts(section, [&](const Position* points, std::size_t count) {
        survey.add(points, count, given_offset);
      });
      if (!survey.cells.areSmallest())
        continue;
      last_exponent = survey.cells.grid().exponent;
      return survey;
    }
  }

  /** use(points, count) for some points of a section at a time. */
  template <typename Use>
  void
  readParts(std::size_t section, const Use& use) const
  {
    const auto& [source, number] = sections[section];
    sources[source]->readSection(number, use);
  }

  /** The points of each section by tile, and which rows of the tiles they are. A rank
   * that misses nothing takes part too: others may see other files. */
  void
  sortSections()
  {
    const bool is_needed = results.isMissing(tiles_name, tileTasks()) ||
                           results.isMissing(rows_name, sectionTasks());
    const Tasks tasks = is_needed ? sectionTasks() : Tasks{sectionTasks().kind, {}};
    results.compute(sections_name, tasks, [&](std::size_t section) {
      return results.write(sections_name, section, [&](WholeFile& file) {
        SectionWriter writer(file, plan().points.size());
        readParts(section, [&](const Position* points, std::size_t count) {
          for (const Position* point = points; point < points + count; ++point)
            if (const auto floats = floatsOf(*point, offset()); isFinite(floats))
              writer.add(*point, plan().tree.tileOf(floats.data()));
        });
        writer.finish();
      });
    });
    results.computeAtOnce(rows_name, sectionTasks(), [&](const Results::Write& write) {
      countRows(write);
    });
  }

  void
  countRows(const Results::Write& write) const
  {
    std::vector<std::uint64_t> next(plan().points.size());
    for (std::size_t section = 0; section < sections.size(); ++section) {
      const std::vector<std::uint64_t> counts = sectionFile(section).counts();
      std::vector<Rows> rows;
      for (std::size_t tile = 0; tile < counts.size(); ++tile)
        if (counts[tile] > 0) {
          rows.push_back({tile, next[tile], counts[tile]});
          next[tile] += counts[tile];
        }
      const auto* const bytes = reinterpret_cast<const std::uint8_t*>(rows.data());
      write(section, {bytes, bytes + rows.size() * sizeof(Rows)});
    }
    if (next != plan().points)
      throw TilingError("the sources have other points than before; expected sources "
                        "that do not change");
  }

  SectionFile
  sectionFile(std::size_t section) const
  {
    return {filePath(directory, sections_name, section), plan().points.size()};
  }

  std::vector<Position>
  pointsOfSections(std::size_t tile) const
  {
    std::vector<Position> points;
    points.reserve(plan().points[tile]);
    for (std::size_t section = 0; section < sections.size(); ++section)
      sectionFile(section).addPointsOf(tile, points);
    if (points.size() != plan().points[tile])
      throw TilingError(directory + ": tile " + std::to_string(tile) + " has " +
                        std::to_string(points.size()) + " points in " + sections_name +
                        "; expected " + std::to_string(plan().points[tile]));
    return points;
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
    files.resize(plan().points.size());
    if (!files[tile])
      files[tile] = std::make_unique<TileFile>(filePath(directory, tiles_name, tile));
    return *files[tile];
  }

  std::string directory;
  Sources sources;
  std::vector<Section> sections;
  TileSettings settings;
  Results results;
  Position given_offset{};
  int last_exponent = DensityCells::min_exponent; ///< of the section surveyed last
  std::optional<Plan> optional_plan;
  std::vector<std::unique_ptr<TileFile>> files;
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
  if (!state_->optional_plan)
    state_->survey();
  Results& results = state_->results;
  results.remove(survey_name); // also that of a run which was killed after it
  state_->sortSections();
  results.compute(tiles_name, state_->tileTasks(), [&](std::size_t tile) {
    return results.write(tiles_name, tile, encodeTile(state_->pointsOfSections(tile)));
  });
  results.remove(sections_name);
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
  state_->given_offset = offset;
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
  TilePoints points;
  points.points = state_->fileOf(tile).points();
  points.own = points.points.size();
  const Box around = state_->boxAround(tile, halo);
  for (const std::size_t other : tilesAround(tile, halo)) {
    std::vector<std::uint32_t> rows;
    state_->fileOf(other).addPointsIn(around, points.points, rows);
    for (const std::uint32_t row : rows)
      points.around.push_back({static_cast<std::uint32_t>(other), row});
  }
  return points;
}

std::vector<std::size_t>
TiledCloud::tilesAround(std::size_t tile, double halo) const
{
  const std::vector<std::uint64_t>& points = state_->plan().points;
  const Box around = state_->boxAround(tile, halo);
  std::vector<std::size_t> tiles;
  for (std::size_t other = 0; other < points.size(); ++other)
    if (other != tile && points[other] > 0 && around.meets(state_->fileOf(other).box()))
      tiles.push_back(other);
  return tiles;
}

void
TiledCloud::run(const std::string& name, double halo, const Function& function)
{
  runOnResults(name,
               [&](std::size_t tile) { return function(tile, load(tile, halo)); });
}

void
TiledCloud::runOnResults(const std::string& name, const ResultFunction& function)
{
  requireFree(name);
  state_->results.compute(name, state_->tileTasks(), [&](std::size_t tile) {
    return state_->results.write(name, tile, function(tile));
  });
}

void
TiledCloud::runAtOnce(const std::string& name,
                      const std::function<void(const Write& write)>& function)
{
  requireFree(name);
  state_->results.computeAtOnce(name, state_->tileTasks(), function);
}

const std::vector<TiledCloud::Section>&
TiledCloud::sections() const
{
  return state_->sections;
}

std::vector<TiledCloud::Rows>
TiledCloud::rowsOf(std::size_t section) const
{
  const Bytes bytes = resultOf(rows_name, section);
  std::vector<Rows> rows(bytes.size() / sizeof(Rows));
  if (!rows.empty())
    std::memcpy(rows.data(), bytes.data(), bytes.size());
  return rows;
}

void
TiledCloud::runOnSections(const std::string& name, const SectionFunction& function)
{
  requireFree(name);
  state_->results.compute(name, state_->sectionTasks(), [&](std::size_t section) {
    return state_->results.write(name, section, [&](WholeFile& file) {
      function(section,
               [&](const void* data, std::size_t size) { file.write(data, size); });
    });
  });
}

std::vector<std::uint8_t>
TiledCloud::resultOf(const std::string& name, std::size_t number) const
{
  return state_->results.read(name, number);
}

void
TiledCloud::copyTo(const std::string& name, std::size_t number, const Sink& sink) const
{
  state_->results.copyTo(name, number, sink);
}

std::string
TiledCloud::pathOf(const std::string& name, std::size_t number) const
{
  return filePath(state_->directory, name, number);
}

void
TiledCloud::check(const std::string& name)
{
  state_->results.check(name, state_->tileTasks());
}

void
TiledCloud::removeResult(const std::string& name)
{
  requireFree(name);
  state_->results.remove(name);
}

std::string
TiledCloud::decide(const std::string& name, const std::function<std::string()>& find)
{
  requireFree(name);
  return state_->results.decide(name, find);
}

void
TiledCloud::remove()
{
  state_->results.removeAll();
}

} // namespace pcl::tiling
