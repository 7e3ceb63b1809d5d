// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The instruction sets that kernels are compiled for, and the one in use.

#include "sweep/portable/targets.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

namespace pcl::kernels {
namespace {

const std::vector<Target>&
targets()
{
  static const std::vector<Target> found = [] {
    std::vector<Target> all;
#ifdef PCL_SHAPE_HAS_HIGHWAY
    all = simdTargets();
#endif
    all.push_back({"portable", &portableKernels()});
    return all;
  }();
  return found;
}

std::atomic<const KernelTable*>&
chosen()
{
  static std::atomic<const KernelTable*> kernels{targets().front().kernels};
  return kernels;
}

} // namespace

std::vector<std::string>
availableTargets()
{
  std::vector<std::string> names;
  for (const Target& target : targets())
    names.emplace_back(target.name);
  return names;
}

void
chooseTarget(const std::string& name)
{
  std::string names;
  for (const Target& target : targets()) {
    if (name.empty() || name == target.name) {
      chosen() = target.kernels;
      return;
    }
    names += (names.empty() ? "" : ", ") + std::string(target.name);
  }
  throw std::invalid_argument("target " + name + ": expected one of " + names);
}

const KernelTable&
chosenKernels()
{
  return *chosen();
}

} // namespace pcl::kernels
