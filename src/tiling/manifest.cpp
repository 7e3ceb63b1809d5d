// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is complete in a directory of tiles: one line of JSON for each step.

#include "tiling/manifest.h"

#include "tiling/checked_file.h"

#include <pcl/tiling/point_source.h>

#include <filesystem>
#include <optional>
#include <string_view>

namespace pcl::tiling {
namespace {

// A line is {"check":"01234567","record":RECORD}; the check is that of RECORD's bytes.
constexpr std::string_view before_check = "{\"check\":\"",
                           after_check = "\",\"record\":";
constexpr std::size_t check_digits = 8;

std::string
lineOf(const Manifest::Record& record)
{
  const std::string text = record.dump();
  return std::string(before_check) + toText(checksumOf(text.data(), text.size())) +
         std::string(after_check) + text + "}\n";
}

/** Nothing if the line is not as it was written. */
std::optional<Manifest::Record>
recordOf(std::string_view line)
{
  constexpr std::size_t begin = before_check.size() + check_digits + after_check.size();
  if (line.size() <= begin + 1 || line.back() != '}')
    return std::nullopt;
  const std::string_view text = line.substr(begin, line.size() - begin - 1);
  auto record = Manifest::Record::parse(text, nullptr, false);
  if (record.is_discarded() || lineOf(record) != std::string(line) + '\n')
    return std::nullopt;
  return record;
}

} // namespace

Manifest::Manifest(const std::string& path, bool repairs) : path_(path)
{
  if (sizeOfFile(path) < 0)
    return;
  const Bytes bytes = readWhole(path);
  const std::string_view text(reinterpret_cast<const char*>(bytes.data()),
                              bytes.size());
  std::size_t begin = 0;
  for (std::size_t end = 0; (end = text.find('\n', begin)) != std::string_view::npos;
       begin = end + 1) {
    auto record = recordOf(text.substr(begin, end - begin));
    if (!record)
      throw TilingError(path + ": line " + std::to_string(records_.size() + 1) +
                        " was changed; expected a manifest as it was written: remove "
                        "its directory to begin anew");
    records_.push_back(std::move(*record));
  }
  if (!repairs || begin == text.size())
    return;
  std::error_code error;
  std::filesystem::resize_file(path, begin, error);
  if (error)
    throw TilingError(path + ": cannot be written: " + error.message());
}

void
Manifest::add(const Record& record)
{
  const std::string line = lineOf(record);
  appendTo(path_, line.data(), line.size());
  records_.push_back(record);
}

} // namespace pcl::tiling
