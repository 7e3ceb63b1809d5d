// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points in memory as a source, and a directory for a test.

#pragma once

#include <pcl/tiling/tiled_cloud.h>

#include <algorithm>
#include <filesystem>
#include <random>
#include <string>
#include <unistd.h>
#include <utility>
#include <vector>

namespace pcl_shape_test {

using pcl::tiling::Position;

class MemorySource : public pcl::tiling::PointSource {
public:
  MemorySource(std::string name, std::vector<Position> points, std::string state = "1")
  : name_(std::move(name))
  , state_(std::move(state))
  , points_(std::move(points))
  {}

  std::string
  name() const override
  {
    return name_;
  }

  std::string
  state() const override
  {
    return state_;
  }

  std::size_t
  countSections() const override
  {
    return 3;
  }

  void
  readSection(std::size_t section, const Use& use) const override
  {
    constexpr std::size_t at_a_time = 100;
    const std::size_t end = points_.size() * (section + 1) / countSections();
    for (std::size_t begin = points_.size() * section / countSections(); begin < end;
         begin += at_a_time)
      use(&points_[begin], std::min(at_a_time, end - begin));
  }

private:
  std::string name_, state_;
  std::vector<Position> points_;
};

/** \brief Points on two planes of very different density. */
inline std::vector<Position>
unevenPoints(std::size_t count, unsigned seed)
{
  std::mt19937 engine(seed);
  const auto random = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(engine()) / 4294967296.0;
  };
  std::vector<Position> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(i % 10 == 0 ? Position{random(-50, 50), random(-50, 50), 3.0}
                                 : Position{random(0, 4), 1.0, random(0, 4)});
  return points;
}

class TemporaryDirectory {
public:
  TemporaryDirectory()
  {
    std::string name =
        (std::filesystem::temp_directory_path() / "pcl_shape_tiling_XXXXXX").string();
    path_ = ::mkdtemp(name.data());
  }
  ~TemporaryDirectory()
  {
    std::error_code error;
    std::filesystem::remove_all(path_, error);
  }
  TemporaryDirectory(const TemporaryDirectory&) = delete;
  TemporaryDirectory& operator=(const TemporaryDirectory&) = delete;

  const std::string&
  path() const
  {
    return path_;
  }

private:
  std::string path_;
};

} // namespace pcl_shape_test
