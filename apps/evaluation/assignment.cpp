// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Shortest augmenting paths in a square of costs.

#include "evaluation/assignment.h"

#include <algorithm>
#include <limits>

namespace pcl::app {
namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/** Costs are minus the gains; rows and columns that fill up the square cost nothing. */
class Matching {
public:
  explicit Matching(const std::vector<std::vector<double>>& gains)
  : gains_(gains)
  , columns_(gains.empty() ? 0 : gains.front().size())
  , size_(std::max(gains.size(), columns_))
  , row_potentials_(size_, 0.0)
  , column_potentials_(size_, 0.0)
  , row_of_(size_, nobody)
  {
    for (std::size_t row = 0; row < gains_.size(); ++row)
      addRow(row);
  }

  std::vector<std::optional<std::size_t>>
  columnsOfRows() const
  {
    std::vector<std::optional<std::size_t>> columns(gains_.size());
    for (std::size_t column = 0; column < columns_; ++column)
      if (row_of_[column] < gains_.size())
        columns[row_of_[column]] = column;
    return columns;
  }

private:
  /** Never negative, and 0 on the paths that may be taken. */
  double
  reducedCost(std::size_t row, std::size_t column) const
  {
    const bool exists = row < gains_.size() && column < columns_;
    return (exists ? -gains_[row][column] : 0.0) - row_potentials_[row] -
           column_potentials_[column];
  }

  /** Dijkstra's algorithm from the new row to a column that has none. */
  void
  addRow(std::size_t new_row)
  {
    std::vector<double> distances(size_, std::numeric_limits<double>::infinity());
    std::vector<std::size_t> previous(size_, nobody); // column before, nobody: new_row
    std::vector<bool> reached(size_, false);
    std::vector<std::size_t> path;
    double distance = 0.0;
    std::size_t row = new_row;
    std::size_t from = nobody;
    while (row != nobody) {
      for (std::size_t column = 0; column < size_; ++column) {
        const double reach = distance + reducedCost(row, column);
        if (reached[column] || reach >= distances[column])
          continue;
        distances[column] = reach;
        previous[column] = from;
      }
      from = nearestOf(distances, reached);
      reached[from] = true;
      path.push_back(from);
      distance = distances[from];
      row = row_of_[from];
    }
    row_potentials_[new_row] += distance;
    for (const std::size_t column : path) {
      column_potentials_[column] -= distance - distances[column];
      if (row_of_[column] != nobody)
        row_potentials_[row_of_[column]] += distance - distances[column];
    }
    for (; previous[from] != nobody; from = previous[from])
      row_of_[from] = row_of_[previous[from]];
    row_of_[from] = new_row;
  }

  static std::size_t
  nearestOf(const std::vector<double>& distances, const std::vector<bool>& reached)
  {
    std::size_t nearest = nobody;
    for (std::size_t column = 0; column < distances.size(); ++column)
      if (!reached[column] &&
          (nearest == nobody || distances[column] < distances[nearest]))
        nearest = column;
    return nearest;
  }

  const std::vector<std::vector<double>>& gains_;
  std::size_t columns_;
  std::size_t size_;
  std::vector<double> row_potentials_;
  std::vector<double> column_potentials_;
  std::vector<std::size_t> row_of_; ///< of each column
};

} // namespace

std::vector<std::optional<std::size_t>>
bestAssignment(const std::vector<std::vector<double>>& gains)
{
  return Matching(gains).columnsOfRows();
}

} // namespace pcl::app
