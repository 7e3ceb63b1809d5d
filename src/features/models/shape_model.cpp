// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Named shape histograms: their checks, likelihoods and posteriors.

#include "common/number_text.h"

#include <pcl/exceptions.h>
#include <pcl/features/shape_model.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace pcl {
namespace {

using detail::numberText;

void
checkParameters(const INADParameters& p)
{
  const auto check = [](bool is_right, const std::string& problem) {
    if (!is_right)
      throw BadArgumentException(problem);
  };
  const bool has_radii = p.normal_radius > 0.0 && std::isfinite(p.normal_radius) &&
                         p.radius > 0.0 && std::isfinite(p.radius) && p.k == 0;
  const bool has_k = p.normal_radius == 0.0 && p.radius == 0.0 && p.k > 0;
  check(has_radii || has_k,
        "normal radius " + numberText(p.normal_radius) + " m, radius " +
            numberText(p.radius) + " m, k " + std::to_string(p.k) +
            ": both radii must be positive and k 0, or the radii 0 and k positive");
  for (const double growth : {p.normal_radius_noise, p.radius_noise})
    check(growth >= 0.0 && std::isfinite(growth) &&
              (growth == 0.0 || p.radius_mode == AdaptiveRadius::DENSITY),
          "radius that grows by " + numberText(growth) +
              " with the noise: it must be 0, or positive in density mode");
  check(has_radii || p.radius_mode == AdaptiveRadius::FIXED,
        "k " + std::to_string(p.k) + " with a radius mode: it must be fixed with k");
  check(p.outlier_rate >= 0.0 && std::isfinite(p.outlier_rate),
        "outlier rate " + numberText(p.outlier_rate) +
            ": it must be 0 or positive and finite");
}

} // namespace

ShapeModel::ShapeModel(const INADParameters& parameters) : parameters_(parameters)
{
  checkParameters(parameters);
}

ShapeModel
ShapeModel::idealPlane(const INADParameters& parameters, std::size_t bins)
{
  ShapeHistogram plane(bins, bins);
  plane.add(0, 0, 1);
  ShapeModel model(parameters);
  model.add("planar", plane);
  return model;
}

void
ShapeModel::add(const std::string& name, const ShapeHistogram& histogram, double prior)
{
  if (name.empty())
    throw BadArgumentException("a class needs a name");
  if (histogram.total() == 0)
    throw BadArgumentException("the histogram of class '" + name +
                               "' is empty: it needs at least one point with a known "
                               "(mu, sigma)");
  if (!(prior > 0.0) || !std::isfinite(prior))
    throw BadArgumentException("the prior of class '" + name + "' is " +
                               numberText(prior) + ": it must be positive and finite");
  const auto binsOf = [](const ShapeHistogram& h) {
    return std::to_string(h.muBins()) + " x " + std::to_string(h.sigmaBins()) +
           " bins over " + numberText(h.muRange()) + " x " +
           numberText(h.sigmaRange()) + " rad";
  };
  if (!classes_.empty() && !classes_.front().histogram.sameBins(histogram))
    throw BadArgumentException("class '" + name + "' has " + binsOf(histogram) +
                               ": those of the model are " +
                               binsOf(classes_.front().histogram));
  const auto known = find(name);
  if (known == classes_.end()) {
    classes_.push_back({name, histogram, prior});
    return;
  }
  known->histogram.merge(histogram);
  known->prior = prior;
}

void
ShapeModel::add(const std::string& name, const ShapeHistogram& histogram)
{
  const auto known = find(name);
  add(name, histogram, known == classes_.end() ? 1.0 : known->prior);
}

std::vector<ShapeModel::Class>::iterator
ShapeModel::find(const std::string& name)
{
  return std::find_if(
      classes_.begin(), classes_.end(), [&](const Class& c) { return c.name == name; });
}

void
ShapeModel::evaluate(const INAD& inad, float* values) const
{
  if (classes_.size() == 1) {
    values[0] = classes_[0].histogram.likelihood(inad);
    return;
  }
  double sum = 0.0;
  bool is_known = false;
  for (const Class& c : classes_) {
    const double density = c.histogram.density(inad);
    is_known = is_known || (density > 0.0 && density >= floor_);
    sum += c.prior * density;
  }
  for (const Class& c : classes_)
    *values++ = is_known ? static_cast<float>(c.prior * c.histogram.density(inad) / sum)
                         : std::numeric_limits<float>::quiet_NaN();
}

std::string
ShapeModel::disagreement(const INADParameters& other) const
{
  std::string text;
  const auto compare =
      [&](const char* name, double mine, double its, const char* unit) {
        const bool differs =
            std::abs(mine - its) > 1e-6 * std::max(std::abs(mine), std::abs(its));
        if (differs)
          text += (text.empty() ? "" : "; ") + (name + (" " + numberText(its))) + unit +
                  " is asked for, the model was made with " + numberText(mine) + unit;
      };
  const INADParameters& p = parameters_;
  const char* unit = p.radius_mode == AdaptiveRadius::DENSITY ? " spacings" : " m";
  compare("normal radius", p.normal_radius, other.normal_radius, unit);
  compare("radius", p.radius, other.radius, unit);
  compare("k", p.k, other.k, "");
  compare("outlier rate", p.outlier_rate, other.outlier_rate, "");
  compare("radius mode (0 fixed, 1 depth, 2 density)",
          p.radius_mode,
          other.radius_mode,
          "");
  compare("growth of the normal radius with noise",
          p.normal_radius_noise,
          other.normal_radius_noise,
          "");
  compare("growth of the radius with noise", p.radius_noise, other.radius_noise, "");
  return text;
}

void
ShapeModel::setSmoothing(double bins)
{
  if (!(bins >= 0.0 && bins <= 100.0))
    throw BadArgumentException("smoothing " + numberText(bins) +
                               " bins: it must be 0 to 100");
  smoothing_ = bins;
}

void
ShapeModel::setFloor(double floor)
{
  if (!(floor >= 0.0) || !std::isfinite(floor))
    throw BadArgumentException("floor " + numberText(floor) +
                               ": it must be 0 or positive and finite");
  floor_ = floor;
}

} // namespace pcl
