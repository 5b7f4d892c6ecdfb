// What the lines of an OBJ file say, before meshes are made of it. Source: Wavefront, "Object Files" (Advanced
// Visualizer manual, appendix B1).
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <utility>
#include <vector>

#include "filters/io/gltf/model_file.h"

namespace boxprobe {

constexpr std::uint32_t kNoObjEntry = 0xffffffffu;

/// Indices into the lists, from 0.
struct ObjCorner {
  std::uint32_t position = 0, uv = kNoObjEntry, normal = kNoObjEntry;
};

struct ObjFace {
  std::size_t first = 0;     ///< of its corners
  std::uint32_t count = 0;   ///< at least 3
  std::uint32_t object = 0;  ///< into ObjGeometry::objects, and below
  std::uint32_t group = 0;
  std::uint32_t material = 0;
  int smoothing = -1;  ///< group of smooth faces; 0: flat; -1: the file does not say
};

struct ObjGeometry {
  std::vector<glm::dvec3> positions;
  std::vector<glm::vec3> colors;  ///< as in the file, 0 to 1, or empty; negative: this vertex has none
  std::vector<glm::dvec2> uvs;    ///< v upwards
  std::vector<glm::dvec3> normals;
  std::vector<ObjCorner> corners;
  std::vector<ObjFace> faces;
  std::vector<std::string> objects, groups, materials;         ///< names; the first of each is empty
  std::vector<std::pair<std::size_t, std::string>> libraries;  ///< line and text of each mtllib
  std::vector<std::string> warnings;
};

/// Throws InputError ("m.obj:12: ...") for what is not OBJ and for indices out of range. Time and memory are linear in
/// the file's size.
ObjGeometry readObjGeometry(const std::string& path, const LoadProgress& progress);

}  // namespace boxprobe
