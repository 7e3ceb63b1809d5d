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
#include <pcl/point_types.h>
#include <pcl/segmentation/shape_field_estimation.h>

#include <optional>
#include <string>
#include <vector>

namespace pcl {

/** \brief The settings that ShapeBackProjection and ShapeEdgeDetection share.
 * \ingroup segmentation */
class PCL_SHAPE_EXPORTS ShapeDetectionSettings : public AdaptiveRadius,
                                                 public SweepIndexUser {
public:
  /** \brief DEFAULT: adaptive neighborhoods and evidence gathered over faces; there is
   * no radius, see ShapeFieldEstimation. PAPER: the published method, fixed radii (or k
   * neighbors), the histogram of an ideal plane or a model, a threshold; it never
   * changes. A setting of the other method is an error. */
  enum Mode { PAPER, DEFAULT };

  /** \brief Choose the method; DEFAULT unless it is called. */
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

  /** \brief The surfaces, or the edge and the rest, to look for. DEFAULT mode takes a
   * model of several classes made in DENSITY mode instead of its own; PAPER mode any,
   * instead of an ideal plane. */
  void
  setModel(const ShapeModel& model)
  {
    model_ = model;
  }

  /** \brief The likelihood from which a point belongs to the class of a model with one
   * histogram, in [0, 1]; 0.5 by default. Of several classes ShapeBackProjection takes
   * the likeliest. ShapeEdgeDetection: a point is an edge if the likelihood of "planar"
   * is below it, that of "edge" above 1 - threshold. */
  void
  setThreshold(double threshold)
  {
    threshold_ = threshold;
  }

  double
  getThreshold() const
  {
    return threshold_;
  }

  /** \brief PAPER mode. \param[in] radius meters */
  void
  setNormalRadius(double radius)
  {
    normal_radius_ = radius;
  }

  double
  getNormalRadius() const
  {
    return getParameters().normal_radius;
  }

  /** \brief PAPER mode. \param[in] radius meters, of the INAD's neighborhood */
  void
  setRadius(double radius)
  {
    radius_ = radius;
  }

  double
  getRadius() const
  {
    return getParameters().radius;
  }

  /** \brief PAPER mode: what the radii are measured in. */
  void
  setRadiusMode(RadiusMode mode)
  {
    AdaptiveRadius::setRadiusMode(mode);
    has_radius_mode_ = true;
  }

  /** \brief PAPER mode: nearest points instead of the two radii, for normals and INAD
   * alike. */
  void
  setKSearch(int k)
  {
    k_ = k;
  }

  int
  getKSearch() const
  {
    return getParameters().k;
  }

  /** \brief PAPER mode: the sigma multiple beyond which angles are rejected. */
  void
  setOutlierRate(double rate)
  {
    outlier_rate_ = rate;
  }

  double
  getOutlierRate() const
  {
    return getParameters().outlier_rate;
  }

  /** \brief PAPER mode: back-project the model at other radii than those it was made
   * with. */
  void
  setIgnoreModelParameters(bool ignore)
  {
    ignore_model_parameters_ = ignore;
  }

  bool
  getIgnoreModelParameters() const
  {
    return ignore_model_parameters_;
  }

  /** \brief The model in use. */
  ShapeModel getModel() const;

  /** \brief How normals and INAD are estimated: in local spacings, and for a cloud
   * without noise, in DEFAULT mode. */
  INADParameters getParameters() const;

protected:
  ShapeDetectionSettings(std::string name, const INADParameters& paper)
  : name_(std::move(name))
  , paper_(paper)
  {}

  virtual ~ShapeDetectionSettings() = default;

  /** \brief The model that DEFAULT mode uses if none is set. */
  virtual const ShapeModel& defaultModel() const = 0;

  /** \brief What makes a model unusable for this class; empty if nothing does. */
  virtual std::string
  problemOfClasses(const ShapeModel&) const
  {
    return {};
  }

  /** \brief A setting of the mode that is not in use; empty if there is none.
   * \param[in] of_paper, of_default what else is set, null if nothing is */
  std::string problemOfMode(const char* of_paper, const char* of_default) const;

  /** \brief What is wrong with the model or the threshold; empty if nothing is. */
  std::string problemOfModel() const;

  std::string name_;
  double threshold_ = 0.5;
  std::optional<ShapeModel> model_;
  Mode mode_ = DEFAULT;

private:
  INADParameters paper_;
  std::optional<double> normal_radius_;
  std::optional<double> radius_;
  std::optional<int> k_;
  std::optional<double> outlier_rate_;
  bool ignore_model_parameters_ = false;
  bool has_radius_mode_ = false;
};

/** \brief What ShapeBackProjection and ShapeEdgeDetection share: from a cloud to the
 * likelihood of each class at each point.
 *
 * In PAPER mode what is not given is estimated: the normals over the normal radius,
 * then the INAD over the radius, then it is looked up in the model. The radii are the
 * model's unless they are set.
 *
 * Errors (those of ShapeFieldEstimation or INADEstimation; a setting of the other mode;
 * a field of another cloud; INAD of another number than the input's points; radii, k or
 * outlier rate that disagree with the model's, unless setIgnoreModelParameters(); a
 * threshold out of [0, 1]; a model without a class) are reported by PCL_ERROR and give
 * empty outputs.
 * \ingroup segmentation
 */
template <typename PointT, typename PointNT = pcl::Normal>
class ShapeDetection : public ShapeFieldUser<PointT>, public ShapeDetectionSettings {
public:
  using PointCloud = pcl::PointCloud<PointT>;
  using PointCloudConstPtr = typename PointCloud::ConstPtr;
  using PointCloudNConstPtr = typename pcl::PointCloud<PointNT>::ConstPtr;
  using INADCloudConstPtr = pcl::PointCloud<INAD>::ConstPtr;

  /** \brief Normals of the search surface (the input, if no surface is set); optional.
   */
  void
  setInputNormals(const PointCloudNConstPtr& normals)
  {
    normals_ = normals;
  }

  PointCloudNConstPtr
  getInputNormals() const
  {
    return normals_;
  }

  /** \brief PAPER mode: INAD of the input's points, all of them; optional. Say with
   * setNormalRadius() and setRadius(), or setKSearch(), how it was computed to have it
   * checked against the model. */
  void
  setInputINAD(const INADCloudConstPtr& inad)
  {
    inad_ = inad;
  }

  INADCloudConstPtr
  getInputINAD() const
  {
    return inad_;
  }

  /** \brief The points to find neighbors among, instead of the input. */
  void
  setSearchSurface(const PointCloudConstPtr& surface)
  {
    surface_ = surface;
  }

  PointCloudConstPtr
  getSearchSurface() const
  {
    return surface_;
  }

  /** \brief The names of the classes, in the order of the likelihoods and of segment().
   */
  virtual std::vector<std::string> getClasses() const = 0;

  /** \brief The likelihood of the first class, one for each index; NaN is unknown. */
  void compute(pcl::PointCloud<pcl::Intensity>& likelihood);

  /** \brief The likelihoods of every class, in the order of getClasses(), one for each
   * index. */
  void compute(std::vector<std::vector<float>>& likelihoods);

  /** \brief The points of every class, in the order of getClasses(). Unknown ones are
   * in none. */
  void segment(std::vector<pcl::PointIndices>& classes);

  /** \brief The same from what compute() gave before, without computing it again. */
  std::vector<pcl::PointIndices>
  classesOf(const std::vector<std::vector<float>>& likelihoods) const;

protected:
  ShapeDetection(const std::string& name, const INADParameters& paper)
  : ShapeDetectionSettings(name, paper)
  {}

  /** \brief From the model's values at one point to one value for each of getClasses().
   */
  virtual void toClasses(const std::vector<float>& values,
                         float* likelihoods) const = 0;

  /** \brief The position in getClasses() of the class of a point with these
   * likelihoods, of so many classes. */
  virtual std::size_t classOf(const float* likelihoods, std::size_t classes) const = 0;

  /** \brief Whether only the edges of a field are needed: setModel() then sets its
   * edge model, else its surface model. */
  virtual bool
  edgesOnly() const
  {
    return false;
  }

  /** \brief The likelihoods of getClasses() at the points of a field. */
  virtual std::vector<std::vector<float>>
  likelihoodsOf(const ShapeField& field) const = 0;

  /** \brief Reports what is wrong with the input or the settings. */
  bool initCompute();

  void reportProblem(const std::string& problem) const;

private:
  std::string findProblem();

  std::string findPaperProblem() const;

  std::string findDefaultProblem();

  void computeINAD(pcl::PointCloud<INAD>& inad) const;

  std::vector<std::vector<float>> paperLikelihoods() const;

  PointCloudNConstPtr normals_;
  INADCloudConstPtr inad_;
  PointCloudConstPtr surface_;
};

} // namespace pcl
