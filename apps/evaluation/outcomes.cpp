// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "evaluation/outcomes.h"

namespace pcl::app {
namespace {

Outcome
outcomeOf(const LabelPair& point, std::uint32_t label)
{
  if (point.truth == label)
    return point.predicted == label ? Outcome::hit : Outcome::miss;
  return point.predicted == label ? Outcome::false_alarm : Outcome::rightly_not;
}

} // namespace

std::vector<std::uint32_t>
outcomesOf(const TaskPoints& selected, std::size_t points)
{
  std::vector<std::uint32_t> outcomes(points,
                                      static_cast<std::uint32_t>(Outcome::left_out));
  const std::uint32_t label = selected.classes.front().label;
  for (std::size_t p = 0; p < selected.points.size(); ++p)
    outcomes[selected.indices[p]] =
        static_cast<std::uint32_t>(outcomeOf(selected.points[p], label));
  return outcomes;
}

} // namespace pcl::app
