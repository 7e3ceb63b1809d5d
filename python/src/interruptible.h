// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Runs computations so that Ctrl-C ends them, without Python's lock.

#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

namespace pcl::python {

/** \brief Run a computation without Python's lock. A signal whose handler raises, such
 * as Ctrl-C, cancels it and is raised at once: what is left of the computation then
 * ends in the background, so it must own all that it uses. \throws what the computation
 * throws, or what the signal's handler raised */
void runInterruptibly(std::function<void()> computation);

/** \brief Wait for computations that were canceled: they must not outlive Python. */
void waitForCanceled();

/** \brief The same for a computation with a result. */
template <typename Computation>
auto
interruptibly(Computation computation)
{
  const auto result = std::make_shared<std::optional<decltype(computation())>>();
  runInterruptibly([result, computation = std::move(computation)] {
    result->emplace(computation());
  });
  return std::move(**result);
}

} // namespace pcl::python
