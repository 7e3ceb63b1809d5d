// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A cloud file of any size, some points at a time.

#pragma once

#include "io/any_cloud.h"
#include "io/cloud_file.h"
#include "io/pcd.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <string>

namespace pcl::app {

/** \brief Reads a cloud from its first point to the last, in bounded memory: PCD that
 * is not compressed, and PLY whose points come first, as text or little-endian without
 * lists. Other files are read as a whole. */
class CloudStream {
public:
  /** \brief Reads the header. \param[in] floats as for readAnyCloud()
   * \throws InputError as readAnyCloud() does */
  explicit CloudStream(const std::string& path, unsigned floats = 0);

  /** \brief All but the points, as they are in parts: with PCL's names. */
  const CloudFile&
  description() const
  {
    return description_;
  }

  std::uint64_t
  size() const
  {
    return std::uint64_t{description_.blob.width} * description_.blob.height;
  }

  /** \brief Whether the file is read as a whole. */
  bool
  isInMemory() const
  {
    return !rows_;
  }

  /** \brief Size and date of the file, now. */
  std::string state() const;

  /** \brief How many sections of the points can be read without those before them: of
   * binary points some, of others one. */
  std::size_t countSections() const;

  using UsePart = std::function<void(CloudFile& part)>;
  using UsePositions =
      std::function<void(const std::array<double, 3>* points, std::size_t count)>;

  /** \brief Give the points of a section in their order, in clouds of one row, with all
   * fields. \throws InputError for what is wrong with them */
  void forEachPart(std::size_t section, const UsePart& use) const;

  /** \brief The same for x, y and z alone: of packed bytes nothing else is looked at.
   * \throws InputError unless they are single values */
  void forEachPosition(std::size_t section, const UsePositions& use) const;

  /** \brief Those of all sections. */
  void forEachPosition(const UsePositions& use) const;

private:
  /** The points of a section. */
  struct Range {
    std::uint64_t begin = 0, end = 0;
  };

  Range rangeOf(std::size_t section) const;
  void finish(CloudFile& part) const;

  std::string path_;
  unsigned floats_;
  CloudFormat format_ = CloudFormat::pcd;
  std::optional<PointRows> rows_;
  CloudFile description_;
};

} // namespace pcl::app
