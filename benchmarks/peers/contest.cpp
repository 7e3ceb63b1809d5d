// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Chooses a peer's setting and threshold, and runs it.

#include "contest.h"

#include <exception>
#include <iostream>
#include <limits>
#include <stdexcept>

namespace peers {
namespace {

using Trials = std::vector<Trial>; ///< of one setting, a cloud each
constexpr std::size_t no_cloud = std::numeric_limits<std::size_t>::max();

struct Choice {
  std::size_t setting = 0;
  float threshold = 0.0f;
};

/** Every cloud with one setting. Exceptions must not leave the parallel region. */
Trials
trialsOf(const Setting& setting,
         const std::vector<LabeledCloud>& clouds,
         Task task,
         int jobs)
{
  Trials trials(clouds.size());
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

std::vector<Trials>
trialsOfAll(const Peer& peer,
            const std::vector<LabeledCloud>& clouds,
            Task task,
            int jobs)
{
  std::vector<Trials> all;
  for (const Setting& setting : peer.settings)
    all.push_back(trialsOf(setting, clouds, task, jobs));
  return all;
}

/** The largest mean F1 over all clouds, or all but one. */
Choice
bestChoice(const Peer& peer,
           const std::vector<Trials>& by_setting,
           std::size_t left_out = no_cloud)
{
  Choice best;
  double best_f1 = -1.0;
  for (std::size_t s = 0; s < by_setting.size(); ++s) {
    std::vector<const Trial*> trials;
    for (std::size_t i = 0; i < by_setting[s].size(); ++i)
      if (i != left_out)
        trials.push_back(&by_setting[s][i]);
    const float threshold = peer.threshold ? *peer.threshold : bestThreshold(trials);
    const double f1 = meanF1(trials, threshold);
    std::cerr << peer.name << ", " << peer.settings[s].text << ": mean F1 " << f1
              << '\n';
    if (f1 > best_f1) {
      best_f1 = f1;
      best = {s, threshold};
    }
  }
  return best;
}

/** A cloud's trial with what was chosen for it. */
void
add(const Peer& peer, const Choice& choice, const Trial& trial, Result& result)
{
  result.settings.push_back(peer.settings[choice.setting].text);
  result.thresholds.push_back(choice.threshold);
  result.trials.push_back(trial);
}

} // namespace

Result
compete(const Peer& peer,
        const std::vector<LabeledCloud>& clouds,
        const Tuning& tuning,
        Task task,
        int jobs)
{
  if (tuning.is_held_out && clouds.size() < 2)
    throw std::invalid_argument(
        "one cloud, and no other to choose settings on: expected at least two");
  Result result{peer.name, !peer.threshold, {}, {}, {}};
  if (tuning.clouds) {
    const Choice choice =
        bestChoice(peer, trialsOfAll(peer, *tuning.clouds, task, jobs));
    for (const Trial& trial :
         trialsOf(peer.settings[choice.setting], clouds, task, jobs))
      add(peer, choice, trial, result);
    return result;
  }
  const std::vector<Trials> all = trialsOfAll(peer, clouds, task, jobs);
  if (!tuning.is_held_out) {
    const Choice choice = bestChoice(peer, all);
    for (const Trial& trial : all[choice.setting])
      add(peer, choice, trial, result);
    return result;
  }
  for (std::size_t i = 0; i < clouds.size(); ++i) {
    const Choice choice = bestChoice(peer, all, i);
    add(peer, choice, all[choice.setting][i], result);
  }
  return result;
}

} // namespace peers
