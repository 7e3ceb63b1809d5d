// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Output files that are complete or not there at all.

#pragma once

#include <string>
#include <string_view>

namespace pcl::app {

/** \brief A file that appears complete or not at all.
 *
 * The contents go to a temporary file beside it, which commit() renames. Without
 * commit() nothing is left, and a file that was there stays as it was. All methods
 * throw an InputError that names the path.
 */
class AtomicFile {
public:
  explicit AtomicFile(const std::string& path);
  ~AtomicFile();
  AtomicFile(const AtomicFile&) = delete;
  AtomicFile& operator=(const AtomicFile&) = delete;

  void write(std::string_view contents);

  void commit();

private:
  std::string path_;   ///< as given, for messages
  std::string target_; ///< without symbolic links
  std::string temporary_;
  int descriptor_ = -1;
  bool is_committed_ = false;
};

/** \brief \throws InputError if a file cannot be written at the path */
void requireWritable(const std::string& path);

/** \brief Remove the temporary files in a directory, and in the directories there,
 * whose process was killed. */
void removeOrphans(const std::string& directory);

/** \brief On SIGINT, SIGTERM and SIGHUP remove the temporary file, then end as usual.
 */
void removeTemporaryFilesOnSignals();

} // namespace pcl::app
