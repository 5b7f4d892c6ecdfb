// Small worlds of coloured squares, built in memory, for tests of what probes capture and when.
#pragma once

#include <array>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/document.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/support/gpu_window.h"

namespace boxprobe::test {

/// Adds a square: its centre, and half its sides as vectors; it faces along cross(right, up).
inline void addSquare(Model& model, const std::string& node, const glm::vec3& center, const glm::vec3& right,
                      const glm::vec3& up, const Material& material) {
  Mesh mesh;
  mesh.positions = {center - right - up, center + right - up, center + right + up, center - right + up};
  mesh.normals.assign(4, glm::normalize(glm::cross(right, up)));
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = static_cast<int>(model.materials.size());
  model.materials.push_back(material);
  model.materials.back().name = node;
  model.instances.push_back({node, static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
  model.meshes.push_back(std::move(mesh));
}

/// Six faces of a box, towards its outside or its inside.
inline void addBox(Model& model, const std::string& node, const glm::vec3& low, const glm::vec3& high, bool outside,
                   const Material& material) {
  const glm::vec3 middle = 0.5f * (low + high), half = 0.5f * (high - low);
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {-1.0f, 1.0f}) {
      glm::vec3 at = middle, right(0.0f), up(0.0f);
      const int r = (axis + 1) % 3, u = (axis + 2) % 3;
      at[axis] += side * half[axis];
      right[r] = half[r] * side * (outside ? 1.0f : -1.0f);
      up[u] = half[u];
      addSquare(model, node + std::to_string(2 * axis + (side > 0.0f ? 1 : 0)), at, right, up, material);
    }
  }
}

inline Material glowing(const glm::vec3& radiance) {
  Material material;
  material.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  material.metallic = 0.0f;
  material.emissive = radiance;
  material.doubleSided = true;
  return material;
}

inline Material mirror() {
  Material material;
  material.metallic = 1.0f;
  material.roughness = 0.0f;
  material.doubleSided = true;
  return material;
}

/// A renderer that is driven as a window drives it: an edit, then a frame.
class QuadWorld {
 public:
  QuadWorld(Scene s, const std::vector<Model>& models, int width = 32, int height = 32)
      : scene(std::move(s)), window(makeWindow(width, height)), renderer(std::make_unique<SceneRenderer>(window)) {
    std::vector<std::shared_ptr<const Model>> shared;
    for (const Model& model : models) {
      shared.push_back(std::make_shared<const Model>(model));
      if (scene.models.size() < shared.size())
        scene.models.push_back({"model " + std::to_string(shared.size()), {}, {}});
    }
    renderer->setModels(std::move(shared));
  }

  void show() {
    renderer->sync(scene, Changes::all());
    renderer->finishWork();
    ASSERT_EQ(renderer->error(), "");
  }
  template <typename Edit>
  void edit(const Edit& change) {
    const Scene before = scene;
    change(scene);
    renderer->sync(scene, difference(before, scene));
  }
  template <typename Edit>
  void editAndFinish(const Edit& change) {
    edit(change);
    renderer->finishWork();
  }
  /// Colour of the middle pixel of what `from` sees towards `to`.
  glm::vec3 look(const glm::dvec3& from, const glm::dvec3& to, const glm::dvec3& up = {0.0, 1.0, 0.0}) {
    Camera camera;
    camera.position = from;
    camera.target = to;
    camera.up = up;
    camera.verticalFovDegrees = 2.0;
    renderer->applyCamera(camera);
    const ImageRgbaF image = renderer->renderLinear(9, 9, 1);
    constexpr std::size_t kMiddle = (4u * 9u + 4u) * 4u;
    const float* middle = &image.pixels[kMiddle];
    return {middle[0], middle[1], middle[2]};
  }
  std::uint64_t faces() const { return renderer->counters().facesCaptured; }
  std::uint64_t levels() const { return renderer->counters().levelsFiltered; }
  std::uint64_t reused() const { return renderer->counters().facesReused; }

  Scene scene;
  vtkSmartPointer<vtkOpenGLRenderWindow> window;
  std::unique_ptr<SceneRenderer> renderer;
};

/// A probe whose box and influence are the cube of that half size around a point.
inline Probe cubeProbe(const std::string& name, const glm::dvec3& center, double half, int faceSize = 32) {
  Probe probe;
  probe.name = name;
  probe.origin = center;
  probe.box = {center - half, center + half};
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  probe.faceSize = faceSize;
  probe.samplesPerPixel = 1;
  return probe;
}

inline Scene darkScene() {
  Scene scene;
  scene.sky = SkyColor{{0.0f, 0.0f, 0.0f}};
  return scene;
}

}  // namespace boxprobe::test
