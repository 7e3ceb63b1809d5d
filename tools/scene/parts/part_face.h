// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// The faces of a machined part: level ones, and strips around an outline.

#pragma once

#include "scene/parts/loop.h"
#include "scene/random.h"

#include <functional>
#include <memory>
#include <vector>

namespace pcl::scene {

/** \brief A place in the section of a wall: how far inside the outline, how high. */
struct SectionPoint {
  double depth = 0.0, height = 0.0;
};

/** \brief How a piece of a section runs: straight, or along a quarter of a circle that
 * begins upright and ends level, or the other way round. */
enum class Bend { Straight, FromUpright, FromLevel };

/** \brief A piece of the section of a wall. Material is on its right when depth points
 * to the right and height upwards. */
struct SectionPiece {
  SectionPoint begin, end;
  Bend bend = Bend::Straight;

  /** \brief Unit, along the piece at its begin or end. */
  SectionPoint beginTangent() const;
  SectionPoint endTangent() const;

  /** \brief Signed, to the line or circle that it is part of. */
  double distance(const SectionPoint& p) const;

  /** \brief True if the nearest place of that line or circle is on the piece. */
  bool spans(const SectionPoint& p, double tolerance) const;

  /** \brief Unit, out of the material; p is on the piece. */
  SectionPoint normal(const SectionPoint& p) const;

  SectionPoint point(double along) const;
  double length() const;
  double meanDepth() const;

  /** \brief Of the quarter of a circle; 0 if it is straight. */
  double radius() const;
};

/** \brief Axis-aligned. */
struct Box3 {
  Vec3 low, high;
};

/** \brief A face of a part, in the part's frame. */
class PartFace {
public:
  PartFace(const Box3& bounds, bool is_flat) : bounds_(bounds), is_flat_(is_flat) {}
  virtual ~PartFace() = default;
  PartFace(const PartFace&) = delete;
  PartFace& operator=(const PartFace&) = delete;

  const Box3&
  bounds() const
  {
    return bounds_;
  }

  /** \brief Calls for each t > 0 at which a ray meets it. */
  virtual void meet(const Ray& ray, const std::function<void(double)>& found) const = 0;

  virtual bool isAt(const Vec3& p, double tolerance) const = 0;

  /** \brief Unit, outwards; p is on the face. */
  virtual Vec3 normal(const Vec3& p) const = 0;

  /** \brief The smaller radius of curvature at a point of it, infinite if flat. */
  virtual double radius(const Vec3& p) const = 0;

  bool
  isFlat() const
  {
    return is_flat_;
  }

  virtual double area() const = 0;

  /** \brief A point on it, each piece of its surface equally likely. */
  virtual Vec3 randomPoint(Random& random) const = 0;

private:
  Box3 bounds_;
  bool is_flat_;
};

/** \brief A parallel of a loop. */
struct Outline {
  Loop loop;
  double depth = 0.0;
};

/** \brief A level face, inside one outline and outside others. */
std::shared_ptr<const PartFace> levelFace(double height,
                                          bool faces_up,
                                          const Outline& outer,
                                          const std::vector<Outline>& holes);

/** \brief A piece of a section that is moved along a stroke: part of a plane, of a
 * cylinder, of a cone or of a torus. */
std::shared_ptr<const PartFace> stripFace(const Stroke& stroke,
                                          const SectionPiece& piece);

} // namespace pcl::scene
