// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A cloud with all the fields of its file, under PCL's names.

#include "io/cloud_file.h"

#include "io/errors.h"
#include "io/text.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <stdexcept>
#include <utility>

namespace pcl::app {
namespace {

const pcl::PCLPointField&
singleField(const CloudFile& cloud, const std::string& name)
{
  const pcl::PCLPointField* const field = findField(cloud, name);
  if (!field) {
    std::string names;
    for (const auto& other : cloud.blob.fields)
      names += ' ' + other.name;
    throw InputError(cloud.path + ": expected a field '" + name + "' but found only" +
                     names);
  }
  if (field->count != 1)
    throw InputError(cloud.path + ": field '" + name + "' has COUNT " +
                     std::to_string(field->count) + ", expected 1");
  return *field;
}

bool
isFloating(const pcl::PCLPointField& field)
{
  return field.datatype == pcl::PCLPointField::FLOAT32 ||
         field.datatype == pcl::PCLPointField::FLOAT64;
}

void
requireFloating(const CloudFile& cloud, const std::string& name)
{
  if (!isFloating(singleField(cloud, name)))
    throw InputError(cloud.path + ": field '" + name +
                     "' is not of type float32 or float64; expected SIZE 4 or 8, "
                     "TYPE F");
}

/** Call \p use with the number of each of the packed points and its value, a double. */
template <typename Use>
void
eachNumber(const CloudFile& cloud,
           const std::uint8_t* data,
           std::size_t points,
           const std::string& name,
           const Use& use)
{
  const pcl::PCLPointField& field = singleField(cloud, name);
  visitType(field.datatype, [&](auto value) {
    const std::uint8_t* from = data + field.offset;
    for (std::size_t i = 0; i < points; ++i, from += cloud.blob.point_step) {
      std::memcpy(&value, from, sizeof(value));
      use(i, static_cast<double>(value));
    }
  });
}

/** The same of the cloud's points. */
template <typename Use>
void
eachNumber(const CloudFile& cloud, const std::string& name, const Use& use)
{
  eachNumber(cloud, cloud.blob.data.data(), cloud.size(), name, use);
}

/** The same of a field of floats or doubles, as floats. */
template <typename Use>
void
eachFloat(const CloudFile& cloud, const std::string& name, const Use& use)
{
  requireFloating(cloud, name);
  eachNumber(cloud, name, [&](std::size_t i, double value) {
    use(i, static_cast<float>(value));
  });
}

constexpr std::array<const char*, 3> coordinate_names{"x", "y", "z"};
constexpr std::array<const char*, 3> normal_names{"normal_x", "normal_y", "normal_z"};

/** Bytes of a point that are copied together. */
struct Run {
  const std::uint8_t* values; ///< of the first point
  std::size_t step;           ///< from one point to the next
  std::size_t bytes;
};

/** Fields that follow one another where they are read from make one run. */
std::vector<Run>
runsOf(const std::vector<FieldSource>& sources)
{
  std::vector<Run> runs;
  for (const FieldSource& source : sources) {
    const std::size_t bytes = valueSize(source.field.datatype) * source.field.count;
    const bool follows = !runs.empty() && runs.back().step == source.step &&
                         runs.back().values + runs.back().bytes == source.values &&
                         runs.back().bytes + bytes <= source.step;
    if (follows)
      runs.back().bytes += bytes;
    else
      runs.push_back({source.values, source.step, bytes});
  }
  return runs;
}

const std::vector<std::string_view> known_names =
    splitWords("x y z normal_x normal_y normal_z curvature rgb rgba intensity");

void
rename(CloudFile& cloud, pcl::PCLPointField& field, const std::string& name)
{
  if (!findField(cloud, name))
    field.name = name;
}

const pcl::PCLPointField*
findByte(const CloudFile& cloud, const std::string& name)
{
  const pcl::PCLPointField* const field = findField(cloud, name);
  return field && field->datatype == pcl::PCLPointField::UINT8 && field->count == 1
             ? field
             : nullptr;
}

/** The channels of a color in the order of a packed one's bytes, or fewer. */
std::vector<const pcl::PCLPointField*>
channelsOf(const CloudFile& cloud, const std::string& prefix)
{
  std::vector<const pcl::PCLPointField*> channels;
  for (const char* const name : {"blue", "green", "red"})
    if (const pcl::PCLPointField* const field = findByte(cloud, prefix + name))
      channels.push_back(field);
  if (const pcl::PCLPointField* const alpha = findByte(cloud, "alpha");
      alpha && channels.size() == 3)
    channels.push_back(alpha);
  return channels;
}

/** Replace three or four bytes by one field in the place of red. */
void
packColors(CloudFile& cloud, const std::string& prefix)
{
  const auto channels = channelsOf(cloud, prefix);
  const bool has_alpha = channels.size() == 4;
  if (channels.size() < 3 || findField(cloud, "rgb") || findField(cloud, "rgba"))
    return;
  constexpr std::size_t bytes = sizeof(std::uint32_t);
  std::vector<std::uint8_t> packed(cloud.size() * bytes, 0);
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (std::size_t c = 0; c < channels.size(); ++c)
      packed[i * bytes + c] = *cloud.at(i, *channels[c]); // 0xAARRGGBB
  pcl::PCLPointField color;
  color.name = has_alpha ? "rgba" : "rgb";
  color.datatype = has_alpha ? pcl::PCLPointField::UINT32 : pcl::PCLPointField::FLOAT32;
  color.count = 1;
  constexpr std::size_t red = 2;
  std::vector<FieldSource> sources;
  for (const FieldSource& source : sourcesOf(cloud)) {
    const auto channel =
        std::find_if(channels.begin(), channels.end(), [&](const auto* c) {
          return c->offset == source.field.offset;
        });
    if (channel == channels.end())
      sources.push_back(source);
    else if (*channel == channels[red])
      sources.push_back({color, packed.data(), bytes});
  }
  setFields(cloud, sources);
}

/** pcl::PLYReader makes a byte of intensity a float. */
void
widenIntensity(CloudFile& cloud)
{
  if (!findByte(cloud, "intensity"))
    return;
  std::vector<float> values;
  for (const double value : numbersOf(cloud, "intensity"))
    values.push_back(static_cast<float>(value));
  setField(cloud, "intensity", values);
}

} // namespace

std::vector<FieldSource>
sourcesOf(const CloudFile& cloud)
{
  std::vector<FieldSource> sources;
  for (const auto& field : cloud.blob.fields)
    sources.push_back(
        {field, cloud.blob.data.data() + field.offset, cloud.blob.point_step});
  return sources;
}

void
setFields(CloudFile& cloud, const std::vector<FieldSource>& sources)
{
  std::vector<pcl::PCLPointField> fields;
  std::uint32_t step = 0;
  for (const FieldSource& source : sources) {
    fields.push_back(source.field);
    fields.back().offset = step;
    step += static_cast<std::uint32_t>(valueSize(source.field.datatype)) *
            source.field.count;
  }
  const std::vector<Run> runs = runsOf(sources);
  std::vector<std::uint8_t> data(cloud.size() * step);
  std::uint8_t* to = data.data();
  for (std::size_t i = 0; i < cloud.size(); ++i)
    for (const Run& run : runs) {
      const std::uint8_t* const from = run.values + i * run.step;
      if (run.bytes == sizeof(float)) // no call for so little
        std::memcpy(to, from, sizeof(float));
      else
        std::memcpy(to, from, run.bytes);
      to += run.bytes;
    }
  cloud.blob.fields = std::move(fields);
  cloud.blob.data = std::move(data);
  cloud.blob.point_step = step;
  cloud.blob.row_step = step * cloud.blob.width;
}

void
appendRows(const CloudFile& cloud,
           const std::vector<StoredValue>& values,
           std::string& text)
{
  for (std::size_t i = 0; i < cloud.size(); ++i) {
    const std::uint8_t* const point =
        cloud.blob.data.data() + i * cloud.blob.point_step;
    for (const StoredValue& stored : values)
      visitType(stored.datatype, [&](auto value) {
        std::memcpy(&value, point + stored.offset, sizeof(value));
        appendFileNumber(value, text);
        text += ' ';
      });
    text.back() = '\n';
  }
}

const pcl::PCLPointField*
findField(const CloudFile& cloud, const std::string& name)
{
  for (const auto& field : cloud.blob.fields)
    if (field.name == name)
      return &field;
  return nullptr;
}

void
addField(CloudFile& cloud, const std::string& name, std::uint8_t datatype)
{
  pcl::PCLPointField& field = cloud.blob.fields.emplace_back();
  field.name = name;
  field.datatype = datatype;
  field.count = 1;
  field.offset = cloud.blob.point_step;
  cloud.blob.point_step += static_cast<std::uint32_t>(valueSize(datatype));
}

std::vector<std::array<double, 3>>
coordinatesOf(const CloudFile& cloud)
{
  return coordinatesOf(cloud, cloud.blob.data.data(), cloud.size());
}

std::vector<std::array<double, 3>>
coordinatesOf(const CloudFile& cloud, const std::uint8_t* data, std::size_t points)
{
  std::vector<std::array<double, 3>> places(points);
  for (std::size_t c = 0; c < coordinate_names.size(); ++c)
    eachNumber(
        cloud, data, points, coordinate_names[c], [&](std::size_t i, double value) {
          places[i][c] = value;
        });
  return places;
}

std::array<float, 3>
viewOriginOf(const CloudFile& cloud)
{
  std::array<float, 3> origin{};
  for (std::size_t c = 0; cloud.is_view_known && c < origin.size(); ++c)
    origin[c] =
        static_cast<float>(static_cast<double>(cloud.viewpoint[c]) - cloud.offset[c]);
  return origin;
}

pcl::PointCloud<pcl::PointXYZ>::Ptr
pointsOf(const CloudFile& cloud)
{
  const auto points = pcl::make_shared<pcl::PointCloud<pcl::PointXYZ>>(
      cloud.blob.width, cloud.blob.height);
  for (std::size_t c = 0; c < coordinate_names.size(); ++c)
    eachNumber(cloud, coordinate_names[c], [&](std::size_t i, double value) {
      (*points)[i].data[c] = static_cast<float>(value - cloud.offset[c]);
    });
  const auto& v = cloud.viewpoint;
  const std::array<float, 3> origin = viewOriginOf(cloud);
  points->sensor_origin_ = Eigen::Vector4f(origin[0], origin[1], origin[2], 0.0f);
  points->sensor_orientation_ = Eigen::Quaternionf(v[3], v[4], v[5], v[6]);
  const std::size_t finite = countFinite(*points);
  if (finite == 0)
    throw InputError(cloud.path + ": none of its " + std::to_string(points->size()) +
                     " points is finite; expected at least one");
  points->is_dense = finite == points->size();
  return points;
}

std::size_t
countFinite(const pcl::PointCloud<pcl::PointXYZ>& points)
{
  return static_cast<std::size_t>(
      std::count_if(points.begin(), points.end(), [](const pcl::PointXYZ& point) {
        return pcl::isXYZFinite(point);
      }));
}

pcl::PointCloud<pcl::Normal>::Ptr
normalsOf(const CloudFile& cloud)
{
  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>(
      cloud.blob.width, cloud.blob.height);
  normals->is_dense = false;
  for (std::size_t c = 0; c < normal_names.size(); ++c)
    eachFloat(cloud, normal_names[c], [&](std::size_t i, float value) {
      (*normals)[i].normal[c] = value;
    });
  if (findField(cloud, "curvature"))
    eachFloat(cloud, "curvature", [&](std::size_t i, float value) {
      (*normals)[i].curvature = value;
    });
  return normals;
}

std::vector<float>
floatsOf(const CloudFile& cloud, const std::string& field)
{
  std::vector<float> values(cloud.size());
  eachFloat(cloud, field, [&](std::size_t i, float value) { values[i] = value; });
  return values;
}

std::vector<double>
numbersOf(const CloudFile& cloud, const std::string& field)
{
  std::vector<double> values(cloud.size());
  eachNumber(cloud, field, [&](std::size_t i, double value) { values[i] = value; });
  return values;
}

std::vector<std::uint32_t>
labelsOf(const CloudFile& cloud, const std::string& field)
{
  const std::vector<double> values = numbersOf(cloud, field);
  std::vector<std::uint32_t> labels(values.size());
  for (std::size_t i = 0; i < labels.size(); ++i) {
    const double value = values[i];
    if (!(value >= 0.0 && value <= std::numeric_limits<std::uint32_t>::max()) ||
        value != std::floor(value))
      throw InputError(cloud.path + ": field '" + field + "' of point " +
                       std::to_string(i) + " is " + std::to_string(value) +
                       ", expected a whole number from 0 to 4294967295");
    labels[i] = static_cast<std::uint32_t>(value);
  }
  return labels;
}

void
setColumns(CloudFile& cloud, const std::vector<Column>& columns)
{
  std::vector<FieldSource> sources = sourcesOf(cloud);
  for (const Column& column : columns) {
    if (column.size != cloud.size())
      throw std::logic_error(cloud.path + ": " + std::to_string(column.size) +
                             " values for a field of " + std::to_string(cloud.size()) +
                             " points");
    const auto found = std::find_if(sources.begin(), sources.end(), [&](const auto& s) {
      return s.field.name == column.name;
    });
    FieldSource& source = found == sources.end() ? sources.emplace_back() : *found;
    source.field.name = column.name;
    source.field.datatype = column.datatype;
    source.field.count = 1;
    source.values = static_cast<const std::uint8_t*>(column.values);
    source.step = valueSize(column.datatype);
  }
  setFields(cloud, sources);
}

void
setField(CloudFile& cloud, const std::string& name, const std::vector<float>& values)
{
  setColumns(cloud, {{name, values}});
}

void
setField(CloudFile& cloud,
         const std::string& name,
         const std::vector<std::uint32_t>& values)
{
  setColumns(cloud, {{name, values}});
}

void
setNormals(CloudFile& cloud, const pcl::PointCloud<pcl::Normal>& normals)
{
  std::array<std::vector<float>, 4> values;
  for (auto& column : values)
    column.reserve(normals.size());
  for (const pcl::Normal& normal : normals) {
    for (std::size_t c = 0; c < 3; ++c)
      values[c].push_back(normal.normal[c]);
    values[3].push_back(normal.curvature);
  }
  const char* const names[] = {"normal_x", "normal_y", "normal_z", "curvature"};
  std::vector<Column> columns;
  for (std::size_t c = 0; c < values.size(); ++c)
    columns.push_back({names[c], values[c]});
  setColumns(cloud, columns);
}

void
usePclNames(CloudFile& cloud)
{
  for (auto& field : cloud.blob.fields) {
    const std::string name = toLower(field.name);
    if (std::count(known_names.begin(), known_names.end(), name) > 0)
      rename(cloud, field, name);
  }
}

void
usePclNamesOfPly(CloudFile& cloud)
{
  usePclNames(cloud);
  constexpr std::array<const char*, 3> normals_in_ply{"nx", "ny", "nz"};
  for (auto& field : cloud.blob.fields)
    for (std::size_t c = 0; c < normal_names.size(); ++c)
      if (field.name == normals_in_ply[c])
        rename(cloud, field, normal_names[c]);
  packColors(cloud, "");
  packColors(cloud, "diffuse_");
  widenIntensity(cloud);
}

} // namespace pcl::app
