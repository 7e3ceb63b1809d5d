// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/errors.h"

#include <pcl/features/shape_model.h>

#include <nlohmann/json.hpp>

#include <cerrno>
#include <cstdint>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <fstream>
#include <initializer_list>
#include <iterator>
#include <string>
#include <unistd.h>
#include <utility>

namespace pcl::detail {

using Json = nlohmann::ordered_json; ///< members stay in the order of the file

/** \brief Reads values out of a JSON object, and says where one is missing or wrong. */
class JsonReader {
public:
  /** \param[in] where what the object is called in messages
   * \param[in] members all that it must have
   * \throws BadArgumentException if it has not these, or others */
  JsonReader(const Json& object,
             std::string where,
             std::initializer_list<const char*> members);

  double number(const char* name) const;

  std::uint64_t count(const char* name) const;

  std::string text(const char* name) const;

  const Json& array(const char* name) const;

  const Json&
  member(const char* name) const
  {
    return object_[name];
  }

  /** \throws BadArgumentException that names the object */
  [[noreturn]] void fail(const std::string& problem) const;

private:
  void checkKnown(const std::string& name,
                  std::initializer_list<const char*> members) const;

  template <typename T>
  T value(const char* name, bool is_right, const char* allowed) const;

  const Json& object_;
  std::string where_;
};

// What both directions have to agree on.
constexpr const char* format_name = "pcl_shape model";
constexpr int format_version = 1;
constexpr const char* scale_names[] = {"fixed", "depth", "density"};

/** \brief The content of a model file. \param[in] model with a class at least */
Json toJson(const ShapeModel& model);

/** \brief The model in the content of a model file.
 * \throws BadArgumentException that says what is wrong, and what is allowed */
ShapeModel modelFrom(const Json& json);

template <typename T>
T
JsonReader::value(const char* name, bool is_right, const char* allowed) const
{
  if (!is_right) {
    fail(std::string("'") + name + "' is " + object_[name].dump().substr(0, 40) +
         ": it must be " + allowed);
  }
  return object_[name].get<T>();
}

JsonReader::JsonReader(const Json& object,
                       std::string where,
                       std::initializer_list<const char*> members)
: object_(object)
, where_(std::move(where))
{
  if (!object.is_object())
    fail("must be an object");
  for (const char* member : members)
    if (!object.contains(member))
      fail(std::string("has no '") + member + "'");
  if (object.size() != members.size())
    for (const auto& item : object.items())
      checkKnown(item.key(), members);
}

double
JsonReader::number(const char* name) const
{
  return value<double>(name, object_[name].is_number(), "a number");
}

std::uint64_t
JsonReader::count(const char* name) const
{
  return value<std::uint64_t>(
      name, object_[name].is_number_unsigned(), "a whole number, not negative");
}

std::string
JsonReader::text(const char* name) const
{
  return value<std::string>(name, object_[name].is_string(), "a string");
}

const Json&
JsonReader::array(const char* name) const
{
  if (!object_[name].is_array())
    fail(std::string("'") + name + "' must be an array");
  return object_[name];
}

void
JsonReader::fail(const std::string& problem) const
{
  raise<BadArgumentException>(textOf(where_, " ", problem));
}

void
JsonReader::checkKnown(const std::string& name,
                       std::initializer_list<const char*> members) const
{
  for (const char* member : members)
    if (name == member)
      return;
  fail("has an unknown member '" + name + "'");
}

} // namespace pcl::detail

namespace pcl {
namespace {

/** \brief Write to a file beside the target, then rename it. */
void
writeWhole(const std::string& file_name, const std::string& text)
{
  const std::string part = file_name + ".part" + std::to_string(::getpid());
  const auto fail = [&] {
    const std::string reason = std::strerror(errno);
    std::remove(part.c_str());
    raise<IOException>(textOf(file_name, ": cannot be written: ", reason));
  };
  {
    std::ofstream stream(part, std::ios::binary);
    stream << text;
    stream.close();
    if (!stream)
      fail();
  }
  if (std::rename(part.c_str(), file_name.c_str()) != 0)
    fail();
}

} // namespace

ShapeModel
ShapeModel::load(const std::string& file_name)
{
  if (std::filesystem::is_directory(file_name))
    raise<IOException>(textOf(file_name, ": is a directory, not a model file"));
  std::ifstream stream(file_name, std::ios::binary);
  if (!stream)
    raise<IOException>(textOf(file_name, ": cannot be read: ", std::strerror(errno)));
  const std::string text{std::istreambuf_iterator<char>(stream), {}};
  return parse(text, file_name);
}

ShapeModel
ShapeModel::parse(const std::string& text, const std::string& file_name)
{
  try {
    return detail::modelFrom(detail::Json::parse(text));
  }
  catch (const detail::Json::exception& e) {
    raise<IOException>(textOf(file_name, ": is not a complete JSON file: ", e.what()));
  }
  catch (const BadArgumentException& e) {
    raise<IOException>(textOf(file_name, ": is not a usable model: ", messageOf(e)));
  }
}

void
ShapeModel::save(const std::string& file_name) const
{
  if (classes_.empty()) {
    raise<BadArgumentException>(
        textOf("a model without a class cannot be saved: add() one"));
  }
  writeWhole(file_name, detail::toJson(*this).dump(1) + "\n");
}

} // namespace pcl

namespace pcl::detail {
namespace {

AdaptiveRadius::RadiusMode
scaleFrom(const JsonReader& reader)
{
  const std::string name = reader.text("scale");
  for (const auto mode :
       {AdaptiveRadius::FIXED, AdaptiveRadius::DEPTH, AdaptiveRadius::DENSITY})
    if (name == scale_names[mode])
      return mode;
  reader.fail("'scale' is \"" + name + "\": it must be fixed, depth or density");
}

/** \brief The parameters; the model's smoothing is among them in the file, since mostly
 * models of another scale than metres have it. */
INADParameters
parametersFrom(const Json& json, double& smoothing)
{
  const bool has_scale = json.is_object() && json.contains("scale");
  const JsonReader reader =
      has_scale ? JsonReader(json,
                             "'parameters'",
                             {"normal_radius",
                              "radius",
                              "k",
                              "outlier_rate",
                              "scale",
                              "normal_radius_noise",
                              "radius_noise",
                              "smoothing"})
                : JsonReader(json,
                             "'parameters'",
                             {"normal_radius", "radius", "k", "outlier_rate"});
  const std::uint64_t k = reader.count("k");
  if (k > 0x7fffffff)
    reader.fail("'k' is " + std::to_string(k) + ": at most 2^31 - 1 is allowed");
  INADParameters parameters;
  parameters.normal_radius = reader.number("normal_radius");
  parameters.radius = reader.number("radius");
  parameters.k = static_cast<int>(k);
  parameters.outlier_rate = reader.number("outlier_rate");
  if (has_scale) {
    parameters.radius_mode = scaleFrom(reader);
    parameters.normal_radius_noise = reader.number("normal_radius_noise");
    parameters.radius_noise = reader.number("radius_noise");
    smoothing = reader.number("smoothing");
  }
  return parameters;
}

ShapeHistogram
emptyHistogramFrom(const Json& json)
{
  const JsonReader reader(json, "'bins'", {"mu", "sigma", "mu_range", "sigma_range"});
  return ShapeHistogram(reader.count("mu"),
                        reader.count("sigma"),
                        reader.number("mu_range"),
                        reader.number("sigma_range"));
}

void
readRow(const Json& row,
        std::size_t i,
        const std::string& where,
        ShapeHistogram& histogram)
{
  const auto fail = [&](const std::string& problem) {
    raise<BadArgumentException>(textOf(where, " ", problem));
  };
  if (!row.is_array() || row.size() != histogram.sigmaBins()) {
    fail("must have " + std::to_string(histogram.sigmaBins()) +
         " counts in each row, as 'bins' says; row " + std::to_string(i) + " has not");
  }
  for (std::size_t j = 0; j < row.size(); ++j) {
    if (!row[j].is_number_unsigned()) {
      fail("has the count " + row[j].dump().substr(0, 40) + " in bin (" +
           std::to_string(i) + ", " + std::to_string(j) +
           "): counts must be whole numbers, not negative");
    }
    histogram.add(i, j, row[j].get<std::uint64_t>());
  }
}

void
addClass(const Json& json, const ShapeHistogram& empty, ShapeModel& model)
{
  const JsonReader reader(json, "a class", {"name", "prior", "counts"});
  const std::string name = reader.text("name");
  for (const ShapeModel::Class& known : model.classes())
    if (known.name == name)
      reader.fail("'" + name + "' occurs twice");
  const Json& rows = reader.array("counts");
  const std::string where = "'counts' of class '" + name + "'";
  if (rows.size() != empty.muBins()) {
    raise<BadArgumentException>(textOf(where,
                                       " must have ",
                                       empty.muBins(),
                                       " rows, as 'bins' says, not ",
                                       rows.size()));
  }
  ShapeHistogram histogram = empty;
  for (std::size_t i = 0; i < rows.size(); ++i)
    readRow(rows[i], i, where, histogram);
  model.add(name, histogram, reader.number("prior"));
}

} // namespace

ShapeModel
modelFrom(const Json& json)
{
  if (!json.is_object() || !json.contains("format") || json["format"] != format_name) {
    raise<BadArgumentException>(textOf(
        R"(it is not a shape model: "format": ")", format_name, R"(" is missing)"));
  }
  if (!json.contains("version") || json["version"] != format_version) {
    raise<BadArgumentException>(textOf(
        "its version is ",
        (json.contains("version") ? json["version"].dump().substr(0, 40) : "missing"),
        ": only version ",
        format_version,
        " can be read; make the model again with pcl_shape_histogram"));
  }
  const JsonReader reader(
      json,
      "the model",
      {"format", "version", "parameters", "bins", "floor", "classes"});
  double smoothing = 0.0;
  ShapeModel model(parametersFrom(reader.member("parameters"), smoothing));
  model.setSmoothing(smoothing);
  model.setFloor(reader.number("floor"));
  const ShapeHistogram empty = emptyHistogramFrom(reader.member("bins"));
  for (const Json& c : reader.array("classes"))
    addClass(c, empty, model);
  if (model.classes().empty())
    reader.fail("has no class: at least one is needed");
  return model;
}

namespace {

Json
toJson(const ShapeModel::Class& c)
{
  const ShapeHistogram& histogram = c.histogram;
  Json rows = Json::array();
  for (std::size_t i = 0; i < histogram.muBins(); ++i) {
    Json row = Json::array();
    for (std::size_t j = 0; j < histogram.sigmaBins(); ++j)
      row.push_back(histogram.count(i, j));
    rows.push_back(row);
  }
  return {{"name", c.name}, {"prior", c.prior}, {"counts", rows}};
}

} // namespace

Json
toJson(const ShapeModel& model)
{
  const INADParameters& p = model.parameters();
  const ShapeHistogram& bins = model.classes().front().histogram;
  Json classes = Json::array();
  for (const ShapeModel::Class& c : model.classes())
    classes.push_back(toJson(c));
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

} // namespace pcl::detail
