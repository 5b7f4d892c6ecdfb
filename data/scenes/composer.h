// Puts a scene's model together: meshes, materials, nodes. Called by the scenes; knows nothing of files.
#pragma once

#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "data/scenes/mesh_builder.h"
#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

using Picture = std::shared_ptr<const ImageRgba8>;

class Composer {
 public:
  int material(Material material);
  int mesh(MeshBuilder builder, const std::string& name, int material);
  int mesh(Mesh mesh);
  void place(const std::string& node, int mesh, glm::dvec3 position = glm::dvec3(0.0), double scale = 1.0);
  void place(const std::string& node, int mesh, const glm::dmat4& worldFromModel);
  /// A mesh that stands in one place, named as its node.
  void add(const std::string& node, MeshBuilder builder, int material);
  Model finish() &&;

 private:
  Model model_;
};

/// White metal without roughness: shows what it reflects and nothing of its own.
Material perfectMirror(const std::string& name);

/// Shows its colour or picture whatever the light: radiance is exactly what the picture says.
Material unlit(const std::string& name, glm::vec3 color);
Material unlit(const std::string& name, const Picture& picture);

/// Black, emits `radiance` and reflects nothing (a black metal has no dielectric sheen).
Material lamp(const std::string& name, glm::vec3 radiance);

/// Diffuse, and glowing with `glow` of its own colour: stands in for the skylight that a capture without ambient light
/// would miss.
Material lit(const std::string& name, glm::vec3 color, float glow);
Material lit(const std::string& name, const Picture& picture, float glow);

}  // namespace boxprobe::scenes
