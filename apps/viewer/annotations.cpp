// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#include "viewer/annotations.h"

#include <algorithm>
#include <vtkCellData.h>
#include <vtkLegendBoxActor.h>
#include <vtkLookupTable.h>
#include <vtkNew.h>
#include <vtkPlaneSource.h>
#include <vtkPolyData.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <vtkProperty2D.h>

namespace pcl::app {
namespace {

constexpr int font_size = 15; // pixels
constexpr double background_opacity = 0.75;
constexpr double channel = 1.0 / 255.0;

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
  table->SetRange(range.least, range.most);
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

/** Of many labels those with most points, in the order of the values. */
std::vector<LegendEntry>
mostImportant(const std::vector<LegendEntry>& legend)
{
  constexpr std::size_t most = 12;
  if (legend.size() <= most)
    return legend;
  std::vector<std::size_t> sizes;
  for (const LegendEntry& entry : legend)
    sizes.push_back(entry.points);
  std::sort(sizes.rbegin(), sizes.rend());
  std::vector<LegendEntry> shown;
  for (const LegendEntry& entry : legend)
    if (entry.points >= sizes[most - 1] && shown.size() < most)
      shown.push_back(entry);
  shown.push_back({"and " + std::to_string(legend.size() - shown.size()) + " more",
                   {255, 255, 255},
                   0});
  return shown;
}

/** A square with a color of its own: that of a legend's entry is its text's. */
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

} // namespace

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

} // namespace pcl::app
