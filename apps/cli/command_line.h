// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The options of an app, their help, and what all main() functions share.

#pragma once

#include "cli/arguments.h"

#include <iosfwd>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief What an app accepts, in PCL's style: `-radius 0.02`; `--radius 0.02` and
 * `-radius=0.02` work as well. Names are never abbreviated. What follows `--` are
 * operands. */
class CommandLine {
public:
  /** \param[in] app its name
   * \param[in] operands as the usage line shows them, e.g. "in.pcd out.pcd"
   * \param[in] purpose one sentence */
  CommandLine(std::string app, std::string operands, std::string purpose);

  CommandLine& flag(const std::string& name, const std::string& help);

  /** \param[in] value as the usage shows it, e.g. "R" */
  CommandLine&
  option(const std::string& name, const std::string& value, const std::string& help);

  const std::string&
  app() const
  {
    return app_;
  }

  /** \throws UsageError for an unknown, repeated or incomplete option */
  Arguments parse(int argc, const char* const* argv) const;

  void printHelp(std::ostream& stream) const;

private:
  struct Option {
    std::string name;
    std::string value; ///< empty for a flag
    std::string help;
  };

  [[noreturn]] void fail(const std::string& what) const;

  std::string app_;
  std::string operands_;
  std::string purpose_;
  std::vector<Option> options_;
};

/** \brief What every main() does: print help or the version, or run the app, and turn
 * exceptions into one line on standard error and an exit status. \param[in] run the
 * app; its result is the exit status */
int runApp(const CommandLine& command_line,
           int argc,
           const char* const* argv,
           int (*run)(const Arguments&));

/** \brief One line on standard error. */
void logLine(const std::string& line);

} // namespace pcl::app
