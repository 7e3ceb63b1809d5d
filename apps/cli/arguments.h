// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The numbers that an option allows: finite and in [least, most]. */
struct NumberRange {
  double least;
  double most;
  bool least_excluded;
  const char* allowed; ///< the range in words
};

constexpr NumberRange positive_length{
    0.0, 1e308, true, "a positive finite number of metres"};
constexpr NumberRange positive_number{0.0, 1e308, true, "a positive finite number"};
constexpr NumberRange non_negative{0.0, 1e308, false, "a finite number of 0 or more"};
constexpr NumberRange probability{0.0, 1.0, false, "a number from 0 to 1"};
constexpr NumberRange right_angle{
    0.0, 90.0, true, "an angle above 0, up to 90 degrees"};

/** \brief The parsed command line. Values are checked when they are asked for; what is
 * not allowed throws a UsageError that names the parameter, its value and what is
 * allowed. */
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

  /** \brief The operands, at least `least`. \throws UsageError if there are fewer */
  const std::vector<std::string>& operandsFrom(std::size_t least) const;

  bool
  has(const std::string& name) const
  {
    return options_.count(name) != 0;
  }

  std::string text(const std::string& name, const std::string& fallback = "") const;

  /** \brief One of `allowed`, of which the first is the default. */
  std::string choice(const std::string& name,
                     const std::vector<std::string>& allowed) const;

  std::optional<double> number(const std::string& name, const NumberRange& range) const;

  /** \brief The numbers of e.g. "0,1.5,2"; as many as asked for. */
  std::optional<std::vector<double>>
  numbers(const std::string& name, std::size_t count, const std::string& allowed) const;

  std::optional<std::uint64_t>
  integer(const std::string& name, std::uint64_t least, std::uint64_t most) const;

  /** \throws UsageError if both options were given */
  void exclude(const std::string& one, const std::string& other) const;

  /** \brief -threads, 0 (all cores) by default. */
  unsigned threads() const;

private:
  [[noreturn]] void failForOperands(const std::string& expected) const;

  std::string app_;
  std::string usage_;
  std::map<std::string, std::string> options_;
  std::vector<std::string> operands_;
};

/** \brief A finite number and nothing but a number, else nothing. */
std::optional<double> parseNumber(const std::string& text);

} // namespace pcl::app
