// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A directory that one run at a time has to itself, and the names of its files.

#include "tiling/own_directory.h"

#include <pcl/tiling/point_source.h>

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <regex>
#include <unistd.h>
#include <vector>

#include <sys/file.h>
#include <sys/stat.h>

namespace fs = std::filesystem;

namespace pcl::tiling {
namespace {

const std::string manifest_name = "manifest.jsonl", lock_name = "lock";

/** A run that ends after the file was opened removes it: the lock is then on a file
 * that nobody else finds. */
bool
isStillAt(const std::string& path, int descriptor)
{
  struct stat locked {
  }, there{};
  return ::fstat(descriptor, &locked) == 0 && ::stat(path.c_str(), &there) == 0 &&
         locked.st_ino == there.st_ino && locked.st_dev == there.st_dev;
}

std::vector<fs::path>
entriesOf(const std::string& directory)
try {
  return {fs::directory_iterator(directory), {}};
}
catch (const fs::filesystem_error& error) {
  throw TilingError(directory + ": cannot be read: " + error.code().message());
}

bool
isThere(const std::string& path)
{
  std::error_code error;
  return fs::exists(fs::symlink_status(path, error));
}

/** A directory with other files belongs to somebody else: nothing there may be removed.
 */
void
requireOwn(const std::string& directory)
{
  const std::vector<fs::path> entries = entriesOf(directory);
  if (!isThere(manifestPath(directory)) &&
      std::any_of(entries.begin(), entries.end(), [](const fs::path& entry) {
        return entry.filename() != lock_name;
      }))
    throw TilingError(directory +
                      ": holds other files; expected a new or empty directory");
}

void
removeFile(const fs::path& path)
{
  std::error_code error;
  fs::remove(path, error);
  if (error)
    throw TilingError(path.string() + ": cannot be removed: " + error.message());
}

/** By its name: 000012.bin, or 000012.bin.345.tmp while process 345 writes it. */
bool
isOfTile(const fs::path& file)
{
  static const std::regex names("[0-9]{6,}\\.bin(\\.[0-9]+\\.tmp)?");
  return std::regex_match(file.filename().string(), names);
}

void
removeUnfinished(const std::string& directory)
{
  for (const fs::path& entry : entriesOf(directory))
    if (std::error_code error; fs::is_directory(fs::symlink_status(entry, error)))
      for (const fs::path& file : entriesOf(entry.string()))
        if (isOfTile(file) && file.extension() == ".tmp")
          removeFile(file);
}

/** Against other runs; the lock ends with the process. */
File
lockedFile(const std::string& path)
{
  const std::string directory = fs::path(path).parent_path().string();
  // The processes of a run that was killed a moment ago may take that long to end.
  constexpr int attempts = 20;
  constexpr useconds_t pause = 100000; // microseconds
  for (int attempt = 0;; ++attempt) {
    File file = openFile(path, "a");
    if (::flock(::fileno(file.get()), LOCK_EX | LOCK_NB) == 0) {
      if (isStillAt(path, ::fileno(file.get())))
        return file;
    }
    else if (errno != EWOULDBLOCK)
      throw TilingError(directory + ": cannot be locked: " + std::strerror(errno));
    file.reset();
    if (attempt == attempts)
      throw TilingError(directory + ": another run is using it; expected to be alone");
    ::usleep(pause);
  }
}

} // namespace

std::string
filePath(const std::string& directory, const std::string& name, std::size_t number)
{
  char file[32];
  std::snprintf(file, sizeof file, "/%06zu.bin", number);
  return directory + '/' + name + file;
}

std::string
manifestPath(const std::string& directory)
{
  return directory + '/' + manifest_name;
}

void
makeDirectory(const std::string& path)
{
  std::error_code error;
  fs::create_directories(path, error);
  if (error)
    throw TilingError(path + ": cannot be made: " + error.message());
}

OwnDirectory::OwnDirectory(const std::string& path) : path_(path)
{
  makeDirectory(path);
  requireOwn(path);
  lock_ = lockedFile(path + '/' + lock_name);
  removeUnfinished(path);
}

void
OwnDirectory::removeFilesOf(const std::string& name) const
{
  const std::string directory = path_ + '/' + name;
  if (!isThere(directory))
    return;
  for (const fs::path& file : entriesOf(directory))
    if (isOfTile(file))
      removeFile(file);
  removeFile(directory);
}

void
OwnDirectory::remove()
{
  removeFile(manifestPath(path_));
  removeFile(path_ + '/' + lock_name);
  lock_.reset(); // NFS keeps a removed file in its directory until it is closed
  removeFile(path_);
}

} // namespace pcl::tiling
