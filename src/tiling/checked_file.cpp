// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files that are complete or absent, with a checksum.
//
// The applications' AtomicFile is another thing: it cleans up on signals, follows links
// and keeps permissions. Here the next run removes what a killed one has left.

#include "tiling/checked_file.h"

#include <pcl/tiling/point_source.h>

#include <cerrno>
#include <cstring>
#include <unistd.h>
#include <utility>
#include <zlib.h>

#include <sys/stat.h>

namespace pcl::tiling {
namespace {

[[noreturn]] void
fail(const std::string& path, const std::string& what, int error = errno)
{
  throw TilingError(path + ": cannot be " + what + ": " + std::strerror(error));
}

void
writeTo(std::FILE* file, const std::string& path, const void* data, std::size_t size)
{
  if (std::fwrite(data, 1, size, file) != size)
    fail(path, "written");
}

void
readFrom(std::FILE* file,
         const std::string& path,
         std::uint64_t at,
         void* to,
         std::size_t size)
{
  if (size == 0)
    return;
  if (::fseeko(file, static_cast<off_t>(at), SEEK_SET) != 0)
    fail(path, "read");
  const std::size_t got = std::fread(to, 1, size, file);
  if (got < size && std::ferror(file) != 0)
    fail(path, "read");
  if (got < size)
    throw TilingError(path + ": truncated: " + std::to_string(size - got) +
                      " bytes are missing at its end");
}

/** Some file systems report only here that the disk is full. The checksums detect what
 * is lost if the machine is switched off. */
void
finish(File file, const std::string& path)
{
  if (std::fclose(file.release()) != 0)
    fail(path, "written");
}

} // namespace

File
openFile(const std::string& path, const std::string& mode)
{
  File file(std::fopen(path.c_str(), (mode + 'e').c_str()));
  if (!file)
    fail(path, mode == "r" ? "read" : "written");
  std::setvbuf(file.get(), nullptr, _IONBF, 0);
  return file;
}

std::uint32_t
checksumOf(const void* data, std::size_t size, std::uint32_t before)
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

WholeFile::WholeFile(const std::string& path)
: path_(path)
, temporary_(path + '.' + std::to_string(::getpid()) + ".tmp")
, file_(openFile(temporary_, "w"))
{}

WholeFile::~WholeFile()
{
  if (!temporary_.empty())
    ::unlink(temporary_.c_str());
}

void
WholeFile::write(const void* data, std::size_t size)
{
  if (size == 0)
    return; // without data there may be no place, either
  writeTo(file_.get(), temporary_, data, size);
  size_ += size;
  checksum_ = checksumOf(data, size, checksum_);
}

void
WholeFile::commit()
{
  finish(std::move(file_), temporary_);
  if (std::rename(temporary_.c_str(), path_.c_str()) != 0)
    fail(path_, "written");
  temporary_.clear();
}

Bytes
readWhole(const std::string& path)
{
  const File file = openFile(path, "r"); // before its size is asked for: NFS remembers
  struct stat status {};                 // old ones
  if (::fstat(::fileno(file.get()), &status) != 0)
    fail(path, "read");
  Bytes bytes(static_cast<std::size_t>(status.st_size));
  readFrom(file.get(), path, 0, bytes.data(), bytes.size());
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
  readFrom(openFile(path, "r").get(), path, at, to, size);
}

void
appendTo(const std::string& path, const void* data, std::size_t size)
{
  File file = openFile(path, "a");
  writeTo(file.get(), path, data, size);
  finish(std::move(file), path);
}

std::int64_t
sizeOfFile(const std::string& path)
{
  struct stat status {};
  return ::stat(path.c_str(), &status) == 0 ? static_cast<std::int64_t>(status.st_size)
                                            : -1;
}

} // namespace pcl::tiling
