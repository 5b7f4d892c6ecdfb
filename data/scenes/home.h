// Puts furnished rooms together: pieces of furniture by node and material, and how much of its surroundings each
// surface sees, as occlusion textures. Called by the scenes; knows nothing of what stands in the rooms.
#pragma once

#include <functional>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <string>
#include <vector>

#include "data/scenes/composer.h"
#include "data/scenes/mesh_builder.h"

namespace boxprobe::scenes {

class Home;

/// Draws one piece in one material, in a frame of its own.
class Pen {
 public:
  Pen(Home& home, std::size_t piece, const glm::dmat4& placed) : home_(home), piece_(piece), placed_(placed) {}

  void add(const MeshBuilder& part) const;
  /// A box with rounded edges that hides what is behind it from others.
  void box(glm::dvec3 low, glm::dvec3 high, double bevel = 0.003, double metres = 1.2) const;
  void cushion(glm::dvec3 low, glm::dvec3 high, double radius, glm::dvec3 bulge, int cells = 9) const;
  /// Hides what is behind it as a box would, and is not drawn.
  void hide(glm::dvec3 low, glm::dvec3 high) const;

 private:
  Home& home_;
  std::size_t piece_;
  glm::dmat4 placed_;
};

class Home {
 public:
  Composer& composer() { return composer_; }

  /// The piece `node` in a material: what is drawn with pens of the same two becomes one mesh.
  Pen pen(const std::string& node, int material, const glm::dmat4& placed = glm::dmat4(1.0));

  /// A wall, floor or ceiling, seen from its front, with a picture that repeats every `metres` and an occlusion texture
  /// of its own. Cuts in metres; `keep` is asked at the middles of cells.
  void surface(const std::string& node, Material material, glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up,
               const std::vector<double>& rightCuts, const std::vector<double>& upCuts, double metres,
               const std::function<bool(double, double)>& keep = {});

  void hide(const glm::dmat4& placed, glm::dvec3 low, glm::dvec3 high);

  int material(Material material);
  /// That has no need of occlusion: it shines or mirrors.
  int bareMaterial(Material material);
  /// Metal that is brushed along the horizontal.
  int brushedMaterial(Material material);

  Model finish() &&;

 private:
  friend class Pen;
  struct Piece {
    std::string node;
    int material;
    MeshBuilder mesh;
  };
  struct Surface {
    std::string node;
    Material material;
    MeshBuilder mesh;
    glm::dvec3 corner, right, up;
  };
  struct Hider {
    glm::dmat4 boxFromWorld;
    glm::dvec3 half, middle;
    double reach;  ///< from the middle
  };

  double openness(glm::dvec3 at, glm::dvec3 normal, const std::vector<const Hider*>& near) const;
  std::vector<const Hider*> hidersNear(glm::dvec3 low, glm::dvec3 high) const;

  Composer composer_;
  std::vector<Piece> pieces_;
  std::vector<Surface> surfaces_;
  std::vector<Hider> hiders_;
  std::vector<int> bare_, brushed_;
  int shift_ = 0;
};

}  // namespace boxprobe::scenes
