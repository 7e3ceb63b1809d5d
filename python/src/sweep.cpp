// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// NeighborhoodSweep: statistics over the neighborhoods of many points.

#include "arrays.h"
#include "interruptible.h"
#include "parts.h"

#include <pcl/features/neighborhood_sweep.h>
#include <pcl/features/sweep_index.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <pybind11/stl.h>

namespace pcl::python {
namespace {

using OptionalArray = std::optional<py::array>;

/** The points to find neighbors among, sorted once for several computations. */
struct Surface {
  Cloud cloud;
  std::shared_ptr<pcl::SweepIndex> index = std::make_shared<pcl::SweepIndex>();
  unsigned threads = 0;
};

/** What is asked of a surface; owns all that it needs. */
struct Question {
  Surface surface;
  std::optional<Cloud> queries;
  double radius = 0.0;
  std::optional<std::vector<float>> radii;
  std::size_t k = 0;

  pcl::NeighborhoodSweep
  sweep() const
  {
    pcl::NeighborhoodSweep sweep(detail::xyzOf(*surface.cloud.points));
    if (queries)
      sweep.setQueries(detail::xyzOf(*queries->points));
    sweep.setNumberOfThreads(surface.threads);
    sweep.setIndex(surface.index);
    return sweep;
  }

  pcl::NeighborhoodSize
  size() const
  {
    return {radius, radii ? radii->data() : nullptr, k};
  }
};

Question
questionOf(const Surface& surface,
           double radius,
           const OptionalArray& radii,
           std::size_t k,
           const OptionalArray& queries)
{
  Question question{surface, std::nullopt, radius, std::nullopt, k};
  if (queries)
    question.queries = cloudWithOffset(*queries, surface.cloud.offset, "queries");
  if (radii) {
    question.radii = floatsOf(*radii, "radii");
    const std::size_t needed = question.sweep().size();
    if (question.radii->size() != needed)
      throw std::invalid_argument(std::to_string(question.radii->size()) +
                                  " radii are given for " + std::to_string(needed) +
                                  " queries: one for each is needed");
  }
  return question;
}

py::tuple
normals(const Surface& surface,
        double radius,
        const OptionalArray& radii,
        std::size_t k,
        const OptionalArray& queries)
{
  const Question question = questionOf(surface, radius, radii, k, queries);
  auto [normals, curvatures] = interruptibly([question] {
    const pcl::NeighborhoodSweep sweep = question.sweep();
    std::vector<float> rows(4 * sweep.size()); // a normal and its curvature
    sweep.computeNormals(question.size(), rows.data(), rows.data() + 3, 4);
    std::pair<std::vector<float>, std::vector<float>> result;
    for (std::size_t i = 0; i < rows.size(); i += 4) {
      const auto row = rows.begin() + static_cast<std::ptrdiff_t>(i);
      result.first.insert(result.first.end(), row, row + 3);
      result.second.push_back(row[3]);
    }
    return result;
  });
  const auto size = static_cast<py::ssize_t>(curvatures.size());
  return py::make_tuple(arrayOf(std::move(normals), {size, 3}),
                        arrayOf(std::move(curvatures)));
}

py::array
inad(const Surface& surface,
     const py::array& given_normals,
     double radius,
     const OptionalArray& radii,
     std::size_t k,
     const OptionalArray& queries,
     double outlier_rate)
{
  const Question question = questionOf(surface, radius, radii, k, queries);
  const std::vector<float> normals = floatsOf(given_normals, 3, "normals");
  std::vector<float> values = interruptibly([=] {
    const pcl::NeighborhoodSweep sweep = question.sweep();
    std::vector<float> mu_sigma(2 * sweep.size());
    sweep.computeINAD(question.size(),
                      {normals.data(), 3, normals.size() / 3},
                      outlier_rate,
                      mu_sigma.data());
    return mu_sigma;
  });
  const auto size = static_cast<py::ssize_t>(values.size() / 2);
  return arrayOf(std::move(values), {size, 2});
}

py::array
countNeighbors(const Surface& surface,
               double radius,
               const OptionalArray& radii,
               std::size_t k,
               const OptionalArray& queries)
{
  const Question question = questionOf(surface, radius, radii, k, queries);
  return arrayOf(interruptibly([question] {
    const pcl::NeighborhoodSweep sweep = question.sweep();
    std::vector<std::uint32_t> counts(sweep.size());
    sweep.countNeighbors(question.size(), counts.data());
    return counts;
  }));
}

py::array
distanceToNearest(const Surface& surface, std::size_t k, const OptionalArray& queries)
{
  const Question question = questionOf(surface, 0.0, std::nullopt, k, queries);
  return arrayOf(interruptibly([question] {
    const pcl::NeighborhoodSweep sweep = question.sweep();
    std::vector<float> distances(sweep.size());
    sweep.computeDistanceToNearest(question.k, distances.data());
    return distances;
  }));
}

constexpr const char* class_text =
    R"(Statistics over the neighborhoods of many points at once, without a search tree.

A neighborhood is exactly one of: radius, meters; radii, float (n,), meters, one for each
query; k, nearest points, the query's own included. Queries are the points themselves, or
(m, 3) others. The points are copied, and sorted once for all computations that can share
it. Fewer than five neighbors besides the point itself give NaN. All methods raise
ValueError with the library's message.)";

} // namespace

void
bindSweep(py::module_& module)
{
  const auto keyword = py::kw_only();
  const auto radius = py::arg("radius") = 0.0;
  const auto radii = py::arg("radii") = py::none();
  const auto k = py::arg("k") = 0;
  const auto queries = py::arg("queries") = py::none();
  py::class_<Surface>(module, "NeighborhoodSweep", class_text)
      .def(py::init([](const py::array& points, unsigned threads) {
             Surface surface;
             surface.cloud = cloudOf(points, "points");
             surface.threads = threads;
             return surface;
           }),
           py::arg("points"),
           keyword,
           py::arg("threads") = 0,
           "points: float32 or float64 (n, 3), meters. threads: 0 for all cores.")
      .def("normals",
           &normals,
           keyword,
           radius,
           radii,
           k,
           queries,
           "Returns (normals, curvature): float32 (m, 3), unit, of either sign, and "
           "float32 (m,), the surface variation, 0 to 1/3.")
      .def("inad",
           &inad,
           py::arg("normals"),
           keyword,
           radius,
           radii,
           k,
           queries,
           py::arg("outlier_rate") = 2.0,
           "normals: (n, 3), of the points, of any length but 0. Returns float32 (m, "
           "2): mean and deviation of the angles between normals, radians.")
      .def("count_neighbors",
           &countNeighbors,
           keyword,
           radius,
           radii,
           k,
           queries,
           "Returns uint32 (m,): neighbors, the query's own point not counted.")
      .def("distance_to_nearest",
           &distanceToNearest,
           py::arg("k"),
           keyword,
           queries,
           "Returns float32 (m,), meters: to the k-th nearest point, the query's own "
           "counted as the first; NaN for a query that is not finite.")
      .def("__len__", [](const Surface& s) { return s.cloud.points->size(); });
}

} // namespace pcl::python
