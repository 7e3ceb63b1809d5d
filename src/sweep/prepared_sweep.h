// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "sweep/block_sweep.h"

#include <pcl/features/neighborhood_sweep.h>

#include <memory>
#include <optional>

namespace pcl {

/** \brief The surface and the queries, sorted for one call. */
class NeighborhoodSweep::Prepared {
public:
  /** \brief Whether rows are as wide as the density asks for, or as the radius says:
   * then the order of neighbors depends on nothing else. */
  enum class Rows { by_density, by_radius };

  /** \throws std::invalid_argument if the sizes are out of range */
  Prepared(const NeighborhoodSweep& sweep,
           const NeighborhoodSize& size,
           Rows rows = Rows::by_density);

  void setNormals(const XYZView& normals);

  /** \brief Whether run() has no result for some queries: those that are not finite. */
  bool
  leavesSomeOut() const
  {
    return (blocks_ ? queries().size() : 0) != sweep_.size();
  }

  /** \brief kernel(block, results), then store(position, result) for each query. */
  template <typename Result, typename Kernel, typename Store>
  void
  run(const Kernel& kernel, const Store& store) const
  {
    if (!blocks_)
      return;
    blocks_->forEachBlock(sweep_.threads_,
                          [&](kernels::SweepBlock& block, const std::uint32_t* order) {
                            Result results[kernels::block_size];
                            kernel(block, order, results);
                            for (std::size_t i = 0; i < block.size; ++i)
                              store(order[i], results[i]);
                          });
  }

private:
  const kernels::RowIndex&
  queries() const
  {
    return own_queries_ ? *own_queries_ : *surface_;
  }

  const NeighborhoodSweep& sweep_;
  std::shared_ptr<const kernels::RowIndex> surface_;
  std::optional<kernels::RowIndex> own_queries_;
  kernels::UnitNormals normals_;
  std::optional<kernels::BlockSweep> blocks_;
};

} // namespace pcl
