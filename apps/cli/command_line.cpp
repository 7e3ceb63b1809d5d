// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The options of an app, the values of one run, and what is around its main().

#include "cli/command_line.h"

#include "cli/errors.h"
#include "cli/files.h"
#include "io/text.h"

#include <boost/program_options/options_description.hpp>
#include <boost/program_options/parsers.hpp>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <new>
#include <ostream>
#include <sstream>

namespace po = boost::program_options;

namespace pcl::app {
namespace {

constexpr const char* operand_key = "";

constexpr int style = po::command_line_style::allow_long |
                      po::command_line_style::long_allow_next |
                      po::command_line_style::long_allow_adjacent |
                      po::command_line_style::allow_long_disguise;

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
  try {
    const auto parsed =
        po::command_line_parser(argc, argv).options(description).style(style).run();
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

std::optional<double>
parseNumber(const std::string& text)
{
  const auto value = parseValue<double>(text);
  return value && std::isfinite(*value) ? value : std::nullopt;
}

Arguments::Arguments(std::string app, std::string usage)
: app_(std::move(app))
, usage_(std::move(usage))
{}

void
Arguments::addOption(const std::string& name, const std::string& value)
{
  if (!options_.emplace(name, value).second)
    throw UsageError("-" + name + " '" + value + "' is given twice; expected once");
}

const std::vector<std::string>&
Arguments::operands(std::size_t count) const
{
  if (operands_.size() != count)
    failForOperands(std::to_string(count));
  return operands_;
}

const std::vector<std::string>&
Arguments::operandsFrom(std::size_t min) const
{
  if (operands_.size() < min)
    failForOperands("at least " + std::to_string(min));
  return operands_;
}

void
Arguments::failForOperands(const std::string& expected) const
{
  std::string given;
  for (const std::string& operand : operands_)
    given += " '" + operand + "'";
  throw UsageError("expected " + expected + " file names but got " +
                   std::to_string(operands_.size()) + given + "; usage: " + app_ + ' ' +
                   usage_ + " (see -help)");
}

void
Arguments::fail(const std::string& name, const std::string& expected) const
{
  throw UsageError("-" + name + " '" + options_.at(name) + "': expected " + expected);
}

const std::string*
Arguments::find(const std::string& name) const
{
  const auto found = options_.find(name);
  return found == options_.end() ? nullptr : &found->second;
}

std::string
Arguments::text(const std::string& name, const std::string& fallback) const
{
  const std::string* const text = find(name);
  if (text && text->empty())
    fail(name, "a text that is not empty");
  return text ? *text : fallback;
}

std::string
Arguments::choice(const std::string& name, const std::vector<std::string>& words) const
{
  const std::string* const text = find(name);
  if (!text)
    return words.front();
  std::string list;
  for (const std::string& word : words) {
    if (word == *text)
      return word;
    list += (list.empty() ? "" : ", ") + word;
  }
  fail(name, "one of " + list);
}

std::optional<double>
Arguments::number(const std::string& name, const NumberRange& range) const
{
  const std::string* const text = find(name);
  if (!text)
    return std::nullopt;
  const std::optional<double> value = parseNumber(*text);
  if (!value || *value > range.max || *value < range.min ||
      (range.min_excluded && *value == range.min))
    fail(name, range.expected);
  return value;
}

std::optional<std::vector<double>>
Arguments::numbers(const std::string& name,
                   std::size_t count,
                   const std::string& expected) const
{
  const std::string* const text = find(name);
  if (!text)
    return std::nullopt;
  std::vector<double> numbers;
  std::istringstream words(*text + ',');
  for (std::string word; std::getline(words, word, ',');) {
    const std::optional<double> number = parseNumber(word);
    if (!number)
      fail(name, expected);
    numbers.push_back(*number);
  }
  if (numbers.size() != count)
    fail(name, expected);
  return numbers;
}

std::optional<std::uint64_t>
Arguments::integer(const std::string& name, std::uint64_t min, std::uint64_t max) const
{
  const std::string* const text = find(name);
  if (!text)
    return std::nullopt;
  const auto value = parseValue<std::uint64_t>(*text);
  if (!value || *value < min || *value > max)
    fail(name,
         "a whole number from " + std::to_string(min) + " to " + std::to_string(max));
  return value;
}

void
Arguments::exclude(const std::string& one, const std::string& other) const
{
  if (has(one) && has(other))
    throw UsageError("-" + one + " '" + options_.at(one) + "' and -" + other + " '" +
                     options_.at(other) + "': expected only one of the two");
}

bool
Arguments::hasBoth(const std::string& one, const std::string& other) const
{
  if (has(one) != has(other))
    throw UsageError("-" + one + " '" + text(one) + "' and -" + other + " '" +
                     text(other) + "': expected both or neither");
  return has(one);
}

unsigned
Arguments::threads() const
{
  constexpr std::uint64_t max_threads = 1024; // more is a mistake, not a machine
  return static_cast<unsigned>(integer("threads", 0, max_threads).value_or(0));
}

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
