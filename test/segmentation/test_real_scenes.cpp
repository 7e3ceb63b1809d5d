// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Surfaces and edges of real scenes reach the accuracy that the documentation states.

#include "instances/instance_scenes.h"

#include <pcl/io/pcd_io.h>
#include <pcl/point_types.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <string>

/** \brief A point of a depth camera's scene with its ground truth. */
struct LabeledPoint {
  PCL_ADD_POINT4D;
  std::uint32_t surface; ///< 0 void, 1 planar, 2 curved, 3 near a crease
  std::uint32_t edge;    ///< 0 no, 1 yes, 255 void
  PCL_MAKE_ALIGNED_OPERATOR_NEW
};

POINT_CLOUD_REGISTER_POINT_STRUCT(
    LabeledPoint,
    (float, x, x)(float, y, y)(float, z, z)(std::uint32_t,
                                            surface,
                                            surface)(std::uint32_t, edge, edge))

// The paper's method on real scenes with ground truth. "Paper-like": a point near a
// crease is curved. "Strict": points that are neither on a crease nor clearly off one
// are left out.
namespace {

using namespace pcl;

using Cloud = PointCloud<PointXYZ>;

struct Counts {
  double true_positives = 0, false_positives = 0, false_negatives = 0;

  void
  add(bool is_true, bool is_predicted)
  {
    true_positives += is_true && is_predicted;
    false_positives += !is_true && is_predicted;
    false_negatives += is_true && !is_predicted;
  }

  double
  f1() const
  {
    return 2 * true_positives /
           (2 * true_positives + false_positives + false_negatives);
  }
};

class RealScenes : public testing::Test {
protected:
  void
  SetUp() override
  {
    if (std::string(PCL_SHAPE_TEST_DATA).empty())
      GTEST_SKIP() << "PCL_SHAPE_TEST_DATA is not set: no scenes";
  }

  void
  load(const std::string& scene)
  {
    const std::string file =
        std::string(PCL_SHAPE_TEST_DATA) + "/osd/" + scene + "_gt.pcd";
    ASSERT_EQ(0, io::loadPCDFile(file, truth_)) << file;
    cloud_ = make_shared<Cloud>();
    for (const LabeledPoint& point : truth_)
      cloud_->push_back(PointXYZ(point.x, point.y, point.z));
  }

  /** \brief The class of each point: 1, 2, ... or 0 for none. */
  template <typename Detection>
  std::vector<std::size_t>
  detect() const
  {
    Detection detection;
    detection.setMode(Detection::PAPER);
    detection.setInputCloud(cloud_);
    std::vector<PointIndices> classes;
    detection.segment(classes);
    std::vector<std::size_t> result(cloud_->size());
    for (std::size_t c = 0; c < classes.size(); ++c)
      for (const index_t i : classes[c].indices)
        result[static_cast<std::size_t>(i)] = c + 1;
    return result;
  }

  void
  expectSurfaces(const std::string& scene, double least_curved_f1)
  {
    load(scene);
    const auto found = detect<ShapeBackProjection<PointXYZ>>();
    Counts planar, curved;
    for (std::size_t i = 0; i < found.size(); ++i) {
      if (truth_[i].surface > 0) {
        planar.add(truth_[i].surface == 1, found[i] == 1);
        curved.add(truth_[i].surface >= 2, found[i] == 2);
      }
    }
    EXPECT_GE(planar.f1(), 0.96);
    EXPECT_GE(curved.f1(), least_curved_f1);
    RecordProperty("planar_f1", std::to_string(planar.f1()));
    RecordProperty("curved_f1", std::to_string(curved.f1()));
  }

  PointCloud<LabeledPoint> truth_;
  Cloud::Ptr cloud_;
};

TEST_F(RealScenes, CylindersOfLearn33)
{
  load("learn33");
  const auto curved = make_shared<Indices>();
  std::vector<bool> evaluated;
  for (std::size_t i = 0; i < truth_.size(); ++i) {
    const std::uint32_t surface = truth_[i].surface;
    evaluated.push_back(surface == 1 || surface == 2);
    if (surface == 2)
      curved->push_back(static_cast<index_t>(i));
  }
  EuclideanClusterExtraction<PointXYZ> clustering;
  clustering.setInputCloud(cloud_);
  clustering.setIndices(curved);
  clustering.setClusterTolerance(0.010);
  clustering.setMinClusterSize(100);
  std::vector<PointIndices> parts;
  clustering.extract(parts);
  const test::Labels truth = test::labelsOf(parts, truth_.size());
  const test::Found found =
      test::compare(truth, test::instancesOf(cloud_, "curved"), evaluated);
  EXPECT_GE(found.point_f1, 0.85);
  RecordProperty("point_f1", std::to_string(found.point_f1));
}

TEST_F(RealScenes, SurfacesOfLearn4) { expectSurfaces("learn4", 0.60); }

TEST_F(RealScenes, SurfacesOfLearn20) { expectSurfaces("learn20", 0.58); }

TEST_F(RealScenes, SurfacesOfLearn33) { expectSurfaces("learn33", 0.77); }

TEST_F(RealScenes, SurfacesOfLearn44) { expectSurfaces("learn44", 0.82); }

TEST_F(RealScenes, EdgesOfAllScenes)
{
  double mean = 0;
  const std::vector<std::string> scenes{
      "learn4", "learn20", "learn22", "learn27", "learn30", "learn33", "learn44"};
  for (const std::string& scene : scenes) {
    load(scene);
    const auto found = detect<ShapeEdgeDetection<PointXYZ>>();
    Counts edges;
    for (std::size_t i = 0; i < found.size(); ++i)
      if (truth_[i].edge <= 1)
        edges.add(truth_[i].edge == 1, found[i] == 1);
    mean += edges.f1() / static_cast<double>(scenes.size());
    RecordProperty(scene, std::to_string(edges.f1()));
  }
  EXPECT_GE(mean, 0.82);
}

} // namespace
