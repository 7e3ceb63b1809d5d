// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One process, or several that are started for each run and get tasks through sockets.

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
#include <poll.h>
#include <unistd.h>

#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>

namespace pcl::tiling {
namespace {

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

/** \param[in] some sends or receives bytes from a place on, and says how many
 * \return false if the other end is closed */
template <typename Some>
bool
transferAll(std::size_t size, const Some& some)
{
  for (std::size_t at = 0; at < size;) {
    const ssize_t done = some(at);
    if (done == 0 || (done < 0 && errno != EINTR))
      return false;
    at += done > 0 ? static_cast<std::size_t>(done) : 0;
  }
  return true;
}

bool
sendAll(int to, const void* data, std::size_t size)
{
  return transferAll(size, [&](std::size_t at) {
    return ::send(to, static_cast<const char*>(data) + at, size - at, MSG_NOSIGNAL);
  });
}

bool
receiveAll(int from, void* data, std::size_t size)
{
  return transferAll(size, [&](std::size_t at) {
    return ::recv(from, static_cast<char*>(data) + at, size - at, 0);
  });
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
    std::array<int, 2> ends{};
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
      throw TilingError(std::string("no socket to a process: ") + std::strerror(errno));
    const pid_t parent = ::getpid();
    process_ = ::fork();
    if (process_ < 0) {
      const std::string why = std::strerror(errno);
      for (const int end : ends)
        ::close(end);
      throw TilingError("no further process: " + why);
    }
    socket_ = ends[process_ == 0];
    ::close(ends[process_ != 0]);
    if (process_ > 0)
      return;
    // Ends with the one that gives tasks, for nobody else would; a handler may remove
    // what is unfinished.
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);
    for (const auto& other : others)
      ::close(other->socket_);
    ::_exit(::getppid() == parent ? serve(work) : EXIT_FAILURE);
  }

  ~Worker()
  {
    ::close(socket_);
    if (process_ > 0)
      waitForItsEnd();
  }
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;

  /** That it has ended is noticed when its answer is taken. */
  void
  give(std::uint64_t task)
  {
    task_ = task;
    sendAll(socket_, &task, sizeof task);
  }

  std::size_t
  task() const
  {
    return task_;
  }

  int
  socket() const
  {
    return socket_;
  }

  /** Its answer about the task; without one it was killed. */
  Outcome
  take(bool& is_alive)
  {
    Outcome outcome;
    is_alive =
        receiveText(socket_, outcome.result) && receiveText(socket_, outcome.error);
    if (is_alive)
      return outcome;
    const int status = waitForItsEnd();
    outcome.error = "its process was ended";
    if (WIFSIGNALED(status))
      outcome.error += " by signal " + std::to_string(WTERMSIG(status));
    return outcome;
  }

private:
  int
  serve(const Team::Work& work) const
  {
    for (std::uint64_t task = 0; receiveAll(socket_, &task, sizeof task);) {
      const Outcome outcome = outcomeOf(work, task);
      if (!sendText(socket_, outcome.result) || !sendText(socket_, outcome.error))
        return EXIT_FAILURE;
    }
    return EXIT_SUCCESS;
  }

  int
  waitForItsEnd()
  {
    int status = 0;
    while (::waitpid(process_, &status, 0) < 0 && errno == EINTR)
      ;
    process_ = -1;
    return status;
  }

  pid_t process_ = -1;
  int socket_ = -1;
  std::size_t task_ = 0;
};

class Processes : public Team {
public:
  explicit Processes(std::size_t count) : count_(count) {}

  void
  run(const std::vector<std::size_t>& tasks,
      const Work& work,
      const Report& report) override
  {
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
      ends.push_back({worker->socket(), POLLIN, 0});
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

Outcome
outcomeOf(const Team::Work& work, std::size_t task)
{
  try {
    return {work(task), {}};
  }
  catch (const std::bad_alloc&) {
    return {{}, "not enough memory; use smaller tiles, or fewer processes or ranks"};
  }
  catch (const std::exception& error) {
    return {{}, error.what()};
  }
}

std::unique_ptr<Team>
makeTeam(std::size_t processes)
{
  if (processes == 0)
    throw TilingError("0 processes; expected at least one");
  if (processes == 1)
    return std::make_unique<Alone>();
  return std::make_unique<Processes>(processes);
}

} // namespace pcl::tiling
