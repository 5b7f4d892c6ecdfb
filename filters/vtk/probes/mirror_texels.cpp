// See mirror_texels.h.
#include "filters/vtk/probes/mirror_texels.h"

#include <vtkCamera.h>

#include <algorithm>
#include <cmath>
#include <glm/trigonometric.hpp>

#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/gl/map_bytes.h"
#include "filters/vtk/surface/vtkProbePass.h"

namespace boxprobe {

namespace {

constexpr double kMirrorRoughness = 0.1;  // the lobes of rougher surfaces are wider than texels
constexpr int kMostTexels = 1024, kMostTimes = 4;

// Texels a side of a face, which spans 90 degrees, none of them larger than a pixel in the middle of the picture.
// Smaller ones alias.
double texelsOfPixels(vtkCamera* camera, int rows) {
  const double half = camera->GetParallelProjection() ? 0.5 : std::tan(0.5 * glm::radians(camera->GetViewAngle()));
  return rows / std::max(half, 1.0e-3);
}

}  // namespace

std::map<std::string, int> mirrorFaceSizes(const SceneContent& content, vtkCamera* camera, int rows,
                                           std::size_t bytes) {
  const double wanted = texelsOfPixels(camera, rows);
  std::map<std::string, int> sizes;
  std::size_t taken = 0;
  for (const DrawnObject& object : content.objects) {
    const ProbeBinding* binding = object.pass->GetBinding();
    if (!object.settings.visible || binding == nullptr || object.roughnessMin >= kMirrorRoughness) continue;
    for (std::size_t slot = 0; slot < binding->probes.size(); ++slot) {
      const auto& drawn = binding->probes[slot];
      // An impostor's steps are for the distances of the scene's own size.
      if (projectionRows()[static_cast<std::size_t>(binding->technique(slot).projection)].distances) continue;
      if (drawn->index < 0 || static_cast<std::size_t>(drawn->index) >= content.scene.probes.size()) continue;
      const Probe& probe = content.scene.probes[static_cast<std::size_t>(drawn->index)];
      int size = probe.faceSize;
      while (size < wanted && 2 * size <= std::min(kMostTexels, kMostTimes * probe.faceSize)) size *= 2;
      if (size == probe.faceSize || sizes.count(probe.name) != 0) continue;
      taken += probeMapsBytes(size, true);
      if (taken > bytes) return sizes;
      sizes[probe.name] = size;
    }
  }
  return sizes;
}

}  // namespace boxprobe
