// Two interiors of others. The Cornell box: the figures of "CornellBox-Original.obj" and its .mtl, created by Guedis
// Cardenas and Morgan McGuire at Williams College in 2011 and released into the public domain. The living room:
// "3d/physical_light_camera_units/living_room.glb" of github.com/godotengine/godot-demo-projects, MIT licence,
// copyright 2014-present Godot Engine contributors, 2007-2014 Juan Linietsky, Ariel Manzur.
#include <array>
#include <utility>
#include <vector>

#include "tests/truth/lit/scenes/lit_parts.h"
#include "tests/truth/lit/scenes/lit_scenes.h"

namespace boxprobe::scenes {
namespace {

using Quad = std::array<glm::dvec3, 4>;

void addQuads(Composer& scene, const std::string& node, const std::vector<Quad>& quads, const Material& material) {
  MeshBuilder mesh;
  for (const Quad& q : quads) mesh.quadrilateral(q[0], q[1], q[2], q[3]);
  scene.add(node, std::move(mesh), scene.material(material));
}

/// A block: the corners of its top, and down to the floor from each edge.
std::vector<Quad> block(const Quad& top) {
  std::vector<Quad> faces = {top};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 a = top[i], b = top[(i + 1) % 4];
    faces.push_back({glm::dvec3(a.x, 0.0, a.z), glm::dvec3(b.x, 0.0, b.z), b, a});
  }
  return faces;
}

}  // namespace

Model litCornell() {
  Composer scene;
  // Thin sheets, seen from either side.
  const auto sheet = [](const char* name, glm::vec3 albedo) {
    Material material = lambert(name, albedo);
    material.doubleSided = true;
    return material;
  };
  const glm::vec3 white(0.725f, 0.71f, 0.68f);
  addQuads(scene, "floor", {{{{-1.01, 0.0, 0.99}, {1.0, 0.0, 0.99}, {1.0, 0.0, -1.04}, {-0.99, 0.0, -1.04}}}},
           sheet("floor", white));
  addQuads(scene, "ceiling", {{{{-1.02, 1.99, 0.99}, {-1.02, 1.99, -1.04}, {1.0, 1.99, -1.04}, {1.0, 1.99, 0.99}}}},
           sheet("ceiling", white));
  addQuads(scene, "backWall", {{{{-0.99, 0.0, -1.04}, {1.0, 0.0, -1.04}, {1.0, 1.99, -1.04}, {-1.02, 1.99, -1.04}}}},
           sheet("backWall", white));
  addQuads(scene, "rightWall", {{{{1.0, 0.0, -1.04}, {1.0, 0.0, 0.99}, {1.0, 1.99, 0.99}, {1.0, 1.99, -1.04}}}},
           sheet("rightWall", {0.14f, 0.45f, 0.091f}));
  addQuads(scene, "leftWall", {{{{-1.01, 0.0, 0.99}, {-0.99, 0.0, -1.04}, {-1.02, 1.99, -1.04}, {-1.02, 1.99, 0.99}}}},
           sheet("leftWall", {0.63f, 0.065f, 0.05f}));
  addQuads(scene, "shortBox", block({{{0.53, 0.60, 0.75}, {0.70, 0.60, 0.17}, {0.13, 0.60, 0.0}, {-0.05, 0.60, 0.57}}}),
           sheet("shortBox", white));
  addQuads(scene, "tallBox",
           block({{{-0.53, 1.20, 0.09}, {0.04, 1.20, -0.09}, {-0.14, 1.20, -0.67}, {-0.71, 1.20, -0.49}}}),
           sheet("tallBox", white));
  Material light = lambert("light", {0.78f, 0.78f, 0.78f});
  light.emissive = {17.0f, 12.0f, 4.0f};
  // Seen from below alone: its back, a centimetre under the ceiling, is not there.
  addQuads(scene, "light", {{{{-0.24, 1.98, 0.16}, {-0.24, 1.98, -0.22}, {0.23, 1.98, -0.22}, {0.23, 1.98, 0.16}}}},
           light);
  return std::move(scene).finish();
}

}  // namespace boxprobe::scenes
