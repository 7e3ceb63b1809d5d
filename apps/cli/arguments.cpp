// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "cli/arguments.h"

#include "cli/errors.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <sstream>

namespace pcl::app {
namespace {

constexpr std::uint64_t max_threads = 1024;

std::string
badValue(const std::string& name, const std::string& value, const std::string& allowed)
{
  return "-" + name + " '" + value + "': allowed is " + allowed;
}

} // namespace

std::optional<double>
parseNumber(const std::string& text)
{
  double value = 0.0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || !std::isfinite(value))
    return std::nullopt;
  return value;
}

Arguments::Arguments(std::string app, std::string usage)
: app_(std::move(app))
, usage_(std::move(usage))
{}

void
Arguments::addOption(const std::string& name, const std::string& value)
{
  if (!options_.emplace(name, value).second)
    throw UsageError("-" + name + " '" + value + "' is given twice: allowed is once");
}

const std::vector<std::string>&
Arguments::operands(std::size_t count) const
{
  if (operands_.size() != count)
    failForOperands(std::to_string(count));
  return operands_;
}

const std::vector<std::string>&
Arguments::operandsFrom(std::size_t least) const
{
  if (operands_.size() < least)
    failForOperands("at least " + std::to_string(least));
  return operands_;
}

void
Arguments::failForOperands(const std::string& expected) const
{
  std::string given;
  for (const std::string& operand : operands_)
    given += " '" + operand + "'";
  throw UsageError("expected " + expected + " file names but got " +
                   std::to_string(operands_.size()) + given + ": allowed is " + app_ +
                   ' ' + usage_ + " (see -help)");
}

std::string
Arguments::text(const std::string& name, const std::string& fallback) const
{
  const auto found = options_.find(name);
  if (found == options_.end())
    return fallback;
  if (found->second.empty())
    throw UsageError(badValue(name, "", "a text that is not empty"));
  return found->second;
}

std::string
Arguments::choice(const std::string& name,
                  const std::vector<std::string>& allowed) const
{
  const auto found = options_.find(name);
  if (found == options_.end())
    return allowed.front();
  if (std::find(allowed.begin(), allowed.end(), found->second) != allowed.end())
    return found->second;
  std::string words;
  for (const std::string& word : allowed)
    words += (words.empty() ? "" : ", ") + word;
  throw UsageError(badValue(name, found->second, "one of " + words));
}

std::optional<double>
Arguments::number(const std::string& name, const NumberRange& range) const
{
  const auto found = options_.find(name);
  if (found == options_.end())
    return std::nullopt;
  const std::optional<double> value = parseNumber(found->second);
  if (!value || *value > range.most || *value < range.least ||
      (range.least_excluded && *value == range.least))
    throw UsageError(badValue(name, found->second, range.allowed));
  return value;
}

std::optional<std::vector<double>>
Arguments::numbers(const std::string& name,
                   std::size_t count,
                   const std::string& allowed) const
{
  const auto found = options_.find(name);
  if (found == options_.end())
    return std::nullopt;
  std::vector<double> numbers;
  bool is_number = true;
  std::istringstream words(found->second + ',');
  for (std::string word; is_number && std::getline(words, word, ',');) {
    const std::optional<double> number = parseNumber(word);
    is_number = number.has_value();
    numbers.push_back(number.value_or(0.0));
  }
  if (!is_number || numbers.size() != count)
    throw UsageError(badValue(name, found->second, allowed));
  return numbers;
}

std::optional<std::uint64_t>
Arguments::integer(const std::string& name,
                   std::uint64_t least,
                   std::uint64_t most) const
{
  const auto found = options_.find(name);
  if (found == options_.end())
    return std::nullopt;
  const std::string& text = found->second;
  std::uint64_t value = 0;
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, value);
  if (error != std::errc() || stop != end || value < least || value > most)
    throw UsageError(badValue(name,
                              text,
                              "a whole number from " + std::to_string(least) + " to " +
                                  std::to_string(most)));
  return value;
}

void
Arguments::exclude(const std::string& one, const std::string& other) const
{
  if (has(one) && has(other))
    throw UsageError("-" + one + " '" + options_.at(one) + "' and -" + other + " '" +
                     options_.at(other) + "': allowed is one of the two");
}

unsigned
Arguments::threads() const
{
  return static_cast<unsigned>(integer("threads", 0, max_threads).value_or(0));
}

} // namespace pcl::app
