// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Points all over a machined part, evenly or at random, with the truth about each.

#pragma once

#include "scene/creases.h"
#include "scene/parts/part.h"
#include "scene/scene.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace pcl::scene {

/** \brief How points are spread over surfaces. */
enum class Spread {
  Even,  /**< no two nearer than 3/4 of the spacing */
  Random /**< each independent of the others */
};

struct PartOptions {
  std::uint64_t seed = 1;
  double size = 0.1; /**< meters, about the longest side, 0.01 to 1 */
  double spacing =
      0.001; /**< meters, sqrt(area / points), 1/1000 to 1/10 of the size */
  Spread spread = Spread::Even;
  double sigma = 0.0; /**< meters of white noise in each coordinate, 0 to 0.1 */
};

/** \brief A part that is sampled all around, in its own frame. The scene is a list
 * (height 1) of one object, whose labels follow the spacing s. Lengths are those of the
 * exact points. */
struct PartSamples {
  /** edge: within 1.5 s of a crease; void up to 3 s, and on fillets whose radius is
   * less than 10 s or within 3 s of them. surface: planar or curved, also beside
   * creases; void on flat faces within 4 s of where they go over into round ones, and
   * where a curve is so wide that it turns by less than 5 degrees within 4 s. */
  Scene scene;
  std::vector<float> crease_s; /**< distance to the nearest crease, in spacings */
  std::vector<float> radius_s; /**< smaller radius of curvature, 1e6 if flat */
  std::vector<float> thin_s;   /**< to the next surface along the normal, through the
                                  part or across a slot */
};

/** \brief Sample a random part; the options are checked. */
PartSamples samplePart(const PartOptions& options);

/** \brief The same of a part that is given; options.size is not used. */
PartSamples samplePart(const Part& part, const PartOptions& options);

/** \throws std::invalid_argument that names the parameter, its value and what it must
 * be */
void checkPartOptions(const PartOptions& options);

/** \brief A point of a part, exact. */
struct SurfacePoint {
  Vec3 point;
  std::size_t face; /**< its index in the part */
};

/** \brief Points spread over all faces, as many for each piece of surface. */
std::vector<SurfacePoint> spreadPoints(const Part& part, const PartOptions& options);

/** \brief Says what PartSamples says of points of a part. */
class PartTruth {
public:
  explicit PartTruth(const Part& part);

  /** \brief Add all but the coordinates of a point.
   * \param[in] spacing of the points around it */
  void add(const SurfacePoint& at, double spacing, PartSamples& samples) const;

private:
  bool isNearTightCurve(const Vec3& p, double spacing) const;
  Surface surfaceOf(const SurfacePoint& at,
                    const Vec3& normal,
                    double radius_s,
                    double spacing) const;

  const Part& part_;
  World world_;
  Creases creases_;
  ThinPlaces seams_;
};

} // namespace pcl::scene
