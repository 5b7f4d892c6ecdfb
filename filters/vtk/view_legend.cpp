#include "filters/vtk/view_legend.h"

#include <vtkColorTransferFunction.h>
#include <vtkLookupTable.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>
#include <vtkVariant.h>

#include <algorithm>

#include "filters/core/probe_color.h"

namespace boxprobe {

namespace {

constexpr int kColors = 256;

void setText(vtkTextProperty* text, int size) {
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->SetColor(1.0, 1.0, 1.0);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

vtkSmartPointer<vtkLookupTable> swatches(const std::vector<glm::vec3>& colors, const std::vector<std::string>& names) {
  auto table = vtkSmartPointer<vtkLookupTable>::New();
  table->SetNumberOfTableValues(static_cast<vtkIdType>(colors.size()));
  table->IndexedLookupOn();
  for (std::size_t i = 0; i < colors.size(); ++i) {
    const glm::dvec3 c(colors[i]);
    table->SetTableValue(static_cast<vtkIdType>(i), c.x, c.y, c.z, 1.0);
    table->SetAnnotation(vtkVariant(static_cast<int>(i)), names[i]);
  }
  return table;
}

}  // namespace

// From dark blue through green to yellow: lightness rises all the way, so that order is seen without the bar and
// without colour vision.
ViewLegend::ViewLegend()
    : colors_(vtkSmartPointer<vtkColorTransferFunction>::New()), bar_(vtkSmartPointer<vtkScalarBarActor>::New()) {
  colors_->SetColorSpaceToLab();
  colors_->AddRGBPoint(0.00, 0.11, 0.09, 0.30);
  colors_->AddRGBPoint(0.25, 0.16, 0.34, 0.60);
  colors_->AddRGBPoint(0.50, 0.11, 0.58, 0.57);
  colors_->AddRGBPoint(0.75, 0.52, 0.79, 0.32);
  colors_->AddRGBPoint(1.00, 0.99, 0.94, 0.40);

  bar_->UnconstrainedFontSizeOn();
  setText(bar_->GetTitleTextProperty(), 15);
  setText(bar_->GetLabelTextProperty(), 14);
  setText(bar_->GetAnnotationTextProperty(), 14);
  bar_->SetTextPositionToPrecedeScalarBar();
  bar_->DrawBackgroundOn();
  bar_->GetBackgroundProperty()->SetColor(0.08, 0.08, 0.09);
  bar_->GetBackgroundProperty()->SetOpacity(0.78);
  bar_->SetNumberOfLabels(5);
  bar_->AnnotationTextScalingOff();
  bar_->SetTextPad(6);
  bar_->SetVerticalTitleSeparation(10);
}

ViewLegend::~ViewLegend() = default;

void ViewLegend::show(vtkRenderer* renderer, const SurfaceViewRow& row, double low, double high,
                      const std::vector<std::string>& probeNames) {
  const bool barred = row.kind == ViewKind::Scalar || row.kind == ViewKind::Category || row.id == "weights";
  if (!barred) {
    renderer->RemoveActor2D(bar_);
    return;
  }
  std::string title(row.label);
  if (!row.unit.empty()) title += "\n" + std::string(row.unit);
  bar_->SetTitle(title.c_str());
  double height = 0.5;
  if (row.kind == ViewKind::Scalar) {
    vtkNew<vtkLookupTable> table;
    table->SetNumberOfTableValues(kColors);
    for (int i = 0; i < kColors; ++i) {
      double rgb[3];
      colors_->GetColor(static_cast<double>(i) / (kColors - 1), rgb);
      table->SetTableValue(i, rgb[0], rgb[1], rgb[2], 1.0);
    }
    table->SetTableRange(low, high);
    table->Build();
    bar_->SetLookupTable(table);
    bar_->SetLabelFormat(high - low >= 10.0 ? "%.1f" : high - low >= 0.1 ? "%.2f" : "%.4f");
  } else if (row.kind == ViewKind::Category) {
    const auto& faces = faceColors();
    bar_->SetLookupTable(swatches({faces.begin(), faces.end()}, {"-x", "+x", "-y", "+y", "-z", "+z"}));
  } else {
    std::vector<glm::vec3> colors;
    std::vector<std::string> names = probeNames;
    for (std::size_t i = 0; i < names.size(); ++i) colors.push_back(probeColor(static_cast<int>(i)));
    colors.push_back(skyColor());
    names.emplace_back("sky");
    bar_->SetLookupTable(swatches(colors, names));
    height = std::min(0.5, 0.12 + 0.06 * static_cast<double>(names.size()));
  }
  bar_->SetPosition(0.015, 0.03);
  bar_->SetWidth(0.13);
  bar_->SetHeight(height);
  renderer->RemoveActor2D(bar_);
  renderer->AddActor2D(bar_);
}

void ViewLegend::upload(vtkOpenGLRenderWindow* window, DebugDraw& debug) const {
  if (debug.colorMap != 0) return;
  std::vector<float> texels;
  for (int i = 0; i < kColors; ++i) {
    double rgb[3];
    colors_->GetColor(static_cast<double>(i) / (kColors - 1), rgb);
    for (const double c : rgb) texels.push_back(static_cast<float>(c));
  }
  glGenTextures(1, &debug.colorMap);
  const BoundTexture bound(window, GL_TEXTURE_2D, debug.colorMap);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGB32F, kColors, 1, 0, GL_RGB, GL_FLOAT, texels.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_LINEAR);
  }
  for (const GLenum name : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_CLAMP_TO_EDGE);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

}  // namespace boxprobe
