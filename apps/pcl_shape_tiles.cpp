// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_tiles: normals, edges, surfaces, instances and INAD of clouds larger than
// memory, tile by tile.

#include "cli/command_line.h"
#include "cli/filter_app.h"
#include "detection/detection.h"
#include "io/any_cloud.h"
#include "io/errors.h"
#include "tiles/cloud_source.h"
#include "tiles/mpi_team.h"
#include "tiles/tile_fields.h"
#include "tiles/tile_instances.h"
#include "tiles/tile_join.h"
#include "tiles/tile_numbers.h"

#include <pcl/segmentation/means_of_parts.h>
#include <pcl/tiling/tiled_cloud.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <set>
#include <thread>

namespace fs = std::filesystem;

namespace {

using namespace pcl::app;
using pcl::tiling::Team;
using pcl::tiling::TiledCloud;
using pcl::tiling::TileSettings;

// Of a point of a tile: its coordinates, what is computed of it, and its share of the
// points around the tile. Some 190 were measured, and 270 with surfaces; smaller tiles
// have larger shares around them.
constexpr double bytes_of_point = 250.0;
// Its halo is wider, and one in four is a piece of a face, with those around the tile.
constexpr double bytes_with_surfaces = 350.0;
constexpr double fixed_bytes = 200e6; // of the program, and of points on their way
constexpr double min_memory = 300e6;
// Pieces of faces reach farther than a small tile. This much holds those of a surface
// that are within reach of a tile, see doc/tiles.md.
constexpr double min_memory_with_surfaces = 800e6;
constexpr double max_points_of_tile = 1e9; // of a tile: they are counted in 32 bits

TileWanted
wantedOf(const Arguments& arguments)
{
  TileWanted wanted{arguments.has("normals"),
                    arguments.has("edges"),
                    arguments.has("types"),
                    arguments.has("surfaces"),
                    arguments.number("inad", positive_length).value_or(0.0),
                    resolutionOf(arguments),
                    arguments.has("instances")
                        ? arguments.choice("instances", {"curved", "planar"})
                        : std::string()};
  if (!wanted.needsNumbers() && wanted.inad_radius == 0.0)
    wanted.edges = wanted.types = true;
  for (const char* const of_points : {"normals", "inad"})
    if (wanted.resolution > 0.0 && arguments.has(of_points))
      throw UsageError("-" + std::string(of_points) +
                       " is of the cloud's own points; leave it or -resolution out");
  return wanted;
}

/** Bytes of e.g. 2G, 500M or 2000000000. */
double
memoryOf(const Arguments& arguments, const TileWanted& wanted)
{
  const std::string text = arguments.text("memory", "2G");
  double unit = 1.0;
  std::string number = text;
  constexpr double kilo = 1e3;
  const std::string units = "kMGT";
  if (const std::size_t at = text.empty() ? std::string::npos : units.find(text.back());
      at != std::string::npos) {
    unit = std::pow(kilo, static_cast<double>(at + 1));
    number.pop_back();
  }
  const auto value = parseNumber(number);
  if (!value || !(*value * unit >= min_memory))
    arguments.fail("memory", "a number of bytes, such as 2G or 500M, of at least 300M");
  if (wanted.needsSurfaces() && *value * unit < min_memory_with_surfaces)
    arguments.fail(
        "memory",
        "at least 800M with -surfaces or -instances, which look far beyond a tile, "
        "however small it is");
  return *value * unit;
}

TileSettings
settingsOf(const Arguments& arguments, const TileWanted& wanted)
{
  TileSettings settings;
  const double bytes = wanted.needsSurfaces() ? bytes_with_surfaces : bytes_of_point;
  settings.max_points = static_cast<std::uint64_t>(std::min(
      (memoryOf(arguments, wanted) - fixed_bytes) / bytes, max_points_of_tile));
  settings.max_edge = arguments.number("tile", positive_length).value_or(0.0);
  nlohmann::ordered_json parameters;
  for (const TileField& field : fieldsOf(wanted))
    parameters["fields"].push_back(field.name);
  parameters["instances"] = wanted.instances;
  parameters["inad"] = wanted.inad_radius;
  parameters["resolution"] = wanted.resolution;
  parameters["offset"] = arguments.text("offset", "default");
  parameters["floats"] = floatsOfBin(arguments);
  settings.parameters = parameters.dump();
  return settings;
}

PCDFormat
formatOf(const Arguments& arguments)
{
  return *pcl::app::formatOf(arguments.choice("format", {"binary", "ascii"}));
}

std::string
outputOf(const std::string& directory, const std::string& input)
{
  fs::path name = fs::path(input).filename();
  if (endingOf(input) == ".bin")
    name.replace_extension(".pcd");
  return (fs::path(directory) / name).string();
}

std::string
tilesOf(const std::string& output_dir)
{
  return (fs::path(output_dir) / "tiles").string();
}

bool
isBelow(const std::string& path, const std::string& directory)
{
  const fs::path whole = fs::weakly_canonical(path);
  const fs::path above = fs::weakly_canonical(directory);
  return std::mismatch(above.begin(), above.end(), whole.begin(), whole.end()).first ==
         above.end();
}

std::vector<std::string>
outputsOf(const Arguments& arguments, const std::vector<std::string>& inputs)
{
  if (!arguments.has("output_dir"))
    throw UsageError("-output_dir is missing; expected a directory for the outputs");
  std::vector<std::string> outputs;
  std::set<std::string> names;
  for (const std::string& input : inputs) {
    const std::string output_dir = arguments.text("output_dir");
    const std::string output = outputOf(output_dir, input);
    std::error_code error;
    if (fs::equivalent(input, output, error) && !error)
      throw UsageError("output '" + output +
                       "' is an input; expected another -output_dir");
    if (isBelow(input, tilesOf(output_dir)))
      throw UsageError("input '" + input + "' is in " + tilesOf(output_dir) +
                       ", where tiles go; expected another -output_dir");
    if (!names.insert(output).second)
      throw UsageError("output '" + output +
                       "' is that of two inputs; expected inputs of different names");
    outputs.push_back(output);
  }
  return outputs;
}

std::size_t
processesOf(const Arguments& arguments)
{
  constexpr std::uint64_t most = 1024; // of one machine
  return arguments.integer("processes", 1, most).value_or(1);
}

/** All cores are shared by the processes, unless -threads says otherwise. */
unsigned
threadsOf(const Arguments& arguments)
{
  const std::size_t processes = processesOf(arguments);
  if (arguments.threads() > 0 || processes == 1)
    return arguments.threads();
  return std::max(
      1U, std::thread::hardware_concurrency() / static_cast<unsigned>(processes));
}

CloudSources
sourcesOf(const std::vector<std::string>& inputs, const Arguments& arguments)
{
  CloudSources sources;
  for (const std::string& input : inputs) {
    sources.push_back(
        std::make_shared<const CloudSource>(input, floatsOfBin(arguments)));
    if (sources.back()->stream().isInMemory())
      logLine(arguments.app() + ": " + input +
              ": warning: is read as a whole, as .bin, compressed PCD and PLY with "
              "lists, a camera, a range_grid, big-endian numbers or elements before "
              "the vertices are; expected memory for it");
  }
  return sources;
}

/** What one run does, from inputs to outputs. */
class Run {
public:
  Run(const Arguments& arguments, Team& team)
  : arguments_(arguments)
  , team_(team)
  , wanted_(wantedOf(arguments))
  , inputs_(arguments.operandsFrom(1))
  , outputs_(outputsOf(arguments, inputs_))
  , sources_(sourcesOf(inputs_, arguments))
  {}

  void
  run()
  {
    const std::string directory = arguments_.text("output_dir");
    const bool keeps = arguments_.has("keep_tiles");
    if (team_.isFirst()) {
      checkResolution();
      prepare(directory);
    }
    TiledCloud cloud(tilesOf(directory),
                     {sources_.begin(), sources_.end()},
                     settingsOf(arguments_, wanted_),
                     team_);
    report_.time("partition", [&] {
      cloud.setOffset(offset(cloud));
      cloud.partition();
    });
    if (team_.isFirst())
      logOffset(arguments_, directory, cloud.offset());
    compute(cloud);
    report_.time("join", [&] {
      joinTiles(cloud,
                team_,
                sources_,
                wanted_,
                {outputs_, formatOf(arguments_), arguments_.has("offset")});
    });
    say(cloud);
    team_.meet();
    if (!keeps)
      cloud.remove();
  }

private:
  /** Before a directory of tiles keeps it: the next run may be given another one. */
  void
  checkResolution()
  {
    if (wanted_.resolution == 0.0 || fs::exists(manifest()))
      return;
    chosen_offset_ = chosenOffset();
    const std::string problem =
        pcl::problemOfResolution(wanted_.resolution, boxOf(sources_, *chosen_offset_));
    if (!problem.empty())
      throw InputError(problem);
  }

  std::string
  manifest() const
  {
    return tilesOf(arguments_.text("output_dir")) + "/manifest.jsonl";
  }

  void
  prepare(const std::string& directory) const
  {
    std::error_code error;
    fs::create_directories(directory, error);
    if (error)
      throw InputError(directory + ": cannot be made: " + error.message());
    for (const std::string& output : outputs_)
      requireWritable(output);
    checkJsonPath(arguments_, inputs_);
    checkJsonPath(arguments_, outputs_);
  }

  pcl::tiling::Position
  offset(TiledCloud& cloud) const
  {
    if (const auto given = givenOffset(arguments_))
      return *given;
    const std::string text = cloud.decide("offset", [&] {
      return nlohmann::ordered_json(chosen_offset_ ? *chosen_offset_ : chosenOffset())
          .dump();
    });
    return nlohmann::ordered_json::parse(text);
  }

  pcl::tiling::Position
  chosenOffset() const
  {
    const auto given = givenOffset(arguments_);
    return given ? *given : offsetOf(sources_);
  }

  void
  compute(TiledCloud& cloud)
  {
    const unsigned threads = threadsOf(arguments_);
    std::optional<MeasuredCloud> measured;
    if (wanted_.needsNumbers())
      report_.time("numbers", [&] {
        measured.emplace(measure(cloud, wanted_.resolution, threads));
      });
    if (measured)
      takeResolution(measured->resolution);
    const std::array<float, 3> view_point =
        viewPointOf(sources_, cloud.offset(), arguments_.has("offset"));
    report_.time("fields",
                 [&] { computeFields(cloud, wanted_, measured, view_point, threads); });
    if (!measured)
      return;
    if (!wanted_.instances.empty())
      report_.setCount("counts", "instances", countInstances(cloud));
    report_.setNumber("numbers", "spacing", measured->numbers.spacing);
    report_.setNumber("numbers", "noise", measured->numbers.noise);
    report_.setNumber("numbers", "noise_level", measured->numbers.noise_level);
  }

  /** That of the measured places, which may be coarser than what was asked for. */
  void
  takeResolution(double resolution)
  {
    report_.setNumber("parameters", "resolution", resolution);
    if (resolution == wanted_.resolution)
      return;
    if (wanted_.normals || wanted_.inad_radius > 0.0)
      throw InputError(noteOfResolution(resolution) +
                       ", but -normals and -inad are of the points themselves; leave "
                       "-normals out, run -inad on its own, and remove " +
                       tilesOf(arguments_.text("output_dir")) +
                       " or give another -output_dir");
    if (team_.isFirst())
      logLine(arguments_.text("output_dir") +
              ": note: " + noteOfResolution(resolution));
    wanted_.resolution = resolution;
  }

  void
  say(const TiledCloud& cloud)
  {
    if (!team_.isFirst())
      return;
    report_.setCount("", "points", cloud.countFinite() + cloud.countNotFinite());
    report_.setCount("", "finite_points", cloud.countFinite());
    report_.setCount("counts", "files", inputs_.size());
    report_.setCount("counts", "tiles", cloud.size());
    report_.setJson("parameters", "offset", cloud.offset());
    printSummary(arguments_.text("output_dir"), report_);
    writeJson(arguments_, toJson(arguments_.app(), report_));
  }

  const Arguments& arguments_;
  Team& team_;
  TileWanted wanted_;
  std::vector<std::string> inputs_, outputs_;
  CloudSources sources_;
  std::optional<pcl::tiling::Position> chosen_offset_;
  Report report_;
};

void
checkArguments(const Arguments& arguments)
{
  checkInputOptions(arguments);
  settingsOf(arguments, wantedOf(arguments));
  threadsOf(arguments);
  formatOf(arguments);
  outputsOf(arguments, arguments.operandsFrom(1));
}

/** By the environment that Open MPI, MPICH and Slurm's PMI give to the processes they
 * start. */
bool
isStartedByMpi()
{
  constexpr std::array<const char*, 3> names{
      "OMPI_COMM_WORLD_RANK", "PMI_RANK", "PMIX_RANK"};
  return std::any_of(
      names.begin(), names.end(), [](const char* name) { return std::getenv(name); });
}

int
run(const Arguments& arguments)
{
  checkArguments(arguments);
  const bool is_mpi = isStartedByMpi();
  if (is_mpi && arguments.has("processes"))
    throw UsageError("-processes belongs to runs without MPI; leave it out, or do not "
                     "use MPI's launcher");
  const auto team = is_mpi ? mpiTeam() : pcl::tiling::makeTeam(processesOf(arguments));
  try {
    Run(arguments, *team).run();
  }
  catch (const std::exception& error) {
    if (!is_mpi)
      throw;
    // All ranks end, but the first one has the most to say.
    if (!team->isFirst())
      std::this_thread::sleep_for(std::chrono::seconds(1));
    logLine(arguments.app() + ": " + error.what());
    endMpi(1);
    return 1;
  }
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_tiles",
      "in.pcd... -output_dir D",
      "Divide clouds that need not fit into memory into tiles, and compute normals, "
      "edges, surfaces,\ninstances and INAD: the inputs are one cloud. D gets a cloud "
      "of each input's name with the fields\nthat are asked for; without any those of "
      "-edges and -types. A run that was ended goes on with the\nsame command.");
  command_line.option("output_dir", "D", "for the outputs, and for tiles in D/tiles")
      .flag("normals", "add normal_x normal_y normal_z curvature")
      .flag("edges", "add edge_likelihood (NaN unknown) and edge: 1 on creases")
      .flag("types", "add edge_type: 1 crease, 2 corner, 3 open boundary, 0 none")
      .flag("surfaces", "add likelihood and surface: 1 planar, 2 curved, 0 unknown")
      .option("instances", "C", "add instance: 1 and up; of curved or planar")
      .option("inad", "R", "add mu and sigma, with neighborhoods of R meters")
      .option("memory",
              "M",
              "of a process, about: 2G (default), 800M or more with surfaces")
      .option("tile", "L", "the longest edge of a tile in meters (by -memory)")
      .option("processes", "N", "that work at the same time: 1 (default)")
      .flag("keep_tiles", "leave D/tiles there in the end")
      .option("format", "F", "of the outputs: binary (default), ascii");
  addResolutionOption(command_line);
  addInputOptions(command_line);
  addCommonOptions(command_line);
  keepFreedMemory();
  return runApp(command_line, argc, argv, run);
}
