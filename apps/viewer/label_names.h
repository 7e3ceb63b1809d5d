// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "io/cloud_file.h"
#include "viewer/color.h"

#include <cstdint>
#include <map>
#include <string>

namespace pcl::app {

/** \brief What a label is called and drawn with. */
struct LabelStyle {
  std::string name;
  Color color;
};

using LabelStyles = std::map<std::int64_t, LabelStyle>;

/** \brief Whether the field holds labels whatever its type is. */
bool isLabelField(const std::string& field);

/** \brief What is known of the labels of this field: those that the applications
 * write, with the names of the model's classes if the cloud has their likelihoods.
 */
LabelStyles stylesOf(const CloudFile& cloud, const std::string& field);

/** \brief The value of -names: "1=flat,2=corrugated".
 * \throws UsageError if it is something else */
std::map<std::int64_t, std::string> parseLabelNames(const std::string& text);

} // namespace pcl::app
