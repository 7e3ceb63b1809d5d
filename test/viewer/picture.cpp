// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Reads PNG files and counts colors in parts of them.

#include "picture.h"

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <png.h>
#include <stdexcept>

namespace pcl_shape_test {
namespace {

struct Columns {
  int first, end;
};

Columns
between(double from, double to, int size)
{
  return {static_cast<int>(std::lround(from * size)),
          static_cast<int>(std::lround(to * size))};
}

} // namespace

Picture::Picture(const std::string& path)
{
  png_image image;
  std::memset(&image, 0, sizeof image);
  image.version = PNG_IMAGE_VERSION;
  if (png_image_begin_read_from_file(&image, path.c_str()) == 0)
    throw std::runtime_error(path + ": " + image.message);
  image.format = PNG_FORMAT_RGB;
  pixels_.resize(PNG_IMAGE_SIZE(image));
  if (png_image_finish_read(&image, nullptr, pixels_.data(), 0, nullptr) == 0)
    throw std::runtime_error(path + ": " + image.message);
  width_ = static_cast<int>(image.width);
  height_ = static_cast<int>(image.height);
}

std::size_t
Picture::count(const Pixel& color, const Part& part) const
{
  constexpr int tolerance = 6;
  const Columns columns = between(part.left, part.right, width_);
  const Columns rows = between(part.top, part.bottom, height_);
  std::size_t found = 0;
  for (int y = rows.first; y < rows.end; ++y)
    for (int x = columns.first; x < columns.end; ++x) {
      const std::uint8_t* const pixel =
          &pixels_[3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
                        static_cast<std::size_t>(x))];
      found += std::abs(pixel[0] - color.r) <= tolerance &&
               std::abs(pixel[1] - color.g) <= tolerance &&
               std::abs(pixel[2] - color.b) <= tolerance;
    }
  return found;
}

double
Picture::share(const Pixel& color, const Part& part) const
{
  return static_cast<double>(count(color, part)) / static_cast<double>(size(part));
}

std::size_t
Picture::size(const Part& part) const
{
  const Columns columns = between(part.left, part.right, width_);
  const Columns rows = between(part.top, part.bottom, height_);
  return static_cast<std::size_t>(columns.end - columns.first) *
         static_cast<std::size_t>(rows.end - rows.first);
}

} // namespace pcl_shape_test
