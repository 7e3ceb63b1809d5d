// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Brings two views of a scene together by features of keypoints.

#pragma once

#include <pcl/features/fpfh_omp.h>
#include <pcl/features/normal_3d_sweep.h>
#include <pcl/filters/voxel_grid.h>
#include <pcl/registration/correspondence_estimation.h>
#include <pcl/registration/correspondence_rejection_sample_consensus.h>
#include <pcl/search/kdtree.h>

using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Features = pcl::PointCloud<pcl::FPFHSignature33>;

/** \brief A cloud and some of its points, or points near it. */
struct View {
  Cloud::ConstPtr cloud;     ///< finite points
  Cloud::ConstPtr keypoints; ///< where the views are compared
};

struct Alignment {
  Eigen::Matrix4f pose = Eigen::Matrix4f::Identity(); ///< from the first view to the
                                                      ///< second
  std::size_t matches = 0;  ///< keypoints with the most similar features
  std::size_t agreeing = 0; ///< those that the pose brings together
};

// [describe]
/** \brief Fast Point Feature Histograms (Rusu 2009) of the keypoints.
 * \param[in] spacing of the cloud's points, meters: lengths are multiples of it */
inline Features::Ptr
describe(const View& view, float spacing)
{
  const auto thinned = pcl::make_shared<Cloud>();
  pcl::VoxelGrid<pcl::PointXYZ> grid;
  grid.setInputCloud(view.cloud);
  grid.setLeafSize(4.0f * spacing, 4.0f * spacing, 4.0f * spacing);
  grid.filter(*thinned);

  const auto normals = pcl::make_shared<pcl::PointCloud<pcl::Normal>>();
  pcl::NormalEstimationSweep<pcl::PointXYZ, pcl::Normal> normal_estimation;
  normal_estimation.setInputCloud(thinned);
  normal_estimation.setSearchSurface(view.cloud);
  normal_estimation.setRadiusSearch(6.0 * spacing);
  normal_estimation.compute(*normals);

  const auto features = pcl::make_shared<Features>();
  pcl::FPFHEstimationOMP<pcl::PointXYZ, pcl::Normal, pcl::FPFHSignature33> estimation;
  estimation.setInputCloud(view.keypoints);
  estimation.setSearchSurface(thinned);
  estimation.setInputNormals(normals);
  estimation.setSearchMethod(pcl::make_shared<pcl::search::KdTree<pcl::PointXYZ>>());
  estimation.setRadiusSearch(25.0 * spacing);
  estimation.compute(*features);
  return features;
}
// [describe]

// [align]
/** \brief Keypoints with similar surroundings, and the pose that most of them agree on.
 * \param[in] spacing of the clouds' points, meters: lengths are multiples of it */
inline Alignment
align(const View& from, const View& to, float spacing)
{
  const auto matches = pcl::make_shared<pcl::Correspondences>();
  pcl::registration::CorrespondenceEstimation<pcl::FPFHSignature33,
                                              pcl::FPFHSignature33>
      estimation;
  estimation.setInputSource(describe(from, spacing));
  estimation.setInputTarget(describe(to, spacing));
  estimation.determineReciprocalCorrespondences(*matches);

  pcl::registration::CorrespondenceRejectorSampleConsensus<pcl::PointXYZ> rejection;
  rejection.setInputSource(from.keypoints);
  rejection.setInputTarget(to.keypoints);
  rejection.setInlierThreshold(6.0 * spacing);
  rejection.setMaximumIterations(20000);
  rejection.setRefineModel(true);
  rejection.setInputCorrespondences(matches);
  pcl::Correspondences agreeing;
  rejection.getCorrespondences(agreeing);
  return {rejection.getBestTransformation(), matches->size(), agreeing.size()};
}
// [align]
