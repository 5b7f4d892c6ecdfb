// Selects the materials that reflect enough to be measured, and the pixels that show them.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/core/surface/lit_point.h"
#include "filters/reference/bench/bench_result.h"

namespace boxprobe {

/// By material name: metals, coated and glossy materials; no unlit or diffuse ones.
std::map<std::string, SurfaceKind> reflectingMaterials(const Scene& scene,
                                                       const std::vector<std::shared_ptr<const Model>>& models);

/// The materials with these names, or all if there are none. Throws InputError for an unknown name.
std::map<std::string, SurfaceKind> onlyMaterials(const std::map<std::string, SurfaceKind>& materials,
                                                 const std::vector<std::string>& names);

/// The scene with all of these materials at one roughness, and a single bounce for every probe: a mirror in a mirror is
/// black in both references.
Scene withRoughness(const Scene& scene, const std::map<std::string, SurfaceKind>& materials, double roughness);

/// The scene with this technique for every probe.
Scene withTechnique(Scene scene, const BenchTechnique& technique);

/// A pixel to measure.
struct BenchPixel {
  std::size_t index = 0;  ///< in the picture, rows from the top
  SurfaceKind kind = SurfaceKind::Smooth;
  LitPoint point;
};

/// The points of a picture that show such a material and are mostly lit by probes.
std::vector<BenchPixel> measuredPixels(std::vector<LitPoint> picture, int width,
                                       const std::map<std::string, SurfaceKind>& materials);

}  // namespace boxprobe
