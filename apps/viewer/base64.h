// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Bytes as text.

#pragma once

#include <cstddef>
#include <string>

namespace pcl::app {

/** \brief The bytes in base64, with padding, in one line. */
std::string toBase64(const void* bytes, std::size_t size);

} // namespace pcl::app
