// Polygons as model files hold them, and the meshes that they become.
#pragma once

#include <cstdint>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe {

/// Arrays other than positions, corners and ends are empty or have one entry per position, corner or polygon.
struct Polygons {
  std::vector<glm::dvec3> positions;
  std::vector<glm::dvec3> normals;
  std::vector<glm::dvec2> uvs;         ///< v upwards
  std::vector<glm::vec4> colors;       ///< linear
  std::vector<std::uint32_t> corners;  ///< positions of all polygons, one after the other
  std::vector<std::size_t> ends;       ///< behind the last corner of each polygon
  std::vector<glm::dvec2> cornerUvs;   ///< per corner, v upwards
  std::vector<glm::vec4> faceColors;   ///< per polygon; multiply those of vertices
  std::vector<std::uint32_t> parts;    ///< per polygon: which mesh it belongs to; empty: the only one
};

struct PolygonMeshes {
  std::vector<Mesh> meshes;        ///< by part
  glm::dmat4 worldFromModel{1.0};  ///< of all of them
  bool tooHard = false;            ///< triangles may overlap: see kPolygonsTooHard
};

/// Triangles with unit normals (computed where there are none: edges sharper than 30 degrees stay sharp). Throws an
/// InputError that starts with `place` for positions that are not finite, and for polygons of too many corners.
PolygonMeshes meshesOf(const Polygons& polygons, std::size_t parts, const std::string& place);

}  // namespace boxprobe
