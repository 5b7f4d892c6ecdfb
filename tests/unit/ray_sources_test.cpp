// Points on surfaces to start rays from, in the scenes that come with the program; against every triangle in turn.
#include "filters/vtk/rays/ray_sources.h"

#include <gtest/gtest.h>
#include <vtkCamera.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkMatrix4x4.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/rays/ray_arrays.h"
#include "filters/vtk/rays/vtkProjectionRays.h"
#include "tests/unit/scene_triangles.h"

namespace {

using namespace boxprobe;

struct Loaded {
  explicit Loaded(const std::string& name)
      : scene(loadSceneFile(scenesFolder() + name + ".boxprobe.json")),
        model(std::make_shared<Model>(loadModelFile(scene.models[0].file))),
        sources({model}, scene) {}
  Scene scene;
  std::shared_ptr<const Model> model;
  RaySources sources;
};

void place(vtkCamera* vtk, const Camera& camera) {
  vtk->SetPosition(camera.position.x, camera.position.y, camera.position.z);
  vtk->SetFocalPoint(camera.target.x, camera.target.y, camera.target.z);
  vtk->SetViewUp(camera.up.x, camera.up.y, camera.up.z);
  vtk->SetViewAngle(camera.verticalFovDegrees);
}

// The first front face (or face of a double-sided material) along a ray, by looking at all of them.
std::pair<double, const Triangle*> nearest(const std::vector<Triangle>& all, const PixelRay& ray) {
  std::pair<double, const Triangle*> best{1.0e30, nullptr};
  for (const Triangle& t : all) {
    const glm::dvec3 n = t.areaVector();
    const double facing = glm::dot(n, ray.direction);
    if (facing == 0.0 || (facing > 0.0 && (t.surface == nullptr || !t.surface->doubleSided))) continue;
    const double distance = glm::dot(n, t.corners[0] - ray.originWorld) / facing;
    if (distance <= 0.0 || distance >= best.first) continue;
    const glm::dvec3 p = ray.originWorld + distance * ray.direction;
    bool inside = true;
    for (std::size_t i = 0; i < 3 && inside; ++i) {
      inside = glm::dot(glm::cross(t.corners[(i + 1) % 3] - t.corners[i], p - t.corners[i]), n) >= 0.0;
    }
    if (inside) best = {distance, &t};
  }
  return best;
}

class Sources : public testing::TestWithParam<const char*> {};

// Two ways to the same surface; and every hit that is drawn from there lies on its probe's box.
TEST_P(Sources, ScreenGridFindsWhatShowsAndItsHitsLieOnTheBoxes) {
  Loaded loaded(GetParam());
  const std::vector<Triangle> all = triangles(*loaded.model);
  std::size_t checked = 0, different = 0, hits = 0;
  double worst = 0.0;
  for (const Camera& camera : loaded.scene.cameras) {
    vtkNew<vtkCamera> vtk;
    place(vtk, camera);
    const PixelRays pixels(vtk, 1280, 720);
    const std::vector<RaySample> samples = loaded.sources.screenGrid(pixels, 64, 36);
    ASSERT_GT(samples.size(), 1000u) << camera.name;
    for (std::size_t i = 0; i < samples.size(); i += 37) {
      const PixelRay ray{camera.position, glm::normalize(samples[i].positionWorld - camera.position)};
      const auto [distance, triangle] = nearest(all, ray);
      ++checked;
      // On an edge either neighbour may be the first.
      if (std::abs(distance - glm::length(samples[i].positionWorld - camera.position)) > 1.0e-6) ++different;
      if (triangle != nullptr && triangle->node == samples[i].object) {
        EXPECT_GT(glm::dot(samples[i].normalWorld, glm::normalize(triangle->areaVector())), 0.5);
      }
    }
    vtkNew<vtkProjectionRays> filter;
    filter->SetInputData(rayPoints(samples));
    filter->SetEye(camera.position.x, camera.position.y, camera.position.z);
    filter->SetProbes(loaded.scene.probes);
    filter->SetMaximumNumberOfRays(1 << 20);
    filter->Update();
    vtkCellData* data = filter->GetOutput()->GetCellData();
    for (vtkIdType i = 0; i < filter->GetOutput()->GetNumberOfCells(); ++i) {
      if (data->GetArray(ray_array::kHitDistance)->GetComponent(i, 0) < 0.0) continue;
      const Probe& probe =
          loaded.scene.probes[static_cast<std::size_t>(data->GetArray(ray_array::kProbe)->GetComponent(i, 0))];
      if (parseTechnique(probe.technique)->projection != parseTechnique("box")->projection) continue;
      glm::dvec3 hit;
      data->GetArray(ray_array::kHitPoint)->GetTuple(i, &hit.x);
      const glm::dvec3 p = glm::transpose(rotationMatrix(probe.rotationDegrees)) * (hit - probe.box.center());
      const glm::dvec3 past = glm::abs(p) - 0.5 * probe.box.size();
      const glm::dvec3 size = probe.box.size();
      worst = std::max(worst, std::abs(std::max({past.x, past.y, past.z})) / std::max({size.x, size.y, size.z}));
      ++hits;
    }
  }
  std::printf(
      "  %s: %zu of %zu points differ from the search through all triangles; %zu drawn hits off the box by at "
      "most %.1e of its size\n",
      GetParam(), different, checked, hits, worst);
  EXPECT_LE(different, checked / 200);
  EXPECT_GT(hits, 1000u);
  EXPECT_LE(worst, 1.0e-5);
}

INSTANTIATE_TEST_SUITE_P(Scenes, Sources, testing::Values("room", "building", "six-faces"));

TEST(RaySources, GridOverAnObjectIsEvenAndTheSameEveryTime) {
  Loaded loaded("room");
  const std::vector<Triangle> all = triangles(*loaded.model);
  const std::vector<RaySample> once = loaded.sources.over("floor", 400), again = loaded.sources.over("floor", 400);
  ASSERT_EQ(once.size(), 400u);
  std::map<std::pair<int, int>, int> cells;
  for (std::size_t i = 0; i < once.size(); ++i) {
    EXPECT_EQ(once[i].positionWorld, again[i].positionWorld);
    EXPECT_NEAR(once[i].positionWorld.y, 0.0, 1.0e-6);
    EXPECT_NEAR(once[i].normalWorld.y, 1.0, 1.0e-6);
    ++cells[{static_cast<int>(std::floor(once[i].positionWorld.x / 2.0)),
             static_cast<int>(std::floor(once[i].positionWorld.z / 2.0))}];
  }
  // A floor of 8 x 6 m: 4 x 4 cells with the room's middle on a cell's edge or middle; none is left out or crowded.
  EXPECT_GE(cells.size(), 12u);
  for (const auto& [cell, count] : cells) EXPECT_LE(count, 48) << cell.first << " " << cell.second;
  EXPECT_TRUE(loaded.sources.over("no such object", 10).empty());
}

TEST(RaySources, LineDropsOnToWhatLiesBelow) {
  Loaded loaded("room");
  const auto samples = loaded.sources.alongLine({-3.5, 0.0, 2.5}, {3.5, 0.0, 2.5}, 15);
  ASSERT_EQ(samples.size(), 15u);
  for (const RaySample& s : samples) EXPECT_NEAR(s.positionWorld.y, 0.0, 1.0e-5);
  EXPECT_TRUE(loaded.sources.alongLine({-3.5, -5.0, 2.5}, {3.5, -5.0, 2.5}, 15).empty());
  EXPECT_TRUE(loaded.sources.alongLine({0, 1, 0}, {1, 1, 0}, 5, glm::dvec3(0.0)).empty());
}

TEST(RaySources, HiddenObjectsAreNotThereAndOverridesCount) {
  Loaded loaded("room");
  Scene scene = loaded.scene;
  scene.objects["floor"].visible = false;
  RaySources without({loaded.model}, scene);
  EXPECT_LT(without.triangles()->GetNumberOfCells(), loaded.sources.triangles()->GetNumberOfCells());
  EXPECT_TRUE(without.over("floor", 3).empty());
  const auto names = loaded.sources.objects();
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), names.size());
  for (const Instance& instance : loaded.model->instances) {
    const Mesh& mesh = loaded.model->meshes[static_cast<std::size_t>(instance.mesh)];
    if (instance.node != "floor" || mesh.material < 0) continue;
    scene.objects["floor"].visible = true;
    scene.materials[loaded.model->materials[static_cast<std::size_t>(mesh.material)].name].roughness = 0.625f;
  }
  EXPECT_FLOAT_EQ(RaySources({loaded.model}, scene).over("floor", 1).at(0).roughness, 0.625f);
}

// The ray through a pixel against VTK's own projection, both kinds of camera.
TEST(PixelRays, AgreeWithTheCamera) {
  vtkNew<vtkCamera> camera;
  camera->SetPosition(3.0, 2.0, 5.0);
  camera->SetFocalPoint(-1.0, 0.5, 0.0);
  camera->SetViewUp(0.1, 1.0, 0.0);
  camera->SetViewAngle(54.0);
  camera->SetClippingRange(0.1, 100.0);
  for (const bool parallel : {false, true}) {
    camera->SetParallelProjection(parallel);
    camera->SetParallelScale(2.5);
    const PixelRays rays(camera, 1280, 720);
    for (const auto& [x, y] : {std::pair(0.5, 0.5), std::pair(640.0, 360.0), std::pair(1000.5, 100.5)}) {
      const PixelRay ray = rays.through(x, y);
      const glm::dvec3 p = ray.originWorld + 4.0 * ray.direction;
      double clip[4] = {p.x, p.y, p.z, 1.0};
      camera->GetCompositeProjectionTransformMatrix(1280.0 / 720.0, -1.0, 1.0)->MultiplyPoint(clip, clip);
      EXPECT_NEAR((clip[0] / clip[3] * 0.5 + 0.5) * 1280.0, x, 1.0e-6);
      EXPECT_NEAR((0.5 - clip[1] / clip[3] * 0.5) * 720.0, y, 1.0e-6);
    }
  }
}

}  // namespace
