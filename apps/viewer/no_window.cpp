// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Replaces window.cpp where there is no X11, or PCL has no visualization.

#include "io/errors.h"
#include "viewer/window.h"

namespace pcl::app {

void
requireDisplay()
{
  throw InputError("built without PCL's visualization: to draw, install PCL with it "
                   "and X11 (Debian: libpcl-dev, libx11-dev), configure with "
                   "-DPCL_SHAPE_WITH_VISUALIZATION=ON and build again");
}

std::string
drawPicture(const Scene& /*scene*/)
{
  requireDisplay();
  return {};
}

void
showWindow(const Scene& /*scene*/)
{
  requireDisplay();
}

} // namespace pcl::app
