// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Replaces the page of -html where npm could not make it.

#include "viewer/page_template.h"

namespace pcl::app {

const PageTemplate*
pageTemplate()
{
  return nullptr;
}

} // namespace pcl::app
