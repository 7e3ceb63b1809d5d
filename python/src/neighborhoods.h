// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// How wide the neighborhoods of normals and INAD are, as Python says it.

#pragma once

#include "arrays.h"

#include <pcl/features/inad.h>
#include <pcl/features/shape_model.h>

#include <optional>
#include <string>

namespace pcl::python {

/** \brief Parameters from keyword arguments. \param[in] normal_radius none for the
 * radius \throws std::invalid_argument for an unknown scale */
INADParameters parametersOf(double radius,
                            const std::optional<double>& normal_radius,
                            int k,
                            double outlier_rate,
                            const std::string& scale);

/** \brief The name of a scale: "fixed", "depth" or "density". */
std::string nameOf(AdaptiveRadius::RadiusMode scale);

using NormalCloud = pcl::PointCloud<pcl::Normal>;

/** \brief Without Python's lock. \throws std::invalid_argument */
NormalCloud::Ptr estimatedNormals(const Cloud& cloud,
                                  const INADParameters& parameters,
                                  const Eigen::Vector3f& view_point,
                                  unsigned threads);

/** \brief Without Python's lock. \param[in] normals of the cloud's points; null to
 * estimate them \throws std::invalid_argument */
pcl::PointCloud<pcl::INAD>::Ptr estimatedINAD(const Cloud& cloud,
                                              const NormalCloud::ConstPtr& normals,
                                              const INADParameters& parameters,
                                              unsigned threads);

} // namespace pcl::python
