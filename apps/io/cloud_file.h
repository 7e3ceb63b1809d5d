// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A cloud with all the fields of its file, under PCL's names.

#pragma once

#include <pcl/PCLPointCloud2.h>
#include <pcl/point_cloud.h>
#include <pcl/point_types.h>

#include <array>
#include <cstdint>
#include <string>
#include <utility>
#include <vector>

namespace pcl::app {

/** \brief A cloud file in memory: all its fields, packed, and its viewpoint. */
struct CloudFile {
  std::string path; ///< for messages
  pcl::PCLPointCloud2 blob;
  std::array<float, 7> viewpoint{0, 0, 0, 1, 0, 0, 0}; ///< tx ty tz qw qx qy qz
  std::array<double, 3> offset{0, 0, 0}; ///< pointsOf() subtracts it, the file keeps it
  bool is_view_known = true;             ///< else the points are seen from the offset

  std::size_t
  size() const
  {
    return static_cast<std::size_t>(blob.width) * blob.height;
  }

  /** \brief The bytes of a field's first value at a point. */
  const std::uint8_t*
  at(std::size_t point, const pcl::PCLPointField& field) const
  {
    return blob.data.data() + point * blob.point_step + field.offset;
  }
};

/** \brief Call `visit` with a zero of the C++ type of a pcl::PCLPointField type. */
template <typename Visitor>
auto
visitType(std::uint8_t datatype, const Visitor& visit)
{
  switch (datatype) {
  case pcl::PCLPointField::INT8:
    return visit(std::int8_t{});
  case pcl::PCLPointField::UINT8:
  case pcl::PCLPointField::BOOL:
    return visit(std::uint8_t{});
  case pcl::PCLPointField::INT16:
    return visit(std::int16_t{});
  case pcl::PCLPointField::UINT16:
    return visit(std::uint16_t{});
  case pcl::PCLPointField::INT32:
    return visit(std::int32_t{});
  case pcl::PCLPointField::UINT32:
    return visit(std::uint32_t{});
  case pcl::PCLPointField::INT64:
    return visit(std::int64_t{});
  case pcl::PCLPointField::UINT64:
    return visit(std::uint64_t{});
  case pcl::PCLPointField::FLOAT32:
    return visit(float{});
  default:
    return visit(double{});
  }
}

/** \brief Bytes of one value of a pcl::PCLPointField type. */
inline std::size_t
valueSize(std::uint8_t datatype)
{
  return visitType(datatype, [](auto value) { return sizeof(value); });
}

/** \brief A value of each point. */
struct StoredValue {
  std::uint8_t datatype;
  std::size_t offset; ///< of its bytes in a point
};

/** \brief Append a line of numbers for each point. */
void appendRows(const CloudFile& cloud,
                const std::vector<StoredValue>& values,
                std::string& text);

/** \brief The field, or nullptr. */
const pcl::PCLPointField* findField(const CloudFile& cloud, const std::string& name);

/** \brief Append a single-valued field to the description of a point that has no data
 * yet. */
void addField(CloudFile& cloud, const std::string& name, std::uint8_t datatype);

/** \brief A field of a cloud to be, and where its values are. */
struct FieldSource {
  pcl::PCLPointField field; ///< its offset does not matter
  const std::uint8_t* values;
  std::size_t step; ///< bytes from a point's value to the next one's
};

/** \brief Make a cloud of these fields, packed. The sources may be the cloud's data. */
void setFields(CloudFile& cloud, const std::vector<FieldSource>& sources);

/** \brief The fields of a cloud as they are. */
std::vector<FieldSource> sourcesOf(const CloudFile& cloud);

/** \brief x, y and z of every point in double.
 * \throws InputError unless they are single values */
std::vector<std::array<double, 3>> coordinatesOf(const CloudFile& cloud);

/** \brief The same of points that are not in the cloud. \param[in] cloud their fields
 * \param[in] data the points, packed \param[in] points how many */
std::vector<std::array<double, 3>>
coordinatesOf(const CloudFile& cloud, const std::uint8_t* data, std::size_t points);

/** \brief The points, with the offset subtracted in double; is_dense says whether all
 * are finite. \throws InputError unless x, y and z are single values and a point is
 * finite */
pcl::PointCloud<pcl::PointXYZ>::Ptr pointsOf(const CloudFile& cloud);

/** \brief Where the points were seen from, with the offset subtracted. */
std::array<float, 3> viewOriginOf(const CloudFile& cloud);

std::size_t countFinite(const pcl::PointCloud<pcl::PointXYZ>& points);

/** \brief The normals in normal_x, normal_y and normal_z.
 * \throws InputError unless they are single float32 or float64 values */
pcl::PointCloud<pcl::Normal>::Ptr normalsOf(const CloudFile& cloud);

/** \brief The values of a single-valued field of floats or doubles. \throws InputError
 * without it */
std::vector<float> floatsOf(const CloudFile& cloud, const std::string& field);

/** \brief The values of a single-valued field of any type. \throws InputError without
 * it */
std::vector<double> numbersOf(const CloudFile& cloud, const std::string& field);

/** \brief The same as labels.
 * \throws InputError without it, or if a value is not a whole number from 0 to 2^32 - 1
 */
std::vector<std::uint32_t> labelsOf(const CloudFile& cloud, const std::string& field);

/** \brief The values of a field to be, one for each point. */
struct Column {
  Column(std::string name, const std::vector<float>& values)
  : name(std::move(name))
  , datatype(pcl::PCLPointField::FLOAT32)
  , values(values.data())
  , size(values.size())
  {}

  Column(std::string name, const std::vector<std::uint32_t>& values)
  : name(std::move(name))
  , datatype(pcl::PCLPointField::UINT32)
  , values(values.data())
  , size(values.size())
  {}

  template <typename T>
  Column(std::string name, std::vector<T>&& temporary) = delete;

  std::string name;
  std::uint8_t datatype;
  const void* values; ///< they must live until they are set
  std::size_t size;
};

/** \brief Append fields, or replace those of these names, whatever their types, in one
 * pass over the points. */
void setColumns(CloudFile& cloud, const std::vector<Column>& columns);

/** \brief The same of one field. */
void
setField(CloudFile& cloud, const std::string& name, const std::vector<float>& values);

void setField(CloudFile& cloud,
              const std::string& name,
              const std::vector<std::uint32_t>& values);

/** \brief Set normal_x, normal_y, normal_z and curvature. */
void setNormals(CloudFile& cloud, const pcl::PointCloud<pcl::Normal>& normals);

/** \brief Coordinates, normals, colors and intensity in capitals get PCL's names,
 * unless a field has the name already. */
void usePclNames(CloudFile& cloud);

/** \brief The same for the properties of PLY: nx ny nz are normal_x normal_y normal_z;
 * red green blue (or diffuse_red and so on), bytes, become the one field rgb, with
 * alpha rgba, as pcl::PLYReader makes them. */
void usePclNamesOfPly(CloudFile& cloud);

} // namespace pcl::app
