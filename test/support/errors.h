// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Messages of exceptions and of PCL's console.

#pragma once

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace pcl {
namespace test {

/** \brief What an action writes to standard error. */
template <typename Action>
std::string
errorsOf(const Action& action)
{
  testing::internal::CaptureStderr();
  action();
  return testing::internal::GetCapturedStderr();
}

inline void
expectParts(const std::string& message, const std::vector<std::string>& parts)
{
  for (const std::string& part : parts) {
    EXPECT_NE(std::string::npos, message.find(part))
        << "'" << part << "' is not in: " << message;
  }
}

/** \brief The text of the exception that an action throws. */
template <typename Exception, typename Action>
std::string
exceptionOf(const Action& action)
{
  try {
    action();
  }
  catch (const Exception& exception) {
    return exception.what();
  }
  ADD_FAILURE() << "nothing was thrown";
  return {};
}

} // namespace test
} // namespace pcl
