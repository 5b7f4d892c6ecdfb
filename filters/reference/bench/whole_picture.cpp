#include "filters/reference/bench/whole_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>

#include "filters/reference/trace/picture_rays.h"

namespace boxprobe {

namespace {

constexpr double kDegrees = 57.29577951308232;

/// Corners of all emissive triangles, and positions of lights that have one.
std::vector<glm::dvec3> lampPoints(const Scene& scene, const TriangleScene& triangles) {
  std::vector<glm::dvec3> points;
  for (const TracedObject& object : triangles.objects) {
    if (!object.inPicture || object.material.unlit || object.material.emissive == glm::vec3(0.0f)) continue;
    for (const std::uint32_t index : object.indices) {
      points.push_back(triangles.anchorWorld + glm::dvec3(object.positions[index]));
    }
  }
  for (const Light& light : scene.lights) {
    if (light.type != LightType::Directional) points.push_back(light.position);
  }
  return points;
}

bool facesNoLamp(const Scene& scene, const std::vector<glm::dvec3>& lamps, const glm::dvec3& position,
                 const glm::dvec3& normal) {
  const auto shines = [&](const Light& light) {
    return light.type == LightType::Directional && glm::dot(normal, light.direction) < 0.0;
  };
  const auto before = [&](const glm::dvec3& lamp) { return glm::dot(normal, lamp - position) > 0.0; };
  return !(lamps.empty() && scene.lights.empty()) && std::none_of(scene.lights.begin(), scene.lights.end(), shines) &&
         std::none_of(lamps.begin(), lamps.end(), before);
}

/// By rays over the whole hemisphere, which cannot meet the surface's own plane.
bool nearAnother(const SceneTracer& tracer, const TracedHit& hit) {
  constexpr double kNear = 0.05;
  constexpr int kRays = 48;
  const glm::dvec3 start = tracer.awayFrom(hit), n = hit.frontWorld;
  const glm::dvec3 side = std::abs(n.x) < 0.5 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
  const glm::dvec3 u = glm::normalize(glm::cross(n, side)), v = glm::cross(n, u);
  for (int i = 0; i < kRays; ++i) {
    const double height = (i + 0.5) / kRays, radius = std::sqrt(1.0 - height * height), turn = 2.399963229728653 * i;
    const glm::dvec3 towards = height * n + radius * (std::cos(turn) * u + std::sin(turn) * v);
    const auto met = tracer.firstHit(start, towards);
    if (met && met->distance < kNear) return true;
  }
  return false;
}

struct PartRow {
  const char* name;
  bool (*holds)(const SeenPoint&);
};

constexpr PartRow kParts[] = {
    {"all", [](const SeenPoint&) { return true; }},
    {"diffuse", [](const SeenPoint& p) { return p.surface && !p.glossy && !p.glass && !p.lamp; }},
    {"glossy", [](const SeenPoint& p) { return p.surface && p.glossy && !p.glass && !p.lamp; }},
    {"behind a lamp", [](const SeenPoint& p) { return p.surface && p.facesNoLamp && !p.lamp; }},
    {"within 5 cm of a wall", [](const SeenPoint& p) { return p.surface && p.nearAnother && !p.lamp; }},
    {"roughness 0 to 0.1", [](const SeenPoint& p) { return p.surface && !p.lamp && p.roughness < 0.1; }},
    {"roughness 0.1 to 0.3",
     [](const SeenPoint& p) { return p.surface && !p.lamp && p.roughness >= 0.1 && p.roughness < 0.3; }},
    {"roughness 0.3 to 0.6",
     [](const SeenPoint& p) { return p.surface && !p.lamp && p.roughness >= 0.3 && p.roughness < 0.6; }},
    {"roughness 0.6 to 1", [](const SeenPoint& p) { return p.surface && !p.lamp && p.roughness >= 0.6; }},
    {"seen under 0 to 15 degrees", [](const SeenPoint& p) { return p.surface && !p.lamp && p.elevation < 15.0; }},
    {"seen under 15 to 45 degrees",
     [](const SeenPoint& p) { return p.surface && !p.lamp && p.elevation >= 15.0 && p.elevation < 45.0; }},
    {"seen under 45 to 90 degrees", [](const SeenPoint& p) { return p.surface && !p.lamp && p.elevation >= 45.0; }},
};

std::string cell(const std::vector<PartError>& parts, const std::string& name) {
  const auto found = std::find_if(parts.begin(), parts.end(), [&](const PartError& p) { return p.part == name; });
  char text[40] = "        -      ";
  if (found != parts.end()) std::snprintf(text, sizeof text, "%7.2f %7.3f", found->light, found->relativeRmse);
  return text;
}

}  // namespace

std::vector<SeenPoint> seenPoints(const Scene& scene, const SceneTracer& tracer, const Camera& camera, int width,
                                  int height) {
  constexpr double kMirrorLike = 0.3;
  const std::vector<glm::dvec3> lamps = lampPoints(scene, tracer.scene());
  const PictureRays rays(camera, width, height);
  std::vector<SeenPoint> seen(static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const glm::dvec3 eye = rays.origin(x + 0.5, y + 0.5);
      const auto hit = tracer.firstHit(eye, rays.direction(x + 0.5, y + 0.5));
      if (!hit) continue;
      const SurfacePoint surface = tracer.surface(*hit, eye);
      const Material& material = tracer.object(*hit).material;
      SeenPoint& point =
          seen[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)];
      point.surface = true;
      point.glass = material.transmits();
      point.lamp = material.unlit || surface.emissive != glm::vec3(0.0f);
      const bool coated = surface.coatStrength > 0.0f;
      point.roughness = coated ? surface.coatRoughness : surface.roughness;
      point.glossy = coated || surface.metallic > 0.5f || point.roughness < kMirrorLike;
      point.elevation = 90.0 - kDegrees * std::acos(std::clamp(hit->cosine, 0.0, 1.0));
      point.facesNoLamp = facesNoLamp(scene, lamps, hit->positionWorld, glm::dvec3(surface.normalWorld));
      point.nearAnother = nearAnother(tracer, *hit);
    }
  }
  return seen;
}

std::vector<PartError> partErrors(const ImageRgbaF& picture, const ReferencePicture& truth,
                                  const std::vector<SeenPoint>& seen) {
  std::vector<PartError> errors;
  for (const PartRow& row : kParts) {
    PartError part;
    part.part = row.name;
    double squares = 0.0, noise = 0.0, truthSquares = 0.0, sum = 0.0, truthSum = 0.0;
    for (std::size_t i = 0; i < seen.size(); ++i) {
      if (!row.holds(seen[i])) continue;
      ++part.pixels;
      for (std::size_t c = 0; c < 3; ++c) {
        const double t = truth.color.pixels[4 * i + c], p = picture.pixels[4 * i + c];
        const double e = truth.standardError.pixels[4 * i + c];
        squares += (p - t) * (p - t);
        noise += e * e;
        truthSquares += t * t;
        sum += p;
        truthSum += t;
      }
    }
    if (part.pixels == 0) continue;
    if (truthSum > 0.0) part.light = sum / truthSum;
    if (truthSquares > 0.0) {
      part.relativeRmse = std::sqrt(std::max(squares - noise, 0.0) / truthSquares);
      part.noise = std::sqrt(noise / truthSquares);
    }
    errors.push_back(part);
  }
  return errors;
}

std::string wholeTable(const std::vector<WholeRow>& rows) {
  constexpr const char* kColumns[] = {"all", "diffuse", "glossy", "behind a lamp", "within 5 cm of a wall"};
  char line[200];
  std::snprintf(line, sizeof line, "%-12s %-9s %-22s", "scene", "camera", "technique");
  std::string text = line;
  for (const char* column : kColumns) {
    std::snprintf(line, sizeof line, " | %15.15s", column);
    text += line;
  }
  text += "\n" + std::string(45, ' ');
  for ([[maybe_unused]] const char* column : kColumns) text += " |   light    RMSE";
  text += "\n";
  for (const WholeRow& row : rows) {
    std::snprintf(line, sizeof line, "%-12s %-9s %-22s", row.scene.c_str(), row.camera.c_str(), row.technique.c_str());
    text += line;
    for (const char* column : kColumns) text += " | " + cell(row.parts, column);
    text += "\n";
  }
  return text;
}

nlohmann::ordered_json wholeJson(const std::vector<WholeRow>& rows, bool complete) {
  nlohmann::ordered_json list = nlohmann::ordered_json::array();
  for (const WholeRow& row : rows) {
    nlohmann::ordered_json parts = nlohmann::ordered_json::array();
    for (const PartError& part : row.parts) {
      parts.push_back({{"part", part.part},
                       {"pixels", part.pixels},
                       {"light", part.light},
                       {"relativeRmse", part.relativeRmse},
                       {"noise", part.noise}});
    }
    list.push_back({{"scene", row.scene},
                    {"camera", row.camera},
                    {"technique", row.technique},
                    {"reference", "path"},
                    {"bounces", row.bounces},
                    {"parts", parts}});
  }
  return {{"complete", complete}, {"rows", list}};
}

}  // namespace boxprobe
