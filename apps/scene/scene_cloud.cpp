// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fields of the generated scene, and the counts of its report.

#include "scene/scene_cloud.h"

#include "cli/filter_app.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <set>

namespace pcl::app {
namespace {

using pcl::scene::Scene;

/** The pixels of an image that have depth, or all. */
std::vector<std::size_t>
pixelsOf(const Scene& scene, bool organized)
{
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < scene.surface.size(); ++i)
    if (organized || std::isfinite(scene.xyz[3 * i + 2]))
      pixels.push_back(i);
  return pixels;
}

/** The channels of some pixels. */
template <typename T>
std::vector<T>
gather(const std::vector<T>& image,
       const std::vector<std::size_t>& pixels,
       std::size_t channels = 1)
{
  std::vector<T> values;
  values.reserve(channels * pixels.size());
  for (const std::size_t pixel : pixels)
    for (std::size_t c = 0; c < channels; ++c)
      values.push_back(image[channels * pixel + c]);
  return values;
}

} // namespace

CloudFile
cloudOf(const std::string& name,
        const std::vector<float>& xyz,
        const std::vector<float>& normals,
        const Arguments& arguments)
{
  CloudFile cloud;
  cloud.path = name;
  cloud.blob.width = static_cast<std::uint32_t>(xyz.size() / 3);
  cloud.blob.height = 1;
  const auto setVectors = [&](const std::string& prefix,
                              const std::vector<float>& vectors) {
    for (std::size_t c = 0; c < 3; ++c) {
      std::vector<float> channel;
      channel.reserve(vectors.size() / 3);
      for (std::size_t i = c; i < vectors.size(); i += 3)
        channel.push_back(vectors[i]);
      setField(cloud, prefix + "xyz"[c], channel);
    }
  };
  setVectors("", xyz);
  if (arguments.has("normals"))
    setVectors("normal_", normals);
  return cloud;
}

CloudFile
sceneCloud(const Scene& scene, const Arguments& arguments)
{
  const bool organized = arguments.has("organized");
  const std::vector<std::size_t> pixels = pixelsOf(scene, organized);
  CloudFile cloud = cloudOf("the generated scene",
                            gather(scene.xyz, pixels, 3),
                            gather(scene.normals, pixels, 3),
                            arguments);
  if (organized) {
    cloud.blob.width = scene.width;
    cloud.blob.height = scene.height;
  }
  setField(cloud, "surface", gather(scene.surface, pixels));
  setField(cloud, "edge", gather(scene.edge, pixels));
  setField(cloud, "instance", gather(scene.instance, pixels));
  setField(cloud, "crease_mm", gather(scene.crease_mm, pixels));
  if (arguments.has("faces"))
    setField(cloud, "face", gather(scene.face, pixels));
  return cloud;
}

void
reportScene(const Scene& scene, const CloudFile& cloud, Report& report)
{
  reportPoints(*pointsOf(cloud), report);
  const auto count = [](const std::vector<std::uint32_t>& labels, std::uint32_t label) {
    return static_cast<std::uint64_t>(std::count(labels.begin(), labels.end(), label));
  };
  const auto surface = labelsOf(cloud, "surface");
  report.setCount("counts", "planar", count(surface, pcl::scene::SurfacePlanar));
  report.setCount("counts", "curved", count(surface, pcl::scene::SurfaceCurved));
  report.setCount("counts", "near_creases", count(surface, pcl::scene::SurfaceCrease));
  report.setCount(
      "counts", "edge", count(labelsOf(cloud, "edge"), pcl::scene::EdgeCrease));
  if (scene.objects.empty()) { // of surfaces without a camera
    const std::set<std::uint32_t> seen(scene.instance.begin(), scene.instance.end());
    report.setCount("counts", "objects", seen.size() - seen.count(0));
    return;
  }
  report.setCount("counts", "objects", scene.objects.size());
  report.setCount("counts",
                  "touching_objects",
                  static_cast<std::uint64_t>(std::count_if(
                      scene.objects.begin(), scene.objects.end(), [](const auto& o) {
                        return !o.touches.empty();
                      })));
}

} // namespace pcl::app
