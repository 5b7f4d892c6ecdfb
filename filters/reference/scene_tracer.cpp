#include "filters/reference/scene_tracer.h"

#include <embree3/rtcore.h>

#include <algorithm>
#include <cstring>
#include <glm/geometric.hpp>
#include <limits>
#include <string>

#include "filters/core/errors.h"
#include "filters/reference/surface_texture.h"

namespace boxprobe {

namespace {

// Called by Embree for each triangle that a ray of one lane meets.
void leaveOutBackFace(const RTCFilterFunctionNArguments* args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const float along = ray->dir_x * hit->Ng_x + ray->dir_y * hit->Ng_y + ray->dir_z * hit->Ng_z;
  if (along > 0.0f) args->valid[0] = 0;
}

RTCGeometry makeGeometry(RTCDevice device, const TracedObject& object) {
  RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
  void* positions = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3, sizeof(glm::vec3),
                                            object.positions.size());
  void* indices = rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                          3 * sizeof(std::uint32_t), object.indices.size() / 3);
  if (positions != nullptr && indices != nullptr) {
    std::memcpy(positions, object.positions.data(), object.positions.size() * sizeof(glm::vec3));
    std::memcpy(indices, object.indices.data(), object.indices.size() / 3 * 3 * sizeof(std::uint32_t));
    if (!object.material.doubleSided) rtcSetGeometryIntersectFilterFunction(geometry, leaveOutBackFace);
  }
  rtcCommitGeometry(geometry);
  return geometry;
}

glm::vec3 unitOr(const glm::vec3& v, const glm::vec3& otherwise) {
  const float length = glm::length(v);
  return length > 0.0f ? v / length : otherwise;
}

float reflectanceOf(float iorTo, float iorFrom) {
  const float r = (iorTo - iorFrom) / (iorTo + iorFrom);
  return r * r;
}

// The triangle's three values of an attribute at a hit.
template <typename Value>
Value interpolated(const std::vector<Value>& values, const std::uint32_t* corners, const glm::dvec2& barycentric) {
  const auto v = static_cast<float>(barycentric.x), w = static_cast<float>(barycentric.y);
  return (1.0f - v - w) * values[corners[0]] + v * values[corners[1]] + w * values[corners[2]];
}

// VTK 9.1: the tangent made perpendicular to the normal, the bitangent without glTF's handedness.
glm::vec3 mappedNormal(const Material& material, const glm::vec2& uv, const glm::vec3& n, const glm::vec3& tangent) {
  const glm::vec3 t = unitOr(tangent - glm::dot(tangent, n) * n, glm::vec3(0.0f));
  const glm::vec3 b = glm::cross(n, t);
  const glm::vec3 packed(sampleTexture(material.normalTexture, uv, false));
  const glm::vec3 scaled = (2.0f * packed - 1.0f) * glm::vec3(material.normalScale, material.normalScale, 1.0f);
  const glm::vec3 turned = unitOr(scaled, glm::vec3(0.0f, 0.0f, 1.0f));
  return unitOr(turned.x * t + turned.y * b + turned.z * n, n);
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
  s.device = rtcNewDevice(nullptr);
  if (s.device == nullptr) throw WorkError("the ray tracer (Embree) does not start on this machine");
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
  if (const RTCError error = rtcGetDeviceError(s.device); error != RTC_ERROR_NONE) {
    throw WorkError("the ray tracer (Embree) cannot take the scene, error " + std::to_string(error) +
                    (error == RTC_ERROR_OUT_OF_MEMORY ? ": not enough memory" : ""));
  }
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
  RTCIntersectContext context;
  rtcInitIntersectContext(&context);
  rtcIntersect1(sees == RaySees::Picture ? structures_->picture : structures_->probes, &context, &query);
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
  if (hit.backSide) hit.frontWorld = -hit.frontWorld;
  return hit;
}

glm::dvec3 SceneTracer::awayFrom(const TracedHit& hit) const {
  // Embree subtracts the ray's origin from the corners in single precision: off by up to 1.2e-7 of the radius each, a
  // few times that in the triangle's plane. Less would let rays leave through the surface they start from.
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

  // Without texture coordinates there is no picture on the surface.
  static const TextureUse none;
  const bool textured = !o.uv.empty();
  const glm::vec2 uv = textured ? interpolated(o.uv, corners, hit.barycentric) : glm::vec2(0.0f);
  const auto sampled = [&](const TextureUse& use, bool srgb) { return sampleTexture(textured ? use : none, uv, srgb); };
  const glm::vec3 base = glm::vec3(m.baseColor) * glm::vec3(sampled(m.baseColorTexture, true));
  if (m.unlit) {
    s.emissive = base;
    s.normalWorld = normal;
    return s;
  }
  if (textured && m.normalTexture.image && !o.tangents.empty()) {
    normal = mappedNormal(m, uv, normal, interpolated(o.tangents, corners, hit.barycentric));
  }
  const glm::vec4 roughMetal = sampled(m.metallicRoughnessTexture, false);
  s.normalWorld = normal;
  s.albedo = base;
  s.emissive = m.emissive * glm::vec3(sampled(m.emissiveTexture, true));
  s.metallic = m.metallic * roughMetal.b;
  s.roughness = m.roughness * roughMetal.g;
  if (m.occlusionTexture.image) {
    s.occlusion = glm::mix(1.0f, sampled(m.occlusionTexture, false).r, m.occlusionStrength);
  }
  // As vtkProperty has it: a coat of index 2, and a base between lying in air and lying under it.
  constexpr float kCoatIor = 2.0f;
  s.baseF0 = glm::mix(reflectanceOf(m.ior, 1.0f), reflectanceOf(m.ior, kCoatIor), m.coat);
  s.coatStrength = m.coat;
  s.coatRoughness = m.coatRoughness;
  s.coatF0 = reflectanceOf(kCoatIor, 1.0f);
  return s;
}

}  // namespace boxprobe
