// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Closed outlines of straight lines and arcs, as a milling cutter follows them.

#pragma once

#include "scene/curve.h"
#include "scene/vec.h"

#include <vector>

namespace pcl::scene {

/** \brief One line or arc of a loop, in the plane z = 0. What the loop encloses is on
 * its left. A depth is how far inside the loop a parallel of the element runs. */
class Stroke {
public:
  /** \param[in] begin_slope, end_slope by how much a parallel is shorter at that end,
   * per depth: the tangent of half the angle of a sharp corner, or 0 */
  static Stroke
  line(const Vec3& begin, const Vec3& end, double begin_slope, double end_slope);

  /** \brief Turns left if `to` is more than `from`, both in turns; at most half a turn
   * or a whole one. */
  static Stroke arc(const Vec3& center, double radius, double from, double to);

  /** \brief A point of a parallel, from 0 at its begin to 1 at its end. */
  Vec3 point(double along, double depth) const;

  /** \brief Unit, to the right, out of the loop. */
  Vec3 outward(double along) const;

  /** \brief How far a position is inside, seen from this stroke. */
  double depthOf(const Vec3& p) const;

  /** \brief Unit, out of the loop, where the stroke is nearest to a position. */
  Vec3 outwardAt(const Vec3& p) const;

  /** \brief Whether the parallel through a position passes it between its ends. */
  bool spans(const Vec3& p, double tolerance) const;

  double length(double depth) const;

  /** \brief Of the parallel at a depth, lifted to a height. */
  Curve curve(double depth, double height) const;

  /** \brief Radius of a parallel, positive where the loop turns left; 0 if straight. */
  double radius(double depth) const;

  /** \brief Whether it starts at a sharp corner. */
  bool
  isSharpAtBegin() const
  {
    return begin_slope_ != 0.0;
  }

  bool
  isWholeCircle() const
  {
    return round_ && (to_ - from_ >= 1.0 || from_ - to_ >= 1.0);
  }

  /** \brief Twice the area between it and the origin. */
  double doubleArea(double depth) const;

  /** \brief How many times a parallel crosses the ray from p to +x. */
  int crossings(const Vec3& p, double depth) const;

private:
  bool round_ = false;
  Vec3 begin_, end_, along_; // of a line
  double begin_slope_ = 0.0, end_slope_ = 0.0;
  Vec3 center_; // of an arc
  double radius_ = 0.0, from_ = 0.0, to_ = 0.0;
};

/** \brief A closed outline without self-intersections, counter-clockwise. */
class Loop {
public:
  /** \brief A polygon, counter-clockwise, whose corners are rounded by a radius in
   * meters each; 0 leaves a corner sharp. */
  static Loop polygon(const std::vector<Vec3>& corners,
                      const std::vector<double>& corner_radii);

  static Loop circle(const Vec3& center, double radius);

  const std::vector<Stroke>&
  strokes() const
  {
    return strokes_;
  }

  /** \brief True if a position is inside the parallel at this depth. */
  bool contains(const Vec3& p, double depth) const;

  /** \brief Enclosed by the parallel at this depth. */
  double area(double depth) const;

  /** \brief Distance from a position to the parallel at this depth. */
  double distance(const Vec3& p, double depth) const;

  bool hasSharpCorners() const;

private:
  std::vector<Stroke> strokes_;
};

} // namespace pcl::scene
