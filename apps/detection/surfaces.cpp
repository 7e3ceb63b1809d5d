// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The results of back-projection, as fields.

#include "detection/surfaces.h"

#include "cli/pcl_errors.h"

namespace pcl::app {

void
addSurfaces(CloudFile& file,
            SurfaceDetector& detector,
            const DetectionSettings& settings,
            Report& report)
{
  std::vector<std::vector<float>> likelihoods;
  withPclErrors(file.path, [&] {
    detector.compute(likelihoods);
    return !likelihoods.empty();
  });
  if (!settings.paper && !settings.has_model)
    report.setNumber(
        "", largest_radius, pcl::largestCurvedRadius(*detector.getShapeField()));
  const auto members = detector.classesOf(likelihoods);
  const std::vector<std::string> names = detector.getClasses();
  std::vector<std::uint32_t> surface(file.size(), 0);
  for (std::size_t c = 0; c < names.size(); ++c)
    for (const pcl::index_t index : members[c].indices)
      surface[static_cast<std::size_t>(index)] = static_cast<std::uint32_t>(c + 1);
  reportClasses(names, members, report);
  setField(file, "likelihood", likelihoods.front());
  if (settings.has_model && settings.model.classes().size() > 1)
    for (std::size_t c = 0; c < names.size(); ++c)
      setField(file, "likelihood_" + names[c], likelihoods[c]);
  setField(file, "surface", surface);
}

} // namespace pcl::app
