// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads a file, a pipe or standard input, or says what is there instead.

#include "cli/read_file.h"

#include "cli/errors.h"

#include <cerrno>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <system_error>
#include <unistd.h>

namespace fs = std::filesystem;

namespace pcl::app {
namespace {

/** Until the end, which a pipe does not say before. */
std::string
readDescriptor(int descriptor)
{
  constexpr std::size_t block = std::size_t{1} << 20; // few calls, little memory
  std::string contents;
  for (std::size_t size = 0;;) {
    contents.resize(size + block);
    const ssize_t count = ::read(descriptor, contents.data() + size, block);
    if (count < 0 && errno == EINTR)
      continue;
    if (count < 0)
      throw std::system_error(errno, std::generic_category());
    size += static_cast<std::size_t>(count);
    if (count == 0) {
      contents.resize(size);
      return contents;
    }
  }
}

} // namespace

std::string
readFile(const std::string& path, const std::string& expected)
{
  const auto bad = [&](const std::string& what, const char* readable = "") {
    return InputError(path + ": " + what + "; expected " + readable + expected);
  };
  if (path == standard_stream) {
    try {
      return readDescriptor(STDIN_FILENO);
    }
    catch (const std::system_error& failure) {
      throw InputError("standard input: " + failure.code().message() + "; expected " +
                       expected);
    }
  }
  std::error_code error;
  const fs::file_status status = fs::status(path, error);
  if (!fs::exists(status))
    throw bad(error ? error.message() : "no such file");
  if (fs::is_fifo(status)) {
    std::ifstream pipe(path, std::ios::binary);
    std::string contents{std::istreambuf_iterator<char>(pipe), {}};
    if (!pipe.is_open() || pipe.bad())
      throw bad("reading failed", "a readable pipe: ");
    return contents;
  }
  if (!fs::is_regular_file(status))
    throw bad(fs::is_directory(status) ? "is a directory" : "is not a regular file");
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw bad(std::strerror(errno), "a readable file: ");
  std::string contents(fs::file_size(path), '\0');
  stream.read(contents.data(), static_cast<std::streamsize>(contents.size()));
  if (!stream)
    throw bad("reading failed", "a readable file: ");
  return contents;
}

} // namespace pcl::app
