// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Edges and curved surfaces, beside the paper's method and others.

#include "common/options.h"
#include "peers/contest.h"
#include "peers/peer.h"
#include "peers/report.h"

#include <algorithm>
#include <iostream>

// This library, the paper's method and what others offer for the same, on clouds with
// truth: how well edges, and curved against planar points, are found. Peers may choose
// the best of their settings and thresholds for these clouds, or for others; this
// library may not.
namespace {

namespace po = boost::program_options;
using namespace peers;

struct Arguments {
  std::vector<std::string> clouds;
  std::vector<std::string> tasks{"edges", "surfaces"};
  std::vector<std::string> peers; ///< only those whose names have one of these in them
  std::vector<double> edge_radii{0.008, 0.012, 0.015};
  std::vector<double> surface_radii{0.015, 0.025};
  std::vector<double> voronoi_radii{0.008}; ///< CGAL's is slow
  std::vector<int> neighbors{24};
  std::vector<std::string> tuning_clouds;
  bool is_held_out = false;
  int jobs = 1;
};

std::vector<Task>
tasksOf(const Arguments& arguments)
{
  std::vector<Task> tasks;
  for (const std::string& name : arguments.tasks) {
    if (name != "edges" && name != "surfaces")
      throw std::invalid_argument("-tasks " + name + ": expected edges, surfaces");
    tasks.push_back(name == "edges" ? Task::edges : Task::surfaces);
  }
  return tasks;
}

void
check(const Arguments& arguments)
{
  if (arguments.clouds.empty())
    throw std::invalid_argument("no clouds: PCD files with truth are needed");
  for (const auto* radii :
       {&arguments.edge_radii, &arguments.surface_radii, &arguments.voronoi_radii}) {
    for (const double radius : *radii) {
      if (!(radius >= 0.001 && radius <= 1.0)) {
        throw std::invalid_argument("radius " + std::to_string(radius) +
                                    ": expected 0.001 to 1 meter");
      }
    }
  }
  for (const int k : arguments.neighbors) {
    if (k < 5 || k > 1000) {
      throw std::invalid_argument("-neighbors " + std::to_string(k) +
                                  ": expected 5 to 1000");
    }
  }
  if (arguments.is_held_out && !arguments.tuning_clouds.empty()) {
    throw std::invalid_argument(
        "-held_out with -tune_on: expected one of them, which both say what settings "
        "are chosen on");
  }
  if (arguments.jobs < 1 || arguments.jobs > 256) {
    throw std::invalid_argument("-jobs " + std::to_string(arguments.jobs) +
                                ": expected 1 to 256");
  }
}

/** Prints the help and returns false if that is asked for. */
bool
parseArguments(int argc, char** argv, Arguments& a)
{
  po::options_description options("compare_peers CLOUD.pcd ... [options]");
  options.add_options()(
      "tasks", po::value(&a.tasks)->multitoken(), "edges, surfaces (both)")(
      "peers", po::value(&a.peers)->multitoken(), "parts of the names of some (all)")(
      "edge_radii", po::value(&a.edge_radii)->multitoken(), "meters, peers' choice")(
      "surface_radii", po::value(&a.surface_radii)->multitoken(), "likewise")(
      "voronoi_radii", po::value(&a.voronoi_radii)->multitoken(), "CGAL's, likewise")(
      "neighbors", po::value(&a.neighbors)->multitoken(), "k nearest, likewise (24)")(
      "held_out",
      po::bool_switch(&a.is_held_out),
      "peers choose for each cloud on the other ones")(
      "tune_on",
      po::value(&a.tuning_clouds)->multitoken(),
      "clouds on which peers choose, instead")(
      "jobs", po::value(&a.jobs), "clouds at a time, one thread each (1)")("help",
                                                                           "this");
  if (!parseCommandLine(argc, argv, options, po::value(&a.clouds)))
    return false;
  check(a);
  return true;
}

std::vector<Peer>
peersOf(Task task, const Arguments& arguments)
{
  std::vector<Peer> peers = task == Task::edges ? ownEdges() : ownSurfaces();
  const std::vector<Peer> others =
      task == Task::edges ? edgePeers(arguments.edge_radii, arguments.neighbors)
                          : surfacePeers(arguments.surface_radii);
  peers.insert(peers.end(), others.begin(), others.end());
#ifdef PCL_SHAPE_HAS_CGAL
  if (task == Task::edges)
    peers.push_back(voronoiPeer(arguments.voronoi_radii));
#endif
  const auto isLeftOut = [&](const Peer& peer) {
    return std::none_of(
        arguments.peers.begin(), arguments.peers.end(), [&](const std::string& part) {
          return peer.name.find(part) != std::string::npos;
        });
  };
  if (!arguments.peers.empty()) {
    peers.erase(std::remove_if(peers.begin(), peers.end(), isLeftOut), peers.end());
    if (peers.empty()) {
      throw std::invalid_argument("-peers " + arguments.peers.front() +
                                  ": no peer has this in its name");
    }
  }
  return peers;
}

std::vector<LabeledCloud>
readClouds(const std::vector<std::string>& paths, const std::vector<Task>& tasks)
{
  std::vector<LabeledCloud> clouds;
  for (const std::string& path : paths)
    clouds.push_back(readLabeledCloud(path, tasks));
  return clouds;
}

int
runComparison(int argc, char** argv)
{
  Arguments arguments;
  if (!parseArguments(argc, argv, arguments))
    return 0;
#ifndef PCL_SHAPE_HAS_CGAL
  std::cerr << "compare_peers: built without CGAL, whose edges are left out\n";
#endif
  const std::vector<Task> tasks = tasksOf(arguments);
  std::vector<std::vector<Peer>> peers;
  peers.reserve(tasks.size());
  for (const Task task : tasks)
    peers.push_back(peersOf(task, arguments));
  const std::vector<LabeledCloud> clouds = readClouds(arguments.clouds, tasks);
  const std::vector<LabeledCloud> others = readClouds(arguments.tuning_clouds, tasks);
  const Tuning tuning{others.empty() ? nullptr : &others, arguments.is_held_out};
  nlohmann::ordered_json report = describe(clouds);
  report["jobs"] = arguments.jobs;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    auto& rows = report[tasks[i] == Task::edges ? "edges" : "surfaces"];
    rows = nlohmann::ordered_json::array();
    for (const Peer& peer : peers[i])
      rows.push_back(toJson(compete(peer, clouds, tuning, tasks[i], arguments.jobs)));
  }
  std::cout << report.dump() << std::endl;
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("compare_peers", runComparison, argc, argv);
}
