// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is complete in a directory of tiles: one line of JSON for each step.

#pragma once

#include <pcl/tiling/point_source.h>

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

/** \brief Calls use(). \throws TilingError if it finds other values in the manifest's
 * records than it looks for */
template <typename Use>
void
useRecords(const std::string& path, const Use& use)
{
  try {
    use();
  }
  catch (const Manifest::Record::exception& error) {
    throw TilingError(path + ": has an unknown record (" + error.what() +
                      "); expected a manifest of this version");
  }
}

} // namespace pcl::tiling
