// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the results of tiles to clouds: those of the inputs, with new fields.

#include "tiles/tile_join.h"

#include "cli/atomic_file.h"
#include "cli/errors.h"
#include "io/any_cloud.h"
#include "io/ply.h"

#include <pcl/features/normal_3d.h>

#include <algorithm>
#include <cstring>
#include <fstream>

namespace pcl::app {
namespace {

using pcl::tiling::Position;
using pcl::tiling::TiledCloud;

/** Gives the rows of a tile's result one after the other. */
class TileRows {
public:
  TileRows(std::string path, std::size_t fields, std::uint64_t points)
  : path_(std::move(path))
  , fields_(fields)
  , left_(points)
  {}

  const std::uint32_t*
  next()
  {
    if (at_ == values_.size())
      fill();
    at_ += fields_;
    return &values_[at_ - fields_];
  }

  bool
  isAtEnd() const
  {
    return left_ == 0 && at_ == values_.size();
  }

private:
  static constexpr std::uint64_t rows_at_a_time = 4096;

  void
  fill()
  {
    const std::uint64_t rows = std::min(left_, rows_at_a_time);
    values_.resize(rows * fields_);
    std::ifstream file(path_, std::ios::binary);
    file.seekg(static_cast<std::streamoff>(begin_));
    const auto bytes = static_cast<std::streamsize>(values_.size() * sizeof values_[0]);
    file.read(reinterpret_cast<char*>(values_.data()), bytes);
    if (rows == 0 || file.gcount() != bytes)
      throw InputError(path_ +
                       ": has fewer points than the inputs; expected inputs that "
                       "do not change");
    begin_ += static_cast<std::uint64_t>(bytes);
    left_ -= rows;
    at_ = 0;
  }

  std::string path_;
  std::size_t fields_, at_ = 0;
  std::uint64_t left_, begin_ = result_header;
  std::vector<std::uint32_t> values_;
};

/** The new fields of some points. */
class Columns {
public:
  explicit Columns(const std::vector<TileField>& fields)
  : fields_(fields)
  , values_(fields.size())
  {
    for (const TileField& field : fields)
      unknown_.push_back(field.unknown);
  }

  /** \param[in] row null for a point that is not finite */
  void
  add(const std::uint32_t* row)
  {
    const std::uint32_t* const from = row ? row : unknown_.data();
    for (std::size_t f = 0; f < values_.size(); ++f)
      values_[f].push_back(from[f]);
  }

  std::vector<float>
  floats(std::size_t field) const
  {
    std::vector<float> floats(values_[field].size());
    if (!floats.empty())
      std::memcpy(floats.data(), values_[field].data(), floats.size() * sizeof(float));
    return floats;
  }

  void
  setFields(std::size_t first, CloudFile& part) const
  {
    for (std::size_t f = first; f < fields_.size(); ++f)
      if (fields_[f].is_float)
        setField(part, fields_[f].name, floats(f));
      else
        setField(part, fields_[f].name, values_[f]);
  }

private:
  const std::vector<TileField>& fields_;
  std::vector<std::uint32_t> unknown_;
  std::vector<std::vector<std::uint32_t>> values_;
};

/** The normals in the first columns, turned to where the points were seen from. */
pcl::PointCloud<pcl::Normal>
turnedNormals(const Columns& columns,
              const std::vector<Position>& points,
              const CloudFile& part)
{
  const std::array<float, 3> view = viewOriginOf(part);
  const std::vector<float> x = columns.floats(0), y = columns.floats(1),
                           z = columns.floats(2), curvature = columns.floats(3);
  pcl::PointCloud<pcl::Normal> normals;
  for (std::size_t i = 0; i < points.size(); ++i) {
    pcl::PointXYZ point;
    for (std::size_t axis = 0; axis < 3; ++axis)
      point.data[axis] = static_cast<float>(points[i][axis] - part.offset[axis]);
    pcl::Normal normal(x[i], y[i], z[i], curvature[i]);
    pcl::flipNormalTowardsViewpoint(point,
                                    view[0],
                                    view[1],
                                    view[2],
                                    normal.normal_x,
                                    normal.normal_y,
                                    normal.normal_z);
    normals.push_back(normal);
  }
  return normals;
}

/** Writes the outputs, from the first source to the last. */
class Join {
public:
  Join(const TiledCloud& cloud, const TileWanted& wanted, PCDFormat format)
  : cloud_(cloud)
  , wanted_(wanted)
  , format_(format)
  , fields_(fieldsOf(wanted))
  {
    for (std::size_t tile = 0; tile < cloud.size(); ++tile)
      rows_.emplace_back(
          cloud.pathOf(resultsName(), tile), fields_.size(), cloud.pointsOf(tile));
  }

  void
  write(const CloudSource& source, const std::string& path, bool is_given)
  {
    AtomicFile output(path);
    bool has_header = false;
    source.stream().forEachPart([&](CloudFile& part) {
      addFields(part, is_given);
      if (!has_header)
        output.write(headerOf(part, source.stream().description()));
      has_header = true;
      output.write(isPly(part) ? encodePlyPoints(part, format_ == PCDFormat::ascii)
                               : encodePcdPoints(part, format_));
    });
    output.commit();
  }

  void
  requireEnd() const
  {
    if (!std::all_of(rows_.begin(), rows_.end(), [](const TileRows& rows) {
          return rows.isAtEnd();
        }))
      throw InputError("the inputs have fewer points than their tiles; expected inputs "
                       "that do not change");
  }

private:
  static bool
  isPly(const CloudFile& cloud)
  {
    return endingOf(cloud.path) == ".ply";
  }

  void
  addFields(CloudFile& part, bool is_given)
  {
    setOffset(part, cloud_.offset(), is_given);
    const std::vector<Position> points = coordinatesOf(part);
    Columns columns(fields_);
    for (const Position& p : points)
      columns.add(cloud_.holds(p) ? rows_[cloud_.tileOf(p)].next() : nullptr);
    if (wanted_.normals)
      setNormals(part, turnedNormals(columns, points, part));
    constexpr std::size_t of_normals = 4;
    columns.setFields(wanted_.normals ? of_normals : 0, part);
  }

  std::string
  headerOf(const CloudFile& part, const CloudFile& description) const
  {
    CloudFile whole = part;
    whole.blob.data.clear();
    whole.blob.width = description.blob.width;
    whole.blob.height = description.blob.height;
    return isPly(part) ? encodePlyHeader(whole, format_ == PCDFormat::ascii)
                       : encodePcdHeader(whole, format_);
  }

  const TiledCloud& cloud_;
  const TileWanted& wanted_;
  PCDFormat format_;
  std::vector<TileField> fields_;
  std::vector<TileRows> rows_;
};

/** Reads the results once, before anything is written of them. */
void
requireUndamaged(const TiledCloud& cloud)
{
  for (std::size_t tile = 0; tile < cloud.size(); ++tile)
    if (cloud.pointsOf(tile) > 0)
      cloud.resultOf(resultsName(), tile);
}

} // namespace

void
joinTiles(const TiledCloud& cloud,
          const CloudSources& sources,
          const std::vector<std::string>& outputs,
          const TileWanted& wanted,
          PCDFormat format,
          bool is_given)
{
  requireUndamaged(cloud);
  Join join(cloud, wanted, format);
  for (std::size_t s = 0; s < sources.size(); ++s)
    join.write(*sources[s], outputs[s], is_given);
  join.requireEnd();
}

} // namespace pcl::app
