#include "tests/unit/geometry_house.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>

#include "tests/support/kept_values.h"
#include "tests/support/sphere_mesh.h"

namespace boxprobe::test {

House::House() {
  // Heights are y. The walls of both rooms are 0.12 thick; a window is in the first, a door between them.
  const glm::vec3 paint(0.7f, 0.6f, 0.5f), oak(0.4f, 0.3f, 0.2f), stone(0.5f, 0.55f, 0.6f);
  panel("floor", 1, 0.0, 1.0, -1.9, 3.1, -2.3, 2.7, oak);
  panel("ceiling", 1, 2.6, -1.0, -1.9, 3.1, -2.3, 2.7, paint);
  panel("roof", 1, 2.75, 1.0, -4.4, 3.3, -2.5, 2.9, stone);
  panel("west", 0, -2.3, 1.0, 0.0, 2.6, -1.9, 3.1, paint);
  panel("west outside", 0, -2.42, -1.0, 0.0, 2.6, -1.9, 3.1, stone);
  wall("east", 0, 2.7, -1.0, 0.0, 2.6, -1.9, 3.1, 0.9, 2.1, 0.3, 1.7, paint);
  wall("east outside", 0, 2.82, 1.0, 0.0, 2.6, -1.9, 3.1, 0.9, 2.1, 0.3, 1.7, stone);
  panel("south", 2, 3.1, -1.0, -2.3, 2.7, 0.0, 2.6, paint);
  panel("south outside", 2, 3.22, 1.0, -2.3, 2.7, 0.0, 2.6, stone);
  wall("north", 2, -1.9, 1.0, -2.3, 2.7, 0.0, 2.6, -1.7, -0.8, 0.0, 2.05, paint);
  wall("north behind", 2, -2.02, -1.0, -2.3, 2.7, 0.0, 2.6, -1.7, -0.8, 0.0, 2.05, stone);
  panel("floor 2", 1, 0.0, 1.0, -4.3, -1.9, -2.3, 1.4, stone);
  panel("ceiling 2", 1, 2.45, -1.0, -4.3, -2.02, -2.3, 1.4, paint);
  panel("west 2", 0, -2.3, 1.0, 0.0, 2.45, -4.3, -2.02, paint);
  panel("east 2", 0, 1.4, -1.0, 0.0, 2.45, -4.3, -2.02, oak);
  panel("north 2", 2, -4.3, 1.0, -2.3, 1.4, 0.0, 2.45, paint);
  block("cupboard", {{1.1, 0.0, -1.85}, {1.9, 1.95, -1.2}}, oak);
  block("table", {{-0.7, 0.68, 0.4}, {0.8, 0.74, 1.3}}, oak);
  panel("screen", 0, 1.63, -1.0, 0.0, 1.5, 0.8, 1.9, paint);
  panel("ceiling lamp", 1, 2.55, -1.0, 0.2, 0.9, -0.6, 0.5, glm::vec3(0.2f), {12.0f, 10.0f, 7.0f});
  block("box lamp", {{-2.0, 0.9, 2.4}, {-1.75, 1.25, 2.75}}, glm::vec3(0.3f), {6.0f, 3.0f, 2.0f});
  // What the rays meet of the round lamp, its rim too.
  panel("lens", 2, 3.05, -1.0, 1.19, 1.61, 0.89, 1.31, glm::vec3(0.2f), {21.0f, 20.0f, 17.0f});
  panel("far lamp", 2, -4.28, 1.0, -0.9, 0.1, 1.3, 2.0, glm::vec3(0.1f), {5.0f, 7.0f, 9.0f});
}

void House::panel(const std::string& node, int axis, double at, double sign, double u0, double u1, double v0, double v1,
                  const glm::vec3& albedo, const glm::vec3& emitted) {
  panels.push_back({node, axis, at, sign, {u0, v0}, {u1, v1}, albedo, emitted});
}

void House::wall(const std::string& node, int axis, double at, double sign, double u0, double u1, double v0, double v1,
                 double holeU0, double holeU1, double holeV0, double holeV1, const glm::vec3& albedo) {
  panel(node, axis, at, sign, u0, holeU0, v0, v1, albedo);
  panel(node, axis, at, sign, holeU1, u1, v0, v1, albedo);
  if (holeV0 > v0) panel(node, axis, at, sign, holeU0, holeU1, v0, holeV0, albedo);
  panel(node, axis, at, sign, holeU0, holeU1, holeV1, v1, albedo);
}

void House::block(const std::string& node, const Box& box, const glm::vec3& albedo, const glm::vec3& emitted) {
  for (int axis = 0; axis < 3; ++axis) {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    panel(node, axis, box.min[axis], -1.0, box.min[u], box.max[u], box.min[v], box.max[v], albedo, emitted);
    panel(node, axis, box.max[axis], 1.0, box.min[u], box.max[u], box.min[v], box.max[v], albedo, emitted);
  }
}

std::optional<SightLines::Met> House::first(const glm::dvec3& from, const glm::dvec3& direction) const {
  std::optional<Met> met;
  for (const Panel& p : panels) {
    if (direction[p.axis] == 0.0) continue;
    const double t = (p.at - from[p.axis]) / direction[p.axis];
    if (t <= 1e-9 || (met && t >= met->distance)) continue;
    const int u = (p.axis + 1) % 3, v = (p.axis + 2) % 3;
    const double a = from[u] + t * direction[u], b = from[v] + t * direction[v];
    if (a < p.low[0] || a > p.high[0] || b < p.low[1] || b > p.high[1]) continue;
    met = Met{};
    met->distance = t;
    met->back = direction[p.axis] * p.sign > 0.0;
    met->normal[p.axis] = direction[p.axis] > 0.0 ? -1.0 : 1.0;
    met->albedo = p.albedo;
    if (!met->back) met->emitted = p.emitted;
  }
  return met;
}

bool House::blocked(const glm::dvec3& from, const glm::dvec3& to, bool shining) const {
  const glm::dvec3 way = to - from;
  return std::any_of(panels.begin(), panels.end(), [&](const Panel& p) {
    if (way[p.axis] == 0.0 || (!shining && p.emitted != glm::vec3(0.0f))) return false;
    const double t = (p.at - from[p.axis]) / way[p.axis];
    if (t < 0.0 || t > 1.0) return false;
    const int u = (p.axis + 1) % 3, v = (p.axis + 2) % 3;
    const double a = from[u] + t * way[u], b = from[v] + t * way[v];
    return a >= p.low[0] && a <= p.high[0] && b >= p.low[1] && b <= p.high[1];
  });
}

Box House::bounds() const {
  return {{-2.5, 0.0, -4.4}, {2.9, 2.75, 3.3}};
}

namespace {

void addQuad(Mesh& mesh, const glm::vec3& a, const glm::vec3& b, const glm::vec3& c, const glm::vec3& d) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), {a, b, c, d});
  for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) mesh.indices.push_back(first + k);
}

void addFan(Mesh& mesh, const std::vector<glm::vec3>& corners) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.insert(mesh.positions.end(), corners.begin(), corners.end());
  for (std::uint32_t k = 1; k + 1 < corners.size(); ++k) {
    for (const std::uint32_t i : {0u, k, k + 1}) mesh.indices.push_back(first + i);
  }
}

}  // namespace

std::shared_ptr<const Model> House::model() const {
  auto model = std::make_shared<Model>();
  const auto material = [&](const std::string& name, const glm::vec3& emissive) {
    Material made;
    made.name = name;
    made.emissive = emissive;
    model->materials.push_back(made);
    return static_cast<int>(model->materials.size()) - 1;
  };
  const auto place = [&](const std::string& node, Mesh mesh, const glm::dmat4& at = glm::dmat4(1.0)) {
    model->meshes.push_back(std::move(mesh));
    model->instances.push_back({node, static_cast<int>(model->meshes.size()) - 1, at});
  };
  std::map<std::string, Mesh> meshes;
  for (const Panel& p : panels) {
    if (p.node == "lens") continue;
    Mesh& mesh = meshes[p.node];
    if (mesh.positions.empty()) mesh.material = material(p.node + " paint", p.emitted);
    const int u = (p.axis + 1) % 3, v = (p.axis + 2) % 3;
    glm::vec3 corner[4];
    for (int k = 0; k < 4; ++k) {
      corner[k][p.axis] = static_cast<float>(p.at);
      corner[k][u] = static_cast<float>(k == 1 || k == 2 ? p.high[0] : p.low[0]);
      corner[k][v] = static_cast<float>(k >= 2 ? p.high[1] : p.low[1]);
    }
    if (p.sign < 0.0) std::swap(corner[1], corner[3]);
    addQuad(mesh, corner[0], corner[1], corner[2], corner[3]);
  }
  for (auto& [node, mesh] : meshes) place(node, std::move(mesh));

  // Lamps that are no rectangles across an axis, each on its own.
  Mesh angle;  // of two arms: concave
  addFan(angle, {{0.0f, 0.0f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.5f, 0.2f, 0.0f}, {0.2f, 0.2f, 0.0f}});
  addFan(angle, {{0.0f, 0.0f, 0.0f}, {0.2f, 0.2f, 0.0f}, {0.2f, 0.6f, 0.0f}, {0.0f, 0.6f, 0.0f}});
  angle.material = material("neon", {9.0f, 4.0f, 11.0f});
  glm::dmat4 tilted(0.8, 0.36, -0.48, 0.0, 0.0, 0.8, 0.6, 0.0, 0.6, -0.48, 0.64, 0.0, -1.3, 1.4, 0.9, 1.0);
  place("angle lamp", angle, tilted);
  Mesh round;
  std::vector<glm::vec3> rim;
  for (int i = 0; i < 14; ++i) {
    const float a = 6.2831853f * static_cast<float>(i) / 14.0f;
    rim.emplace_back(1.4f + 0.21f * std::cos(a), 1.1f + 0.21f * std::sin(a), 3.05f);
  }
  std::reverse(rim.begin(), rim.end());
  addFan(round, rim);
  round.material = material("lens", {21.0f, 20.0f, 17.0f});
  model->materials.back().doubleSided = true;
  place("round lamp", round);
  Mesh bulb = sphereMesh(0.09f, 6, 8);
  bulb.material = material("bulb", {30.0f, 25.0f, 20.0f});
  tilted[3] = {0.4, 1.9, 2.1, 1.0};
  place("bulb", bulb, tilted);
  Mesh shown;
  addQuad(shown, {-2.25f, 1.2f, -0.7f}, {-2.25f, 1.2f, -0.2f}, {-2.25f, 1.6f, -0.2f}, {-2.25f, 1.6f, -0.7f});
  std::reverse(shown.indices.begin(), shown.indices.end());
  shown.material = material("screen", {8.0f, 9.0f, 10.0f});
  auto picture = std::make_shared<ImageRgba8>();
  picture->width = 2;
  picture->height = 1;
  picture->pixels = {255, 120, 30, 255, 200, 40, 90, 255};
  model->materials.back().emissiveTexture.image = picture;
  place("television", shown);
  Mesh thread;
  addFan(thread, {{0.0f, 1.0f, 2.0f}, {0.5f, 1.0f, 2.0f}, {1.0f, 1.0f, 2.0f}});
  thread.material = material("wire", {5.0f, 5.0f, 5.0f});
  place("thread", thread);
  Mesh dim;
  addQuad(dim, {1.0f, 0.5f, 3.0f}, {1.0f, 0.9f, 3.0f}, {1.5f, 0.9f, 3.0f}, {1.5f, 0.5f, 3.0f});
  dim.material = material("dial", {0.1f, 0.2f, 0.1f});
  place("dial", dim);
  Mesh sign;
  addQuad(sign, {2.3f, 1.9f, 2.0f}, {2.6f, 1.9f, 2.0f}, {2.6f, 2.1f, 2.0f}, {2.3f, 2.1f, 2.0f});
  sign.material = material("exit", {0.0f, 0.0f, 0.0f});
  model->materials.back().unlit = true;
  model->materials.back().baseColor = {4.0f, 9.0f, 5.0f, 1.0f};
  place("sign", sign);
  place("hidden sign", sign);
  return model;
}

Scene House::scene() const {
  Scene scene;
  scene.models.push_back({"house.glb"});
  scene.objects["hidden sign"].seenByProbes = false;
  scene.objects["box lamp"].translation = {0.03, 0.02, -0.04};
  scene.objects["sign"].rotationDegrees = {0.0, 90.0, 0.0};
  scene.materials["far lamp paint"].emissive = glm::vec3(4.0f, 6.0f, 7.5f);
  Probe first;
  first.name = "first";
  first.origin = {0.3, 1.3, 1.7};
  first.box = {{-2.3, 0.0, -1.9}, {2.7, 2.6, 3.1}};
  first.influence = Box{{-2.4, -0.1, -2.9}, {2.8, 2.7, 3.2}};
  first.blendDistance = {{0.1, 0.1, 0.4}, {0.2, 0.1, 0.3}};
  Probe second;
  second.name = "second";
  second.origin = {-0.4, 1.2, -3.1};
  second.box = {{-2.2, 0.1, -4.2}, {1.3, 2.3, -2.1}};
  second.rotationDegrees = {2.0, 14.0, -3.0};
  second.importance = 0.7;
  second.hides = {"angle lamp"};
  scene.probes = {first, second};
  const auto light = [&](LightType type, const glm::dvec3& position, const glm::dvec3& direction, float intensity) {
    Light made;
    made.type = type;
    made.position = position;
    made.direction = direction;
    made.intensity = intensity;
    made.color = {0.9f, 0.8f, 0.6f};
    made.innerConeDegrees = 14.0;
    made.outerConeDegrees = 52.0;
    scene.lights.push_back(made);
  };
  light(LightType::Point, {-1.2, 2.1, -1.1}, {}, 3.1f);
  light(LightType::Spot, {0.5, 2.2, -2.6}, {-0.3, -1.0, -0.2}, 7.3f);
  light(LightType::Directional, {}, {-1.0, -0.6, -0.1}, 2.2f);
  light(LightType::Point, {0.1, 2.5, 0.6}, {}, 1.4f);           // at the ceiling lamp
  light(LightType::Spot, {1.4, 1.1, 3.0}, {0, 0, -1}, 900.0f);  // at the round lamp, and much stronger
  light(LightType::Point, {1.9, 0.4, 1.4}, {}, 0.7f);
  light(LightType::Point, {0.9, 1.4, 2.4}, {}, 0.0f);      // off
  light(LightType::Point, {-1.84, 1.1, 2.56}, {}, 40.0f);  // within the box lamp, and much stronger
  scene.lights[5].shadows = LightShadows::Coverage;
  scene.lights[0].range = 6.0;
  scene.lights[1].radius = 0.21;
  return scene;
}

std::string keptBox(const Box& box) {
  return keptVector(box.min, 4) + " to " + keptVector(box.max, 4);
}

std::string digest(const std::vector<double>& values) {
  double sum = 0.0, squares = 0.0, rising = 0.0, sevenths = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    sum += values[i];
    squares += values[i] * values[i];
    rising += values[i] * static_cast<double>(i) / static_cast<double>(values.size());
    sevenths += values[i] * static_cast<double>(i * 5 % 7);
  }
  const double count = std::max(static_cast<double>(values.size()), 1.0);
  std::string text = std::to_string(values.size()) + " values:";
  for (const double each : {sum, squares, rising, sevenths}) text += " " + keptNumber(each / count, 4);
  text += ", of them";
  const std::size_t step = values.size() / 11 + 1;
  for (std::size_t i = step / 2; i < values.size(); i += step) text += " " + keptNumber(values[i], 4);
  return text;
}

}  // namespace boxprobe::test
