// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A method to compare with, and its settings.

#pragma once

#include "labeled_cloud.h"

#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace peers {

/** \brief How much each point is an edge, or curved; NaN where that is not known. */
using Scores = std::vector<float>;

/** \brief One way to run a method. */
struct Setting {
  std::string text; ///< what is set, for the report
  std::function<Scores(const LabeledCloud&)> score;
};

/** \brief A method. It runs on one thread. */
struct Peer {
  std::string name;
  std::vector<Setting> settings; ///< the best one is reported
  /** The score from which a point is an edge or curved. Without it the best one of all
   * clouds together is taken. */
  std::optional<float> threshold;
};

/** \brief This library and the paper's method, nothing to choose. */
std::vector<Peer> ownEdges();
std::vector<Peer> ownSurfaces();

/** \brief What others offer for edges. \param[in] radii meters, to choose from
 * \param[in] neighbors likewise, for the k nearest points */
std::vector<Peer> edgePeers(const std::vector<double>& radii,
                            const std::vector<int>& neighbors);

/** \brief What others offer to tell curved from planar points. */
std::vector<Peer> surfacePeers(const std::vector<double>& radii);

/** \brief The ones of surfacePeers() that look for whole surfaces. */
std::vector<Peer> regionPeers();

/** \brief CGAL's Voronoi covariance measure. */
Peer voronoiPeer(const std::vector<double>& radii);

} // namespace peers
