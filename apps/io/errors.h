// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The two kinds of errors: of the command line, and of files.

#pragma once

#include <stdexcept>
#include <string>

namespace pcl::app {

/** \brief The command line is wrong: exit 2. */
class UsageError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief A file is wrong, or cannot be read or written: exit 1. */
class InputError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/** \brief \throws InputError "PATH: WHAT; expected EXPECTED" */
[[noreturn]] inline void
fail(const std::string& path, const std::string& what, const std::string& expected)
{
  throw InputError(path + ": " + what + "; expected " + expected);
}

} // namespace pcl::app
