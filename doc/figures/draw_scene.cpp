/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include <pcl/PCLPointCloud2.h>
#include <pcl/io/pcd_io.h>
#include <pcl/io/png_io.h>

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <iostream>
#include <stdexcept>
#include <string>
#include <vector>

// Draws the objects of an organized cloud three times, side by side: the surface lit
// from the camera, its planar and curved points, its edge points.
namespace {

struct Color {
  float r, g, b;
};

constexpr Color paper{255, 255, 255};
constexpr Color plain{205, 205, 205};
constexpr Color planar{120, 160, 220};
constexpr Color curved{245, 150, 40};
constexpr Color unknown{90, 90, 90};
constexpr Color crease{200, 20, 40};

/** One field of an organized cloud, as an image. */
template <typename T>
class Image {
public:
  Image(const pcl::PCLPointCloud2& cloud, const std::string& name) : cloud_(cloud)
  {
    for (const pcl::PCLPointField& field : cloud.fields) {
      if (field.name == name) {
        offset_ = field.offset;
        return;
      }
    }
    throw std::runtime_error("the cloud has no field '" + name + "'");
  }

  T
  operator[](std::size_t i) const
  {
    T value;
    std::memcpy(&value, &cloud_.data[i * cloud_.point_step + offset_], sizeof value);
    return value;
  }

private:
  const pcl::PCLPointCloud2& cloud_;
  std::size_t offset_ = 0;
};

/** What the panels show of a cloud. */
struct Scene {
  explicit Scene(const pcl::PCLPointCloud2& cloud)
  : z(cloud, "z")
  , normal_x(cloud, "normal_x")
  , normal_y(cloud, "normal_y")
  , normal_z(cloud, "normal_z")
  , surface(cloud, "surface")
  , edge(cloud, "edge")
  {}

  /** A light above the camera's left shoulder, and some from everywhere. */
  float
  light(std::size_t i) const
  {
    const float toward =
        -(0.35f * normal_x[i] + 0.55f * normal_y[i] + normal_z[i]) / 1.2f;
    return std::isnan(toward) ? 0.5f : 0.3f + 0.7f * std::min(1.f, std::abs(toward));
  }

  Color
  pixel(int panel, std::size_t i) const
  {
    if (!std::isfinite(z[i])) {
      return paper;
    }
    Color color = plain;
    if (panel == 1) {
      color = surface[i] == 1 ? planar : (surface[i] == 2 ? curved : unknown);
    }
    else if (panel == 2 && edge[i] == 1) {
      return crease;
    }
    const float l = light(i);
    return {color.r * l, color.g * l, color.b * l};
  }

  Image<float> z, normal_x, normal_y, normal_z;
  Image<std::uint32_t> surface, edge;
};

/** A part of an image: columns x0 to x1 and rows y0 to y1, without the last. */
struct Part {
  std::size_t x0, y0, x1, y1;
};

/** The objects and a little around them. */
Part
partWithObjects(const pcl::PCLPointCloud2& cloud)
{
  constexpr std::size_t margin = 25;
  const Image<std::uint32_t> instance(cloud, "instance");
  Part part{cloud.width, cloud.height, 0, 0};
  for (std::size_t i = 0; i < std::size_t{cloud.width} * cloud.height; ++i) {
    if (instance[i] != 0) {
      const std::size_t x = i % cloud.width;
      const std::size_t y = i / cloud.width;
      part = {std::min(part.x0, x),
              std::min(part.y0, y),
              std::max(part.x1, x + 1),
              std::max(part.y1, y + 1)};
    }
  }
  if (part.x1 == 0) {
    throw std::runtime_error("the cloud has no objects");
  }
  return {part.x0 - std::min(part.x0, margin),
          part.y0 - std::min(part.y0, margin),
          std::min<std::size_t>(part.x1 + margin, cloud.width),
          std::min<std::size_t>(part.y1 + margin, cloud.height)};
}

void
setPixel(unsigned char* pixel, const Color& color)
{
  // Fewer tones make a smaller file.
  const auto tone = [](float value) {
    return static_cast<unsigned char>(static_cast<int>(value) / 4 * 4 + 3);
  };
  pixel[0] = tone(color.r);
  pixel[1] = tone(color.g);
  pixel[2] = tone(color.b);
}

void
draw(const std::string& input, const std::string& output)
{
  pcl::PCLPointCloud2 cloud;
  if (pcl::io::loadPCDFile(input, cloud) != 0 || cloud.height < 2) {
    throw std::runtime_error(input + ": an organized cloud is needed");
  }
  constexpr std::size_t panels = 3;
  constexpr std::size_t gap = 6;
  const Scene scene(cloud);
  const Part part = partWithObjects(cloud);
  const std::size_t columns = part.x1 - part.x0;
  const std::size_t rows = part.y1 - part.y0;
  const std::size_t width = panels * columns + (panels - 1) * gap;
  std::vector<unsigned char> picture(3 * width * rows, 255);
  for (std::size_t panel = 0; panel < panels; ++panel) {
    for (std::size_t y = 0; y < rows; ++y) {
      for (std::size_t x = 0; x < columns; ++x) {
        const std::size_t point = (part.y0 + y) * cloud.width + part.x0 + x;
        setPixel(&picture[3 * (y * width + panel * (columns + gap) + x)],
                 scene.pixel(static_cast<int>(panel), point));
      }
    }
  }
  pcl::io::saveRgbPNGFile(
      output, picture.data(), static_cast<int>(width), static_cast<int>(rows));
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 3) {
    std::cerr << "usage: draw_scene in.pcd out.png\n"
                 "in.pcd: organized, with normals and the fields surface, edge and "
                 "instance\n";
    return 2;
  }
  try {
    draw(argv[1], argv[2]);
  }
  catch (const std::exception& error) {
    std::cerr << "draw_scene: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
