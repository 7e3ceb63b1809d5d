// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A whole file as a string.

#pragma once

#include <string>

namespace pcl::app {

/** \brief The path that stands for standard input, or standard output. */
constexpr const char* standard_stream = "-";

/** \brief All bytes of a regular file, of a pipe, or of standard input. \param[in]
 * expected what the file should be, for messages, such as "a PCD file" \throws
 * InputError that names the path */
std::string readFile(const std::string& path, const std::string& expected);

} // namespace pcl::app
