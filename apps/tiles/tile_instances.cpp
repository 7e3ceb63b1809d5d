// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Instances of a class over tiles: steps of tiles, and between them steps of one
// process that unites, cuts and ranks what tiles have found.

#include "tiles/tile_instances.h"

#include "tiles/tile_pieces.h"
#include "tiles/tile_places.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <utility>

namespace pcl::app {
namespace {

using pcl::InstanceNode;
using pcl::InstancePoint;
using pcl::InstancesOfParts;
using pcl::LabelCount;
using pcl::tiling::TiledCloud;

constexpr std::uint32_t none = 0xffffffffU; // no point of instances at a row
const std::string nodes_name = "nodes", links_name = "links", pieces_name = "pieces";
const std::string labels_name = "labels", ranks_name = "ranks";
const std::string grown_name = "grown", instances_name = "instances";

std::vector<InstancePoint>
pointsOf(const TiledCloud& cloud, std::size_t tile)
{
  return takeFrom<std::vector<InstancePoint>>(
      cloud.resultOf(instance_points_name, tile));
}

Eigen::Vector3d
positionOf(const InstancePoint& point)
{
  return Eigen::Vector3f(point.position.data()).cast<double>();
}

/** The box of some points, grown along each axis. */
Eigen::AlignedBox3d
grownBox(const std::vector<InstancePoint>& points, double by)
{
  Eigen::AlignedBox3d box;
  for (const InstancePoint& point : points)
    box.extend(positionOf(point));
  const Eigen::Vector3d margin = Eigen::Vector3d::Constant(by);
  return {box.min() - margin, box.max() + margin};
}

/** Labels of a tile's points: numbers of its own, and what they are in the cloud. */
struct TileLabels {
  std::vector<LabelCount> counts;   ///< of the labels that it has
  std::vector<std::int32_t> places; ///< of each point's label among these; -1 none
};

Bytes
labelBytes(const InstancesOfParts& parts,
           const std::vector<InstancePoint>& points,
           const std::vector<std::int32_t>& labels)
{
  const std::vector<LabelCount> counts = parts.count(points, labels);
  std::vector<std::int32_t> places;
  for (const std::int32_t label : labels) {
    const auto found = std::lower_bound(
        counts.begin(), counts.end(), label, [](const LabelCount& count, auto l) {
          return count.label < l;
        });
    places.push_back(label < 0 ? -1
                               : static_cast<std::int32_t>(found - counts.begin()));
  }
  return bytesOf(counts, places);
}

TileLabels
labelsOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  TileLabels labels;
  ByteReader(cloud.resultOf(name, tile)).take(labels.counts, labels.places);
  return labels;
}

/** The rank of each label of a tile in the cloud, and how many the cloud has. */
struct TileRanks {
  std::uint64_t count = 0;
  std::vector<std::int32_t> ranks;
};

TileRanks
ranksOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  TileRanks ranks;
  ByteReader(cloud.resultOf(name, tile)).take(ranks.count, ranks.ranks);
  return ranks;
}

/** For each point of a tile the rank of its label; -1 none. */
std::vector<std::int32_t>
ranksOfPoints(const TiledCloud& cloud,
              const std::string& labels,
              const std::string& ranks,
              std::size_t tile)
{
  std::vector<std::int32_t> result = labelsOf(cloud, labels, tile).places;
  const TileRanks of_labels = ranksOf(cloud, ranks, tile);
  for (std::int32_t& label : result)
    if (label >= 0)
      label = of_labels.ranks[static_cast<std::size_t>(label)];
  return result;
}

/** The steps in their order. */
class Steps {
public:
  explicit Steps(const MeasuredCloud& cloud)
  : measured_(cloud)
  , cloud_(cloud.tiles)
  , parts_(cloud.numbers, {}, cloud.threads)
  {}

  void
  run()
  {
    cloud_.runOnResults(nodes_name, [&](std::size_t tile) { return nodesOf(tile); });
    cloud_.runOnResults(links_name, [&](std::size_t tile) { return linksOf(tile); });
    cloud_.runAtOnce(pieces_name, [&](const TiledCloud::Write& write) {
      cutPieces(cloud_, {nodes_name, links_name}, parts_, write);
    });
    cloud_.runOnResults(labels_name, [&](std::size_t tile) { return labelsAt(tile); });
    rank(labels_name, ranks_name, &InstancesOfParts::pieceRanks);
    cloud_.runOnResults(grown_name, [&](std::size_t tile) { return grown(tile); });
    rank(grown_name, instances_name, &InstancesOfParts::instanceRanks);
  }

private:
  Bytes
  nodesOf(std::size_t tile) const
  {
    std::vector<InstancePoint> points = pointsOf(cloud_, tile);
    const std::size_t own = points.size();
    if (own > 0) {
      const Eigen::AlignedBox3d box = grownBox(points, parts_.reach().nodes);
      for (const std::size_t other : measured_.tilesAround(tile, parts_.reach().nodes))
        for (const InstancePoint& point : pointsOf(cloud_, other))
          if (box.contains(positionOf(point)))
            points.push_back(point);
    }
    return bytesOf(parts_.nodes(points, own));
  }

  Bytes
  linksOf(std::size_t tile) const
  {
    std::vector<InstanceNode> nodes = pcl::app::nodesOf(cloud_, nodes_name, tile);
    const std::size_t own = nodes.size();
    std::vector<NodeOfTile> around;
    for (const std::size_t other : measured_.tilesAround(tile, parts_.reach().links)) {
      std::uint32_t number = 0;
      for (const InstanceNode& node : pcl::app::nodesOf(cloud_, nodes_name, other)) {
        nodes.push_back(node);
        around.push_back({static_cast<std::uint32_t>(other), number++});
      }
    }
    return linkBytes(parts_.link(nodes, own), own, around);
  }

  Bytes
  labelsAt(std::size_t tile) const
  {
    const std::vector<InstancePoint> points = pointsOf(cloud_, tile);
    CutNodes all = cutNodesOf(cloud_, nodes_name, pieces_name, tile);
    for (const std::size_t other : measured_.tilesAround(tile, parts_.reach().labels)) {
      const CutNodes some = cutNodesOf(cloud_, nodes_name, pieces_name, other);
      all.nodes.insert(all.nodes.end(), some.nodes.begin(), some.nodes.end());
      all.labels.insert(all.labels.end(), some.labels.begin(), some.labels.end());
    }
    const std::vector<std::int32_t> labels =
        parts_.labels(points, std::move(all.nodes), all.labels);
    return labelBytes(parts_, points, labels);
  }

  Bytes
  grown(std::size_t tile) const
  {
    std::vector<InstancePoint> points = pointsOf(cloud_, tile);
    std::vector<std::int32_t> labels =
        ranksOfPoints(cloud_, labels_name, ranks_name, tile);
    const std::size_t own = points.size();
    if (own > 0) {
      const Eigen::AlignedBox3d box = grownBox(points, parts_.reach().growth);
      for (const std::size_t other :
           measured_.tilesAround(tile, parts_.reach().growth)) {
        const std::vector<InstancePoint> some = pointsOf(cloud_, other);
        const std::vector<std::int32_t> of_some =
            ranksOfPoints(cloud_, labels_name, ranks_name, other);
        for (std::size_t i = 0; i < some.size(); ++i)
          if (box.contains(positionOf(some[i]))) {
            points.push_back(some[i]);
            labels.push_back(of_some[i]);
          }
      }
    }
    labels = parts_.grow(points, std::move(labels));
    points.resize(own);
    labels.resize(own);
    return labelBytes(parts_, points, labels);
  }

  using Rank = std::vector<std::int32_t> (InstancesOfParts::*)(
      const std::vector<LabelCount>& all) const;

  /** From the counts of all tiles to the ranks of their labels. */
  void
  rank(const std::string& labels, const std::string& name, Rank rank)
  {
    cloud_.runAtOnce(name, [&, rank](const TiledCloud::Write& write) {
      std::vector<LabelCount> all;
      forEachTile(cloud_, [&](std::size_t tile) {
        InstancesOfParts::add(labelsOf(cloud_, labels, tile).counts, all);
      });
      const std::vector<std::int32_t> ranks = (parts_.*rank)(all);
      const auto is_some = [](std::int32_t r) { return r >= 0; };
      const auto count = static_cast<std::uint64_t>(
          std::count_if(ranks.begin(), ranks.end(), is_some));
      forEachTile(cloud_, [&](std::size_t tile) {
        std::vector<std::int32_t> of_tile;
        for (const LabelCount& label : labelsOf(cloud_, labels, tile).counts)
          of_tile.push_back(ranks[static_cast<std::size_t>(label.label)]);
        write(tile, bytesOf(count, of_tile));
      });
    });
  }

  const MeasuredCloud& measured_;
  TiledCloud& cloud_;
  InstancesOfParts parts_;
};

} // namespace

Bytes
instancePointsOf(std::vector<InstancePoint> places,
                 const std::vector<std::uint32_t>& place_of_row,
                 const std::vector<std::uint32_t>& rows,
                 const std::array<float, 3>& view_point,
                 const MeasuredCloud& cloud)
{
  const std::vector<bool> is_held =
      InstancesOfParts(cloud.numbers, {}, cloud.threads).mayHold(places);
  std::vector<InstancePoint> points;
  std::vector<std::uint32_t> point_of_place(places.size(), none);
  for (std::size_t i = 0; i < places.size(); ++i)
    if (is_held[i]) {
      point_of_place[i] = static_cast<std::uint32_t>(points.size());
      InstancesOfParts::turn(view_point, places[i]);
      points.push_back(places[i]);
    }
  std::vector<std::uint32_t> point_of_row;
  for (const std::uint32_t place : place_of_row)
    point_of_row.push_back(point_of_place[place]);
  return bytesOf(points, point_of_row, rows);
}

void
findInstances(const MeasuredCloud& cloud)
{
  Steps(cloud).run();
}

TileInstances
instancesOf(const TiledCloud& cloud, std::size_t tile)
{
  std::vector<InstancePoint> points;
  std::vector<std::uint32_t> point_of_row;
  TileInstances result;
  ByteReader(cloud.resultOf(instance_points_name, tile))
      .take(points, point_of_row, result.rows);
  const std::vector<std::int32_t> instances =
      ranksOfPoints(cloud, grown_name, instances_name, tile);
  for (const std::uint32_t point : point_of_row)
    result.of_row.push_back(
        point == none ? 0 : static_cast<std::uint32_t>(instances[point] + 1));
  return result;
}

std::uint64_t
countInstances(const TiledCloud& cloud)
{
  for (std::size_t tile = 0; tile < cloud.size(); ++tile)
    if (cloud.pointsOf(tile) > 0)
      return ranksOf(cloud, instances_name, tile).count;
  return 0;
}

} // namespace pcl::app
