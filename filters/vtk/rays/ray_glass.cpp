#include "filters/vtk/rays/ray_glass.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

std::optional<GlassRayPath> glassPath(const GlassSurface& glass, const SurfaceRay& ray, const RayView& view,
                                      bool back) {
  // Relative to the point, to preserve precision far from the origin.
  const glm::dvec3 anchor = ray.positionWorld;
  const shading::GlassObject object = glass.object(anchor);
  const shading::ShellSampler* shell = glass.shell ? &glass.shell->shell() : nullptr;
  const auto eye = static_cast<float>(view.parallel ? 0.0 : glm::length(view.eyeWorld - ray.positionWorld));
  const shading::GlassView seen = shading::lookThroughGlass(shell, object, glm::vec3(0.0f), glm::vec3(ray.normalWorld),
                                                            glm::vec3(ray.viewWorld), ray.roughness, back, eye);
  if (seen.reflectance >= 1.0f) return std::nullopt;
  GlassRayPath path;
  const glm::dvec3 exit = anchor + glm::dvec3(seen.through.position);
  if (glass.form == GlassForm::TwoInterface && !glass.sheet && !back) {
    // Repeats the steps, for the corners between.
    const float eta = 1.0f / object.ior;
    glm::vec3 place(0.0f), along = shading::refractedView(glm::vec3(ray.normalWorld), glm::vec3(ray.viewWorld), eta);
    path.within.push_back(anchor);
    for (int i = 0; i < seen.through.mirrored; ++i) {
      const glm::vec4 leave = shading::shellExit(shell, object, place, along);
      place += leave.w * along;
      along -= 2.0f * glm::dot(glm::vec3(leave), along) * glm::vec3(leave);
      path.within.push_back(anchor + glm::dvec3(place));
    }
    path.within.push_back(exit);
  }
  path.leaving = ray;
  path.leaving.positionWorld = exit;
  path.leaving.normalWorld = path.leaving.viewWorld = path.leaving.reflectionWorld = glm::dvec3(seen.through.direction);
  path.leaving.roughness = std::sqrt(seen.through.alpha);
  return path;
}

}  // namespace boxprobe
