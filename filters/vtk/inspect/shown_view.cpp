#include "filters/vtk/inspect/shown_view.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/sampling/filter_lobe.h"

namespace boxprobe {

namespace {

// To two digits, so that the ends of a scale are readable.
double roundedUp(double x) {
  const double digit = std::pow(10.0, std::floor(std::log10(std::max(x, 1.0e-30))) - 1.0);
  return std::ceil(x / digit) * digit;
}

const SurfaceViewRow& rowOf(const SurfaceViewSettings& settings) {
  return surfaceViews()[static_cast<std::size_t>(settings.view)];
}

}  // namespace

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

void ShownView::upload(vtkOpenGLRenderWindow* window, SceneResources& resources) const {
  if (any()) legend_.upload(window, resources);
}

}  // namespace boxprobe
