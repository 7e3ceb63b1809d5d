/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace pcl::tiling {

/** \brief Who works on tiles: one process, several, or the ranks of MPI. With ranks all
 * of them make the same calls. */
class Team {
public:
  /** \brief What a process does for one task; an exception is reported, and the other
   * tasks continue. */
  using Work = std::function<std::string(std::size_t task)>;

  /** \brief Called in the first process, for each task as it ends. \param[in] error
   * empty if there was none */
  using Report = std::function<void(
      std::size_t task, const std::string& result, const std::string& error)>;

  virtual ~Team() = default;

  /** \brief Whether this is the process that decides, and writes the manifest. */
  virtual bool
  isFirst() const
  {
    return true;
  }

  /** \brief Do the tasks, in the order of the list. */
  virtual void run(const std::vector<std::size_t>& tasks,
                   const Work& work,
                   const Report& report) = 0;

  /** \brief Wait until all ranks are here. */
  virtual void
  meet()
  {}
};

/** \brief How a task has ended. */
struct Outcome {
  std::string result; ///< what the work has returned
  std::string error;  ///< empty if there was none
};

/** \brief Do a task, for classes of teams. \param[in] work to be done \param[in] task
 * its number \return an exception as an error */
Outcome outcomeOf(const Team::Work& work, std::size_t task);

/** \brief One process, this one, or more that are started for each run. If one is
 * killed, its task fails. To start some the caller must not have used OpenMP before. */
std::unique_ptr<Team> makeTeam(std::size_t processes = 1);

} // namespace pcl::tiling
