// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Writes the header and the arrays that apps/viewer/page/src/data.js reads.

#include "viewer/page.h"

#include "io/errors.h"
#include "viewer/page_points.h"
#include "viewer/page_template.h"

#include <boost/archive/iterators/base64_from_binary.hpp>
#include <boost/archive/iterators/transform_width.hpp>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <limits>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::size_t group = 3; // bytes that make four letters

using Letters = boost::archive::iterators::base64_from_binary<
    boost::archive::iterators::transform_width<const std::uint8_t*, 6, 8>>;

/** The bytes in base64, with padding, in one line. */
std::string
toBase64(const void* bytes, std::size_t size)
{
  const auto* const begin = static_cast<const std::uint8_t*>(bytes);
  const std::size_t rest = size % group;
  std::string text;
  text.reserve((size + group - 1) / group * 4);
  text.append(Letters(begin), Letters(begin + (size - rest)));
  if (rest == 0)
    return text;
  std::array<std::uint8_t, group> last{};
  std::memcpy(last.data(), begin + (size - rest), rest);
  text.append(Letters(last.data()), Letters(last.data() + group));
  const std::size_t padding = group - rest;
  return text.replace(text.size() - padding, padding, padding, '=');
}

/** The arrays of a page, in elements that browsers neither show nor run. */
class Arrays {
public:
  /** \return what stands for the array in the header */
  template <typename Value>
  Json
  add(const std::vector<Value>& values, const char* type)
  {
    const std::string id = "array_" + std::to_string(count_++);
    html_ += "<script type=\"text/plain\" id=\"" + id + "\">" +
             toBase64(values.data(), values.size() * sizeof(Value)) + "</script>\n";
    return {{"id", id}, {"type", type}};
  }

  const std::string&
  html() const
  {
    return html_;
  }

private:
  int count_ = 0;
  std::string html_;
};

std::string
toText(const Color& color)
{
  char text[8];
  std::snprintf(text, sizeof text, "#%02x%02x%02x", color.r, color.g, color.b);
  return text;
}

Json
toJson(const Eigen::Vector3f& vector)
{
  return {vector.x(), vector.y(), vector.z()};
}

template <typename To, typename From>
std::vector<To>
pick(const std::vector<From>& values, const std::vector<std::size_t>& points)
{
  std::vector<To> picked;
  picked.reserve(points.size());
  for (const std::size_t point : points)
    picked.push_back(static_cast<To>(values[point]));
  return picked;
}

/** The smallest type that holds the labels. */
Json
labelsToJson(const FieldView& view,
             const std::vector<std::size_t>& points,
             Arrays& arrays)
{
  if (view.legend.size() <= std::numeric_limits<std::uint8_t>::max())
    return arrays.add(pick<std::uint8_t>(view.labels, points), "uint8");
  if (view.legend.size() <= std::numeric_limits<std::uint16_t>::max())
    return arrays.add(pick<std::uint16_t>(view.labels, points), "uint16");
  return arrays.add(pick<std::uint32_t>(view.labels, points), "uint32");
}

std::vector<std::uint8_t>
channelsOf(const FieldView& view, const std::vector<std::size_t>& points)
{
  std::vector<std::uint8_t> channels;
  channels.reserve(3 * points.size());
  for (const std::size_t point : points) {
    const Color& color = view.colors[point];
    channels.insert(channels.end(), {color.r, color.g, color.b});
  }
  return channels;
}

Json
legendToJson(const std::vector<LegendEntry>& legend)
{
  Json entries = Json::array();
  for (const LegendEntry& entry : legend)
    entries.push_back({{"name", entry.name},
                       {"color", toText(entry.color)},
                       {"points", entry.points}});
  return entries;
}

Json
fieldToJson(const FieldView& view,
            const std::vector<std::size_t>& points,
            Arrays& arrays)
{
  Json json{{"name", view.field},
            {"title", view.title.empty() ? "one color" : view.title}};
  if (!view.labels.empty()) {
    json["kind"] = "labels";
    json["legend"] = legendToJson(view.legend);
    if (view.nothing)
      json["nothing"] = *view.nothing;
    json["values"] = labelsToJson(view, points, arrays);
  }
  else if (view.range) {
    json["kind"] = "numbers";
    json["range"] = {view.range->min, view.range->max};
    json["unknown"] = view.unknown;
    json["values"] = arrays.add(pick<float>(view.numbers, points), "float32");
  }
  else if (view.title.empty()) {
    json["kind"] = "plain";
    json["color"] = toText(colors::plain);
  }
  else {
    json["kind"] = "colors";
    json["values"] = arrays.add(channelsOf(view, points), "uint8");
  }
  return json;
}

Json
viridisToJson()
{
  constexpr int steps = 256;
  Json palette = Json::array();
  for (int i = 0; i < steps; ++i)
    palette.push_back(toText(viridis(static_cast<double>(i) / (steps - 1))));
  return palette;
}

Json
cameraToJson(const Scene& scene)
{
  const Camera& camera = scene.camera;
  return {{"position", toJson(camera.position)},
          {"focus", toJson(camera.focus)},
          {"up", toJson(camera.up)},
          {"angle", camera.angle},
          {"aspect", static_cast<double>(scene.width) / scene.height}};
}

/** Arrows for the first points only: their order is random. */
Json
arrowsToJson(const PageContents& contents)
{
  constexpr std::size_t max_arrows = 1200; // more hide the cloud
  constexpr float share = 0.02f;           // of the distance, as in the window
  const Scene& scene = contents.scene;
  const auto normals = normalsOf(contents.cloud);
  Json places = Json::array(), directions = Json::array();
  for (const std::size_t point : contents.points) {
    const Eigen::Vector3f normal = (*normals)[point].getNormalVector3fMap();
    if (!normal.allFinite())
      continue;
    places.push_back(toJson((*scene.points)[point].getVector3fMap()));
    directions.push_back(toJson(normal));
    if (places.size() == max_arrows)
      break;
  }
  return {{"on", scene.normals != nullptr},
          {"length", share * (scene.camera.focus - scene.camera.position).norm()},
          {"places", places},
          {"directions", directions}};
}

Json
linesToJson(const std::vector<Line>& lines)
{
  Json json = Json::array();
  for (std::size_t l = 0; l < lines.size(); ++l)
    json.push_back({{"color", toText(distinctColor(l))},
                    {"spacing", lines[l].spacing},
                    {"points", lines[l].points}});
  return json;
}

Json
instancesToJson(const std::vector<InstanceBox>& instances)
{
  Json json = Json::array();
  for (const InstanceBox& instance : instances)
    json.push_back({{"name", instance.name},
                    {"color", toText(instance.color)},
                    {"min", instance.min},
                    {"max", instance.max}});
  return json;
}

Json
graspsToJson(const Grasps& grasps)
{
  Json list = Json::array();
  for (const Grasp& grasp : grasps.grasps)
    list.push_back({{"position", grasp.position},
                    {"approach", grasp.approach},
                    {"seals", grasp.seals}});
  return {{"cup_radius", grasps.cup_radius}, {"grasps", list}};
}

void
addOverlays(const PageContents& contents, Json& header)
{
  const Scene& scene = contents.scene;
  if (!scene.lines.empty())
    header["lines"] = linesToJson(scene.lines);
  if (!scene.instances.empty())
    header["instances"] = instancesToJson(scene.instances);
  if (!scene.grasps.grasps.empty())
    header["grasps"] = graspsToJson(scene.grasps);
  if (hasNormals(contents.cloud))
    header["arrows"] = arrowsToJson(contents);
}

/** 1234567 as 1,234,567. */
std::string
withCommas(std::size_t number)
{
  std::string text = std::to_string(number);
  for (std::size_t place = text.size(); place > 3;)
    text.insert(place -= 3, 1, ',');
  return text;
}

std::string
noteOf(std::size_t shown, std::size_t points)
{
  if (shown == points)
    return withCommas(points) + (points == 1 ? " point" : " points");
  return withCommas(shown) + " of " + withCommas(points) +
         " points, chosen evenly; counts are of all";
}

std::string
titleOf(const std::string& path)
{
  if (path == "-")
    return "Point cloud";
  return path.substr(path.find_last_of('/') + 1);
}

pcl::PointCloud<pcl::PointXYZ>
shownPoints(const PageContents& contents)
{
  pcl::PointCloud<pcl::PointXYZ> points;
  points.reserve(contents.points.size());
  for (const std::size_t point : contents.points)
    points.push_back((*contents.scene.points)[point]);
  return points;
}

void
addPlaces(const pcl::PointCloud<pcl::PointXYZ>& points, Json& header, Arrays& arrays)
{
  Eigen::AlignedBox3f box;
  std::vector<float> coordinates;
  coordinates.reserve(3 * points.size());
  for (const pcl::PointXYZ& point : points) {
    box.extend(point.getVector3fMap());
    coordinates.insert(coordinates.end(), {point.x, point.y, point.z});
  }
  header["center"] = toJson(box.center());
  header["radius"] = std::max(0.5f * box.diagonal().norm(), 1e-6f);
  header["spacing"] = spacingOf(points);
  header["positions"] = arrays.add(coordinates, "float32");
}

void
addShades(const PageContents& contents, Json& header, Arrays& arrays)
{
  header["shaded"] = contents.shaded;
  if (!hasNormals(contents.cloud))
    return;
  constexpr float full = 255.0f;
  std::vector<float> shades = brightnessOf(contents.cloud);
  for (float& shade : shades)
    shade = std::round(full * shade);
  header["shades"] = arrays.add(pick<std::uint8_t>(shades, contents.points), "uint8");
}

/** From the page's coordinates to the file's. */
std::array<double, 3>
offsetOf(const PageContents& contents)
{
  std::array<double, 3> offset = contents.cloud.offset;
  for (std::size_t axis = 0; axis < offset.size(); ++axis)
    offset[axis] +=
        static_cast<double>(contents.origin[static_cast<Eigen::Index>(axis)]);
  return offset;
}

Json
headerOf(const PageContents& contents, Arrays& arrays)
{
  const Scene& scene = contents.scene;
  const std::size_t shown = contents.points.size();
  Json header{{"title", titleOf(contents.cloud.path)},
              {"note", noteOf(shown, countFinite(*scene.points))},
              {"made_by",
               "Made by pcl_shape_viewer " PCL_SHAPE_VERSION
               ". Nothing is loaded from, "
               "or sent to, any network."},
              {"points", shown},
              {"offset", offsetOf(contents)},
              {"camera", cameraToJson(scene)},
              {"viridis", viridisToJson()}};
  if (scene.has_point_size)
    header["point_size"] = scene.point_size;
  addPlaces(shownPoints(contents), header, arrays);
  header["fields"] = Json::array();
  for (const FieldView& view : scene.views)
    header["fields"].push_back(fieldToJson(view, contents.points, arrays));
  addShades(contents, header, arrays);
  addOverlays(contents, header);
  return header;
}

/** JSON without '<', so that it cannot end its element. */
std::string
toElement(const Json& header)
{
  std::string json = header.dump(-1, ' ', true, Json::error_handler_t::replace);
  for (std::size_t at = 0; (at = json.find('<', at)) != std::string::npos;)
    json.replace(at, 1, "\\u003c");
  return "<script type=\"application/json\" id=\"cloud\">" + json + "</script>\n";
}

} // namespace

std::vector<std::string>
fieldsOfPage(const CloudFile& cloud)
{
  const std::string first = defaultField(cloud);
  std::vector<std::string> fields{first};
  for (const pcl::PCLPointField& field : cloud.blob.fields) {
    const std::string& name = field.name;
    const bool is_shown_otherwise = name == first || name == "x" || name == "y" ||
                                    name.compare(0, 7, "normal_") == 0;
    if (!is_shown_otherwise && field.count == 1 && name != "_" && name != "plain")
      fields.push_back(name);
  }
  fields.emplace_back("plain");
  return fields;
}

void
requirePage()
{
  if (pageTemplate() == nullptr)
    throw InputError(
        "built without pages: for -html, install npm (Debian: npm), configure with "
        "-DPCL_SHAPE_WITH_HTML=ON where the npm registry can be reached, and build "
        "again");
}

std::string
drawPage(const PageContents& contents)
{
  requirePage();
  Arrays arrays;
  const Json header = headerOf(contents, arrays);
  std::string page(pageTemplate()->before);
  page += toElement(header);
  page += arrays.html();
  page += pageTemplate()->after;
  return page;
}

} // namespace pcl::app
