// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files that are complete or absent, with a checksum.
//
// The applications' AtomicFile is another thing: it cleans up on signals, follows links
// and keeps permissions. Here the next run removes what a killed one has left.

#include "tiling/checked_file.h"

#include <pcl/tiling/point_source.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>
#include <zlib.h>

#include <sys/stat.h>

namespace pcl::tiling {
namespace {

[[noreturn]] void
fail(const std::string& path, const std::string& what, int error)
{
  throw TilingError(path + ": cannot be " + what + ": " + std::strerror(error));
}

/** A file descriptor that is closed in the end. */
class File {
public:
  File(const std::string& path, int flags) : path_(path)
  {
    constexpr mode_t by_umask = 0666;
    do
      descriptor_ = ::open(path.c_str(), flags | O_CLOEXEC, by_umask);
    while (descriptor_ < 0 && errno == EINTR);
    if (descriptor_ < 0)
      fail(path, (flags & O_ACCMODE) == O_RDONLY ? "read" : "written", errno);
  }
  ~File()
  {
    if (descriptor_ >= 0)
      ::close(descriptor_);
  }
  File(const File&) = delete;
  File& operator=(const File&) = delete;

  void
  write(const void* data, std::size_t size)
  {
    const auto* from = static_cast<const char*>(data);
    while (size > 0) {
      const ssize_t written = ::write(descriptor_, from, size);
      if (written < 0 && errno != EINTR)
        fail(path_, "written", errno);
      if (written > 0) {
        from += written;
        size -= static_cast<std::size_t>(written);
      }
    }
  }

  void
  readAt(std::uint64_t at, void* to, std::size_t size)
  {
    auto* next = static_cast<char*>(to);
    while (size > 0) {
      const ssize_t got = ::pread(descriptor_, next, size, static_cast<off_t>(at));
      if (got < 0 && errno != EINTR)
        fail(path_, "read", errno);
      if (got == 0)
        throw TilingError(path_ + ": truncated: " + std::to_string(size) +
                          " bytes are missing at its end");
      if (got > 0) {
        next += got;
        at += static_cast<std::uint64_t>(got);
        size -= static_cast<std::size_t>(got);
      }
    }
  }

  std::size_t
  size() const
  {
    struct stat status {};
    if (::fstat(descriptor_, &status) != 0)
      fail(path_, "read", errno);
    return static_cast<std::size_t>(status.st_size);
  }

  /** Some file systems report only here that the disk is full. The checksums detect
   * what is lost if the machine is switched off. */
  void
  finish()
  {
    const int closed = ::close(descriptor_);
    descriptor_ = -1;
    if (closed != 0)
      fail(path_, "written", errno);
  }

private:
  std::string path_;
  int descriptor_ = -1;
};

} // namespace

std::uint32_t
checksumOf(const void* data, std::size_t size)
{
  return checksumOf(0, data, size);
}

std::uint32_t
checksumOf(std::uint32_t before, const void* data, std::size_t size)
{
  return static_cast<std::uint32_t>(
      ::crc32_z(before, static_cast<const unsigned char*>(data), size));
}

std::string
toText(std::uint32_t checksum)
{
  char digits[9];
  std::snprintf(digits, sizeof digits, "%08x", checksum);
  return digits;
}

struct WholeFile::State {
  explicit State(const std::string& at)
  : path(at)
  , temporary(at + '.' + std::to_string(::getpid()) + ".tmp")
  , file(temporary, O_WRONLY | O_CREAT | O_TRUNC)
  {}

  std::string path, temporary;
  File file;
  std::uint64_t size = 0;
  std::uint32_t checksum = 0;
  bool is_committed = false;
};

WholeFile::WholeFile(const std::string& path) : state_(std::make_unique<State>(path)) {}

WholeFile::~WholeFile()
{
  if (!state_->is_committed)
    ::unlink(state_->temporary.c_str());
}

void
WholeFile::write(const void* data, std::size_t size)
{
  if (size == 0)
    return;
  state_->file.write(data, size);
  state_->size += size;
  state_->checksum = checksumOf(state_->checksum, data, size);
}

void
WholeFile::commit()
{
  state_->file.finish();
  if (std::rename(state_->temporary.c_str(), state_->path.c_str()) != 0)
    fail(state_->path, "written", errno);
  state_->is_committed = true;
}

std::uint64_t
WholeFile::size() const
{
  return state_->size;
}

std::uint32_t
WholeFile::checksum() const
{
  return state_->checksum;
}

Bytes
readWhole(const std::string& path)
{
  File file(path, O_RDONLY); // before its size is asked for: NFS remembers old ones
  Bytes bytes(file.size());
  file.readAt(0, bytes.data(), bytes.size());
  return bytes;
}

void
failDamaged(const std::string& path)
{
  ::unlink(path.c_str());
  throw TilingError(path + ": was damaged, and is removed; run the same command again "
                           "to make it anew");
}

void
readAt(const std::string& path, std::uint64_t at, void* to, std::size_t size)
{
  File(path, O_RDONLY).readAt(at, to, size);
}

void
appendTo(const std::string& path, const void* data, std::size_t size)
{
  File file(path, O_WRONLY | O_CREAT | O_APPEND);
  file.write(data, size);
  file.finish();
}

std::int64_t
sizeOfFile(const std::string& path)
{
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? static_cast<std::int64_t>(status.st_size)
                                            : -1;
}

} // namespace pcl::tiling
