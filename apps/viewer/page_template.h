// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The page of -html without a cloud, made when this application was built.

#pragma once

#include <string_view>

namespace pcl::app {

/** \brief What stands before and after the cloud. */
struct PageTemplate {
  std::string_view before;
  std::string_view after;
};

/** \brief The page, or nullptr if this application was built without npm. */
const PageTemplate* pageTemplate();

} // namespace pcl::app
