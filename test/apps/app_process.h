// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs programs and keeps what they print.

#pragma once

#include <functional>
#include <string>
#include <vector>

#include <sys/types.h>

namespace pcl_shape_test {

/** \brief What a finished process left. */
struct Outcome {
  int status = -1; ///< exit status, or minus the signal that ended it
  std::string out;
  std::string err;
};

using Words = std::vector<std::string>;

/** \brief Run one of the project's apps. \throws std::runtime_error if it does not
 * start */
Outcome runApp(const std::string& app, const Words& arguments);

/** \brief Where one of the apps is. */
std::string pathOf(const std::string& app);

/** \brief Run any program. */
Outcome runProgram(const std::string& path, const Words& arguments);

/** \brief An app that runs beside the test, its output dropped. It is killed in the
 * end. */
class RunningApp {
public:
  RunningApp(const std::string& app, const Words& arguments);
  ~RunningApp();
  RunningApp(const RunningApp&) = delete;
  RunningApp& operator=(const RunningApp&) = delete;

  /** \throws std::runtime_error if the app ends before, or after a minute */
  void waitUntil(const std::function<bool()>& condition);

  /** \brief SIGSTOP: it is there, and does nothing. */
  void stop() const;

  /** \brief SIGKILL, and wait for the end. */
  void kill();

private:
  pid_t process_ = -1;
};

} // namespace pcl_shape_test
