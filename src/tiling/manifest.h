// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is complete in a directory of tiles: one line of JSON for each step.

#pragma once

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace pcl::tiling {

/** \brief The lines of a manifest, each with its checksum. A line that a killed run
 * left unfinished is ignored; any other damage is an error. */
class Manifest {
public:
  using Record = nlohmann::ordered_json;

  /** \brief Reads the file if there is one. \param[in] repairs whether an unfinished
   * line is cut off; one process may \throws TilingError */
  Manifest(const std::string& path, bool repairs);

  /** \brief Append a record, in one write. */
  void add(const Record& record);

  const std::vector<Record>&
  records() const
  {
    return records_;
  }

private:
  std::string path_;
  std::vector<Record> records_;
};

} // namespace pcl::tiling
