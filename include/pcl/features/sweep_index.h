/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/neighborhood_sweep.h>

#include <cstddef>
#include <memory>
#include <mutex>

namespace pcl {

namespace kernels {
struct RowIndex;
}

/** \brief Keeps the sorted points of a search surface from one computation to the next:
 * of one class with another radius, or of several classes that work on the same cloud.
 *
 * \code
 * const auto index = std::make_shared<pcl::SweepIndex>();
 * normal_estimation.setSweepIndex(index);
 * inad_estimation.setSweepIndex(index);
 * \endcode
 *
 * Only the time changes, not a bit of the results. Before it is used again, every point
 * is compared with the surface: another cloud, or one that was edited in place, is
 * sorted anew. So are points whose rows of cells are far wider or narrower than a
 * neighborhood asks for. Normals over one radius for all points need rows of their own:
 * compute normals first. The last one sorted is kept until clear() or the object's end:
 * about 20 bytes a point of a surface, up to 60 where points are sparse. Several
 * threads may share it.
 *
 * \ingroup features
 */
class PCL_SHAPE_EXPORTS SweepIndex {
public:
  using Ptr = std::shared_ptr<SweepIndex>;
  using ConstPtr = std::shared_ptr<const SweepIndex>;

  /** \brief Free the memory. */
  void clear();

  /** \brief How many times points were sorted: computations that could use what was
   * kept did not add to it. */
  std::size_t getSortCount() const;

private:
  friend class NeighborhoodSweep;

  /** \brief How wide rows are to be, meters. */
  struct RowWidth {
    double width;
    bool is_exact; ///< otherwise about as wide will do
  };

  /** \brief What is kept, if it will do, else the points sorted anew. */
  std::shared_ptr<const kernels::RowIndex> rowsOf(const XYZView& points,
                                                  std::size_t finite_points,
                                                  const RowWidth& width,
                                                  unsigned threads);

  std::shared_ptr<const kernels::RowIndex>
  keptFor(const XYZView& points, std::size_t finite_points, const RowWidth& width);

  mutable std::mutex mutex_;
  std::shared_ptr<const kernels::RowIndex> rows_;
  std::size_t points_ = 0; ///< how many were given, finite or not
  std::size_t sort_count_ = 0;
};

/** \brief The setting that the classes which sort a search surface share.
 * \ingroup features
 */
class SweepIndexUser {
public:
  /** \brief Share the sorted search surface with others that work on the same cloud,
   * or another radius of this one; null, the default, to sort it in each computation
   * (detectors: once for all their stages). With a search method it has no effect. */
  void
  setSweepIndex(const SweepIndex::Ptr& index)
  {
    index_ = index;
  }

  SweepIndex::Ptr
  getSweepIndex() const
  {
    return index_;
  }

protected:
  ~SweepIndexUser() = default;

  SweepIndex::Ptr index_;
};

} // namespace pcl
