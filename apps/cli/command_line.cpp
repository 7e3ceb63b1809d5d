// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parses and explains options; help, version, one-line errors and exit statuses.

#include "cli/command_line.h"

#include "io/errors.h"
#include "io/files.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <new>
#include <ostream>
#include <sstream>
#include <utility>

namespace po = boost::program_options;

namespace pcl::app {
namespace {

constexpr const char* operand_key = "";

constexpr int style = po::command_line_style::allow_long |
                      po::command_line_style::long_allow_next |
                      po::command_line_style::long_allow_adjacent |
                      po::command_line_style::allow_long_disguise;

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

CommandLine::CommandLine(std::string app, std::string operands, std::string purpose)
: app_(std::move(app))
, operands_(std::move(operands))
, purpose_(std::move(purpose))
{
  flag("help", "print this text (also -h)");
  flag("version", "print the version");
}

CommandLine&
CommandLine::flag(const std::string& name, const std::string& help)
{
  return option(name, "", help);
}

CommandLine&
CommandLine::option(const std::string& name,
                    const std::string& value,
                    const std::string& help)
{
  options_.push_back({name, value, help});
  return *this;
}

void
CommandLine::fail(const std::string& what) const
{
  std::string names;
  for (const Option& option : options_)
    names += (names.empty() ? "-" : ", -") + option.name;
  throw UsageError(what + "; expected one of " + names);
}

Arguments
CommandLine::parse(int argc, const char* const* argv) const
{
  po::options_description description;
  for (const Option& option : options_)
    if (option.value.empty())
      description.add_options()(option.name.c_str(), "");
    else
      description.add_options()(option.name.c_str(), po::value<std::string>(), "");
  description.add_options()("h", "");

  Arguments arguments(app_, operands_);
  const char* const* const all_end = argv + argc;
  const char* const* end = std::find(argv, all_end, std::string("--"));
  try {
    const auto parsed = po::command_line_parser(static_cast<int>(end - argv), argv)
                            .options(description)
                            .style(style)
                            .run();
    for (const auto& found : parsed.options) {
      const std::string value = found.value.empty() ? "" : found.value.front();
      if (found.string_key != operand_key)
        arguments.addOption(found.string_key == "h" ? "help" : found.string_key, value);
      else if (value.size() > 1 && value.front() == '-')
        fail("unknown option " + value);
      else
        arguments.addOperand(value);
    }
  }
  catch (const po::unknown_option& error) {
    fail("unknown option " + error.get_option_name());
  }
  catch (const po::error& error) {
    fail(error.what());
  }
  while (end != all_end && ++end != all_end)
    arguments.addOperand(*end);
  return arguments;
}

void
CommandLine::printHelp(std::ostream& stream) const
{
  stream << "Usage: " << app_ << ' ' << operands_ << " [options]\n"
         << purpose_ << "\n\n";
  std::size_t width = 0;
  for (const Option& option : options_)
    width = std::max(width, option.name.size() + option.value.size() + 4);
  for (const Option& option : options_) {
    std::string left = "  -" + option.name + ' ' + option.value;
    std::istringstream help(option.help);
    for (std::string line; std::getline(help, line); left.clear())
      stream << left << std::string(2 + width - left.size(), ' ') << line << '\n';
  }
  stream << "\nLengths are in meters, angles in degrees. Exit status: 0 success, 1 bad "
            "input, 2 bad command line.\n";
}

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
