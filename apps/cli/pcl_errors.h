// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Turns what PCL's classes print when they refuse an input into an InputError.

#pragma once

#include <functional>
#include <string>

namespace pcl::app {

/** \brief Call a class that reports errors by PCL_ERROR.
 * \param[in] path of the cloud, for the message
 * \param[in] call returns whether there is a result
 * \throws InputError "PATH: REASON" if there is none, with what PCL printed last. What
 * it printed besides, such as warnings, goes to standard error when the call ends. Not
 * for calls from several threads: standard error is the process's. */
void withPclErrors(const std::string& path, const std::function<bool()>& call);

} // namespace pcl::app
