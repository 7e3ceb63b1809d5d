// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCL's and nanoflann's search structures behind one interface.

#include "search_structures.h"

#include <pcl/common/point_tests.h>
#include <pcl/search/kdtree.h>
#include <pcl/search/octree.h>
#include <pcl/search/organized.h>

#include <limits>

#include <nanoflann.hpp>

namespace {

/** \brief The loop around a search. Search: `void find(const Cloud&, pcl::index_t,
 * double radius, pcl::Indices&)`, which a thread calls on a copy of its own. */
template <typename Search>
class LoopOver : public RadiusSearch {
public:
  LoopOver(const Cloud::ConstPtr& cloud, double radius, Search search)
  : cloud_(cloud)
  , radius_(radius)
  , search_(std::move(search))
  {}

  SearchResult
  run(const Normals& normals, int threads) const override
  {
    SearchResult result;
    result.mu.assign(cloud_->size(), std::numeric_limits<float>::quiet_NaN());
    std::uint64_t neighbors = 0;
#pragma omp parallel num_threads(threads) reduction(+ : neighbors)
    {
      Search search = search_;
      pcl::Indices found;
#pragma omp for schedule(dynamic, 256)
      for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(cloud_->size()); ++i) {
        if (pcl::isFinite((*cloud_)[i])) {
          const auto point = static_cast<pcl::index_t>(i);
          search.find(*cloud_, point, radius_, found);
          neighbors += found.size() - 1;
          result.mu[i] = inadAt(normals, found, point).mean;
        }
      }
    }
    result.neighbors = neighbors;
    return result;
  }

private:
  Cloud::ConstPtr cloud_;
  double radius_;
  Search search_;
};

/** \brief Any pcl::search::Search. */
struct PclSearch {
  pcl::search::Search<pcl::PointXYZ>::Ptr search;
  std::vector<float> squared_distances;

  void
  find(const Cloud& cloud, pcl::index_t point, double radius, pcl::Indices& found)
  {
    search->radiusSearch(cloud[point], radius, found, squared_distances);
  }
};

std::unique_ptr<RadiusSearch>
builtOver(const pcl::search::Search<pcl::PointXYZ>::Ptr& search,
          const Cloud::ConstPtr& cloud,
          double radius)
{
  search->setInputCloud(cloud);
  return std::make_unique<LoopOver<PclSearch>>(cloud, radius, PclSearch{search, {}});
}

/** \brief The finite points, as nanoflann wants to see them. */
struct FinitePoints {
  Cloud::ConstPtr cloud;
  pcl::Indices points;

  std::size_t
  kdtree_get_point_count() const
  {
    return points.size();
  }

  float
  kdtree_get_pt(std::size_t i, std::size_t axis) const
  {
    return (*cloud)[points[i]].data[axis];
  }

  template <typename Box>
  bool
  kdtree_get_bbox(Box&) const
  {
    return false;
  }
};

class Nanoflann {
public:
  Nanoflann(const Cloud::ConstPtr& cloud, std::size_t leaf_size)
  : points_(std::make_shared<FinitePoints>())
  {
    points_->cloud = cloud;
    for (std::size_t i = 0; i < cloud->size(); ++i)
      if (pcl::isFinite((*cloud)[i]))
        points_->points.push_back(static_cast<pcl::index_t>(i));
    tree_ = std::make_shared<Tree>(3, *points_, leaf_size);
    tree_->buildIndex();
  }

  void
  find(const Cloud& cloud, pcl::index_t point, double radius, pcl::Indices& found)
  {
    const auto r2 = static_cast<float>(radius * radius);
    tree_->radiusSearch(
        cloud[point].data, r2, matches_, nanoflann::SearchParams(0, 0.0f, false));
    found.clear();
    for (const auto& match : matches_)
      found.push_back(points_->points[match.first]);
  }

private:
  using Tree = nanoflann::KDTreeSingleIndexAdaptor<
      nanoflann::L2_Simple_Adaptor<float, FinitePoints>,
      FinitePoints,
      3,
      std::uint32_t>;

  std::shared_ptr<FinitePoints> points_;
  std::shared_ptr<Tree> tree_;
  std::vector<std::pair<std::uint32_t, float>> matches_;
};

} // namespace

std::vector<SearchStructure>
searchStructures(const Cloud& cloud)
{
  using Point = pcl::PointXYZ;
  const auto kdTree = [](bool sorted) {
    return [sorted](const Cloud::ConstPtr& c, double radius) {
      return builtOver(pcl::make_shared<pcl::search::KdTree<Point>>(sorted), c, radius);
    };
  };
  std::vector<SearchStructure> all{
      {"pcl::search::KdTree, sorted", kdTree(true)},
      {"pcl::search::KdTree, unsorted", kdTree(false)},
      {"pcl::search::Octree, leaf = radius",
       [](const Cloud::ConstPtr& c, double radius) {
         return builtOver(
             pcl::make_shared<pcl::search::Octree<Point>>(radius), c, radius);
       }},
      {"nanoflann, leaf size 10",
       [](const Cloud::ConstPtr& c, double radius) {
         return std::make_unique<LoopOver<Nanoflann>>(c, radius, Nanoflann(c, 10));
       }},
      {"nanoflann, leaf size 30", [](const Cloud::ConstPtr& c, double radius) {
         return std::make_unique<LoopOver<Nanoflann>>(c, radius, Nanoflann(c, 30));
       }}};
  if (cloud.isOrganized()) {
    all.push_back(
        {"pcl::search::OrganizedNeighbor", [](const Cloud::ConstPtr& c, double radius) {
           return builtOver(
               pcl::make_shared<pcl::search::OrganizedNeighbor<Point>>(), c, radius);
         }});
  }
  return all;
}
