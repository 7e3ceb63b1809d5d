// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <string>
#include <vector>

namespace pcl::app {

/** \brief A value of a JSON file that knows where it is, for messages. All methods
 * throw an InputError that says where, what is there and what is allowed. */
class JsonValue {
public:
  /** \brief The whole file. */
  static JsonValue read(const std::string& path);

  bool has(const std::string& member) const;

  JsonValue at(const std::string& member) const;

  std::vector<JsonValue> array() const;

  std::string text() const;

  bool flag() const;

  /** \brief A finite number. */
  float number() const;

  /** \brief A whole number from 0 to 2^32 - 1. */
  std::uint32_t count() const;

  /** \brief Three finite numbers. */
  std::array<float, 3> vector() const;

  [[noreturn]] void fail(const std::string& allowed) const;

private:
  JsonValue(std::string path, std::string place, nlohmann::json value)
  : path_(std::move(path))
  , place_(std::move(place))
  , value_(std::move(value))
  {}

  std::string path_;
  std::string place_;
  nlohmann::json value_;
};

using Vector = std::array<float, 3>;

/** \brief A crease of pcl_shape_edge_detection -lines. */
struct Line {
  std::vector<Vector> points; ///< metres, at least two
  float spacing;              ///< metres
};

/** \brief An object of pcl_shape_instances -json. */
struct Instance {
  std::uint32_t id; ///< its value in the field instance
  std::string name; ///< its class, and its primitive if it has one
  Vector centroid;  ///< metres
};

/** \brief A grasp of pcl_shape_grasp -json. */
struct Grasp {
  Vector position; ///< metres, on the surface
  Vector approach; ///< unit, into the surface
  bool seals;
};

struct Grasps {
  std::vector<Grasp> grasps; ///< the best first
  float cup_radius;          ///< metres; of the file, or 20 mm
};

/** \brief Read one of these files.
 * \throws InputError that names the file, the member and what is allowed */
std::vector<Line> readLines(const std::string& path);

std::vector<Instance> readInstances(const std::string& path);

Grasps readGrasps(const std::string& path);

} // namespace pcl::app
