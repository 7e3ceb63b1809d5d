// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// pcl_shape_back_projection: adds the surface class and its likelihood.

#include "cli/app.h"
#include "cli/filter_app.h"
#include "detection/detection.h"

#include <pcl/segmentation/shape_back_projection.h>

namespace {

using namespace pcl::app;
using Detector = pcl::ShapeBackProjection<pcl::PointXYZ, pcl::Normal>;

struct Classification {
  std::vector<std::vector<float>> likelihoods; ///< one a class
  std::vector<pcl::PointIndices> members;      ///< one a class
};

/** \param[in] is_default the model, which tells planar from curved surfaces */
std::vector<std::vector<float>>
likelihoodsOf(Detector& detector, bool is_default, Report& report)
{
  if (!is_default) {
    std::vector<std::vector<float>> likelihoods;
    detector.compute(likelihoods);
    return likelihoods;
  }
  pcl::Surfaces surfaces;
  detector.classify(surfaces);
  report.setNumber("", largest_radius, pcl::largestCurvedRadius(surfaces));
  return std::move(surfaces.likelihoods);
}

Classification
classify(Detector& detector, const CloudFile& file, bool is_default, Report& report)
{
  Classification classes;
  classes.likelihoods = likelihoodsOf(detector, is_default, report);
  classes.members = detector.classesOf(classes.likelihoods);
  if (classes.likelihoods.empty() || classes.members.empty())
    throw InputError(file.path + ": refused for the reason given above");
  return classes;
}

void
addClasses(CloudFile& file,
           const Arguments& arguments,
           const DetectionSettings& settings,
           Report& report)
{
  Detector detector;
  prepare(detector, file, settings, arguments, report);
  const bool is_default = settings.adaptive && !arguments.has("model");
  const Classification classes = report.time(
      "back_projection", [&] { return classify(detector, file, is_default, report); });
  const std::vector<std::string> names = detector.getClasses();

  std::vector<std::uint32_t> surface(file.size(), 0);
  std::uint64_t unknown = report.count("", "finite_points");
  for (std::size_t c = 0; c < names.size(); ++c) {
    for (const pcl::index_t index : classes.members[c].indices)
      surface[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(c + 1);
    report.setCount("counts", names[c], classes.members[c].indices.size());
    unknown -= classes.members[c].indices.size();
  }
  report.setCount("counts", "unknown", unknown);
  setField(file, "likelihood", classes.likelihoods.front());
  if (arguments.has("model") && settings.model.classes().size() > 1)
    for (std::size_t c = 0; c < names.size(); ++c)
      setField(file, "likelihood_" + names[c], classes.likelihoods[c]);
  setField(file, "surface", surface);
}

/** Names of classes become parts of names of fields. */
void
requireFieldNames(const DetectionSettings& settings, const Arguments& arguments)
{
  for (const auto& of : settings.model.classes())
    for (const char c : of.name)
      if (c <= ' ' || c > '~')
        throw InputError(arguments.text("model") + ": class '" + of.name +
                         "'; expected a name without blanks, in ASCII");
}

int
run(const Arguments& arguments)
{
  const DetectionSettings settings =
      detectionSettings(arguments, pcl::INADParameters::surfaces());
  requireFieldNames(settings, arguments);
  if (arguments.has("threshold") &&
      (settings.adaptive || settings.model.classes().size() > 1))
    throw UsageError("-threshold with several classes, as the default mode has: points "
                     "belong to the likeliest; expected one class, as with -mode "
                     "paper");
  return runFilter(arguments, [&](CloudFile& file, Report& report) {
    addClasses(file, arguments, settings, report);
  });
}

} // namespace

int
main(int argc, char** argv)
{
  CommandLine command_line(
      "pcl_shape_back_projection",
      "in.pcd out.pcd",
      "Add the fields likelihood (of the first class) and surface: 1 planar, 2 curved, "
      "0 "
      "unknown;\nwith a model of several classes the number of the class, and "
      "likelihood_<name> of each.");
  addDetectionOptions(command_line);
  addFilterOptions(command_line);
  return runApp(command_line, argc, argv, run);
}
