/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include "json_reader.h"

#include <pcl/features/shape_model.h>

namespace pcl::detail {

// What both directions have to agree on.
constexpr const char* format_name = "pcl_shape model";
constexpr int format_version = 1;
constexpr const char* scale_names[] = {"fixed", "depth", "density"};

/** \brief The content of a model file. \param[in] model with a class at least */
Json toJson(const ShapeModel& model);

/** \brief The model in the content of a model file.
 * \throws BadArgumentException that says what is wrong, and what is allowed */
ShapeModel modelFrom(const Json& json);

} // namespace pcl::detail
