// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A machined part: its faces, its creases and its smooth seams.

#pragma once

#include "scene/parts/part_face.h"

#include <memory>
#include <vector>

namespace pcl::scene {

/** \brief A line where a face continues smoothly into one of another curvature. */
struct Seam {
  Curve line;
  double radius = 0.0; /**< the smaller radius of curvature of the two */
};

/** \brief A closed body of level faces and walls around outlines, as a mill makes it.
 * Frame: x and y as the outlines', z up, the lowest face at 0. */
class Part {
public:
  /** \brief A wall around a loop. It joins level faces where its section begins and
   * ends. Round pieces need a loop without sharp corners.
   * \param[in] section pieces one after the other, upwards where the loop encloses
   * material, downwards where it encloses a hole */
  void addWall(const Loop& loop, const std::vector<SectionPiece>& section);

  void addLevel(double height,
                bool faces_up,
                const Outline& outer,
                const std::vector<Outline>& holes);

  const std::vector<std::shared_ptr<const PartFace>>&
  faces() const
  {
    return faces_;
  }

  /** \brief Lines where two faces meet at an angle. */
  const std::vector<Curve>&
  creases() const
  {
    return creases_;
  }

  const std::vector<Seam>&
  seams() const
  {
    return seams_;
  }

  double area() const;

  /** \brief The first face that a ray meets, in the part's frame; face -1 is none. */
  Hit intersect(const Ray& ray) const;

  /** \brief How near the next surface is to a point of a face, along its normal: the
   * thickness of the part there, or the width of a slot. */
  double thickness(const Vec3& p, const Vec3& normal) const;

  /** \brief Around all of it. */
  Sphere bounds() const;

private:
  void addSection(const Stroke& stroke, const std::vector<SectionPiece>& section);
  void
  addJoint(const Stroke& stroke, const SectionPiece* before, const SectionPiece* after);
  void addBegin(const Stroke& before, const Stroke& stroke, const SectionPiece& piece);

  std::vector<std::shared_ptr<const PartFace>> faces_;
  std::vector<Curve> creases_;
  std::vector<Seam> seams_;
};

/** \brief The random numbers of the shape of a part that is alone. */
constexpr std::uint64_t part_stream = 20;

/** \brief A plate, block, disc or profile with what a mill and a drill make of it:
 * pockets, holes, ribs, bosses, steps, letters, chamfers, fillets and thin walls, from
 * above and sometimes from below. The middle of its plan is at x = y = 0.
 * \param[in] size meters, about its longest side */
Part randomPart(double size, Random& random);

} // namespace pcl::scene
