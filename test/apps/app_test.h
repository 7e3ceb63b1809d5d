// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds, files and checks that the tests of apps share.

#pragma once

#include "app_process.h"
#include "support/temporary_directory.h"

#include <gtest/gtest.h>

#include <string>

namespace pcl_shape_test {

void writeFile(const std::string& path, const std::string& contents);

/** \brief The contents. \throws std::runtime_error if it cannot be read */
std::string readFile(const std::string& path);

bool exists(const std::string& path);

/** \brief A directory of its own for each test. */
class AppTest : public ::testing::Test {
protected:
  std::string
  path(const std::string& name) const
  {
    return directory_.file(name);
  }

  /** \brief The path of a new file. */
  std::string file(const std::string& name, const std::string& contents) const;

  /** \brief Names of the files in the test's directory, sorted. */
  std::vector<std::string> files() const;

private:
  pcl::test::TemporaryDirectory directory_;
};

/** \brief The app ended with the status and exactly one line on standard error, in
 * which all the words occur. */
void expectRefused(const Outcome& outcome, int status, const Words& words);

void expectSuccess(const Outcome& outcome);

/** \brief The same, but warnings and notes on standard error are all right. */
void expectSuccessOrWarnings(const Outcome& outcome);

/** \brief A PCD file in text: the header for these fields, all of SIZE 4, and the rows.
 */
std::string asciiCloud(const std::string& fields,
                       const std::string& types,
                       const std::vector<std::string>& rows);

/** \brief Rows "x y z" of a square grid in the plane z = 1 m, points 5 mm apart. */
std::vector<std::string> planeRows(int side);

/** \brief Rows of a plane z = 1 m that folds by 90 degrees along x = 0; 5 mm apart. */
std::vector<std::string> foldRows(int side);

/** \brief Each row with another column. */
std::vector<std::string> withColumn(std::vector<std::string> rows,
                                    const std::string& value);

} // namespace pcl_shape_test
