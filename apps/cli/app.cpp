// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Help, version, one-line errors and exit statuses.

#include "cli/app.h"

#include "cli/atomic_file.h"
#include "cli/errors.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>

namespace pcl::app {
namespace {

int
parseAndRun(const CommandLine& command_line,
            int argc,
            const char* const* argv,
            int (*run)(const Arguments&))
{
  const Arguments arguments = command_line.parse(argc, argv);
  if (arguments.has("help"))
    command_line.printHelp(std::cout);
  else if (arguments.has("version"))
    std::cout << command_line.app() << ' ' << PCL_SHAPE_VERSION << '\n';
  else {
    const int status = run(arguments);
    if (!std::cout.flush() || std::fflush(stdout) != 0)
      throw InputError("standard output: cannot be written");
    return status;
  }
  return 0;
}

} // namespace

void
logLine(const std::string& line)
{
  std::string clean = line;
  std::replace_if(
      clean.begin(),
      clean.end(),
      [](unsigned char c) { return c < ' ' || c == 127; },
      '?');
  std::cerr << clean + '\n';
}

int
runApp(const CommandLine& command_line,
       int argc,
       const char* const* argv,
       int (*run)(const Arguments&))
{
  const std::string prefix = command_line.app() + ": ";
  try {
    removeTemporaryFilesOnSignals();
    return parseAndRun(command_line, argc, argv, run);
  }
  catch (const UsageError& error) {
    logLine(prefix + error.what());
    return 2;
  }
  catch (const std::bad_alloc&) {
    logLine(prefix + "not enough memory");
  }
  catch (const std::exception& error) {
    logLine(prefix + error.what());
  }
  return 1;
}

} // namespace pcl::app
