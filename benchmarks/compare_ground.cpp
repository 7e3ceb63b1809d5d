// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The ground in generated streets, beside RANSAC and a morphological filter.

#include "common/measure.h"
#include "ground/methods.h"

#include <nlohmann/json.hpp>

#include <iostream>

// The ground in generated streets: this library beside a plane by RANSAC and a
// progressive morphological filter. These may choose the best of their settings for
// these very streets; this library has none.
namespace {

namespace po = boost::program_options;
using namespace ground;
using Json = nlohmann::ordered_json;

struct Arguments {
  std::uint64_t seed = 101;
  unsigned streets = 10;
  unsigned slow_streets = 3; ///< for the morphological filter
  std::vector<unsigned> beams{64, 16};
  unsigned threads = 1;
  unsigned repeat = 7;
};

struct Contender {
  std::string name;
  Setting setting;
  std::size_t streets; ///< the first ones
  unsigned repeat;
  std::vector<Score> scores;
  std::vector<std::vector<double>> times; ///< street by street, milliseconds
};

/** Prints the help and returns false if that is asked for. */
bool
parseArguments(int argc, char** argv, Arguments& a)
{
  po::options_description options("compare_ground [options]");
  options.add_options()("seed", po::value(&a.seed), "of the first street (101)")(
      "streets", po::value(&a.streets), "for each number of beams (10)")(
      "slow_streets",
      po::value(&a.slow_streets),
      "of them for the morphological filter, which is slow; 0 leaves it out (3)")(
      "beams", po::value(&a.beams)->multitoken(), "64, 16 (both)")(
      "threads", po::value(&a.threads), "(1)")(
      "repeat", po::value(&a.repeat), "runs of each, in turns (7)")("help", "this");
  if (!parseCommandLine(argc, argv, options))
    return false;
  if (a.streets == 0 || a.threads == 0 || a.repeat == 0 || a.slow_streets > a.streets)
    throw std::invalid_argument("at least 1 street, thread and run are needed, and no "
                                "more slow streets than streets");
  return true;
}

double
meanF1(const std::vector<Score>& scores)
{
  double sum = 0.0;
  for (const Score& score : scores)
    sum += score.f1;
  return sum / static_cast<double>(scores.size());
}

/** The setting with the best mean F1. */
Contender
best(const Method& method,
     const std::vector<Street>& streets,
     std::size_t count,
     unsigned repeat)
{
  Contender winner;
  for (const Setting& setting : method.settings) {
    Contender contender{method.name, setting, count, repeat, {}, {}};
    for (std::size_t i = 0; i < count; ++i)
      contender.scores.push_back(scoreOf(streets[i], setting.find(streets[i].points)));
    std::cerr << method.name << ", " << setting.text << ": mean F1 "
              << meanF1(contender.scores) << std::endl;
    if (winner.scores.empty() || meanF1(contender.scores) > meanF1(winner.scores))
      winner = std::move(contender);
  }
  winner.times.resize(count);
  return winner;
}

/** In turns, so that what else the machine does is the same for all. */
void
measure(std::vector<Contender>& contenders,
        const std::vector<Street>& streets,
        unsigned repeat)
{
  for (std::size_t i = 0; i < streets.size(); ++i)
    for (unsigned turn = 0; turn < repeat; ++turn)
      for (Contender& contender : contenders)
        if (i < contender.streets && turn < contender.repeat)
          contender.times[i].push_back(
              millisecondsOf([&] { contender.setting.find(streets[i].points); }));
}

Json
toJson(const Contender& contender, const std::vector<Street>& streets)
{
  Json clouds = Json::array();
  std::vector<double> times;
  Score mean;
  double worst = 1.0;
  const auto count = static_cast<double>(contender.scores.size());
  for (std::size_t i = 0; i < contender.scores.size(); ++i) {
    const Score& score = contender.scores[i];
    times.push_back(median(contender.times[i]));
    mean.f1 += score.f1 / count;
    mean.precision += score.precision / count;
    mean.recall += score.recall / count;
    worst = std::min(worst, score.f1);
    clouds.push_back({{"seed", streets[i].seed},
                      {"points", streets[i].points->size()},
                      {"f1", score.f1},
                      {"precision", score.precision},
                      {"recall", score.recall},
                      {"ms", times.back()}});
  }
  return {{"method", contender.name},
          {"setting", contender.setting.text},
          {"streets", contender.streets},
          {"f1", mean.f1},
          {"worst_f1", worst},
          {"precision", mean.precision},
          {"recall", mean.recall},
          {"ms", median(times)},
          {"clouds", clouds}};
}

Json
compare(const Arguments& arguments, unsigned beams)
{
  std::vector<Street> streets;
  for (unsigned i = 0; i < arguments.streets; ++i)
    streets.push_back(generateStreet(beams, arguments.seed + i));
  std::vector<Contender> contenders;
  contenders.push_back(
      best(ownMethod(arguments.threads), streets, streets.size(), arguments.repeat));
  contenders.push_back(
      best(planeMethod(arguments.threads), streets, streets.size(), arguments.repeat));
  if (arguments.slow_streets > 0)
    contenders.push_back(
        best(morphologicalMethod(), streets, arguments.slow_streets, 1));
  measure(contenders, streets, arguments.repeat);
  Json methods = Json::array();
  for (const Contender& contender : contenders)
    methods.push_back(toJson(contender, streets));
  return {{"beams", beams}, {"methods", methods}};
}

int
runComparison(int argc, char** argv)
{
  Arguments arguments;
  if (!parseArguments(argc, argv, arguments))
    return 0;
  Json report{{"threads", arguments.threads},
              {"repeat", arguments.repeat},
              {"seed", arguments.seed},
              {"streets", arguments.streets}};
  for (const unsigned beams : arguments.beams)
    report["sensors"].push_back(compare(arguments, beams));
  std::cout << report.dump() << std::endl;
  return 0;
}

} // namespace

int
main(int argc, char** argv)
{
  return runProgram("compare_ground", runComparison, argc, argv);
}
