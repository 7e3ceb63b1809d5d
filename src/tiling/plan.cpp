// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How sources are divided into tiles, from the counts of their sections.

#include "tiling/plan.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <utility>

namespace pcl::tiling {
namespace {

/** Before the cells of a survey. */
struct SurveyHeader {
  std::uint64_t finite = 0, not_finite = 0, cells = 0;
  std::int64_t exponent = 0; ///< of the size of the cells
};

} // namespace

std::array<float, 3>
floatsOf(const Position& point, const Position& offset)
{
  std::array<float, 3> floats;
  for (std::size_t axis = 0; axis < 3; ++axis)
    floats[axis] = static_cast<float>(point[axis] - offset[axis]);
  return floats;
}

bool
isFinite(const std::array<float, 3>& p)
{
  return std::isfinite(p[0]) && std::isfinite(p[1]) && std::isfinite(p[2]);
}

Survey
Survey::ofSection(int exponent)
{
  // Cells grow from a micrometer, and each time all are counted anew: these do not
  // leave the cache. A million points are 32 in a cell then, and tiles have thousands.
  // Eight sections have as many cells as there may be of all.
  constexpr std::size_t max_cells = DensityCells::default_max_cells / 8;
  return {DensityCells(max_cells, exponent)};
}

void
Survey::add(const Position* points, std::size_t count, const Position& offset)
{
  std::vector<float> of_finite;
  of_finite.reserve(3 * count);
  for (std::size_t i = 0; i < count; ++i)
    if (const std::array<float, 3> floats = floatsOf(points[i], offset);
        isFinite(floats))
      of_finite.insert(of_finite.end(), floats.begin(), floats.end());
  const std::size_t added = of_finite.size() / 3;
  cells.add(of_finite.data(), added);
  finite += added;
  not_finite += count - added;
}

void
Survey::add(const Bytes& bytes)
{
  SurveyHeader header;
  if (bytes.size() >= sizeof header)
    std::memcpy(&header, bytes.data(), sizeof header);
  std::vector<Cell> of_bytes((bytes.size() - std::min(bytes.size(), sizeof header)) /
                             sizeof(Cell));
  const std::size_t size = of_bytes.size() * sizeof(Cell);
  if (of_bytes.size() != header.cells || bytes.size() != sizeof header + size)
    throw TilingError("a survey has " + std::to_string(bytes.size()) +
                      " bytes; expected those of " + std::to_string(header.cells) +
                      " cells");
  std::copy_n(bytes.begin() + sizeof header,
              size,
              reinterpret_cast<std::uint8_t*>(of_bytes.data()));
  finite += header.finite;
  not_finite += header.not_finite;
  cells.add(CellGrid{static_cast<int>(header.exponent)}, of_bytes);
}

Bytes
Survey::toBytes() const
{
  const std::vector<Cell> sorted = cells.counts().sorted();
  const SurveyHeader header{finite, not_finite, sorted.size(), cells.grid().exponent};
  Bytes bytes(sizeof header + sorted.size() * sizeof(Cell));
  std::memcpy(bytes.data(), &header, sizeof header);
  const auto* const from = reinterpret_cast<const std::uint8_t*>(sorted.data());
  std::copy_n(from, sorted.size() * sizeof(Cell), bytes.begin() + sizeof header);
  return bytes;
}

Plan
planOf(const Survey& survey,
       const Position& offset,
       std::uint64_t max_points,
       double max_edge)
{
  if (survey.finite == 0)
    throw TilingError("none of " + std::to_string(survey.not_finite) +
                      " points is finite; expected at least one");
  Plan plan{offset,
            TileTree(survey.cells, max_points, max_edge),
            {},
            survey.finite,
            survey.not_finite,
            survey.cells.typicalDistance()};
  plan.points.resize(plan.tree.size());
  for (const auto& [key, count] : survey.cells.counts().cells())
    plan.points[plan.tree.tileOf(key)] += count;
  return plan;
}

nlohmann::ordered_json
toJson(const Plan& plan)
{
  nlohmann::ordered_json nodes = nlohmann::ordered_json::array();
  for (const TileTree::Node& node : plan.tree.nodes())
    nodes.push_back({node.axis, node.cut, node.first, node.second});
  return {{"offset", plan.offset},
          {"cell", plan.tree.grid().exponent},
          {"nodes", nodes},
          {"points", plan.points},
          {"finite", plan.finite},
          {"not_finite", plan.not_finite},
          {"typical_distance", plan.typical_distance}};
}

Plan
planOf(const nlohmann::ordered_json& record)
{
  std::vector<TileTree::Node> nodes;
  for (const nlohmann::ordered_json& node : record.at("nodes"))
    nodes.push_back({node.at(0), node.at(1), node.at(2), node.at(3)});
  return {record.at("offset"),
          TileTree(CellGrid{record.at("cell")}, std::move(nodes)),
          record.at("points"),
          record.at("finite"),
          record.at("not_finite"),
          record.at("typical_distance")};
}

} // namespace pcl::tiling
