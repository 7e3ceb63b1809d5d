/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "atomic_file.h"

#include "errors.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <unistd.h>

#include <sys/stat.h>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

constexpr std::size_t max_pending = 4;

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

} // namespace

AtomicFile::AtomicFile(const std::string& path)
: path_(path)
, target_(resolve(path))
, temporary_(target_ + '.' + std::to_string(::getpid()) + ".tmp")
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
removeTemporaryFilesOnSignals()
{
  for (const int signal : {SIGINT, SIGTERM, SIGHUP})
    if (std::signal(signal, removePendingAndEnd) == SIG_IGN)
      std::signal(signal, SIG_IGN);
}

} // namespace pcl::app
