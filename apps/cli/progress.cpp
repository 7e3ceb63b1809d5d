// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "cli/progress.h"

#include "cli/app.h"

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace pcl::app {
namespace {

std::uint64_t
bytesOf(const std::string& file)
{
  std::error_code error;
  const auto bytes = std::filesystem::file_size(file, error);
  return error ? 0 : bytes;
}

} // namespace

Progress::Progress(std::string app, const std::vector<std::string>& files)
: app_(std::move(app))
, files_(files.size())
{
  for (const std::string& file : files)
    bytes_left_ += bytesOf(file);
}

void
Progress::begin(const std::string& file)
{
  std::string line = app_ + ": " + std::to_string(++begun_) + " of " +
                     std::to_string(files_) + ": " + file;
  if (bytes_processed_ > 0.0) {
    const double left = seconds_ / bytes_processed_ * static_cast<double>(bytes_left_);
    line += ", about " + std::to_string(std::llround(std::ceil(left))) + " s left";
  }
  logLine(line);
  start_ = Clock::now();
}

void
Progress::end(const std::string& file, bool is_processed)
{
  const std::uint64_t bytes = bytesOf(file);
  bytes_left_ -= std::min(bytes, bytes_left_);
  if (!is_processed)
    return;
  bytes_processed_ += static_cast<double>(bytes);
  seconds_ += std::chrono::duration<double>(Clock::now() - start_).count();
}

} // namespace pcl::app
