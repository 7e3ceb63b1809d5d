// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "cli/atomic_file.h"

#include "cli/errors.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <optional>
#include <unistd.h>
#include <vector>

#include <sys/stat.h>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

constexpr std::size_t max_pending = 4;
constexpr const char* temporary_ending = ".tmp";

/** Paths of the temporary files, for the signal handler. */
std::array<std::atomic<const char*>, max_pending> pending{};

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
  for (auto& path : pending) {
    const char* expected = old_value;
    if (path.compare_exchange_strong(expected, new_value))
      return;
  }
}

std::string
cannotWrite(const std::string& path, const std::string& why)
{
  return path + ": cannot be written: " + why +
         "; allowed is a file in a directory that exists and is writable";
}

std::string
resolve(const std::string& path)
{
  std::error_code error;
  const fs::path resolved = fs::weakly_canonical(path, error);
  if (error)
    throw InputError(cannotWrite(path, error.message()));
  const fs::file_status status = fs::status(resolved, error);
  if (fs::is_directory(status))
    throw InputError(cannotWrite(path, "it is a directory"));
  if (fs::exists(status) && !fs::is_regular_file(status))
    throw InputError(cannotWrite(path, "it is not a regular file"));
  if (fs::exists(status) && ::access(resolved.c_str(), W_OK) != 0)
    throw InputError(cannotWrite(path, std::strerror(errno)));
  return resolved.string();
}

/** The process whose temporary file has this name, if it is one's name. */
std::optional<pid_t>
processOf(const fs::path& path)
{
  if (path.extension() != temporary_ending || !path.stem().has_extension())
    return std::nullopt;
  const std::string digits = path.stem().extension().string().substr(1);
  pid_t process = 0;
  const char* const end = digits.data() + digits.size();
  const auto [stop, error] = std::from_chars(digits.data(), end, process);
  return error == std::errc() && stop == end && process > 0
             ? std::optional<pid_t>(process)
             : std::nullopt;
}

} // namespace

AtomicFile::AtomicFile(const std::string& path)
: path_(path)
, target_(resolve(path))
, temporary_(target_ + '.' + std::to_string(::getpid()) + temporary_ending)
{
  replacePending(nullptr, temporary_.c_str());
  constexpr mode_t by_umask = 0666;
  descriptor_ =
      ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, by_umask);
  if (descriptor_ < 0) {
    const std::string why = std::strerror(errno);
    replacePending(temporary_.c_str(), nullptr);
    throw InputError(cannotWrite(path_, why));
  }
  struct stat old {};
  if (::stat(target_.c_str(), &old) == 0)
    ::fchmod(descriptor_, old.st_mode & 07777);
}

AtomicFile::~AtomicFile()
{
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
  replacePending(temporary_.c_str(), nullptr);
}

void
AtomicFile::write(std::string_view contents)
{
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor_, contents.data(), contents.size());
    if (written < 0 && errno == EINTR)
      continue;
    if (written < 0)
      throw InputError(cannotWrite(path_, std::strerror(errno)));
    contents.remove_prefix(static_cast<std::size_t>(written));
  }
}

void
AtomicFile::commit()
{
  const int closed = ::close(descriptor_);
  descriptor_ = -1;
  if (closed != 0 || std::rename(temporary_.c_str(), target_.c_str()) != 0)
    throw InputError(cannotWrite(path_, std::strerror(errno)));
  replacePending(temporary_.c_str(), nullptr);
  temporary_.clear();
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
    const auto process = processOf(entry->path());
    if (process && ::kill(*process, 0) != 0 && errno == ESRCH)
      orphans.push_back(entry->path());
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
