// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces grouped to bodies.

#pragma once

#include "instances/faces/face_contacts.h"

namespace pcl::segmentation {

/** \brief Group faces that are mostly convex to each other: join the pair of groups
 * with the most convex border, as long as that is longer than their concave border
 * (greedy additive edge contraction; Keuper et al., "Efficient Decomposition of Image
 * and Mesh Graphs by Lifted Multicuts", 2015). Then groups that are too narrow for a
 * body of their own and touch nothing that is left out join what holds them, even where
 * the border is mostly concave.
 * \return a group for each face; -1 for faces that are left out */
Labels groupFaces(const std::vector<Face>& faces,
                  const std::vector<char>& left_out,
                  const std::vector<FaceContact>& contacts);

} // namespace pcl::segmentation
