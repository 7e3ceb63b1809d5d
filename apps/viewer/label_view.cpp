// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/label_view.h"

#include "cli/errors.h"
#include "viewer/label_names.h"

#include <pcl/common/point_tests.h>

#include <cmath>
#include <set>

namespace pcl::app {
namespace {

constexpr std::size_t most_labels = 4096; // beyond, whole numbers are just numbers

bool
isWhole(double value)
{
  constexpr double largest_exact = 9007199254740992.0; // 2^53
  return std::abs(value) <= largest_exact && value == std::floor(value);
}

/** Of what has no color of its own: positive numbers in turn, then the others. */
Color
colorOf(std::int64_t label)
{
  const auto size = static_cast<std::size_t>(std::abs(label));
  return distinctColor(label > 0 ? size - 1 : most_labels + size);
}

LabelStyle
styleOf(std::int64_t label,
        const LabelStyles& known,
        const std::map<std::int64_t, std::string>& names)
{
  const auto style = known.find(label);
  LabelStyle result = style != known.end()
                          ? style->second
                          : LabelStyle{std::to_string(label), colorOf(label)};
  if (const auto name = names.find(label); name != names.end())
    result.name = name->second;
  return result;
}

} // namespace

bool
hasLabels(const CloudFile& cloud,
          const std::string& field,
          const std::vector<double>& values)
{
  if (isLabelField(field))
    return true;
  const std::uint8_t type = findField(cloud, field)->datatype;
  if (type == pcl::PCLPointField::FLOAT32 || type == pcl::PCLPointField::FLOAT64)
    return false;
  const std::set<double> different(values.begin(), values.end());
  return different.size() <= most_labels;
}

FieldView
labelView(const CloudFile& cloud,
          const std::string& field,
          const std::vector<double>& values,
          const std::map<std::int64_t, std::string>& names)
{
  const auto points = pointsOf(cloud);
  const LabelStyles known = stylesOf(cloud, field);
  std::map<std::int64_t, LegendEntry> entries;
  FieldView view;
  view.colors.reserve(values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!isWhole(values[i]))
      throw InputError(cloud.path + ": field '" + field + "' of point " +
                       std::to_string(i) + " is " + std::to_string(values[i]) +
                       ": allowed is a whole number, as it holds labels");
    const auto label = static_cast<std::int64_t>(values[i]);
    auto entry = entries.find(label);
    if (entry == entries.end()) {
      const LabelStyle style = styleOf(label, known, names);
      entry = entries.emplace(label, LegendEntry{style.name, style.color, 0}).first;
    }
    view.colors.push_back(entry->second.color);
    entry->second.points += pcl::isXYZFinite((*points)[i]);
  }
  for (const auto& entry : entries)
    if (entry.second.points > 0)
      view.legend.push_back(entry.second);
  return view;
}

} // namespace pcl::app
