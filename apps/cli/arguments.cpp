// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Checks the values of options and says what was expected instead.

#include "cli/arguments.h"

#include "io/errors.h"
#include "io/text.h"

#include <cmath>
#include <sstream>
#include <utility>

namespace pcl::app {

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
  const auto withValue = [&](const std::string& option) {
    const std::string& value = options_.at(option);
    return "-" + option + (value.empty() ? "" : " '" + value + "'");
  };
  if (has(one) && has(other))
    throw UsageError(withValue(one) + " and " + withValue(other) +
                     ": expected only one of the two");
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

} // namespace pcl::app
