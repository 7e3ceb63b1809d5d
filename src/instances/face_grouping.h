// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Faces grouped to bodies, and the supports that bodies stand on.

#pragma once

#include "instances/face_contacts.h"

namespace pcl::segmentation {

/** \brief Which faces belong to a support: those that are known; planar ones, not much
 * smaller than the largest such face, with others on them; and pieces that lie in the
 * same plane. */
std::vector<char> supportsAmong(const detail::InstanceInput& input,
                                const Labels& labels,
                                const std::vector<Face>& faces,
                                const std::vector<char>& known,
                                const std::vector<FaceContact>& contacts);

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
