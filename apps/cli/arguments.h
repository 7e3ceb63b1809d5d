// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The options and operands of one run, checked when they are asked for.

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The numbers that an option accepts: finite and in [min, max]. */
struct NumberRange {
  double min;
  double max;
  bool min_excluded;
  const char* expected; ///< the range in words
};

constexpr NumberRange positive_length{
    0.0, 1e308, true, "a positive finite number of meters"};
constexpr NumberRange positive_number{0.0, 1e308, true, "a positive finite number"};
constexpr NumberRange non_negative{0.0, 1e308, false, "a finite number of 0 or more"};
constexpr NumberRange probability{0.0, 1.0, false, "a number from 0 to 1"};
constexpr NumberRange right_angle{
    0.0, 90.0, true, "an angle above 0, up to 90 degrees"};

/** \brief The parsed command line. A bad value throws a UsageError that names the
 * parameter, its value and what is expected. */
class Arguments {
public:
  Arguments(std::string app, std::string usage);

  /** \throws UsageError if the option was given before */
  void addOption(const std::string& name, const std::string& value);

  void
  addOperand(const std::string& operand)
  {
    operands_.push_back(operand);
  }

  const std::string&
  app() const
  {
    return app_;
  }

  /** \brief The operands. \throws UsageError if there are not `count` */
  const std::vector<std::string>& operands(std::size_t count) const;

  /** \brief The operands, at least `min`. \throws UsageError if there are fewer */
  const std::vector<std::string>& operandsFrom(std::size_t min) const;

  bool
  has(const std::string& name) const
  {
    return options_.count(name) != 0;
  }

  std::string text(const std::string& name, const std::string& fallback = "") const;

  /** \brief One of `words`, of which the first is the default. */
  std::string choice(const std::string& name,
                     const std::vector<std::string>& words) const;

  std::optional<double> number(const std::string& name, const NumberRange& range) const;

  /** \brief The numbers of e.g. "0,1.5,2"; as many as asked for. */
  std::optional<std::vector<double>> numbers(const std::string& name,
                                             std::size_t count,
                                             const std::string& expected) const;

  std::optional<std::uint64_t>
  integer(const std::string& name, std::uint64_t min, std::uint64_t max) const;

  /** \throws UsageError if both options were given */
  void exclude(const std::string& one, const std::string& other) const;

  /** \brief Whether both options were given. \throws UsageError if only one was */
  bool hasBoth(const std::string& one, const std::string& other) const;

  /** \brief -threads, 0 (all cores) by default. */
  unsigned threads() const;

  /** \brief Throws a UsageError for the value of an option. */
  [[noreturn]] void fail(const std::string& name, const std::string& expected) const;

private:
  [[noreturn]] void failForOperands(const std::string& expected) const;

  /** The value of an option that was given, or nullptr. */
  const std::string* find(const std::string& name) const;

  std::string app_;
  std::string usage_;
  std::map<std::string, std::string> options_;
  std::vector<std::string> operands_;
};

/** \brief A finite number and nothing but a number, else nothing. */
std::optional<double> parseNumber(const std::string& text);

} // namespace pcl::app
