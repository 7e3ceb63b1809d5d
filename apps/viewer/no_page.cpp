// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// In the place of the page where it could not be made.

#include "viewer/page_template.h"

namespace pcl::app {

const PageTemplate*
pageTemplate()
{
  return nullptr;
}

} // namespace pcl::app
