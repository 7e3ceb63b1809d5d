// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// What is known of a cloud, as Python has it.

#pragma once

#include "arrays.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/shape_edge_detection.h>
#include <pcl/segmentation/shape_field.h>

#include <memory>
#include <optional>
#include <vector>

namespace pcl::python {

/** \brief How a field is computed. */
struct FieldSettings {
  double resolution = 0.0;
  bool one_resolution = false; ///< for all of the cloud
  bool edges_only = false;
  std::optional<ShapeModel> edge_model;
  std::optional<ShapeModel> surface_model;
  pcl::PointCloud<pcl::Normal>::Ptr normals;
  unsigned threads = 0;
};

/** \brief A cloud and its field. */
struct KnownCloud {
  Cloud cloud;
  pcl::ShapeField::ConstPtr field;
};

/** \brief What `detect` gives: all that is known of each point. */
struct Detection : KnownCloud {
  std::vector<std::uint8_t> edges; ///< 0 or 1
  std::vector<EdgeType> types;
  std::vector<std::uint32_t> surface;
  std::vector<float> likelihoods; ///< (n, classes)
};

/** \brief Without Python's lock. \throws std::invalid_argument */
KnownCloud knownCloud(const Cloud& cloud, const FieldSettings& settings);

/** \brief A task's first argument: what `detect` gave, or points that it will be
 * computed for. */
class Subject {
public:
  Subject(const py::object& points, const FieldSettings& settings);

  const Cloud&
  cloud() const
  {
    return detection_ ? detection_->cloud : cloud_;
  }

  /** \brief The names of the classes that its field has, or will have. */
  std::vector<std::string> classes() const;

  /** \brief Without Python's lock. */
  KnownCloud known() const;

private:
  std::shared_ptr<const Detection> detection_;
  Cloud cloud_;
  FieldSettings settings_;
};

} // namespace pcl::python
