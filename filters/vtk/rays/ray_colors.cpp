// See ray_colors.h.
#include "filters/vtk/rays/ray_colors.h"

#include <vtkCellData.h>
#include <vtkColorTransferFunction.h>
#include <vtkDataArray.h>
#include <vtkFieldData.h>
#include <vtkLookupTable.h>
#include <vtkPolyData.h>
#include <vtkScalarBarActor.h>
#include <vtkStringArray.h>
#include <vtkVariant.h>

#include <algorithm>
#include <set>

#include "filters/core/picture/probe_color.h"
#include "filters/vtk/rays/ray_arrays.h"

namespace boxprobe {

namespace {

// Distinguishable without colour vision: Okabe and Ito's hues, lightened for thin lines.
const std::vector<glm::vec3>& kindColors() {
  static const std::vector<glm::vec3> colors = {{0.45f, 0.78f, 1.00f}, {0.20f, 0.85f, 0.62f}, {1.00f, 0.65f, 0.10f},
                                                {0.90f, 0.55f, 0.80f}, {0.97f, 0.91f, 0.35f}, {1.00f, 1.00f, 1.00f},
                                                {1.00f, 0.36f, 0.16f}, {0.40f, 0.95f, 0.95f}, {0.30f, 0.60f, 1.00f},
                                                {0.66f, 0.62f, 0.95f}};
  return colors;
}

constexpr glm::vec3 kUndefined(0.72f);

const char* arrayOf(RayColoring coloring) {
  switch (coloring) {
    case RayColoring::Kind:
      return ray_array::kKind;
    case RayColoring::HitDistance:
      return ray_array::kHitDistance;
    case RayColoring::Error:
      return ray_array::kError;
    case RayColoring::Face:
      return ray_array::kFace;
    case RayColoring::Probe:
      return ray_array::kProbe;
  }
  return ray_array::kKind;
}

std::vector<std::string> probeNames(vtkPolyData* rays) {
  std::vector<std::string> names;
  auto* array = vtkStringArray::SafeDownCast(rays->GetFieldData()->GetAbstractArray(ray_array::kProbeNames));
  if (array == nullptr) return names;
  for (vtkIdType i = 0; i < array->GetNumberOfValues(); ++i) names.push_back(array->GetValue(i));
  return names;
}

}  // namespace

RayColors::RayColors(vtkPolyData* rays, RayColoring coloring, const std::optional<RayRange>& locked)
    : values_(rays->GetCellData()->GetArray(arrayOf(coloring))) {
  switch (coloring) {
    case RayColoring::Kind:
      title_ = "Rays";
      useChoices(kindColors(), {std::begin(kRayKindNames), std::end(kRayKindNames)});
      break;
    case RayColoring::HitDistance:
      title_ = "Hit distance\nscene units";
      useNumber(locked);
      break;
    case RayColoring::Error:
      title_ = "Hit error\nscene units";
      useNumber(locked);
      break;
    case RayColoring::Face: {
      title_ = "Face hit";
      // Half of the faces' colours are too dark for thin lines.
      std::vector<glm::vec3> colors;
      for (const glm::vec3& c : faceColors()) colors.push_back(0.25f + 0.75f * c);
      useChoices(colors, {"-x", "+x", "-y", "+y", "-z", "+z"});
      break;
    }
    case RayColoring::Probe: {
      title_ = "Probe";
      const std::vector<std::string> names = probeNames(rays);
      std::vector<glm::vec3> colors;
      for (std::size_t i = 0; i < names.size(); ++i) colors.push_back(probeColor(static_cast<int>(i)));
      useChoices(colors, names);
      break;
    }
  }
}

RayColors::~RayColors() = default;

void RayColors::useNumber(const std::optional<RayRange>& locked) {
  double low = 0.0, high = 0.0;
  for (vtkIdType i = 0; values_ && i < values_->GetNumberOfTuples(); ++i) {
    high = std::max(high, values_->GetComponent(i, 0));  // negative: undefined
  }
  if (locked) {
    low = locked->low;
    high = locked->high;
  }
  // A bar needs a length, even if all values are 0.
  range_ = {low, std::max(high, low + 1.0e-6)};
  // From blue to pale yellow, bright from the start because lines are thin, with increasing lightness.
  vtkNew<vtkColorTransferFunction> colors;
  colors->SetColorSpaceToLab();
  const auto at = [&](double share) { return range_.low + share * (range_.high - range_.low); };
  colors->AddRGBPoint(at(0.0), 0.42, 0.55, 1.00);
  colors->AddRGBPoint(at(0.5), 0.20, 0.76, 0.67);
  colors->AddRGBPoint(at(1.0), 1.00, 0.95, 0.50);
  table_ = colors;
}

void RayColors::useChoices(const std::vector<glm::vec3>& colors, const std::vector<std::string>& names) {
  choices_ = colors;
  std::set<int> used;
  for (vtkIdType i = 0; values_ && i < values_->GetNumberOfTuples(); ++i) {
    used.insert(static_cast<int>(values_->GetComponent(i, 0)));
  }
  std::vector<int> shown;
  for (const int value : used) {
    if (value >= 0 && static_cast<std::size_t>(value) < colors.size()) shown.push_back(value);
  }
  vtkNew<vtkLookupTable> table;
  table->SetNumberOfTableValues(static_cast<vtkIdType>(shown.size()));
  table->IndexedLookupOn();
  for (std::size_t i = 0; i < shown.size(); ++i) {
    const auto value = static_cast<std::size_t>(shown[i]);
    table->SetTableValue(static_cast<vtkIdType>(i), colors[value].x, colors[value].y, colors[value].z, 1.0);
    table->SetAnnotation(vtkVariant(shown[i]), value < names.size() ? names[value] : std::to_string(value));
  }
  range_ = {0.0, static_cast<double>(colors.size()) - 1.0};
  table_ = table;
}

glm::vec3 RayColors::color(long long cell) const {
  const double value = values_ && cell < values_->GetNumberOfTuples() ? values_->GetComponent(cell, 0) : -1.0;
  if (value < 0.0) return kUndefined;
  if (!choices_.empty()) {
    const auto index = static_cast<std::size_t>(value);
    return index < choices_.size() ? choices_[index] : kUndefined;
  }
  double rgb[3];
  table_->GetColor(std::clamp(value, range_.low, range_.high), rgb);
  return glm::vec3(rgb[0], rgb[1], rgb[2]);
}

void RayColors::describe(vtkScalarBarActor* bar) const {
  bar->SetTitle(title_.c_str());
  bar->SetLookupTable(table_);
  const double size = range_.high - range_.low;
  bar->SetLabelFormat(size >= 10.0 ? "%.1f" : size >= 0.1 ? "%.2f" : "%.2e");
  const int entries = static_cast<int>(table_->GetNumberOfAnnotatedValues());
  bar->SetWidth(choices_.empty() ? 0.13 : 0.055);
  bar->SetHeight(choices_.empty() ? 0.36 : std::min(0.40, 0.08 + 0.045 * entries));
}

}  // namespace boxprobe
