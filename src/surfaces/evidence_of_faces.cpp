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
              const std::vector<float>& evidence,
              float reach,
              const Bounds& bounds)
  : nodes_(knownOf(level, evidence))
  , grid_(positionsOf(nodes_), reach, bounds)
  , reach_(reach)
  {}

  float
  evidenceAt(const Eigen::Vector3f& point) const
  {
    float nearest = std::numeric_limits<float>::infinity();
    float evidence = std::numeric_limits<float>::quiet_NaN();
    grid_.forEachWithin(point, reach_, [&](std::uint32_t k, float squared) {
      const float off = nodes_[k].normal.dot(point - nodes_[k].position);
      if (const float distance = squared + off_plane * off * off; distance < nearest) {
        nearest = distance;
        evidence = nodes_[k].evidence;
      }
    });
    return evidence;
  }

private:
  struct Node {
    Eigen::Vector3f position, normal;
    float evidence;
  };

  static std::vector<Node>
  knownOf(const FaceLevel& level, const std::vector<float>& evidence)
  {
    std::vector<Node> nodes;
    for (std::size_t i = 0; i < evidence.size(); ++i)
      if (!std::isnan(evidence[i]))
        nodes.push_back({level.nodes[i].position, level.nodes[i].normal, evidence[i]});
    return nodes;
  }

  std::vector<Node> nodes_;
  PointGrid grid_;
  float reach_;
};

} // namespace

std::vector<float>
evidenceOfFaces(const XYZView& points,
                const FacePyramid& faces,
                const std::vector<float>& of_nodes,
                float spacing,
                const Bounds& bounds,
                unsigned threads)
{
  const NearestFace nearest(
      faces.levels.front(), of_nodes, nearest_face_spacings * spacing, bounds);
  std::vector<float> evidence(points.size, std::numeric_limits<float>::quiet_NaN());
  kernels::parallelForEach(evidence.size(), threads, [&](std::size_t i) {
    const std::uint32_t node = faces.node_of_point[i];
    if (node != FacePyramid::none)
      evidence[i] = of_nodes[node];
    else if (kernels::isFinite(points[i]))
      evidence[i] = nearest.evidenceAt(positionOf(points, i));
  });
  return evidence;
}

} // namespace pcl::segmentation
