// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/number_view.h"

#include <algorithm>
#include <cmath>

namespace pcl::app {
namespace {

constexpr double degrees_per_radian = 180.0 / 3.14159265358979323846;

/** What the applications write. */
struct Quantity {
  std::string unit;
  double factor = 1.0; ///< from the file to this unit
  std::optional<ValueRange> range;
};

Quantity
quantityOf(const std::string& field)
{
  if (field == "mu" || field == "sigma")
    return {"degrees", degrees_per_radian, {}};
  if (field == "x" || field == "y" || field == "z")
    return {"m", 1.0, {}};
  if (field == "crease_mm")
    return {"mm", 1.0, {}};
  if (field.find("likelihood") != std::string::npos || field == "confidence")
    return {"", 1.0, ValueRange{0.0, 1.0}};
  if (field == "normal_x" || field == "normal_y" || field == "normal_z")
    return {"", 1.0, ValueRange{-1.0, 1.0}};
  return {};
}

/** Infinite values are left out like NaN. */
ValueRange
rangeOf(const std::vector<double>& values)
{
  std::vector<double> finite;
  std::copy_if(values.begin(), values.end(), std::back_inserter(finite), [](double v) {
    return std::isfinite(v);
  });
  if (finite.empty())
    return {0.0, 1.0};
  const auto percentile = [&finite](std::size_t percent) {
    const auto place = finite.begin() +
                       static_cast<std::ptrdiff_t>((finite.size() - 1) * percent / 100);
    std::nth_element(finite.begin(), place, finite.end());
    return *place;
  };
  const ValueRange range{percentile(1), percentile(99)};
  const double least_width = std::max(1e-6 * std::abs(range.least), 1e-12);
  return {range.least, std::max(range.most, range.least + least_width)};
}

} // namespace

FieldView
numberView(const std::string& field, std::vector<double> values)
{
  const Quantity quantity = quantityOf(field);
  for (double& value : values)
    value *= quantity.factor;
  FieldView view;
  view.title = quantity.unit.empty() ? field : field + ", " + quantity.unit;
  view.range = quantity.range ? *quantity.range : rangeOf(values);
  const double width = view.range->most - view.range->least;
  view.colors.reserve(values.size());
  for (const double value : values) {
    const bool known = !std::isnan(value);
    view.unknown += !known;
    view.colors.push_back(known ? viridis((value - view.range->least) / width)
                                : colors::unknown);
  }
  return view;
}

} // namespace pcl::app
