/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <charconv>
#include <cmath>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief Whether a number that is out of range is too small rather than too large. */
inline bool
isTiny(std::string_view word)
{
  double value = 0.0;
  const auto result = std::from_chars(word.data(), word.data() + word.size(), value);
  return result.ec == std::errc() && std::abs(value) < 1.0;
}

/** \brief The whole word as a number of this type, if it is one. */
template <typename T>
std::optional<T>
parseInteger(std::string_view word)
{
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (error != std::errc() || stop != end)
    return std::nullopt;
  return value;
}

/** \brief The same for nan, inf and what is in the range of the type; what is closer to
 * 0 than its smallest number is 0. */
template <typename T>
std::optional<T>
parseFloating(std::string_view word)
{
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    return std::nullopt;
  if (error == std::errc::result_out_of_range)
    return isTiny(word) ? std::optional<T>(T{0}) : std::nullopt;
  return value;
}

/** \brief Write the shortest text that reads as the same number. */
template <typename T>
void
appendNumber(T value, std::string& text)
{
  constexpr std::size_t longest = 32;
  char digits[longest];
  const auto result = std::to_chars(digits, digits + longest, value);
  text.append(digits, result.ptr);
}

/** \brief A word of a file for a message: printable and short. */
std::string quoted(std::string_view word);

/** \brief The words of a line. */
std::vector<std::string_view> splitWords(std::string_view line);

/** \brief Take the first line, without its end, off the text. */
std::string_view takeLine(std::string_view& text);

} // namespace pcl::app
