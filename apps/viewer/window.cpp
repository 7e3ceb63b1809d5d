// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PCL's visualizer with legends, overlays and keys; off-screen for pictures.

#include "viewer/window.h"

#include "io/errors.h"
#include "viewer/overlays.h"

#include <pcl/common/point_tests.h>
#include <pcl/visualization/pcl_visualizer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <iostream>
#include <memory>
#include <vtkCellData.h>
#include <vtkLegendBoxActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <X11/Xlib.h>
#include <vtkProperty2D.h>

namespace pcl::app {
namespace {

using Visualizer = pcl::visualization::PCLVisualizer;

constexpr const char* key_help = "drag: turn    shift+drag: move    wheel: nearer\n"
                                 "+  -   larger, smaller points\n"
                                 "r      all points in the middle\n"
                                 "o      perspective on, off\n"
                                 "f      fly to the point under the mouse\n"
                                 "v      print -camera of this view\n"
                                 "j      save a picture\n"
                                 "h      these keys on, off\n"
                                 "q      quit";

constexpr int font_size = 15; // pixels
constexpr double background_opacity = 0.75;
constexpr double channel = 1.0 / 255.0;
constexpr double radians_per_degree = 0.017453292519943295;

void
makePlain(vtkTextProperty& property)
{
  property.SetFontFamilyToArial();
  property.SetFontSize(font_size);
  property.SetColor(0.0, 0.0, 0.0);
  property.BoldOff();
  property.ItalicOff();
  property.ShadowOff();
}

vtkSmartPointer<vtkLookupTable>
viridisTable(const ValueRange& range)
{
  constexpr int steps = 256;
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(steps);
  table->SetRange(range.min, range.max);
  for (int i = 0; i < steps; ++i) {
    const Color color = viridis(static_cast<double>(i) / (steps - 1));
    table->SetTableValue(i, color.r * channel, color.g * channel, color.b * channel);
  }
  table->SetNanColor(colors::unknown.r * channel,
                     colors::unknown.g * channel,
                     colors::unknown.b * channel,
                     1.0);
  return table;
}

void
addScaleBar(const FieldView& view, int width, int height, vtkRenderer& renderer)
{
  constexpr double pixels_wide = 90.0, pixels_high = 260.0;
  vtkNew<vtkScalarBarActor> bar;
  bar->SetLookupTable(viridisTable(*view.range));
  bar->SetTitle(view.title.c_str());
  bar->SetNumberOfLabels(5);
  bar->SetLabelFormat("%.3g");
  bar->UnconstrainedFontSizeOn();
  bar->SetVerticalTitleSeparation(8);
  bar->SetBarRatio(0.25);
  if (view.unknown > 0) {
    bar->DrawNanAnnotationOn();
    bar->SetNanAnnotation("unknown");
  }
  bar->DrawBackgroundOn();
  bar->GetBackgroundProperty()->SetColor(1.0, 1.0, 1.0);
  bar->GetBackgroundProperty()->SetOpacity(background_opacity);
  makePlain(*bar->GetTitleTextProperty());
  makePlain(*bar->GetLabelTextProperty());
  makePlain(*bar->GetAnnotationTextProperty());
  const double share_wide = std::min(0.4, pixels_wide / width);
  const double share_high = std::min(0.8, pixels_high / height);
  bar->SetPosition(0.98 - share_wide, 0.03);
  bar->SetPosition2(share_wide, share_high);
  renderer.AddActor2D(bar);
}

/** If there are many labels, those with the most points, in the order of their values.
 */
std::vector<LegendEntry>
mostImportant(const std::vector<LegendEntry>& legend)
{
  constexpr std::size_t max_entries = 12; // fit beside the picture
  if (legend.size() <= max_entries)
    return legend;
  std::vector<std::size_t> sizes;
  for (const LegendEntry& entry : legend)
    sizes.push_back(entry.points);
  std::sort(sizes.rbegin(), sizes.rend());
  std::vector<LegendEntry> shown;
  for (const LegendEntry& entry : legend)
    if (entry.points >= sizes[max_entries - 1] && shown.size() < max_entries)
      shown.push_back(entry);
  shown.push_back({"and " + std::to_string(legend.size() - shown.size()) + " more",
                   {255, 255, 255},
                   0});
  return shown;
}

/** A square with its own color: an entry's color in VTK is that of its text. */
vtkSmartPointer<vtkPolyData>
swatchOf(const Color& color)
{
  vtkNew<vtkPlaneSource> square;
  square->Update();
  vtkNew<vtkUnsignedCharArray> colors;
  colors->SetNumberOfComponents(3);
  const std::uint8_t channels[3] = {color.r, color.g, color.b};
  colors->InsertNextTypedTuple(channels);
  vtkSmartPointer<vtkPolyData> swatch = square->GetOutput();
  swatch->GetCellData()->SetScalars(colors);
  return swatch;
}

void
addLegend(const FieldView& view, int width, int height, vtkRenderer& renderer)
{
  const std::vector<LegendEntry> entries = mostImportant(view.legend);
  vtkNew<vtkLegendBoxActor> legend;
  legend->SetNumberOfEntries(static_cast<int>(entries.size()));
  std::size_t longest = 0;
  for (std::size_t e = 0; e < entries.size(); ++e) {
    double black[3] = {0.0, 0.0, 0.0};
    const auto place = static_cast<int>(e);
    const auto swatch = swatchOf(entries[e].color);
    legend->SetEntry(place, swatch, entries[e].name.c_str(), black);
    longest = std::max(longest, entries[e].name.size());
  }
  makePlain(*legend->GetEntryTextProperty());
  legend->BorderOff();
  legend->UseBackgroundOn();
  double white[3] = {1.0, 1.0, 1.0};
  legend->SetBackgroundColor(white);
  legend->SetBackgroundOpacity(background_opacity);
  const double line = 1.5 * font_size;
  const double share_wide = std::min(
      0.6, (3.0 * line + 0.6 * font_size * static_cast<double>(longest)) / width);
  const double share_high =
      std::min(0.9, line * static_cast<double>(entries.size()) / height);
  legend->SetPosition(0.98 - share_wide, 0.03);
  legend->SetPosition2(share_wide, share_high);
  renderer.AddActor2D(legend);
}

/** A text at a place of the picture, 0 to 1 each way. */
vtkSmartPointer<vtkTextActor>
makeText(const std::string& text, double x, double y, int size)
{
  auto actor = vtkSmartPointer<vtkTextActor>::New();
  actor->SetInput(text.c_str());
  makePlain(*actor->GetTextProperty());
  actor->GetTextProperty()->SetFontSize(size);
  actor->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  actor->SetPosition(x, y);
  return actor;
}

/** The name of the field and, in `height` pixels, its legend or scale bar. */
void
addAnnotations(const FieldView& view, int width, int height, vtkRenderer& renderer)
{
  const auto title = makeText(view.title, 0.015, 0.985, font_size + 3);
  title->GetTextProperty()->SetVerticalJustificationToTop();
  title->GetTextProperty()->SetBackgroundColor(1.0, 1.0, 1.0);
  title->GetTextProperty()->SetBackgroundOpacity(background_opacity);
  renderer.AddActor2D(title);
  if (view.range)
    addScaleBar(view, width, height, renderer);
  else if (!view.legend.empty())
    addLegend(view, width, height, renderer);
}

pcl::PointCloud<pcl::PointXYZRGB>::Ptr
coloredPoints(const Scene& scene, const FieldView& view)
{
  const auto cloud = pcl::make_shared<pcl::PointCloud<pcl::PointXYZRGB>>();
  for (std::size_t i = 0; i < view.colors.size(); ++i) {
    const pcl::PointXYZ& point = (*scene.points)[i];
    const Color& color = view.colors[i];
    if (pcl::isXYZFinite(point))
      cloud->emplace_back(point.x, point.y, point.z, color.r, color.g, color.b);
  }
  return cloud;
}

Props
overlaysOf(const Scene& scene)
{
  Props props = linesOf(scene.lines);
  for (Props& more :
       std::vector<Props>{instancesOf(scene.instances), graspsOf(scene.grasps)})
    props.insert(props.end(), more.begin(), more.end());
  if (scene.normals) {
    constexpr float share = 0.02f; // of the distance
    const float length =
        share * (scene.camera.focus - scene.camera.position).norm() *
        std::tan(0.5f * scene.camera.angle * static_cast<float>(radians_per_degree)) /
        std::tan(0.26f);
    const Props normals = normalsOf(*scene.points, *scene.normals, length);
    props.insert(props.end(), normals.begin(), normals.end());
  }
  return props;
}

/** The visualizer's viewports, one for each view. A single view takes the one that
 * always exists, the whole window. */
std::vector<int>
makeViewports(Visualizer& visualizer, std::size_t views)
{
  if (views == 1)
    return {0};
  const int columns = columnsOf(views);
  const int rows = rowsOf(views);
  std::vector<int> viewports;
  for (int v = 0; v < static_cast<int>(views); ++v) {
    const double x = v % columns;
    const double y = rows - 1 - v / columns;
    visualizer.createViewPort(x / columns,
                              y / rows,
                              (x + 1) / columns,
                              (y + 1) / rows,
                              viewports.emplace_back());
  }
  return viewports;
}

vtkRenderer&
rendererOf(Visualizer& visualizer, int viewport)
{
  return *vtkRenderer::SafeDownCast(
      visualizer.getRendererCollection()->GetItemAsObject(viewport));
}

void
fill(Visualizer& visualizer, const Scene& scene)
{
  const std::vector<int> viewports = makeViewports(visualizer, scene.views.size());
  visualizer.setBackgroundColor(1.0, 1.0, 1.0);
  visualizer.setShowFPS(false);
  const Props overlays = overlaysOf(scene);
  const int columns = columnsOf(scene.views.size());
  const int rows = rowsOf(scene.views.size());
  for (std::size_t v = 0; v < scene.views.size(); ++v) {
    const auto cloud = coloredPoints(scene, scene.views[v]);
    const std::string id = "view " + std::to_string(v);
    visualizer.addPointCloud<pcl::PointXYZRGB>(cloud, id, viewports[v]);
    visualizer.setPointCloudRenderingProperties(
        pcl::visualization::PCL_VISUALIZER_POINT_SIZE, scene.point_size, id);
    vtkRenderer& renderer = rendererOf(visualizer, viewports[v]);
    for (const auto& prop : overlays)
      renderer.AddViewProp(prop);
    addAnnotations(
        scene.views[v], scene.width / columns, scene.height / rows, renderer);
  }
}

void
setCamera(Visualizer& visualizer, const Camera& camera)
{
  visualizer.setCameraPosition(camera.position.x(),
                               camera.position.y(),
                               camera.position.z(),
                               camera.focus.x(),
                               camera.focus.y(),
                               camera.focus.z(),
                               camera.up.x(),
                               camera.up.y(),
                               camera.up.z());
  visualizer.setCameraFieldOfView(camera.angle * radians_per_degree);
}

Camera
cameraOf(Visualizer& visualizer)
{
  std::vector<pcl::visualization::Camera> cameras;
  visualizer.getCameras(cameras);
  const pcl::visualization::Camera& camera = cameras.front();
  const auto vector = [](const double* v) -> Eigen::Vector3f {
    return Eigen::Map<const Eigen::Vector3d>(v).cast<float>();
  };
  return {vector(camera.pos),
          vector(camera.focal),
          vector(camera.view),
          static_cast<float>(camera.fovy / radians_per_degree)};
}

vtkSmartPointer<vtkTextActor>
addKeyHelp(Visualizer& visualizer, bool visible)
{
  auto help = makeText(key_help, 0.015, 0.06, 14);
  vtkTextProperty& property = *help->GetTextProperty();
  property.SetFontFamilyToCourier();
  property.SetBackgroundColor(1.0, 1.0, 0.85);
  property.SetBackgroundOpacity(0.9);
  property.SetFrame(1);
  property.SetFrameColor(0.4, 0.4, 0.4);
  help->SetVisibility(visible ? 1 : 0);
  vtkRendererCollection& renderers = *visualizer.getRendererCollection();
  rendererOf(visualizer, renderers.GetNumberOfItems() > 1 ? 1 : 0).AddActor2D(help);
  return help;
}

std::string
encode(vtkRenderWindow& window)
{
  vtkNew<vtkWindowToImageFilter> image;
  image->SetInput(&window);
  image->SetInputBufferTypeToRGB();
  image->ReadFrontBufferOff();
  vtkNew<vtkPNGWriter> writer;
  writer->SetInputConnection(image->GetOutputPort());
  writer->WriteToMemoryOn();
  writer->SetCompressionLevel(9);
  writer->Write();
  vtkUnsignedCharArray* const bytes = writer->GetResult();
  if (!bytes || bytes->GetNumberOfValues() == 0)
    throw InputError("the picture cannot be drawn; expected a display with OpenGL");
  return {reinterpret_cast<const char*>(bytes->GetPointer(0)),
          static_cast<std::size_t>(bytes->GetNumberOfValues())};
}

} // namespace

void
requireDisplay()
{
  const char* const name = std::getenv("DISPLAY");
  // Open until the end: Xvfb starts anew when its last client leaves.
  static const std::unique_ptr<Display, int (*)(Display*)> display(
      XOpenDisplay(nullptr), XCloseDisplay);
  if (!display)
    throw InputError("no X server at DISPLAY '" + std::string(name ? name : "") +
                     "'; expected one that can be reached; without a screen, "
                     "'xvfb-run -a pcl_shape_viewer ... -screenshot out.png' draws "
                     "pictures");
}

std::string
drawPicture(const Scene& scene)
{
  vtkObject::GlobalWarningDisplayOff();
  const auto window = vtkSmartPointer<vtkRenderWindow>::New();
  window->SetOffScreenRendering(1);
  Visualizer visualizer(vtkSmartPointer<vtkRenderer>::New(), window, scene.title, true);
  visualizer.setSize(scene.width, scene.height);
  fill(visualizer, scene);
  setCamera(visualizer, scene.camera);
  addKeyHelp(visualizer, scene.keys);
  window->Render();
  return encode(*window);
}

void
showWindow(const Scene& scene)
{
  vtkObject::GlobalWarningDisplayOff();
  Visualizer visualizer(scene.title);
  visualizer.setSize(scene.width, scene.height);
  fill(visualizer, scene);
  setCamera(visualizer, scene.camera);
  const auto help = addKeyHelp(visualizer, scene.keys);
  const auto hint = makeText("h: keys", 0.015, 0.02, 13);
  rendererOf(visualizer, 0).AddActor2D(hint);
  visualizer.registerKeyboardCallback(
      [&](const pcl::visualization::KeyboardEvent& event) {
        if (!event.keyDown())
          return;
        if (event.getKeySym() == "h")
          help->SetVisibility(help->GetVisibility() == 0 ? 1 : 0);
        if (event.getKeySym() == "v")
          std::cout << "-camera " << toText(cameraOf(visualizer)) << std::endl;
        visualizer.getRenderWindow()->Render();
      });
  visualizer.spin();
}

} // namespace pcl::app
