// Meshes of what an OBJ file says: polygons as triangles, corners as vertices, missing normals.
#pragma once

#include <functional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/obj/obj_geometry.h"

namespace boxprobe {

/// A mesh with the object that it belongs to.
struct ObjPart {
  Mesh mesh;                              ///< its `material` is an index into ObjGeometry::materials
  std::string object;                     ///< name of the object or group; empty: the file names none
  bool hasNormals = false;                ///< else they are to be computed
  bool hasUv = false, hasColors = false;  ///< does any corner have them?
};

struct ObjParts {
  std::vector<ObjPart> parts;
  glm::dmat4 worldFromModel{1.0};  ///< of all parts
};

/// One part for each object (else group) and material. Throws InputError for positions that are not finite; `progress`
/// gets the finished fraction.
ObjParts partsOf(ObjGeometry& geometry, const std::string& path, const std::function<void(double)>& progress);

}  // namespace boxprobe
