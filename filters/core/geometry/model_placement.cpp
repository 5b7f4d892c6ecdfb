#include "filters/core/geometry/model_placement.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/mat3x3.hpp>

#include "filters/core/geometry/probe_geometry.h"

namespace boxprobe {

namespace {

// The quarter turn that takes the file's up axis to +Y.
glm::dmat4 upright(UpAxis up) {
  const double quarter = std::acos(0.0);
  glm::dmat4 turn(1.0);
  if (up == UpAxis::Z) turn = glm::rotate(turn, -quarter, {1.0, 0.0, 0.0});
  if (up == UpAxis::X) turn = glm::rotate(turn, quarter, {0.0, 0.0, 1.0});
  for (int column = 0; column < 3; ++column) {
    for (int row = 0; row < 3; ++row) turn[column][row] = std::round(turn[column][row]);  // exactly 0 and 1
  }
  return turn;
}

}  // namespace

double metresPerUnit(LengthUnit unit) {
  constexpr double kMetres[] = {1.0, 0.01, 0.001, 0.0254, 0.3048};
  return kMetres[static_cast<int>(unit)];
}

glm::dmat4 worldFromFile(const ModelFile& file) {
  return glm::translate(glm::dmat4(1.0), file.translation) * glm::dmat4(rotationMatrix(file.rotationDegrees)) *
         glm::scale(glm::dmat4(1.0), glm::dvec3(file.scale * metresPerUnit(file.unit))) * upright(file.upAxis);
}

glm::dmat4 movedInstance(const glm::dmat4& placed, const ObjectOverride& object) {
  if (object.translation == glm::dvec3(0.0) && object.rotationDegrees == glm::dvec3(0.0)) return placed;
  glm::dmat4 moved = glm::dmat4(rotationMatrix(object.rotationDegrees)) * placed;
  moved[3] = glm::dvec4(glm::dvec3(placed[3]) + object.translation, 1.0);
  return moved;
}

glm::dmat4 movedInstance(const glm::dmat4& placed, const Scene& scene, const std::string& node) {
  const auto found = scene.objects.find(node);
  return found == scene.objects.end() ? placed : movedInstance(placed, found->second);
}

std::vector<Light> placedLights(const Model& model, const ModelFile& file) {
  const glm::dmat4 placement = worldFromFile(file);
  const double length = file.scale * metresPerUnit(file.unit);
  std::vector<Light> lights = model.lights;
  for (Light& light : lights) {
    light.position = glm::dvec3(placement * glm::dvec4(light.position, 1.0));
    light.direction = glm::normalize(glm::dmat3(placement) * light.direction);
    light.range *= length;
  }
  return lights;
}

std::vector<Camera> placedCameras(const Model& model, const ModelFile& file) {
  const glm::dmat4 placement = worldFromFile(file);
  std::vector<Camera> cameras = model.cameras;
  for (Camera& camera : cameras) {
    camera.position = glm::dvec3(placement * glm::dvec4(camera.position, 1.0));
    camera.target = glm::dvec3(placement * glm::dvec4(camera.target, 1.0));
    camera.up = glm::normalize(glm::dmat3(placement) * camera.up);
    camera.parallelHeight *= file.scale * metresPerUnit(file.unit);
  }
  return cameras;
}

}  // namespace boxprobe
