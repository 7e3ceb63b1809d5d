// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Makes a field stage by stage: what is measured, edges, surfaces.

#pragma once

#include "edges/edge_detection.h"

#include <pcl/segmentation/impl/shape_field_estimation.hpp>

#include <functional>
#include <vector>

namespace pcl::detail {

/** \brief What is known of the spacings before a field is made. */
struct Spacings {
  bool are_even = false; ///< they change slowly: they are taken as they are
  const std::vector<float>* known = nullptr;
};

/** \brief Whether a field goes on to edges: from what was measured of a cloud, and its
 * field with spacings. */
using ToEdges =
    std::function<bool(const MeasuredCloud& cloud, const ShapeField& field)>;

/** \brief Whether a field goes on from one stage to the next; else it ends there. */
struct Conditions {
  ToEdges to_edges = [](const MeasuredCloud&, const ShapeField&) { return true; };
  std::function<bool(const ShapeField& edges)> to_surfaces =
      [](const ShapeField& /*edges*/) { return true; };
};

/** \brief The points of the request's surface among themselves, as it looks for
 * neighbors. */
Neighborhoods neighborhoodsOf(const FieldRequest& request);

/** \brief Likewise other points. \param[in] others x, y and z of each */
Neighborhoods neighborhoodsOf(const FieldRequest& request,
                              const std::vector<float>& others);

/** \brief The field of a cloud. \param[in] owner of its points */
ShapeField fieldOf(const FieldRequest& request,
                   const shared_ptr<const void>& owner,
                   const Neighborhoods& neighborhoods,
                   const Spacings& spacings = {},
                   const Conditions& conditions = {});

} // namespace pcl::detail
