/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#include "face_grouping.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr double planar_threshold = 0.5;
constexpr double least_area_share = 0.25;   // of the largest face's
constexpr double same_plane_cosine = 0.985; // of 10 degrees

bool
carries(std::size_t face, const std::vector<FaceContact>& contacts)
{
  float convex = 0.0f, concave = 0.0f;
  for (const FaceContact& contact : contacts) {
    const auto first = static_cast<std::size_t>(contact.first);
    const auto second = static_cast<std::size_t>(contact.second);
    if (first != face && second != face)
      continue;
    convex += contact.convex;
    concave += contact.concave;
  }
  return concave > 2.0f * convex;
}

bool
inSamePlane(const Face& support, const Face& face, float offset_limit)
{
  const double offset = std::abs(support.normal.dot(face.center - support.center));
  return face.planar > planar_threshold &&
         face.normal.dot(support.normal) > same_plane_cosine &&
         offset < 2.0f * offset_limit * face.spacing;
}

/** Weights between groups; positive ones want to be joined. */
class SignedGraph {
public:
  SignedGraph(std::size_t size,
              const std::vector<char>& left_out,
              const std::vector<FaceContact>& contacts)
  : weights_(size)
  , group_(size)
  {
    for (std::size_t i = 0; i < size; ++i)
      group_[i] = left_out[i] ? -1 : static_cast<std::int32_t>(i);
    for (const FaceContact& contact : contacts)
      if (group_[static_cast<std::size_t>(contact.first)] >= 0 &&
          group_[static_cast<std::size_t>(contact.second)] >= 0)
        add(contact.first, contact.second, contact.convex - contact.concave);
  }

  Labels
  contract()
  {
    for (auto best = strongest(); best.weight > 0.0f; best = strongest())
      join(best.first, best.second);
    return group_;
  }

private:
  struct Edge {
    float weight = 0.0f;
    std::int32_t first = -1, second = -1;
  };

  std::map<std::int32_t, float>&
  of(std::int32_t group)
  {
    return weights_[static_cast<std::size_t>(group)];
  }

  void
  add(std::int32_t first, std::int32_t second, float weight)
  {
    of(first)[second] += weight;
    of(second)[first] += weight;
  }

  Edge
  strongest() const
  {
    Edge best;
    for (std::size_t i = 0; i < weights_.size(); ++i)
      for (const auto& [other, weight] : weights_[i])
        if (weight > best.weight)
          best = {weight, static_cast<std::int32_t>(i), other};
    return best;
  }

  void
  join(std::int32_t kept, std::int32_t gone)
  {
    of(kept).erase(gone);
    of(gone).erase(kept);
    for (const auto& [other, weight] : of(gone)) {
      of(other).erase(gone);
      add(kept, other, weight);
    }
    of(gone).clear();
    std::replace(group_.begin(), group_.end(), gone, kept);
  }

  std::vector<std::map<std::int32_t, float>> weights_;
  Labels group_;
};

} // namespace

std::vector<Face>
facesOf(const detail::InstanceInput& input, const Labels& labels)
{
  const std::int32_t most = *std::max_element(labels.begin(), labels.end());
  std::vector<Face> faces(static_cast<std::size_t>(most + 1));
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    Face& face = faces[static_cast<std::size_t>(labels[i])];
    const double d = input.spacings[i];
    face.center += positionOf(input.points, i).cast<double>();
    face.normal += normalOf(input, i).cast<double>();
    face.area += d * d;
    face.spacing += d;
    face.planar += std::isnan(input.likelihood[i]) ? 0.0 : input.likelihood[i];
    ++face.points;
  }
  for (Face& face : faces) {
    const auto points = static_cast<double>(face.points);
    face.center /= points;
    face.normal.normalize();
    face.spacing /= points;
    face.planar /= points;
  }
  return faces;
}

std::vector<char>
supportsAmong(const std::vector<Face>& faces,
              const std::vector<FaceContact>& contacts,
              float offset_limit)
{
  double largest = 0.0;
  for (const Face& face : faces)
    if (face.planar > planar_threshold)
      largest = std::max(largest, face.area);
  std::vector<char> is_support(faces.size(), 0);
  std::vector<std::size_t> supports;
  for (std::size_t f = 0; f < faces.size(); ++f) {
    const bool is_large = faces[f].area >= least_area_share * largest;
    if (faces[f].planar > planar_threshold && is_large && carries(f, contacts))
      supports.push_back(f);
  }
  for (const std::size_t s : supports)
    for (std::size_t f = 0; f < faces.size(); ++f)
      if (f == s || inSamePlane(faces[s], faces[f], offset_limit))
        is_support[f] = 1;
  return is_support;
}

Labels
groupFaces(std::size_t faces,
           const std::vector<char>& left_out,
           const std::vector<FaceContact>& contacts)
{
  return SignedGraph(faces, left_out, contacts).contract();
}

} // namespace pcl::segmentation
