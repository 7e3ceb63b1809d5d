// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A directory that one run at a time has to itself, and the names of its files.

#pragma once

#include "tiling/checked_file.h"

#include <cstddef>
#include <string>

namespace pcl::tiling {

/** \brief Where the file of a tile or a section is. */
std::string
filePath(const std::string& directory, const std::string& name, std::size_t number);

std::string manifestPath(const std::string& directory);

/** \brief With its parents. \throws TilingError */
void makeDirectory(const std::string& path);

/** \brief A directory with a manifest and one directory for each name of files; nothing
 * else in it is ever removed. All methods throw a TilingError. */
class OwnDirectory {
public:
  /** \brief Creates the directory unless it exists. Removes files that a killed run has
   * not renamed. */
  explicit OwnDirectory(const std::string& path);

  /** \brief Remove the files of a name. */
  void removeFilesOf(const std::string& name) const;

  /** \brief Remove what is left when no name has files: the manifest is the last to go,
   * so that a directory is known until it is empty. */
  void remove();

private:
  std::string path_;
  File lock_;
};

} // namespace pcl::tiling
