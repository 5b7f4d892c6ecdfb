// See ray_layer.h.
#include "filters/vtk/rays/ray_layer.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPolyData.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkScalarBarActor.h>
#include <vtkTextProperty.h>

#include <array>
#include <glm/vec3.hpp>
#include <set>
#include <vector>

#include "filters/vtk/rays/ray_arrays.h"
#include "filters/vtk/rays/vtkRayLinesProp.h"

namespace boxprobe {

namespace {

// Relative to the line's width.
constexpr float kDot = 3.4f;        // where a ray hits
constexpr float kErrorLine = 1.8f;  // errors are the main information

void setBarText(vtkTextProperty* text, int size) {
  text->SetFontFamilyToArial();
  text->SetFontSize(size);
  text->SetColor(1.0, 1.0, 1.0);
  text->BoldOff();
  text->ItalicOff();
  text->ShadowOff();
}

// Reads the lines' cells in double, relative to the first point.
class LineReader {
 public:
  explicit LineReader(vtkPolyData* rays) : rays_(rays), kinds_(rays->GetCellData()->GetArray(ray_array::kKind)) {
    if (rays->GetNumberOfPoints() > 0) rays->GetPoint(0, &anchor.x);
  }
  RayKind kind(vtkIdType cell) const {
    return kinds_ != nullptr ? static_cast<RayKind>(static_cast<int>(kinds_->GetComponent(cell, 0)))
                             : RayKind::Reflected;
  }
  glm::vec3 point(vtkIdType id) const {
    glm::dvec3 p;
    rays_->GetPoint(id, &p.x);
    return glm::vec3(p - anchor);
  }
  glm::dvec3 anchor{0.0};

 private:
  vtkPolyData* rays_;
  vtkDataArray* kinds_;
};

bool headed(RayKind kind) {
  return kind == RayKind::Normal || kind == RayKind::Reflected || kind == RayKind::Lookup || kind == RayKind::Refracted;
}

}  // namespace

RayLayer::RayLayer(vtkRenderer* renderer) : renderer_(renderer) {
  bar_->UnconstrainedFontSizeOn();
  setBarText(bar_->GetTitleTextProperty(), 15);
  setBarText(bar_->GetLabelTextProperty(), 14);
  setBarText(bar_->GetAnnotationTextProperty(), 14);
  // Annotations are outside the bar's own background.
  bar_->GetAnnotationTextProperty()->SetBackgroundColor(0.08, 0.08, 0.09);
  bar_->GetAnnotationTextProperty()->SetBackgroundOpacity(0.78);
  bar_->AnnotationTextScalingOff();
  bar_->SetTextPositionToPrecedeScalarBar();
  bar_->DrawBackgroundOn();
  bar_->GetBackgroundProperty()->SetColor(0.08, 0.08, 0.09);
  bar_->GetBackgroundProperty()->SetOpacity(0.78);
  bar_->SetNumberOfLabels(5);
  bar_->SetTextPad(6);
  bar_->SetVerticalTitleSeparation(8);
  bar_->PickableOff();
  // Above the bar of the surfaces' colours, which has the lower half.
  bar_->SetPosition(0.015, 0.57);
}

RayLayer::~RayLayer() {
  setVisible(false);
}

void RayLayer::setRays(vtkPolyData* rays) {
  rays_ = nullptr;
  if (rays != nullptr) {
    // The filter's next execution must not change what is shown here.
    rays_ = vtkSmartPointer<vtkPolyData>::New();
    rays_->ShallowCopy(rays);
  }
  rebuild();
}

void RayLayer::setColoring(RayColoring coloring, const std::optional<RayRange>& locked) {
  if (coloring == coloring_ && locked == locked_) return;
  coloring_ = coloring;
  locked_ = locked;
  rebuild();
}

void RayLayer::setLegendVisible(bool visible) {
  legend_ = visible;
  place();
}

void RayLayer::setLineWidth(double pixels) {
  lineWidth_ = pixels;
  rebuild();
}

void RayLayer::setPixelScale(double devicePixels) {
  lines_->SetPixelScale(static_cast<float>(devicePixels));
}

void RayLayer::setVisible(bool visible) {
  if (visible == visible_) return;
  visible_ = visible;
  if (visible_ && stale_) {
    rebuild();
  } else {
    place();
  }
}

void RayLayer::place() {
  const bool any = visible_ && rays_ && rays_->GetNumberOfLines() > 0;
  if (any != (renderer_->HasViewProp(lines_) != 0)) {
    if (any) {
      renderer_->AddViewProp(lines_);
    } else {
      renderer_->RemoveViewProp(lines_);
    }
  }
  const bool bar = any && legend_;
  if (bar != (renderer_->HasViewProp(bar_) != 0)) {
    if (bar) {
      renderer_->AddViewProp(bar_);
    } else {
      renderer_->RemoveViewProp(bar_);
    }
  }
}

void RayLayer::rebuild() {
  stale_ = !visible_;
  if (!visible_) return;
  std::vector<DrawnLine> drawn;
  glm::dvec3 anchor(0.0);
  if (rays_) {
    const LineReader reader(rays_);
    anchor = reader.anchor;
    const RayColors colors(rays_, coloring_, locked_);
    range_ = colors.range();
    colors.describe(bar_);
    const auto width = static_cast<float>(lineWidth_);
    // Later lines are on top: a true ray coincides with the reflected one, and its error must be visible on both.
    std::vector<DrawnLine> below, heads, dots;
    std::set<std::array<float, 3>> origins;  // one dot for all lookups of a probe
    vtkCellArray* cells = rays_->GetLines();
    drawn.reserve(static_cast<std::size_t>(cells->GetNumberOfCells()) * 2);
    // Cell data count vertices before lines.
    const vtkIdType firstCell = rays_->GetNumberOfVerts();
    for (vtkIdType i = 0; i < cells->GetNumberOfCells(); ++i) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cells->GetCellAtId(i, count, ids);
      if (count != 2) continue;
      const RayKind kind = reader.kind(firstCell + i);
      DrawnLine line;
      line.from = reader.point(ids[0]);
      line.to = reader.point(ids[1]);
      line.color = colors.color(firstCell + i);
      line.widthPixels = kind == RayKind::Error ? kErrorLine * width : width;
      line.arrow = headed(kind) ? 1.0f : 0.0f;
      (kind == RayKind::TrueHit ? below : drawn).push_back(line);
      if (headed(kind)) {
        heads.push_back(line);
        heads.back().arrow = 2.0f;
      }
      const auto dot = [&](const glm::vec3& at) { dots.push_back({at, at, line.color, kDot * width, 0.0f}); };
      if (kind == RayKind::Eye || kind == RayKind::TrueHit) dot(line.to);
      if (kind == RayKind::Lookup && origins.insert({line.from.x, line.from.y, line.from.z}).second) dot(line.from);
    }
    drawn.insert(drawn.begin(), below.begin(), below.end());
    drawn.insert(drawn.end(), heads.begin(), heads.end());
    drawn.insert(drawn.end(), dots.begin(), dots.end());
  }
  lines_->SetLines(std::move(drawn), anchor);
  place();
}

}  // namespace boxprobe
