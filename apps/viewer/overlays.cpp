// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// Tubes, boxes, names and arrows of VTK.

#include "viewer/overlays.h"

#include <pcl/common/point_tests.h>

#include <algorithm>
#include <cmath>
#include <vtkActor.h>
#include <vtkArrowSource.h>
#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkOutlineSource.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkProperty.h>
#include <vtkRegularPolygonSource.h>
#include <vtkTextProperty.h>
#include <vtkTubeFilter.h>

#include <vtkBillboardTextActor3D.h>
#include <vtkGlyph3D.h>

namespace pcl::app {
namespace {

vtkSmartPointer<vtkActor>
actorOf(vtkAlgorithmOutput* geometry, const Color& color)
{
  vtkNew<vtkPolyDataMapper> mapper;
  mapper->SetInputConnection(geometry);
  mapper->ScalarVisibilityOff();
  auto actor = vtkSmartPointer<vtkActor>::New();
  actor->SetMapper(mapper);
  actor->GetProperty()->SetColor(color.r / 255.0, color.g / 255.0, color.b / 255.0);
  return actor;
}

/** Places with directions, for glyphs. */
class Arrows {
public:
  Arrows() { directions_->SetNumberOfComponents(3); }

  void
  add(const Vector& place, const Vector& direction)
  {
    points_->InsertNextPoint(place.data());
    directions_->InsertNextTuple(direction.data());
  }

  /** The shape, which lies along x and is 1 long, at each place. */
  vtkSmartPointer<vtkActor>
  draw(vtkAlgorithmOutput* shape, float scale, const Color& color) const
  {
    vtkNew<vtkPolyData> places;
    places->SetPoints(points_);
    places->GetPointData()->SetNormals(directions_);
    vtkNew<vtkGlyph3D> glyphs;
    glyphs->SetInputData(places);
    glyphs->SetSourceConnection(shape);
    glyphs->SetVectorModeToUseNormal();
    glyphs->SetScaleModeToDataScalingOff();
    glyphs->SetScaleFactor(scale);
    return actorOf(glyphs->GetOutputPort(), color);
  }

private:
  vtkNew<vtkPoints> points_;
  vtkNew<vtkFloatArray> directions_;
};

vtkSmartPointer<vtkProp>
tubeOf(const Line& line, const Color& color)
{
  vtkNew<vtkPoints> points;
  vtkNew<vtkCellArray> cells;
  cells->InsertNextCell(static_cast<int>(line.points.size()));
  for (const Vector& point : line.points)
    cells->InsertCellPoint(points->InsertNextPoint(point.data()));
  vtkNew<vtkPolyData> polyline;
  polyline->SetPoints(points);
  polyline->SetLines(cells);
  vtkNew<vtkTubeFilter> tube;
  tube->SetInputData(polyline);
  tube->SetRadius(1.5 * line.spacing); // partly below the points
  tube->SetNumberOfSides(10);
  tube->CappingOn();
  return actorOf(tube->GetOutputPort(), color);
}

vtkSmartPointer<vtkProp>
nameOf(const InstanceBox& instance)
{
  constexpr double channel = 0.6 / 255.0; // darker, to be read
  const auto name = vtkSmartPointer<vtkBillboardTextActor3D>::New();
  name->SetInput(instance.name.c_str());
  name->SetPosition((instance.min[0] + instance.max[0]) / 2.0,
                    (instance.min[1] + instance.max[1]) / 2.0,
                    (instance.min[2] + instance.max[2]) / 2.0);
  vtkTextProperty& property = *name->GetTextProperty();
  property.SetFontSize(14);
  property.BoldOn();
  property.SetColor(instance.color.r * channel,
                    instance.color.g * channel,
                    instance.color.b * channel);
  property.SetBackgroundColor(1.0, 1.0, 1.0);
  property.SetBackgroundOpacity(0.75);
  property.SetJustificationToCentered();
  property.SetVerticalJustificationToCentered();
  name->ForceTranslucentOn();
  return name;
}

} // namespace

Props
linesOf(const std::vector<Line>& lines)
{
  Props props;
  for (std::size_t l = 0; l < lines.size(); ++l)
    props.push_back(tubeOf(lines[l], distinctColor(l)));
  return props;
}

Props
instancesOf(const std::vector<InstanceBox>& instances)
{
  Props props;
  for (const InstanceBox& instance : instances) {
    vtkNew<vtkOutlineSource> box;
    box->SetBounds(instance.min[0],
                   instance.max[0],
                   instance.min[1],
                   instance.max[1],
                   instance.min[2],
                   instance.max[2]);
    const auto actor = actorOf(box->GetOutputPort(), instance.color);
    actor->GetProperty()->SetLineWidth(2.0f);
    actor->GetProperty()->LightingOff();
    props.emplace_back(actor);
    props.push_back(nameOf(instance));
  }
  return props;
}

Props
graspsOf(const Grasps& grasps)
{
  constexpr float arrow_lengths = 4.0f; // cup radii
  vtkNew<vtkArrowSource> arrow;
  arrow->SetTipLength(0.3);
  arrow->InvertOn(); // its tip, not its end, is at the place
  vtkNew<vtkRegularPolygonSource> disc;
  disc->SetNormal(1.0, 0.0, 0.0);
  disc->SetCenter(0.1, 0.0, 0.0); // above the points
  disc->SetRadius(1.0);
  disc->SetNumberOfSides(40);
  Props props;
  for (const bool seals : {true, false}) {
    Arrows arrows;
    for (const Grasp& grasp : grasps.grasps)
      if (grasp.seals == seals)
        arrows.add(grasp.position,
                   {-grasp.approach[0], -grasp.approach[1], -grasp.approach[2]});
    const Color color = seals ? colors::green : colors::crimson;
    props.emplace_back(
        arrows.draw(arrow->GetOutputPort(), arrow_lengths * grasps.cup_radius, color));
    props.emplace_back(arrows.draw(disc->GetOutputPort(), grasps.cup_radius, color));
  }
  return props;
}

Props
normalsOf(const pcl::PointCloud<pcl::PointXYZ>& points,
          const pcl::PointCloud<pcl::Normal>& normals,
          float length)
{
  constexpr std::size_t max_arrows = 1200;            // more hide the cloud
  constexpr double golden_ratio = 0.6180339887498949; // no two points in a row
  const std::size_t count = std::min(points.size(), max_arrows);
  Arrows arrows;
  for (std::size_t a = 0; a < count; ++a) {
    const double share = std::fmod(golden_ratio * static_cast<double>(a), 1.0);
    const auto i = static_cast<std::size_t>(share * static_cast<double>(points.size()));
    const Eigen::Vector3f normal = normals[i].getNormalVector3fMap();
    if (pcl::isXYZFinite(points[i]) && normal.allFinite())
      arrows.add({points[i].x, points[i].y, points[i].z},
                 {normal.x(), normal.y(), normal.z()});
  }
  vtkNew<vtkArrowSource> arrow;
  arrow->SetShaftRadius(0.02);
  arrow->SetTipRadius(0.07);
  return {arrows.draw(arrow->GetOutputPort(), length, colors::dark)};
}

} // namespace pcl::app
