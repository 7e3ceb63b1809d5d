// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Files read as a whole, and files that are written complete or not at all.

#include "io/files.h"

#include "io/errors.h"
#include "io/text.h"

#include <array>
#include <atomic>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <random>
#include <system_error>
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

struct EndingSignal {
  int number;
  const char* message; ///< prepared: a handler may not compose one
};

#define PCL_SHAPE_ENDED_BY(NAME, WHY)                                                  \
  {                                                                                    \
    NAME, "ended by " #NAME WHY "; unfinished output was removed\n"                    \
  }

constexpr EndingSignal ending_signals[] = {
    PCL_SHAPE_ENDED_BY(SIGINT, ""),
    PCL_SHAPE_ENDED_BY(SIGTERM, ""),
    PCL_SHAPE_ENDED_BY(SIGHUP, ""),
    PCL_SHAPE_ENDED_BY(SIGQUIT, ""),
    PCL_SHAPE_ENDED_BY(SIGPIPE, ", nobody reads the output"),
    PCL_SHAPE_ENDED_BY(SIGXCPU, ", the limit of processor time"),
    PCL_SHAPE_ENDED_BY(SIGXFSZ, ", the limit of the size of files")};

#undef PCL_SHAPE_ENDED_BY

extern "C" void
removePendingAndEnd(int signal)
{
  for (const auto& path : pending)
    if (const char* const name = path.load())
      ::unlink(name);
  for (const EndingSignal& ending : ending_signals)
    if (ending.number == signal) {
      // If this fails, nobody is left to be told.
      const ssize_t written =
          ::write(STDERR_FILENO, ending.message, std::strlen(ending.message));
      static_cast<void>(written);
    }
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
failToWrite(const std::string& path, const std::string& why)
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
    failToWrite(path, error.message());
  const fs::file_status status = fs::status(resolved, error);
  if (fs::is_directory(status))
    failToWrite(path, "it is a directory");
  if (fs::exists(status) && !fs::is_regular_file(status))
    failToWrite(path, "it is not a regular file");
  if (fs::exists(status) && ::access(resolved.c_str(), W_OK) != 0)
    failToWrite(path, std::strerror(errno));
  return resolved.string();
}

/** Keeps signals from this thread while a file exists that the handler does not know.
 */
class BlockedSignals {
public:
  BlockedSignals()
  {
    sigset_t all;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &old_);
  }
  ~BlockedSignals() { pthread_sigmask(SIG_SETMASK, &old_, nullptr); }
  BlockedSignals(const BlockedSignals&) = delete;
  BlockedSignals& operator=(const BlockedSignals&) = delete;

private:
  sigset_t old_{};
};

/** \return the number of the error, or 0 */
int
writeAll(int descriptor, std::string_view contents)
{
  while (!contents.empty()) {
    const ssize_t written = ::write(descriptor, contents.data(), contents.size());
    if (written >= 0)
      contents.remove_prefix(static_cast<std::size_t>(written));
    else if (errno != EINTR)
      return errno;
  }
  return 0;
}

/** TARGET.RANDOM.PROCESS.tmp. In a container every process may be number 1: the number
 * alone would be that of the process which was killed before. */
std::string
temporaryName(const std::string& target)
{
  std::random_device random;
  constexpr unsigned digits = 36; // and small letters
  constexpr int length = 8;       // 10^12 names
  std::string word;
  for (int i = 0; i < length; ++i)
    word += "0123456789abcdefghijklmnopqrstuvwxyz"[random() % digits];
  return target + '.' + word + '.' + std::to_string(::getpid()) + ".tmp";
}

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

AtomicFile::AtomicFile(const std::string& path) : path_(path)
{
  if (path_ == standard_stream)
    return;
  target_ = resolve(path_);
  constexpr mode_t by_umask = 0666;
  constexpr int max_attempts = 100;
  for (int attempt = 0; descriptor_ < 0; ++attempt) {
    temporary_ = temporaryName(target_);
    const BlockedSignals blocked;
    descriptor_ =
        ::open(temporary_.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, by_umask);
    if (descriptor_ >= 0)
      replacePending(nullptr, temporary_.c_str());
    else if (errno != EINTR && (errno != EEXIST || attempt >= max_attempts))
      failToWrite(path_, std::strerror(errno));
  }
  if (struct stat old{}; ::stat(target_.c_str(), &old) == 0)
    ::fchmod(descriptor_, old.st_mode & 07777);
}

AtomicFile::~AtomicFile()
{
  if (temporary_.empty())
    return;
  if (descriptor_ >= 0)
    ::close(descriptor_);
  if (!is_committed_)
    ::unlink(temporary_.c_str());
  replacePending(temporary_.c_str(), nullptr);
}

void
AtomicFile::write(std::string_view contents)
{
  if (temporary_.empty())
    for_standard_output_ += contents;
  else if (const int error = writeAll(descriptor_, contents))
    failToWrite(path_, std::strerror(error));
}

void
AtomicFile::commit()
{
  if (temporary_.empty()) {
    if (const int error = writeAll(STDOUT_FILENO, for_standard_output_))
      throw InputError(std::string("standard output: cannot be written: ") +
                       std::strerror(error));
    for_standard_output_.clear();
    return;
  }
  const int closed = ::close(std::exchange(descriptor_, -1));
  if (closed != 0 || std::rename(temporary_.c_str(), target_.c_str()) != 0)
    failToWrite(path_, std::strerror(errno));
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
    const fs::path& path = entry->path(); // NAME.RANDOM.PROCESS.tmp
    const auto process =
        parseValue<pid_t>(path.stem().extension().string().erase(0, 1));
    if (path.extension() == ".tmp" && process && *process > 0 &&
        (*process == ::getpid() || (::kill(*process, 0) != 0 && errno == ESRCH)))
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
  for (const EndingSignal& ending : ending_signals)
    if (std::signal(ending.number, removePendingAndEnd) == SIG_IGN)
      std::signal(ending.number, SIG_IGN);
}

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
