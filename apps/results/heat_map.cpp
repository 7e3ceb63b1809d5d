// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "results/heat_map.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <png.h>
#include <stdexcept>
#include <vector>

namespace pcl::app {
namespace {

constexpr int side = 480; // pixels of the map
constexpr int left = 56, bottom = 44, margin = 24;
constexpr int width = left + side + margin, height = margin + side + bottom;
constexpr int zoom = 2; // of the letters
constexpr int ticks = 5;
constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;

using Color = std::array<std::uint8_t, 3>;
constexpr Color black{0, 0, 0};

/** Letters of 3 x 5 pixels: a row in three bits, the left one first. */
struct Letter {
  char character;
  std::array<std::uint8_t, 5> rows;
};

constexpr Letter letters[] = {{'0', {7, 5, 5, 5, 7}},
                              {'1', {2, 6, 2, 2, 7}},
                              {'2', {7, 1, 7, 4, 7}},
                              {'3', {7, 1, 7, 1, 7}},
                              {'4', {5, 5, 7, 1, 1}},
                              {'5', {7, 4, 7, 1, 7}},
                              {'6', {7, 4, 7, 5, 7}},
                              {'7', {7, 1, 1, 1, 1}},
                              {'8', {7, 5, 7, 5, 7}},
                              {'9', {7, 5, 7, 1, 7}},
                              {'.', {0, 0, 0, 0, 2}},
                              {'m', {0, 5, 7, 5, 5}},
                              {'u', {0, 5, 5, 5, 7}},
                              {'s', {0, 7, 4, 1, 7}},
                              {'i', {2, 0, 2, 2, 2}},
                              {'g', {0, 7, 5, 7, 1}},
                              {'a', {0, 7, 5, 7, 5}},
                              {'d', {1, 1, 7, 5, 7}},
                              {'e', {0, 7, 7, 4, 7}}};

class Picture {
public:
  Picture() : pixels_(std::size_t{3} * width * height, 255) {}

  void
  set(int x, int y, const Color& color)
  {
    if (x >= 0 && x < width && y >= 0 && y < height)
      std::copy(color.begin(),
                color.end(),
                pixels_.begin() + std::ptrdiff_t{3} * (y * width + x));
  }

  void
  write(int x, int y, const std::string& text)
  {
    for (const char character : text) {
      for (const Letter& letter : letters)
        if (letter.character == character)
          draw(x, y, letter);
      x += 4 * zoom;
    }
  }

  std::string
  encode() const
  {
    png_image image;
    std::memset(&image, 0, sizeof image);
    image.version = PNG_IMAGE_VERSION;
    image.width = width;
    image.height = height;
    image.format = PNG_FORMAT_RGB;
    png_alloc_size_t bytes = PNG_IMAGE_PNG_SIZE_MAX(image);
    std::string png(bytes, '\0');
    if (png_image_write_to_memory(
            &image, png.data(), &bytes, 0, pixels_.data(), 0, nullptr) == 0)
      throw std::runtime_error(std::string("libpng: ") + image.message);
    png.resize(bytes);
    return png;
  }

private:
  void
  draw(int x, int y, const Letter& letter)
  {
    for (int row = 0; row < 5 * zoom; ++row)
      for (int column = 0; column < 3 * zoom; ++column)
        if (letter.rows[static_cast<std::size_t>(row / zoom)] >> (2 - column / zoom) &
            1)
          set(x + column, y + row, black);
  }

  std::vector<std::uint8_t> pixels_;
};

/** White, yellow, red, black: the darker, the more. */
Color
colorOf(double share)
{
  const auto channel = [](double value) {
    return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
  };
  return {channel(3.0 - 3.0 * share),
          channel(2.0 - 3.0 * share),
          channel(1.0 - 3.0 * share)};
}

double
shareOf(std::uint64_t count, std::uint64_t peak)
{
  return std::log1p(static_cast<double>(count)) / std::log1p(static_cast<double>(peak));
}

void
drawAxes(const pcl::ShapeHistogram& histogram, Picture& picture)
{
  for (int i = -1; i <= side; ++i)
    for (const int at : {-1, side}) {
      picture.set(left + i, margin + at, black);
      picture.set(left + at, margin + i, black);
    }
  for (int t = 0; t <= ticks; ++t) {
    const auto label = [t](double range) {
      const double degrees = range * degrees_per_radian * t / ticks;
      const std::string text = std::to_string(std::lround(10.0 * degrees));
      const std::string whole = text.size() > 1 ? text.substr(0, text.size() - 1) : "0";
      return text.back() == '0' ? whole : whole + '.' + text.back();
    };
    const int along = side * t / ticks;
    for (int i = 0; i < 6; ++i) {
      picture.set(left + along, margin + side + i, black);
      picture.set(left - i, margin + side - along, black);
    }
    picture.write(left + along - 8, margin + side + 10, label(histogram.muRange()));
    picture.write(left - 42, margin + side - along - 5, label(histogram.sigmaRange()));
  }
  picture.write(left + side / 2 - 24, margin + side + 28, "mu deg");
  picture.write(left - 42, margin - 18, "sigma deg");
}

} // namespace

std::string
heatMap(const pcl::ShapeHistogram& histogram)
{
  Picture picture;
  for (int y = 0; y < side; ++y)
    for (int x = 0; x < side; ++x) {
      const auto i = static_cast<std::size_t>(x) * histogram.muBins() / side;
      const auto j = static_cast<std::size_t>(y) * histogram.sigmaBins() / side;
      const double share = shareOf(histogram.count(i, j), histogram.peak());
      picture.set(left + x, margin + side - 1 - y, colorOf(share));
    }
  drawAxes(histogram, picture);
  return picture.encode();
}

} // namespace pcl::app
