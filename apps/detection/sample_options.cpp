// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parses -name, -field, -value and -classes.

#include "detection/sample_options.h"

#include "io/errors.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl::app {
namespace {

bool
isName(const std::string& text)
{
  return !text.empty() && std::all_of(text.begin(), text.end(), [](unsigned char c) {
    return std::isalnum(c) != 0 || c == '_' || c == '-';
  });
}

/** -classes NAME=VALUE[:PRIOR],... of -field. */
std::vector<SampleOptions>
classesOf(const Arguments& arguments)
{
  const std::string text = arguments.text("classes");
  const auto fail = [&](const std::string& part) {
    throw UsageError(
        "-classes '" + text + "': '" + part +
        "' is not NAME=VALUE[:PRIOR]; expected letters, digits, _ and - for a "
        "name, a whole number of -field for a value, and commas between");
  };
  if (!arguments.has("field"))
    throw UsageError("-classes '" + text +
                     "' without -field; expected a field of the samples");
  std::vector<SampleOptions> classes;
  std::istringstream parts(text);
  for (std::string part; std::getline(parts, part, ',');) {
    const std::size_t equals = std::min(part.find('='), part.size());
    const std::size_t colon = std::min(part.find(':', equals), part.size());
    const std::string name = part.substr(0, equals);
    const std::string number =
        equals < colon ? part.substr(equals + 1, colon - equals - 1) : "";
    const double value = parseNumber(number).value_or(-1.0);
    const double prior =
        colon < part.size() ? parseNumber(part.substr(colon + 1)).value_or(0.0) : 1.0;
    constexpr double most = 4294967295.0;
    if (!isName(name) || value < 0.0 || value > most || value != std::floor(value) ||
        prior <= 0.0)
      fail(part);
    classes.push_back(
        {name, arguments.text("field"), static_cast<std::uint32_t>(value), prior});
  }
  return classes;
}

} // namespace

std::vector<SampleOptions>
sampleOptions(const Arguments& arguments)
{
  for (const char* single : {"name", "value", "prior"})
    arguments.exclude("classes", single);
  if (arguments.has("classes"))
    return classesOf(arguments);
  SampleOptions options;
  options.name = arguments.text("name", options.name);
  if (!isName(options.name))
    throw UsageError("-name '" + options.name + "': expected letters, digits, _ and -");
  if (arguments.has("field") != arguments.has("value"))
    throw UsageError("-field '" + arguments.text("field") + "' and -value '" +
                     arguments.text("value") + "': expected both or neither");
  options.field = arguments.text("field");
  options.value = static_cast<std::uint32_t>(
      arguments.integer("value", 0, std::numeric_limits<std::uint32_t>::max())
          .value_or(0));
  return {options};
}

} // namespace pcl::app
