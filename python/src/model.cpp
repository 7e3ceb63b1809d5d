// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// ShapeModel: histograms of surfaces, made of samples, saved and loaded.

#include "interruptible.h"
#include "neighborhoods.h"
#include "parts.h"

#include <pcl/features/shape_model.h>
#include <pcl/segmentation/impl/shape_detection.hpp>

#include <map>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

/** Points of a surface, of which some are counted. */
struct Sample {
  Cloud cloud;
  std::optional<std::vector<std::int32_t>> counted;
};

struct Class {
  std::string name;
  std::vector<Sample> samples;
  std::optional<double> prior;
};

Sample
sampleOf(const py::handle& object)
{
  py::handle points = object;
  py::handle counted;
  if (py::isinstance<py::tuple>(object)) {
    const auto pair = object.cast<py::tuple>();
    if (pair.size() != 2)
      throw std::invalid_argument("a sample is a tuple of " +
                                  std::to_string(pair.size()) +
                                  ": it must be points, or points and a mask");
    points = pair[0];
    counted = pair[1];
  }
  Sample sample{cloudOf(points.cast<py::array>(), "sample"), std::nullopt};
  if (counted)
    sample.counted =
        indicesOf(counted.cast<py::array>(), sample.cloud.points->size(), "mask");
  return sample;
}

std::vector<Sample>
samplesOf(const py::handle& object)
{
  std::vector<Sample> samples;
  if (py::isinstance<py::list>(object))
    for (const py::handle one : object)
      samples.push_back(sampleOf(one));
  else
    samples.push_back(sampleOf(object));
  return samples;
}

std::vector<Class>
classesOf(const py::dict& samples, const std::map<std::string, double>& priors)
{
  std::vector<Class> classes;
  for (const auto& [name, of_class] : samples) {
    Class c{name.cast<std::string>(), samplesOf(of_class), std::nullopt};
    if (const auto prior = priors.find(c.name); prior != priors.end())
      c.prior = prior->second;
    classes.push_back(std::move(c));
  }
  for (const auto& [name, prior] : priors)
    if (!samples.contains(name.c_str()))
      throw std::invalid_argument("priors has the class '" + name +
                                  "': it must be one of the samples");
  return classes;
}

void
count(const Sample& sample,
      const INADParameters& parameters,
      unsigned threads,
      ShapeHistogram& histogram)
{
  const auto inad =
      estimatedINAD(sample.cloud,
                    nullptr,
                    detail::withNoiseOfCloud(
                        parameters, detail::xyzOf(*sample.cloud.points), threads),
                    threads);
  if (!sample.counted)
    histogram.add(*inad, threads);
  else
    for (const std::int32_t i : *sample.counted)
      histogram.add((*inad)[static_cast<std::size_t>(i)]);
}

ShapeModel
trained(ShapeModel model,
        const ShapeHistogram& empty,
        const std::vector<Class>& classes,
        unsigned threads)
{
  for (const Class& c : classes) {
    ShapeHistogram histogram = empty;
    for (const Sample& sample : c.samples)
      count(sample, model.parameters(), threads, histogram);
    model.add(c.name, histogram, c.prior.value_or(1.0));
  }
  return model;
}

ShapeModel
train(const py::dict& samples,
      double radius,
      const std::optional<double>& normal_radius,
      int k,
      double outlier_rate,
      const std::string& scale,
      double normal_radius_noise,
      double radius_noise,
      std::size_t bins,
      double mu_range,
      double sigma_range,
      const std::map<std::string, double>& priors,
      double smoothing,
      double floor,
      unsigned threads)
{
  INADParameters parameters =
      parametersOf(radius, normal_radius, k, outlier_rate, scale);
  parameters.normal_radius_noise = normal_radius_noise;
  parameters.radius_noise = radius_noise;
  ShapeModel model(parameters);
  model.setSmoothing(smoothing);
  model.setFloor(floor);
  const ShapeHistogram empty(bins, bins, mu_range, sigma_range);
  const std::vector<Class> classes = classesOf(samples, priors);
  return interruptibly([=] { return trained(model, empty, classes, threads); });
}

const ShapeModel::Class&
classOf(const ShapeModel& model, const std::string& name)
{
  std::string names;
  for (const ShapeModel::Class& c : model.classes()) {
    if (c.name == name)
      return c;
    names += (names.empty() ? "" : ", ") + c.name;
  }
  throw std::invalid_argument("class '" + name + "': it must be one of " + names);
}

py::array
histogramOf(const ShapeModel& model, const std::string& name)
{
  const ShapeHistogram& histogram = classOf(model, name).histogram;
  std::vector<std::uint64_t> counts;
  for (std::size_t i = 0; i < histogram.muBins(); ++i)
    for (std::size_t j = 0; j < histogram.sigmaBins(); ++j)
      counts.push_back(histogram.count(i, j));
  return arrayOf(std::move(counts),
                 {static_cast<py::ssize_t>(histogram.muBins()),
                  static_cast<py::ssize_t>(histogram.sigmaBins())});
}

py::tuple
rangesOf(const ShapeModel& model, const std::string& name)
{
  const ShapeHistogram& histogram = classOf(model, name).histogram;
  return py::make_tuple(histogram.muRange(), histogram.sigmaRange());
}

py::array
evaluate(const ShapeModel& model, const py::array& inad)
{
  const std::vector<float> pairs = floatsOf(inad, 2, "inad");
  const std::size_t size = pairs.size() / 2, classes = model.classes().size();
  std::vector<float> values(size * classes);
  for (std::size_t i = 0; classes > 0 && i < size; ++i)
    model.evaluate({pairs[2 * i], pairs[2 * i + 1]}, &values[i * classes]);
  return arrayOf(std::move(values),
                 {static_cast<py::ssize_t>(size), static_cast<py::ssize_t>(classes)});
}

py::dict
parameterDict(const ShapeModel& model)
{
  const INADParameters& p = model.parameters();
  py::dict dict;
  dict["normal_radius"] = p.normal_radius;
  dict["radius"] = p.radius;
  dict["k"] = p.k;
  dict["outlier_rate"] = p.outlier_rate;
  dict["scale"] = nameOf(p.radius_mode);
  dict["normal_radius_noise"] = p.normal_radius_noise;
  dict["radius_noise"] = p.radius_noise;
  return dict;
}

std::string
pathText(const py::object& path)
{
  return py::module_::import("os").attr("fspath")(path).cast<std::string>();
}

constexpr const char* train_text =
    R"(Make a model of samples of surfaces.

samples: a dict of the name of each class and its sample: points, float32 or float64
    (n, 3), meters; or a tuple of points and a mask, bool (n,) or indices (m,), of those
    that are counted, all being neighbors; or a list of such samples.
radius, normal_radius, k, outlier_rate, scale: how INAD is computed, as of inad();
    detect() needs "density", radii in local spacings.
normal_radius_noise, radius_noise: what a noise of one spacing adds to the radii.
bins, mu_range, sigma_range: bins x bins over angles of 0 to the ranges, radians.
priors: how frequent classes are, relative to each other; 1 for those without one.
smoothing: deviation of the Gaussian that densities are smoothed with, bins.
floor: density, 1/rad^2, below which a class says nothing.
threads: 0 for all cores.

Raises ValueError with the library's message.)";

using ModelClass = py::class_<ShapeModel>;

void
bindTraining(ModelClass& model)
{
  model.def_static("train",
                   &train,
                   py::arg("samples"),
                   py::kw_only(),
                   py::arg("radius") = 0.0,
                   py::arg("normal_radius") = py::none(),
                   py::arg("k") = 0,
                   py::arg("outlier_rate") = INADParameters().outlier_rate,
                   py::arg("scale") = "density",
                   py::arg("normal_radius_noise") = 0.0,
                   py::arg("radius_noise") = 0.0,
                   py::arg("bins") = 10,
                   py::arg("mu_range") = double{ShapeHistogram::default_range},
                   py::arg("sigma_range") = double{ShapeHistogram::default_range},
                   py::arg("priors") = std::map<std::string, double>(),
                   py::arg("smoothing") = 0.0,
                   py::arg("floor") = 0.0,
                   py::arg("threads") = 0,
                   train_text);
}

void
bindProperties(ModelClass& model)
{
  model
      .def_property_readonly(
          "classes",
          [](const ShapeModel& m) { return detail::classNames(m); },
          "The names of the classes.")
      .def_property_readonly(
          "priors",
          [](const ShapeModel& m) {
            py::dict priors;
            for (const ShapeModel::Class& c : m.classes())
              priors[py::str(c.name)] = c.prior;
            return priors;
          },
          "How frequent each class is; only the ratios count.")
      .def_property_readonly(
          "parameters",
          &parameterDict,
          "How INAD is computed: a dict of the arguments of train().")
      .def_property_readonly(
          "smoothing",
          [](const ShapeModel& m) { return m.smoothing(); },
          "Deviation of the Gaussian that densities are smoothed with, bins.")
      .def_property_readonly(
          "floor",
          [](const ShapeModel& m) { return m.floor(); },
          "Density, 1/rad^2, below which a class says nothing.");
}

} // namespace

void
bindModel(py::module_& module)
{
  ModelClass model(
      module,
      "ShapeModel",
      "Named histograms of surfaces over the mean and the deviation of the "
      "angles between normals (INAD).");
  bindTraining(model);
  bindProperties(model);
  model
      .def_static(
          "load",
          [](const py::object& path) { return ShapeModel::load(pathText(path)); },
          py::arg("path"),
          "Read a model file (JSON).")
      .def(
          "save",
          [](const ShapeModel& m, const py::object& path) { m.save(pathText(path)); },
          py::arg("path"),
          "Write a model file: complete, or not at all.")
      .def_static(
          "default_edges",
          [] { return ShapeModel::defaultEdges(); },
          "The default model of edges: \"edge\" and \"surface\".")
      .def_static(
          "default_surfaces",
          [] { return ShapeModel::defaultSurfaces(); },
          "The default model of surfaces: \"planar\" and \"curved\".")
      .def("histogram",
           &histogramOf,
           py::arg("name"),
           "The counts of a class, uint64 (mu bins, sigma bins).")
      .def("ranges",
           &rangesOf,
           py::arg("name"),
           "The first angles beyond the bins of a class: mu, sigma, radians.")
      .def("evaluate",
           &evaluate,
           py::arg("inad"),
           "inad: (n, 2), radians. Returns float32 (n, c): the likelihood of the one "
           "class, or the posteriors of several; NaN unknown.")
      .def("__repr__", [](const ShapeModel& m) {
        std::string names;
        for (const ShapeModel::Class& c : m.classes())
          names += (names.empty() ? "" : ", ") + c.name;
        return "<ShapeModel of " + names + ">";
      });
}

} // namespace pcl::python
