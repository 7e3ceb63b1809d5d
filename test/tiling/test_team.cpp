// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Processes that share tasks.

#include <pcl/tiling/point_source.h>
#include <pcl/tiling/team.h>

#include <gtest/gtest.h>

#include <csignal>
#include <map>
#include <set>
#include <unistd.h>

namespace {

using namespace pcl::tiling;

std::map<std::size_t, std::string>
outcomes(Team& team, const std::vector<std::size_t>& tasks, const Team::Work& work)
{
  std::map<std::size_t, std::string> found;
  team.run(
      tasks, work, [&](std::size_t task, const std::string& result, const auto& error) {
        EXPECT_EQ(found.count(task), 0U);
        found[task] = error.empty() ? result : "error: " + error;
      });
  return found;
}

TEST(Team, DoesEachTaskOnce)
{
  const std::vector<std::size_t> tasks{5, 3, 8, 1, 0, 9, 7};
  for (const std::size_t processes : {1U, 2U, 4U, 20U}) {
    const auto found = outcomes(*makeTeam(processes), tasks, [](std::size_t task) {
      return std::string(task * 100000, 'x'); // more than a pipe holds
    });
    ASSERT_EQ(found.size(), tasks.size());
    for (const auto& [task, result] : found)
      EXPECT_EQ(result.size(), task * 100000);
  }
}

TEST(Team, WorksInSeveralProcesses)
{
  std::set<std::string> processes;
  const auto found = outcomes(*makeTeam(3), {0, 1, 2, 3, 4, 5}, [](std::size_t) {
    ::usleep(50000);
    return std::to_string(::getpid());
  });
  for (const auto& [task, process] : found)
    processes.insert(process);
  EXPECT_EQ(processes.size(), 3U);
  EXPECT_EQ(processes.count(std::to_string(::getpid())), 0U);
}

TEST(Team, ReportsErrorsAndGoesOn)
{
  for (const std::size_t processes : {1U, 2U}) {
    const auto found =
        outcomes(*makeTeam(processes), {0, 1, 2, 3}, [](std::size_t task) {
          if (task == 1)
            throw TilingError("no luck");
          return std::string("done");
        });
    EXPECT_EQ(found.at(1), "error: no luck");
    EXPECT_EQ(found.at(3), "done");
  }
}

TEST(Team, ReplacesAProcessThatIsKilled)
{
  const auto found = outcomes(*makeTeam(2), {0, 1, 2, 3, 4, 5}, [](std::size_t task) {
    if (task < 3)
      ::kill(::getpid(), SIGKILL);
    return std::string("done");
  });
  ASSERT_EQ(found.size(), 6U);
  EXPECT_NE(found.at(0).find("signal 9"), std::string::npos) << found.at(0);
  EXPECT_EQ(found.at(5), "done");
}

TEST(Team, NeedsAProcess) { EXPECT_THROW(makeTeam(0), TilingError); }

} // namespace
