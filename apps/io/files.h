// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files read as a whole, and files that are written complete or not at all.

#pragma once

#include <string>
#include <string_view>

namespace pcl::app {

/** \brief A file that appears complete or not at all.
 *
 * The contents go to a temporary file beside it, which commit() renames. Without
 * commit() nothing is left, and a file that was there stays as it was. For the path "-"
 * commit() writes to standard output. All methods throw an InputError that names the
 * path.
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
  std::string for_standard_output_;
};

/** \brief \throws InputError if a file cannot be written at the path */
void requireWritable(const std::string& path);

/** \brief Remove the temporary files that killed processes left in a directory and its
 * subdirectories. A file with this process's number counts as one of them: call it
 * before the first AtomicFile. */
void removeOrphans(const std::string& directory);

/** \brief On each signal that ends a process and can be caught (SIGINT, SIGTERM,
 * SIGHUP, SIGQUIT, SIGPIPE, SIGXCPU, SIGXFSZ) remove the temporary files, report that
 * on standard error, and end as usual. */
void removeTemporaryFilesOnSignals();

/** \brief The path that stands for standard input, or standard output. */
constexpr const char* standard_stream = "-";

/** \brief All bytes of a regular file, of a pipe, or of standard input. \param[in]
 * expected what the file should be, for messages, such as "a PCD file" \throws
 * InputError that names the path */
std::string readFile(const std::string& path, const std::string& expected);

} // namespace pcl::app
