// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "scene/body.h"

#include <optional>

namespace pcl::scene {

/** \brief The ground, z = 0, where objects' centres may be: ahead (+y) of a camera at
 * x = y = 0, in its field of view. Metres. */
struct Ground {
  double near = 0.42, far = 0.92; /**< y */
  double spread = 0.4;            /**< |x| <= spread * y */
  double half_width = 0.34;       /**< |x| <= half_width */
};

/** \brief Objects put on a table one after the other: alone, on another, against
 * another, leaning, in a bowl. They never overlap. */
class Layout {
public:
  Layout(const Ground& ground, double scale, Random& random);

  /** \brief Put an object of this kind somewhere, against others if too few touch.
   * \return false if no room was found */
  bool add(Shape shape);

  /** \brief The same where not every kind can touch another: every other object is put
   * against others if that is possible. */
  bool addWherePossible(Shape shape);

  const std::vector<Body>&
  bodies() const
  {
    return bodies_;
  }

  /** \brief How many objects touch another one (the table does not count). */
  std::size_t countTouching() const;

private:
  using Candidate = std::optional<Body>;

  Candidate alone(Shape shape);

  Candidate onTop(Shape shape);

  Candidate beside(Shape shape);

  Candidate besideFlush(const Body& partner);

  Candidate leaning();

  Candidate inBowl();

  Candidate inContact(Shape shape);

  bool fits(const Body& body) const;

  void insert(Body body);

  std::size_t randomIndex();

  Point2 randomHeading();

  Ground ground_;
  double scale_;
  Random& random_;
  std::vector<Body> bodies_;
};

/** \brief Put `count` objects on the ground. Where it is too small for them they become
 * smaller.
 * \param[in] kinds in turn; none: all, so that at least 30 % of the objects touch
 * another one (if there are two or more) */
std::vector<Body> randomLayout(const Ground& ground,
                               unsigned count,
                               const std::vector<Shape>& kinds,
                               Random& random);

} // namespace pcl::scene
