#include "filters/reference/trace/scene_tracer.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/embree.h"
#include "filters/core/scene/coat.h"
#include "filters/reference/trace/surface_texture.h"

namespace boxprobe {

namespace {

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

float reflectanceOf(float iorTo, float iorFrom) {
  const float r = (iorTo - iorFrom) / (iorTo + iorFrom);
  return r * r;
}

// An attribute at a hit, interpolated between the triangle's three corners.
template <typename Value>
Value interpolated(const std::vector<Value>& values, const std::uint32_t* corners, const glm::dvec2& barycentric) {
  const auto v = static_cast<float>(barycentric.x), w = static_cast<float>(barycentric.y);
  return (1.0f - v - w) * values[corners[0]] + v * values[corners[1]] + w * values[corners[2]];
}

// shaders/gpu/material.glsl, bpMappedNormal.
glm::vec3 mappedNormal(const glm::vec3& n, const glm::vec4& tangent, const glm::vec3& packed, float scale) {
  const glm::vec3 along(tangent);
  const glm::vec3 t = unitOr(along - glm::dot(along, n) * n, glm::vec3(0.0f));
  const glm::vec3 b = glm::cross(n, t) * (tangent.w < 0.0f ? -1.0f : 1.0f);
  const glm::vec3 mapped = (2.0f * packed - 1.0f) * glm::vec3(scale, scale, 1.0f);
  return unitOr(mapped.x * t + mapped.y * b + mapped.z * n, n);
}

// The attributes of a surface at a point.
class Attributes {
 public:
  Attributes(const TracedObject& object, const std::uint32_t* corners, const glm::dvec2& barycentric)
      : object_(object), corners_(corners), barycentric_(barycentric) {}

  /// White if there is no picture or no texture coordinates.
  glm::vec4 sampled(const TextureUse& use, bool srgb) const {
    const std::vector<glm::vec2>& set = use.uvSet == 1 ? object_.uv1 : object_.uv;
    if (!use.image || set.empty()) return glm::vec4(1.0f);
    return sampleTexture(use, interpolated(set, corners_, barycentric_), srgb);
  }
  bool mapped(const TextureUse& use) const {
    return use.image && !(use.uvSet == 1 ? object_.uv1 : object_.uv).empty() && !object_.tangents.empty();
  }
  glm::vec4 base() const {
    glm::vec4 base = object_.material.baseColor * sampled(object_.material.baseColorTexture, true);
    if (!object_.colors.empty()) base *= interpolated(object_.colors, corners_, barycentric_);
    return base;
  }
  /// As in shaders/gpu/finish.glsl.
  PointFinish finish(const SurfacePoint& s, bool backSide) const {
    const MaterialFinish& f = object_.material.finish;
    PointFinish point;
    const float strength = sampled(f.specularTexture, false).a;
    point.tinted = f.tintsSpecular();
    point.edge = f.specularEdge * strength;
    point.f0 = strength * glm::min(s.baseF0 * f.specularTint * glm::vec3(sampled(f.specularColorTexture, true)),
                                   glm::vec3(f.specularEdge));
    if (!point.tinted) point.f0 = glm::vec3(s.baseF0);
    point.sheenColor = f.sheenColor * glm::vec3(sampled(f.sheenColorTexture, true));
    point.sheenRoughness = f.sheenRoughness * sampled(f.sheenRoughnessTexture, false).a;
    point.iridescence = f.iridescence * sampled(f.iridescenceTexture, false).r;
    point.filmIor = f.filmIor;
    const float thick = mapsTo(f.filmThicknessTexture) ? sampled(f.filmThicknessTexture, false).g : 1.0f;
    if (f.hasFilm()) point.filmThickness = glm::mix(f.filmThicknessMin, f.filmThicknessMax, thick);
    if (f.isAnisotropic() && !object_.tangents.empty()) brush(point, s.normalWorld, backSide);
    return point;
  }

 private:
  bool mapsTo(const TextureUse& use) const { return use.image && !(use.uvSet == 1 ? object_.uv1 : object_.uv).empty(); }
  void brush(PointFinish& point, const glm::vec3& normal, bool backSide) const {
    const MaterialFinish& f = object_.material.finish;
    const glm::vec4 given = interpolated(object_.tangents, corners_, barycentric_);
    const glm::vec3 along(given), flat = along - glm::dot(along, normal) * normal;
    if (!(glm::length(flat) > 0.0f)) return;
    const glm::vec3 tangent = glm::normalize(flat);
    const float side = (given.w < 0.0f) != backSide ? -1.0f : 1.0f;
    const glm::vec3 bitangent = side * glm::cross(normal, tangent);
    float angle = f.anisotropyRotation;
    point.anisotropy = f.anisotropy;
    if (mapsTo(f.anisotropyTexture)) {
      const glm::vec4 texel = sampled(f.anisotropyTexture, false);
      const glm::vec2 own = 2.0f * glm::vec2(texel) - 1.0f;
      if (own != glm::vec2(0.0f)) angle += std::atan2(own.y, own.x);
      point.anisotropy *= texel.b;
    }
    point.acrossWorld = std::cos(angle) * bitangent - std::sin(angle) * tangent;
  }

  const TracedObject& object_;
  const std::uint32_t* corners_;
  glm::dvec2 barycentric_;
};

// Embree's filter for each triangle that a ray meets: skips back faces of single-sided surfaces, and masked-out texels.
void skipHit(const RTCFilterFunctionNArguments* args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const auto& object = *static_cast<const TracedObject*>(args->geometryUserPtr);
  const float along = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z;
  if (along > 0.0f && !object.material.doubleSided) args->valid[0] = 0;
  if (object.material.alphaMode != AlphaMode::Mask) return;
  const Attributes at(object, &object.indices[3 * static_cast<std::size_t>(hit->primID)], {hit->u, hit->v});
  if (at.base().a < object.material.alphaCutoff) args->valid[0] = 0;
}

RTCGeometry makeGeometry(RTCDevice device, const TracedObject& object) {
  RTCGeometry geometry = newTriangleGeometry(device, object.positions, object.indices);
  if (!object.material.doubleSided || object.material.alphaMode == AlphaMode::Mask) {
    rtcSetGeometryUserData(geometry, const_cast<TracedObject*>(&object));
    rtcSetGeometryIntersectFilterFunction(geometry, skipHit);
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

}  // namespace

struct SceneTracer::Structures {
  RTCDevice device = nullptr;
  RTCScene picture = nullptr;
  RTCScene probes = nullptr;

  ~Structures() {
    if (picture != nullptr) rtcReleaseScene(picture);
    if (probes != nullptr) rtcReleaseScene(probes);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

SceneTracer::SceneTracer(TriangleScene scene) : scene_(std::move(scene)), structures_(std::make_unique<Structures>()) {
  Structures& s = *structures_;
  s.device = newRayDevice();
  for (RTCScene* target : {&s.picture, &s.probes}) {
    *target = rtcNewScene(s.device);
    rtcSetSceneFlags(*target, RTC_SCENE_FLAG_ROBUST);
  }
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const TracedObject& object = scene_.objects[i];
    if (object.indices.size() < 3 || !(object.inPicture || object.inProbes)) continue;
    RTCGeometry geometry = makeGeometry(s.device, object);
    if (object.inPicture) rtcAttachGeometryByID(s.picture, geometry, static_cast<unsigned>(i));
    if (object.inProbes) rtcAttachGeometryByID(s.probes, geometry, static_cast<unsigned>(i));
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(s.picture);
  rtcCommitScene(s.probes);
  checkCommitted(s.device, "the scene");
}

SceneTracer::~SceneTracer() = default;

std::optional<TracedHit> SceneTracer::firstHit(const glm::dvec3& origin, const glm::dvec3& direction,
                                               RaySees sees) const {
  const double length = glm::length(direction);
  if (!(length > 0.0)) return std::nullopt;
  const glm::dvec3 unit = direction / length;
  const glm::vec3 from(origin - scene_.anchorWorld), along(unit);
  RTCRayHit query;
  query.ray = {from.x, from.y, from.z, 0.0f, along.x, along.y, along.z, 0.0f, std::numeric_limits<float>::infinity(),
               ~0u,    0u,     0u};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  intersectOne(sees == RaySees::Picture ? structures_->picture : structures_->probes, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;

  TracedHit hit;
  hit.object = static_cast<int>(query.hit.geomID);
  hit.triangle = query.hit.primID;
  const TracedObject& o = object(hit);
  const std::uint32_t* corners = &o.indices[3 * static_cast<std::size_t>(hit.triangle)];
  const glm::dvec3 a(o.positions[corners[0]]), b(o.positions[corners[1]]), c(o.positions[corners[2]]);
  hit.barycentric = {query.hit.u, query.hit.v};
  hit.positionWorld = scene_.anchorWorld + (1.0 - hit.barycentric.x - hit.barycentric.y) * a + hit.barycentric.x * b +
                      hit.barycentric.y * c;
  hit.distance = glm::dot(hit.positionWorld - origin, unit);
  hit.frontWorld = glm::normalize(glm::cross(b - a, c - a));
  hit.backSide = glm::dot(hit.frontWorld, unit) > 0.0;
  hit.cosine = std::abs(glm::dot(hit.frontWorld, unit));
  if (hit.backSide) hit.frontWorld = -hit.frontWorld;
  return hit;
}

glm::dvec3 SceneTracer::awayFrom(const TracedHit& hit) const {
  // Embree subtracts the ray's origin from the corners in single precision: an error of up to 1.2e-7 of the radius
  // each, several times that in the triangle's plane. A smaller value would let rays leave through the surface they
  // start from.
  constexpr double kShare = 2.0e-6;
  return hit.positionWorld + kShare * scene_.radius * hit.frontWorld;
}

SurfacePoint SceneTracer::surface(const TracedHit& hit, const glm::dvec3& eye) const {
  const TracedObject& o = object(hit);
  const Material& m = o.material;
  const std::uint32_t* corners = &o.indices[3 * static_cast<std::size_t>(hit.triangle)];
  SurfacePoint s;
  s.positionWorld = hit.positionWorld;
  s.eyeWorld = eye;
  s.viewWorld = unitOr(glm::vec3(eye - hit.positionWorld), glm::vec3(hit.frontWorld));
  const glm::vec3 front(hit.frontWorld);
  glm::vec3 normal = o.normals.empty() ? front : unitOr(interpolated(o.normals, corners, hit.barycentric), front);
  if (hit.backSide && !o.normals.empty()) normal = -normal;
  s.coatNormalWorld = normal;

  const Attributes at(o, corners, hit.barycentric);
  const glm::vec4 base = at.base();
  s.opacity = m.alphaMode == AlphaMode::Blend ? base.a : 1.0f;
  if (m.unlit) {
    s.emissive = glm::vec3(base);
    s.normalWorld = normal;
    return s;
  }
  // The frame of a back face is reversed as a whole.
  const float side = hit.backSide ? -1.0f : 1.0f;
  const auto turned = [&](const TextureUse& use, float scale) {
    if (!at.mapped(use)) return normal;
    return side * mappedNormal(side * normal, interpolated(o.tangents, corners, hit.barycentric),
                               glm::vec3(at.sampled(use, false)), scale);
  };
  const glm::vec4 roughMetal = at.sampled(m.metallicRoughnessTexture, false);
  s.normalWorld = turned(m.normalTexture, m.normalScale);
  s.coatNormalWorld = turned(m.coatNormalTexture, m.coatNormalScale);
  s.albedo = glm::vec3(base);
  s.emissive = m.emissive * glm::vec3(at.sampled(m.emissiveTexture, true));
  s.metallic = m.metallic * roughMetal.b;
  s.roughness = m.roughness * roughMetal.g;
  s.occlusion = glm::mix(1.0f, at.sampled(m.occlusionTexture, false).r, m.occlusionStrength);
  // As in vtkProperty: the base reflectance is interpolated between that in air and that under its coat.
  s.baseF0 = glm::mix(reflectanceOf(m.reflectedIor(), 1.0f), reflectanceOf(m.reflectedIor(), kCoatIor), m.coat);
  s.coatStrength = m.coat * at.sampled(m.coatTexture, false).r;
  s.coatRoughness = m.coatRoughness * at.sampled(m.coatRoughnessTexture, false).g;
  s.coatF0 = reflectanceOf(kCoatIor, 1.0f);
  if (m.finish.any() && !m.transmits()) s.finish = at.finish(s, hit.backSide);
  return s;
}

}  // namespace boxprobe
