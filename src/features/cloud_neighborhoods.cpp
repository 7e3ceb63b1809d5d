// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/finite.h"
#include "common/number_text.h"
#include "common/parallel.h"

#include <pcl/features/impl/cloud_neighborhoods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

namespace pcl::detail {
namespace {

using kernels::isFinite;

std::string
problemOfCloud(const std::string& name, const XYZView& points)
{
  if (points.size == 0)
    return name + " is empty: at least one point is needed";
  if (points.size >
      static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    return name + " has " + std::to_string(points.size) +
           " points: at most 2^31 - 1 are allowed";
  }
  for (std::size_t i = 0; i < points.size; ++i)
    if (isFinite(points[i]))
      return {};
  return name + " has no finite point: at least one of its " +
         std::to_string(points.size) + " points must be finite";
}

std::string
problemOfIndices(const pcl::Indices& indices, std::size_t size)
{
  const auto bad = std::find_if(indices.begin(), indices.end(), [size](index_t i) {
    return i < 0 || static_cast<std::size_t>(i) >= size;
  });
  if (bad == indices.end())
    return {};
  return "index " + std::to_string(*bad) + " (at position " +
         std::to_string(bad - indices.begin()) + ") is out of range: 0 to " +
         std::to_string(size - 1) + " are allowed";
}

/** \brief Whether at least that many points are finite: counts no further. */
bool
hasFinite(const XYZView& points, std::size_t count)
{
  std::size_t found = 0;
  for (std::size_t i = 0; found < count && i < points.size; ++i)
    found += isFinite(points[i]) ? 1 : 0;
  return found >= count;
}

std::string
problemOfSize(double radius, int k, const XYZView& surface)
{
  if (radius != 0.0 && k != 0) {
    return "both radius (" + numberText(radius) + " m) and k (" + std::to_string(k) +
           ") are set: set one of them to 0";
  }
  if (radius == 0.0 && k == 0)
    return "neither radius nor k is set: set one of them to a positive number";
  if (k != 0) {
    return k > 0 && hasFinite(surface, static_cast<std::size_t>(k))
               ? std::string()
               : "k is " + std::to_string(k) + ": 1 to " +
                     std::to_string(kernels::countFinite(surface)) +
                     ", the number of finite points, is allowed";
  }
  return radius > 0.0 && std::isfinite(radius)
             ? std::string()
             : "radius is " + numberText(radius) + " m: it must be positive and finite";
}

} // namespace

std::string
problemOf(const NeighborhoodRequest& request)
{
  std::string problem = problemOfCloud("the input cloud", request.input);
  if (problem.empty() && request.surface.first != request.input.first)
    problem = problemOfCloud("the search surface", request.surface);
  if (problem.empty() && request.indices)
    problem = problemOfIndices(*request.indices, request.input.size);
  if (problem.empty())
    problem = problemOfSize(request.radius, request.k, request.surface);
  return problem;
}

std::string
problemOfNormals(std::size_t normals, std::size_t surface)
{
  return normals == surface
             ? std::string()
             : std::to_string(normals) + " normals are given for a search surface of " +
                   std::to_string(surface) + " points: one for each point is needed";
}

std::string
problemOfOutlierRate(double rate)
{
  return rate >= 0.0 && std::isfinite(rate)
             ? std::string()
             : "outlier rate is " + numberText(rate) +
                   ": it must be 0 (no rejection) or positive and finite";
}

bool
allFinite(const XYZView& points)
{
  return countFinite(points) == points.size;
}

std::size_t
countFinite(const XYZView& points)
{
  return kernels::countFinite(points);
}

void
forEachPart(std::size_t count,
            unsigned threads,
            const std::function<void(std::size_t, std::size_t)>& body)
{
  kernels::parallelForRanges(count, threads, body);
}

} // namespace pcl::detail
