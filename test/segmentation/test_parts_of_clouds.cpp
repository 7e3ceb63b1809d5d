// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Parts of a cloud with the numbers of the whole have its surfaces and instances, bit
// by bit.

#include "bumpy_plane.h"
#include "common/disjoint_sets.h"
#include "field_of.h"
#include "measured_numbers.h"
#include "support/bits.h"
#include "support/errors.h"
#include "support/random.h"

#include <pcl/point_types.h>
#include <pcl/segmentation/cloud_reach.h>
#include <pcl/segmentation/faces_of_parts.h>
#include <pcl/segmentation/instances_of_parts.h>
#include <pcl/segmentation/shape_field_estimation.h>
#include <pcl/features/impl/neighborhoods.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numeric>
#include <stdexcept>
#include <string>
#include <utility>

namespace {

using namespace pcl;
using namespace pcl::test;

using Cloud = PointCloud<PointXYZ>;
constexpr std::size_t curved = 1; // among the classes of surfaces
constexpr double spacing = 0.02;  // meters, between points

/** A floor and a wall beside it, and half of a pipe on the floor: 1.6 m along x. */
Cloud::Ptr
corner()
{
  Random random(5);
  const auto cloud = make_shared<Cloud>();
  const auto add = [&](double x, double y, double z) {
    const auto moved = [&](double value) {
      return static_cast<float>(value + 0.1 * spacing * random.normal());
    };
    cloud->emplace_back(moved(x), moved(y), moved(z));
  };
  constexpr double length = 1.6, width = 0.8, pi = 3.14159265358979;
  for (double x = 0.0; x < length; x += spacing) {
    for (double v = 0.0; v < width; v += spacing) {
      if (v < 0.3 || v > 0.5)
        add(x, v, 0.0);
      add(x, 0.0, v);
    }
    for (double angle = 0.0; angle < pi; angle += spacing / 0.1)
      add(x, 0.4 + 0.1 * std::cos(angle), 0.1 * std::sin(angle));
  }
  return cloud;
}

/** A part of a cloud: its own places, and what is computed of them. */
struct Part {
  Indices indices; ///< of its own places in the cloud
  Cloud own;
  PartOfFaces faces;
  std::vector<InstancePoint> places;
};

float
xOf(const InstancePoint& point)
{
  return point.position[0];
}

float
xOf(const InstanceNode& node)
{
  return node.place[0];
}

/** Items of parts, one part after the other. */
template <typename Item>
struct ItemsOfParts {
  void
  add(const std::vector<Item>& of_part)
  {
    all.insert(all.end(), of_part.begin(), of_part.end());
    begins.push_back(all.size());
  }

  std::size_t
  countOf(std::size_t part) const
  {
    return begins[part + 1] - begins[part];
  }

  /** Where a part's items are along x. */
  std::pair<float, float>
  rangeOf(std::size_t part) const
  {
    float low = std::numeric_limits<float>::infinity(), high = -low;
    for (std::size_t i = begins[part]; i < begins[part + 1]; ++i) {
      low = std::min(low, xOf(all[i]));
      high = std::max(high, xOf(all[i]));
    }
    return {low, high};
  }

  /** The indices of a part's items, then of others within a reach of a range. */
  std::vector<std::size_t>
  near(std::size_t part, const std::pair<float, float>& range, double reach) const
  {
    std::vector<std::size_t> indices(countOf(part));
    std::iota(indices.begin(), indices.end(), begins[part]);
    for (std::size_t i = 0; i < all.size(); ++i)
      if ((i < begins[part] || i >= begins[part + 1]) &&
          xOf(all[i]) >= range.first - reach && xOf(all[i]) <= range.second + reach)
        indices.push_back(i);
    return indices;
  }

  std::vector<Item> all;
  std::vector<std::size_t> begins{0};
};

template <typename T>
std::vector<T>
taken(const std::vector<T>& values, const std::vector<std::size_t>& from)
{
  std::vector<T> result;
  for (const std::size_t i : from)
    result.push_back(values[i]);
  return result;
}

/** The instances of a cloud, from its parts. */
class InstancesFromParts {
public:
  InstancesFromParts(const CloudNumbers& numbers, ItemsOfParts<InstancePoint> points)
  : steps_(numbers, {}, 1)
  , reach_(steps_.reach())
  , points_(std::move(points))
  , parts_(points_.begins.size() - 1)
  {}

  /** The instance of each point, -1 none. */
  std::vector<std::int32_t>
  run()
  {
    for (std::size_t p = 0; p < parts_; ++p)
      nodes_.add(steps_.nodes(
          taken(points_.all, points_.near(p, points_.rangeOf(p), reach_.nodes)),
          points_.countOf(p)));
    labelNodes(unitedNodes());
    std::vector<std::int32_t> labels = ranked(
        labelsOfPoints(), [&](const auto& all) { return steps_.pieceRanks(all); });
    return ranked(grown(labels),
                  [&](const auto& all) { return steps_.instanceRanks(all); });
  }

private:
  /** The root of each node's piece; the number of nodes if it is of none. */
  std::vector<std::size_t>
  unitedNodes() const
  {
    const std::size_t none = nodes_.all.size();
    std::vector<LinkedNodes> linked;
    std::vector<std::vector<std::size_t>> near;
    std::vector<std::uint32_t> firsts{0};
    for (std::size_t p = 0; p < parts_; ++p) {
      near.push_back(nodes_.near(p, nodes_.rangeOf(p), reach_.links));
      linked.push_back(steps_.link(taken(nodes_.all, near.back()), nodes_.countOf(p)));
      firsts.push_back(firsts.back() + linked.back().pieces);
    }
    std::vector<std::size_t> pieces;
    for (std::size_t p = 0; p < parts_; ++p)
      for (const std::uint32_t piece : linked[p].piece)
        pieces.push_back(piece == LinkedNodes::none ? none : firsts[p] + piece);
    segmentation::DisjointSets sets(firsts.back());
    for (std::size_t p = 0; p < parts_; ++p)
      for (const auto& [piece, node] : linked[p].outward)
        if (pieces[near[p][node]] != none)
          sets.unite(firsts[p] + piece,
                     static_cast<std::uint32_t>(pieces[near[p][node]]));
    for (std::size_t& piece : pieces)
      if (piece != none)
        piece = sets.find(static_cast<std::uint32_t>(piece));
    return pieces;
  }

  void
  labelNodes(const std::vector<std::size_t>& pieces)
  {
    std::map<std::size_t, std::vector<std::size_t>> nodes_of;
    for (std::size_t i = 0; i < pieces.size(); ++i)
      if (pieces[i] < pieces.size())
        nodes_of[pieces[i]].push_back(i);
    labels_of_nodes_.assign(pieces.size(), -1);
    std::int32_t next = 0;
    for (const auto& nodes_of_piece : nodes_of) {
      const std::vector<std::size_t>& nodes = nodes_of_piece.second;
      const std::vector<std::int32_t> groups =
          steps_.cut(1, [&](std::size_t) { return taken(nodes_.all, nodes); }).front();
      for (std::size_t k = 0; k < nodes.size(); ++k)
        if (groups[k] >= 0)
          labels_of_nodes_[nodes[k]] = next + groups[k];
      next += static_cast<std::int32_t>(nodes.size());
    }
  }

  std::vector<std::int32_t>
  labelsOfPoints() const
  {
    std::vector<std::int32_t> labels;
    for (std::size_t p = 0; p < parts_; ++p) {
      const std::vector<std::size_t> near =
          nodes_.near(p, points_.rangeOf(p), reach_.labels);
      std::vector<std::size_t> own(points_.countOf(p));
      std::iota(own.begin(), own.end(), points_.begins[p]);
      const std::vector<std::int32_t> of_part =
          steps_.labels(taken(points_.all, own),
                        taken(nodes_.all, near),
                        taken(labels_of_nodes_, near));
      labels.insert(labels.end(), of_part.begin(), of_part.end());
    }
    return labels;
  }

  std::vector<std::int32_t>
  grown(const std::vector<std::int32_t>& labels) const
  {
    std::vector<std::int32_t> result;
    for (std::size_t p = 0; p < parts_; ++p) {
      const std::vector<std::size_t> near =
          points_.near(p, points_.rangeOf(p), reach_.growth);
      const std::vector<std::int32_t> of_part =
          steps_.grow(taken(points_.all, near), taken(labels, near));
      result.insert(result.end(),
                    of_part.begin(),
                    of_part.begin() + static_cast<std::ptrdiff_t>(points_.countOf(p)));
    }
    return result;
  }

  template <typename Rank>
  std::vector<std::int32_t>
  ranked(std::vector<std::int32_t> labels, const Rank& rank) const
  {
    std::vector<LabelCount> all;
    for (std::size_t p = parts_; p-- > 0;) { // the order makes no difference
      std::vector<std::size_t> own(points_.countOf(p));
      std::iota(own.begin(), own.end(), points_.begins[p]);
      InstancesOfParts::add(steps_.count(taken(points_.all, own), taken(labels, own)),
                            all);
    }
    const std::vector<std::int32_t> ranks = rank(all);
    for (std::int32_t& label : labels)
      if (label >= 0)
        label = ranks[static_cast<std::size_t>(label)];
    return labels;
  }

  InstancesOfParts steps_;
  InstancesOfParts::Reach reach_;
  ItemsOfParts<InstancePoint> points_;
  ItemsOfParts<InstanceNode> nodes_;
  std::vector<std::int32_t> labels_of_nodes_;
  std::size_t parts_;
};

class PartsOfClouds : public ::testing::Test {
protected:
  PartsOfClouds() : cloud(corner()), numbers(measuredNumbers(*cloud))
  {
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setInputCloud(cloud);
    const auto field = make_shared<ShapeField>();
    EXPECT_TRUE(estimation.compute(*field));
    whole = field;
    for (int part = 0; part < 3; ++part)
      parts.push_back(computed(part));
  }

  /** Slabs along x, not of the same width. */
  static int
  partOf(const PointXYZ& point)
  {
    return point.x < 0.45f ? 0 : point.x < 0.97f ? 1 : 2;
  }

  Part
  computed(int number) const
  {
    const double halo = reachOf(numbers, ShapeModel::defaultEdges()).faces;
    Part part;
    double low = std::numeric_limits<double>::infinity(), high = -low;
    for (const PointXYZ& point : *cloud)
      if (partOf(point) == number) {
        low = std::min(low, static_cast<double>(point.x) - halo);
        high = std::max(high, static_cast<double>(point.x) + halo);
      }
    const auto near = make_shared<Cloud>();
    std::vector<bool> is_own;
    for (std::size_t i = 0; i < cloud->size(); ++i) {
      const PointXYZ& point = (*cloud)[i];
      if (point.x < low || point.x > high)
        continue;
      near->push_back(point);
      is_own.push_back(partOf(point) == number);
      if (is_own.back()) {
        part.indices.push_back(static_cast<index_t>(i));
        part.own.push_back(point);
      }
    }
    ShapeFieldEstimation<PointXYZ> estimation;
    estimation.setInputCloud(near);
    estimation.setCloudNumbers(numbers);
    estimation.setEdgesOnly(true);
    ShapeField edges;
    EXPECT_TRUE(estimation.compute(edges));
    part.faces = facesOfPart(edges, numbers, is_own, 1);
    for (std::size_t i = 0; i < near->size(); ++i)
      if (is_own[i])
        part.places.push_back(
            {{(*near)[i].x, (*near)[i].y, (*near)[i].z},
             {edges.normals[i].x(), edges.normals[i].y(), edges.normals[i].z()},
             edges.spacings[i],
             0.0f,
             edges.edge_likelihood[i]});
    return part;
  }

  /** The likelihoods that a part's places have in the whole cloud. */
  std::vector<float>
  ofWhole(const Part& part, std::size_t of_class) const
  {
    std::vector<float> values;
    for (const index_t i : part.indices)
      values.push_back(whole->likelihoods[of_class][static_cast<std::size_t>(i)]);
    return values;
  }

  /** use(part, the faces around it) */
  template <typename Use>
  void
  forEachFaces(const Use& use) const
  {
    for (const Part& part : parts) {
      const auto box = FacesAround::Box::of(detail::xyzOf(part.own));
      FacesAround faces(part.faces, box, numbers, 1);
      for (const Part& other : parts)
        if (&other != &part)
          faces.add(other.faces.linked);
      use(part, faces);
    }
  }

  FacesAround::Noise
  noiseOfFaces() const
  {
    std::array<std::vector<float>, FacesAround::levels> residuals;
    forEachFaces([&](const Part&, const FacesAround& faces) {
      const FacesAround::Windows of_part = faces.windows();
      for (std::size_t l = 0; l < residuals.size(); ++l)
        for (const FacesAround::Window& window : of_part[l].windows)
          residuals[l].push_back(window.residual);
    });
    FacesAround::Noise noise{};
    for (std::size_t l = 0; l < noise.size(); ++l)
      if (!residuals[l].empty()) {
        std::sort(residuals[l].begin(), residuals[l].end());
        noise[l] = residuals[l][FacesAround::rankOfNoise(residuals[l].size())];
      }
    return noise;
  }

  const Cloud::Ptr cloud;
  const CloudNumbers numbers;
  ShapeField::ConstPtr whole;
  std::vector<Part> parts;
};

TEST_F(PartsOfClouds, HaveTheSurfacesOfTheWhole)
{
  const FacesAround::Noise noise = noiseOfFaces();
  std::size_t compared = 0;
  forEachFaces([&](const Part& part, const FacesAround& faces) {
    const std::vector<std::vector<float>> likelihoods =
        faces.likelihoods(detail::xyzOf(part.own), noise, faces.windows());
    ASSERT_EQ(likelihoods.size(), whole->likelihoods.size());
    for (std::size_t c = 0; c < likelihoods.size(); ++c)
      EXPECT_TRUE(sameBits(likelihoods[c], ofWhole(part, c))) << "class " << c;
    compared += part.indices.size();
  });
  EXPECT_EQ(compared, cloud->size());
  const std::vector<float>& of_pipe = whole->likelihoods[curved];
  EXPECT_GT(
      std::count_if(of_pipe.begin(), of_pipe.end(), [](float l) { return l > 0.5f; }),
      100); // planes alone would say little
}

TEST_F(PartsOfClouds, HaveOtherSurfacesWithoutWhatIsAround)
{
  const FacesAround::Noise noise = noiseOfFaces();
  for (const Part& part : parts) {
    const XYZView places = detail::xyzOf(part.own);
    const FacesAround alone(part.faces, FacesAround::Box::of(places), numbers, 1);
    EXPECT_FALSE(sameBits(alone.likelihoods(places, noise, alone.windows())[curved],
                          ofWhole(part, curved)));
  }
}

TEST_F(PartsOfClouds, RefuseWindowsOfOtherNodesAndOtherPlaces)
{
  const FacesAround::Noise noise{};
  forEachFaces([&](const Part& part, const FacesAround& faces) {
    const XYZView places = detail::xyzOf(part.own);
    const FacesAround alone(part.faces, FacesAround::Box::of(places), numbers, 1);
    EXPECT_THROW(faces.likelihoods(places, noise, alone.windows()),
                 std::invalid_argument);
    EXPECT_THROW(faces.likelihoods({places.first, places.stride, places.size - 1},
                                   noise,
                                   faces.windows()),
                 std::invalid_argument);
  });
}

TEST_F(PartsOfClouds, HaveTheInstancesOfTheWhole)
{
  for (const std::string of_class : {"planar", "curved"}) {
    ItemsOfParts<InstancePoint> points;
    std::vector<std::size_t> indices; // of these points in the cloud
    for (const Part& part : parts) {
      std::vector<InstancePoint> places = part.places;
      const std::vector<float> likelihoods =
          ofWhole(part, of_class == "planar" ? 0 : curved);
      for (std::size_t i = 0; i < places.size(); ++i) {
        places[i].likelihood = likelihoods[i];
        InstancesOfParts::turn({0.0f, 0.0f, 0.0f}, places[i]);
      }
      const std::vector<bool> is_held =
          InstancesOfParts(numbers, {}, 1).mayHold(places);
      std::vector<InstancePoint> held;
      for (std::size_t i = 0; i < places.size(); ++i)
        if (is_held[i]) {
          held.push_back(places[i]);
          indices.push_back(static_cast<std::size_t>(part.indices[i]));
        }
      points.add(held);
    }
    const std::vector<std::int32_t> found = InstancesFromParts(numbers, points).run();
    std::vector<std::int32_t> labels(cloud->size(), -1), expected = labels;
    for (std::size_t i = 0; i < found.size(); ++i)
      labels[indices[i]] = found[i];
    ShapeInstanceSegmentation<PointXYZ> segmentation;
    segmentation.setInputCloud(cloud);
    segmentation.setShapeField(whole);
    segmentation.setClass(of_class);
    std::vector<PointIndices> instances;
    ASSERT_TRUE(segmentation.segment(instances));
    EXPECT_GT(instances.size(), of_class == "planar" ? 1U : 0U);
    for (std::size_t k = 0; k < instances.size(); ++k)
      for (const index_t i : instances[k].indices)
        expected[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(k);
    EXPECT_EQ(labels, expected) << of_class;
  }
}

/** A piece belongs to the part that its first point is of. */
TEST_F(PartsOfClouds, HaveEachPieceOnce)
{
  std::vector<std::array<float, 3>> firsts;
  std::size_t outward = 0;
  for (std::size_t p = 0; p < parts.size(); ++p) {
    const LinkedPieces& linked = parts[p].faces.linked;
    ASSERT_EQ(linked.link_begins.size(), linked.pieces.size() + 1);
    for (const FacePiece& piece : linked.pieces) {
      EXPECT_EQ(partOf({piece.first[0], piece.first[1], piece.first[2]}),
                static_cast<int>(p));
      firsts.push_back(piece.first);
    }
    for (const std::array<float, 3>& other : linked.others)
      EXPECT_NE(partOf({other[0], other[1], other[2]}), static_cast<int>(p));
    outward += linked.others.size();
  }
  std::sort(firsts.begin(), firsts.end());
  EXPECT_EQ(std::adjacent_find(firsts.begin(), firsts.end()), firsts.end());
  EXPECT_GT(outward, 10U);
}

TEST(PartsOfNoisyClouds, KnowWhichEdgesPersist)
{
  const Cloud::Ptr cloud = bumpyPlane(4.0);
  const CloudNumbers numbers = measuredNumbers(*cloud);
  EXPECT_EQ(1.0, numbers.noise_correlation);
  const auto reach =
      static_cast<float>(reachOf(numbers, ShapeModel::defaultEdges()).edges);
  const ShapeField whole = edgeFieldOf(cloud);
  constexpr float width = 0.01f; // of strips across x
  std::size_t compared = 0, likely = 0;
  for (float low = 0.02f; low < 0.38f; low += 0.06f) {
    const auto near = make_shared<Cloud>();
    Indices of_near;
    for (std::size_t i = 0; i < cloud->size(); ++i)
      if ((*cloud)[i].x > low - reach && (*cloud)[i].x < low + width + reach) {
        near->push_back((*cloud)[i]);
        of_near.push_back(static_cast<index_t>(i));
      }
    ASSERT_LT(near->size(), cloud->size());
    const ShapeField part = edgeFieldOf(near, numbers);
    for (std::size_t k = 0; k < near->size(); ++k) {
      if ((*near)[k].x < low || (*near)[k].x > low + width)
        continue;
      const float expected =
          whole.edge_likelihood[static_cast<std::size_t>(of_near[k])];
      ASSERT_EQ(expected, part.edge_likelihood[k]) << "point " << of_near[k];
      ++compared;
      likely += expected > 0.0f ? 1 : 0;
    }
  }
  EXPECT_GT(compared, 5000U);
  EXPECT_GT(likely, 300U);
}

TEST(RefusedParts, HaveNoSpacing)
{
  CloudNumbers numbers;
  numbers.spacing = 0.0f;
  expectParts(exceptionOf<std::invalid_argument>(
                  [&] { facesOfPart(ShapeField(), numbers, {}, 1); }),
              {"spacing of the cloud is 0", "above 0"});
}

TEST(RefusedParts, AskTheFieldForSurfaces)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(corner());
  estimation.setCloudNumbers(CloudNumbers());
  ShapeField field;
  expectParts(errorsOf([&] { EXPECT_FALSE(estimation.compute(field)); }),
              {"setEdgesOnly(true)", "facesOfPart()"});
}

} // namespace
