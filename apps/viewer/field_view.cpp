// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/field_view.h"

#include "cli/errors.h"
#include "viewer/label_view.h"
#include "viewer/number_view.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace pcl::app {
namespace {

bool
isColor(const std::string& field)
{
  return field == "rgb" || field == "rgba";
}

FieldView
plainView(const CloudFile& cloud)
{
  FieldView view;
  view.colors.assign(cloud.size(), colors::plain);
  return view;
}

/** PCL packs blue, green, red and alpha, a byte each, into one value. */
FieldView
colorView(const CloudFile& cloud, const std::string& field)
{
  numbersOf(cloud, field);
  const pcl::PCLPointField& source = *findField(cloud, field);
  if (valueSize(source.datatype) != 4)
    throw InputError(cloud.path + ": field '" + field + "' has SIZE " +
                     std::to_string(valueSize(source.datatype)) + ": allowed is 4");
  FieldView view;
  view.colors.resize(cloud.size());
  for (std::size_t i = 0; i < view.colors.size(); ++i) {
    std::uint8_t bytes[4];
    std::memcpy(bytes,
                cloud.blob.data.data() + i * cloud.blob.point_step + source.offset,
                sizeof bytes);
    view.colors[i] = {bytes[2], bytes[1], bytes[0]};
  }
  return view;
}

FieldView
makeView(const CloudFile& cloud,
         const std::string& field,
         const std::map<std::int64_t, std::string>& names)
{
  if (isColor(field))
    return colorView(cloud, field);
  const std::vector<double> values = numbersOf(cloud, field);
  return hasLabels(cloud, field, values) ? labelView(cloud, field, values, names)
                                         : numberView(field, values);
}

} // namespace

FieldView
viewOf(const CloudFile& cloud,
       const std::string& field,
       const std::map<std::int64_t, std::string>& names)
{
  const bool plain = field == "plain" && !findField(cloud, field);
  FieldView view = plain ? plainView(cloud) : makeView(cloud, field, names);
  view.field = field;
  if (view.title.empty() && !plain)
    view.title = field;
  return view;
}

std::string
defaultField(const CloudFile& cloud)
{
  for (const char* const field : {"outcome",
                                  "surface",
                                  "edge_type",
                                  "edge",
                                  "ground",
                                  "label",
                                  "instance",
                                  "rgb",
                                  "rgba",
                                  "likelihood",
                                  "edge_likelihood",
                                  "mu",
                                  "intensity"})
    if (findField(cloud, field))
      return field;
  return "z";
}

void
shade(const CloudFile& cloud, FieldView& view)
{
  constexpr float least = 0.3f, unknown_light = 0.6f;
  const auto normals = normalsOf(cloud);
  const Eigen::Vector3f light = pointsOf(cloud)->sensor_orientation_ *
                                Eigen::Vector3f(-0.3f, -0.46f, -0.84f); // unit
  for (std::size_t i = 0; i < view.colors.size(); ++i) {
    const float cosine = std::abs(light.dot((*normals)[i].getNormalVector3fMap()));
    const float brightness = std::isfinite(cosine)
                                 ? least + (1.0f - least) * std::min(1.0f, cosine)
                                 : unknown_light;
    for (std::uint8_t* const channel :
         {&view.colors[i].r, &view.colors[i].g, &view.colors[i].b})
      *channel = static_cast<std::uint8_t>(
          std::lround(brightness * static_cast<float>(*channel)));
  }
}

} // namespace pcl::app
