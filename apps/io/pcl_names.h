// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The names that PCL gives to fields which other programs call otherwise.

#pragma once

#include "io/cloud_file.h"

namespace pcl::app {

/** \brief Coordinates, normals, colors and intensity in capitals get PCL's names,
 * unless a field has the name already. */
void usePclNames(CloudFile& cloud);

/** \brief The same for the properties of PLY: nx ny nz are normal_x normal_y normal_z;
 * red green blue (or diffuse_red and so on), bytes, become the one field rgb, with
 * alpha rgba, as pcl::PLYReader makes them. */
void usePclNamesOfPly(CloudFile& cloud);

} // namespace pcl::app
