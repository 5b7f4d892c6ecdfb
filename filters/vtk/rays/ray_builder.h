// Converts a point's calculated rays to lines: which are drawn, their ends, and their values.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include "filters/vtk/rays/ray_calculation.h"
#include "filters/vtk/rays/ray_glass.h"
#include "filters/vtk/rays/ray_lines.h"

namespace boxprobe {

class RayScene;

struct RayBuilderSettings {
  RayView view;
  std::vector<RayProbe> probes;
  std::vector<Light> lights;
  std::array<bool, kRayKinds> kinds{};
  double maximumLength = 100.0;  ///< of lines without an end, scene units
  double normalLength = 0.25;
  bool contributingOnly = true;  ///< only probes with a share that the picture would sample
  std::vector<RayGlass> glass;
  RayScene* scene = nullptr;  ///< null: the true hit is from the probes' own distances
};

class RayBuilder {
 public:
  /// Both must outlive this object.
  RayBuilder(const RayBuilderSettings& settings, RayLines& lines) : settings_(settings), lines_(lines) {}
  void addPoint(int point, const SurfaceRay& ray);
  /// The refracted rays of a point after addPoint(); `back`: its inner side is seen.
  void addGlass(int point, const SurfaceRay& ray, const GlassSurface& glass, bool back);

 private:
  std::optional<double> sceneDistance(const SurfaceRay& ray) const;
  void add(const RayLine& line);
  void addSkyRay(int point, const SurfaceRay& ray);
  void addProbe(int point, const SurfaceRay& ray, int probe, float share, std::optional<double> sceneDistance);
  void addShadows(const RayLine& common, const SurfaceRay& ray, int probe);
  void addLookups(const RayLine& common, const ProbeRay& found, const RayProbe& probe, const SurfaceRay& ray);

  const RayBuilderSettings& settings_;
  RayLines& lines_;
};

}  // namespace boxprobe
