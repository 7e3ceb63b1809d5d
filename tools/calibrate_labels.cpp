// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fits the confidence of labels to generated scenes, see src/labels/label_weights.h.

#include "labels/label_evidence.h"
#include "scene/scene.h"
#include "scene/sensors/part_samples.h"
#include "scene/sensors/station_scan.h"
#include "scene/sensors/surface_samples.h"

#include <pcl/point_types.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <iostream>
#include <iterator>
#include <string>
#include <vector>

// Logistic regression. The weights go to standard output, how well the confidence then
// fits to standard error. Seeds from 400001 on are used for nothing else; the threshold
// is chosen on other seeds and sensors than the weights are.
namespace {

using namespace pcl;

constexpr std::uint32_t edge = 3; // after planar and curved
constexpr std::size_t features = std::tuple_size<detail::LabelFeatures>::value;
constexpr Eigen::Index terms = 1 + features; // a constant is the first
using Terms = Eigen::Matrix<double, terms, 1>;

/** A cloud and its truth: planar 1, curved 2, edge 3, left out 0. */
struct World {
  PointCloud<PointXYZ>::Ptr cloud = make_shared<PointCloud<PointXYZ>>();
  std::vector<std::uint32_t> truth;
};

struct Point {
  Terms values;
  std::uint32_t label, truth;
  double weight;
};

struct Example {
  const Point* point;
  double is_right;
};

using Examples = std::vector<Example>;

std::uint32_t
truthAt(const scene::Scene& scene, std::size_t i)
{
  if (scene.edge[i] == scene::EdgeCrease)
    return edge;
  const bool is_surface =
      scene.edge[i] == scene::EdgeNot && (scene.surface[i] == scene::SurfacePlanar ||
                                          scene.surface[i] == scene::SurfaceCurved);
  return is_surface ? scene.surface[i] : 0;
}

World
worldOf(const scene::Scene& scene)
{
  World world;
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    if (!std::isfinite(p[2]))
      continue;
    world.cloud->push_back(PointXYZ(p[0], p[1], p[2]));
    world.truth.push_back(truthAt(scene, i));
  }
  return world;
}

/** Without what one may call either way, as in doc/evaluation.md: thin walls, and
 * curves too sharp or too wide for the spacing. */
World
worldOf(const scene::PartSamples& part)
{
  constexpr float thin = 4.0f, beside_crease = 3.0f, sharp = 10.0f, wide = 40.0f;
  World world = worldOf(part.scene);
  for (std::size_t i = 0; i < world.truth.size(); ++i) {
    const float radius = part.radius_s[i];
    const bool is_curved = world.truth[i] == scene::SurfaceCurved;
    if (part.thin_s[i] < thin || (radius < sharp && part.crease_s[i] > beside_crease) ||
        (is_curved && (radius < sharp || radius > wide)))
      world.truth[i] = 0;
  }
  return world;
}

World
part(std::uint64_t seed, double spacing, double sigma_in_spacings, scene::Spread spread)
{
  scene::PartOptions options;
  options.seed = seed;
  options.spacing = spacing;
  options.spread = spread;
  options.sigma = sigma_in_spacings * spacing;
  return worldOf(scene::samplePart(options));
}

World
image(std::uint64_t seed,
      scene::Noise noise,
      double sigma = 0.0,
      std::vector<scene::Shape> shapes = {})
{
  scene::SceneOptions options;
  options.seed = seed;
  options.noise = noise;
  options.white_sigma = sigma;
  if (!shapes.empty())
    options.objects = 3; // larger ones than eight would be
  options.shapes = std::move(shapes);
  return worldOf(scene::generateScene(options));
}

World
samples(std::uint64_t seed, double spacing, double sigma)
{
  scene::SampleOptions options;
  options.seed = seed;
  options.objects = 8;
  options.spacing = spacing;
  options.sigma = sigma;
  return worldOf(scene::sampleScene(options));
}

World
room(std::uint64_t seed, unsigned stations)
{
  scene::StationOptions options;
  options.seed = seed;
  options.stations = stations;
  options.step = 0.5;
  return worldOf(scene::scanPlace(options));
}

/** The points whose label and truth are known. */
std::vector<Point>
pointsOf(const World& world)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(world.cloud);
  estimation.setNumberOfThreads(1); // worlds are computed beside each other
  ShapeField field;
  estimation.compute(field);
  const auto evidence = detail::labelEvidence({field, 1, scene::SurfacePlanar});
  std::vector<Point> points;
  for (std::size_t i = 0; i < world.truth.size(); ++i) {
    if (world.truth[i] == 0 || evidence.labels[i] == 0)
      continue;
    Point point{Terms(), evidence.labels[i], world.truth[i], 0.0};
    point.values[0] = 1.0;
    for (std::size_t f = 0; f < features; ++f)
      point.values[static_cast<Eigen::Index>(f) + 1] = evidence.features[i][f];
    points.push_back(point);
  }
  return points;
}

/** Some of each label, as many in the whole as a cloud with more of it: worlds count
 * the same, except where they have next to nothing of a label. */
void
addSome(const std::vector<Point>& points, std::vector<Point>& some)
{
  constexpr double few = 300.0;
  constexpr std::size_t most = 4000;
  for (std::uint32_t label = 1; label <= edge; ++label) {
    const auto has = [=](const Point& point) { return point.label == label; };
    const auto count =
        static_cast<std::size_t>(std::count_if(points.begin(), points.end(), has));
    const std::size_t step = count / most + 1;
    std::size_t at = 0;
    for (const Point& point : points) {
      if (!has(point) || at++ % step != 0)
        continue;
      some.push_back(point);
      some.back().weight =
          static_cast<double>(step) / (static_cast<double>(count) + few);
    }
  }
}

/** A world to be, and what it is called. */
struct Recipe {
  std::string name;
  std::function<World()> make;
};

/** The points of each. */
std::vector<std::vector<Point>>
pointsOf(const std::vector<Recipe>& recipes)
{
  std::vector<std::vector<Point>> points(recipes.size());
#pragma omp parallel for schedule(dynamic)
  for (std::ptrdiff_t i = 0; i < static_cast<std::ptrdiff_t>(recipes.size()); ++i) {
    const auto at = static_cast<std::size_t>(i);
    points[at] = pointsOf(recipes[at].make());
#pragma omp critical
    std::cerr << recipes[at].name << ": " << points[at].size() << " points\n";
  }
  return points;
}

const std::vector<scene::Shape> parts_only{scene::Shape::Part};

/** Even parts of 100 and 50 spacings with noise of 0 to .4 of them, and of 170 and 250,
 * whose curves are wider; images of tables and of parts on a table; samples of tables;
 * rooms. */
std::vector<Recipe>
trainingWorlds()
{
  using scene::Noise;
  std::vector<Recipe> recipes;
  std::uint64_t next = 400001;
  const auto add = [&](const char* name, auto make) {
    recipes.push_back({name, [make, seed = next++] { return make(seed); }});
  };
  const auto addPart = [&](double spacing, double sigma) {
    add("part", [=](std::uint64_t seed) {
      return part(seed, spacing, sigma, scene::Spread::Even);
    });
  };
  for (int round = 0; round < 3; ++round) {
    for (const double sigma : {0.0, 0.15, 0.3, 0.4})
      addPart(0.001, sigma);
    for (const double spacing : {0.002, 0.0006, 0.0004})
      addPart(spacing, 0.15 * round);
  }
  const auto addImage = [&](Noise noise,
                            double sigma,
                            std::vector<scene::Shape> shapes) {
    add("image", [=](std::uint64_t seed) { return image(seed, noise, sigma, shapes); });
  };
  for (int round = 0; round < 2; ++round) {
    addImage(Noise::Kinect, 0.0, {});
    addImage(Noise::None, 0.0, {});
    addImage(Noise::White, 0.001, {});
    addImage(Noise::White, 0.003, {});
    for (int k = 0; k < 2; ++k) {
      addImage(Noise::TimeOfFlight, 0.0, {});
      addImage(Noise::TimeOfFlight, 0.0, parts_only);
    }
    addImage(Noise::Kinect, 0.0, parts_only);
    add("samples", [](std::uint64_t seed) { return samples(seed, 0.003, 0.0003); });
    add("samples",
        [=](std::uint64_t seed) { return samples(seed, 0.0015, 0.0003 * round); });
    add("room", [](std::uint64_t seed) { return room(seed, 1); });
  }
  return recipes;
}

/** Other sensors, to choose from which confidence labels are kept. */
std::vector<Recipe>
choosingWorlds()
{
  using scene::Noise;
  const auto randomPart = [](std::uint64_t seed, double sigma) {
    return part(seed, 0.001, sigma, scene::Spread::Random);
  };
  return {{"random part, .15 s", [=] { return randomPart(450001, 0.15); }},
          {"random part, .30 s", [=] { return randomPart(450002, 0.3); }},
          {"random part, .15 s", [=] { return randomPart(450003, 0.15); }},
          {"table, structured light", [] { return image(450004, Noise::Structured); }},
          {"parts, structured light",
           [] { return image(450005, Noise::Structured, 0.0, parts_only); }},
          {"room, two stations", [] { return room(450006, 2); }}};
}

std::vector<Point>
trainingPoints()
{
  std::vector<Point> some;
  for (const std::vector<Point>& points : pointsOf(trainingWorlds()))
    addSome(points, some);
  return some;
}

double
probability(const Terms& weights, const Point& point)
{
  return 1.0 / (1.0 + std::exp(-weights.dot(point.values)));
}

/** Newton's method; `allowed` are 1, the others stay 0. */
Terms
fit(const Examples& examples, const Terms& allowed)
{
  constexpr double ridge = 1e-4;
  constexpr int max_steps = 50;
  Terms weights = Terms::Zero();
  for (int step = 0; step < max_steps; ++step) {
    Terms gradient = Terms::Zero();
    Eigen::Matrix<double, terms, terms> hessian;
    hessian.setZero();
    double count = 0.0;
    for (const Example& example : examples) {
      const Terms& values = example.point->values;
      const double w = example.point->weight;
      const double p = probability(weights, *example.point);
      count += w;
      gradient += w * (p - example.is_right) * values;
      hessian += w * p * (1.0 - p) * values * values.transpose();
    }
    gradient = (gradient / count + ridge * weights).cwiseProduct(allowed);
    hessian = allowed.asDiagonal() * (hessian / count) * allowed.asDiagonal();
    hessian.diagonal().array() += ridge;
    const Terms change = hessian.ldlt().solve(gradient).cwiseProduct(allowed);
    weights -= change;
    if (change.cwiseAbs().maxCoeff() < 1e-7)
      break;
  }
  return weights;
}

/** What speaks for a label may not count against it: such features are left out. */
Terms
fitMonotone(const Examples& examples, Terms allowed)
{
  while (true) {
    const Terms weights = fit(examples, allowed);
    Eigen::Index worst = 0;
    if (weights.tail<terms - 1>().minCoeff(&worst) >= 0.0)
      return weights;
    allowed[worst + 1] = 0.0;
  }
}

/** What the confidence is the product of, see doc/labels.md. */
struct Weights {
  Terms no_edge, classes, edges;

  double
  confidence(const Point& point) const
  {
    return point.label == edge
               ? probability(edges, point)
               : probability(no_edge, point) * probability(classes, point);
  }
};

Terms
termsOf(std::initializer_list<int> features_used)
{
  Terms used = Terms::Zero();
  used[0] = 1.0;
  for (const int f : features_used)
    used[f + 1] = 1.0;
  return used;
}

Weights
weightsFor(const std::vector<Point>& points)
{
  Examples no_edge, classes, edges;
  for (const Point& point : points) {
    const double is_right = point.label == point.truth ? 1.0 : 0.0;
    if (point.label == edge) {
      edges.push_back({&point, is_right});
      continue;
    }
    no_edge.push_back({&point, point.truth != edge ? 1.0 : 0.0});
    if (point.truth != edge)
      classes.push_back({&point, is_right});
  }
  // Those that have to do with it: see LabelFeatures.
  return {fitMonotone(no_edge, termsOf({1, 2, 3})),
          fitMonotone(classes, termsOf({0, 3, 4})),
          fitMonotone(edges, termsOf({0, 1, 2, 3}))};
}

/** Of a world of the choosing: the share kept from several confidences, and how many of
 * these are right. */
void
printKept(const std::string& name,
          const std::vector<Point>& points,
          const Weights& weights)
{
  std::fprintf(stderr, "%s:", name.c_str());
  for (const double least : {0.8, 0.9, 0.95, 0.97, 0.99}) {
    double kept = 0.0, right = 0.0;
    for (const Point& point : points) {
      if (weights.confidence(point) < least)
        continue;
      kept += 1.0;
      right += point.label == point.truth ? 1.0 : 0.0;
    }
    std::fprintf(stderr,
                 " from %.2f kept %.3f right %.4f,",
                 least,
                 kept / static_cast<double>(points.size()),
                 right / kept);
  }
  std::fprintf(stderr, "\n");
}

/** Shares that are right in ranges of confidence. */
void
printReliability(const std::vector<Point>& points, const Weights& weights)
{
  const double limits[] = {0.0, 0.5, 0.8, 0.9, 0.95, 0.98, 1.0};
  for (std::size_t l = 1; l < std::size(limits); ++l) {
    double count = 0.0, right = 0.0, expected = 0.0;
    for (const Point& point : points) {
      const double p = weights.confidence(point);
      if (p < limits[l - 1] || p >= limits[l])
        continue;
      count += point.weight;
      right += point.label == point.truth ? point.weight : 0.0;
      expected += point.weight * p;
    }
    if (count > 0.0)
      std::fprintf(
          stderr, "%.3f expected, %.3f right\n", expected / count, right / count);
  }
}

void
printWeights(const char* name, const Terms& weights)
{
  std::printf("constexpr LabelWeights %s_weights{%.3g, {", name, weights[0]);
  for (Eigen::Index f = 1; f < terms; ++f)
    std::printf(f == 1 ? "%.3g" : ", %.3g", weights[f]);
  std::printf("}};\n");
}

} // namespace

int
main()
{
  const std::vector<Point> points = trainingPoints();
  const Weights weights = weightsFor(points);
  printWeights("no_edge", weights.no_edge);
  printWeights("class", weights.classes);
  printWeights("edge", weights.edges);
  printReliability(points, weights);
  const std::vector<Recipe> others = choosingWorlds();
  const std::vector<std::vector<Point>> of_others = pointsOf(others);
  for (std::size_t i = 0; i < others.size(); ++i)
    printKept(others[i].name, of_others[i], weights);
  return 0;
}
