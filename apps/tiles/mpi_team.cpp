// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The ranks of MPI as a team: the first one gives tasks out, and works, too.

#include "tiles/mpi_team.h"

#include "io/errors.h"

#include <chrono>
#include <cstdint>
#include <exception>
#include <mpi.h>
#include <mutex>
#include <string>
#include <thread>

namespace pcl::app {
namespace {

// MPI waits by asking again and again, which takes a core from the work: sleep between.
constexpr std::chrono::milliseconds pause{2};
constexpr int ask_tag = 1, task_tag = 2;
constexpr std::uint64_t no_task = ~std::uint64_t{0};

void
waitFor(MPI_Request& request)
{
  for (int is_done = 0; MPI_Test(&request, &is_done, MPI_STATUS_IGNORE), !is_done;)
    std::this_thread::sleep_for(pause);
}

/** What a rank says when it asks for a task: how the last one ended. */
struct Answer {
  std::uint64_t task = no_task;
  pcl::tiling::Outcome outcome;
};

std::string
messageOf(const Answer& answer)
{
  const auto& [result, error] = answer.outcome;
  return std::to_string(answer.task) + '\n' + std::to_string(result.size()) + '\n' +
         result + error;
}

Answer
answerOf(const std::string& message)
{
  const std::size_t first = message.find('\n'), second = message.find('\n', first + 1);
  const std::size_t size = std::stoull(message.substr(first + 1, second - first - 1));
  return {std::stoull(message.substr(0, first)),
          {message.substr(second + 1, size), message.substr(second + 1 + size)}};
}

class Ranks : public pcl::tiling::Team {
public:
  Ranks()
  {
    int provided = 0;
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_MULTIPLE, &provided);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &size_);
    if (size_ > 1 && provided < MPI_THREAD_MULTIPLE)
      throw InputError("this MPI does not let several threads call it; expected "
                       "MPI_THREAD_MULTIPLE");
  }
  ~Ranks() override
  {
    int is_over = 0; // endMpi() may have been called
    MPI_Finalized(&is_over);
    if (std::uncaught_exceptions() == 0 && !is_over)
      MPI_Finalize();
  }
  Ranks(const Ranks&) = delete;
  Ranks& operator=(const Ranks&) = delete;

  bool
  isFirst() const override
  {
    return rank_ == 0;
  }

  void
  meet() override
  {
    MPI_Request request;
    MPI_Ibarrier(MPI_COMM_WORLD, &request);
    waitFor(request);
  }

  void
  run(const std::vector<std::size_t>& tasks,
      const Work& work,
      const Report& report) override
  {
    if (isFirst())
      give(tasks, work, report);
    else
      take(work);
  }

private:
  void
  give(const std::vector<std::size_t>& tasks, const Work& work, const Report& report)
  {
    std::mutex mutex;
    std::size_t next = 0;
    std::exception_ptr failure; // of a report: the manifest cannot be written
    const auto exchange = [&](const Answer& answer) {
      const std::lock_guard<std::mutex> lock(mutex);
      try {
        if (answer.task != no_task && !failure)
          report(answer.task, answer.outcome.result, answer.outcome.error);
      }
      catch (...) {
        failure = std::current_exception();
      }
      return next < tasks.size() && !failure ? tasks[next++] : no_task;
    };
    std::thread server([&] { serve(exchange); });
    Answer last;
    for (std::uint64_t task = exchange(last); task != no_task; task = exchange(last))
      last = {task, pcl::tiling::outcomeOf(work, task)};
    server.join();
    if (failure)
      std::rethrow_exception(failure);
  }

  /** Give tasks to the other ranks until each was told that there is none left. */
  template <typename Exchange>
  void
  serve(const Exchange& exchange) const
  {
    for (int left = size_ - 1; left > 0;) {
      int is_there = 0;
      MPI_Status status;
      MPI_Iprobe(MPI_ANY_SOURCE, ask_tag, MPI_COMM_WORLD, &is_there, &status);
      if (!is_there) {
        std::this_thread::sleep_for(pause);
        continue;
      }
      int size = 0;
      MPI_Get_count(&status, MPI_CHAR, &size);
      std::string message(static_cast<std::size_t>(size), ' ');
      MPI_Recv(message.data(),
               size,
               MPI_CHAR,
               status.MPI_SOURCE,
               ask_tag,
               MPI_COMM_WORLD,
               MPI_STATUS_IGNORE);
      const std::uint64_t task = exchange(answerOf(message));
      MPI_Send(&task, 1, MPI_UINT64_T, status.MPI_SOURCE, task_tag, MPI_COMM_WORLD);
      left -= task == no_task ? 1 : 0;
    }
  }

  static void
  take(const Work& work)
  {
    Answer last;
    for (;;) {
      const std::string message = messageOf(last);
      MPI_Send(message.data(),
               static_cast<int>(message.size()),
               MPI_CHAR,
               0,
               ask_tag,
               MPI_COMM_WORLD);
      std::uint64_t task = no_task;
      MPI_Request request;
      MPI_Irecv(&task, 1, MPI_UINT64_T, 0, task_tag, MPI_COMM_WORLD, &request);
      waitFor(request);
      if (task == no_task)
        return;
      last = {task, pcl::tiling::outcomeOf(work, task)};
    }
  }

  int rank_ = 0, size_ = 1;
};

} // namespace

std::unique_ptr<pcl::tiling::Team>
mpiTeam()
{
  return std::make_unique<Ranks>();
}

void
endMpi(int status)
{
  int is_running = 0, is_over = 0;
  MPI_Initialized(&is_running);
  MPI_Finalized(&is_over);
  int size = 1;
  if (is_running && !is_over) {
    MPI_Comm_size(MPI_COMM_WORLD, &size);
    if (size > 1)
      MPI_Abort(MPI_COMM_WORLD, status);
    MPI_Finalize();
  }
}

} // namespace pcl::app
