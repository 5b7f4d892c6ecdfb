// The wire boxes of the probes in a vtkRenderer: the selected probe's box and, dashed, the box inside which it has its
// full weight; the other probes' boxes thin. Called by the probe widget; knows no mouse.
#pragma once

#include <vtkSmartPointer.h>

#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "filters/core/scene.h"

class QColor;
class vtkActor;
class vtkCamera;
class vtkPolyData;
class vtkRenderer;

namespace boxprobe {

/// A set of world-space segments drawn as a coloured line on a wider dark one, to be read before light and dark.
class HaloLines {
 public:
  HaloLines(vtkRenderer* renderer, const QColor& color, double widthPixels, double opacity);
  void setSegments(const std::vector<glm::dvec3>& endpointPairsWorld);
  void setVisible(bool visible);
  /// Draws everything `factor` times as far from `eyeWorld`: the same on the screen, but nearer in depth.
  void pullTowards(const glm::dvec3& eyeWorld, double factor);

 private:
  vtkSmartPointer<vtkPolyData> lines_;
  vtkSmartPointer<vtkActor> halo_, core_;
  glm::dvec3 anchorWorld_{0.0};  ///< the points are relative to it, so that float keeps their precision far from 0
  bool empty_ = true;
};

class WireActors {
 public:
  /// `opacity` of everything drawn; less than 1 where another layer already draws what is not hidden.
  WireActors(vtkRenderer* renderer, double opacity);

  void update(const std::vector<Probe>& probes, std::optional<std::size_t> selected);
  void setVisible(bool visible);
  void pullTowards(const glm::dvec3& eyeWorld, double factor);

 private:
  HaloLines idle_, influence_, blend_, box_;
};

}  // namespace boxprobe
