// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs the viewer under xvfb-run.

#include "viewer_test.h"

#include <cstdlib>

namespace pcl_shape_test {
namespace {

constexpr int side = 40;
constexpr int half = 20;

} // namespace

ViewerTest::ViewerTest() { ::unsetenv("DISPLAY"); }

void
ViewerTest::SetUp()
{
  if (std::string(PCL_SHAPE_XVFB_RUN).empty())
    GTEST_SKIP() << "xvfb-run was not found (Debian: xvfb, xauth)";
}

std::string
ViewerTest::square(const std::string& fields,
                   const std::string& types,
                   const std::vector<std::string>& values) const
{
  std::vector<std::string> rows;
  for (int j = 0; j < side; ++j)
    for (int i = 0; i < side; ++i) {
      const std::size_t place = static_cast<std::size_t>(i) * values.size() / side;
      rows.push_back(std::to_string(0.005 * (i - half)) + ' ' +
                     std::to_string(0.005 * (j - half)) + " 1 " + values[place]);
    }
  return file("square.pcd", asciiCloud("x y z " + fields, "F F F " + types, rows));
}

Outcome
ViewerTest::draw(const Words& arguments)
{
  Words words{"-a", pathOf("pcl_shape_viewer")};
  words.insert(words.end(), arguments.begin(), arguments.end());
  return runProgram(PCL_SHAPE_XVFB_RUN, words);
}

Picture
ViewerTest::pictureOf(Words arguments) const
{
  const std::string picture = path("picture.png");
  arguments.insert(arguments.end(), {"-screenshot", picture});
  const Outcome outcome = draw(arguments);
  EXPECT_EQ(outcome.status, 0) << outcome.out << outcome.err;
  EXPECT_NE(outcome.out.find(picture), std::string::npos) << outcome.out;
  return Picture(picture);
}

} // namespace pcl_shape_test
