// See scene_surfaces.h.
#include "app/gui/handles/scene_surfaces.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>
#include <limits>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

/// Möller and Trumbore 1997: how far along `direction`, in its lengths; nothing beside the triangle or behind. Of a
/// triangle that is drawn on one side alone, nothing from behind: `oneSided` is negative where its placement mirrors.
std::optional<double> meetTriangle(const glm::dvec3& origin, const glm::dvec3& direction, const glm::dvec3& a,
                                   const glm::dvec3& b, const glm::dvec3& c, std::optional<double> oneSided) {
  const glm::dvec3 ab = b - a, ac = c - a, p = glm::cross(direction, ac);
  const double determinant = glm::dot(ab, p);
  if (determinant == 0.0 || (oneSided && determinant * *oneSided < 0.0)) return std::nullopt;
  const glm::dvec3 from = origin - a, q = glm::cross(from, ab);
  const double u = glm::dot(from, p) / determinant, v = glm::dot(direction, q) / determinant;
  const double t = glm::dot(ac, q) / determinant;
  if (!(u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0)) return std::nullopt;
  return t;
}

}  // namespace

void SceneSurfaces::setModels(const TriangleRays::Models& models) {
  models_ = models;
  forget();
}

void SceneSurfaces::documentChanged(const Changes& changes) {
  if (changes.models || changes.objects) forget();
}

void SceneSurfaces::setView(PassedParts passed) {
  if (passed.hidden != passed_.hidden) shown_ = {};
  passed_ = std::move(passed);
}

void SceneSurfaces::forget() {
  whole_ = {};
  shown_ = {};
}

const SurfaceRays* SceneSurfaces::rays() {
  return traced(whole_, {});
}

const SurfaceRays* SceneSurfaces::traced(Traced& of, const std::set<std::string>& hidden) const {
  // Between two scenes the models may already be the next one's.
  if (models_.size() != document_.scene().models.size()) return nullptr;
  if (!of.rays && !of.failed && !models_.empty()) {
    try {
      of.rays = std::make_unique<TriangleRays>(document_.scene(), models_, SeenBy::Eyes,
                                               std::vector<std::string>(hidden.begin(), hidden.end()));
    } catch (const std::exception&) {  // too little memory, too
      of.failed = true;
    }
  }
  return of.rays && !of.rays->empty() ? of.rays.get() : nullptr;
}

// One ray against every triangle: a click is rare, and takes some ten milliseconds at a million of them.
std::optional<PickedObject> SceneSurfaces::objectAt(const Ray& given) const {
  const Ray ray = behindCut(given);
  const Scene& scene = document_.scene();
  std::optional<PickedObject> picked;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < models_.size() && i < scene.models.size(); ++i) {
    const Model& model = *models_[i];
    for (const Instance& instance : model.instances) {
      const auto object = scene.objects.find(instance.node);
      if (object != scene.objects.end() && !object->second.visible) continue;
      if (passed_.hidden.count(instance.node) > 0 || passed_.locked.count(instance.node) > 0) continue;
      const glm::dmat4 place =
          movedInstance(worldFromFile(scene.models[i]) * instance.worldFromModel, scene, instance.node);
      const glm::dmat4 back = glm::inverse(place);
      const glm::dvec3 origin(back * glm::dvec4(ray.origin, 1.0)), along(back * glm::dvec4(ray.direction, 0.0));
      const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
      const auto corner = [&](std::size_t at) { return glm::dvec3(mesh.positions[mesh.indices[at]]); };
      const Material* material =
          mesh.material >= 0 ? &model.materials[static_cast<std::size_t>(mesh.material)] : nullptr;
      std::optional<double> oneSided;
      if (material != nullptr && !material->doubleSided) oneSided = glm::determinant(glm::dmat3(place));
      for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
        const auto t = meetTriangle(origin, along, corner(at), corner(at + 1), corner(at + 2), oneSided);
        if (!t || *t >= nearest) continue;
        nearest = *t;
        picked = {instance.node, material != nullptr ? material->name : std::string()};
      }
    }
  }
  return picked;
}

// As the picture is cut: from where the ray enters the box, if it starts before it.
Ray SceneSurfaces::behindCut(const Ray& ray) const {
  if (!passed_.cutaway) return ray;
  const CutBox& cut = *passed_.cutaway;
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(cut.rotationDegrees));
  const glm::dvec3 from = boxFromWorld * (ray.origin - cut.box.center()), along = boxFromWorld * ray.direction;
  const glm::dvec3 half = cut.halfSize();
  double enters = -std::numeric_limits<double>::infinity(), leaves = -enters;
  for (int axis = 0; axis < 3; ++axis) {
    if (along[axis] == 0.0) {
      if (std::abs(from[axis]) > half[axis]) return ray;
      continue;
    }
    const double a = (-half[axis] - from[axis]) / along[axis], b = (half[axis] - from[axis]) / along[axis];
    enters = std::max(enters, std::min(a, b));
    leaves = std::min(leaves, std::max(a, b));
  }
  if (enters <= 0.0 || enters > leaves) return ray;
  return {ray.origin + enters * ray.direction, ray.direction};
}

std::optional<glm::dvec3> SceneSurfaces::meet(const Ray& given) {
  const Ray ray = behindCut(given);
  const SurfaceRays* surfaces = passed_.hidden.empty() ? rays() : traced(shown_, passed_.hidden);
  const auto hit = surfaces != nullptr ? surfaces->first(ray.origin, ray.direction) : std::nullopt;
  if (!hit) return std::nullopt;
  return ray.origin + hit->distance * ray.direction;
}

}  // namespace boxprobe
