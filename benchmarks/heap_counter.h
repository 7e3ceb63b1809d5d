/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <cstddef>

/** \brief Bytes that the program has allocated and not freed. */
std::size_t heapInUse();

/** \brief The most bytes in use since the last call of resetHeapPeak(). */
std::size_t heapPeak();

void resetHeapPeak();
