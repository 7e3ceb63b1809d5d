/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/features/inad_parameters.h>
#include <pcl/features/shape_histogram.h>

#include <string>
#include <vector>

namespace pcl {

/** \brief Named shape histograms on the same bins, with the parameters of their INAD.
 *
 * With one class, the likelihood of a pair is the histogram's; with several, the
 * posterior of each class by Bayes' rule over the histograms' densities and the
 * classes' priors. \ingroup features
 */
class PCL_SHAPE_EXPORTS ShapeModel {
public:
  /** \brief A kind of surface. */
  struct Class {
    std::string name;         ///< not empty, no other class has it
    ShapeHistogram histogram; ///< of its INAD
    double prior = 1.0;       ///< positive; only the ratios count
  };

  /** \brief A model without classes. \throws pcl::BadArgumentException for bad
   * parameters */
  explicit ShapeModel(const INADParameters& parameters = {});

  /** \brief The histogram of an ideal plane, all of it in bin (0, 0), named "planar".
   */
  static ShapeModel idealPlane(const INADParameters& parameters = {},
                               std::size_t bins = 10);

  /** \brief The default model of edges: classes "edge" and "surface", radii in local
   * spacings. Learned from generated scenes only (scripts/train_models.sh). */
  static const ShapeModel& defaultEdges();

  /** \brief The default model of surfaces: classes "planar" and "curved"; likewise. */
  static const ShapeModel& defaultSurfaces();

  /** \brief Read a model file (JSON).
   * \throws pcl::IOException naming the file, what is wrong with it and what is
   * expected */
  static ShapeModel load(const std::string& file_name);

  /** \brief Write a model file: complete, or not at all.
   * \throws pcl::IOException if that fails, pcl::BadArgumentException for a model
   * without a class
   */
  void save(const std::string& file_name) const;

  /** \brief Read a model from the text of a model file.
   * \param[in] text the file's contents
   * \param[in] name of the text, for messages \throws pcl::IOException as load() */
  static ShapeModel parse(const std::string& text, const std::string& name);

  /** \brief Add a class, or merge into the one of that name, whose prior becomes this.
   * \throws pcl::BadArgumentException for an empty name, an empty histogram, a prior
   * that is not positive and finite, or bins other than those of the other classes
   */
  void add(const std::string& name, const ShapeHistogram& histogram, double prior);

  /** \brief The same with a prior of 1, or that of the class of that name. */
  void add(const std::string& name, const ShapeHistogram& histogram);

  /** \brief One value a class: the likelihood (one class) or the posteriors (several).
   * NaN where the pair is NaN or, with several classes, where every density is below
   * floor(). \param[in] inad the pair
   * \param[out] values classes().size() floats
   */
  void evaluate(const INAD& inad, float* values) const;

  /** \brief What in `parameters` differs from the model's by more than 1e-6 of its
   * value: a sentence that names the parameter and both values, empty if nothing does.
   */
  std::string disagreement(const INADParameters& parameters) const;

  /** \brief The classes, in the order in which they were added. */
  const std::vector<Class>&
  classes() const
  {
    return classes_;
  }

  /** \brief How the INAD of its histograms was computed. */
  const INADParameters&
  parameters() const
  {
    return parameters_;
  }

  /** \brief The density, 1/rad^2, below which a class says nothing about a pair. */
  double
  floor() const
  {
    return floor_;
  }

  /** \throws pcl::BadArgumentException if it is negative or not finite */
  void setFloor(double floor);

  /** \brief Standard deviation, in bins, of the Gaussian that densities are smoothed
   * with where evidence is averaged (DENSITY mode); 0 for none. Counts of a few samples
   * vary from bin to bin by chance. */
  double
  smoothing() const
  {
    return smoothing_;
  }

  /** \throws pcl::BadArgumentException unless it is 0 to 100 */
  void setSmoothing(double bins);

private:
  std::vector<Class>::iterator find(const std::string& name);

  INADParameters parameters_;
  std::vector<Class> classes_;
  double floor_ = 0.0;
  double smoothing_ = 0.0;
};

} // namespace pcl
