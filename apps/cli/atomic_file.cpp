// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Writes a file beside its place and renames it; signals remove what is unfinished.

#include "cli/atomic_file.h"

#include "cli/errors.h"
#include "io/text.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>
#include <utility>
#include <vector>

#include <sys/stat.h>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

/** Paths of the temporary files, for the signal handler; a scan with its labels and a
 * report has three. */
std::array<std::atomic<const char*>, 4> pending{};

extern "C" void
removePendingAndEnd(int signal)
{
  for (const auto& path : pending)
    if (const char* const name = path.load())
      ::unlink(name);
  std::signal(signal, SIG_DFL);
  std::raise(signal);
}

void
replacePending(const char* old_value, const char* new_value)
{
  for (auto& path : pending)
    if (const char* expected = old_value;
        path.compare_exchange_strong(expected, new_value))
      return;
}

[[noreturn]] void
fail(const std::string& path, const std::string& why)
{
  throw InputError(path + ": cannot be written: " + why +
                   "; expected a file in a directory that exists and is writable");
}

/** The file without symbolic links. */
std::string
resolve(const std::string& path)
{
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  if (error)
    fail(path, error.message());
  const fs::file_status status = fs::status(resolved, error);
  if (fs::is_directory(status))
    fail(path, "it is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status))
    fail(path, "it is not a regular file");
  if (fs::exists(status) && ::access(resolved.c_str(), W_OK) != 0)
    fail(path, std::strerror(errno));
  return resolved.string();
}

} // namespace

AtomicFile::AtomicFile(const std::string& path)
: path_(path)
, target_(resolve(path))
, temporary_(target_ + '.' + std::to_string(::getpid()) + ".tmp")
{
  constexpr mode_t by_umask = 0666;
  replacePending(nullptr, temporary_.c_str());
  descriptor_ =
      ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, by_umask);
  if (descriptor_ < 0) {
    const std::string why = std::strerror(errno);
    replacePending(temporary_.c_str(), nullptr);
    fail(path_, why);
  }
  if (struct stat old{}; ::stat(target_.c_str(), &old) == 0)
    ::fchmod(descriptor_, old.st_mode & 07777);
}

AtomicFile::~AtomicFile()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (!is_committed_)
    ::unlink(temporary_.c_str());
  replacePending(temporary_.c_str(), nullptr);
}

void
AtomicFile::write(std::string_view contents)
{
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor_, contents.data(), contents.size());
    if (written >= 0)
      contents.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      fail(path_, std::strerror(errno));
  }
}

void
AtomicFile::commit()
{
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0 || std::rename(temporary_.c_str(), target_.c_str()) != 0)
    fail(path_, std::strerror(errno));
  is_committed_ = true;
}

void
requireWritable(const std::string& path)
{
  const AtomicFile probe(path);
}

void
removeOrphans(const std::string& directory)
{
  std::error_code error;
  std::vector<fs::path> orphans;
  for (auto entry = fs::recursive_directory_iterator(directory, error);
       !error && entry != fs::recursive_directory_iterator();
       entry.increment(error)) {
    const fs::path& path = entry->path(); // NAME.PROCESS.tmp
    const auto process =
        parseValue<pid_t>(path.stem().extension().string().erase(0, 1));
    if (path.extension() == ".tmp" && process && *process > 0 &&
        ::kill(*process, 0) != 0 && errno == ESRCH)
      orphans.push_back(path);
    if (entry.depth() > 0)
      entry.disable_recursion_pending();
  }
  for (const fs::path& orphan : orphans)
    fs::remove(orphan, error);
}

void
removeTemporaryFilesOnSignals()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, removePendingAndEnd) == SIG_IGN)
      std::signal(signal, SIG_IGN);
}

} // namespace pcl::app
