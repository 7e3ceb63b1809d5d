// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs computations so that Ctrl-C ends them, without Python's lock.

#include "interruptible.h"

#include <pcl/features/cancellation.h>

#include <algorithm>
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include <pybind11/pybind11.h>

namespace py = pybind11;

namespace pcl::python {
namespace {

/** A computation on a thread of its own. */
class Job {
public:
  void
  run(const std::function<void()>& computation)
  {
    std::exception_ptr error;
    try {
      const CancellationScope scope(is_canceled_);
      computation();
    }
    catch (...) {
      error = std::current_exception();
    }
    const std::lock_guard<std::mutex> lock(mutex_);
    error_ = error;
    is_done_ = true;
    ended_.notify_all();
  }

  void
  cancel()
  {
    is_canceled_ = true;
  }

  bool
  isDoneWithin(std::chrono::milliseconds time)
  {
    std::unique_lock<std::mutex> lock(mutex_);
    return ended_.wait_for(lock, time, [this] { return is_done_; });
  }

  void
  rethrow() const
  {
    if (error_)
      std::rethrow_exception(error_);
  }

private:
  std::atomic<bool> is_canceled_{false};
  std::mutex mutex_;
  std::condition_variable ended_;
  bool is_done_ = false;
  std::exception_ptr error_;
};

/** Canceled computations, until they end. */
class CanceledJobs {
public:
  void
  add(std::shared_ptr<Job> job, std::thread thread)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    joinThose(
        [](Job& other) { return other.isDoneWithin(std::chrono::milliseconds(0)); });
    left_.push_back({std::move(job), std::move(thread)});
  }

  void
  join()
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    joinThose([](Job&) { return true; });
  }

private:
  struct Left {
    std::shared_ptr<Job> job;
    std::thread thread;
  };

  template <typename Test>
  void
  joinThose(const Test& test)
  {
    const auto joined = std::remove_if(left_.begin(), left_.end(), [&](Left& left) {
      const bool is_wanted = test(*left.job);
      if (is_wanted)
        left.thread.join();
      return is_wanted;
    });
    left_.erase(joined, left_.end());
  }

  std::mutex mutex_;
  std::vector<Left> left_;
};

CanceledJobs&
canceled()
{
  static CanceledJobs jobs;
  return jobs;
}

bool
isMainThread()
{
  const py::module_ threading = py::module_::import("threading");
  return threading.attr("current_thread")().is(threading.attr("main_thread")());
}

} // namespace

void
runInterruptibly(std::function<void()> computation)
{
  // Python runs the handlers of signals in its main thread only.
  if (!isMainThread()) {
    const py::gil_scoped_release release;
    computation();
    return;
  }
  // Nobody notices a twentieth of a second, and looking costs microseconds.
  constexpr std::chrono::milliseconds between_looks{50};
  const auto job = std::make_shared<Job>();
  std::thread thread(
      [job, computation = std::move(computation)] { job->run(computation); });
  const auto waitsInVain = [&] {
    const py::gil_scoped_release release;
    return !job->isDoneWithin(between_looks);
  };
  while (waitsInVain())
    if (PyErr_CheckSignals() != 0) {
      job->cancel();
      canceled().add(job, std::move(thread));
      throw py::error_already_set();
    }
  thread.join();
  job->rethrow();
}

void
waitForCanceled()
{
  const py::gil_scoped_release release;
  canceled().join();
}

} // namespace pcl::python
