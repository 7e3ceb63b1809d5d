// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances that are found, beside what PCL offers for it.

#include "common/measure.h"
#include "common/options.h"
#include "instances/instance_methods.h"
#include "instances/instance_scores.h"

#include <nlohmann/json.hpp>

#include <iostream>
#include <map>
#include <utility>

// This library and what PCL offers for it, on clouds with instances of known extent:
// how many are found, and how long it takes. Peers may choose the best of their
// settings for each group of clouds; this library may not.
namespace {

namespace po = boost::program_options;
using namespace instances;
using pcl::scene::Shape;
using Json = nlohmann::ordered_json;

struct Arguments {
  std::vector<std::string> clouds;
  std::vector<std::uint64_t> seeds{101, 102};
  std::vector<unsigned> counts{1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12};
  std::vector<std::string> groups{
      "cylinders", "boxes", "faces", "mixed", "mixed_curved"};
  std::string noise = "kinect";
  bool own_only = false;
  bool verbose = false;
  unsigned threads = 1;
};

struct Group {
  Task task;
  std::vector<Shape> shapes;
};

const std::map<std::string, Group>&
groups()
{
  static const std::map<std::string, Group> all{
      {"cylinders", {Task::curved, {Shape::Cylinder}}},
      {"boxes", {Task::objects, {Shape::Box}}},
      {"faces", {Task::faces, {Shape::Box}}},
      {"mixed", {Task::objects, {}}},
      {"mixed_curved", {Task::curved, {}}}};
  return all;
}

bool
parseArguments(int argc, char** argv, Arguments& a)
{
  po::options_description options("compare_instances [CLOUD.pcd ...] [options]");
  options.add_options()("seeds", po::value(&a.seeds)->multitoken(), "of the scenes")(
      "counts", po::value(&a.counts)->multitoken(), "of objects (1 to 12)")(
      "groups",
      po::value(&a.groups)->multitoken(),
      "of scenes: cylinders, boxes, faces (of boxes), mixed, mixed_curved")(
      "noise", po::value(&a.noise), "kinect, none")(
      "own", po::bool_switch(&a.own_only), "no peers")(
      "verbose", po::bool_switch(&a.verbose), "a line for each cloud")(
      "threads", po::value(&a.threads), "of this library (1, as the peers have)")(
      "help", "this");
  if (!parseCommandLine(argc, argv, options, po::value(&a.clouds)))
    return false;
  for (const std::string& group : a.groups)
    if (group != "none" && groups().count(group) == 0)
      throw std::invalid_argument("-groups " + group +
                                  ": expected cylinders, boxes, faces, mixed, "
                                  "mixed_curved, none");
  if (a.noise != "kinect" && a.noise != "none")
    throw std::invalid_argument("-noise " + a.noise + ": expected kinect, none");
  return true;
}

std::vector<InstanceCloud>
cloudsOf(const Arguments& arguments, const std::string& name)
{
  const Group& group = groups().at(name);
  std::vector<InstanceCloud> clouds;
  for (const unsigned count : arguments.counts)
    for (const std::uint64_t seed : arguments.seeds) {
      pcl::scene::SceneOptions options;
      options.seed = seed;
      options.objects = count;
      options.shapes = group.shapes;
      options.noise = arguments.noise == "none" ? pcl::scene::Noise::None
                                                : pcl::scene::Noise::Kinect;
      InstanceCloud cloud = generatedCloud(name, group.task, options);
      if (cloud.count() > 0)
        clouds.push_back(std::move(cloud));
    }
  return clouds;
}

Scores
run(const Method& method, const std::vector<InstanceCloud>& clouds, bool verbose)
{
  Scores sum;
  for (const InstanceCloud& cloud : clouds) {
    Labels labels;
    const double time = millisecondsOf([&] { labels = method.run(cloud); });
    Scores scores = scoresOf(cloud, labels);
    scores.milliseconds = time;
    if (verbose)
      std::cerr << cloud.group << ", " << cloud.name << ": " << scores.found << " of "
                << scores.instances << ", merged " << scores.merged << ", split "
                << scores.split << ", missed " << scores.missed << ", extra "
                << scores.extra << ", F1 " << scores.point_f1 << ", "
                << cloud.points->size() << " points, " << time << " ms\n";
    sum += scores;
  }
  return sum;
}

Json
toJson(const Method& method, const Scores& scores)
{
  const auto clouds = static_cast<double>(scores.clouds);
  return {{"method", method.name},
          {"setting", method.setting},
          {"point_f1", scores.point_f1 / clouds},
          {"instances", scores.instances},
          {"found", scores.found},
          {"merged", scores.merged},
          {"split", scores.split},
          {"missed", scores.missed},
          {"extra", scores.extra},
          {"milliseconds", scores.milliseconds / clouds}};
}

/** This library first, then every peer with its best setting. */
Json
compare(const std::vector<InstanceCloud>& clouds, const Arguments& arguments)
{
  Json rows = Json::array();
  const Method own = ownMethod(arguments.threads);
  rows.push_back(toJson(own, run(own, clouds, arguments.verbose)));
  if (arguments.own_only)
    return rows;
  std::map<std::string, std::size_t> places;
  for (const Method& peer : peersFor(clouds.front().task)) {
    const Json row = toJson(peer, run(peer, clouds, false));
    std::cerr << row.dump() << '\n';
    const auto [place, is_new] = places.try_emplace(peer.name, rows.size());
    if (is_new)
      rows.push_back(row);
    else if (row["found"] > rows[place->second]["found"])
      rows[place->second] = row;
  }
  return rows;
}

int
runComparison(int argc, char** argv)
{
  Arguments arguments;
  if (!parseArguments(argc, argv, arguments))
    return 0;
  Json report;
  report["seeds"] = arguments.seeds;
  report["counts"] = arguments.counts;
  report["noise"] = arguments.noise;
  const auto add = [&](const std::string& name, const auto& clouds) {
    const Json rows = compare(clouds, arguments);
    std::cerr << name << ": " << rows.front().dump() << '\n';
    report["groups"].push_back(
        {{"name", name}, {"clouds", clouds.size()}, {"rows", rows}});
  };
  for (const std::string& path : arguments.clouds) {
    const std::vector<InstanceCloud> clouds{curvedParts("given", path)};
    add(clouds.front().name, clouds);
  }
  for (const std::string& name : arguments.groups)
    if (name != "none")
      add(name, cloudsOf(arguments, name));
  std::cout << report.dump() << std::endl;
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("compare_instances", runComparison, argc, argv);
}
