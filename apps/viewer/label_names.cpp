// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/label_names.h"

#include "cli/errors.h"
#include "io/pcd.h"

#include <sstream>

namespace pcl::app {
namespace {

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

/** The names of the model's classes, of several: of the fields likelihood_<name>. */
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

} // namespace

bool
isLabelField(const std::string& field)
{
  return knownStyles().count(field) != 0;
}

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

std::map<std::int64_t, std::string>
parseLabelNames(const std::string& text)
{
  std::map<std::int64_t, std::string> names;
  std::istringstream entries(text);
  for (std::string entry; std::getline(entries, entry, ',');) {
    const std::size_t equals = entry.find('=');
    const auto value = parseInteger<std::int64_t>(entry.substr(0, equals));
    if (equals == std::string::npos || equals + 1 == entry.size() || !value)
      throw UsageError("-names '" + text + "', at '" + entry +
                       "': allowed is like 1=flat,2=corrugated");
    names[*value] = entry.substr(equals + 1);
  }
  return names;
}

} // namespace pcl::app
