// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// One page of HTML that shows a scene in any browser, without a network.

#pragma once

#include "io/cloud_file.h"
#include "viewer/scene.h"

#include <cstddef>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief The fields that a page shows by default: the one that says most, then all
 * other single-valued ones but x, y and normals, and plain. */
std::vector<std::string> fieldsOfPage(const CloudFile& cloud);

/** \brief \throws InputError if this application cannot make pages */
void requirePage();

/** \brief What a page shows. */
struct PageContents {
  const CloudFile& cloud;
  /** \brief Around the origin, where floats are finest. Its views are the fields, the
   * first of which is shown first. */
  const Scene& scene;
  std::vector<std::size_t> points; ///< those of the cloud that are shown, in this order
  Eigen::Vector3f origin; ///< of the scene, in the cloud without its offset, meters
  bool shaded;            ///< at first, if the cloud has normals
};

/** \brief The page. \throws InputError if this application cannot make pages */
std::string drawPage(const PageContents& contents);

} // namespace pcl::app
