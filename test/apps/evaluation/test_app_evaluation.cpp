// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Precision, recall and IoU of labels and instances.

#include "app_test.h"
#include "evaluation/assignment.h"
#include "evaluation/evaluation_tasks.h"
#include "evaluation/objects.h"
#include "io/errors.h"
#include "io/pcd.h"
#include "support/random.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>

namespace {

using namespace pcl::app;
using namespace pcl_shape_test;

constexpr double exact = 1e-12;

class Tasks : public AppTest {
protected:
  CloudFile
  cloud(const std::string& name,
        const std::string& fields,
        const std::string& types,
        const Words& rows) const
  {
    Words complete;
    for (const std::string& row : rows)
      complete.push_back("0 0 1 " + row);
    return readCloud(
        file(name, asciiCloud("x y z " + fields, "F F F " + types, complete)));
  }
};

void
expectScore(const Score& score, std::uint64_t tp, std::uint64_t fp, std::uint64_t fn)
{
  EXPECT_EQ(score.true_positives, tp);
  EXPECT_EQ(score.false_positives, fp);
  EXPECT_EQ(score.false_negatives, fn);
}

TEST(Scores, ByHand)
{
  const Score score{6, 2, 4};
  EXPECT_NEAR(score.precision(), 6.0 / 8.0, exact);
  EXPECT_NEAR(score.recall(), 6.0 / 10.0, exact);
  EXPECT_NEAR(score.f1(), 2.0 * 0.75 * 0.6 / (0.75 + 0.6), exact);
  EXPECT_NEAR(score.iou(), 6.0 / 12.0, exact);
  EXPECT_TRUE(std::isnan(Score{}.precision()));
  EXPECT_EQ((Score{0, 3, 0}.precision()), 0.0);
  EXPECT_TRUE(std::isnan((Score{0, 3, 0}.recall())));
}

TEST_F(Tasks, StrictEdges)
{
  const CloudFile truth = cloud(
      "t.pcd", "edge surface", "U U", {"1 3", "1 3", "1 3", "0 1", "0 2", "255 1"});
  const CloudFile predicted = cloud("p.pcd",
                                    "edge edge_likelihood",
                                    "U F",
                                    {"1 .9", "0 .1", "0 nan", "1 .9", "0 0", "1 1"});
  const TaskPoints selected =
      selectPoints("edge", Convention::strict, predicted, truth);
  EXPECT_EQ(selected.points.size(), 5u);
  EXPECT_EQ(selected.unknown, 1u);
  const Evaluation evaluation = evaluateLabels(selected.points, selected.classes);
  ASSERT_EQ(evaluation.classes.size(), 1u);
  expectScore(evaluation.classes[0].score, 1, 1, 2);
  EXPECT_NEAR(evaluation.accuracy, 2.0 / 5.0, exact);
}

TEST_F(Tasks, PaperEdges)
{
  const CloudFile truth = cloud(
      "t.pcd", "edge surface", "U U", {"255 3", "0 3", "1 1", "0 2", "1 0", "0 1"});
  const CloudFile predicted =
      cloud("p.pcd", "edge", "U", {"1", "0", "1", "0", "1", "0"});
  const TaskPoints selected = selectPoints("edge", Convention::paper, predicted, truth);
  EXPECT_EQ(selected.points.size(), 5u);
  const Evaluation evaluation = evaluateLabels(selected.points, selected.classes);
  expectScore(evaluation.classes[0].score, 1, 1, 1);
  EXPECT_NEAR(evaluation.accuracy, 3.0 / 5.0, exact);
}

TEST_F(Tasks, StrictSurfaces)
{
  const CloudFile truth =
      cloud("t.pcd", "surface", "U", {"1", "1", "1", "2", "2", "3", "0", "2"});
  const CloudFile predicted =
      cloud("p.pcd", "surface", "U", {"1", "1", "2", "2", "1", "2", "2", "0"});
  for (const char* task : {"planar", "curved"}) {
    const TaskPoints selected =
        selectPoints(task, Convention::strict, predicted, truth);
    EXPECT_EQ(selected.points.size(), 6u);
    EXPECT_EQ(selected.unknown, 1u);
    const Evaluation evaluation = evaluateLabels(selected.points, selected.classes);
    EXPECT_EQ(evaluation.classes[0].name, task);
    const bool planar_first = evaluation.classes[0].label == 1;
    expectScore(evaluation.classes[planar_first ? 0 : 1].score, 2, 1, 1);
    expectScore(evaluation.classes[planar_first ? 1 : 0].score, 1, 1, 2);
    EXPECT_NEAR(evaluation.mean_iou, (2.0 / 4.0 + 1.0 / 4.0) / 2.0, exact);
    EXPECT_NEAR(evaluation.accuracy, 3.0 / 6.0, exact);
  }
}

TEST_F(Tasks, PaperSurfacesCountCreasesAsCurved)
{
  const CloudFile truth = cloud("t.pcd", "surface", "U", {"1", "2", "3", "3", "0"});
  const CloudFile predicted = cloud("p.pcd", "surface", "U", {"1", "2", "2", "1", "1"});
  const TaskPoints selected =
      selectPoints("curved", Convention::paper, predicted, truth);
  EXPECT_EQ(selected.points.size(), 4u);
  const Evaluation evaluation = evaluateLabels(selected.points, selected.classes);
  expectScore(evaluation.classes[0].score, 2, 0, 1);
  expectScore(evaluation.classes[1].score, 1, 1, 0);
}

TEST_F(Tasks, PointsWithoutCoordinatesAreLeftOut)
{
  const CloudFile truth = readCloud(
      file("t.pcd", asciiCloud("x y z edge", "F F F U", {"nan 0 0 1", "0 0 1 1"})));
  const CloudFile predicted = cloud("p.pcd", "edge", "U", {"0", "1"});
  const TaskPoints selected =
      selectPoints("edge", Convention::strict, predicted, truth);
  ASSERT_EQ(selected.points.size(), 1u);
  EXPECT_EQ(selected.points[0].predicted, 1u);
}

TEST_F(Tasks, GroundLabelsAndTheirConvention)
{
  const CloudFile truth =
      cloud("t.pcd", "ground label", "U U", {"1 4", "0 7", "1 7", "2 0"});
  const CloudFile predicted =
      cloud("p.pcd", "ground label", "U U", {"1 4", "1 4", "0 7", "1 4"});
  const TaskPoints ground =
      selectPoints("ground", Convention::strict, predicted, truth);
  EXPECT_EQ(ground.points.size(), 3u);
  expectScore(evaluateLabels(ground.points, ground.classes).classes[0].score, 1, 1, 1);
  const TaskPoints label = selectPoints("label", Convention::strict, predicted, truth);
  const Evaluation evaluation = evaluateLabels(label.points, label.classes);
  ASSERT_EQ(evaluation.classes.size(), 2u);
  EXPECT_EQ(evaluation.classes[1].name, "7");
  expectScore(evaluation.classes[0].score, 1, 1, 0);
  expectScore(evaluation.classes[1].score, 1, 0, 1);
  EXPECT_THROW(selectPoints("label", Convention::paper, predicted, truth), UsageError);
}

TEST(Instances, MatchOnceFromHalfAnOverlap)
{
  // 1 and 5 share 3 of 5 points; 2 is split into 6 (2 of 4 points) and 7; 3 is missed.
  std::vector<LabelPair> points;
  const auto add = [&](int count, std::uint32_t truth, std::uint32_t predicted) {
    points.insert(points.end(), static_cast<std::size_t>(count), {truth, predicted});
  };
  add(3, 1, 5);
  add(1, 1, 0);
  add(1, 0, 5);
  add(2, 2, 6);
  add(2, 2, 7);
  add(1, 0, 7);
  add(4, 3, 0);
  add(9, 0, 0);
  const InstanceEvaluation evaluation = evaluateInstances(points);
  expectScore(evaluation.instances, 2, 1, 1);
  expectScore(evaluation.points, 5, 4, 7);
  EXPECT_NEAR(evaluation.mean_matched_iou, (3.0 / 5.0 + 2.0 / 4.0) / 2.0, exact);
}

double
gainOf(const std::vector<std::vector<double>>& gains)
{
  double gain = 0.0;
  const auto columns = bestAssignment(gains);
  std::set<std::size_t> used;
  for (std::size_t row = 0; row < columns.size(); ++row)
    if (columns[row]) {
      EXPECT_TRUE(used.insert(*columns[row]).second);
      gain += gains[row][*columns[row]];
    }
  return gain;
}

/** The best of all ways to give each row a column of a square. */
double
bestGainOf(const std::vector<std::vector<double>>& gains, std::size_t columns)
{
  std::vector<std::size_t> order(std::max(gains.size(), columns));
  std::iota(order.begin(), order.end(), std::size_t{0});
  double best = 0.0;
  do {
    double gain = 0.0;
    for (std::size_t row = 0; row < gains.size(); ++row)
      if (order[row] < columns)
        gain += gains[row][order[row]];
    best = std::max(best, gain);
  }
  while (std::next_permutation(order.begin(), order.end()));
  return best;
}

TEST(Assignment, IsTheBestOfAll)
{
  EXPECT_TRUE(bestAssignment({}).empty());
  pcl::test::Random random(7);
  for (const auto& [rows, columns] :
       {std::pair{1, 1}, {3, 3}, {2, 5}, {5, 2}, {6, 6}, {4, 0}})
    for (int trial = 0; trial < 20; ++trial) {
      std::vector<std::vector<double>> gains(static_cast<std::size_t>(rows));
      for (auto& row : gains)
        for (int column = 0; column < columns; ++column)
          row.push_back(std::max(0.0, random.uniform(-0.5, 1.0)));
      EXPECT_NEAR(
          gainOf(gains), bestGainOf(gains, static_cast<std::size_t>(columns)), exact)
          << rows << " x " << columns;
    }
}

TEST(Objects, AreMatchedAsAWholeAndCountedOverPoints)
{
  std::vector<LabelPair> points;
  const auto add = [&](int count, std::uint32_t truth, std::uint32_t predicted) {
    points.insert(points.end(), static_cast<std::size_t>(count), {truth, predicted});
  };
  // Instance 7 is best for both objects, but 1 can also have 8, and 2 nothing else.
  add(500, 11, 7);
  add(400, 12, 8);
  add(500, 20, 7);
  add(60, 20, 0);
  add(299, 30, 9); // too small to be an object, but 9 is a false alarm
  add(50, 5, 8);   // no object
  const ObjectEvaluation evaluation = evaluateObjects(points, {10, 300});
  EXPECT_EQ(evaluation.objects, 2u);
  EXPECT_EQ(evaluation.instances, 3u);
  expectScore(evaluation.overlap, 900, 849, 560);
  EXPECT_EQ(evaluation.found, 0u);
  EXPECT_EQ(evaluateObjects(points, {10, 299}).found, 1u);
  EXPECT_TRUE(std::isnan(evaluateObjects({{1, 1}}, {1, 2}).foundShare()));
}

TEST_F(Tasks, ObjectsAreLabelsOfTheTruthIfItHasNoInstances)
{
  const std::string predicted = file(
      "p.pcd",
      asciiCloud(
          "x y z instance", "F F F U", {"0 0 1 1", "0 0 1 1", "0 0 1 1", "0 0 1 0"}));
  const auto truth = [&](const std::string& name, const std::string& field) {
    return file(name,
                asciiCloud("x y z " + field,
                           "F F F U",
                           {"0 0 1 21", "0 0 1 21", "0 0 1 20", "0 0 1 1"}));
  };
  const auto outcome = runApp("pcl_shape_evaluate",
                              {predicted,
                               truth("t.pcd", "label"),
                               "-task",
                               "objects",
                               "-parts",
                               "10",
                               "-min_points",
                               "2",
                               "-json",
                               path("json")});
  expectSuccess(outcome);
  EXPECT_NE(outcome.out.find("objects 1, instances 1"), std::string::npos);
  EXPECT_NE(readFile(path("json")).find("\"found\": 1"), std::string::npos);
  expectRefused(runApp("pcl_shape_evaluate",
                       {predicted, truth("s.pcd", "segment"), "-task", "objects"}),
                1,
                {"s.pcd", "instance or label"});
  expectRefused(runApp("pcl_shape_evaluate",
                       {predicted, predicted, "-task", "edge", "-parts", "10"}),
                2,
                {"-parts", "'edge'", "expected -task objects or grasps"});
}

TEST_F(Tasks, CloudsOfOtherSizesAreRefused)
{
  const std::string truth =
      file("t.pcd", asciiCloud("x y z edge", "F F F U", {"nan 0 0 255", "0 0 1 1"}));
  const std::string predicted =
      file("p.pcd", asciiCloud("x y z edge", "F F F U", {"0 0 1 1"}));
  expectRefused(runApp("pcl_shape_evaluate", {predicted, truth, "-json", path("json")}),
                1,
                {predicted, "1 points", truth, "2 (1 finite)", "same order"});
  EXPECT_FALSE(exists(path("json")));
}

TEST_F(Tasks, PointsElsewhereAreRefused)
{
  const auto cloud = [&](const std::string& name, const std::string& last) {
    return file(name,
                asciiCloud("x y z edge", "F F F U", {"nan 0 1 1", "0 0 1 1", last}));
  };
  const std::string truth = cloud("t.pcd", "1 0 1 0");
  const std::string rounded = cloud("r.pcd", "1.0001 0 1 1");
  expectSuccess(runApp("pcl_shape_evaluate", {rounded, truth, "-task", "edge"}));
  const std::string moved = cloud("m.pcd", "1.01 0 1 1");
  expectRefused(runApp("pcl_shape_evaluate", {moved, truth, "-task", "edge"}),
                1,
                {moved, "point 2", truth, "same order"});
}

TEST_F(Tasks, NothingToEvaluateIsRefused)
{
  const std::string truth =
      file("t.pcd", asciiCloud("x y z edge", "F F F U", {"0 0 1 255"}));
  expectRefused(
      runApp("pcl_shape_evaluate", {truth, truth}), 1, {truth, "'edge'", "expected"});
  expectRefused(runApp("pcl_shape_evaluate", {truth, truth, "-task", "planar"}),
                1,
                {truth, "'surface'", "expected"});
}

TEST_F(Tasks, TheAppPrintsATable)
{
  const std::string truth = file(
      "t.pcd",
      asciiCloud(
          "x y z surface", "F F F U", {"0 0 1 1", "0 0 1 2", "0 0 1 2", "0 0 1 0"}));
  const std::string predicted = file(
      "p.pcd",
      asciiCloud(
          "x y z surface", "F F F U", {"0 0 1 1", "0 0 1 2", "0 0 1 0", "0 0 1 1"}));
  const auto outcome =
      runApp("pcl_shape_evaluate",
             {predicted, truth, "-task", "curved", "-json", path("json")});
  expectSuccess(outcome);
  EXPECT_NE(outcome.out.find("4 points, 3 evaluated, 1 of them"), std::string::npos);
  EXPECT_NE(outcome.out.find("class-mean IoU 0.750"), std::string::npos);
  EXPECT_NE(outcome.out.find("accuracy 0.667"), std::string::npos);
  EXPECT_NE(readFile(path("json")).find("\"f1\": 0.6666666666666666"),
            std::string::npos);
  EXPECT_TRUE(outcome.err.empty());
}

TEST_F(Tasks, APredictionThatIsTheTruthItselfIsNoticed)
{
  const auto edges = [&](const std::string& name, const std::string& last) {
    return file(name,
                asciiCloud("x y z edge", "F F F U", {"0 0 1 1", "0 0 1 0", last}));
  };
  const std::string truth = edges("t.pcd", "0 0 1 255");
  const auto copied =
      runApp("pcl_shape_evaluate", {edges("c.pcd", "0 0 1 255"), truth});
  EXPECT_EQ(copied.status, 0);
  for (const char* word : {"warning", "c.pcd", "'edge'", "t.pcd"})
    EXPECT_NE(copied.err.find(word), std::string::npos) << word;
  expectSuccess(runApp("pcl_shape_evaluate", {edges("p.pcd", "0 0 1 1"), truth}));
}

} // namespace
