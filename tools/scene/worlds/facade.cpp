// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// House fronts: windows, arches, bays, moldings, pipes and steps.

#include "scene/parts/part.h"
#include "scene/random.h"
#include "scene/worlds/place.h"

namespace pcl::scene {

Solid
boxBetween(const Vec3& low, const Vec3& high)
{
  return {Shape::Box,
          {high.x - low.x, high.y - low.y, high.z - low.z},
          {Pose().axes, (low + high) * 0.5}};
}

Solid
extrusion(const std::vector<Vec3>& profile, const Pose& pose, double by)
{
  const Loop loop = Loop::polygon(profile, std::vector<double>(profile.size(), 0.0));
  auto part = std::make_shared<Part>();
  part->addWall(loop, {{{0.0, 0.0}, {0.0, by}}});
  part->addLevel(0.0, false, {loop}, {});
  part->addLevel(by, true, {loop}, {});
  return {Shape::Part, {}, pose, std::move(part)};
}

namespace {

constexpr std::uint64_t facade_stream = 32;
constexpr double wall = 0.3; // meters, the front's thickness
constexpr double scanner_height = 1.6;

std::vector<Vec3>
rectangle(double left, double right, double low, double high)
{
  return {{left, low}, {right, low}, {right, high}, {left, high}};
}

class Builder {
public:
  explicit Builder(std::uint64_t seed) : random_(seed, facade_stream) {}

  Place
  run()
  {
    floors_ = 2 + random_.below(3);
    floor_height_ = random_.uniform(2.8, 3.3);
    place_.length = random_.uniform(8.0, 14.0);
    place_.width = floors_ * floor_height_ + 0.4;
    columns_ = static_cast<unsigned>(place_.length / 2.0);
    column_width_ = place_.length / columns_;
    door_ = random_.below(columns_);
    bay_ = random_.chance(0.5) ? random_.below(columns_) : columns_; // or none
    addBox({-5.0, -14.0, -0.3}, {place_.length + 5.0, 1.0, 0.0});
    addFront();
    place_.shell = place_.world.solids.size();
    addSills();
    addMoldings();
    addSteps();
    addPorch();
    addPipe();
    addStations();
    return std::move(place_);
  }

private:
  void
  addBox(const Vec3& low, const Vec3& high)
  {
    place_.world.solids.push_back(boxBetween(low, high));
  }

  double
  middleOf(unsigned column) const
  {
    return (column + 0.5) * column_width_;
  }

  bool
  isWindow(unsigned column, unsigned floor) const
  {
    return (column != bay_ || floor == 0) && (column != door_ || floor > 0);
  }

  template <class Function>
  void
  forEachWindow(const Function& function) const
  {
    for (unsigned floor = 0; floor < floors_; ++floor)
      for (unsigned column = 0; column < columns_; ++column)
        if (isWindow(column, floor))
          function(middleOf(column), floor * floor_height_ + sill);
  }

  /** A recess or a bay of the front; negative is a recess. */
  void
  addRelief(const Loop& loop, double out)
  {
    front_.addWall(loop, {{{0.0, wall}, {0.0, wall + out}}});
    front_.addLevel(wall + out, true, {loop}, {});
    reliefs_.push_back({loop});
  }

  void
  addFront()
  {
    const double deep = random_.uniform(0.08, 0.2);
    const double width = random_.uniform(0.9, 1.3), height = random_.uniform(1.2, 1.6);
    window_width_ = width;
    const double arch = random_.chance(0.4) ? 0.49 * width : 0.0;
    const std::vector<double> rounded_above{0.0, 0.0, arch, arch};
    forEachWindow([&](double x, double z) {
      addRelief(
          Loop::polygon(rectangle(x - 0.5 * width, x + 0.5 * width, z, z + height),
                        rounded_above),
          -deep);
    });
    step_count_ = 1 + random_.below(3);
    const double threshold = step_count_ * rise + 0.01, x = middleOf(door_);
    canopy_ = threshold + door_height + 0.1;
    addRelief(
        Loop::polygon(rectangle(x - 0.55, x + 0.55, threshold, threshold + door_height),
                      rounded_above),
        -deep);
    if (bay_ < columns_)
      addBay();
    const Loop outline = Loop::polygon(rectangle(0.0, place_.length, 0.0, place_.width),
                                       {0.0, 0.0, 0.0, 0.0});
    front_.addWall(outline, {{{0.0, 0.0}, {0.0, wall}}});
    front_.addLevel(0.0, false, {outline}, {});
    front_.addLevel(wall, true, {outline}, reliefs_);
    // The part's z is against the world's y.
    const Pose pose{{{{1, 0, 0}, {0, 0, 1}, {0, -1, 0}}}, {0.0, wall, 0.0}};
    place_.world.solids.push_back(
        {Shape::Part, {}, pose, std::make_shared<Part>(front_)});
  }

  void
  addBay()
  {
    const double half = 0.4 * column_width_, x = middleOf(bay_);
    const double rounding = random_.uniform(0.1, 0.4);
    addRelief(
        Loop::polygon(
            rectangle(x - half, x + half, floor_height_ + 0.2, place_.width - 0.6),
            {rounding, rounding, rounding, rounding}),
        random_.uniform(0.3, 0.6));
  }

  void
  addSills()
  {
    const double out = random_.uniform(0.06, 0.12), half = 0.5 * window_width_ + 0.05;
    constexpr double thick = 0.05;
    forEachWindow([&](double x, double z) {
      addBox({x - half, -out, z - thick}, {x + half, 0.0, z});
    });
  }

  /** Between floors, where no bay is in the way. */
  void
  addMoldings()
  {
    if (bay_ < columns_)
      return;
    const double out = random_.uniform(0.04, 0.15), high = random_.uniform(0.08, 0.25);
    for (unsigned floor = 1; floor <= floors_; ++floor) {
      const double z = floor * floor_height_;
      addBox({0.3, -out, z}, {place_.length - 0.02, 0.0, z + high});
    }
  }

  void
  addSteps()
  {
    const double run = random_.uniform(0.26, 0.3);
    std::vector<Vec3> profile{{0.0, 0.0}, {step_count_ * run, 0.0}};
    for (unsigned i = 1; i <= step_count_; ++i) {
      profile.push_back({(step_count_ - i + 1) * run, i * rise});
      profile.push_back({(step_count_ - i) * run, i * rise});
    }
    constexpr double half = 0.7;
    const Pose pose{{{{0, -1, 0}, {0, 0, 1}, {-1, 0, 0}}},
                    {middleOf(door_) + half, 0.0, 0.0}};
    place_.world.solids.push_back(extrusion(profile, pose, 2.0 * half));
  }

  void
  addCylinder(const Vec3& base, double radius, double height)
  {
    place_.world.solids.push_back(
        {Shape::Cylinder, {radius, height, 0.0}, {Pose().axes, base}});
  }

  /** A canopy above the door on two round columns beside the steps. */
  void
  addPorch()
  {
    const double radius = random_.uniform(0.12, 0.22), x = middleOf(door_);
    constexpr double aside = 0.98, before = 0.7, half = 1.25, thick = 0.1;
    for (const double side : {-aside, aside})
      addCylinder({x + side, -before, 0.0}, radius, canopy_);
    addBox({x - half, -before - 0.3, canopy_}, {x + half, 0.0, canopy_ + thick});
  }

  /** Beside all moldings and sills. */
  void
  addPipe()
  {
    const double radius = random_.uniform(0.035, 0.05);
    addCylinder(
        {0.12, -radius - 0.04, 0.0}, radius, place_.width - random_.uniform(0.1, 0.3));
  }

  void
  addStations()
  {
    for (unsigned i = 0; i < max_stations; ++i) {
      // From one side to the other, so that all are apart
      const double share =
          ((i % 2) * 2 + i / 2 + random_.uniform(0.2, 0.8)) / max_stations;
      place_.stations.push_back(
          {share * place_.length, -random_.uniform(4.0, 9.0), scanner_height});
    }
  }

  static constexpr double rise = 0.17; // meters, a comfortable step
  static constexpr double sill = 0.9;  // meters above the floor
  static constexpr double door_height = 1.95;

  Random random_;
  Place place_;
  Part front_;
  std::vector<Outline> reliefs_;
  unsigned floors_ = 0, columns_ = 0, door_ = 0, bay_ = 0, step_count_ = 0;
  double floor_height_ = 0.0, column_width_ = 0.0, window_width_ = 0.0, canopy_ = 0.0;
};

} // namespace

Place
randomFacade(std::uint64_t seed)
{
  return Builder(seed).run();
}

} // namespace pcl::scene
