// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The evidence of faces at each point: its own face's, or the nearest one's.

#include "surfaces/evidence_of_faces.h"

#include "common/finite.h"
#include "common/parallel.h"

#include <cmath>
#include <limits>

namespace pcl::segmentation {
namespace {

// A face that a point is off from is farther than one that it is beside.
constexpr float off_plane = 8.0f; // of squares

/** The nodes with evidence, to find the nearest. */
class NearestFace {
public:
  NearestFace(const FaceLevel& level,
              const FaceEvidence& evidence,
              float reach,
              const Bounds& bounds)
  : nodes_(knownOf(level, evidence))
  , grid_(positionsOf(nodes_), reach, bounds)
  , reach_(reach)
  {}

  /** \return the number of the nearest node, or none */
  std::uint32_t
  nodeAt(const Eigen::Vector3f& point) const
  {
    float nearest = std::numeric_limits<float>::infinity();
    std::uint32_t node = FacePyramid::none;
    grid_.forEachWithin(point, reach_, [&](std::uint32_t k, float squared) {
      const float off = nodes_[k].normal.dot(point - nodes_[k].position);
      if (const float distance = squared + off_plane * off * off; distance < nearest) {
        nearest = distance;
        node = nodes_[k].number;
      }
    });
    return node;
  }

private:
  struct Node {
    Eigen::Vector3f position, normal;
    std::uint32_t number;
  };

  static std::vector<Node>
  knownOf(const FaceLevel& level, const FaceEvidence& evidence)
  {
    std::vector<Node> nodes;
    for (std::uint32_t i = 0; i < evidence.curved.size(); ++i)
      if (!std::isnan(evidence.curved[i]))
        nodes.push_back({level.nodes[i].position, level.nodes[i].normal, i});
    return nodes;
  }

  std::vector<Node> nodes_;
  PointGrid grid_;
  float reach_;
};

} // namespace

FaceEvidence
evidenceOfFaces(const XYZView& points,
                const FacePyramid& faces,
                const FaceEvidence& of_nodes,
                float spacing,
                const Bounds& bounds,
                unsigned threads)
{
  const NearestFace nearest(
      faces.levels.front(), of_nodes, nearest_face_spacings * spacing, bounds);
  const std::vector<float> unknown(points.size,
                                   std::numeric_limits<float>::quiet_NaN());
  FaceEvidence evidence{unknown, unknown};
  kernels::parallelForEach(points.size, threads, [&](std::size_t i) {
    std::uint32_t node = faces.node_of_point[i];
    if (node == FacePyramid::none && kernels::isFinite(points[i]))
      node = nearest.nodeAt(positionOf(points, i));
    if (node == FacePyramid::none)
      return;
    evidence.curved[i] = of_nodes.curved[node];
    evidence.flat[i] = of_nodes.flat[node];
  });
  return evidence;
}

} // namespace pcl::segmentation
