// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Pieces of surface that run over several tiles, united and cut by one process.

#include "tiles/tile_pieces.h"

#include <boost/pending/disjoint_sets.hpp>

#include <algorithm>
#include <utility>

namespace pcl::app {
namespace {

using pcl::InstanceNode;
using pcl::LinkedNodes;
using pcl::tiling::TiledCloud;

constexpr std::uint32_t none = LinkedNodes::none;
// Some 150 bytes each while pieces are cut: as much as other steps take.
constexpr std::uint64_t nodes_at_a_time = 2000000;

/** A piece of a tile goes on at a node of another tile, unless that is of no piece. */
struct OutwardLink {
  std::uint32_t piece = 0;
  NodeOfTile node;
};

struct TileLinks {
  std::uint32_t pieces = 0;
  std::vector<std::uint32_t> piece; ///< of each node, or none
  std::vector<OutwardLink> outward;
};

TileLinks
linksOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  TileLinks links;
  ByteReader(cloud.resultOf(name, tile)).take(links.pieces, links.piece, links.outward);
  return links;
}

/** The pieces of the cloud: for each tile those of its nodes. */
struct Pieces {
  std::vector<std::vector<std::uint32_t>> of_nodes; ///< or none
  std::vector<std::uint64_t> sizes;                 ///< in nodes
};

/** Numbers the sets of pieces of tiles by the first piece of each. */
template <typename Sets>
Pieces
numberedSets(Sets& sets, std::uint32_t count, Pieces pieces)
{
  std::vector<std::uint32_t> number_of_root(count, none), numbers;
  for (std::uint32_t piece = 0; piece < count; ++piece) {
    std::uint32_t& number = number_of_root[sets.find_set(piece)];
    if (number == none) {
      number = static_cast<std::uint32_t>(pieces.sizes.size());
      pieces.sizes.push_back(0);
    }
    numbers.push_back(number);
  }
  for (std::vector<std::uint32_t>& of_tile : pieces.of_nodes)
    for (std::uint32_t& piece : of_tile)
      if (piece != none) {
        piece = numbers[piece];
        ++pieces.sizes[piece];
      }
  return pieces;
}

Pieces
unitedPieces(const TiledCloud& cloud, const std::string& links_name)
{
  Pieces pieces;
  pieces.of_nodes.resize(cloud.size());
  std::uint32_t count = 0; // of pieces of tiles
  forEachTile(cloud, [&](std::size_t tile) {
    TileLinks links = linksOf(cloud, links_name, tile);
    for (std::uint32_t& piece : links.piece)
      if (piece != none)
        piece += count;
    count += links.pieces;
    pieces.of_nodes[tile] = std::move(links.piece);
  });
  boost::disjoint_sets_with_storage<> sets(count);
  std::uint32_t first = 0; // piece of the tile
  forEachTile(cloud, [&](std::size_t tile) {
    const TileLinks links = linksOf(cloud, links_name, tile);
    for (const OutwardLink& link : links.outward) {
      const std::uint32_t other = pieces.of_nodes[link.node.tile][link.node.number];
      if (other != none)
        sets.union_set(first + link.piece, other);
    }
    first += links.pieces;
  });
  return numberedSets(sets, count, std::move(pieces));
}

/** Cuts some pieces after the other. */
class Cutting {
public:
  Cutting(const TiledCloud& cloud,
          const std::string& nodes_name,
          const pcl::InstancesOfParts& parts,
          const Pieces& pieces)
  : cloud_(cloud)
  , nodes_name_(nodes_name)
  , parts_(parts)
  , pieces_(pieces)
  {
    for (const auto& of_tile : pieces.of_nodes)
      labels_.emplace_back(of_tile.size(), -1);
  }

  /** \return for each tile the labels of its nodes, -1 none */
  const std::vector<std::vector<std::int32_t>>&
  run()
  {
    const std::size_t all = pieces_.sizes.size();
    for (std::size_t begin = 0, end = 0; begin < all; begin = end) {
      std::uint64_t nodes = 0;
      while (end < all &&
             (end == begin || nodes + pieces_.sizes[end] <= nodes_at_a_time))
        nodes += pieces_.sizes[end++];
      cut(begin, end);
    }
    return labels_;
  }

private:
  bool
  hasAny(std::size_t tile, std::size_t begin, std::size_t end) const
  {
    const auto& of_nodes = pieces_.of_nodes[tile];
    return std::any_of(of_nodes.begin(), of_nodes.end(), [&](std::uint32_t piece) {
      return piece >= begin && piece < end;
    });
  }

  void
  cut(std::size_t begin, std::size_t end)
  {
    std::vector<std::vector<InstanceNode>> nodes(end - begin);
    std::vector<std::vector<NodeOfTile>> places(end - begin);
    for (std::size_t tile = 0; tile < pieces_.of_nodes.size(); ++tile) {
      if (!hasAny(tile, begin, end))
        continue;
      const std::vector<InstanceNode> of_tile = nodesOf(cloud_, nodes_name_, tile);
      for (std::uint32_t k = 0; k < of_tile.size(); ++k) {
        const std::size_t piece = pieces_.of_nodes[tile][k];
        if (piece < begin || piece >= end)
          continue;
        nodes[piece - begin].push_back(of_tile[k]);
        places[piece - begin].push_back({static_cast<std::uint32_t>(tile), k});
      }
    }
    const std::vector<std::vector<std::int32_t>> groups =
        parts_.cut(end - begin, [&](std::size_t i) { return std::move(nodes[i]); });
    for (std::size_t i = 0; i < groups.size(); ++i)
      setLabels(places[i], groups[i]);
  }

  void
  setLabels(const std::vector<NodeOfTile>& places,
            const std::vector<std::int32_t>& groups)
  {
    std::int32_t most = -1;
    for (std::size_t k = 0; k < places.size(); ++k)
      if (groups[k] >= 0) {
        labels_[places[k].tile][places[k].number] = next_ + groups[k];
        most = std::max(most, groups[k]);
      }
    next_ += most + 1;
  }

  const TiledCloud& cloud_;
  const std::string& nodes_name_;
  const pcl::InstancesOfParts& parts_;
  const Pieces& pieces_;
  std::vector<std::vector<std::int32_t>> labels_;
  std::int32_t next_ = 0;
};

} // namespace

std::vector<InstanceNode>
nodesOf(const TiledCloud& cloud, const std::string& name, std::size_t tile)
{
  return takeFrom<std::vector<InstanceNode>>(cloud.resultOf(name, tile));
}

Bytes
linkBytes(const LinkedNodes& linked,
          std::size_t own,
          const std::vector<NodeOfTile>& around)
{
  std::vector<OutwardLink> outward;
  for (const auto& [piece, node] : linked.outward)
    outward.push_back({piece, around[node - own]});
  return bytesOf(linked.pieces, linked.piece, outward);
}

void
cutPieces(const TiledCloud& cloud,
          const NamesOfLinks& names,
          const pcl::InstancesOfParts& parts,
          const TiledCloud::Write& write)
{
  const Pieces pieces = unitedPieces(cloud, names.links);
  Cutting cutting(cloud, names.nodes, parts, pieces);
  const std::vector<std::vector<std::int32_t>>& labels = cutting.run();
  forEachTile(cloud, [&](std::size_t tile) { write(tile, bytesOf(labels[tile])); });
}

CutNodes
cutNodesOf(const TiledCloud& cloud,
           const std::string& nodes,
           const std::string& pieces,
           std::size_t tile)
{
  CutNodes result;
  result.nodes = nodesOf(cloud, nodes, tile);
  ByteReader(cloud.resultOf(pieces, tile)).take(result.labels);
  return result;
}

} // namespace pcl::app
