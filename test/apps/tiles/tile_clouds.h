// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds of surfaces with strays, equal points and NaN, for tests of tiles.

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

namespace pcl_shape_test {

using TilePoint = std::array<double, 3>;
using TilePointCloud = std::vector<TilePoint>;

/** \brief A room of 6 x 5 x 2.5 m with a table and a pillar, with noise. */
TilePointCloud roomCloud(std::size_t points);

/** \brief A road with curbs, walls and poles, denser near its middle. */
TilePointCloud streetCloud(std::size_t points);

/** \brief A wavy sheet without an edge. */
TilePointCloud sheetCloud(std::size_t points);

/** \brief A path of 4 x 75 m, curved in its first half, with a ridge: longer than
 * surfaces look, and wide enough for the largest windows of faces. */
TilePointCloud pathCloud(std::size_t points);

/** \brief A ridge whose heights have steps of 4 cm, points 1 cm apart. */
TilePointCloud stepsCloud();

/** \brief Where two walls meet, 3.5 m before a Kinect: its steps are five and ten
 * pixels wide.
 */
TilePointCloud widerStepsCloud();

/** \brief The same, with one more such corner beside it and one 1.1 m away: parts that
 * need different resolutions. */
TilePointCloud nearAndFarCloud();

/** \brief Both sides of sheet metal, four distances between points thick. */
TilePointCloud plateCloud();

/** \brief A table of 1.2 x 0.4 m, points 2.5 mm apart, seen by a stereo camera: heights
 * of 2 mm change over 45 to 70 mm. Only large windows say that it is flat. */
TilePointCloud wavyTableCloud();

/** \brief With points that are not finite, equal points, and points far away. */
TilePointCloud withTrouble(TilePointCloud points);

/** \brief A binary PCD file with x, y, z and the place of each point, id. \param[in]
 * is_double whether coordinates are doubles */
std::string tileCloudFile(const TilePointCloud& points,
                          const std::vector<std::size_t>& order,
                          bool is_double = false);

/** \brief 0 to size - 1, in an order of its own for each seed. */
std::vector<std::size_t> shuffled(std::size_t size, unsigned seed);

} // namespace pcl_shape_test
