#include "tests/support/odd_room.h"

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

namespace boxprobe::test {

namespace {

void addQuad(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  const glm::vec3 normal = glm::normalize(glm::cross(b - a, c - a));
  for (const glm::vec3& corner : {a, b, c, d}) {
    mesh.positions.push_back(corner);
    mesh.normals.push_back(normal);
  }
  for (const std::uint32_t i : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + i);
}

/// Of a box that is seen from outside, or one wall of it (0..5: -x +x -y +y -z +z) from within.
Mesh boxMesh(const glm::vec3& low, const glm::vec3& high, int wall = -1) {
  Mesh mesh;
  for (int face = 0; face < 6; ++face) {
    if (wall >= 0 && face != wall) continue;
    const int axis = face / 2, u = (axis + 1) % 3, v = (axis + 2) % 3;
    glm::vec3 corners[4];
    for (int i = 0; i < 4; ++i) {
      corners[i][axis] = face % 2 == 0 ? low[axis] : high[axis];
      corners[i][u] = i == 1 || i == 2 ? high[u] : low[u];
      corners[i][v] = i >= 2 ? high[v] : low[v];
    }
    const bool turned = (face % 2 == 0) != (wall >= 0);
    addQuad(mesh, corners[0], corners[turned ? 3 : 1], corners[2], corners[turned ? 1 : 3]);
  }
  return mesh;
}

Material painted(const char* name, const glm::vec3& color, float metallic, float roughness) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = metallic;
  material.roughness = roughness;
  return material;
}

void add(Model& model, const char* node, Mesh mesh, Material material, const glm::dmat4& placed = glm::dmat4(1.0)) {
  mesh.material = static_cast<int>(model.materials.size());
  model.materials.push_back(std::move(material));
  model.instances.push_back({node, static_cast<int>(model.meshes.size()), placed});
  model.meshes.push_back(std::move(mesh));
}

Probe probeOf(const char* name, const glm::dvec3& origin, const Box& box, const Box& influence,
              const BlendDistance& blend) {
  Probe probe;
  probe.name = name;
  probe.origin = origin;
  probe.box = box;
  probe.influence = influence;
  probe.blendDistance = blend;
  probe.faceSize = 16;
  probe.filterSamples = 24;
  probe.samplesPerPixel = 4;
  return probe;
}

}  // namespace

OddRoom oddRoom() {
  auto model = std::make_shared<Model>();
  const glm::vec3 low(-2.3f, 0.2f, -1.7f), high(3.1f, 2.9f, 2.6f);
  const char* names[] = {"west", "east", "floor", "ceiling", "north", "south"};
  const glm::vec3 colors[] = {{0.71f, 0.23f, 0.19f}, {0.24f, 0.62f, 0.31f}, {0.83f, 0.78f, 0.66f},
                              {0.91f, 0.93f, 0.87f}, {0.33f, 0.36f, 0.74f}, {0.58f, 0.47f, 0.12f}};
  const float metallic[] = {0.0f, 0.0f, 0.93f, 0.0f, 0.86f, 0.0f};
  const float roughness[] = {0.72f, 0.54f, 0.13f, 0.97f, 0.31f, 0.43f};
  for (int i = 0; i < 6; ++i) {
    Material wall = painted(names[i], colors[i], metallic[i], roughness[i]);
    if (i == 1) wall.emissive = {0.11f, 0.07f, 0.02f};
    add(*model, names[i], boxMesh(low, high, i), wall);
  }
  Material paint = painted("paint", {0.42f, 0.06f, 0.29f}, 0.08f, 0.61f);
  paint.coat = 0.74f;
  paint.coatRoughness = 0.09f;
  add(*model, "pillar", boxMesh({-0.31f, 0.2f, -0.22f}, {0.29f, 1.73f, 0.34f}), paint,
      glm::translate(glm::dmat4(1.0), {-1.1, 0.0, 0.6}));
  Material glass = painted("glass", {0.88f, 0.94f, 0.91f}, 0.0f, 0.04f);
  glass.transmission = 0.83f;
  glass.ior = 1.37f;
  glass.thin = false;
  glass.thickness = 0.46f;
  glass.attenuationDistance = 0.92f;
  glass.attenuationColor = {0.35f, 0.71f, 0.52f};
  add(*model, "block", boxMesh({-0.41f, 0.2f, -0.27f}, {0.36f, 0.95f, 0.44f}), glass,
      glm::translate(glm::dmat4(1.0), {1.3, 0.0, -0.35}));
  add(*model, "mover", boxMesh({-0.17f, 0.2f, -0.21f}, {0.23f, 0.67f, 0.26f}),
      painted("toy", {0.93f, 0.55f, 0.07f}, 0.04f, 0.36f), glm::translate(glm::dmat4(1.0), {0.4, 0.0, 1.2}));

  OddRoom room;
  room.model = model;
  Scene& scene = room.scene;
  scene.models.emplace_back();
  scene.models.back().file = "odd-room.glb";
  scene.sky = SkyGradient{{0.12f, 0.31f, 0.67f}, {0.81f, 0.74f, 0.58f}, {0.17f, 0.09f, 0.05f}};
  Camera camera;
  camera.position = {2.4, 1.85, 2.2};
  camera.target = {-0.65, 0.55, -0.3};
  camera.verticalFovDegrees = 67.0;
  scene.cameras.push_back(camera);
  Light sun;
  sun.direction = {-0.42, -0.83, -0.27};
  sun.color = {0.97f, 0.91f, 0.79f};
  sun.intensity = 0.63f;
  sun.angleDegrees = 2.3;
  Light bulb;
  bulb.type = LightType::Point;
  bulb.position = {-0.9, 2.35, -0.75};
  bulb.color = {0.86f, 0.69f, 0.44f};
  bulb.intensity = 1.7f;
  bulb.range = 6.2;
  Light spot;
  spot.type = LightType::Spot;
  spot.position = {2.6, 2.5, -1.1};
  spot.direction = {-0.61, -0.72, 0.38};
  spot.color = {0.54f, 0.77f, 0.95f};
  spot.intensity = 2.9f;
  spot.innerConeDegrees = 17.0;
  spot.outerConeDegrees = 41.0;
  spot.range = 8.4;
  scene.lights = {sun, bulb, spot};
  scene.probes.push_back(probeOf("a", {-0.95, 1.25, -0.55}, {{-2.3, 0.2, -1.7}, {3.05, 2.85, 2.55}},
                                 {{-2.45, 0.05, -1.85}, {1.15, 2.97, 2.72}}, {{0.21, 0.34, 0.47}, {0.93, 0.58, 0.71}}));
  scene.probes.push_back(probeOf("b", {1.45, 1.62, 0.85}, {{-2.25, 0.23, -1.68}, {3.1, 2.9, 2.6}},
                                 {{-0.62, 0.01, -1.93}, {3.27, 3.04, 2.81}}, {{1.06, 0.29, 0.52}, {0.37, 0.66, 0.83}}));
  Probe turned = probeOf("c", {0.35, 0.88, 0.15}, {{-1.9, 0.2, -1.6}, {2.7, 2.9, 2.5}},
                         {{-0.75, -0.04, -0.68}, {1.85, 1.42, 1.37}}, {{0.44, 0.18, 0.61}, {0.27, 0.53, 0.39}});
  turned.rotationDegrees = {0.0, 23.0, 0.0};
  turned.importance = 2.0;
  turned.intensity = 0.87;
  scene.probes.push_back(turned);
  scene.objects["mover"].dynamic = true;
  return room;
}

}  // namespace boxprobe::test
