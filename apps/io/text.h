// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The words and numbers of text files: headers, rows of points, option values.

#pragma once

#include <charconv>
#include <cmath>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace pcl::app {

/** \brief The whole word as a number of this type, if it is one and in its range. Of
 * floating types nan and inf are numbers, and what is closer to 0 than the smallest
 * number is 0. */
template <typename T>
std::optional<T>
parseValue(std::string_view word)
{
  T value{};
  const char* const end = word.data() + word.size();
  const auto [stop, error] = std::from_chars(word.data(), end, value);
  if (stop != end || error == std::errc::invalid_argument)
    return std::nullopt;
  if (error == std::errc())
    return value;
  if constexpr (std::is_floating_point_v<T>) {
    double wide = 0.0; // holds what is too small for a float
    const bool fits = std::from_chars(word.data(), end, wide).ec == std::errc();
    if (fits && std::abs(wide) < 1.0)
      return T{0};
  }
  return std::nullopt;
}

/** \brief Write the shortest text that reads as the same number. */
template <typename T>
void
appendNumber(T value, std::string& text)
{
  constexpr std::size_t max_digits = 32; // a double needs 24
  char digits[max_digits];
  text.append(digits, std::to_chars(digits, digits + max_digits, value).ptr);
}

/** \brief A word of a file for a message: printable and short. */
std::string inQuotes(std::string_view word);

/** \brief The words of a line. */
std::vector<std::string_view> splitWords(std::string_view line);

/** \brief Take the first line, without its end, off the text. */
std::string_view takeLine(std::string_view& text);

} // namespace pcl::app
