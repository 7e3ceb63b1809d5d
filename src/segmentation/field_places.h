// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// A field with each place once, however many points are there.

#pragma once

#include <pcl/features/distinct_points.h>
#include <pcl/segmentation/shape_field.h>
#include <pcl/types.h>

#include <cstddef>
#include <vector>

namespace pcl::detail {

/** \brief The values with zeros that are positive. */
std::vector<float> unsignedZeros(std::vector<float> values);

/** \brief The places of a field's points. If its base is of these, it knows them. */
DistinctPoints distinctPoints(const ShapeField& field);

/** \brief What detectors work on: a field without equal points. Each place has the
 * values of its points; if only some of them are known, theirs. */
class FieldPlaces {
public:
  /** \param[in] field must live as long */
  explicit FieldPlaces(const ShapeField& field);

  explicit FieldPlaces(ShapeField&& temporary) = delete;
  FieldPlaces(const FieldPlaces&) = delete;
  FieldPlaces& operator=(const FieldPlaces&) = delete;

  /** \brief The field that was given, if it has no equal points. */
  const ShapeField&
  field() const
  {
    return hasRepeats() ? of_places_ : given_;
  }

  bool
  hasRepeats() const
  {
    return distinct_.hasRepeats();
  }

  /** \brief Where in field() a point of the field is that was given. */
  std::size_t
  placeOf(std::size_t point) const
  {
    return hasRepeats() ? static_cast<std::size_t>(distinct_.place[point]) : point;
  }

  /** \brief The places of some points, each once. */
  pcl::Indices placesOf(const pcl::Indices& points) const;

private:
  const ShapeField& given_;
  DistinctPoints distinct_;
  std::vector<float> positions_;
  ShapeField of_places_;
};

} // namespace pcl::detail
