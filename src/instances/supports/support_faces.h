// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Which faces are supports, or patches of them.

#pragma once

#include "instances/faces/face_contacts.h"
#include "instances/supports/support_planes.h"

#include <vector>

namespace pcl::segmentation {

/** \brief Which faces are patches of a support: no higher than its ripple, and not far
 * behind it, as where a lens bends it; and narrow ones on the rims of its walls.
 * \param[in] supports planes that carry things
 * \param[in] input the points
 * \param[in] face_of the face of each point, -1 none
 * \param[in] faces what is known of each face */
std::vector<char> patchesOf(const std::vector<Support>& supports,
                            const detail::InstanceInput& input,
                            const Labels& face_of,
                            const std::vector<Face>& faces);

/** \brief Which patch each point is of, of those that do not touch the support's own
 * plane; -1 of none.
 * \param[in] patches which faces are patches, by patchesOf()
 * \param[in] supports planes that carry things
 * \param[in] face_of the face of each point, -1 none
 * \param[in] contacts the borders of the faces
 * \param[in] grown_face_of the same with the points between the faces shared out */
Labels lonePatches(const std::vector<char>& patches,
                   const std::vector<Support>& supports,
                   const Labels& face_of,
                   const std::vector<FaceContact>& contacts,
                   const Labels& grown_face_of);

/** \brief Which faces belong to a support: those that are known; planar ones, not much
 * smaller than the largest such face, with others on them; and pieces that lie in the
 * same plane.
 * \param[in] input the points
 * \param[in] face_of the face of each point, -1 none
 * \param[in] faces what is known of each face
 * \param[in] known which faces are patches of supports
 * \param[in] contacts the borders of the faces */
std::vector<char> supportsAmong(const detail::InstanceInput& input,
                                const Labels& face_of,
                                const std::vector<Face>& faces,
                                const std::vector<char>& known,
                                const std::vector<FaceContact>& contacts);

} // namespace pcl::segmentation
