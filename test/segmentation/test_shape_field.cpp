// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One field serves all classes, and is refused where it does not belong.

#include "detection_scenes.h"
#include "support/errors.h"

#include <pcl/features/normal_3d_sweep.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_instance_segmentation.h>
#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/suction_grasp_estimation.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <string>

namespace {

using namespace pcl;
using namespace pcl::test;

using Estimation = ShapeFieldEstimation<PointXYZ>;
using Numbers = std::vector<float>;

void
add(Numbers& numbers, const Eigen::Vector3f& v)
{
  numbers.insert(numbers.end(), v.data(), v.data() + 3);
}

/** A cube and a can on a table, seen from above; points about 2 mm apart at random, so
 * that no two neighbors are equally far. */
Cloud::Ptr
tableScene()
{
  constexpr double density = 1.0 / (0.0021 * 0.0021), side = 0.08, radius = 0.04,
                   height = 0.1;
  const auto points = [](double area) {
    return static_cast<std::size_t>(density * area);
  };
  Random random(61);
  Surface scene = plane(points(0.3 * 0.3), 0.3, random);
  Surface cube = sampled(points(5 * side * side), random, [=](Random& r) {
    for (;;) {
      const SurfacePoint p = onCube(r);
      if (p.position.z() > 0.0)
        return SurfacePoint{side * p.position, p.normal};
    }
  });
  cube.move(Eigen::Isometry3d(Eigen::Translation3d(0.04, 0.05, 0.0)));
  Surface can = cylinder(points(2 * pi * radius * height), radius, height, random);
  can.move(Eigen::Isometry3d(Eigen::Translation3d(0.22, 0.2, 0.0)));
  scene.append(cube);
  scene.append(can);
  Eigen::Isometry3d pose(Eigen::AngleAxisd(pi, Eigen::Vector3d::UnitX()));
  pose.pretranslate(Eigen::Vector3d(-0.15, 0.15, 0.6));
  scene.move(pose);
  return toCloud<PointXYZ>(scene);
}

ShapeField::Ptr
fieldOf(Estimation& estimation, const Cloud::ConstPtr& cloud)
{
  estimation.setInputCloud(cloud);
  const auto field = make_shared<ShapeField>();
  EXPECT_TRUE(estimation.compute(*field));
  return field;
}

/** What the classes find, as numbers to compare bit by bit. */
struct Results {
  Numbers edges, types, creases, surfaces, curved, objects, grasps, labels;
};

Numbers
numbersOf(const Likelihoods& likelihoods)
{
  Numbers numbers;
  for (const auto& of_class : likelihoods)
    numbers.insert(numbers.end(), of_class.begin(), of_class.end());
  return numbers;
}

Numbers
numbersOf(const std::vector<ShapeInstance>& instances)
{
  Numbers numbers;
  for (const ShapeInstance& instance : instances) {
    numbers.push_back(static_cast<float>(instance.indices.size()));
    numbers.insert(numbers.end(), instance.indices.begin(), instance.indices.end());
    add(numbers, instance.centroid);
    numbers.insert(numbers.end(), instance.shares.begin(), instance.shares.end());
    const ShapePrimitive& primitive = instance.primitive;
    numbers.push_back(static_cast<float>(primitive.type));
    numbers.insert(
        numbers.end(), primitive.coefficients.begin(), primitive.coefficients.end());
    numbers.push_back(primitive.residual);
  }
  return numbers;
}

Numbers
numbersOf(const std::vector<SuctionGrasp>& grasps)
{
  Numbers numbers;
  for (const SuctionGrasp& grasp : grasps) {
    add(numbers, grasp.position);
    add(numbers, grasp.approach);
    for (const SealProblem problem : grasp.problems)
      numbers.push_back(static_cast<float>(problem));
    numbers.insert(numbers.end(),
                   {grasp.score,
                    grasp.likelihood,
                    grasp.covered,
                    grasp.edge_distance,
                    grasp.obstacle_distance,
                    grasp.residual,
                    grasp.bandwidth,
                    static_cast<float>(grasp.surface),
                    static_cast<float>(grasp.iterations)});
  }
  return numbers;
}

/** \param[in] prepare sets the cloud and all else of each class */
template <typename Prepare>
Results
resultsOf(const Prepare& prepare)
{
  Results results;
  ShapeEdgeDetection<PointXYZ> edge_detection;
  prepare(edge_detection);
  Edges edges;
  edge_detection.detect(edges);
  Likelihoods likelihoods;
  edge_detection.compute(likelihoods);
  results.edges = numbersOf(likelihoods);
  EXPECT_TRUE(sameBits(edges.likelihood, likelihoods.at(0)));
  for (const EdgeType type : edges.types)
    results.types.push_back(static_cast<float>(type));
  for (const CreasePoint& crease : edges.creases) {
    results.creases.insert(
        results.creases.end(), crease.position.begin(), crease.position.end());
    results.creases.insert(results.creases.end(), {crease.angle, crease.spacing});
  }

  ShapeBackProjection<PointXYZ> projection;
  prepare(projection);
  projection.compute(likelihoods);
  results.surfaces = numbersOf(likelihoods);

  ShapeInstanceSegmentation<PointXYZ> segmentation;
  prepare(segmentation);
  segmentation.setPrimitive(PrimitiveType::Auto);
  std::vector<ShapeInstance> instances;
  EXPECT_TRUE(segmentation.segment(instances));
  results.curved = numbersOf(instances);
  segmentation.setClass("object");
  EXPECT_TRUE(segmentation.segment(instances));
  results.objects = numbersOf(instances);

  SuctionGraspEstimation<PointXYZ> estimation;
  prepare(estimation);
  std::vector<SuctionGrasp> grasps;
  EXPECT_TRUE(estimation.compute(grasps));
  results.grasps = numbersOf(grasps);

  ShapeLabeling<PointXYZ> labeling;
  prepare(labeling);
  PointLabels labels;
  labeling.label(labels);
  results.labels = labels.confidence;
  results.labels.insert(
      results.labels.end(), labels.labels.begin(), labels.labels.end());
  return results;
}

void
expectSame(const Results& expected, const Results& found)
{
  const auto expect = [](const char* name, const Numbers& a, const Numbers& b) {
    EXPECT_FALSE(a.empty()) << name;
    EXPECT_TRUE(sameBits(a, b)) << name;
  };
  expect("edges", expected.edges, found.edges);
  expect("types", expected.types, found.types);
  expect("creases", expected.creases, found.creases);
  expect("surfaces", expected.surfaces, found.surfaces);
  expect("curved instances", expected.curved, found.curved);
  expect("objects", expected.objects, found.objects);
  expect("grasps", expected.grasps, found.grasps);
  expect("labels", expected.labels, found.labels);
}

/** use(name, task, run) for each class that works on a field; run() computes, and is
 * true if that gives something. */
template <typename Use>
void
forEachTask(const Use& use)
{
  Likelihoods likelihoods;
  ShapeEdgeDetection<PointXYZ> edge_detection;
  use("ShapeEdgeDetection", edge_detection, [&] {
    edge_detection.compute(likelihoods);
    return !likelihoods.empty();
  });
  ShapeBackProjection<PointXYZ> projection;
  use("ShapeBackProjection", projection, [&] {
    projection.compute(likelihoods);
    return !likelihoods.empty();
  });
  ShapeInstanceSegmentation<PointXYZ> segmentation;
  use("ShapeInstanceSegmentation", segmentation, [&] {
    std::vector<ShapeInstance> instances(1);
    const bool is_done = segmentation.segment(instances);
    EXPECT_EQ(is_done, !instances.empty());
    return is_done;
  });
  SuctionGraspEstimation<PointXYZ> estimation;
  use("SuctionGraspEstimation", estimation, [&] {
    std::vector<SuctionGrasp> grasps(1);
    const bool is_done = estimation.compute(grasps);
    EXPECT_EQ(is_done, !grasps.empty());
    return is_done;
  });
  ShapeLabeling<PointXYZ> labeling;
  use("ShapeLabeling", labeling, [&] {
    PointLabels labels{{1}, {1.0f}};
    labeling.label(labels);
    return !labels.labels.empty();
  });
}

class OneField : public testing::Test {
protected:
  static void
  SetUpTestSuite()
  {
    cloud_ = tableScene();
    Estimation estimation;
    field_ = fieldOf(estimation, cloud_);
  }

  static void
  TearDownTestSuite()
  {
    cloud_.reset();
    field_.reset();
  }

  static std::size_t
  size()
  {
    return cloud_->size();
  }

  /** Some of the points: part of the table, with objects of both kinds. */
  static IndicesPtr
  right()
  {
    Indices indices;
    for (std::size_t i = 0; i < size(); ++i)
      if ((*cloud_)[i].x > -0.1f)
        indices.push_back(static_cast<index_t>(i));
    return indicesOf(indices);
  }

  static Results
  resultsWith(const ShapeField::ConstPtr& field, const IndicesPtr& indices = nullptr)
  {
    return resultsOf([&](auto& task) {
      task.setInputCloud(cloud_);
      task.setIndices(indices);
      task.setShapeField(field);
      EXPECT_EQ(field, task.getShapeField());
    });
  }

  static Cloud::Ptr cloud_;
  static ShapeField::Ptr field_;
};

Cloud::Ptr OneField::cloud_;
ShapeField::Ptr OneField::field_;

TEST_F(OneField, GivesWhatEachClassFindsItself)
{
  expectSame(resultsWith(nullptr), resultsWith(field_));
}

TEST_F(OneField, WithAResolution)
{
  constexpr double resolution = 0.003;
  Estimation estimation;
  estimation.setResolution(resolution);
  EXPECT_EQ(resolution, estimation.getResolution());
  const auto field = fieldOf(estimation, cloud_);
  EXPECT_EQ(resolution, field->resolution);
  ASSERT_TRUE(field->base);
  EXPECT_LT(field->base->points.size, size());
  ASSERT_EQ(size(), field->base_points.size());
  EXPECT_TRUE(field->isOf(cloud_.get(), size()));
  const Results own = resultsOf([&](auto& task) {
    task.setInputCloud(cloud_);
    task.setResolution(resolution);
  });
  expectSame(own, resultsWith(field));
  EXPECT_FALSE(sameBits(own.edges, resultsWith(field_).edges));
}

TEST_F(OneField, WithIndices)
{
  const Results all = resultsWith(field_);
  const Results some = resultsWith(field_, right());
  expectSame(resultsWith(nullptr, right()), some);
  EXPECT_LT(some.edges.size(), all.edges.size());
  for (std::size_t i = 0; i < right()->size(); ++i)
    ASSERT_EQ(some.types[i], all.types[static_cast<std::size_t>((*right())[i])]);
}

TEST_F(OneField, WithIndicesAndAResolution)
{
  Estimation estimation;
  estimation.setResolution(0.003);
  const Results own = resultsOf([&](auto& task) {
    task.setInputCloud(cloud_);
    task.setIndices(right());
    task.setResolution(0.003);
  });
  expectSame(own, resultsWith(fieldOf(estimation, cloud_), right()));
}

TEST_F(OneField, WithNormalsOfOnesOwn)
{
  NormalEstimationSweep<PointXYZ, Normal> normal_estimation;
  normal_estimation.setInputCloud(cloud_);
  normal_estimation.setRadiusSearch(0.012);
  const auto normals = make_shared<PointCloud<Normal>>();
  normal_estimation.compute(*normals);
  for (Normal& normal : *normals)
    normal.getNormalVector3fMap() *= 3.0f;
  Estimation estimation;
  estimation.setInputNormals(normals);
  const auto field = fieldOf(estimation, cloud_);
  std::size_t known = 0;
  for (std::size_t i = 0; i < size(); ++i) {
    const Eigen::Vector3f own = (*normals)[i].getNormalVector3fMap().normalized();
    if (!own.allFinite())
      continue;
    ++known;
    ASSERT_NEAR(std::abs(own.dot(field->normals[i])), 1.0f, 1e-5f);
    ASSERT_NEAR(field->normals[i].norm(), 1.0f, 1e-5f);
    ASSERT_LE(field->normals[i].dot((*cloud_)[i].getVector3fMap()), 0.0f);
  }
  EXPECT_GT(known, size() * 9 / 10);
  const Results with_field = resultsWith(field);
  EXPECT_FALSE(sameBits(with_field.edges, resultsWith(field_).edges));

  const auto likelihoodsWithNormals = [&](auto&& detection) {
    EXPECT_EQ(detection.DEFAULT, detection.getMode());
    detection.setInputNormals(normals);
    EXPECT_EQ(normals, detection.getInputNormals());
    return numbersOf(likelihoodsOf(detection, cloud_));
  };
  EXPECT_TRUE(sameBits(with_field.edges,
                       likelihoodsWithNormals(ShapeEdgeDetection<PointXYZ>())));
  EXPECT_TRUE(sameBits(with_field.surfaces,
                       likelihoodsWithNormals(ShapeBackProjection<PointXYZ>())));

  estimation.setResolution(0.003);
  ShapeField refused;
  expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(refused)); }),
              {"normals and a resolution are set"});
}

TEST_F(OneField, NormalsOfAnotherSizeAreRefused)
{
  Estimation estimation;
  estimation.setInputCloud(cloud_);
  estimation.setInputNormals(make_shared<PointCloud<Normal>>(7, 1));
  ShapeField field;
  expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(field)); }),
              {"7 normals", std::to_string(size()) + " points"});
}

TEST_F(OneField, CountsInsteadOfTheSettings)
{
  const Results expected = resultsWith(field_);
  const Results found = resultsOf([&](auto& task) {
    task.setInputCloud(cloud_);
    task.setResolution(0.01);
    task.setSearchMethod(make_shared<search::KdTree<PointXYZ>>());
    task.setShapeField(field_);
  });
  expectSame(expected, found);
}

TEST_F(OneField, OfAnotherCloudIsRefused)
{
  const auto copy = make_shared<Cloud>(*cloud_);
  const auto part = pcl::make_shared<Cloud>(*cloud_, *right());
  forEachTask([&](const std::string& name, auto& task, const auto& run) {
    task.setShapeField(field_);
    for (const auto& other : {copy, part}) {
      task.setInputCloud(other);
      expectParts(errorsOf([&] { EXPECT_FALSE(run()) << name; }),
                  {"[pcl::" + name + "::",
                   "the shape field is of another cloud",
                   std::to_string(size()) + " points",
                   std::to_string(other->size()) + ")"});
    }
    task.setInputCloud(cloud_);
    EXPECT_EQ("", errorsOf([&] { EXPECT_TRUE(run()) << name; }));
  });
}

TEST_F(OneField, OfACloudThatGrewIsRefused)
{
  const auto cloud = make_shared<Cloud>(*cloud_);
  Estimation estimation;
  const auto field = fieldOf(estimation, cloud);
  cloud->push_back(cloud->front());
  forEachTask([&](const std::string& name, auto& task, const auto& run) {
    task.setInputCloud(cloud);
    task.setShapeField(field);
    expectParts(errorsOf([&] { EXPECT_FALSE(run()) << name; }),
                {"the shape field is of another cloud"});
  });
}

TEST_F(OneField, ForEdgesOnlyServesEdgesOnly)
{
  Estimation estimation;
  estimation.setEdgesOnly(true);
  EXPECT_TRUE(estimation.getEdgesOnly());
  const auto field = fieldOf(estimation, cloud_);
  EXPECT_TRUE(field->classes.empty());
  EXPECT_TRUE(field->likelihoods.empty());
  EXPECT_TRUE(sameBits(field_->edge_likelihood, field->edge_likelihood));
  forEachTask([&](const std::string& name, auto& task, const auto& run) {
    task.setInputCloud(cloud_);
    task.setShapeField(field);
    const bool is_for_edges = name == "ShapeEdgeDetection";
    const std::string error = errorsOf([&] { EXPECT_EQ(is_for_edges, run()) << name; });
    EXPECT_EQ(is_for_edges, error.empty()) << error;
    if (!is_for_edges)
      expectParts(error, {"[pcl::" + name + "::", "field", "classes"});
  });
}

bool
isUnknown(const ShapeField& field, std::size_t i)
{
  return std::isnan(field.spacings[i]) && std::isnan(field.edge_likelihood[i]) &&
         field.normals[i].array().isNaN().all() &&
         std::all_of(field.likelihoods.begin(),
                     field.likelihoods.end(),
                     [i](const auto& of_class) { return std::isnan(of_class[i]); });
}

TEST_F(OneField, OfIndicesKnowsNoOthers)
{
  for (const double resolution : {0.0, 0.003}) {
    Estimation estimation;
    estimation.setResolution(resolution);
    const auto all = fieldOf(estimation, cloud_);
    estimation.setIndices(right());
    const auto some = fieldOf(estimation, cloud_);
    EXPECT_EQ(all->noise, some->noise);
    EXPECT_EQ(all->creases.size(), some->creases.size());
    EXPECT_EQ(all->classes, some->classes);
    std::vector<bool> is_wanted(size(), false);
    const IndicesPtr wanted_points = right();
    for (const index_t index : *wanted_points)
      is_wanted[static_cast<std::size_t>(index)] = true;
    ASSERT_EQ(size(), some->spacings.size());
    const auto valuesAt = [](const ShapeField& field, std::size_t i) {
      Numbers values{field.spacings[i], field.edge_likelihood[i]};
      add(values, field.normals[i]);
      for (const auto& of_class : field.likelihoods)
        values.push_back(of_class[i]);
      return values;
    };
    for (std::size_t i = 0; i < size(); ++i) {
      ASSERT_TRUE(is_wanted[i] ? sameBits(valuesAt(*all, i), valuesAt(*some, i))
                               : isUnknown(*some, i));
    }
    for (std::size_t i = 0; i < some->base_points.size(); ++i) {
      const std::int32_t wanted = is_wanted[i] ? all->base_points[i] : -1;
      ASSERT_EQ(wanted, some->base_points[i]);
    }
  }
}

TEST_F(OneField, ASearchMethodFindsTheSame)
{
  Estimation estimation;
  const auto search = make_shared<search::KdTree<PointXYZ>>();
  estimation.setSearchMethod(search);
  EXPECT_EQ(search, estimation.getSearchMethod());
  const auto searched = fieldOf(estimation, cloud_);
  const auto shareOfEqual = [](const Numbers& a, const Numbers& b) {
    EXPECT_EQ(a.size(), b.size());
    std::size_t same = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      const bool is_near = std::abs(a[i] - b[i]) <= 1e-3f * std::abs(a[i]) + 1e-3f;
      same += (std::isnan(a[i]) && std::isnan(b[i])) || is_near ? 1 : 0;
    }
    return static_cast<double>(same) / static_cast<double>(a.size());
  };
  for (std::size_t i = 0; i < size(); ++i)
    ASSERT_FLOAT_EQ(field_->spacings[i], searched->spacings[i]);
  EXPECT_NEAR(field_->noise, searched->noise, 1e-5);
  EXPECT_GE(shareOfEqual(field_->edge_likelihood, searched->edge_likelihood), 0.999);
  for (std::size_t c = 0; c < 2; ++c)
    EXPECT_GE(shareOfEqual(field_->likelihoods[c], searched->likelihoods[c]), 0.999);
}

TEST_F(OneField, OfASearchSurface)
{
  const auto queries = make_shared<Cloud>();
  for (std::size_t i = 0; i < size(); i += 10)
    queries->push_back((*cloud_)[i]);
  queries->push_back(PointXYZ(9, 9, 9));
  Estimation estimation;
  estimation.setSearchSurface(cloud_);
  EXPECT_EQ(cloud_, estimation.getSearchSurface());
  const auto field = fieldOf(estimation, queries);
  EXPECT_TRUE(field->isOf(queries.get(), queries->size()));
  ASSERT_TRUE(field->base);
  EXPECT_TRUE(field->base->isOf(cloud_.get(), size()));
  EXPECT_TRUE(sameBits(field_->edge_likelihood, field->base->edge_likelihood));
  ASSERT_EQ(queries->size(), field->base_points.size());
  for (std::size_t q = 0; q + 1 < queries->size(); ++q) {
    ASSERT_EQ(static_cast<std::int32_t>(10 * q), field->base_points[q]);
    ASSERT_TRUE(sameBits({field_->edge_likelihood[10 * q], field_->spacings[10 * q]},
                         {field->edge_likelihood[q], field->spacings[q]}));
    ASSERT_TRUE(sameBits({field_->likelihoods[1][10 * q]}, {field->likelihoods[1][q]}));
  }
  EXPECT_EQ(-1, field->base_points.back());
  EXPECT_TRUE(isUnknown(*field, queries->size() - 1));
  const auto resultsAt = [&](const ShapeField::ConstPtr& given, auto&& detection) {
    if (given)
      detection.setShapeField(given);
    else
      detection.setSearchSurface(cloud_);
    return numbersOf(likelihoodsOf(detection, queries));
  };
  EXPECT_TRUE(sameBits(resultsAt(nullptr, ShapeEdgeDetection<PointXYZ>()),
                       resultsAt(field, ShapeEdgeDetection<PointXYZ>())));
  EXPECT_TRUE(sameBits(resultsAt(nullptr, ShapeBackProjection<PointXYZ>()),
                       resultsAt(field, ShapeBackProjection<PointXYZ>())));
  // The other classes know no search surface, but take the field of one.
  ShapeLabeling<PointXYZ> labeling;
  labeling.setInputCloud(queries);
  labeling.setShapeField(field);
  PointLabels labels;
  labeling.label(labels);
  ASSERT_EQ(queries->size(), labels.labels.size());
  EXPECT_GT(std::count(labels.labels.begin(), labels.labels.end(), 1U), 500);
  EXPECT_EQ(0.0f, labels.confidence.back());
}

TEST_F(OneField, PointsThatAreNotFiniteDoNotMatter)
{
  // With noise, of which other points would tell another level.
  std::mt19937 random(62);
  std::normal_distribution<float> noise(0.0f, 8e-4f);
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const auto finite = make_shared<Cloud>(), with_gaps = make_shared<Cloud>();
  for (const PointXYZ& p : *cloud_) {
    const float x = noise(random), y = noise(random), z = noise(random);
    finite->push_back(PointXYZ(p.x + x, p.y + y, p.z + z));
    with_gaps->push_back(finite->back());
    with_gaps->push_back(PointXYZ(nan, nan, nan));
  }
  with_gaps->is_dense = false;
  Estimation estimation;
  const auto expected = fieldOf(estimation, finite);
  const auto field = fieldOf(estimation, with_gaps);
  const auto everyOther = [](const Numbers& numbers) {
    Numbers values;
    for (std::size_t i = 0; i < numbers.size(); i += 2)
      values.push_back(numbers[i]);
    return values;
  };
  ASSERT_GT(expected->noise_level, 0.0);
  EXPECT_EQ(expected->noise, field->noise);
  EXPECT_EQ(expected->noise_level, field->noise_level);
  EXPECT_TRUE(sameBits(expected->edge_likelihood, everyOther(field->edge_likelihood)));
  for (std::size_t c = 0; c < field->likelihoods.size(); ++c)
    EXPECT_TRUE(sameBits(expected->likelihoods[c], everyOther(field->likelihoods[c])));
}

TEST_F(OneField, ThreadsDoNotMatter)
{
  Estimation estimation;
  for (const unsigned threads : {1U, 3U}) {
    estimation.setNumberOfThreads(threads);
    EXPECT_EQ(threads, estimation.getNumberOfThreads());
    const auto field = fieldOf(estimation, cloud_);
    EXPECT_TRUE(sameBits(field_->edge_likelihood, field->edge_likelihood));
    EXPECT_TRUE(sameBits(field_->likelihoods[0], field->likelihoods[0]));
  }
}

/** Settings of the paper's method, and of the default one. */
template <typename Detection>
class DetectionModes : public testing::Test {
protected:
  DetectionModes() { detection_.setInputCloud(cloud_); }

  void
  expectRefused(const std::vector<std::string>& parts)
  {
    Likelihoods found(3);
    expectParts(errorsOf([&] { detection_.compute(found); }), parts);
    EXPECT_TRUE(found.empty());
  }

  void
  expectAccepted()
  {
    Likelihoods found;
    EXPECT_EQ("", errorsOf([&] { detection_.compute(found); }));
    EXPECT_EQ(2U, found.size());
  }

  /** In DEFAULT mode, but not in PAPER mode. \param[in] name the setting's */
  template <typename Set>
  void
  expectOfPaper(const std::string& name, const Set& set)
  {
    SCOPED_TRACE(name);
    detection_ = Detection();
    detection_.setInputCloud(cloud_);
    set();
    EXPECT_EQ(Detection::DEFAULT, detection_.getMode()) << "nothing switches it";
    expectRefused({name + " is set", "the paper's method", "setMode(PAPER)"});
    detection_.setMode(Detection::PAPER);
    expectAccepted();
  }

  Cloud::Ptr cloud_ = toCloud<PointXYZ>(grid(20, 0.004));
  Detection detection_;
};

using Detections =
    testing::Types<ShapeBackProjection<PointXYZ>, ShapeEdgeDetection<PointXYZ>>;
TYPED_TEST_SUITE(DetectionModes, Detections);

TYPED_TEST(DetectionModes, TheModeIsWhatWasSet)
{
  EXPECT_EQ(TypeParam::DEFAULT, this->detection_.getMode());
  this->expectAccepted();
  this->detection_.setMode(TypeParam::PAPER);
  EXPECT_EQ(TypeParam::PAPER, this->detection_.getMode());
  this->expectAccepted();
  this->detection_.setMode(TypeParam::DEFAULT);
  EXPECT_EQ(TypeParam::DEFAULT, this->detection_.getMode());
}

TYPED_TEST(DetectionModes, SettingsOfThePaper)
{
  TypeParam& detection = this->detection_;
  this->expectOfPaper("a radius", [&] { detection.setRadius(0.02); });
  this->expectOfPaper("a normal radius", [&] { detection.setNormalRadius(0.02); });
  this->expectOfPaper("k", [&] { detection.setKSearch(12); });
  this->expectOfPaper("an outlier rate", [&] { detection.setOutlierRate(2.0); });
  this->expectOfPaper("a radius mode",
                      [&] { detection.setRadiusMode(TypeParam::FIXED); });
  this->expectOfPaper("setIgnoreModelParameters()",
                      [&] { detection.setIgnoreModelParameters(true); });
  this->expectOfPaper("INAD", [&] {
    detection.setInputINAD(
        make_shared<PointCloud<INAD>>(this->cloud_->size(), 1, INAD{0.1f, 0.1f}));
  });
}

TYPED_TEST(DetectionModes, WhatIsTakenBackIsNotSet)
{
  this->detection_.setKSearch(12);
  this->detection_.setKSearch(0);
  this->detection_.setIgnoreModelParameters(true);
  this->detection_.setIgnoreModelParameters(false);
  this->detection_.setInputINAD(make_shared<PointCloud<INAD>>(400, 1));
  this->detection_.setInputINAD(nullptr);
  this->expectAccepted();
  this->detection_.setMode(TypeParam::PAPER);
  this->detection_.setResolution(0.01);
  this->detection_.setResolution(0.0);
  this->expectAccepted();
}

TYPED_TEST(DetectionModes, SettingsOfTheDefault)
{
  this->detection_.setResolution(0.008);
  this->expectAccepted();
  this->detection_.setMode(TypeParam::PAPER);
  this->expectRefused({"a resolution is set", "belongs to DEFAULT mode"});
  this->detection_.setResolution(0.0);
  Estimation estimation;
  this->detection_.setShapeField(fieldOf(estimation, this->cloud_));
  this->expectRefused({"a shape field is set", "belongs to DEFAULT mode"});
  this->detection_.setMode(TypeParam::DEFAULT);
  this->expectAccepted();
}

TYPED_TEST(DetectionModes, ModelsOfThePaper)
{
  this->detection_.setModel(ShapeModel::idealPlane());
  this->expectRefused({"not made in DENSITY mode", "the paper's method"});
  INADParameters parameters;
  parameters.normal_radius = parameters.radius = 3.0;
  parameters.radius_mode = AdaptiveRadius::DENSITY;
  this->detection_.setModel(ShapeModel::idealPlane(parameters));
  this->expectRefused({"model has 1 classes"});
  this->detection_.setMode(TypeParam::PAPER);
  this->expectAccepted();
}

TEST(DetectionModes, KindsOfEdgesNeedTheDefault)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setInputCloud(toCloud<PointXYZ>(grid(20, 0.004)));
  detection.setMode(detection.PAPER);
  Edges edges;
  expectParts(errorsOf([&] { detection.detect(edges); }), {"use DEFAULT mode"});
  EXPECT_TRUE(edges.likelihood.empty());
  detection.setMode(detection.DEFAULT);
  detection.detect(edges);
  EXPECT_EQ(400U, edges.types.size());
}

TEST(Settings, EverySetterHasItsGetter)
{
  ShapeEdgeDetection<PointXYZ> detection;
  detection.setMode(detection.PAPER);
  detection.setNormalRadius(0.02);
  detection.setRadius(0.01);
  detection.setOutlierRate(3.0);
  detection.setIgnoreModelParameters(true);
  EXPECT_EQ(0.02, detection.getNormalRadius());
  EXPECT_EQ(0.01, detection.getRadius());
  EXPECT_EQ(3.0, detection.getOutlierRate());
  EXPECT_TRUE(detection.getIgnoreModelParameters());
  ShapeBackProjection<PointXYZ> nearest;
  nearest.setMode(nearest.PAPER);
  nearest.setKSearch(7);
  EXPECT_EQ(7, nearest.getKSearch());

  ShapeInstanceSegmentation<PointXYZ> segmentation;
  segmentation.setModel(ShapeModel::defaultEdges());
  EXPECT_EQ("edge", segmentation.getModel().classes().front().name);
  const auto cloud = toCloud<PointXYZ>(grid(20, 0.004));
  cloud->sensor_origin_ = Eigen::Vector4f(1.0f, 2.0f, 3.0f, 0.0f);
  segmentation.setInputCloud(cloud);
  EXPECT_EQ(Eigen::Vector3f(1.0f, 2.0f, 3.0f), segmentation.getViewPoint());
  segmentation.setViewPoint(4.0f, 5.0f, 6.0f);
  EXPECT_EQ(Eigen::Vector3f(4.0f, 5.0f, 6.0f), segmentation.getViewPoint());
}

} // namespace
