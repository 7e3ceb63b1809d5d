// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs tests on every instruction set of the machine.

#pragma once

#include "sweep/portable/targets.h"

#include <string>
#include <vector>

namespace pcl {
namespace test {

/** \brief The instruction sets that tests run with: all that this machine has. */
inline std::vector<std::string>
kernelTargets()
{
  return kernels::availableTargets();
}

/** \brief While it lives, the sweep runs on this target. */
class ForcedTarget {
public:
  explicit ForcedTarget(const std::string& name) { kernels::chooseTarget(name); }

  ForcedTarget(const ForcedTarget&) = delete;
  ForcedTarget& operator=(const ForcedTarget&) = delete;

  ~ForcedTarget() { kernels::chooseTarget(""); }
};

/** \brief Names the tests of a suite that runs on every target. */
struct TargetName {
  template <typename Test>
  std::string
  operator()(const Test& test) const
  {
    return test.param;
  }
};

} // namespace test
} // namespace pcl
