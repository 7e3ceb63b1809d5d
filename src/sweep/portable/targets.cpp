// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "sweep/portable/targets.h"

#include <algorithm>
#include <atomic>
#include <stdexcept>

#ifdef PCL_SHAPE_HAS_HIGHWAY
#include <hwy/targets.h>
#endif

namespace pcl::kernels {
namespace {

struct Target {
  const char* name;
  const KernelTable* kernels;
};

std::vector<Target>
findTargets()
{
  std::vector<Target> targets;
#ifdef PCL_SHAPE_HAS_HIGHWAY
  struct Candidate {
    const char* name;
    std::int64_t bit;
  };
  for (const Candidate candidate : {Candidate{"avx3", HWY_AVX3},
                                    Candidate{"avx2", HWY_AVX2},
                                    Candidate{"sse4", HWY_SSE4},
                                    Candidate{"neon", HWY_NEON}}) {
    const KernelTable* kernels = simdKernels(candidate.name);
    if (kernels && (hwy::SupportedTargets() & candidate.bit) != 0)
      targets.push_back({candidate.name, kernels});
  }
#endif
  targets.push_back({"portable", &portableKernels()});
  return targets;
}

const std::vector<Target>&
targets()
{
  static const std::vector<Target> found = findTargets();
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
  std::string allowed;
  for (const Target& target : targets()) {
    if (name.empty() || name == target.name) {
      chosen() = target.kernels;
      return;
    }
    allowed += (allowed.empty() ? "" : ", ") + std::string(target.name);
  }
  throw std::invalid_argument("target " + name + ": this processor and build have " +
                              allowed);
}

const KernelTable&
chosenKernels()
{
  return *chosen();
}

} // namespace pcl::kernels
