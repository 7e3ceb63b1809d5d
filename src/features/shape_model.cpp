// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "common/errors.h"

#include <pcl/features/shape_model.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <sstream>

namespace pcl {
namespace {

void
checkParameters(const INADParameters& p)
{
  const bool has_radii = p.normal_radius > 0.0 && std::isfinite(p.normal_radius) &&
                         p.radius > 0.0 && std::isfinite(p.radius) && p.k == 0;
  const bool has_k = p.normal_radius == 0.0 && p.radius == 0.0 && p.k > 0;
  if (!has_radii && !has_k) {
    raise<BadArgumentException>(textOf("normal radius ",
                                       p.normal_radius,
                                       " m, radius ",
                                       p.radius,
                                       " m, k ",
                                       p.k,
                                       ": both radii must be positive and k 0, or "
                                       "the radii 0 and k positive"));
  }
  for (const double growth : {p.normal_radius_noise, p.radius_noise}) {
    if (!(growth >= 0.0) || !std::isfinite(growth) ||
        (growth > 0.0 && p.radius_mode != AdaptiveRadius::DENSITY)) {
      raise<BadArgumentException>(
          textOf("radius that grows by ",
                 growth,
                 " with the noise: it must be 0, or positive in density mode"));
    }
  }
  if (has_k && p.radius_mode != AdaptiveRadius::FIXED) {
    raise<BadArgumentException>(
        textOf("k ", p.k, " with a radius mode: it must be fixed with k"));
  }
  if (!(p.outlier_rate >= 0.0) || !std::isfinite(p.outlier_rate)) {
    raise<BadArgumentException>(textOf(
        "outlier rate ", p.outlier_rate, ": it must be 0 or positive and finite"));
  }
}

bool
differs(double a, double b)
{
  return std::abs(a - b) > 1e-6 * std::max(std::abs(a), std::abs(b));
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
    raise<BadArgumentException>(textOf("a class needs a name"));
  if (histogram.total() == 0) {
    raise<BadArgumentException>(textOf("the histogram of class '",
                                       name,
                                       "' is empty: it needs at least one "
                                       "point with a known (mu, sigma)"));
  }
  if (!(prior > 0.0) || !std::isfinite(prior)) {
    raise<BadArgumentException>(textOf("the prior of class '",
                                       name,
                                       "' is ",
                                       prior,
                                       ": it must be positive and finite"));
  }
  if (!classes_.empty() && !classes_.front().histogram.sameBins(histogram)) {
    const ShapeHistogram& first = classes_.front().histogram;
    raise<BadArgumentException>(textOf("class '",
                                       name,
                                       "' has ",
                                       histogram.muBins(),
                                       " x ",
                                       histogram.sigmaBins(),
                                       " bins over ",
                                       histogram.muRange(),
                                       " x ",
                                       histogram.sigmaRange(),
                                       " rad: those of the model are ",
                                       first.muBins(),
                                       " x ",
                                       first.sigmaBins(),
                                       " over ",
                                       first.muRange(),
                                       " x ",
                                       first.sigmaRange(),
                                       " rad"));
  }
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
  for (const Class& c : classes_) {
    *values++ = is_known ? static_cast<float>(c.prior * c.histogram.density(inad) / sum)
                         : std::numeric_limits<float>::quiet_NaN();
  }
}

std::string
ShapeModel::disagreement(const INADParameters& other) const
{
  std::ostringstream text;
  const auto compare =
      [&](const char* name, double mine, double its, const char* unit) {
        if (differs(mine, its))
          text << (text.tellp() > 0 ? "; " : "") << name << " " << its << unit
               << " is asked for, the model was made with " << mine << unit;
      };
  const char* unit =
      parameters_.radius_mode == AdaptiveRadius::DENSITY ? " spacings" : " m";
  compare("normal radius", parameters_.normal_radius, other.normal_radius, unit);
  compare("radius", parameters_.radius, other.radius, unit);
  compare("k", parameters_.k, other.k, "");
  compare("outlier rate", parameters_.outlier_rate, other.outlier_rate, "");
  compare("radius mode (0 fixed, 1 depth, 2 density)",
          parameters_.radius_mode,
          other.radius_mode,
          "");
  compare("growth of the normal radius with noise",
          parameters_.normal_radius_noise,
          other.normal_radius_noise,
          "");
  compare("growth of the radius with noise",
          parameters_.radius_noise,
          other.radius_noise,
          "");
  return text.str();
}

void
ShapeModel::setSmoothing(double bins)
{
  if (!(bins >= 0.0 && bins <= 100.0)) {
    raise<BadArgumentException>(
        textOf("smoothing ", bins, " bins: it must be from 0 to 100"));
  }
  smoothing_ = bins;
}

void
ShapeModel::setFloor(double floor)
{
  if (!(floor >= 0.0) || !std::isfinite(floor)) {
    raise<BadArgumentException>(
        textOf("floor ", floor, ": it must be 0 or positive and finite"));
  }
  floor_ = floor;
}

} // namespace pcl
