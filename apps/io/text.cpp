// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Splits text into lines and words, and quotes words for messages.

#include "io/text.h"

#include <algorithm>

namespace pcl::app {

std::string
inQuotes(std::string_view word)
{
  constexpr std::size_t max_length = 40; // a message stays on one line
  std::string text(word.substr(0, max_length));
  std::replace_if(
      text.begin(),
      text.end(),
      [](unsigned char c) { return c < ' ' || c > '~'; },
      '?');
  return '\'' + text + (word.size() > max_length ? "...'" : "'");
}

std::vector<std::string_view>
splitWords(std::string_view line)
{
  constexpr std::string_view blanks = " \t\r";
  std::vector<std::string_view> words;
  std::size_t begin = line.find_first_not_of(blanks);
  while (begin != std::string_view::npos) {
    const std::size_t end = std::min(line.find_first_of(blanks, begin), line.size());
    words.push_back(line.substr(begin, end - begin));
    begin = line.find_first_not_of(blanks, end);
  }
  return words;
}

std::vector<std::string_view>
splitPoint(std::string_view line)
{
  std::vector<std::string_view> words = splitWords(line);
  if (!words.empty() && words.front().front() == '#')
    words.clear();
  return words;
}

std::string
toLower(std::string_view word)
{
  std::string lower(word);
  for (char& c : lower)
    if (c >= 'A' && c <= 'Z')
      c = static_cast<char>(c - 'A' + 'a');
  return lower;
}

std::optional<double>
parseMicrosoftValue(std::string_view word)
{
  const bool is_negative = !word.empty() && word.front() == '-';
  const std::string text = toLower(word.substr(is_negative ? 1 : 0));
  // Rounded to few digits, zeros follow: 1.#QNAN00.
  const std::string bare = text.substr(0, text.find_last_not_of('0') + 1);
  if (bare == "1.#inf")
    return is_negative ? -std::numeric_limits<double>::infinity()
                       : std::numeric_limits<double>::infinity();
  for (const char* const name : {"1.#qnan", "1.#snan", "1.#ind", "1.#nan"})
    if (bare == name)
      return std::numeric_limits<double>::quiet_NaN();
  return std::nullopt;
}

std::string_view
withoutByteOrderMark(std::string_view text)
{
  constexpr std::string_view mark = "\xef\xbb\xbf";
  return text.substr(0, mark.size()) == mark ? text.substr(mark.size()) : text;
}

std::optional<std::string>
withNewLines(std::string_view file, std::string_view last, std::string_view format)
{
  bool has_text = false;
  std::size_t begin = 0, end = 0;
  for (bool is_last = false; !is_last; begin = end + 1) {
    end = file.find_first_of("\r\n", begin);
    if (end == std::string_view::npos || file[end] == '\n')
      return std::nullopt;
    const auto words = splitWords(file.substr(begin, end - begin));
    const std::string first = words.empty() ? "" : toLower(words.front());
    constexpr std::string_view ascii = "ascii";
    has_text = has_text || (first == format && words.size() > 1 &&
                            toLower(words[1].substr(0, ascii.size())) == ascii);
    is_last = first == last;
  }
  std::string text(file);
  const auto stop =
      has_text ? text.end() : text.begin() + static_cast<std::ptrdiff_t>(begin);
  std::replace(text.begin(), stop, '\r', '\n');
  return text;
}

std::string_view
takeLine(std::string_view& text)
{
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

} // namespace pcl::app
