// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Clouds, files and checks that the tests of apps share.

#include "app_test.h"

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

namespace fs = std::filesystem;

namespace pcl_shape_test {
namespace {

constexpr double spacing = 0.005;

std::string
row(double x, double y, double z)
{
  std::ostringstream text;
  text << x << ' ' << y << ' ' << z;
  return text.str();
}

} // namespace

void
writeFile(const std::string& path, const std::string& contents)
{
  std::ofstream stream(path, std::ios::binary);
  stream << contents;
  if (!stream.flush())
    throw std::runtime_error(path + ": cannot be written");
}

std::string
readFile(const std::string& path)
{
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw std::runtime_error(path + ": cannot be read");
  return {std::istreambuf_iterator<char>(stream), {}};
}

bool
exists(const std::string& path)
{
  return fs::exists(path);
}

std::string
AppTest::file(const std::string& name, const std::string& contents) const
{
  writeFile(path(name), contents);
  return path(name);
}

std::vector<std::string>
AppTest::files() const
{
  std::vector<std::string> names;
  for (const auto& entry : fs::directory_iterator(directory_.path()))
    names.push_back(entry.path().filename());
  std::sort(names.begin(), names.end());
  return names;
}

void
expectRefused(const Outcome& outcome, int status, const Words& words)
{
  EXPECT_EQ(outcome.status, status) << outcome.err;
  EXPECT_EQ(std::count(outcome.err.begin(), outcome.err.end(), '\n'), 1) << outcome.err;
  EXPECT_EQ(outcome.out, "");
  for (const std::string& word : words)
    EXPECT_NE(outcome.err.find(word), std::string::npos)
        << "'" << word << "' is not in: " << outcome.err;
}

void
expectSuccess(const Outcome& outcome)
{
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_EQ(outcome.err, "");
  EXPECT_NE(outcome.out, "");
}

void
expectSuccessOrWarnings(const Outcome& outcome)
{
  ASSERT_EQ(outcome.status, 0) << outcome.err;
  EXPECT_NE(outcome.out, "");
  std::istringstream lines(outcome.err);
  for (std::string line; std::getline(lines, line);)
    EXPECT_TRUE(line.find(": warning: ") != std::string::npos ||
                line.find(": note: ") != std::string::npos)
        << line;
}

std::string
asciiCloud(const std::string& fields,
           const std::string& types,
           const std::vector<std::string>& rows)
{
  const auto words = 1 + std::count(fields.begin(), fields.end(), ' ');
  std::string sizes;
  std::string counts;
  for (auto i = words; i > 0; --i) {
    sizes += " 4";
    counts += " 1";
  }
  const std::string points = std::to_string(rows.size());
  std::string text = "VERSION 0.7\nFIELDS " + fields + "\nSIZE" + sizes + "\nTYPE " +
                     types + "\nCOUNT" + counts + "\nWIDTH " + points +
                     "\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS " + points +
                     "\nDATA ascii\n";
  for (const std::string& line : rows)
    text += line + '\n';
  return text;
}

std::vector<std::string>
planeRows(int side)
{
  std::vector<std::string> rows;
  for (int i = 0; i < side; ++i)
    for (int j = 0; j < side; ++j)
      rows.push_back(row(i * spacing, j * spacing, 1.0));
  return rows;
}

std::vector<std::string>
foldRows(int side)
{
  std::vector<std::string> rows;
  for (int i = -side; i < side; ++i)
    for (int j = 0; j < side; ++j)
      rows.push_back(
          row(std::min(i, 0) * spacing, j * spacing, 1.0 + std::max(i, 0) * spacing));
  return rows;
}

std::vector<std::string>
withColumn(std::vector<std::string> rows, const std::string& value)
{
  for (std::string& line : rows)
    line += ' ' + value;
  return rows;
}

} // namespace pcl_shape_test
