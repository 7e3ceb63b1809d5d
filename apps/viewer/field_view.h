// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The colors of the points by one field, with their legend or scale.

#pragma once

#include "io/cloud_file.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace pcl::app {

struct Color {
  std::uint8_t r, g, b;

  friend bool
  operator==(const Color& a, const Color& b)
  {
    return a.r == b.r && a.g == b.g && a.b == b.b;
  }
};

namespace colors {
constexpr Color unknown{150, 150, 150};
constexpr Color plain{205, 205, 205};
constexpr Color blue{70, 120, 205};
constexpr Color orange{240, 140, 30};
constexpr Color crimson{205, 20, 55};
constexpr Color green{35, 155, 75};
constexpr Color violet{130, 60, 190};
constexpr Color dark{95, 95, 95};
} // namespace colors

/** \brief Matplotlib's Viridis from blue (0) over green to yellow (1). */
Color viridis(double share);

/** \brief Colors that differ as much as possible and can be seen on white. */
Color distinctColor(std::size_t position);

/** \brief The values at the ends of the scale bar. */
struct ValueRange {
  double min;
  double max;
};

struct LegendEntry {
  std::string name;
  Color color;
  std::size_t points; ///< with finite coordinates
};

/** \brief How the points look that are colored by one field. */
struct FieldView {
  std::string field;
  std::string title;               ///< with the unit, if it is known
  std::vector<Color> colors;       ///< of each point
  std::vector<float> numbers;      ///< of each point, in the unit; empty for labels
  std::vector<std::size_t> labels; ///< of each point, places in the legend
  std::optional<ValueRange> range; ///< of numbers, for the scale bar
  std::vector<LegendEntry> legend; ///< of labels, by value
  std::optional<std::size_t>
      nothing;             ///< the place of the label for no edge, no instance
  std::size_t unknown = 0; ///< points that are NaN there
};

/** \brief The view of one field: colors as they are (rgb, rgba), labels, or numbers;
 * "plain" stands for one color for all points.
 * \param[in] names of labels, beside those that are known
 * \throws InputError that lists the fields, if this one is missing */
FieldView viewOf(const CloudFile& cloud,
                 const std::string& field,
                 const std::map<std::int64_t, std::string>& names);

/** \brief The value of -names: "1=flat,2=corrugated".
 * \throws UsageError if it is something else */
std::map<std::int64_t, std::string> parseLabelNames(const std::string& text);

/** \brief The field that says most about the cloud. */
std::string defaultField(const CloudFile& cloud);

/** \brief Whether shade() can be used. */
bool hasNormals(const CloudFile& cloud);

/** \brief The brightness of the points, from 0 to 1, by a light above the viewer's left
 * shoulder; medium for points without a normal. \throws InputError if the cloud has no
 * normals */
std::vector<float> brightnessOf(const CloudFile& cloud);

/** \brief Multiply the colors by brightnessOf(): surfaces that turn away from the light
 * get darker.
 * \throws InputError if the cloud has no normals */
void shade(const CloudFile& cloud, FieldView& view);

} // namespace pcl::app
