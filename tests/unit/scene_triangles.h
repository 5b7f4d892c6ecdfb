// A model as triangles in the world, for tests that ask geometric questions of the scenes. Knows nothing of rendering.
#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Where the scenes' files lie, with a slash at the end.
std::string scenesFolder();

struct Triangle {
  std::string node;
  std::string material;
  std::array<glm::dvec3, 3> corners;  ///< world
  std::array<glm::dvec3, 3> normals;  ///< world, of the vertices
  std::array<glm::vec2, 3> uv;
  const Material* surface;  ///< points into the model

  glm::dvec3 areaVector() const;  ///< along the front's normal, as long as the area
  glm::dvec3 middle() const;
};

std::vector<Triangle> triangles(const Model& model);

bool startsWith(const std::string& text, const std::string& start);

}  // namespace boxprobe
