// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The words and numbers of text files: headers, rows of points, option values.

#pragma once

#include <charconv>
#include <cmath>
#include <cstdlib>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
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
    const long double wide = std::strtold(std::string(word).c_str(), nullptr);
    if (std::abs(wide) < 1.0L) // too small for the type, not too large
      return T{0};
  }
  return std::nullopt;
}

/** \brief The same, for the words that are in files of points: with a plus sign, a
 * whole number as 3.0, NaN and infinity as Microsoft's runtime writes them (1.#QNAN,
 * -1.#IND, 1.#INF). What PCL accepts for a whole number is read as there: a fraction is
 * cut off, NaN is 0, and -1 without a sign in the type is the largest number. */
template <typename T>
std::optional<T> parseFileValue(std::string_view word);

/** \brief Lower case of ASCII letters. */
std::string toLower(std::string_view word);

/** \brief NaN or infinity as Microsoft's runtime writes them, if the word is one. */
std::optional<double> parseMicrosoftValue(std::string_view word);

/** \brief Write the shortest text that reads as the same number. */
template <typename T>
void
appendNumber(T value, std::string& text)
{
  constexpr std::size_t max_digits = 32; // a double needs 24
  char digits[max_digits];
  text.append(digits, std::to_chars(digits, digits + max_digits, value).ptr);
}

/** \brief The same for files of points: NaN is nan, without the sign that
 * std::to_chars keeps. */
template <typename T>
void
appendFileNumber(T value, std::string& text)
{
  if (value != value)
    text += "nan";
  else
    appendNumber(value, text);
}

/** \brief A word of a file for a message: printable and short. */
std::string inQuotes(std::string_view word);

/** \brief The words of a line. */
std::vector<std::string_view> splitWords(std::string_view line);

/** \brief The same for rows of points: none of a line that begins with #. */
std::vector<std::string_view> splitPoint(std::string_view line);

/** \brief The text after the mark that some editors put before UTF-8. */
std::string_view withoutByteOrderMark(std::string_view text);

/** \brief The file with new lines, if those of its header end with carriage returns
 * alone, as of Rhinoceros. What follows stays as it is unless it is text.
 * \param[in] last the first word of the header's last line \param[in] format of the
 * line that says ascii if text follows; both in lower case */
std::optional<std::string>
withNewLines(std::string_view file, std::string_view last, std::string_view format);

/** \brief Take the first line, without its end, off the text. */
std::string_view takeLine(std::string_view& text);

template <typename T>
std::optional<T>
parseFileValue(std::string_view word)
{
  const bool has_plus = word.size() > 1 && word[0] == '+' && word[1] != '-';
  const std::string_view bare = has_plus ? word.substr(1) : word;
  if (const std::optional<T> value = parseValue<T>(bare))
    return value;
  if constexpr (std::is_floating_point_v<T>) {
    const std::optional<double> value = parseMicrosoftValue(bare);
    return value ? std::optional<T>(static_cast<T>(*value)) : std::nullopt;
  }
  else {
    using Signed = std::make_signed_t<T>;
    if (const std::optional<Signed> value = parseValue<Signed>(bare))
      return static_cast<T>(*value); // negative, of an unsigned type
    const std::optional<double> value = parseFileValue<double>(bare);
    if (!value)
      return std::nullopt;
    if (std::isnan(*value))
      return T{0};
    const double whole = std::trunc(*value);
    const double end = std::ldexp(1.0, std::numeric_limits<T>::digits);
    const double begin = std::is_signed_v<T> ? -end : 0.0;
    return whole >= begin && whole < end ? std::optional<T>(static_cast<T>(whole))
                                         : std::nullopt;
  }
}

} // namespace pcl::app
