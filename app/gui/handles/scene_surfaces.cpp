// See scene_surfaces.h.
#include "app/gui/handles/scene_surfaces.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/model_placement.h"

namespace boxprobe {

namespace {

/// Möller and Trumbore 1997: how far along `direction`, in its lengths; nothing beside the triangle or behind.
std::optional<double> meetTriangle(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a,
                                   const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0) return std::nullopt;
  const glm::dvec3 from = origin - a, q = glm::cross(from, ab);
  const double u = glm::dot(from, p) / determinant, v = glm::dot(direction, q) / determinant;
  const double t = glm::dot(ac, q) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0)) return std::nullopt;
  return t;
}

}  // namespace

void SceneSurfaces::setModels(const TriangleRays::Models& models) {
  models_ = models;
  rays_.reset();
  failed_ = false;
}

void SceneSurfaces::documentChanged(const Changes& changes) {
  if (!changes.models && !changes.objects) return;
  rays_.reset();
  failed_ = false;
}

const SurfaceRays* SceneSurfaces::rays() {
  // Between two scenes the models may already be the next one's.
  if (models_.size() != document_.scene().models.size()) return nullptr;
  if (!rays_ && !failed_ && !models_.empty()) {
    try {
      rays_ = std::make_unique<TriangleRays>(document_.scene(), models_);
    } catch (const Error&) {
      failed_ = true;
    }
  }
  return rays_ && !rays_->empty() ? rays_.get() : nullptr;
}

// One ray against every triangle: a click is rare, and takes some ten milliseconds at a million of them.
std::optional<PickedObject> SceneSurfaces::objectAt(const Ray& ray) const {
  const Scene& scene = document_.scene();
  std::optional<PickedObject> picked;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < models_.size() && i < scene.models.size(); ++i) {
    const Model& model = *models_[i];
    for (const Instance& instance : model.instances) {
      const auto object = scene.objects.find(instance.node);
      if (object != scene.objects.end() && !object->second.visible) continue;
      const glm::dmat4 place =
          movedInstance(worldFromFile(scene.models[i]) * instance.worldFromModel, scene, instance.node);
      const glm::dmat4 back = glm::inverse(place);
      const glm::dvec3 origin(back * glm::dvec4(ray.origin, 1.0)), along(back * glm::dvec4(ray.direction, 0.0));
      const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
      const auto corner = [&](std::size_t at) { return glm::dvec3(mesh.positions[mesh.indices[at]]); };
      for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
        const auto t = meetTriangle(origin, along, corner(at), corner(at + 1), corner(at + 2));
        if (!t || *t >= nearest) continue;
        nearest = *t;
        const bool own = mesh.material >= 0;
        picked = PickedObject{instance.node,
                              own ? model.materials[static_cast<std::size_t>(mesh.material)].name : std::string()};
      }
    }
  }
  return picked;
}

std::optional<glm::dvec3> SceneSurfaces::meet(const Ray& ray) {
  const SurfaceRays* surfaces = rays();
  const auto hit = surfaces != nullptr ? surfaces->first(ray.origin, ray.direction) : std::nullopt;
  if (!hit) return std::nullopt;
  return ray.origin + hit->distance * ray.direction;
}

}  // namespace boxprobe
