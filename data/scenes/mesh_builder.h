// Meshes out of quads, boxes and lathed shapes, with normals and texture coordinates. Called by the scenes; knows
// nothing of materials or files. Front faces wind counter-clockwise; v = 0 is the top of the picture.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

/// Part of a picture: u from the left, v from the top.
struct UvRectangle {
  double left = 0.0, top = 0.0, right = 1.0, bottom = 1.0;
};

enum Faces : unsigned { kPlusX = 1, kMinusX = 2, kPlusY = 4, kMinusY = 8, kPlusZ = 16, kMinusZ = 32, kAllFaces = 63 };

/// Where a face of a box finds its picture; `face` is one of Faces, `size` the face's width and height in metres.
using FaceUv = std::function<UvRectangle(unsigned face, glm::dvec2 size)>;

/// The picture repeats every `metres`.
FaceUv repeating(double metres);

class MeshBuilder {
 public:
  /// `corner` is lower left, `right` and `up` are its edges as seen from the front: the normal is right x up.
  void quad(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, UvRectangle uv = {});

  /// Four corners in one plane, counter-clockwise from the lower left as seen from the front.
  void quadrilateral(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d);

  /// As quad, cut at the given fractions of `right` and `up` (0 and 1 included); `keep(column, row)` may leave cells
  /// out. Neighbours that share an edge must share its cuts, or pixels of background shine through.
  void quadGrid(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, const std::vector<double>& rightCuts,
                const std::vector<double>& upCuts, UvRectangle uv = {}, const std::function<bool(int, int)>& keep = {});

  /// Axis-aligned, seen from outside. Upright faces have u across and v down, horizontal ones u along the longer edge.
  void box(glm::dvec3 low, glm::dvec3 high, const FaceUv& uv, unsigned faces = kAllFaces);

  /// A profile of (radius, height) points, lowest first, turned about +Y, smooth; a radius of 0 closes the end.
  void lathe(const std::vector<glm::dvec2>& profile, const std::vector<glm::dvec2>& profileNormals, int slices);

  /// A horizontal disc about `center`, facing up, its picture repeating every `metres`.
  void disc(glm::dvec3 center, double radius, int slices, double metres);

  /// For shapes of other files: a vertex, its index; a triangle of three, counter-clockwise as seen from the front.
  std::uint32_t vertex(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv);
  void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c);

  /// Another mesh, turned and moved; `placed` must not scale.
  void add(const MeshBuilder& part, const glm::dmat4& placed);

  Mesh finish(std::string name, int material) &&;

 private:
  Mesh mesh_;
};

/// A smooth sphere about the origin, `slices` x `slices / 2` quads.
MeshBuilder sphere(double radius, int slices);

}  // namespace boxprobe::scenes
