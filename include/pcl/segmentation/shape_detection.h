/*
 * SPDX-License-Identifier: BSD-3-Clause
 *
 * Point Cloud Library (PCL) - www.pointclouds.org
 * Copyright (c) 2026, pcl_shape contributors
 *
 * All rights reserved
 */

#pragma once

#include <pcl/PointIndices.h>
#include <pcl/features/inad_point.h>
#include <pcl/features/shape_model.h>
#include <pcl/features/sweep_index.h>
#include <pcl/pcl_base.h>
#include <pcl/point_types.h>
#include <pcl/search/search.h>
#include <pcl/segmentation/adaptive_detection.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

namespace detail {

/** \brief What is wrong with a model, a threshold, or parameters that the model was not
 * made with (if they are given); empty if nothing is. */
PCL_SHAPE_EXPORTS std::string problemOfModel(const ShapeModel& model,
                                             double threshold,
                                             const INADParameters* parameters);

} // namespace detail

/** \brief What ShapeBackProjection and ShapeEdgeDetection share: from a cloud to the
 * likelihood of each class at each point.
 *
 * What is not given is estimated: the normals over the normal radius, then the INAD
 * over the radius, then it is looked up in the model. The radii are the model's unless
 * they are set.
 *
 * Errors (those of INADEstimation; INAD of another number than the input's points;
 * radii, k or outlier rate that disagree with the model's, unless
 * setIgnoreModelParameters(); a threshold out of [0, 1]; a model without a class; a
 * resolution that is negative, finer than what a float holds at the largest coordinate,
 * or set without isAdaptive()) are reported by PCL_ERROR and give empty outputs.
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ShapeDetection : public PCLBase<PointT>,
                       public AdaptiveRadius,
                       public SweepIndexUser {
public:
  /** \brief PAPER: fixed radii, 10 x 10 bins, one histogram of an ideal plane,
   * threshold 0.5; it never changes. DEFAULT: the best that this version knows, if
   * isAdaptive(); with radii, k, an outlier rate, normals or INAD that were set, the
   * paper's method with these. */
  enum Mode { PAPER, DEFAULT };

  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;
  using PointCloudNConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr;
  using INADCloudConstPtr = pcl::PointCloud<INAD>::ConstPtr;
  using SearchPtr = typename pcl::search::Search<PointT>::Ptr;

  /** \brief Normals of the search surface (the input, if no surface is set); optional.
   */
  void
  setInputNormals(const PointCloudNConstPtr& normals)
  {
    normals_ = normals;
  }

  /** \brief INAD of the input's points, all of them; optional. Say with
   * setNormalRadius() and setRadius(), or setKSearch(), how it was computed to have it
   * checked against the model. */
  void
  setInputINAD(const INADCloudConstPtr& inad)
  {
    inad_ = inad;
  }

  /** \brief The points to find neighbors among, instead of the input. */
  void
  setSearchSurface(const PointCloudConstPtr& surface)
  {
    surface_ = surface;
  }

  /** \brief Find neighbors with this instead of the much faster pcl::NeighborhoodSweep.
   * It is asked by several threads at once: one that does not allow that needs
   * setNumberOfThreads(1). */
  void
  setSearchMethod(const SearchPtr& search)
  {
    search_ = search;
  }

  SearchPtr
  getSearchMethod() const
  {
    return search_;
  }

  /** \param[in] radius metres */
  void
  setNormalRadius(double radius)
  {
    normal_radius_ = radius;
  }

  /** \param[in] radius metres, of the INAD's neighborhood */
  void
  setRadius(double radius)
  {
    radius_ = radius;
  }

  /** \brief What the radii are measured in. DENSITY is the default where no radius is
   * given; with FIXED or DEPTH the radii are the paper's unless they are set. */
  void
  setRadiusMode(RadiusMode mode)
  {
    AdaptiveRadius::setRadiusMode(mode);
    has_radius_mode_ = true;
  }

  /** \brief Whether the neighborhoods follow the cloud's density and noise, and
   * evidence is gathered over them: in DEFAULT mode, where neither radii, k, an outlier
   * rate, normals nor INAD are set, the radius mode is DENSITY or not set, and the
   * model, if one is set, was made in DENSITY mode and has several classes. */
  bool isAdaptive() const;

  /** \brief Work as if no points were closer than this, if isAdaptive(): the mean of
   * the points in each cell of this size stands for them, and each point of the input
   * gets what the nearest of these gets. Neighborhoods follow the density, and surfaces
   * that curve with more than 20 local spacings are planar: of clouds with many points
   * this sets what is, a radius of up to about 40 times the resolution. It is also much
   * faster, and takes noise that is larger than the distances between points.
   * \param[in] metres between points; 0 (default) for the cloud's own */
  void
  setResolution(double metres)
  {
    resolution_ = metres;
  }

  double
  getResolution() const
  {
    return resolution_;
  }

  /** \brief Nearest points instead of the two radii, for normals and INAD alike. */
  void
  setKSearch(int k)
  {
    k_ = k;
  }

  void
  setOutlierRate(double rate)
  {
    outlier_rate_ = rate;
  }

  /** \brief The surfaces, or the edge and the rest, to look for. Without, if
   * isAdaptive(): ShapeModel::defaultSurfaces(), of ShapeEdgeDetection
   * ShapeModel::defaultEdges(); else an ideal plane. */
  void
  setModel(const ShapeModel& model)
  {
    model_ = model;
  }

  /** \brief Back-project the model at other radii than those it was made with. */
  void
  setIgnoreModelParameters(bool ignore)
  {
    ignore_model_parameters_ = ignore;
  }

  /** \brief The likelihood from which a point belongs to the class of a model with one
   * histogram, in [0, 1]; 0.5 by default. ShapeBackProjection with several classes does
   * not use it. ShapeEdgeDetection does with any model: a point is an edge if the
   * likelihood of "planar" is below it, that of "edge" above 1 - threshold. */
  void
  setThreshold(double threshold)
  {
    threshold_ = threshold;
  }

  void
  setMode(Mode mode)
  {
    mode_ = mode;
  }

  Mode
  getMode() const
  {
    return mode_;
  }

  /** \param[in] threads 0 for all cores */
  void
  setNumberOfThreads(unsigned threads = 0)
  {
    threads_ = threads;
  }

  /** \brief The names of the classes, in the order of the likelihoods and of segment().
   */
  virtual std::vector<std::string> getClasses() const = 0;

  /** \brief The model in use and the parameters that compute() will estimate with. */
  ShapeModel getModel() const;

  INADParameters getParameters() const;

  /** \brief The likelihood of the first class, one for each index; NaN is unknown. */
  void compute(pcl::PointCloud<pcl::Intensity>& likelihood);

  /** \brief The likelihoods of every class, in the order of getClasses(), one for each
   * index.
   */
  void compute(std::vector<std::vector<float>>& likelihoods);

  /** \brief The points of every class, in the order of getClasses(). Unknown ones are
   * in none.
   */
  void segment(std::vector<pcl::PointIndices>& classes);

  /** \brief The same from what compute() gave before, without computing it again. */
  std::vector<pcl::PointIndices>
  classesOf(const std::vector<std::vector<float>>& likelihoods) const;

protected:
  ShapeDetection(std::string name, const INADParameters& defaults)
  : name_(std::move(name))
  , defaults_(defaults)
  {}

  /** \brief From the model's values at one point to one value for each of getClasses().
   */
  virtual void toClasses(const std::vector<float>& values,
                         float* likelihoods) const = 0;

  /** \brief The position in getClasses() of the class of a point with these
   * likelihoods. */
  virtual std::size_t classOf(const float* likelihoods) const = 0;

  /** \brief What makes a model unusable for this class; empty if nothing does. */
  virtual std::string
  problemOfClasses(const ShapeModel&) const
  {
    return {};
  }

  /** \brief The model that is used if none is set and isAdaptive(). */
  virtual const ShapeModel& defaultModel() const = 0;

  /** \brief What isAdaptive() says to compute. \param[out] spacings of the points
   * \return one value for each of getClasses(), for each point of the input */
  virtual std::vector<float>
  adaptiveLikelihoods(const detail::AdaptiveInput& input,
                      std::vector<float>& spacings) const = 0;

  /** \brief Call find(detail::AdaptiveInput) with all points of the search surface, as
   * fine as the resolution. \param[in] find returns their spacings
   * \return for each index the point of these that it stands for, -1 if there is none
   */
  template <typename Find>
  std::vector<std::int32_t> withAdaptiveInput(const Find& find) const;

  bool initCompute();

  std::string name_;
  double threshold_ = 0.5;
  std::optional<ShapeModel> model_;

private:
  void computeAdaptive(std::vector<float>& likelihoods) const;

  /** \brief The points to find neighbors among. */
  PointCloudConstPtr searchSurface() const;

  /** \brief The same, thinned out to the resolution. */
  PointCloudConstPtr adaptiveSurface() const;

  std::vector<std::int32_t> surfacePoints(const PointCloud& surface,
                                          std::vector<float> spacings) const;

  std::string problemOfResolution() const;

  /** \brief What is wrong with the input or the settings; empty if nothing is. */
  std::string findProblem() const;

  PointCloudNConstPtr estimateNormals(const INADParameters& parameters,
                                      const SweepIndex::Ptr& index) const;

  void computeINAD(pcl::PointCloud<INAD>& inad) const;

  /** \brief One value for each class, for each index; false after an error. */
  bool computeLikelihoods(std::vector<float>& likelihoods);

  INADParameters defaults_;
  PointCloudNConstPtr normals_;
  INADCloudConstPtr inad_;
  PointCloudConstPtr surface_;
  SearchPtr search_;
  std::optional<double> normal_radius_;
  std::optional<double> radius_;
  std::optional<int> k_;
  std::optional<double> outlier_rate_;
  double resolution_ = 0.0;
  bool ignore_model_parameters_ = false;
  bool has_radius_mode_ = false;
  Mode mode_ = DEFAULT;
  unsigned threads_ = 0;
};

} // namespace pcl
