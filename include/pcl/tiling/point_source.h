/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <stdexcept>
#include <string>

namespace pcl::tiling {

/** \brief x, y and z, meters. */
using Position = std::array<double, 3>;

/** \brief What is wrong with a directory of tiles, an input, or a setting. */
class TilingError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief A cloud that need not fit into memory. */
class PointSource {
public:
  virtual ~PointSource() = default;

  /** \brief The name of the cloud, for messages and to find it again. */
  virtual std::string name() const = 0;

  /** \brief Text that changes when the cloud does, such as its size and date. */
  virtual std::string state() const = 0;

  /** \brief In how many sections the cloud can be read, at the same time by several
   * processes: always the same number, at least one. */
  virtual std::size_t
  countSections() const
  {
    return 1;
  }

  /** \brief Takes some points at a time, not all of a large cloud: memory grows with
   * them. */
  using Use = std::function<void(const Position* points, std::size_t count)>;

  /** \brief Gives the points of a section, the same each time. Those of all sections,
   * one after the other, are the cloud in its order. \param[in] section from 0 to
   * countSections() - 1 \param[in] use takes them */
  virtual void readSection(std::size_t section, const Use& use) const = 0;
};

} // namespace pcl::tiling
