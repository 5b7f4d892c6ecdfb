#include "data/scenes/mural_wall.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <utility>

#include "data/scenes/picture.h"

namespace boxprobe::scenes {

MuralWall::MuralWall(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, std::vector<double> rightCuts,
                     std::vector<double> upCuts)
    : corner_(corner), right_(right), up_(up), rightCuts_(std::move(rightCuts)), upCuts_(std::move(upCuts)) {}

MeshBuilder MuralWall::part(const std::function<bool(double x, double y)>& keep, UvRectangle uv) const {
  MeshBuilder mesh;
  const glm::dvec2 metres = size();
  mesh.quadGrid(corner_, right_, up_, rightCuts_, upCuts_, uv, [&](int column, int row) {
    const auto c = static_cast<std::size_t>(column), r = static_cast<std::size_t>(row);
    return keep(metres.x * 0.5 * (rightCuts_[c] + rightCuts_[c + 1]), metres.y * 0.5 * (upCuts_[r] + upCuts_[r + 1]));
  });
  return mesh;
}

glm::dvec2 MuralWall::size() const {
  return {glm::length(right_), glm::length(up_)};
}

void addWall(Composer& scene, double texelsPerMetre, const std::string& name, const MuralWall& wall, Mural mural,
             const std::vector<WallLamp>& lamps) {
  const glm::dvec2 metres = wall.size();
  const Picture picture =
      paint(name, static_cast<int>(texelsPerMetre * metres.x), static_cast<int>(texelsPerMetre * metres.y),
            [mural, metres](double u, double v) { return mural(metres.x * u, metres.y * (1.0 - v)); });
  const auto lampAt = [&](double x, double y) {
    return std::any_of(lamps.begin(), lamps.end(), [&](const WallLamp& l) { return l.patch.holds(x, y); });
  };
  scene.add(name, wall.part([&](double x, double y) { return !lampAt(x, y); }), scene.material(unlit(name, picture)));
  for (const WallLamp& l : lamps) {
    scene.add(l.name, wall.part([&](double x, double y) { return l.patch.holds(x, y); }),
              scene.material(lamp(l.name, l.radiance)));
  }
}

std::vector<double> reversed(std::vector<double> cuts) {
  std::reverse(cuts.begin(), cuts.end());
  for (double& cut : cuts) cut = 1.0 - cut;
  return cuts;
}

std::vector<double> fractions(std::vector<double> metres) {
  const double whole = metres.back();
  for (double& cut : metres) cut /= whole;
  return metres;
}

}  // namespace boxprobe::scenes
