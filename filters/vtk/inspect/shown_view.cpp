#include "filters/vtk/inspect/shown_view.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkCoordinate.h>
#include <vtkLegendBoxActor.h>
#include <vtkLookupTable.h>
#include <vtkOpenGLRenderWindow.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextActor.h>
#include <vtkTextProperty.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "filters/core/picture/probe_color.h"
#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

namespace {

constexpr int kColors = 256;
constexpr int kSmallPicture = 800;  // pixels across: smaller pictures are for pages, where they are scaled down further
constexpr double kSmallFactor = 1.5;  // scale of text and bar in them

void setText(vtkTextProperty* text, int size) {
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->SetColor(1.0, 1.0, 1.0);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

// To two digits, so that the ends of a scale are readable.
double roundedUp(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(std::max(x, 1.0e-30))) - 1.0);
  return std::ceil(x / digit) * digit;
}

const SurfaceViewRow& rowOf(const SurfaceViewSettings& settings) {
  return surfaceViews()[static_cast<std::size_t>(settings.view)];
}

}  // namespace

// From dark blue through green to yellow, with increasing lightness, so that the order is visible without the bar and
// without colour vision.
ViewLegend::ViewLegend()
    : colors_(vtkSmartPointer<vtkColorTransferFunction>::New()),
      bar_(vtkSmartPointer<vtkScalarBarActor>::New()),
      names_(vtkSmartPointer<vtkLegendBoxActor>::New()),
      caption_(vtkSmartPointer<vtkTextActor>::New()) {
  colors_->SetColorSpaceToLab();
  colors_->AddRGBPoint(0.00, 0.11, 0.09, 0.30);
  colors_->AddRGBPoint(0.25, 0.16, 0.34, 0.60);
  colors_->AddRGBPoint(0.50, 0.11, 0.58, 0.57);
  colors_->AddRGBPoint(0.75, 0.52, 0.79, 0.32);
  colors_->AddRGBPoint(1.00, 0.99, 0.94, 0.40);

  bar_->UnconstrainedFontSizeOn();
  setText(bar_->GetLabelTextProperty(), 14);
  bar_->SetTextPositionToSucceedScalarBar();
  bar_->DrawBackgroundOn();
  bar_->GetBackgroundProperty()->SetColor(0.08, 0.08, 0.09);
  bar_->GetBackgroundProperty()->SetOpacity(0.78);
  bar_->SetNumberOfLabels(5);
  bar_->SetTextPad(6);

  setText(names_->GetEntryTextProperty(), 14);
  names_->ScalarVisibilityOn();
  names_->UseBackgroundOn();
  double background[3] = {0.08, 0.08, 0.09};
  names_->SetBackgroundColor(background);
  names_->SetBackgroundOpacity(0.78);
  names_->BorderOff();

  setText(caption_->GetTextProperty(), 16);
  caption_->GetTextProperty()->SetBackgroundColor(background);
  caption_->GetTextProperty()->SetBackgroundOpacity(0.78);
  caption_->GetTextProperty()->SetVerticalJustificationToTop();
  caption_->GetPositionCoordinate()->SetCoordinateSystemToNormalizedViewport();
  caption_->SetPosition(0.015, 0.97);
}

ViewLegend::~ViewLegend() = default;

void ViewLegend::show(vtkRenderer* renderer, const SurfaceViewRow& row, double low, double high,
                      const std::vector<std::string>& probeNames) {
  renderer->RemoveViewProp(bar_);
  renderer->RemoveViewProp(names_);
  renderer->RemoveViewProp(caption_);
  if (row.kind == ViewKind::Picture) return;
  const double factor = renderer->GetSize()[0] < kSmallPicture ? kSmallFactor : 1.0;
  for (vtkTextProperty* text : {bar_->GetLabelTextProperty(), names_->GetEntryTextProperty()}) {
    text->SetFontSize(static_cast<int>(14 * factor));
  }
  caption_->GetTextProperty()->SetFontSize(static_cast<int>(16 * factor));
  const std::string unit = row.unit.empty() ? "" : ", " + std::string(row.unit);
  caption_->SetInput((" " + std::string(row.label) + unit + " ").c_str());
  renderer->AddViewProp(caption_);
  if (row.kind == ViewKind::Category) {
    const auto& faces = faceColors();
    showNames(renderer, {faces.begin(), faces.end()}, {"-x", "+x", "-y", "+y", "-z", "+z"});
    return;
  }
  if (row.id == "weights") {
    std::vector<glm::vec3> colors;
    std::vector<std::string> names = probeNames;
    for (std::size_t i = 0; i < names.size(); ++i) colors.push_back(probeColor(static_cast<int>(i)));
    colors.push_back(skyColor());
    names.emplace_back("sky");
    showNames(renderer, colors, names);
    return;
  }
  if (row.kind != ViewKind::Scalar) return;
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
  bar_->SetPosition(0.015, 0.03);
  bar_->SetWidth(0.13 * factor);
  bar_->SetHeight(0.5);
  renderer->AddViewProp(bar_);
}

void ViewLegend::showNames(vtkRenderer* renderer, const std::vector<glm::vec3>& colors,
                           const std::vector<std::string>& names) {
  constexpr std::size_t kMost = 24;  // more would not be legible; the first ones in file order are shown
  const std::size_t count = std::min(names.size(), kMost);
  names_->SetNumberOfEntries(static_cast<int>(count));
  vtkNew<vtkPoints> corners;
  for (const auto& [x, y] : {std::pair(0, 0), {1, 0}, {1, 1}, {0, 1}}) corners->InsertNextPoint(x, y, 0);
  vtkNew<vtkCellArray> face;
  face->InsertNextCell({0, 1, 2, 3});
  std::size_t longest = 4;
  for (std::size_t i = 0; i < count; ++i) {
    // The swatch contains the colour: an entry's own colour would apply to its text, dark on dark.
    vtkNew<vtkUnsignedCharArray> color;
    color->SetNumberOfComponents(3);
    const glm::dvec3 rgb = 255.0 * glm::dvec3(colors[i]);
    color->InsertNextTuple3(rgb.x, rgb.y, rgb.z);
    vtkNew<vtkPolyData> square;
    square->SetPoints(corners);
    square->SetPolys(face);
    square->GetCellData()->SetScalars(color);
    names_->SetEntrySymbol(static_cast<int>(i), square);
    names_->SetEntryString(static_cast<int>(i), names[i].c_str());
    longest = std::max(longest, names[i].size());
  }
  names_->SetPosition(0.015, 0.03);
  const double factor = renderer->GetSize()[0] < kSmallPicture ? 2.0 * kSmallFactor : 1.0;
  names_->SetPosition2(std::min(factor * (0.05 + 0.008 * static_cast<double>(longest)), 0.4),
                       std::min(factor * 0.045 * static_cast<double>(count), 0.9));
  renderer->AddViewProp(names_);
}

// Below the colours stands the traced light, from its lowest row on: one sampler for both.
void ViewLegend::upload(vtkOpenGLRenderWindow* window, SceneResources& resources, const ImageRgbaF& truth) const {
  const auto columns = static_cast<std::size_t>(std::max(kColors, truth.width));
  const auto rows = static_cast<std::size_t>(truth.height);
  std::vector<float> texels((rows + 1) * columns * 4, -1.0f);
  for (int i = 0; i < kColors; ++i) {
    double rgb[3];
    colors_->GetColor(static_cast<double>(i) / (kColors - 1), rgb);
    std::copy(rgb, rgb + 3, texels.begin() + 4 * i);
  }
  texels[3] = static_cast<float>(truth.width);
  const std::size_t row = static_cast<std::size_t>(truth.width) * 4;
  for (std::size_t y = 0; y < rows; ++y) {
    std::copy_n(truth.pixels.begin() + static_cast<std::ptrdiff_t>((rows - 1 - y) * row), row,
                texels.begin() + static_cast<std::ptrdiff_t>((y + 1) * columns * 4));
  }
  if (resources.viewColors == 0) glGenTextures(1, &resources.viewColors);
  const BoundTexture bound(window, GL_TEXTURE_2D, resources.viewColors);
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA32F, static_cast<int>(columns), static_cast<int>(rows) + 1, 0, GL_RGBA,
               GL_FLOAT, texels.data());
  for (const GLenum name : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER}) {
    glTexParameteri(GL_TEXTURE_2D, name, GL_NEAREST);
  }
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAX_LEVEL, 0);
}

// A row without a range takes it from the scene: distances up to the largest box's diagonal, the maximum of a ray
// inside; levels up to the longest chain.
std::pair<double, double> ShownView::range(const SceneContent& content) const {
  const SurfaceViewRow& row = rowOf(settings_);
  double low = row.low, high = row.high;
  if (row.kind == ViewKind::Scalar && low == high) {
    if (row.id == "level") {
      for (const Probe& probe : content.scene.probes) high = std::max(high, prefilterLevels(probe.faceSize) - 1.0);
    } else {
      double diagonal = 0.0;
      for (const Probe& probe : content.scene.probes) diagonal = std::max(diagonal, glm::length(probe.box.size()));
      if (diagonal == 0.0) diagonal = glm::length(content.bounds().size());
      high = roundedUp(row.id == "hit-error" ? 0.1 * diagonal : diagonal);
    }
    if (high <= low) high = low + 1.0;
  }
  return {settings_.low.value_or(low), settings_.high.value_or(high)};
}

void ShownView::apply(SceneContent& content, DrawState& state, vtkRenderer* renderer) {
  for (DrawnObject& object : content.objects) object.pass->SetDebug(any());
  const auto [low, high] = range(content);
  state.setDebugView({settings_.view, static_cast<float>(low), static_cast<float>(high)});
  std::vector<std::string> names;
  for (const Probe& probe : content.scene.probes) names.push_back(probe.name);
  legend_.show(renderer, rowOf(settings_), low, high, names);
}

void ShownView::setTruth(ImageRgbaF light) {
  truth_ = std::move(light);
  truthChanged_ = true;
}

std::optional<glm::vec4> ShownView::truthAt(int x, int y, int width, int height) const {
  if (truth_.pixels.empty() || width <= 0 || height <= 0) return std::nullopt;
  const auto nearest = [](int i, int count, int texels) {
    return std::clamp(static_cast<int>((i + 0.5) * texels / count), 0, texels - 1);
  };
  const int row = nearest(y, height, truth_.height), column = nearest(x, width, truth_.width);
  const float* p = &truth_.pixels[(static_cast<std::size_t>(row) * static_cast<std::size_t>(truth_.width) +
                                   static_cast<std::size_t>(column)) *
                                  4];
  if (p[3] < 0.0f) return std::nullopt;
  return glm::vec4(p[0], p[1], p[2], p[3]);
}

void ShownView::upload(vtkOpenGLRenderWindow* window, SceneResources& resources) {
  if (!any() || (resources.viewColors != 0 && !truthChanged_)) return;
  legend_.upload(window, resources, truth_);
  truthChanged_ = false;
}

}  // namespace boxprobe
