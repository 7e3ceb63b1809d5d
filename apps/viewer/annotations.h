// SPDX-License-Identifier: BSD-3-Clause
// SPDX-FileCopyrightText: 2026 pcl_shape contributors
// PURPOSE

#pragma once

#include "viewer/field_view.h"

#include <vtkRenderer.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

namespace pcl::app {

/** \brief A text at a place of the picture, 0 to 1 each way. */
vtkSmartPointer<vtkTextActor>
makeText(const std::string& text, double x, double y, int font_size);

/** \brief The name of the field and, in `height` pixels, its legend or scale bar. */
void
addAnnotations(const FieldView& view, int width, int height, vtkRenderer& renderer);

} // namespace pcl::app
