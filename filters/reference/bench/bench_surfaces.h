// Which materials of a scene reflect enough to be measured, and the pixels that show them. Called by the benchmark;
// knows no renderer.
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

/// By material name: metals of any brightness, coated and glossy materials; not unlit or diffuse ones.
std::map<std::string, SurfaceKind> reflectingMaterials(const Scene& scene,
                                                       const std::vector<std::shared_ptr<const Model>>& models);

/// Those of these names; without names all. Throws InputError for a name that is not among them.
std::map<std::string, SurfaceKind> onlyMaterials(const std::map<std::string, SurfaceKind>& materials,
                                                 const std::vector<std::string>& names);

/// The scene with all of them at one roughness, every probe captured once: a mirror in a mirror is black in both
/// truths.
Scene withRoughness(const Scene& scene, const std::map<std::string, SurfaceKind>& materials, double roughness);

/// Every probe with this technique.
Scene withTechnique(Scene scene, const BenchTechnique& technique);

/// A pixel that is measured.
struct BenchPixel {
  std::size_t index = 0;  ///< in the picture, rows from the top
  SurfaceKind kind = SurfaceKind::Smooth;
  LitPoint point;
};

/// Of a whole picture's points those that show such a material, mostly lit by probes.
std::vector<BenchPixel> measuredPixels(std::vector<LitPoint> picture, int width,
                                       const std::map<std::string, SurfaceKind>& materials);

}  // namespace boxprobe
