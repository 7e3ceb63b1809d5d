// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The pipeline from points to likelihoods, by PCL and by this library.

#pragma once

#include "common/clouds.h"

#include <pcl/features/inad_point.h>

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

/** \brief Normals, INAD over one or more radii, and of each the likelihood at every
 * point, over 10 x 10 bins of 90 degrees. */
struct Pipeline {
  double normal_radius; ///< meters
  std::vector<double> inad_radii;
  bool own_histogram; ///< the likelihood of the cloud's own histogram, not a plane's

  /** \param[in] task "pipeline" (normals over 10 mm, INAD over 6 and 20 mm, the cloud's
   * own histogram), "edges" or "surfaces" (the detectors' radii, an ideal plane)
   * \param[in] scale of all radii
   */
  static Pipeline of(const std::string& task, double scale);
};

struct PipelineResult {
  std::vector<pcl::PointCloud<pcl::INAD>> inad; ///< of each radius, of runShape()
  std::vector<std::vector<float>> mu, sigma;    ///< of runPcl(), and of splitINAD()
  std::vector<std::vector<float>> likelihood;
  std::uint64_t neighbors = 0; ///< of all INAD, the points themselves not counted
};

constexpr std::size_t bins = 10;

/** \brief As a user of PCL writes it: NormalEstimationOMP, then a loop over
 * radiusSearch(). \param[in] sorted the argument of pcl::search::KdTree */
PipelineResult runPcl(const Pipeline& pipeline,
                      const Cloud::ConstPtr& cloud,
                      bool sorted,
                      int threads);

/** \brief The same with NormalEstimationSweep and INADEstimation. */
PipelineResult
runShape(const Pipeline& pipeline, const Cloud::ConstPtr& cloud, unsigned threads);

/** \brief Set mu and sigma from the clouds. */
void splitINAD(PipelineResult& result);

/** \brief The neighbors that runShape() goes through. */
std::uint64_t
countShapeNeighbors(const Pipeline& pipeline, const Cloud& cloud, unsigned threads);

/** \brief The most bytes a point that NormalEstimationSweep or INADEstimation has in
 * use beside the cloud that it returns. */
double
maxExtraBytes(const Pipeline& pipeline, const Cloud::ConstPtr& cloud, unsigned threads);
