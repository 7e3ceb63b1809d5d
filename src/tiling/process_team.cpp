// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One process, or several that are started for each run and get tasks through pipes.

#include <pcl/tiling/point_source.h>
#include <pcl/tiling/team.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <optional>
#include <poll.h>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/wait.h>

namespace pcl::tiling {
namespace {

struct Outcome {
  std::string result, error;
};

Outcome
outcomeOf(const Team::Work& work, std::size_t task)
{
  try {
    return {work(task), {}};
  }
  catch (const std::bad_alloc&) {
    return {{}, "not enough memory; use smaller tiles, or fewer processes"};
  }
  catch (const std::exception& error) {
    return {{}, error.what()};
  }
}

class Alone : public Team {
public:
  void
  run(const std::vector<std::size_t>& tasks,
      const Work& work,
      const Report& report) override
  {
    for (const std::size_t task : tasks) {
      const Outcome outcome = outcomeOf(work, task);
      report(task, outcome.result, outcome.error);
    }
  }
};

/** \return false if the other end is closed */
bool
sendAll(int to, const void* data, std::size_t size)
{
  const auto* from = static_cast<const char*>(data);
  while (size > 0) {
    const ssize_t sent = ::write(to, from, size);
    if (sent < 0 && errno == EINTR)
      continue;
    if (sent <= 0)
      return false;
    from += sent;
    size -= static_cast<std::size_t>(sent);
  }
  return true;
}

bool
receiveAll(int from, void* data, std::size_t size)
{
  auto* to = static_cast<char*>(data);
  while (size > 0) {
    const ssize_t got = ::read(from, to, size);
    if (got < 0 && errno == EINTR)
      continue;
    if (got <= 0)
      return false;
    to += got;
    size -= static_cast<std::size_t>(got);
  }
  return true;
}

bool
sendText(int to, const std::string& text)
{
  const std::uint64_t size = text.size();
  return sendAll(to, &size, sizeof size) && sendAll(to, text.data(), text.size());
}

bool
receiveText(int from, std::string& text)
{
  std::uint64_t size = 0;
  if (!receiveAll(from, &size, sizeof size))
    return false;
  text.resize(size);
  return receiveAll(from, text.data(), size);
}

/** A working process, as the one that hands out tasks sees it. */
class Worker {
public:
  Worker(const Team::Work& work, const std::vector<std::unique_ptr<Worker>>& others)
  {
    std::array<int, 2> down{}, up{};
    if (::pipe(down.data()) != 0 || ::pipe(up.data()) != 0)
      throw TilingError(std::string("no pipe to a process: ") + std::strerror(errno));
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ < 0)
      throw TilingError(std::string("no further process: ") + std::strerror(errno));
    if (process_ == 0) {
      // Ends with the one that gives tasks, for nobody else would; a handler may remove
      // what is unfinished.
      ::prctl(PR_SET_PDEATHSIG, SIGTERM);
      for (const auto& other : others)
        other->closePipes();
      ::close(down[1]);
      ::close(up[0]);
      ::_exit(::getppid() == parent ? serve(work, down[0], up[1]) : EXIT_FAILURE);
    }
    ::close(down[0]);
    ::close(up[1]);
    tasks_ = down[1];
    results_ = up[0];
  }

  ~Worker()
  {
    closePipes();
    while (process_ > 0 && ::waitpid(process_, nullptr, 0) < 0 && errno == EINTR)
      ;
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /** \return false if it has ended */
  bool
  give(std::size_t task)
  {
    task_ = task;
    const std::uint64_t number = task;
    return sendAll(tasks_, &number, sizeof number);
  }

  bool
  isBusy() const
  {
    return task_.has_value();
  }

  std::size_t
  task() const
  {
    return *task_;
  }

  int
  results() const
  {
    return results_;
  }

  /** Its answer about the task; without one it was killed. */
  Outcome
  take(bool& is_alive)
  {
    Outcome outcome;
    is_alive =
        receiveText(results_, outcome.result) && receiveText(results_, outcome.error);
    if (!is_alive)
      outcome.error = whyItEnded();
    task_.reset();
    return outcome;
  }

private:
  static int
  serve(const Team::Work& work, int tasks, int results)
  {
    for (std::uint64_t task = 0; receiveAll(tasks, &task, sizeof task);) {
      const Outcome outcome = outcomeOf(work, task);
      if (!sendText(results, outcome.result) || !sendText(results, outcome.error))
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
  }

  std::string
  whyItEnded()
  {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR)
      ;
    process_ = -1;
    return "its process was ended" +
           (WIFSIGNALED(status) ? " by signal " + std::to_string(WTERMSIG(status))
                                : std::string());
  }

  void
  closePipes()
  {
    for (int* const end : {&tasks_, &results_})
      if (*end >= 0) {
        ::close(*end);
        *end = -1;
      }
  }

  pid_t process_ = -1;
  int tasks_ = -1, results_ = -1;
  std::optional<std::size_t> task_;
};

/** A pipe whose reader has ended gives an error instead of a signal. */
class IgnoredPipeSignal {
public:
  IgnoredPipeSignal() : old_(std::signal(SIGPIPE, SIG_IGN)) {}
  ~IgnoredPipeSignal() { std::signal(SIGPIPE, old_); }
  IgnoredPipeSignal(const IgnoredPipeSignal&) = delete;
  IgnoredPipeSignal& operator=(const IgnoredPipeSignal&) = delete;

private:
  void (*old_)(int);
};

class Processes : public Team {
public:
  explicit Processes(std::size_t count) : count_(count) {}

  void
  run(const std::vector<std::size_t>& tasks,
      const Work& work,
      const Report& report) override
  {
    const IgnoredPipeSignal ignored;
    std::vector<std::unique_ptr<Worker>> workers;
    for (std::size_t i = 0; i < std::min(count_, tasks.size()); ++i)
      workers.push_back(std::make_unique<Worker>(work, workers));
    std::size_t next = 0;
    for (auto& worker : workers)
      worker->give(tasks[next++]);
    while (!workers.empty()) {
      const std::size_t ready = waitForOne(workers);
      Worker& worker = *workers[ready];
      const std::size_t task = worker.task();
      bool is_alive = false;
      const Outcome outcome = worker.take(is_alive);
      report(task, outcome.result, outcome.error);
      if (!is_alive && next < tasks.size())
        workers[ready] = std::make_unique<Worker>(work, workers);
      if (next < tasks.size())
        workers[ready]->give(tasks[next++]);
      else
        workers.erase(workers.begin() + static_cast<std::ptrdiff_t>(ready));
    }
  }

private:
  static std::size_t
  waitForOne(const std::vector<std::unique_ptr<Worker>>& workers)
  {
    std::vector<pollfd> ends;
    for (const auto& worker : workers)
      ends.push_back({worker->results(), POLLIN, 0});
    while (::poll(ends.data(), ends.size(), -1) < 0)
      if (errno != EINTR)
        throw TilingError(std::string("waiting for processes: ") +
                          std::strerror(errno));
    const auto ready = std::find_if(
        ends.begin(), ends.end(), [](const pollfd& end) { return end.revents != 0; });
    return static_cast<std::size_t>(ready - ends.begin());
  }

  std::size_t count_;
};

} // namespace

std::unique_ptr<Team>
makeTeam()
{
  return std::make_unique<Alone>();
}

std::unique_ptr<Team>
makeTeam(std::size_t processes)
{
  if (processes == 0)
    throw TilingError("0 processes; expected at least one");
  return processes == 1 ? makeTeam() : std::make_unique<Processes>(processes);
}

} // namespace pcl::tiling
