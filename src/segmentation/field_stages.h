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

/** \brief Whether a field goes on from one stage to the next; else it ends there. */
struct Conditions {
  std::function<bool(const MeasuredCloud& cloud)> to_edges =
      [](const MeasuredCloud& /*cloud*/) { return true; };
  std::function<bool(const ShapeField& edges)> to_surfaces =
      [](const ShapeField& /*edges*/) { return true; };
};

/** \brief The points of a cloud among themselves, as a request looks for neighbors. */
class Surroundings {
public:
  Surroundings(const FieldRequest& request, const XYZView& points);

  /** \param[in] points x, y and z of each, other points than the request's surface */
  Surroundings(const FieldRequest& request, const std::vector<float>& points);

  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;

  const Neighborhoods&
  neighborhoods() const
  {
    return neighborhoods_;
  }

private:
  Surroundings(const FieldRequest& request,
               const XYZView& points,
               const NeighborFinder& finder);

  pcl::Indices all_;
  Neighborhoods neighborhoods_;
};

/** \brief The field of a cloud. \param[in] owner of its points */
ShapeField fieldOf(const FieldRequest& request,
                   const shared_ptr<const void>& owner,
                   const Surroundings& surroundings,
                   const Spacings& spacings = {},
                   const Conditions& conditions = {});

} // namespace pcl::detail
