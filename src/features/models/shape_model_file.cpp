// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Shape models as JSON files.

#include <pcl/exceptions.h>
#include <pcl/features/shape_model.h>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <limits>
#include <string>
#include <type_traits>
#include <unistd.h>
#include <utility>
#include <vector>

namespace pcl {
namespace {

using Json = nlohmann::ordered_json; // members stay in the order of the file

constexpr const char* format_name = "pcl_shape model";
constexpr int format_version = 1;
constexpr const char* scale_names[] = {"fixed", "depth", "density"}; // by RadiusMode

/** The start of a value, for messages. */
std::string
excerptOf(const Json& value)
{
  return value.dump().substr(0, 40);
}

/** An object of the file. Says which member is missing or wrong. */
class Object {
public:
  /** \param[in] name what the object is called in messages
   * \param[in] keys of its members: these and no others
   * \throws BadArgumentException if it has not these, or others */
  Object(const Json& json, std::string name, const std::vector<std::string>& keys)
  : json_(json)
  , name_(std::move(name))
  {
    if (!json.is_object())
      fail("must be an object");
    for (const std::string& key : keys)
      if (!json.contains(key))
        fail("has no '" + key + "'");
    for (const auto& item : json.items())
      if (std::find(keys.begin(), keys.end(), item.key()) == keys.end())
        fail("has an unknown member '" + item.key() + "'");
  }

  const Json&
  operator[](const char* key) const
  {
    return json_[key];
  }

  template <typename T>
  T
  get(const char* key) const
  {
    const Json& value = json_[key];
    if constexpr (std::is_same_v<T, double>)
      check(key, value.is_number(), "a number");
    else if constexpr (std::is_same_v<T, std::uint64_t>)
      check(key, value.is_number_unsigned(), "a whole number, not negative");
    else
      check(key, value.is_string(), "a string");
    return value.get<T>();
  }

  void
  check(const char* key, bool is_right, const char* expected) const
  {
    if (!is_right)
      fail(std::string("'") + key + "' is " + excerptOf(json_[key]) + ": it must be " +
           expected);
  }

  [[noreturn]] void
  fail(const std::string& problem) const
  {
    throw BadArgumentException(name_ + " " + problem);
  }

private:
  const Json& json_;
  std::string name_;
};

ShapeModel
withParametersOf(const Json& json)
{
  std::vector<std::string> keys{"normal_radius", "radius", "k", "outlier_rate"};
  const bool has_scale = json.is_object() && json.contains("scale");
  if (has_scale)
    keys.insert(keys.end(),
                {"scale", "normal_radius_noise", "radius_noise", "smoothing"});
  const Object object(json, "'parameters'", keys);
  const std::uint64_t k = object.get<std::uint64_t>("k");
  object.check("k", k <= std::numeric_limits<int>::max(), "at most 2^31 - 1");
  INADParameters parameters;
  parameters.normal_radius = object.get<double>("normal_radius");
  parameters.radius = object.get<double>("radius");
  parameters.k = static_cast<int>(k);
  parameters.outlier_rate = object.get<double>("outlier_rate");
  if (!has_scale)
    return ShapeModel(parameters);
  const auto scale = std::find(
      std::begin(scale_names), std::end(scale_names), object.get<std::string>("scale"));
  object.check(
      "scale", scale != std::end(scale_names), "one of fixed, depth and density");
  parameters.radius_mode =
      static_cast<AdaptiveRadius::RadiusMode>(scale - std::begin(scale_names));
  parameters.normal_radius_noise = object.get<double>("normal_radius_noise");
  parameters.radius_noise = object.get<double>("radius_noise");
  ShapeModel model(parameters);
  model.setSmoothing(object.get<double>("smoothing"));
  return model;
}

void
addClass(const Json& json, ShapeHistogram histogram, ShapeModel& model)
{
  const Object object(json, "a class", {"name", "prior", "counts"});
  const std::string name = object.get<std::string>("name");
  for (const ShapeModel::Class& known : model.classes())
    if (known.name == name)
      object.fail("'" + name + "' occurs twice");
  const auto fail = [&](const std::string& problem) {
    throw BadArgumentException("'counts' of class '" + name + "' " + problem);
  };
  const Json& rows = object["counts"];
  object.check("counts", rows.is_array(), "an array");
  if (rows.size() != histogram.muBins())
    fail("must have " + std::to_string(histogram.muBins()) +
         " rows, as 'bins' says, not " + std::to_string(rows.size()));
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Json& row = rows[i];
    if (!row.is_array() || row.size() != histogram.sigmaBins())
      fail("must have " + std::to_string(histogram.sigmaBins()) +
           " counts in each row, as 'bins' says; row " + std::to_string(i) +
           " has not");
    for (std::size_t j = 0; j < row.size(); ++j) {
      if (!row[j].is_number_unsigned())
        fail("has the count " + excerptOf(row[j]) + " in bin (" + std::to_string(i) +
             ", " + std::to_string(j) +
             "): counts must be whole numbers, not negative");
      histogram.add(i, j, row[j].get<std::uint64_t>());
    }
  }
  model.add(name, histogram, object.get<double>("prior"));
}

ShapeModel
fromJson(const Json& json)
{
  if (!json.is_object() || !json.contains("format") || json["format"] != format_name)
    throw BadArgumentException(std::string("it is not a shape model: \"format\": \"") +
                               format_name + "\" is missing");
  const bool has_version = json.contains("version");
  if (!has_version || json["version"] != format_version)
    throw BadArgumentException(
        "its version is " + (has_version ? excerptOf(json["version"]) : "missing") +
        ": only version " + std::to_string(format_version) +
        " can be read; make the model again with pcl_shape_histogram");
  const Object object(json,
                      "the model",
                      {"format", "version", "parameters", "bins", "floor", "classes"});
  ShapeModel model = withParametersOf(object["parameters"]);
  model.setFloor(object.get<double>("floor"));
  const Object bins(
      object["bins"], "'bins'", {"mu", "sigma", "mu_range", "sigma_range"});
  const ShapeHistogram empty(bins.get<std::uint64_t>("mu"),
                             bins.get<std::uint64_t>("sigma"),
                             bins.get<double>("mu_range"),
                             bins.get<double>("sigma_range"));
  object.check("classes", object["classes"].is_array(), "an array");
  for (const Json& c : object["classes"])
    addClass(c, empty, model);
  if (model.classes().empty())
    object.fail("has no class: at least one is needed");
  return model;
}

Json
toJson(const ShapeModel& model)
{
  const INADParameters& p = model.parameters();
  Json parameters = {{"normal_radius", p.normal_radius},
                     {"radius", p.radius},
                     {"k", p.k},
                     {"outlier_rate", p.outlier_rate}};
  if (p.radius_mode != AdaptiveRadius::FIXED || model.smoothing() != 0.0) {
    parameters["scale"] = scale_names[p.radius_mode];
    parameters["normal_radius_noise"] = p.normal_radius_noise;
    parameters["radius_noise"] = p.radius_noise;
    parameters["smoothing"] = model.smoothing();
  }
  Json classes = Json::array();
  const ShapeHistogram& bins = model.classes().front().histogram;
  for (const ShapeModel::Class& c : model.classes()) {
    Json rows = Json::array();
    for (std::size_t i = 0; i < bins.muBins(); ++i) {
      Json& row = rows.emplace_back(Json::array());
      for (std::size_t j = 0; j < bins.sigmaBins(); ++j)
        row.push_back(c.histogram.count(i, j));
    }
    classes.push_back({{"name", c.name}, {"prior", c.prior}, {"counts", rows}});
  }
  return {{"format", format_name},
          {"version", format_version},
          {"parameters", parameters},
          {"bins",
           {{"mu", bins.muBins()},
            {"sigma", bins.sigmaBins()},
            {"mu_range", bins.muRange()},
            {"sigma_range", bins.sigmaRange()}}},
          {"floor", model.floor()},
          {"classes", classes}};
}

/** Write to a file beside the target, then rename it. */
void
writeWhole(const std::string& file_name, const std::string& text)
{
  const std::string part = file_name + ".part" + std::to_string(::getpid());
  const auto fail = [&] {
    const std::string reason = std::strerror(errno);
    std::remove(part.c_str());
    throw IOException(file_name + ": cannot be written: " + reason);
  };
  std::ofstream stream(part, std::ios::binary);
  stream << text;
  stream.close();
  if (!stream || std::rename(part.c_str(), file_name.c_str()) != 0)
    fail();
}

} // namespace

ShapeModel
ShapeModel::load(const std::string& file_name)
{
  if (std::filesystem::is_directory(file_name))
    throw IOException(file_name + ": is a directory, not a model file");
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream)
    throw IOException(file_name + ": cannot be read: " + std::strerror(errno));
  return parse({std::istreambuf_iterator<char>(stream), {}}, file_name);
}

ShapeModel
ShapeModel::parse(const std::string& text, const std::string& file_name)
{
  try {
    return fromJson(Json::parse(text));
  }
  catch (const Json::exception& e) {
    throw IOException(file_name + ": is not a complete JSON file: " + e.what());
  }
  catch (const BadArgumentException& e) {
    // PCL puts ": " before the text of an exception.
    throw IOException(file_name + ": is not a usable model" + e.what());
  }
}

void
ShapeModel::save(const std::string& file_name) const
{
  if (classes_.empty())
    throw BadArgumentException("a model without a class cannot be saved: add() one");
  writeWhole(file_name, toJson(*this).dump(1) + "\n");
}

} // namespace pcl
