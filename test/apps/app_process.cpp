// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs programs and keeps what they print.

#include "app_process.h"

#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <spawn.h>
#include <stdexcept>
#include <thread>
#include <unistd.h>

#include <sys/wait.h>

extern char** environ;

namespace pcl_shape_test {
namespace {

/** An unnamed file that receives what a process prints. */
class Capture {
public:
  Capture() : file_(std::tmpfile())
  {
    if (!file_)
      throw std::runtime_error("no temporary file for the output of a process");
  }

  ~Capture() { std::fclose(file_); }
  Capture(const Capture&) = delete;
  Capture& operator=(const Capture&) = delete;

  int
  descriptor() const
  {
    return fileno(file_);
  }

  std::string
  contents() const
  {
    std::rewind(file_);
    std::string text;
    std::array<char, 4096> buffer{};
    while (const std::size_t size = std::fread(buffer.data(), 1, buffer.size(), file_))
      text.append(buffer.data(), size);
    return text;
  }

private:
  std::FILE* file_;
};

pid_t
spawn(const std::string& path, const Words& arguments, int out, int err)
{
  std::vector<std::string> words{path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  for (std::string& word : words)
    argv.push_back(word.data());
  argv.push_back(nullptr);

  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, out, STDOUT_FILENO);
  posix_spawn_file_actions_adddup2(&actions, err, STDERR_FILENO);
  pid_t process = 0;
  const int error =
      posix_spawn(&process, path.c_str(), &actions, nullptr, argv.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0)
    throw std::runtime_error(path + ": " + std::strerror(error));
  return process;
}

} // namespace

Outcome
runProgram(const std::string& path, const Words& arguments)
{
  const Capture out;
  const Capture err;
  const pid_t process = spawn(path, arguments, out.descriptor(), err.descriptor());
  int status = 0;
  if (waitpid(process, &status, 0) != process)
    throw std::runtime_error(path + ": cannot be waited for");
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status),
          out.contents(),
          err.contents()};
}

std::string
pathOf(const std::string& app)
{
  return std::string(PCL_SHAPE_APP_DIRECTORY) + '/' + app;
}

Outcome
runApp(const std::string& app, const Words& arguments)
{
  return runProgram(pathOf(app), arguments);
}

RunningApp::RunningApp(const std::string& app, const Words& arguments)
{
  const Capture dropped;
  process_ = spawn(pathOf(app), arguments, dropped.descriptor(), dropped.descriptor());
}

RunningApp::~RunningApp() { kill(); }

void
RunningApp::waitUntil(const std::function<bool()>& condition)
{
  constexpr int most_polls = 60'000;
  for (int poll = 0; poll < most_polls; ++poll) {
    if (condition())
      return;
    if (waitpid(process_, nullptr, WNOHANG) != 0) {
      process_ = -1;
      if (condition())
        return; // it came true, and then the app ended
      throw std::runtime_error("the app ended before what was waited for");
    }
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  throw std::runtime_error("what was waited for did not happen within a minute");
}

void
RunningApp::stop() const
{
  if (process_ < 0)
    throw std::runtime_error("the app has ended; expected it to run");
  ::kill(process_, SIGSTOP);
}

void
RunningApp::kill()
{
  if (process_ < 0)
    return;
  ::kill(process_, SIGKILL);
  waitpid(process_, nullptr, 0);
  process_ = -1;
}

} // namespace pcl_shape_test
