// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "grasps/cup_map.h"
#include "grasps/mean_shift.h"

namespace pcl::segmentation {

/** \brief A cup of one size on one class of surface of a target. */
class CupPlacement {
public:
  /** \param[in] weights how likely the class is, one for each of target.points()
   * \param[in] surface the number of the class */
  CupPlacement(const TargetSurface& target,
               std::vector<float> weights,
               std::uint32_t surface,
               const SuctionCup& cup);

  /** \brief A grasp for each mode of the likelihood, in the order of the modes. */
  std::vector<SuctionGrasp> run(unsigned threads) const;

private:
  /** The point of the surface next to a mode. */
  std::optional<TargetSurface::Point> nearestTo(const Mode& mode) const;

  /** From a mode to where the cup fits: uphill to the greatest clearance. */
  std::optional<SuctionGrasp> place(const Mode& mode) const;

  SuctionGrasp judged(const SurfaceFit& fit, const CupMap& map) const;

  void findProblems(SuctionGrasp& grasp) const;

  float likelihoodUnder(const SurfaceFit& fit) const;

  const TargetSurface& target_;
  std::vector<float> weights_;
  std::uint32_t surface_;
  float radius_;
  float most_sag_;
  float enough_; ///< clearance
};

} // namespace pcl::segmentation
