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

/** \brief This process alone. */
std::unique_ptr<Team> makeTeam();

/** \brief Processes that are started for each run. If one is killed, its task fails.
 * The caller must not have used OpenMP before. */
std::unique_ptr<Team> makeTeam(std::size_t processes);

} // namespace pcl::tiling
