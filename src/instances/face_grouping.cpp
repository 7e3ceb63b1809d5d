// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "instances/face_grouping.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <cmath>
#include <map>

namespace pcl::segmentation {
namespace {

// doc/instances.md has the reason of each number.
constexpr double planar_threshold = 0.5;
constexpr double least_area_share = 0.25; // of the largest face's
constexpr float least_side = 1.0f;        // of the width of a group
constexpr float narrow = 8.0f, least_narrow_side = 0.5f;
constexpr double least_rim = 0.1;      // of the width of a side of a body
constexpr double in_plane_share = 0.8; // of a face's points

/** Others stand on a face, or lie before it: it is no side of a body. */
bool
carries(std::size_t face,
        const std::vector<Face>& faces,
        const std::vector<FaceContact>& contacts)
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
  if (concave > 2.0f * convex)
    return true;
  double others = 0.0;
  for (std::size_t f = 0; f < faces.size(); ++f)
    others += f == face ? 0.0 : faces[f].area;
  const double area = faces[face].area;
  return others > 0.0 && area > others && convex < least_rim * std::sqrt(area);
}

/** A plane by least squares. */
struct Plane {
  Eigen::Vector3d center = Eigen::Vector3d::Zero();
  Eigen::Vector3d normal = Eigen::Vector3d::Zero();
};

Plane
planeOf(const detail::InstanceInput& input, const Labels& labels, std::int32_t label)
{
  const auto forEach = [&](const auto& visit) {
    for (std::size_t i = 0; i < labels.size(); ++i)
      if (labels[i] == label)
        visit(Eigen::Vector3d(positionOf(input.points, i).cast<double>()));
  };
  Plane plane;
  double points = 0.0;
  forEach([&](const Eigen::Vector3d& p) {
    plane.center += p;
    points += 1.0;
  });
  plane.center /= points;
  Eigen::Matrix3d covariance = Eigen::Matrix3d::Zero();
  forEach([&](const Eigen::Vector3d& p) {
    covariance += (p - plane.center) * (p - plane.center).transpose();
  });
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(covariance);
  plane.normal = solver.eigenvectors().col(0);
  return plane;
}

/** How many points of each face are in a plane, but for the noise. */
std::vector<std::size_t>
pointsIn(const Plane& plane,
         const detail::InstanceInput& input,
         const Labels& labels,
         std::size_t faces)
{
  const double limit = offsetLimit(input);
  std::vector<std::size_t> counts(faces, 0);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (labels[i] < 0)
      continue;
    const Eigen::Vector3d p = positionOf(input.points, i).cast<double>();
    const double offset = std::abs(plane.normal.dot(p - plane.center));
    if (offset < limit * input.spacings[i])
      ++counts[static_cast<std::size_t>(labels[i])];
  }
  return counts;
}

/** Weights between groups; positive ones want to be joined. */
class SignedGraph {
public:
  SignedGraph(const std::vector<Face>& faces,
              const std::vector<char>& left_out,
              const std::vector<FaceContact>& contacts)
  : weights_(faces.size())
  , group_(faces.size())
  {
    for (std::size_t i = 0; i < faces.size(); ++i) {
      group_[i] = left_out[i] ? -1 : static_cast<std::int32_t>(i);
      widths_.push_back(static_cast<float>(std::sqrt(faces[i].area)));
    }
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
        if (weight > best.weight && !isNeck(i, static_cast<std::size_t>(other), weight))
          best = {weight, static_cast<std::int32_t>(i), other};
    return best;
  }

  /** Faces of one body share a side; bodies that touch may share less. */
  bool
  isNeck(std::size_t a, std::size_t b, float weight) const
  {
    const float width = std::min(widths_[a], widths_[b]);
    return weight < width * (width < narrow ? least_narrow_side : least_side);
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
    float& width = widths_[static_cast<std::size_t>(kept)];
    width = std::hypot(width, widths_[static_cast<std::size_t>(gone)]);
    std::replace(group_.begin(), group_.end(), gone, kept);
  }

  std::vector<std::map<std::int32_t, float>> weights_;
  std::vector<float> widths_; ///< of groups, in spacings
  Labels group_;
};

} // namespace

std::vector<char>
supportsAmong(const detail::InstanceInput& input,
              const Labels& labels,
              const std::vector<Face>& faces,
              const std::vector<FaceContact>& contacts)
{
  double largest = 0.0;
  for (const Face& face : faces)
    if (face.planar > planar_threshold)
      largest = std::max(largest, face.area);
  std::vector<char> is_support(faces.size(), 0);
  for (std::size_t s = 0; s < faces.size(); ++s) {
    const bool is_large = faces[s].area >= least_area_share * largest;
    if (is_support[s] || faces[s].planar <= planar_threshold || !is_large ||
        !carries(s, faces, contacts))
      continue;
    const Plane plane = planeOf(input, labels, static_cast<std::int32_t>(s));
    const std::vector<std::size_t> in_plane =
        pointsIn(plane, input, labels, faces.size());
    for (std::size_t f = 0; f < faces.size(); ++f) {
      const auto needed = in_plane_share * static_cast<double>(faces[f].points);
      if (f == s || static_cast<double>(in_plane[f]) >= needed)
        is_support[f] = 1;
    }
  }
  return is_support;
}

Labels
groupFaces(const std::vector<Face>& faces,
           const std::vector<char>& left_out,
           const std::vector<FaceContact>& contacts)
{
  return SignedGraph(faces, left_out, contacts).contract();
}

} // namespace pcl::segmentation
