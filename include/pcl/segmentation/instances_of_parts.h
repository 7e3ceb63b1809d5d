/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/segmentation/shape_instance_segmentation.h>

#include <array>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <vector>

namespace pcl {

/** \brief A place that an instance of a class may hold. \ingroup segmentation */
struct InstancePoint {
  std::array<float, 3> position{}; ///< meters
  std::array<float, 3> normal{};   ///< unit; NaN unknown
  float spacing = 0.0f;            ///< meters
  float likelihood = 0.0f;         ///< of the class; NaN unknown
  float edge = 0.0f;               ///< likelihood of an edge
};

/** \brief A place that stands for those around it. */
struct InstanceNode {
  std::array<float, 3> place{};    ///< no other node has it
  std::array<float, 3> position{}; ///< the mean of the places around it
  std::array<float, 3> normal{};   ///< unit
  float spacing = 0.0f;            ///< meters
  float noise = 0.0f;              ///< in spacings
};

/** \brief Which nodes of a part are of one piece of surface. */
struct LinkedNodes {
  static constexpr std::uint32_t none = 0xffffffffU; ///< of a node without a piece

  std::uint32_t pieces = 0;         ///< how many there are, as far as the part knows
  std::vector<std::uint32_t> piece; ///< of each node of the part, or none
  /** \brief A piece, and the number of a node of another part which is of the same
   * piece, unless it is of none. */
  std::vector<std::array<std::uint32_t, 2>> outward;
};

/** \brief What a part adds to a label. The bytes are all used. */
struct LabelCount {
  std::uint64_t points = 0;      ///< with the label
  std::uint64_t high_points = 0; ///< with the high likelihood
  std::array<float, 3> first{};  ///< of the positions, in the order of coordinates
  std::int32_t label = 0;        ///< which one
};

/** \brief Instances of a class over the parts of a cloud, step by step: each step works
 * on one part with what is around it, and the numbers of the whole cloud. The results
 * are those of ShapeInstanceSegmentation for the cloud, bit by bit.
 *
 * 1. nodes() of each part; 2. link() them; 3. unite the pieces of all parts, and cut()
 * each of them; 4. labels() of points, count() them, and rank them by pieceRanks(); 5.
 * grow() these, count() again, and rank by instanceRanks(). */
class PCL_SHAPE_EXPORTS InstancesOfParts {
public:
  /** \param[in] numbers of the whole cloud \param[in] limits what counts as an instance
   * \param[in] threads 0 for all cores */
  InstancesOfParts(const CloudNumbers& numbers,
                   const InstanceLimits& limits,
                   unsigned threads);

  /** \brief How far, in meters along each axis, a step looks from a place to others:
   * for nodes and growth to points, for links and labels to the places of nodes. */
  struct Reach {
    double nodes = 0.0;  ///< of nodes()
    double links = 0.0;  ///< of link()
    double labels = 0.0; ///< of labels()
    double growth = 0.0; ///< of grow()
  };

  /** \brief That of each step, for the numbers of the cloud. */
  Reach reach() const;

  /** \brief Turn the normal towards where the point was seen from. */
  static void turn(const std::array<float, 3>& view_point, InstancePoint& point);

  /** \brief Which points can be part of an instance. The others are not needed. */
  std::vector<bool> mayHold(const std::vector<InstancePoint>& points) const;

  /** \brief The nodes of the part. \param[in] points those of the part first, then
   * those around it that instances may hold \param[in] own how many are of the part */
  std::vector<InstanceNode> nodes(const std::vector<InstancePoint>& points,
                                  std::size_t own) const;

  /** \brief The pieces of surface of the part's nodes. \param[in] nodes those of the
   * part first \param[in] own how many are of the part */
  LinkedNodes link(const std::vector<InstanceNode>& nodes, std::size_t own) const;

  /** \brief Cut pieces where primitives do not meet. \param[in] pieces how many there
   * are \param[in] nodesOf gives all nodes of a piece of the cloud, in any order; it is
   * called by several threads \return for each piece the group of each of these nodes,
   * from 0; -1 none */
  std::vector<std::vector<std::int32_t>>
  cut(std::size_t pieces,
      const std::function<std::vector<InstanceNode>(std::size_t)>& nodesOf) const;

  /** \brief The label of the node that each of the part's points belongs to, -1 none.
   * \param[in] points those of the part \param[in] nodes those of the part, and those
   * around it \param[in] labels one for each node, -1 none */
  std::vector<std::int32_t> labels(const std::vector<InstancePoint>& points,
                                   std::vector<InstanceNode> nodes,
                                   const std::vector<std::int32_t>& labels) const;

  /** \brief Spread labels to points around them, those on edges included.
   * \param[in] points those of the part first \param[in] labels one for each point, the
   * ranks of their pieces; -1 none \return those of all points: the part's are right */
  std::vector<std::int32_t> grow(const std::vector<InstancePoint>& points,
                                 std::vector<std::int32_t> labels) const;

  /** \brief What some points add to each of their labels, in the order of labels. */
  std::vector<LabelCount> count(const std::vector<InstancePoint>& points,
                                const std::vector<std::int32_t>& labels) const;

  /** \brief Add counts of a part to those of all, of which the place is the label. */
  static void add(const std::vector<LabelCount>& part, std::vector<LabelCount>& all);

  /** \brief The rank of each label, the largest first; -1 for pieces of too few points
   * with a high likelihood, but these count in the ranks of the others. */
  std::vector<std::int32_t> pieceRanks(const std::vector<LabelCount>& all) const;

  /** \brief The number of each label's instance from 0, the largest first; -1 for those
   * with too few points. */
  std::vector<std::int32_t> instanceRanks(const std::vector<LabelCount>& all) const;

private:
  CloudNumbers numbers_;
  InstanceLimits limits_;
  unsigned threads_;
};

} // namespace pcl
