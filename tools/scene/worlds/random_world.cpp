// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A camera above a table or a bin, and objects put on it: alone, on, against or in each
// other.

#include "scene/worlds/random_world.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace pcl::scene {
namespace {

/** \brief The ground, z = 0, where objects' centers may be: ahead (+y) of a camera at
 * x = y = 0, in its field of view. Meters. */
struct Ground {
  double near = 0.42, far = 0.92; /**< y */
  double spread = 0.4;            /**< |x| <= spread * y */
  double half_width = 0.34;       /**< |x| <= half_width */
};

/** The middle of where objects may be. */
Vec3
middleOf(const Ground& ground)
{
  return {0.0, 0.5 * (ground.near + ground.far), 0.0};
}

/** Over a table it is 0.55 to 0.66 m high and looks 35 to 45 degrees down; over a bin
 * it is 0.85 to 1.1 m high and looks 70 to 90 degrees down, at the middle. */
Camera
randomCamera(const SceneOptions& options, Random& random)
{
  constexpr double focal_at_640 = 525.0;
  Camera camera;
  camera.width = options.width;
  camera.height = options.height;
  camera.focal = focal_at_640 * options.width / 640.0;
  const UnitVector tilt = fromTurns(
      (options.in_bin ? random.uniform(70.0, 90.0) : random.uniform(35.0, 45.0)) /
      360.0);
  const UnitVector roll = fromTurns(random.uniform(-2.0, 2.0) / 360.0);
  const Vec3 right{1.0, 0.0, 0.0};
  const Vec3 down{0.0, -tilt.sine, -tilt.cosine};
  camera.pose.axes = {{right * roll.cosine + down * roll.sine,
                       down * roll.cosine - right * roll.sine,
                       {0.0, tilt.cosine, -tilt.sine}}};
  if (options.in_bin) {
    const double height = random.uniform(0.85, 1.1);
    camera.pose.origin =
        middleOf(Ground{}) + Vec3{0.0, -height * tilt.cosine / tilt.sine, height};
  }
  else
    camera.pose.origin = {0.0, 0.0, random.uniform(0.55, 0.66)};
  return camera;
}

/** Walk around the middle of where objects may be, looking at the same things. */
void
turnAround(const Ground& ground, double degrees, Camera& camera)
{
  const Vec3 middle = middleOf(ground);
  const UnitVector turn = fromTurns(degrees / 360.0);
  const auto turned = [&](const Vec3& v) {
    return Vec3{
        turn.cosine * v.x - turn.sine * v.y, turn.sine * v.x + turn.cosine * v.y, v.z};
  };
  camera.pose.origin = middle + turned(camera.pose.origin - middle);
  for (Vec3& axis : camera.pose.axes)
    axis = turned(axis);
}

Table
randomTable(Random& random)
{
  Table table;
  const UnitVector turn = fromTurns(random.uniform(-5.0, 5.0) / 360.0);
  table.along = {turn.cosine, turn.sine, 0.0};
  table.across = {-turn.sine, turn.cosine, 0.0};
  table.half_length = random.uniform(0.46, 0.54);
  table.half_width = random.uniform(0.56, 0.68);
  table.center = {random.uniform(-0.06, 0.06), 0.15 + table.half_width, 0.0};
  return table;
}

Solid
box(const Vec3& center, const Vec3& size)
{
  Solid solid;
  solid.size = {size.x, size.y, size.z};
  solid.pose.origin = center;
  return solid;
}

/** \brief A bin around where objects may be: its bottom, its walls, and the floor. */
struct Bin {
  Table bottom;
  std::vector<Solid> others;
};

/** As large as the picture, on a floor that is larger. */
Bin
randomBin(Random& random)
{
  constexpr double thickness = 0.01, floor_width = 4.0;
  Bin bin;
  bin.bottom.center = middleOf(Ground{});
  // An object's middle is on the ground, and it reaches .15 m from there.
  bin.bottom.half_length = random.uniform(0.49, 0.52);
  bin.bottom.half_width = random.uniform(0.4, 0.42);
  const double height = random.uniform(0.08, 0.25);
  const double x = bin.bottom.half_length + 0.5 * thickness;
  const double y = bin.bottom.half_width + 0.5 * thickness;
  for (const double side : {-1.0, 1.0}) {
    bin.others.push_back(box(bin.bottom.center + Vec3{side * x, 0.0, 0.5 * height},
                             {thickness, 2.0 * y + thickness, height}));
    bin.others.push_back(box(bin.bottom.center + Vec3{0.0, side * y, 0.5 * height},
                             {2.0 * x - thickness, thickness, height}));
  }
  const double depth = random.uniform(0.2, 0.8);
  bin.others.push_back(box(bin.bottom.center - Vec3{0.0, 0.0, depth + 0.5 * thickness},
                           {floor_width, floor_width, thickness}));
  return bin;
}

constexpr double clearance = 0.006;   // meters between objects that do not touch
constexpr double max_top = 0.32;      // meters; higher the camera would not see it
constexpr double stacked_scale = 0.8; // objects on others are smaller

bool
widestAtCommonHeight(const Body& a, const Body& b)
{
  return std::max(a.widest_low, b.widest_low) <= std::min(a.widest_high, b.widest_high);
}

class Layout {
public:
  Layout(const Ground& ground, double scale, Random& random)
  : ground_(ground)
  , scale_(scale)
  , random_(random)
  {}

  /** \brief Put an object of this kind somewhere.
   * \param[in] any_kind the kinds are mixed: put it against others if too few touch
   * \return false if no room was found */
  bool
  add(Shape shape, bool any_kind)
  {
    constexpr int attempts = 200;
    const bool is_first = bodies_.empty();
    const bool must_touch =
        any_kind && !is_first && 10 * countTouching() < 4 * bodies_.size() + 4;
    // Footprints of parts are larger than the parts: they would not really touch.
    const bool in_contact =
        (must_touch || (!is_first && random_.chance(0.5))) && shape != Shape::Part;
    const bool stack = any_kind && shape == Shape::Box && !is_first &&
                       std::none_of(bodies_.begin(), bodies_.end(), [](const Body& b) {
                         return b.low > 0.0;
                       });
    for (int attempt = 0; attempt < attempts; ++attempt) {
      std::optional<Body> body;
      if (stack && attempt < attempts / 4)
        body = onTop(shape);
      else if (in_contact && (any_kind || attempt < attempts / 2))
        body = inContact(shape);
      else
        body = alone(shape);
      if (!body || !fits(*body))
        continue;
      for (const std::size_t other : body->touches)
        bodies_[other].touches.push_back(bodies_.size());
      bodies_.push_back(std::move(*body));
      return true;
    }
    return false;
  }

  const std::vector<Body>&
  bodies() const
  {
    return bodies_;
  }

  /** \brief How many objects touch another one (the table does not count). */
  std::size_t
  countTouching() const
  {
    return static_cast<std::size_t>(
        std::count_if(bodies_.begin(), bodies_.end(), [](const Body& b) {
          return !b.touches.empty();
        }));
  }

private:
  Body
  alone(Shape shape)
  {
    const Body body = randomBody(shape, scale_, randomHeading(random_), random_);
    const double y = random_.uniform(ground_.near, ground_.far);
    const double x = y * ground_.spread * random_.uniform(-1.0, 1.0);
    return moved(body, {x, y, 0.0});
  }

  std::optional<Body>
  onTop(Shape shape)
  {
    const std::size_t index = randomIndex();
    const Body& carrier = bodies_[index];
    if (!carrier.carries)
      return {};
    Body body =
        randomBody(shape, stacked_scale * scale_, randomHeading(random_), random_);
    const bool round = carrier.solid.shape == Shape::Cylinder;
    const double length = round ? 1.2 * carrier.solid.size[0] : carrier.solid.size[0];
    const double width = round ? length : carrier.solid.size[1];
    const double along = 0.25 * length * random_.uniform(-1.0, 1.0);
    const double across = 0.25 * width * random_.uniform(-1.0, 1.0);
    const auto& axes = carrier.solid.pose.axes;
    body = moved(body, carrier.topCenter() + (axes[0] * along + axes[1] * across));
    body.touches = {index};
    return body;
  }

  std::optional<Body>
  beside(Shape shape)
  {
    const std::size_t index = randomIndex();
    const Body& partner = bodies_[index];
    if (partner.low != 0.0)
      return {};
    Body body;
    if (shape == Shape::Box && partner.solid.shape == Shape::Box && random_.chance(0.5))
      body = besideFlush(partner);
    else {
      body = moved(randomBody(shape, scale_, randomHeading(random_), random_),
                   partner.center);
      const Vec3 direction = randomHeading(random_);
      body = moved(body,
                   direction *
                       slideToContact(body.footprint, direction, partner.footprint));
    }
    if (!widestAtCommonHeight(body, partner))
      return {};
    body.touches = {index};
    return body;
  }

  Body
  besideFlush(const Body& partner)
  {
    const Vec3& along = partner.solid.pose.axes[0];
    const Vec3& across = partner.solid.pose.axes[1];
    const Body box = randomBody(Shape::Box, scale_, along, random_);
    const double shift = 0.3 * partner.solid.size[1] * random_.uniform(-1.0, 1.0);
    const Vec3 away = random_.chance(0.5) ? along : -along;
    const Body inside = moved(box, partner.center + across * shift);
    return moved(inside,
                 away * slideToContact(inside.footprint, away, partner.footprint));
  }

  std::optional<Body>
  leaning()
  {
    const std::size_t index = randomIndex();
    const Body& support = bodies_[index];
    const bool suitable = support.solid.shape == Shape::Box && support.carries &&
                          support.low == 0.0 && support.high >= 0.05 * scale_;
    if (!suitable)
      return {};
    const Vec3& axis = support.solid.pose.axes[random_.below(2)];
    const bool to_the_camera = random_.chance(0.75);
    const Vec3 outward = (axis.y < 0.0) == to_the_camera ? axis : -axis;
    Body body = randomLeaningBox(support, outward, scale_, random_);
    body.touches = {index};
    return body;
  }

  std::optional<Body>
  inBowl()
  {
    const std::size_t index = randomIndex();
    const Body& bowl = bodies_[index];
    const bool occupied =
        std::any_of(bodies_.begin(), bodies_.end(), [&](const Body& body) {
          return body.low > bowl.low && body.isTouching(index);
        });
    if (!bowl.open || occupied)
      return {};
    Body body = randomBallInBowl(bowl, random_);
    body.touches = {index};
    return body;
  }

  std::optional<Body>
  inContact(Shape shape)
  {
    switch (random_.below(4)) {
    case 0:
      if (shape == Shape::Box)
        return leaning();
      return shape == Shape::Sphere ? inBowl() : beside(shape);
    case 1:
      return onTop(shape);
    default:
      return beside(shape);
    }
  }

  bool
  fits(const Body& body) const
  {
    const Vec3& center = body.center;
    if (center.y < ground_.near || center.y > ground_.far || body.high > max_top ||
        std::abs(center.x) > std::min(ground_.half_width, ground_.spread * center.y))
      return false;
    for (std::size_t i = 0; i < bodies_.size(); ++i) {
      const Body& other = bodies_[i];
      const bool at_other_heights = body.low >= other.high || body.high <= other.low;
      if (!at_other_heights && !body.isTouching(i) &&
          distance(body.footprint, other.footprint) < clearance)
        return false;
    }
    return true;
  }

  std::size_t
  randomIndex()
  {
    return random_.below(static_cast<unsigned>(bodies_.size()));
  }

  Ground ground_;
  double scale_;
  Random& random_;
  std::vector<Body> bodies_;
};

/** \brief Put `count` objects on the ground, one after the other. Where it is too small
 * for them they become smaller.
 * \param[in] kinds in turn; none: all, so that at least 30 % of the objects touch
 * another one (if there are two or more) */
std::vector<Body>
randomLayout(const Ground& ground,
             unsigned count,
             const std::vector<Shape>& kinds,
             Random& random)
{
  const bool any_kind = kinds.empty();
  const std::vector<Shape> mixed{Shape::Box,
                                 Shape::Box,
                                 Shape::Cylinder,
                                 Shape::Sphere,
                                 Shape::Bowl,
                                 Shape::Box,
                                 Shape::Cylinder,
                                 Shape::Cone};
  const std::vector<Shape>& shapes = any_kind ? mixed : kinds;
  for (double scale = 1.0;; scale *= 0.95) {
    Layout layout(ground, scale, random);
    unsigned added = 0;
    while (added < count && layout.add(shapes[added % shapes.size()], any_kind))
      ++added;
    const bool enough_touch =
        !any_kind || count < 2 || 10 * layout.countTouching() >= 3 * count;
    if (added == count && enough_touch)
      return layout.bodies();
  }
}

} // namespace

RandomWorld
randomWorld(const SceneOptions& options)
{
  constexpr std::uint64_t placing_stream = 1;
  Random random(options.seed, placing_stream);
  RandomWorld result;
  result.world.camera = randomCamera(options, random);
  std::vector<Solid> others;
  if (options.in_bin) {
    Bin bin = randomBin(random);
    result.world.table = bin.bottom;
    others = std::move(bin.others);
  }
  else
    result.world.table = randomTable(random);
  result.bodies = randomLayout(Ground{}, options.objects, options.shapes, random);
  if (options.turn != 0.0)
    turnAround(Ground{}, options.turn, result.world.camera);
  for (const auto& body : result.bodies)
    result.world.solids.push_back(body.solid);
  result.world.solids.insert(result.world.solids.end(), others.begin(), others.end());
  return result;
}

} // namespace pcl::scene
