// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The colors of the points by one field, with their legend or scale.

#include "viewer/field_view.h"

#include "io/errors.h"
#include "io/text.h"

#include <pcl/common/colors.h>
#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <iterator>
#include <set>
#include <sstream>

namespace pcl::app {
namespace {

std::vector<Color>
colorsSeenOnWhite()
{
  constexpr int lightest = 3 * 200, darkest = 3 * 30; // sums of the channels
  std::vector<Color> seen;
  for (std::size_t i = 0; i < pcl::GlasbeyLUT::size(); ++i) {
    const pcl::RGB color = pcl::GlasbeyLUT::at(i);
    const int sum = color.r + color.g + color.b;
    if (sum >= darkest && sum <= lightest)
      seen.push_back({color.r, color.g, color.b});
  }
  return seen;
}

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
  const double min_width = std::max(1e-6 * std::abs(range.min), 1e-12);
  return {range.min, std::max(range.max, range.min + min_width)};
}

/** Numbers in Viridis. Angles are shown in degrees, probabilities from 0 to 1, anything
 * else from the first to the 99th percentile; values beyond get the color of that end.
 */
FieldView
numberView(const std::string& field, std::vector<double> values)
{
  const Quantity quantity = quantityOf(field);
  for (double& value : values)
    value *= quantity.factor;
  FieldView view;
  view.title = quantity.unit.empty() ? field : field + ", " + quantity.unit;
  view.range = quantity.range ? *quantity.range : rangeOf(values);
  const double width = view.range->max - view.range->min;
  view.colors.reserve(values.size());
  view.numbers.reserve(values.size());
  for (const double value : values) {
    view.numbers.push_back(static_cast<float>(value));
    const bool known = !std::isnan(value);
    view.unknown += !known;
    view.colors.push_back(known ? viridis((value - view.range->min) / width)
                                : colors::unknown);
  }
  return view;
}

/** The name and color of a label. */
struct LabelStyle {
  std::string name;
  Color color;
};

using LabelStyles = std::map<std::int64_t, LabelStyle>;

const std::map<std::string, LabelStyles>&
knownStyles()
{
  using namespace colors;
  static const std::map<std::string, LabelStyles> styles{
      {"surface",
       {{0, {"unknown", unknown}},
        {1, {"planar", blue}},
        {2, {"curved", orange}},
        {3, {"near a crease", crimson}}}},
      {"edge",
       {{0, {"no edge", plain}}, {1, {"edge", crimson}}, {255, {"left out", dark}}}},
      {"edge_type",
       {{0, {"no edge", plain}},
        {1, {"crease", crimson}},
        {2, {"corner", violet}},
        {3, {"open boundary", green}}}},
      {"ground", {{0, {"not ground", unknown}}, {1, {"ground", green}}}},
      {"instance", {{0, {"none", plain}}}},
      {"label", {{0, {"none", plain}}}},
      {"label beside confidence",
       {{0, {"void", unknown}},
        {1, {"planar", blue}},
        {2, {"curved", orange}},
        {3, {"edge", crimson}}}},
      {"outcome",
       {{0, {"left out", unknown}},
        {1, {"rightly not", plain}},
        {2, {"hit", green}},
        {3, {"miss", crimson}},
        {4, {"false alarm", violet}}}}};
  return styles;
}

/** The names of a model's classes, if it has several: from the fields
 * likelihood_<name>. */
std::vector<std::string>
classNames(const CloudFile& cloud)
{
  const std::string prefix = "likelihood_";
  std::vector<std::string> names;
  for (const auto& field : cloud.blob.fields)
    if (field.name.compare(0, prefix.size(), prefix) == 0)
      names.push_back(field.name.substr(prefix.size()));
  return names;
}

/** The styles of a model with other classes than planar and curved. */
LabelStyles
stylesOfModel(const std::vector<std::string>& names, const LabelStyles& known)
{
  const auto isKnown = [&known](std::size_t label, const std::string& name) {
    const auto style = known.find(static_cast<std::int64_t>(label));
    return style != known.end() && style->second.name == name;
  };
  LabelStyles styles{{0, known.at(0)}};
  bool all_known = true;
  for (std::size_t c = 0; c < names.size(); ++c) {
    all_known = all_known && isKnown(c + 1, names[c]);
    styles[static_cast<std::int64_t>(c + 1)] = {names[c], distinctColor(c)};
  }
  return all_known ? known : styles;
}

/** The known labels of this field: those that the applications write, or the model's
 * classes if the cloud has their likelihoods. */
LabelStyles
stylesOf(const CloudFile& cloud, const std::string& field)
{
  const bool is_training = field == "label" && findField(cloud, "confidence");
  const auto known =
      knownStyles().find(is_training ? "label beside confidence" : field);
  if (known == knownStyles().end())
    return {};
  return field == "surface" ? stylesOfModel(classNames(cloud), known->second)
                            : known->second;
}

constexpr std::size_t max_labels = 4096; // beyond, whole numbers are just numbers

bool
isWhole(double value)
{
  constexpr double largest_exact = 9007199254740992.0; // 2^53
  return std::abs(value) <= largest_exact && value == std::floor(value);
}

/** The color of a label without one of its own: positive labels come first. */
Color
colorOf(std::int64_t label)
{
  const auto size = static_cast<std::size_t>(std::abs(label));
  return distinctColor(label > 0 ? size - 1 : max_labels + size);
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

/** Whether the field holds labels: a known name, or whole numbers, not too large, of
 * which not too many differ. */
bool
hasLabels(const CloudFile& cloud,
          const std::string& field,
          const std::vector<double>& values)
{
  if (knownStyles().count(field) != 0)
    return true;
  const std::uint8_t type = findField(cloud, field)->datatype;
  if (type == pcl::PCLPointField::FLOAT32 || type == pcl::PCLPointField::FLOAT64)
    return false;
  const std::set<double> different(values.begin(), values.end());
  return different.size() <= max_labels &&
         std::all_of(different.begin(), different.end(), isWhole); // no nanoseconds
}

/** The place of label 0 in the legend, if it means that there is nothing at a point. */
std::optional<std::size_t>
placeOfNothing(const std::string& field,
               const std::map<std::int64_t, std::size_t>& places)
{
  const auto place = places.find(0);
  if (field == "outcome" || knownStyles().count(field) == 0 || place == places.end())
    return {};
  return place->second;
}

/** Throws an InputError if a value is not a whole number. */
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
                       ", expected a whole number, as it holds labels");
    const auto label = static_cast<std::int64_t>(values[i]);
    auto entry = entries.find(label);
    if (entry == entries.end()) {
      const LabelStyle style = styleOf(label, known, names);
      entry = entries.emplace(label, LegendEntry{style.name, style.color, 0}).first;
    }
    view.colors.push_back(entry->second.color);
    entry->second.points += pcl::isXYZFinite((*points)[i]);
  }
  std::map<std::int64_t, std::size_t> places;
  for (const auto& [label, entry] : entries)
    if (entry.points > 0) {
      places[label] = view.legend.size();
      view.legend.push_back(entry);
    }
  view.nothing = placeOfNothing(field, places);
  view.labels.reserve(values.size());
  for (const double value : values)
    view.labels.push_back(places[static_cast<std::int64_t>(value)]);
  return view;
}

/** PCL packs blue, green, red and alpha, a byte each, into one value. */
FieldView
colorView(const CloudFile& cloud, const std::string& field)
{
  numbersOf(cloud, field); // throws unless it is one number a point
  const pcl::PCLPointField& source = *findField(cloud, field);
  if (valueSize(source.datatype) != 4)
    throw InputError(cloud.path + ": field '" + field + "' has SIZE " +
                     std::to_string(valueSize(source.datatype)) + ", expected 4");
  FieldView view;
  view.colors.resize(cloud.size());
  for (std::size_t i = 0; i < view.colors.size(); ++i) {
    const std::uint8_t* const bytes = cloud.at(i, source);
    view.colors[i] = {bytes[2], bytes[1], bytes[0]};
  }
  return view;
}

} // namespace

Color
viridis(double share)
{
  const auto last = static_cast<double>(pcl::ViridisLUT::size() - 1);
  const double position = std::clamp(share, 0.0, 1.0) * last;
  const pcl::RGB color =
      pcl::ViridisLUT::at(static_cast<std::size_t>(std::lround(position)));
  return {color.r, color.g, color.b};
}

Color
distinctColor(std::size_t position)
{
  static const std::vector<Color> seen = colorsSeenOnWhite();
  return seen[position % seen.size()];
}

FieldView
viewOf(const CloudFile& cloud,
       const std::string& field,
       const std::map<std::int64_t, std::string>& names)
{
  const bool plain = field == "plain" && !findField(cloud, field);
  FieldView view;
  if (plain)
    view.colors.assign(cloud.size(), colors::plain);
  else if (field == "rgb" || field == "rgba")
    view = colorView(cloud, field);
  else {
    const std::vector<double> values = numbersOf(cloud, field);
    view = hasLabels(cloud, field, values) ? labelView(cloud, field, values, names)
                                           : numberView(field, values);
  }
  view.field = field;
  if (view.title.empty() && !plain)
    view.title = field;
  return view;
}

std::map<std::int64_t, std::string>
parseLabelNames(const std::string& text)
{
  std::map<std::int64_t, std::string> names;
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, ',');) {
    const std::size_t equals = entry.find('=');
    const auto value = parseValue<std::int64_t>(entry.substr(0, equals));
    if (equals == std::string::npos || equals + 1 == entry.size() || !value)
      throw UsageError("-names '" + text + "', at '" + entry +
                       "': expected something like 1=flat,2=corrugated");
    names[*value] = entry.substr(equals + 1);
  }
  return names;
}

std::string
defaultField(const CloudFile& cloud)
{
  for (const std::string_view field :
       splitWords("outcome surface edge_type edge ground label instance rgb rgba "
                  "likelihood edge_likelihood mu intensity"))
    if (findField(cloud, std::string(field)))
      return std::string(field);
  return "z";
}

bool
hasNormals(const CloudFile& cloud)
{
  return findField(cloud, "normal_x") && findField(cloud, "normal_y") &&
         findField(cloud, "normal_z");
}

std::vector<float>
brightnessOf(const CloudFile& cloud)
{
  constexpr float min_light = 0.3f, unknown_light = 0.6f;
  const auto normals = normalsOf(cloud);
  const auto& v = cloud.viewpoint;
  const Eigen::Vector3f light = Eigen::Quaternionf(v[3], v[4], v[5], v[6]) *
                                Eigen::Vector3f(-0.3f, -0.46f, -0.84f); // unit
  std::vector<float> brightness;
  brightness.reserve(normals->size());
  for (const pcl::Normal& normal : *normals) {
    const float cosine = std::abs(light.dot(normal.getNormalVector3fMap()));
    brightness.push_back(std::isfinite(cosine)
                             ? min_light + (1.0f - min_light) * std::min(1.0f, cosine)
                             : unknown_light);
  }
  return brightness;
}

void
shade(const CloudFile& cloud, FieldView& view)
{
  const std::vector<float> brightness = brightnessOf(cloud);
  for (std::size_t i = 0; i < view.colors.size(); ++i)
    for (std::uint8_t* const channel :
         {&view.colors[i].r, &view.colors[i].g, &view.colors[i].b})
      *channel = static_cast<std::uint8_t>(
          std::lround(brightness[i] * static_cast<float>(*channel)));
}

} // namespace pcl::app
