// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Cloud files as sources of tiles, and the offset for all of them.

#pragma once

#include "cli/arguments.h"
#include "io/cloud_stream.h"

#include <pcl/tiling/point_source.h>

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief A file. \throws InputError for what is wrong with it */
class CloudSource : public pcl::tiling::PointSource {
public:
  CloudSource(const std::string& path, unsigned floats)
  : path_(path)
  , stream_(path, floats)
  {}

  std::string
  name() const override
  {
    return path_;
  }

  std::string
  state() const override
  {
    return stream_.state();
  }

  std::size_t
  countSections() const override
  {
    return stream_.countSections();
  }

  void
  readSection(std::size_t section, const Use& use) const override
  {
    stream_.forEachPosition(section, use);
  }

  const CloudStream&
  stream() const
  {
    return stream_;
  }

private:
  std::string path_;
  CloudStream stream_;
};

using CloudSources = std::vector<std::shared_ptr<const CloudSource>>;

/** \brief Sets the offset of a cloud, or of a part of it, as chooseOffset() does.
 * \param[in] is_given whether it was given, not chosen */
void setOffset(CloudFile& cloud, const std::array<double, 3>& offset, bool is_given);

/** \brief Where points were seen from, in floats. Of several inputs it is the place
 * with the least coordinates, whatever their order. */
std::array<float, 3> viewPointOf(const CloudSources& sources,
                                 const std::array<double, 3>& offset,
                                 bool is_given);

/** \brief Two corners of the box that holds the points as floats, three coordinates
 * each; empty if no point is finite. */
std::vector<float> boxOf(const CloudSources& sources,
                         const std::array<double, 3>& offset);

/** \brief What chooseOffset() would choose for one cloud of all points, in bounded
 * memory. */
std::array<double, 3> offsetOf(const CloudSources& sources);

} // namespace pcl::app
