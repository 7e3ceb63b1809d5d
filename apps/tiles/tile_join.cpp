// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// From the results of tiles to clouds: those of the inputs, with new fields.

#include "tiles/tile_join.h"

#include "io/any_cloud.h"
#include "io/errors.h"
#include "io/files.h"
#include "io/ply.h"

#include <pcl/features/normal_3d.h>

#include <algorithm>
#include <cstring>
#include <fstream>
#include <numeric>
#include <unordered_map>
#include <utility>

namespace pcl::app {
namespace {

using pcl::tiling::Position;
using pcl::tiling::TiledCloud;

/** Of each section, as in its output. */
std::string
joinedName(PCDFormat format)
{
  return std::string("joined_") + nameOf(format);
}

/** Gives the rows of a tile's result one after the other. */
class TileRows {
public:
  /** \param[in] rows which of them */
  TileRows(std::string path, std::size_t fields, const TiledCloud::Rows& rows)
  : path_(std::move(path))
  , fields_(fields)
  , left_(rows.count)
  , begin_(result_header + rows.first * fields * sizeof values_[0])
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
  std::uint64_t left_, begin_;
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

/** Writes the points of a section with their fields. */
class SectionJoin {
public:
  SectionJoin(const TiledCloud& cloud,
              const TileWanted& wanted,
              const JoinedOutputs& outputs,
              std::size_t section)
  : cloud_(cloud)
  , wanted_(wanted)
  , outputs_(outputs)
  , is_first_(cloud.sections()[section].number == 0)
  , fields_(fieldsOf(wanted))
  {
    for (const TiledCloud::Rows& rows : cloud.rowsOf(section))
      rows_.emplace(
          rows.tile,
          TileRows(cloud.pathOf(results_name, rows.tile), fields_.size(), rows));
  }

  void
  write(const CloudStream& stream, std::size_t number, const TiledCloud::Sink& sink)
  {
    const auto give = [&](const std::string& text) { sink(text.data(), text.size()); };
    stream.forEachPart(number, [&](CloudFile& part) {
      addFields(part);
      if (is_first_)
        give(headerOf(part, stream.description()));
      is_first_ = false;
      give(isPly(part) ? encodePlyPoints(part, isText())
                       : encodePcdPoints(part, outputs_.format));
    });
    requireEnd();
  }

private:
  static bool
  isPly(const CloudFile& cloud)
  {
    return endingOf(cloud.path) == ".ply";
  }

  bool
  isText() const
  {
    return outputs_.format == PCDFormat::ascii;
  }

  void
  addFields(CloudFile& part)
  {
    setOffset(part, cloud_.offset(), outputs_.is_offset_given);
    const std::vector<Position> points = coordinatesOf(part);
    Columns columns(fields_);
    for (const Position& p : points)
      columns.add(cloud_.holds(p) ? rowOf(p) : nullptr);
    if (wanted_.normals)
      setNormals(part, turnedNormals(columns, points, part));
    constexpr std::size_t of_normals = 4;
    columns.setFields(wanted_.normals ? of_normals : 0, part);
  }

  const std::uint32_t*
  rowOf(const Position& point)
  {
    const auto found = rows_.find(cloud_.tileOf(point));
    if (found == rows_.end())
      failChanged("other");
    return found->second.next();
  }

  void
  requireEnd() const
  {
    if (!std::all_of(rows_.begin(), rows_.end(), [](const auto& rows) {
          return rows.second.isAtEnd();
        }))
      failChanged("fewer");
  }

  [[noreturn]] static void
  failChanged(const std::string& which)
  {
    throw InputError("the inputs have " + which +
                     " points than their tiles; expected inputs that do not change");
  }

  std::string
  headerOf(const CloudFile& part, const CloudFile& description) const
  {
    CloudFile whole = part;
    whole.blob.data.clear();
    whole.blob.width = description.blob.width;
    whole.blob.height = description.blob.height;
    return isPly(part) ? encodePlyHeader(whole, isText())
                       : encodePcdHeader(whole, outputs_.format);
  }

  const TiledCloud& cloud_;
  const TileWanted& wanted_;
  const JoinedOutputs& outputs_;
  bool is_first_; ///< of its source, and nothing is written yet
  std::vector<TileField> fields_;
  std::unordered_map<std::uint64_t, TileRows> rows_; ///< of each tile it has points of
};

/** The sections of a source, one after the other. */
void
putTogether(const TiledCloud& cloud,
            const std::string& joined,
            std::size_t source,
            const std::string& path)
{
  AtomicFile output(path);
  const std::vector<TiledCloud::Section>& sections = cloud.sections();
  for (std::size_t section = 0; section < sections.size(); ++section)
    if (sections[section].source == source)
      cloud.copyTo(joined, section, [&](const void* data, std::size_t size) {
        output.write({static_cast<const char*>(data), size});
      });
  output.commit();
}

} // namespace

void
joinTiles(TiledCloud& cloud,
          pcl::tiling::Team& team,
          const CloudSources& sources,
          const TileWanted& wanted,
          const JoinedOutputs& outputs)
{
  cloud.check(results_name); // before parts of them are read
  const std::string joined = joinedName(outputs.format);
  cloud.runOnSections(joined, [&](std::size_t section, const TiledCloud::Sink& sink) {
    const auto [source, number] = cloud.sections()[section];
    SectionJoin(cloud, wanted, outputs, section)
        .write(sources[source]->stream(), number, sink);
  });
  std::vector<std::size_t> all(sources.size());
  std::iota(all.begin(), all.end(), std::size_t{0});
  std::string failure;
  team.run(
      all,
      [&](std::size_t source) {
        putTogether(cloud, joined, source, outputs.paths[source]);
        return std::string();
      },
      [&](std::size_t, const std::string&, const std::string& error) {
        failure = failure.empty() ? error : failure;
      });
  if (!failure.empty())
    throw InputError(failure);
  // A run that was killed may have been asked for another format.
  for (const PCDFormat format : {PCDFormat::ascii, PCDFormat::binary})
    cloud.removeResult(joinedName(format));
}

} // namespace pcl::app
