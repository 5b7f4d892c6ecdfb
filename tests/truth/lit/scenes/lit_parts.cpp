#include "tests/truth/lit/scenes/lit_parts.h"

#include <cmath>
#include <utility>

namespace boxprobe::scenes {
namespace {

// As meshes are rounded: sines may differ in the last digit from one processor to the next.
double rounded(double value) {
  return std::nearbyint(std::ldexp(value, 20)) * std::ldexp(1.0, -20) + 0.0;
}

glm::dmat4 turnedAboutY(glm::dvec3 position, double degrees) {
  const double angle = degrees * 3.141592653589793 / 180.0;
  const double c = rounded(std::cos(angle)), s = rounded(std::sin(angle));
  glm::dmat4 matrix(1.0);
  matrix[0] = {c, 0.0, -s, 0.0};
  matrix[2] = {s, 0.0, c, 0.0};
  matrix[3] = {position.x, position.y, position.z, 1.0};
  return matrix;
}

}  // namespace

Material lambert(const std::string& name, glm::vec3 albedo) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(albedo, 1.0f);
  material.metallic = 0.0f;
  material.specular = 0.0f;
  material.finish.specularEdge = 0.0f;
  return material;
}

Material lambert(const std::string& name, const Picture& albedo) {
  Material material = lambert(name, glm::vec3(1.0f));
  material.baseColorTexture = {albedo, Wrap::Repeat, Wrap::Repeat};
  return material;
}

Material glow(const std::string& name, glm::vec3 radiance) {
  Material material = lambert(name, glm::vec3(0.0f));
  material.emissive = radiance;
  return material;
}

Material metal(const std::string& name, glm::vec3 f0, float roughness) {
  Material material;
  material.name = name;
  material.baseColor = glm::vec4(f0, 1.0f);
  material.roughness = roughness;
  return material;
}

Material blackGloss(const std::string& name, float roughness) {
  Material material;
  material.name = name;
  material.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  material.metallic = 0.0f;
  material.roughness = roughness;
  return material;
}

void addBox(Composer& scene, const std::string& node, glm::dvec3 low, glm::dvec3 high, int material) {
  addTiledBox(scene, node, low, high, 1.0, material);
}

void addTiledBox(Composer& scene, const std::string& node, glm::dvec3 low, glm::dvec3 high, double metres,
                 int material) {
  MeshBuilder box;
  box.box(low, high, repeating(metres));
  scene.add(node, std::move(box), material);
}

void addTurned(Composer& scene, const std::string& node, MeshBuilder builder, glm::dvec3 position, double degrees,
               int material) {
  scene.place(node, scene.mesh(std::move(builder), node, material), turnedAboutY(position, degrees));
}

void addRoom(Composer& scene, const ThickRoom& r) {
  const glm::dvec3 &a = r.low, &b = r.high;
  const double t = r.thick;
  addTiledBox(scene, "floor", {a.x - t, a.y - t, a.z - t}, {b.x + t, a.y, b.z + t}, r.floorMetres, r.floor);
  addBox(scene, "ceiling", {a.x - t, b.y, a.z - t}, {b.x + t, b.y + t, b.z + t}, r.ceiling);
  // North and south reach to the outside, east and west stand between them.
  if (r.north >= 0)
    addTiledBox(scene, "wall north", {a.x - t, a.y, a.z - t}, {b.x + t, b.y, a.z}, r.northMetres, r.north);
  if (r.south >= 0) addBox(scene, "wall south", {a.x - t, a.y, b.z}, {b.x + t, b.y, b.z + t}, r.south);
  if (r.west >= 0) addBox(scene, "wall west", {a.x - t, a.y, a.z}, {a.x, b.y, b.z}, r.west);
  if (r.east >= 0) addBox(scene, "wall east", {b.x, a.y, a.z}, {b.x + t, b.y, b.z}, r.east);
}

}  // namespace boxprobe::scenes
