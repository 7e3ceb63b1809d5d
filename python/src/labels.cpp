// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// labels(): labels for training others, with a confidence.

#include "detection.h"
#include "interruptible.h"
#include "parts.h"

#include <pcl/segmentation/shape_labeling.h>
#include <pcl/segmentation/impl/shape_labeling.hpp>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

struct Labels {
  pcl::PointLabels of_points;
  std::vector<std::string> classes;
};

Labels
labeled(const KnownCloud& known, double confidence, unsigned threads)
{
  pcl::ShapeLabeling<pcl::PointXYZ> labeling;
  labeling.setInputCloud(known.cloud.points);
  labeling.setShapeField(known.field);
  labeling.setConfidence(confidence);
  labeling.setNumberOfThreads(threads);
  Labels result;
  result.classes = labeling.getClasses();
  labeling.label(result.of_points);
  return result;
}

py::tuple
labels(const py::object& points,
       double confidence,
       double resolution,
       const std::optional<ShapeModel>& surface_model,
       unsigned threads)
{
  FieldSettings settings;
  settings.resolution = resolution;
  settings.surface_model = surface_model;
  settings.threads = threads;
  const Subject subject(points, settings);
  refuse(detail::problemOfLabels(detail::labelNames(subject.classes()), confidence));
  Labels result = interruptibly([subject, confidence, threads] {
    return labeled(subject.known(), confidence, threads);
  });
  return py::make_tuple(arrayOf(std::move(result.of_points.labels)),
                        arrayOf(std::move(result.of_points.confidence)),
                        result.classes);
}

constexpr const char* labels_text =
    R"(Label the points of a cloud to train others with.

points: a ShapeField, or float32 or float64 (n, 3), meters.
confidence: points of less are void, 0 to 1.
resolution, surface_model: as of detect(); not used with a ShapeField.
threads: 0 for all cores.

Returns (labels, confidence, classes): uint32 (n,), 0 void, else 1 + the position in
classes; float32 (n,), 0 to 1, 0 unknown; the names of the labels from 1 on. Raises
ValueError with the library's message.)";

} // namespace

void
bindLabels(py::module_& module)
{
  module.def("labels",
             &labels,
             py::arg("points"),
             py::kw_only(),
             py::arg("confidence") =
                 double{pcl::ShapeLabeling<pcl::PointXYZ>::default_confidence},
             py::arg("resolution") = 0.0,
             py::arg("surface_model") = py::none(),
             py::arg("threads") = 0,
             labels_text);
}

} // namespace pcl::python
