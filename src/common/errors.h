// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <pcl/exceptions.h>

#include <sstream>
#include <string>

namespace pcl {

/** \brief All arguments as they would be printed. */
template <typename... Parts>
std::string
textOf(const Parts&... parts)
{
  std::ostringstream stream;
  (stream << ... << parts);
  return stream.str();
}

/** \brief Throws a PCL exception whose text is for the user: what is wrong, and what is
 * allowed, without the place in the code. */
template <typename Exception>
[[noreturn]] void
raise(const std::string& message)
{
  throw Exception(message);
}

/** \brief The text of raise(): PCL puts ": " before it. */
inline std::string
messageOf(const PCLException& exception)
{
  const std::string text = exception.what();
  return text.rfind(": ", 0) == 0 ? text.substr(2) : text;
}

} // namespace pcl
