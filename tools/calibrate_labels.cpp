// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Fits the confidence of labels to generated scenes, see src/labels/label_weights.h.

#include "labels/label_evidence.h"
#include "scene/scene.h"
#include "scene/surface_samples.h"

#include <pcl/point_types.h>

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <iterator>
#include <tuple>
#include <vector>

// Logistic regression. The weights go to standard output, how well the confidence then
// fits to standard error. Seeds from 400001 on are used for nothing else.
namespace {

using namespace pcl;

constexpr std::size_t classes = 3; // planar, curved, edge
constexpr std::size_t features = std::tuple_size<detail::LabelFeatures>::value;
constexpr Eigen::Index terms = 1 + features; // a constant is the first
using Terms = Eigen::Matrix<double, terms, 1>;

struct Example {
  Terms values;
  double is_right;
};

using Examples = std::vector<Example>;

/** 0 where the truth is left out. */
std::uint32_t
truthAt(const scene::Scene& scene, std::size_t i)
{
  if (scene.edge[i] == scene::EdgeCrease)
    return classes;
  const bool is_surface =
      scene.edge[i] == scene::EdgeNot && (scene.surface[i] == scene::SurfacePlanar ||
                                          scene.surface[i] == scene::SurfaceCurved);
  return is_surface ? scene.surface[i] : 0;
}

ShapeField
fieldOf(const PointCloud<PointXYZ>::Ptr& cloud)
{
  ShapeFieldEstimation<PointXYZ> estimation;
  estimation.setInputCloud(cloud);
  ShapeField field;
  estimation.compute(field);
  return field;
}

void
addScene(const scene::Scene& scene, std::vector<Examples>& examples)
{
  const auto cloud = make_shared<PointCloud<PointXYZ>>();
  std::vector<std::uint32_t> truth;
  for (std::size_t i = 0; i < scene.surface.size(); ++i) {
    const float* p = &scene.xyz[3 * i];
    if (!std::isfinite(p[2]))
      continue;
    cloud->push_back(PointXYZ(p[0], p[1], p[2]));
    truth.push_back(truthAt(scene, i));
  }
  const ShapeField field = fieldOf(cloud);
  const auto evidence = detail::labelEvidence({field});
  // Planar points are many and alike.
  const std::size_t steps[classes] = {5, 2, 1};
  for (std::size_t i = 0; i < truth.size(); ++i) {
    const std::uint32_t label = evidence.labels[i];
    if (truth[i] == 0 || label == 0 || i % steps[label - 1] != 0)
      continue;
    Terms values;
    values[0] = 1.0;
    for (std::size_t f = 0; f < features; ++f)
      values[static_cast<Eigen::Index>(f) + 1] = evidence.features[i][f];
    examples[label - 1].push_back({values, label == truth[i] ? 1.0 : 0.0});
  }
  std::cerr << cloud->size() << " points, noise " << field.noise << '\n';
}

double
probability(const Terms& weights, const Example& example)
{
  return 1.0 / (1.0 + std::exp(-weights.dot(example.values)));
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
    for (const Example& example : examples) {
      const double p = probability(weights, example);
      gradient += (p - example.is_right) * example.values;
      hessian += p * (1.0 - p) * example.values * example.values.transpose();
    }
    const double count = static_cast<double>(examples.size());
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
fitMonotone(const Examples& examples)
{
  Terms allowed = Terms::Ones();
  while (true) {
    const Terms weights = fit(examples, allowed);
    Eigen::Index worst = 0;
    if (weights.tail<terms - 1>().minCoeff(&worst) >= 0.0)
      return weights;
    allowed[worst + 1] = 0.0;
  }
}

/** Shares that are right in ranges of confidence. */
void
printReliability(const char* name, const Examples& examples, const Terms& weights)
{
  const double limits[] = {0.0, 0.5, 0.8, 0.9, 0.95, 0.98, 1.0};
  std::fprintf(stderr, "%s:", name);
  for (std::size_t l = 1; l < std::size(limits); ++l) {
    double count = 0.0, right = 0.0, expected = 0.0;
    for (const Example& example : examples) {
      const double p = probability(weights, example);
      if (p < limits[l - 1] || p >= limits[l])
        continue;
      count += 1.0;
      right += example.is_right;
      expected += p;
    }
    if (count > 0.0)
      std::fprintf(stderr,
                   " %.3f expected %.3f right (%.0f),",
                   expected / count,
                   right / count,
                   count);
  }
  std::fprintf(stderr, "\n");
}

void
printWeights(const char* name, const Terms& weights)
{
  std::printf("constexpr LabelWeights %s_weights{%.4g, {", name, weights[0]);
  for (Eigen::Index f = 1; f < terms; ++f)
    std::printf(f == 1 ? "%.4g" : ", %.4g", weights[f]);
  std::printf("}};\n");
}

std::vector<scene::Scene>
scenesOf(std::uint64_t seed)
{
  std::vector<scene::Scene> scenes;
  for (std::uint64_t s = 0; s < 8; ++s) {
    scene::SceneOptions options;
    options.seed = seed++;
    scenes.push_back(scene::generateScene(options));
  }
  for (const double sigma : {0.0, 0.0005, 0.001, 0.0015, 0.002}) {
    scene::SceneOptions options;
    options.seed = seed++;
    options.noise = sigma > 0.0 ? scene::Noise::White : scene::Noise::None;
    options.white_sigma = sigma;
    scenes.push_back(scene::generateScene(options));
  }
  for (const double sigma : {0.0, 0.0, 0.0001, 0.0002, 0.0004}) {
    scene::SampleOptions options;
    options.seed = seed++;
    options.objects = 8;
    options.sigma = sigma;
    scenes.push_back(scene::sampleScene(options));
  }
  return scenes;
}

} // namespace

int
main()
{
  std::vector<Examples> examples(classes);
  constexpr std::uint64_t first_seed = 400001;
  for (const scene::Scene& scene : scenesOf(first_seed))
    addScene(scene, examples);
  const char* const names[classes] = {"planar", "curved", "edge"};
  for (std::size_t c = 0; c < classes; ++c) {
    const Terms weights = fitMonotone(examples[c]);
    printWeights(names[c], weights);
    printReliability(names[c], examples[c], weights);
  }
  return 0;
}
