// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "sweep/inad_input.h"
#include "sweep/portable/targets.h"
#include "sweep/prepared_sweep.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>

namespace pcl {
namespace {

using namespace kernels;

constexpr float nan = std::numeric_limits<float>::quiet_NaN();

} // namespace

bool
NeighborhoodSweep::computeNormals(const NeighborhoodSize& neighborhood,
                                  float* normals,
                                  float* curvature,
                                  std::size_t stride) const
{
  const Prepared prepared(*this, neighborhood, Prepared::Rows::by_radius);
  std::atomic<bool> is_finite{!prepared.leavesSomeOut()};
  if (prepared.leavesSomeOut()) {
    for (std::size_t i = 0; i < size(); ++i) {
      std::fill_n(normals + i * stride, 3, nan);
      curvature[i * stride] = nan;
    }
  }
  prepared.run<NormalResult>(
      [](const SweepBlock& block, const std::uint32_t*, NormalResult* results) {
        kernels::chosenKernels().normals(block, results);
      },
      [&](std::uint32_t i, const NormalResult& result) {
        float* normal = normals + i * stride;
        normal[0] = result.x;
        normal[1] = result.y;
        normal[2] = result.z;
        curvature[i * stride] = result.curvature;
        if (std::isnan(result.x))
          is_finite = false;
      });
  return is_finite;
}

bool
NeighborhoodSweep::computeINAD(const NeighborhoodSize& neighborhood,
                               const XYZView& normals,
                               double outlier_rate,
                               float* mu_sigma) const
{
  checkINADInput(surface_.size, normals.size, outlier_rate);
  Prepared prepared(*this, neighborhood);
  prepared.setNormals(normals);
  std::atomic<bool> is_finite{!prepared.leavesSomeOut()};
  if (prepared.leavesSomeOut())
    std::fill_n(mu_sigma, 2 * size(), nan);
  prepared.run<INADResult>(
      [&](SweepBlock& block, const std::uint32_t* order, INADResult* results) {
        for (std::size_t i = 0;
             has_indices_ && block.queries_on_surface && i < block.size;
             ++i) {
          const UnitNormal own = unitNormal(normals[surfaceIndex(order[i])]);
          block.qnx[i] = own.x;
          block.qny[i] = own.y;
          block.qnz[i] = own.z;
        }
        kernels::chosenKernels().inad(block, outlier_rate, results);
      },
      [&](std::uint32_t i, const INADResult& result) {
        mu_sigma[std::size_t{2} * i] = result.mu;
        mu_sigma[std::size_t{2} * i + 1] = result.sigma;
        if (std::isnan(result.mu))
          is_finite = false;
      });
  return is_finite;
}

void
NeighborhoodSweep::countNeighbors(const NeighborhoodSize& neighborhood,
                                  std::uint32_t* counts) const
{
  const Prepared prepared(*this, neighborhood);
  std::fill_n(counts, size(), 0);
  prepared.run<std::uint32_t>(
      [](const SweepBlock& block, const std::uint32_t*, std::uint32_t* results) {
        kernels::chosenKernels().count(block, results);
      },
      [&](std::uint32_t i, std::uint32_t count) { counts[i] = count; });
}

void
NeighborhoodSweep::computeDistanceToNearest(std::size_t k, float* distances) const
{
  const Prepared prepared(*this, NeighborhoodSize::ofNearest(k));
  std::fill_n(distances, size(), nan);
  prepared.run<float>(
      [](const SweepBlock& block, const std::uint32_t*, float* results) {
        std::copy_n(block.kth_d2, block.size, results);
      },
      [&](std::uint32_t i, float d2) { distances[i] = std::sqrt(d2); });
}

} // namespace pcl
