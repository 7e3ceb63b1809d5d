// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "cli/report.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <sstream>
#include <stdexcept>

namespace pcl::app {
namespace {

using Json = nlohmann::ordered_json;

std::string
dump(const Json& json)
{
  constexpr int indent = 2;
  return json.dump(indent, ' ', false, Json::error_handler_t::replace) + '\n';
}

Json
header(const std::string& app)
{
  return {{"app", app}, {"version", PCL_SHAPE_VERSION}};
}

/** The object of a section: "a/b" is b in a. */
Json&
objectOf(Json& json, const std::string& section)
{
  Json* object = &json;
  std::istringstream names(section);
  for (std::string name; std::getline(names, name, '/');)
    object = &(*object)[name];
  return *object;
}

Json
toJson(const Report::Json& value)
{
  return Json::parse(value.text);
}

template <typename Value>
Json
toJson(const Value& value)
{
  return value;
}

void
add(Json& json, const Report& report)
{
  for (const Report::Section& section : report.sections()) {
    Json& target = objectOf(json, section.name);
    for (const auto& [name, value] : section.entries)
      std::visit([&, key = name](const auto& v) { target[key] = toJson(v); }, value);
  }
}

} // namespace

void
Report::set(const std::string& section, const std::string& name, Value value)
{
  auto place = std::find_if(sections_.begin(), sections_.end(), [&](const Section& s) {
    return s.name == section;
  });
  if (place == sections_.end())
    place = sections_.insert(sections_.end(), {section, {}});
  place->entries.emplace_back(name, std::move(value));
}

void
Report::setText(const std::string& section,
                const std::string& name,
                const std::string& value)
{
  set(section, name, value);
}

void
Report::setNumber(const std::string& section, const std::string& name, double value)
{
  set(section, name, value);
}

void
Report::setCount(const std::string& section,
                 const std::string& name,
                 std::uint64_t value)
{
  set(section, name, value);
}

void
Report::setFlag(const std::string& section, const std::string& name, bool value)
{
  set(section, name, value);
}

void
Report::setJson(const std::string& section,
                const std::string& name,
                const std::string& text)
{
  set(section, name, Json{text});
}

double
Report::totalTime() const
{
  double total = 0.0;
  for (const Section& section : sections_)
    if (section.name == "times_ms")
      for (const auto& entry : section.entries)
        total += std::get<double>(entry.second);
  return total;
}

const Report::Value&
Report::get(const std::string& section, const std::string& name) const
{
  for (const Section& candidate : sections_)
    if (candidate.name == section)
      for (const auto& entry : candidate.entries)
        if (entry.first == name)
          return entry.second;
  throw std::out_of_range("the report has no '" + section + '/' + name + "'");
}

std::uint64_t
Report::count(const std::string& section, const std::string& name) const
{
  return std::get<std::uint64_t>(get(section, name));
}

double
Report::number(const std::string& section, const std::string& name) const
{
  return std::get<double>(get(section, name));
}

std::string
Report::text(const std::string& section, const std::string& name) const
{
  return std::get<std::string>(get(section, name));
}

std::string
toJson(const std::string& app, const Report& report)
{
  Json json = header(app);
  add(json, report);
  return dump(json);
}

std::string
toJson(const std::string& app,
       const std::vector<Report>& reports,
       const std::vector<Failure>& failures)
{
  Json json = header(app);
  json["files"] = Json::array();
  for (const Report& report : reports)
    add(json["files"].emplace_back(Json::object()), report);
  json["failures"] = Json::array();
  for (const Failure& failure : failures)
    json["failures"].push_back({{"input", failure.input}, {"error", failure.error}});
  return dump(json);
}

} // namespace pcl::app
