// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <string>

namespace pcl::app {

/** \brief All bytes of a regular file. \param[in] allowed what the file should be, for
 * messages, such as "a PCD file" \throws InputError that names the path */
std::string readFile(const std::string& path, const std::string& allowed);

} // namespace pcl::app
