// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// This library and the paper's method.

#include "peer.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <limits>

namespace peers {
namespace {

using Edges = pcl::ShapeEdgeDetection<pcl::PointXYZ, pcl::Normal>;
using Surfaces = pcl::ShapeBackProjection<pcl::PointXYZ, pcl::Normal>;

/** 1 for the points of the class that is looked for, 0 for others, NaN in no class. */
template <typename Detector>
Scores
detect(Detector& detector, const LabeledCloud& cloud, std::size_t looked_for)
{
  detector.setInputCloud(cloud.points);
  detector.setNumberOfThreads(1);
  std::vector<pcl::PointIndices> classes;
  detector.segment(classes);
  Scores scores(cloud.points->size(), std::numeric_limits<float>::quiet_NaN());
  for (std::size_t c = 0; c < classes.size(); ++c)
    for (const pcl::index_t i : classes[c].indices)
      scores[static_cast<std::size_t>(i)] = c == looked_for ? 1.0f : 0.0f;
  return scores;
}

template <typename Detector>
Setting
defaultMode(std::size_t looked_for)
{
  return {"no options", [=](const LabeledCloud& cloud) {
            Detector detector;
            return detect(detector, cloud, looked_for);
          }};
}

template <typename Detector>
Setting
paperMode(const pcl::INADParameters& parameters,
          std::size_t bins,
          std::size_t looked_for)
{
  return {"the paper's radii", [=](const LabeledCloud& cloud) {
            Detector detector;
            detector.setMode(Detector::PAPER);
            detector.setModel(pcl::ShapeModel::idealPlane(parameters, bins));
            return detect(detector, cloud, looked_for);
          }};
}

template <typename Detector>
std::vector<Peer>
ownMethods(const pcl::INADParameters& papers, std::size_t looked_for)
{
  constexpr float is_member = 0.5f;
  std::vector<Peer> methods{
      {"pcl_shape, default mode", {defaultMode<Detector>(looked_for)}, is_member}};
  for (const std::size_t bins : {10, 20}) {
    const std::string size = std::to_string(bins) + "×" + std::to_string(bins);
    methods.push_back({"paper mode, " + size,
                       {paperMode<Detector>(papers, bins, looked_for)},
                       is_member});
  }
  return methods;
}

} // namespace

std::vector<Peer>
ownEdges()
{
  return ownMethods<Edges>(pcl::INADParameters::edges(), 0);
}

std::vector<Peer>
ownSurfaces()
{
  return ownMethods<Surfaces>(pcl::INADParameters::surfaces(), 1);
}

} // namespace peers
