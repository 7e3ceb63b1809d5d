// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The faces of a cloud as linked means of cells, at several sizes of cells.

#pragma once

#include "geometry/cell_order.h"

#include <pcl/segmentation/shape_field.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::segmentation {

/** \brief The mean of the points of one face in one cell of space. */
struct FaceNode {
  Eigen::Vector3f position = Eigen::Vector3f::Zero();
  Eigen::Vector3f normal = Eigen::Vector3f::Zero(); ///< unit, of either sign
  float count = 0.0f;                               ///< of points
  float spacing = 0.0f;                             ///< of the points, mean
};

/** \brief Nodes of one size of cells, and which of them follow each other on a face. */
struct FaceLevel {
  float cell = 0.0f;
  std::vector<FaceNode> nodes;
  std::vector<Eigen::Matrix3f> scatters;  ///< of each: sum of products about the mean
  std::vector<std::uint32_t> link_begins; ///< of each node in links, and the end
  std::vector<std::uint32_t> links;       ///< both ways
  std::vector<std::uint32_t> parents;     ///< in the next level; none in the last
};

/** \brief A node, and one that follows it. */
using FaceLink = std::pair<std::uint32_t, std::uint32_t>;

/** \brief Set the links of a level, in the order of nodes and once each. */
void
setLinks(const std::vector<FaceLink>& links, FaceLevel& level, unsigned threads = 1);

/** \brief Levels from small cells to large ones, each twice the size of the last. */
struct FacePyramid {
  static constexpr std::uint32_t none = 0xffffffffU;

  std::vector<FaceLevel> levels;
  std::vector<std::uint32_t> node_of_point; ///< of the first level, or none
  std::vector<std::uint32_t> point_of_node; ///< one point of each node there
};

/** \brief The first level: link what is not an edge to faces. Links do not cross edges,
 * nor lead to where the surface turns by more than 45 degrees within a cell: two faces,
 * or two sides of a wall, stay apart however large the cells are. The order of the
 * points does not matter. \param[in] field with its edges \param[in] spacing of the
 * cloud, median \param[in] threads 0 for all cores */
FacePyramid firstFaces(const XYZView& points,
                       const ShapeField& field,
                       float spacing,
                       unsigned threads);

/** \brief The levels above it. \param[in] levels how many in all \param[in] threads 0
 * for all cores */
void addLevels(std::size_t levels, FacePyramid& pyramid, unsigned threads);

/** \brief The size of the cells of the first level. \param[in] noise in spacings */
float firstCell(double noise, float spacing);

/** \brief How far a node of it and one that follows it are apart, at most. */
double firstLink(double cell, double max_spacing);

/** \brief How far a node of it is from the mean of its points, at most.
 * \param[in] noise in spacings */
double layerReach(double noise, float spacing);

/** \brief Nodes of the first level are in this order of the first points in them: by
 * their cells, and by coordinates. */
using PlaceInOrder = std::pair<Cell, std::array<float, 3>>;

/** \param[in] cell the size of the cells */
PlaceInOrder inOrder(const std::array<float, 3>& place, float cell);

/** \brief The nodes of a face around one of them. */
class FaceWindow {
public:
  explicit FaceWindow(const FaceLevel& level)
  : level_(level)
  , visits_(level.nodes.size(), 0)
  {}

  /** \brief The node, then those that links lead to within the radius, by normals that
   * differ from the node's by less than an angle. */
  const std::vector<std::uint32_t>&
  around(std::uint32_t node, float radius, float min_cosine);

private:
  const FaceLevel& level_;
  std::vector<std::uint32_t> visits_; ///< the last search that saw each
  std::uint32_t search_ = 0;
  std::vector<std::uint32_t> found_;
};

} // namespace pcl::segmentation
