// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include <cstddef>

/** \brief Count what the program allocates and frees from now on. */
void startCountingHeap();

void stopCountingHeap();

/** \brief The most bytes in use since the last call, or startCountingHeap(): more than
 * when counting began. */
std::ptrdiff_t takeHeapPeak();
