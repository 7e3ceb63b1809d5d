// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A picture of the viewer, and the colors in parts of it.

#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace pcl_shape_test {

struct Pixel {
  int r, g, b;
};

/** A part of a picture: from 0 at the left and at the top to 1. */
struct Part {
  double left = 0.0, top = 0.0, right = 1.0, bottom = 1.0;
};

/** \brief A PNG file. */
class Picture {
public:
  /** \throws std::runtime_error if it is none */
  explicit Picture(const std::string& path);

  int
  width() const
  {
    return width_;
  }

  int
  height() const
  {
    return height_;
  }

  /** \brief How many pixels a part has. */
  std::size_t size(const Part& part) const;

  /** \brief How many pixels of a part have this color, give or take 6 in each channel.
   */
  std::size_t count(const Pixel& color, const Part& part = {}) const;

  /** \brief The same over the number of pixels of the part. */
  double share(const Pixel& color, const Part& part = {}) const;

private:
  int width_ = 0;
  int height_ = 0;
  std::vector<std::uint8_t> pixels_;
};

} // namespace pcl_shape_test
