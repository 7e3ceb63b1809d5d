// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Statistics over neighborhoods, by the sweep or a search method, and the checks of
// input.

#include "common/finite.h"
#include "common/number_text.h"
#include "common/parallel.h"
#include "features/spacing/local_spacing.h"

#include <pcl/features/impl/neighborhoods.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <type_traits>

namespace pcl::detail {
namespace {

using kernels::isFinite;

// PCL can be built with other indices. Clouds of 2^31 points and more are refused, so
// that all of them fit the engine's.
constexpr bool has_engine_indices = std::is_same_v<pcl::index_t, std::int32_t>;

/** \brief PCL's indices where they have the engine's type, else the narrow ones. */
template <typename Index>
const std::int32_t*
eitherOf(const std::vector<Index>& indices, const std::vector<std::int32_t>& narrow)
{
  if constexpr (std::is_same_v<Index, std::int32_t>)
    return indices.data();
  else
    return narrow.data();
}

std::string
problemOfCloud(const std::string& name, const XYZView& points)
{
  if (points.size == 0)
    return name + " is empty: at least one point is needed";
  if (points.size >
      static_cast<std::size_t>(std::numeric_limits<std::int32_t>::max())) {
    return name + " has " + std::to_string(points.size) +
           " points: it must have at most 2^31 - 1";
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
         std::to_string(bad - indices.begin()) + ") is out of range: it must be 0 to " +
         std::to_string(size - 1);
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
               : "k is " + std::to_string(k) + ": it must be 1 to " +
                     std::to_string(kernels::countFinite(surface)) +
                     ", the number of finite points";
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

Neighborhoods::Neighborhoods(const XYZView& input,
                             const XYZView& surface,
                             const pcl::Indices& indices,
                             unsigned threads)
: input_(input)
, surface_(surface)
, indices_(&indices)
, threads_(threads)
{
  if constexpr (!has_engine_indices) {
    narrow_indices_.reserve(indices.size());
    for (const pcl::index_t index : indices)
      narrow_indices_.push_back(static_cast<std::int32_t>(index));
  }
}

Neighborhoods
Neighborhoods::among(const pcl::Indices& points) const
{
  Neighborhoods some(input_, surface_, points, threads_);
  some.finder_ = finder_;
  some.index_ = index_;
  return some;
}

NeighborhoodSweep
Neighborhoods::sweep() const
{
  NeighborhoodSweep sweep(surface_);
  if (input_.first != surface_.first)
    sweep.setQueries(input_);
  bool is_all = size() == input_.size;
  for (std::size_t i = 0; indices_ && is_all && i < size(); ++i)
    is_all = pointAt(i) == static_cast<pcl::index_t>(i);
  if (!is_all)
    sweep.setQueryIndices(eitherOf(*indices_, narrow_indices_), size());
  sweep.setNumberOfThreads(threads_);
  sweep.setIndex(index_);
  return sweep;
}

bool
Neighborhoods::computeNormals(const NeighborhoodSize& size,
                              float* normals,
                              float* curvature,
                              std::size_t stride) const
{
  return finder_ ? computeListedNormals(size, normals, curvature, stride)
                 : sweep().computeNormals(size, normals, curvature, stride);
}

bool
Neighborhoods::computeINAD(const NeighborhoodSize& size,
                           const XYZView& normals,
                           double outlier_rate,
                           float* mu_sigma) const
{
  return finder_ ? computeListedINAD(size, normals, outlier_rate, mu_sigma)
                 : sweep().computeINAD(size, normals, outlier_rate, mu_sigma);
}

void
Neighborhoods::computeDistanceToNearest(std::size_t k, float* distances) const
{
  k = std::min(k, countFinite(surface_));
  if (!finder_) {
    sweep().computeDistanceToNearest(k, distances);
    return;
  }
  pcl::Indices found;
  std::vector<float> squared;
  for (std::size_t i = 0; i < size(); ++i) {
    distances[i] = std::numeric_limits<float>::quiet_NaN();
    found.clear();
    if (isFinite(input_[static_cast<std::size_t>(pointAt(i))]))
      finder_(pointAt(i), 0.0, static_cast<int>(k), found, squared);
    if (!found.empty())
      distances[i] = std::sqrt(*std::max_element(squared.begin(), squared.end()));
  }
}

NeighborhoodSize
Neighborhoods::sizeOf(double radius,
                      int k,
                      AdaptiveRadius::RadiusMode mode,
                      std::vector<float>& radii) const
{
  if (k > 0)
    return NeighborhoodSize::ofNearest(static_cast<std::size_t>(k));
  if (mode == AdaptiveRadius::FIXED)
    return NeighborhoodSize::ofRadius(radius);
  radii = adaptiveRadii(mode, radius, *this);
  return NeighborhoodSize::ofRadii(radii.data());
}

} // namespace pcl::detail
