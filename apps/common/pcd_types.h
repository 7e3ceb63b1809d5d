/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

namespace pcl::app {

enum class PCDFormat { ascii, binary, binary_compressed };

/** \brief The name of the fields that only keep others aligned. */
constexpr std::string_view padding_field = "_";

/** \brief The word of the DATA line. */
const char* nameOf(PCDFormat format);

std::optional<PCDFormat> formatOf(std::string_view name);

/** \brief I, U or F. */
char typeLetter(std::uint8_t datatype);

/** \brief The pcl::PCLPointField type of a TYPE and a SIZE, if there is one. */
std::optional<std::uint8_t> datatypeOf(std::string_view type, std::string_view size);

} // namespace pcl::app
