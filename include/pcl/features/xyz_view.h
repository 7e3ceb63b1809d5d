/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstddef>

namespace pcl {

/** \brief Points (or normals) in memory: item i is the three floats at `first + i *
 * stride`. The view does not own them.
 */
struct XYZView {
  const float* first = nullptr; ///< x of the first item
  std::size_t stride = 3;       ///< in floats
  std::size_t size = 0;         ///< how many items there are

  /** \brief x, y and z of an item. \param[in] i below size: not checked */
  const float*
  operator[](std::size_t i) const
  {
    return first + i * stride;
  }
};

} // namespace pcl
