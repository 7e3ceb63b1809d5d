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

std::string_view
takeLine(std::string_view& text)
{
  const std::size_t end = std::min(text.find('\n'), text.size());
  const std::string_view line = text.substr(0, end);
  text.remove_prefix(std::min(end + 1, text.size()));
  return line;
}

} // namespace pcl::app
