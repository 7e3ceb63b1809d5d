/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/cloud_numbers.h>
#include <pcl/segmentation/shape_field.h>

#include <array>
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

namespace pcl {

/** \brief The points of one face in one small cell of space. \ingroup segmentation */
struct FacePiece {
  std::array<float, 3> first{};    ///< one of its points: no other piece has it
  std::array<float, 3> position{}; ///< the mean of its points
  std::array<float, 3> normal{};   ///< unit, of either sign
  float count = 0.0f;              ///< of points
  float spacing = 0.0f;            ///< of the points, mean
  std::array<float, 9> scatter{};  ///< sum of products about the mean
};

/** \brief Pieces of faces, and which of them follow each other on a face. */
struct LinkedPieces {
  std::vector<FacePiece> pieces; ///< of the part
  /** \brief The first points of pieces of other parts: they are numbered after these.
   */
  std::vector<std::array<float, 3>> others;
  std::vector<std::uint32_t> link_begins; ///< of each piece in links, and the end
  std::vector<std::uint32_t> links;       ///< numbers of pieces
};

/** \brief What a part of a cloud knows of its own places. */
struct PartOfFaces {
  static constexpr std::uint32_t none = 0xffffffffU; ///< no piece

  LinkedPieces linked; ///< the pieces whose first points are the part's own
  std::vector<std::uint32_t> piece_of_place; ///< or none: it is on no face
  std::vector<float> of_model; ///< how much its INAD says for curved; NaN unknown
};

/** \brief The smallest pieces of faces of a part of a cloud.
 * \param[in] edges of the part's places, see ShapeFieldEstimation::setCloudNumbers():
 * those within CloudReach::faces of its own places must be among them
 * \param[in] numbers of the whole cloud \param[in] is_own which of the places are the
 * part's own; those of all parts are the cloud
 * \param[in] threads 0 for all cores
 * \throws std::invalid_argument if the spacing of the cloud is 0 */
PCL_SHAPE_EXPORTS PartOfFaces facesOfPart(const ShapeField& edges,
                                          const CloudNumbers& numbers,
                                          const std::vector<bool>& is_own,
                                          unsigned threads);

/** \brief The faces around a part of a cloud, from the pieces of parts.
 *
 * Surfaces look some hundred spacings far. So far pieces are enough, of which there are
 * much fewer than points. */
class PCL_SHAPE_EXPORTS FacesAround {
public:
  /** \brief How many sizes of windows the faces are looked at with. */
  static constexpr std::size_t levels = 5;

  /** \brief For each level the noise of the whole cloud, meters. */
  using Noise = std::array<float, levels>;

  /** \brief The box that holds places; by default of none. */
  struct Box {
    std::array<float, 3> low{far, far, far};     ///< least x, y and z, meters
    std::array<float, 3> high{-far, -far, -far}; ///< largest x, y and z, meters

    /** \param[in] places three coordinates each; those that are not finite are left out
     */
    PCL_SHAPE_EXPORTS static Box of(const XYZView& places);

  private:
    static constexpr float far = std::numeric_limits<float>::infinity();
  };

  /** \brief The part and the numbers are not copied: they must outlive this.
   * \param[in] own of the part \param[in] box of the part's own places
   * \param[in] numbers of the whole cloud \param[in] threads 0 for all cores */
  FacesAround(const PartOfFaces& own,
              const Box& box,
              const CloudNumbers& numbers,
              unsigned threads);
  ~FacesAround();
  FacesAround(const FacesAround&) = delete;
  FacesAround& operator=(const FacesAround&) = delete;

  /** \brief Add what is near of another part: of all that have places within
   * CloudReach::surfaces of the part's own along each axis. */
  void add(const LinkedPieces& other);

  /** \brief How a window of the part's own pieces bends. */
  struct Window {
    std::uint32_t node = 0;     ///< in its middle, of those of the level
    float residual = 0.0f;      ///< of its nodes from a quadric, r.m.s., meters
    float freedom = 0.0f;       ///< degrees of freedom of that
    float half_width = 0.0f;    ///< in the direction in which it bends, meters
    float bulge = 0.0f;         ///< of the quadric out of a plane there, meters
    float bulge_error = 0.0f;   ///< standard error of that, meters
    float inliers = 0.0f;       ///< share of the nodes that count
    float center_offset = 0.0f; ///< of its middle from the quadric, meters
    float center_cosine = 0.0f; ///< of the angle between their normals
  };

  /** \brief The windows of one level. */
  struct LevelWindows {
    std::uint64_t nodes = 0;     ///< how many the level has, of the part and around it
    std::vector<Window> windows; ///< of the part's own nodes
  };

  /** \brief Those of each level. */
  using Windows = std::array<LevelWindows, levels>;

  /** \brief The windows of the part's own pieces. The noise of the cloud follows from
   * the residuals of all parts, see rankOfNoise(). */
  Windows windows() const;

  /** \brief For each class of ShapeModel::defaultSurfaces() the posterior of each of
   * the part's own places; NaN unknown.
   * \param[in] places the part's own, in the order of PartOfFaces::piece_of_place
   * \param[in] noise of the cloud \param[in] windows those of windows(), which are not
   * found again: of this object, or of another one with the same part, the same box and
   * the same other parts, as they name nodes by their numbers
   * \throws std::invalid_argument if there are more or fewer places than the part has,
   * or if windows are of another number of nodes */
  std::vector<std::vector<float>>
  likelihoods(const XYZView& places, const Noise& noise, const Windows& windows) const;

  /** \brief The noise of a cloud is the residual of all parts that so many others are
   * below; it is 0 if there is none. \param[in] residuals how many all parts have */
  static std::uint64_t rankOfNoise(std::uint64_t residuals);

private:
  struct State;
  std::unique_ptr<State> state_;
};

} // namespace pcl
