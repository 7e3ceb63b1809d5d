// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Keeps the values of a report as JSON and writes them for people and machines.

#include "cli/report.h"

#include <nlohmann/json.hpp>

#include <iomanip>
#include <sstream>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

Json
header(const std::string& app)
{
  return {{"app", app}, {"version", PCL_SHAPE_VERSION}};
}

} // namespace

Report::Report() : sections_(std::make_unique<Json>(Json::object())) {}

Report::~Report() = default;

Report::Report(Report&& other) noexcept = default;

Report& Report::operator=(Report&& other) noexcept = default;

void
Report::setJson(const std::string& section, const std::string& name, const Json& value)
{
  (*sections_)[section][name] = value;
}

void
Report::setText(const std::string& section,
                const std::string& name,
                const std::string& value)
{
  setJson(section, name, value);
}

void
Report::setNumber(const std::string& section, const std::string& name, double value)
{
  setJson(section, name, value);
}

void
Report::setCount(const std::string& section,
                 const std::string& name,
                 std::uint64_t value)
{
  setJson(section, name, value);
}

void
Report::setFlag(const std::string& section, const std::string& name, bool value)
{
  setJson(section, name, value);
}

bool
Report::hasFlag(const std::string& section, const std::string& name) const
{
  return sections_->value(section, Json::object()).value(name, false);
}

std::uint64_t
Report::count(const std::string& section, const std::string& name) const
{
  return sections_->at(section).at(name).get<std::uint64_t>();
}

double
Report::number(const std::string& section, const std::string& name) const
{
  return sections_->at(section).at(name).get<double>();
}

std::string
Report::text(const std::string& section, const std::string& name) const
{
  return sections_->at(section).at(name).get<std::string>();
}

std::string
Report::summary() const
{
  std::ostringstream line;
  line << count("", "points") << " points, " << count("", "finite_points") << " finite";
  const Json counts = sections_->value("counts", Json::object());
  for (const auto& [name, value] : counts.items())
    line << ", " << value.get<std::uint64_t>() << ' ' << name;
  if (sections_->at("").contains(largest_radius))
    line << ", curved up to a radius of " << std::setprecision(2)
         << number("", largest_radius);
  double total = 0.0;
  for (const Json& time : sections_->value("times_ms", Json::object()))
    total += time.get<double>();
  line << std::fixed << std::setprecision(0) << ", " << total << " ms";
  return line.str();
}

nlohmann::ordered_json
Report::toJson() const
{
  Json json = Json::object();
  for (const auto& [section, values] : sections_->items()) {
    Json* target = &json;
    std::istringstream names(section);
    for (std::string name; std::getline(names, name, '/');)
      target = &(*target)[name];
    for (const auto& [name, value] : values.items())
      (*target)[name] = value;
  }
  return json;
}

std::string
dumpJson(const Json& json, int indent)
{
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

std::string
toJson(const std::string& app, const Report& report)
{
  Json json = header(app);
  json.update(report.toJson());
  return dumpJson(json);
}

std::string
toJson(const std::string& app,
       const std::vector<Report>& reports,
       const std::vector<Failure>& failures)
{
  Json json = header(app);
  json["files"] = Json::array();
  for (const Report& report : reports)
    json["files"].push_back(report.toJson());
  json["failures"] = Json::array();
  for (const Failure& failure : failures)
    json["failures"].push_back({{"input", failure.input}, {"error", failure.error}});
  return dumpJson(json);
}

nlohmann::ordered_json
vectorToJson(const float* v)
{
  return {v[0], v[1], v[2]};
}

} // namespace pcl::app
