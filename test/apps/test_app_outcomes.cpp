// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_evaluate -out: hits, misses and false alarms.

// pcl_shape_evaluate -out

#include "app_test.h"
#include "io/pcd.h"

namespace {

using namespace pcl_shape_test;

const char* const app = "pcl_shape_evaluate";

class Outcomes : public AppTest {
protected:
  std::string
  cloud(const std::string& name, const std::string& field, const Words& labels) const
  {
    Words rows;
    for (const std::string& label : labels)
      rows.push_back("0 0 1 " + label);
    return file(name, asciiCloud("x y z " + field, "F F F U", rows));
  }

  std::vector<std::uint32_t>
  outcomes(const Words& arguments) const
  {
    Words words = arguments;
    words.insert(words.end(), {"-out", path("out.pcd")});
    expectSuccess(runApp(app, words));
    return pcl::app::labelsOf(pcl::app::readCloud(path("out.pcd")), "outcome");
  }
};

using Labels = std::vector<std::uint32_t>;

TEST_F(Outcomes, OfEdges)
{
  const std::string truth = cloud("t.pcd", "edge", {"1", "1", "0", "0", "255", "255"});
  const std::string predicted = cloud("p.pcd", "edge", {"1", "0", "0", "1", "0", "1"});
  EXPECT_EQ(outcomes({predicted, truth}), (Labels{2, 3, 1, 4, 0, 0}));
  EXPECT_EQ(pcl::app::labelsOf(pcl::app::readCloud(path("out.pcd")), "edge"),
            (Labels{1, 0, 0, 1, 0, 1}))
      << "the fields of the prediction are kept";
}

TEST_F(Outcomes, OfSurfacesAreOfTheTasksOwnClass)
{
  const std::string truth = cloud("t.pcd", "surface", {"1", "1", "2", "2", "3", "2"});
  const std::string predicted =
      cloud("p.pcd", "surface", {"1", "2", "1", "2", "1", "0"});
  EXPECT_EQ(outcomes({predicted, truth, "-task", "planar"}),
            (Labels{2, 3, 4, 1, 0, 1}));
  EXPECT_EQ(outcomes({predicted, truth, "-task", "curved"}),
            (Labels{1, 4, 3, 2, 0, 3}));
}

TEST_F(Outcomes, AreRefusedWithoutOneClassOrAFileOfTheirOwn)
{
  const std::string in = cloud("in.pcd", "instance", {"1", "2"});
  const std::string out = path("out.pcd");
  for (const char* const task : {"instance", "label"})
    expectRefused(runApp(app, {in, in, "-task", task, "-out", out}),
                  2,
                  {"-out", task, "allowed"});
  const std::string edges = cloud("edge.pcd", "edge", {"1", "0"});
  expectRefused(runApp(app, {edges, edges, "-out", edges}), 2, {"-out", "another"});
  expectRefused(
      runApp(app, {edges, edges, "-out", out, "-json", out}), 2, {"-json", "another"});
  expectRefused(runApp(app, {edges, edges, "-out", path("no/o.pcd")}), 1, {"no/o.pcd"});
  expectRefused(runApp(app, {edges, in, "-out", out}), 1, {"in.pcd", "'edge'"});
  EXPECT_EQ(files(), (std::vector<std::string>{"edge.pcd", "in.pcd"}));
}

} // namespace
