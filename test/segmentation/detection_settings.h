// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A small cloud with given INAD, and models of it, for tests of settings.

#pragma once

#include "support/clouds.h"
#include "support/errors.h"

#include <pcl/segmentation/shape_back_projection.h>
#include <pcl/segmentation/shape_edge_detection.h>

#include <gtest/gtest.h>

#include <string>
#include <type_traits>
#include <vector>

/** What the tests of settings and of models share. */
namespace pcl::test {

/** \brief The paper's method on 100 points in a plane; INAD in bins 0 to 9 of mu, ten
 * points each. */
template <typename Class>
class DetectionSettings : public testing::Test {
protected:
  DetectionSettings()
  {
    detection_.setInputCloud(toCloud<PointXYZ>(grid(10, 0.004)));
    detection_.setMode(Class::PAPER);
    inad_->resize(100);
    for (std::size_t i = 0; i < 100; ++i) {
      (*inad_)[i].mu =
          static_cast<float>((static_cast<double>(i / 10) + 0.5) * pi / 20);
    }
  }

  void
  expectRefused(std::vector<std::string> parts)
  {
    PointCloud<Intensity> first(3, 1);
    std::vector<std::vector<float>> likelihoods(3);
    std::vector<PointIndices> segments(3);
    const std::string name = std::is_same_v<Class, ShapeBackProjection<PointXYZ>>
                                 ? "ShapeBackProjection"
                                 : "ShapeEdgeDetection";
    parts.insert(parts.begin(), "[pcl::" + name + "::compute]");
    expectParts(errorsOf([&] { detection_.compute(first); }), parts);
    expectParts(errorsOf([&] { detection_.compute(likelihoods); }), parts);
    expectParts(errorsOf([&] { detection_.segment(segments); }), parts);
    EXPECT_TRUE(first.empty());
    EXPECT_TRUE(likelihoods.empty());
    EXPECT_TRUE(segments.empty());
  }

  /** \brief One value of each class for each bin of mu. */
  std::vector<std::vector<float>>
  expectAccepted()
  {
    std::vector<std::vector<float>> all, of_bins;
    EXPECT_EQ("", errorsOf([&] { detection_.compute(all); }));
    for (const auto& values : all) {
      EXPECT_EQ(100U, values.size());
      of_bins.emplace_back();
      for (std::size_t i = 5; i < values.size(); i += 10)
        of_bins.back().push_back(values[i]);
    }
    EXPECT_FALSE(all.empty());
    return of_bins;
  }

  std::vector<std::size_t>
  segmentSizes()
  {
    std::vector<PointIndices> segments;
    detection_.segment(segments);
    std::vector<std::size_t> sizes;
    for (const PointIndices& segment : segments)
      sizes.push_back(segment.indices.size());
    return sizes;
  }

  Class detection_;
  PointCloud<INAD>::Ptr inad_ = make_shared<PointCloud<INAD>>();
};

} // namespace pcl::test
