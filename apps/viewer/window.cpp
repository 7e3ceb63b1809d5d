// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/window.h"

#include "cli/errors.h"
#include "viewer/annotations.h"
#include "viewer/overlays.h"

#include <pcl/common/point_tests.h>
#include <pcl/visualization/pcl_visualizer.h>

#include <cstdlib>
#include <iostream>
#include <memory>
#include <vtkNew.h>
#include <vtkPNGWriter.h>
#include <vtkRenderWindow.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>
#include <vtkWindowToImageFilter.h>

#include <X11/Xlib.h>

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
    const float length = share * (scene.camera.focus - scene.camera.position).norm() *
                         std::tan(0.5f * scene.camera.angle * 0.0174532925f) /
                         std::tan(0.26f);
    const Props normals = normalsOf(*scene.points, *scene.normals, length);
    props.insert(props.end(), normals.begin(), normals.end());
  }
  return props;
}

/** The visualizer's parts of the window, one for each view; it has one of its own for
 * the whole window, which is the only one if there is a single view. */
std::vector<int>
makeViewports(Visualizer& visualizer, std::size_t views)
{
  if (views == 1)
    return {0};
  const int columns = columnsOf(views);
  const int rows = (static_cast<int>(views) + columns - 1) / columns;
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
  const int rows = (static_cast<int>(scene.views.size()) + columns - 1) / columns;
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
  constexpr double radians_per_degree = 0.017453292519943295;
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
          static_cast<float>(camera.fovy / 0.017453292519943295)};
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
    throw InputError("the picture cannot be drawn: allowed is a display with OpenGL");
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
                     "': allowed is one that can be reached; without a screen, "
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
