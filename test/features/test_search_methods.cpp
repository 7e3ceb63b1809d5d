// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A search method that is set gives the neighbors, and the results stay the same.

#include "support/clouds.h"
#include "support/counting_search.h"
#include "support/differences.h"
#include "support/sweep.h"

#include <pcl/features/inad.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/search/brute_force.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include <gtest/gtest.h>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;
using SearchPtr = search::Search<PointXYZ>::Ptr;

struct Size {
  double radius;
  int k;
};

const Size sizes[] = {{0.02, 0}, {0.0, 40}};

struct Results {
  std::vector<float> normals;
  std::vector<float> inad;
};

/** \brief Normals, and the INAD of the input's true ones. */
Results
compute(const Cloud::Ptr& cloud,
        const PointCloud<Normal>::Ptr& given,
        const Size& size,
        const SearchPtr& search,
        unsigned threads = 0,
        double outlier_rate = 2.0)
{
  NormalEstimationSweep<PointXYZ, Normal> normal_estimation(threads);
  INADEstimation<PointXYZ, Normal> estimation(threads);
  const auto configure = [&](auto& feature) {
    feature.setInputCloud(cloud);
    feature.setSearchMethod(search);
    feature.setRadiusSearch(size.radius);
    feature.setKSearch(size.k);
  };
  configure(normal_estimation);
  configure(estimation);
  PointCloud<Normal> normals;
  normal_estimation.compute(normals);
  estimation.setInputNormals(given);
  estimation.setOutlierRate(outlier_rate);
  PointCloud<INAD> inad;
  estimation.compute(inad);
  EXPECT_EQ(search, normal_estimation.getSearchMethod());
  EXPECT_EQ(search, estimation.getSearchMethod());
  return {normalValuesOf(normals), valuesOf(inad)};
}

double
shareWithin(const std::vector<float>& a, const std::vector<float>& b, double tolerance)
{
  Differences differences;
  differences.add(a, b);
  EXPECT_GT(differences.known(), a.size() / 2);
  return differences.within(tolerance);
}

class SearchMethods : public testing::Test {
protected:
  SearchMethods()
  {
    Random random(31);
    scene_ = mixedScene(4000, random);
    scene_.addNoise(0.0005, random);
    cloud_ = toCloud<PointXYZ>(scene_);
    normals_ = trueNormalsOf<Normal>(scene_);
  }

  /** \brief One neighbor more or less moves a mean by far more than rounding does: it
   * would show at any point, but for an angle that rounding pushes over the limit of
   * the rejection, which is off here. */
  void
  expectEqual(const SearchPtr& search) const
  {
    for (const Size& size : sizes) {
      const Results swept = compute(cloud_, normals_, size, nullptr, 0, 0.0);
      const Results found = compute(cloud_, normals_, size, search, 0, 0.0);
      EXPECT_EQ(1.0, shareWithin(swept.inad, found.inad, 1e-6));
      EXPECT_GE(shareWithin(swept.normals, found.normals, 1e-6), 0.999);
      EXPECT_EQ(1.0, shareWithin(swept.normals, found.normals, 1e-4));
    }
  }

  void
  expectAlmostAll(const Cloud::Ptr& cloud,
                  const PointCloud<Normal>::Ptr& normals,
                  const SearchPtr& search,
                  const Size& size) const
  {
    const Results swept = compute(cloud, normals, size, nullptr);
    const Results found = compute(cloud, normals, size, search);
    EXPECT_GE(shareWithin(swept.inad, found.inad, 1e-5), 0.99);
    EXPECT_GE(shareWithin(swept.normals, found.normals, 1e-5), 0.99);
  }

  Surface scene_;
  Cloud::Ptr cloud_;
  PointCloud<Normal>::Ptr normals_;
};

TEST_F(SearchMethods, KdTreeAgreesExactly)
{
  expectEqual(make_shared<search::KdTree<PointXYZ>>());
  expectEqual(make_shared<search::KdTree<PointXYZ>>(false));
}

TEST_F(SearchMethods, BruteForceAgreesExactly)
{
  expectEqual(make_shared<search::BruteForce<PointXYZ>>());
}

TEST_F(SearchMethods, KdTreeFindsTheSameNumbersOfNeighbors)
{
  search::KdTree<PointXYZ> tree;
  tree.setInputCloud(cloud_);
  const auto counts = sweptCounts(NeighborhoodSweep(scene_.points()),
                                  NeighborhoodSize::ofRadius(sizes[0].radius));
  Indices found;
  std::vector<float> distances;
  for (std::size_t i = 0; i < cloud_->size(); ++i) {
    tree.radiusSearch((*cloud_)[i], sizes[0].radius, found, distances);
    ASSERT_EQ(found.size() - 1, counts[i]);
  }
}

TEST_F(SearchMethods, OctreeAgreesAtAlmostAllPoints)
{
  for (const Size& size : sizes) {
    expectAlmostAll(
        cloud_, normals_, make_shared<search::Octree<PointXYZ>>(0.02), size);
  }
}

TEST_F(SearchMethods, OrganizedNeighborAgreesAtAlmostAllPoints)
{
  const auto image = depthImage<PointXYZ>(120, 90);
  NormalEstimationSweep<PointXYZ, Normal> estimation;
  estimation.setInputCloud(image);
  estimation.setRadiusSearch(0.03);
  const auto normals = make_shared<PointCloud<Normal>>();
  estimation.compute(*normals);
  for (const Size& size : {Size{0.03, 0}, Size{0, 40}}) {
    expectAlmostAll(
        image, normals, make_shared<search::OrganizedNeighbor<PointXYZ>>(), size);
  }
}

TEST_F(SearchMethods, AGivenOneIsAskedForEachPoint)
{
  const auto counting = make_shared<CountingSearch>();
  compute(cloud_, normals_, sizes[0], counting);
  EXPECT_EQ(2 * cloud_->size(), counting->radius_calls); // normals and INAD
  EXPECT_EQ(0U, counting->nearest_calls);
  compute(cloud_, normals_, sizes[1], counting);
  EXPECT_EQ(2 * cloud_->size(), counting->nearest_calls);
  EXPECT_EQ(cloud_, counting->getInputCloud());
}

/** \brief compute() checks that getSearchMethod() is what was set: also null. */
TEST_F(SearchMethods, NoneIsBuiltWithoutOne)
{
  for (const auto& cloud : {cloud_, depthImage<PointXYZ>(40, 30)}) {
    const auto normals = make_shared<PointCloud<Normal>>(cloud->size(), 1);
    EXPECT_FALSE(compute(cloud, normals, sizes[0], nullptr).inad.empty());
  }
}

TEST_F(SearchMethods, AnyNumberOfThreadsGivesTheSameBits)
{
  Random random(32);
  Surface large = mixedScene(102000, random);
  large.addNoise(0.0005, random);
  const auto cloud = toCloud<PointXYZ>(large);
  const auto normals = trueNormalsOf<Normal>(large);
  ASSERT_GE(cloud->size(), 100000U);
  for (const Size& size : {Size{0.004, 0}, Size{0, 12}}) {
    for (const SearchPtr& search :
         {SearchPtr(), SearchPtr(make_shared<search::KdTree<PointXYZ>>(false))}) {
      const Results one = compute(cloud, normals, size, search, 1);
      for (const unsigned threads : {2U, 4U}) {
        const Results many = compute(cloud, normals, size, search, threads);
        EXPECT_TRUE(sameBits(one.normals, many.normals));
        EXPECT_TRUE(sameBits(one.inad, many.inad));
      }
    }
  }
}

TEST_F(SearchMethods, IndicesOfOneStayWhenACloudIsNotAsDenseAsItSays)
{
  auto points = make_shared<Indices>();
  for (std::size_t i = 0; i < cloud_->size() / 2; ++i)
    points->push_back(static_cast<index_t>(i));
  (*cloud_)[7].x = std::numeric_limits<float>::quiet_NaN();
  ASSERT_TRUE(cloud_->is_dense);
  const auto honest = make_shared<Cloud>(*cloud_);
  honest->is_dense = false;
  const auto expected = make_shared<search::KdTree<PointXYZ>>();
  expected->setInputCloud(honest, points);
  const auto search = make_shared<search::KdTree<PointXYZ>>();
  search->setInputCloud(honest, points);
  search->setInputCloud(make_shared<Cloud>(*honest), points);
  const Size size{0.02, 0};
  const Results right = compute(honest, normals_, size, expected);
  for (int time = 0; time < 2; ++time) {
    const Results found = compute(cloud_, normals_, size, search);
    EXPECT_TRUE(sameBits(right.normals, found.normals));
    EXPECT_TRUE(sameBits(right.inad, found.inad));
  }
}

} // namespace
