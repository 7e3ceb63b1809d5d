// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Edges and curved surfaces, beside the paper's method and others.

#include "common/options.h"
#include "peers/peer.h"
#include "peers/report.h"
#include "peers/trial.h"

#include <algorithm>
#include <exception>
#include <iostream>

// This library, the paper's method and what others offer for the same, on clouds with
// truth: how well edges, and curved against planar points, are found. Peers may choose
// the best of their settings and thresholds for these clouds; this library may not.
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
      "jobs", po::value(&a.jobs), "clouds at a time, one thread each (1)")("help",
                                                                           "this");
  if (!parseCommandLine(argc, argv, options, po::value(&a.clouds)))
    return false;
  check(a);
  return true;
}

/** Every cloud with one setting. Exceptions must not leave the parallel region. */
std::vector<Trial>
trialsOf(const Setting& setting,
         const std::vector<LabeledCloud>& clouds,
         Task task,
         int jobs)
{
  std::vector<Trial> trials(clouds.size());
  std::exception_ptr failure;
#pragma omp parallel for schedule(dynamic) num_threads(jobs)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(clouds.size()); ++i) {
    try {
      const auto at = static_cast<std::size_t>(i);
      trials[at] = run(setting, clouds[at], task);
    }
    catch (...) {
#pragma omp critical
      failure = std::current_exception();
    }
  }
  if (failure)
    std::rethrow_exception(failure);
  return trials;
}

/** The best setting of a peer. */
Result
compete(const Peer& peer, const std::vector<LabeledCloud>& clouds, Task task, int jobs)
{
  Result best;
  double best_f1 = -1.0;
  for (const Setting& setting : peer.settings) {
    Result result{peer.name, setting.text, !peer.threshold, 0.0f, {}};
    result.trials = trialsOf(setting, clouds, task, jobs);
    result.threshold = peer.threshold ? *peer.threshold : bestThreshold(result.trials);
    const double f1 = meanF1(result.trials, result.threshold);
    std::cerr << peer.name << ", " << setting.text << ": mean F1 " << f1 << '\n';
    if (f1 > best_f1) {
      best_f1 = f1;
      best = std::move(result);
    }
  }
  return best;
}

std::vector<Peer>
peersOf(Task task, const Arguments& arguments)
{
  std::vector<Peer> peers = task == Task::edges ? ownEdges() : ownSurfaces();
  const std::vector<Peer> others = task == Task::edges
                                       ? edgePeers(arguments.edge_radii)
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
  std::vector<LabeledCloud> clouds;
  for (const std::string& path : arguments.clouds)
    clouds.push_back(readLabeledCloud(path, tasks));
  nlohmann::ordered_json report = describe(clouds);
  report["jobs"] = arguments.jobs;
  for (std::size_t i = 0; i < tasks.size(); ++i) {
    auto& rows = report[tasks[i] == Task::edges ? "edges" : "surfaces"];
    rows = nlohmann::ordered_json::array();
    for (const Peer& peer : peers[i])
      rows.push_back(toJson(compete(peer, clouds, tasks[i], arguments.jobs)));
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
