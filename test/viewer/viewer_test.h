// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The fixture of tests that look at pictures of the viewer.

#pragma once

#include "apps/app_test.h"
#include "picture.h"

#include <string>
#include <vector>

namespace pcl_shape_test {

constexpr Pixel white{255, 255, 255};
constexpr Pixel blue{70, 120, 205};
constexpr Pixel orange{240, 140, 30};
constexpr Pixel crimson{205, 20, 55};
constexpr Pixel green{35, 155, 75};
constexpr Pixel grey{150, 150, 150};
constexpr Pixel light_grey{205, 205, 205};

/** \brief Pictures of the viewer, drawn under xvfb-run. */
class ViewerTest : public AppTest {
protected:
  ViewerTest();

  /** \brief Skips the test unless pictures can be drawn here. */
  void SetUp() override;

  /** \brief A square of 40 x 40 points, 5 mm apart, seen from 1 m away: the rows of
   * `values` are its columns, from left to right, and the last entry of each is for the
   * rest of them. */
  std::string square(const std::string& fields,
                     const std::string& types,
                     const std::vector<std::string>& values) const;

  /** \brief What the viewer did under xvfb-run. */
  static Outcome draw(const Words& arguments);

  /** \brief The picture of a run that succeeds. */
  Picture pictureOf(Words arguments) const;
};

} // namespace pcl_shape_test
