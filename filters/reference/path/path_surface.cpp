#include "filters/reference/path/path_surface.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>
#include <map>
#include <string>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/core/geometry/embree.h"

namespace boxprobe {

namespace {

/// IEC 61966-2-1.
double linearOf(std::uint8_t byte) {
  const double s = byte / 255.0;
  return s <= 0.04045 ? s / 12.92 : std::pow((s + 0.055) / 1.055, 2.4);
}

struct Decoded {
  double linear[256];
  Decoded() {
    for (int i = 0; i < 256; ++i) linear[i] = linearOf(static_cast<std::uint8_t>(i));
  }
};

double wrapped(double x, Wrap wrap) {
  switch (wrap) {
    case Wrap::ClampToEdge:
      return x;
    case Wrap::MirroredRepeat: {
      const double within = std::fabs(std::fmod(x, 2.0));
      return within > 1.0 ? 2.0 - within : within;
    }
    case Wrap::Repeat:
      break;
  }
  return x - std::floor(x);
}

/// Applies the wrap mode to a texel index, as in OpenGL (glTF 2.0, 3.8.4).
int texelAt(int i, int size, Wrap wrap) {
  if (wrap == Wrap::Repeat) return (i % size + size) % size;
  return std::clamp(i, 0, size - 1);  // mirrored repeat clamps at its edge
}

/// Bilinear, bytes decoded before interpolation; white without a picture.
glm::dvec4 sampled(const TextureUse& use, const glm::dvec2& coordinates, bool srgb) {
  static const Decoded decoded;
  if (!use.image || use.image->width <= 0 || use.image->height <= 0) return glm::dvec4(1.0);
  const ImageRgba8& image = *use.image;
  const auto& m = use.uvTransform;
  const double u = m[0][0] * coordinates.x + m[1][0] * coordinates.y + m[2][0];
  const double v = m[0][1] * coordinates.x + m[1][1] * coordinates.y + m[2][1];
  if (!std::isfinite(u) || !std::isfinite(v)) return glm::dvec4(0.0);
  const double nudge = use.nearest ? 0.0 : 0.5;
  const double x = std::clamp(wrapped(u, use.wrapS), -1.0, 2.0) * image.width - nudge;
  const double y = std::clamp(wrapped(v, use.wrapT), -1.0, 2.0) * image.height - nudge;
  const int column = static_cast<int>(std::floor(x)), row = static_cast<int>(std::floor(y));
  const double a = use.nearest ? 0.0 : x - column, b = use.nearest ? 0.0 : y - row;
  glm::dvec4 sum(0.0);
  for (int i = 0; i < 4; ++i) {
    const double weight = ((i & 1) != 0 ? a : 1.0 - a) * ((i & 2) != 0 ? b : 1.0 - b);
    if (weight == 0.0) continue;
    const auto c = static_cast<std::size_t>(texelAt(column + (i & 1), image.width, use.wrapS));
    const auto r = static_cast<std::size_t>(texelAt(row + (i >> 1), image.height, use.wrapT));
    const std::uint8_t* p = &image.pixels[4 * (r * static_cast<std::size_t>(image.width) + c)];
    for (int k = 0; k < 3; ++k) sum[k] += weight * (srgb ? decoded.linear[p[k]] : p[k] / 255.0);
    sum.w += weight * p[3] / 255.0;
  }
  return sum;
}

template <typename Vector>
Vector between(const std::vector<Vector>& values, const std::uint32_t* corners, const glm::dvec2& barycentric) {
  using Scalar = typename Vector::value_type;
  const auto b = static_cast<Scalar>(barycentric.x), c = static_cast<Scalar>(barycentric.y);
  return (Scalar(1) - b - c) * values[corners[0]] + b * values[corners[1]] + c * values[corners[2]];
}

/// The values of a material's textures at one point.
class Textured {
 public:
  Textured(const TracedObject& object, std::uint32_t triangle, const glm::dvec2& barycentric)
      : object_(object), corners_(&object.indices[3 * static_cast<std::size_t>(triangle)]), barycentric_(barycentric) {}

  glm::dvec4 of(const TextureUse& use, bool srgb) const {
    const auto& set = use.uvSet == 1 ? object_.uv1 : object_.uv;
    if (set.empty()) return glm::dvec4(1.0);
    return sampled(use, glm::dvec2(between(set, corners_, barycentric_)), srgb);
  }
  glm::dvec4 base() const {
    glm::dvec4 color(object_.material.baseColor);
    color *= of(object_.material.baseColorTexture, true);
    if (!object_.colors.empty()) color *= glm::dvec4(between(object_.colors, corners_, barycentric_));
    return color;
  }
  const std::uint32_t* corners() const { return corners_; }

 private:
  const TracedObject& object_;
  const std::uint32_t* corners_;
  glm::dvec2 barycentric_;
};

/// Set for camera rays: a filter of a scene gets Embree's query only through its context.
thread_local bool eyeAsks = false;

void skipHit(const RTCFilterFunctionNArguments* args) {
  const auto* ray = reinterpret_cast<const RTCRay*>(args->ray);
  const auto* hit = reinterpret_cast<const RTCHit*>(args->hit);
  const auto& object = *static_cast<const TracedObject*>(args->geometryUserPtr);
  const Material& material = object.material;
  const double along = static_cast<double>(ray->dir_x) * hit->Ng_x + static_cast<double>(ray->dir_y) * hit->Ng_y +
                       static_cast<double>(ray->dir_z) * hit->Ng_z;
  const bool shines = material.emissive != glm::vec3(0.0f);
  if (along > 0.0 && !material.doubleSided && (eyeAsks || shines)) args->valid[0] = 0;
  if (material.alphaMode != AlphaMode::Mask) return;
  if (Textured(object, hit->primID, {hit->u, hit->v}).base().w < material.alphaCutoff) args->valid[0] = 0;
}

glm::dvec3 unitOr(const glm::dvec3& v, const glm::dvec3& otherwise) {
  const double length = glm::length(v);
  return length > 1.0e-12 && std::isfinite(length) ? v / length : otherwise;
}

glm::dvec3 anyAcross(const glm::dvec3& n) {
  const glm::dvec3 axis = std::abs(n.x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  return glm::normalize(glm::cross(axis, n));
}

}  // namespace

struct PathScene::Structures {
  RTCDevice device = nullptr;
  RTCScene scene = nullptr;
  ~Structures() {
    if (scene != nullptr) rtcReleaseScene(scene);
    if (device != nullptr) rtcReleaseDevice(device);
  }
};

/// One per kind, because its table is expensive.
std::vector<PathScene::Films> PathScene::filmsOf(const TriangleScene& scene) {
  std::vector<Films> films(scene.objects.size());
  std::map<std::array<float, 3>, Films> kinds;
  for (std::size_t i = 0; i < films.size(); ++i) {
    const Material& material = scene.objects[i].material;
    const MaterialFinish& f = material.finish;
    if (!f.hasFilm() || material.unlit || !scene.objects[i].inPicture) continue;
    // Without a texture the film has its maximum thickness.
    const float end = f.filmThicknessTexture.image ? f.filmThicknessMin : f.filmThicknessMax;
    const float least = std::min(end, f.filmThicknessMax), most = std::max(end, f.filmThicknessMax);
    Films& kind = kinds[{f.filmIor, least, most}];
    const auto made = [&](PathFilm::Base base) {
      return std::make_shared<const PathFilm>(base, f.filmIor, least, most);
    };
    if (!kind.metal && material.metallic > 0.0f) kind.metal = made(PathFilm::Base::Metal);
    if (!kind.dielectric && (material.metallic < 1.0f || material.metallicRoughnessTexture.image)) {
      kind.dielectric = made(PathFilm::Base::Dielectric);
    }
    films[i] = kind;
  }
  return films;
}

PathScene::PathScene(TriangleScene scene)
    : scene_(std::move(scene)), films_(filmsOf(scene_)), structures_(std::make_unique<Structures>()) {
  Structures& s = *structures_;
  s.device = newRayDevice();
  s.scene = rtcNewScene(s.device);
  rtcSetSceneFlags(s.scene, RTC_SCENE_FLAG_ROBUST);
  for (std::size_t i = 0; i < scene_.objects.size(); ++i) {
    const TracedObject& object = scene_.objects[i];
    if (object.indices.size() < 3 || !object.inPicture) continue;
    RTCGeometry geometry = newTriangleGeometry(s.device, object.positions, object.indices);
    if (!object.material.doubleSided || object.material.alphaMode == AlphaMode::Mask) {
      rtcSetGeometryUserData(geometry, const_cast<TracedObject*>(&object));
      rtcSetGeometryIntersectFilterFunction(geometry, skipHit);
    }
    rtcCommitGeometry(geometry);
    rtcAttachGeometryByID(s.scene, geometry, static_cast<unsigned>(i));
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(s.scene);
  checkCommitted(s.device, "the scene");
}

PathScene::~PathScene() = default;

std::optional<PathHit> PathScene::first(const glm::dvec3& origin, const glm::dvec3& direction, bool eye) const {
  const glm::vec3 from(origin), along(direction);
  RTCRayHit query;
  query.ray = {from.x, from.y, from.z, 0.0f, along.x, along.y, along.z, 0.0f, std::numeric_limits<float>::infinity(),
               ~0u,    0u,     0u};
  query.hit.geomID = RTC_INVALID_GEOMETRY_ID;
  query.hit.instID[0] = RTC_INVALID_GEOMETRY_ID;
  eyeAsks = eye;
  intersectOne(structures_->scene, &query);
  if (query.hit.geomID == RTC_INVALID_GEOMETRY_ID) return std::nullopt;
  PathHit hit;
  hit.object = static_cast<int>(query.hit.geomID);
  hit.triangle = query.hit.primID;
  hit.barycentric = {query.hit.u, query.hit.v};
  const TracedObject& object = scene_.objects[query.hit.geomID];
  const std::uint32_t* corners = &object.indices[3 * static_cast<std::size_t>(hit.triangle)];
  const glm::dvec3 a(object.positions[corners[0]]), b(object.positions[corners[1]]), c(object.positions[corners[2]]);
  hit.position = (1.0 - hit.barycentric.x - hit.barycentric.y) * a + hit.barycentric.x * b + hit.barycentric.y * c;
  hit.distance = glm::dot(hit.position - origin, direction);
  hit.normal = unitOr(glm::cross(b - a, c - a), -direction);
  hit.back = glm::dot(hit.normal, direction) > 0.0;
  if (hit.back) hit.normal = -hit.normal;
  return hit;
}

double PathScene::passes(const PathHit& from, const glm::dvec3& direction, double distance, int object) const {
  constexpr int kMostBlended = 64;
  // Relative to the length. Rounding moves the hit on the light's own surface, far at grazing angles.
  constexpr double kShort = 1.0e-5, kOwn = 1.0e-2;
  glm::dvec3 origin = away(from, direction);
  // The start is moved off the surface, which matters if a lamp is a few millimetres away.
  const double step = glm::length(origin - from.position);
  double left = distance * (1.0 - kShort) - glm::dot(origin - from.position, direction) - step, share = 1.0;
  for (int i = 0; i < kMostBlended; ++i) {
    const auto hit = first(origin, direction, false);
    if (!hit || hit->distance >= left) return share;
    if (hit->object == object && hit->distance >= left - kOwn * distance) return share;
    const TracedObject& before = scene_.objects[static_cast<std::size_t>(hit->object)];
    if (before.material.alphaMode != AlphaMode::Blend) return 0.0;
    share *= 1.0 - std::clamp(Textured(before, hit->triangle, hit->barycentric).base().w, 0.0, 1.0);
    if (share <= 0.0) return 0.0;
    const glm::dvec3 next = away(*hit, direction);
    left -= glm::dot(next - origin, direction);
    origin = next;
  }
  return 0.0;
}

glm::dvec3 PathScene::away(const PathHit& hit, const glm::dvec3& side) const {
  constexpr double kShare = 6.0e-7;
  const glm::dvec3 size = glm::abs(hit.position);
  const double step = kShare * std::max({size.x, size.y, size.z, 1.0e-3 * scene_.radius});
  return hit.position + (glm::dot(hit.normal, side) < 0.0 ? -step : step) * hit.normal;
}

PathSurface PathScene::surface(const PathHit& hit, const glm::dvec3& direction) const {
  const TracedObject& object = scene_.objects[static_cast<std::size_t>(hit.object)];
  const Material& m = object.material;
  const Textured at(object, hit.triangle, hit.barycentric);
  PathSurface s;
  glm::dvec3 normal = hit.normal;
  if (!object.normals.empty()) {
    normal = unitOr(glm::dvec3(between(object.normals, at.corners(), hit.barycentric)), hit.normal);
    if (hit.back) normal = -normal;
    // A shading normal that faces away from its triangle is an error of the file.
    if (glm::dot(normal, hit.normal) <= 0.0) normal = hit.normal;
  }
  glm::dvec3 tangent = anyAcross(normal), bitangent = glm::cross(normal, tangent);
  const bool framed = !object.tangents.empty();
  if (framed) {
    const glm::dvec4 t(between(object.tangents, at.corners(), hit.barycentric));
    tangent = unitOr(glm::dvec3(t) - glm::dot(glm::dvec3(t), normal) * normal, tangent);
    // The frame of a back face is reversed as a whole.
    bitangent = glm::cross(hit.back ? -normal : normal, tangent) * (t.w < 0.0 ? -1.0 : 1.0);
  }
  const auto mapped = [&](const TextureUse& use, double scale) {
    if (!use.image || !framed) return normal;
    const glm::dvec4 texel = at.of(use, false);
    const glm::dvec3 bent((2.0 * texel.x - 1.0) * scale, (2.0 * texel.y - 1.0) * scale, 2.0 * texel.z - 1.0);
    const double side = hit.back ? -1.0 : 1.0;
    glm::dvec3 n = unitOr(side * (bent.x * tangent + bent.y * bitangent) + bent.z * normal, normal);
    // Normals bent away from the viewer are brought back until just visible, so that no light leaks through the
    // surface.
    const double facing = glm::dot(n, -direction);
    if (facing < 1.0e-3) n = unitOr(n + (1.0e-3 - facing) * -direction, normal);
    return n;
  };
  const glm::dvec4 base = at.base();
  s.normal = mapped(m.normalTexture, m.normalScale);
  s.coatNormal = mapped(m.coatNormalTexture, m.coatNormalScale);
  s.tangent = tangent;
  s.color = glm::clamp(glm::dvec3(base), glm::dvec3(0.0), glm::dvec3(1.0));
  s.opacity = m.alphaMode == AlphaMode::Blend ? std::clamp(base.w, 0.0, 1.0) : 1.0;
  if (m.unlit) {
    s.emission = glm::dvec3(base);
    s.color = glm::dvec3(0.0);
    s.f0 = s.specularEdge = 0.0;
    return s;
  }
  const glm::dvec4 roughMetal = at.of(m.metallicRoughnessTexture, false);
  s.metallic = std::clamp(m.metallic * roughMetal.z, 0.0, 1.0);
  s.roughness = std::clamp(m.roughness * roughMetal.y, 0.0, 1.0);
  const double root = (m.ior - 1.0) / (m.ior + 1.0);
  const MaterialFinish& f = m.finish;
  const double specular = m.specular * (f.specularTexture.image ? at.of(f.specularTexture, false).w : 1.0);
  s.f0 = std::min(root * root * specular, 1.0);
  s.ior = m.ior;
  s.specularTint = glm::dvec3(f.specularTint) * glm::dvec3(at.of(f.specularColorTexture, true));
  s.specularEdge = std::clamp(static_cast<double>(f.specularEdge) * std::min(specular, 1.0), 0.0, 1.0);
  s.emission = glm::dvec3(m.emissive) * glm::dvec3(at.of(m.emissiveTexture, true));
  for (int c = 0; c < 3; ++c) {
    if (!std::isfinite(s.emission[c])) s.emission[c] = 0.0;
  }
  s.coat = std::clamp(m.coat * at.of(m.coatTexture, false).x, 0.0, 1.0);
  s.coatRoughness = std::clamp(m.coatRoughness * at.of(m.coatRoughnessTexture, false).y, 0.0, 1.0);
  s.sheen = glm::dvec3(f.sheenColor) * glm::dvec3(at.of(f.sheenColorTexture, true));
  s.sheenRoughness = std::clamp(f.sheenRoughness * at.of(f.sheenRoughnessTexture, false).w, 0.0, 1.0);
  if (f.anisotropy > 0.0f) {
    const glm::dvec4 texel =
        f.anisotropyTexture.image ? at.of(f.anisotropyTexture, false) : glm::dvec4(1.0, 0.5, 1.0, 1.0);
    const double turn = f.anisotropyRotation + std::atan2(2.0 * texel.y - 1.0, 2.0 * texel.x - 1.0);
    s.anisotropy = std::clamp(f.anisotropy * texel.z, 0.0, 1.0);
    s.tangent = unitOr(std::cos(turn) * tangent + std::sin(turn) * bitangent, tangent);
  }
  if (f.hasFilm()) {
    const Films& films = films_[static_cast<std::size_t>(hit.object)];
    s.film = films.dielectric.get();
    s.metalFilm = films.metal.get();
    s.filmShare = std::clamp(f.iridescence * at.of(f.iridescenceTexture, false).x, 0.0, 1.0);
    const double along = at.of(f.filmThicknessTexture, false).y;
    s.filmThickness = f.filmThicknessMin + (f.filmThicknessMax - f.filmThicknessMin) * along;
  }
  s.transmission = std::clamp(m.transmission * at.of(m.transmissionTexture, false).x, 0.0, 1.0);
  s.thin = m.thin;
  s.inside = hit.back && !m.thin && s.transmission > 0.0;
  if (s.inside && m.attenuationDistance > 0.0f) {
    for (int c = 0; c < 3; ++c) {
      s.absorption[c] =
          -std::log(std::clamp(static_cast<double>(m.attenuationColor[c]), 1.0e-9, 1.0)) / m.attenuationDistance;
    }
  }
  return s;
}

}  // namespace boxprobe
