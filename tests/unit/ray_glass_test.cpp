// Rays through glass in the debug view: their corners and their hit on the box against geometry.
#include "filters/vtk/rays/ray_glass.h"

#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/vtk/rays/ray_sources.h"
#include "filters/vtk/rays/vtkProjectionRays.h"

namespace boxprobe {
namespace {

struct Line {
  RayKind kind;
  glm::dvec3 from, to;
};

std::vector<Line> raysOver(const std::string& object, const Scene& scene, const glm::dvec3& eye) {
  RaySources sources({std::make_shared<Model>(loadModelFile(scene.models[0].file))}, scene);
  std::vector<RaySample> samples;
  for (RaySample& s : sources.over(object, 40)) {
    if (glm::dot(s.normalWorld, eye - s.positionWorld) > 0.2) samples.push_back(s);
  }
  vtkNew<vtkProjectionRays> filter;
  filter->SetProbes(scene.probes);
  filter->SetGlass(sources.glass());
  filter->SetEye(eye.x, eye.y, eye.z);
  filter->SetInputData(rayPoints(samples));
  filter->Update();
  std::vector<Line> lines;
  vtkPolyData* out = filter->GetOutput();
  vtkDataArray* kinds = out->GetCellData()->GetArray(ray_array::kKind);
  for (vtkIdType i = 0; i < out->GetNumberOfCells(); ++i) {
    Line line;
    line.kind = static_cast<RayKind>(static_cast<int>(kinds->GetComponent(i, 0)));
    out->GetPoint(2 * i, &line.from.x);
    out->GetPoint(2 * i + 1, &line.to.x);
    lines.push_back(line);
  }
  return lines;
}

std::vector<Line> ofKind(const std::vector<Line>& lines, RayKind kind) {
  std::vector<Line> found;
  for (const Line& line : lines) {
    if (line.kind == kind) found.push_back(line);
  }
  return found;
}

TEST(RayGlass, LeadsThroughTheBallToTheBox) {
  Scene scene = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/glass.boxprobe.json");
  const glm::dvec3 middle(-2.0, 0.97, -0.9), eye(-1.35, 1.25, 0.75);
  const std::vector<Line> lines = raysOver("ball", scene, eye);
  const std::vector<Line> within = ofKind(lines, RayKind::Within), refracted = ofKind(lines, RayKind::Refracted);
  ASSERT_GT(within.size(), 5u);
  ASSERT_EQ(within.size(), refracted.size()) << "nothing is mirrored within a ball";
  for (std::size_t i = 0; i < within.size(); ++i) {
    const glm::dvec3 n = glm::normalize(within[i].from - middle), in = glm::normalize(within[i].to - within[i].from);
    const glm::dvec3 expected = glm::refract(glm::normalize(within[i].from - eye), n, 1.0 / 1.5);
    EXPECT_LT(glm::length(in - expected), 5e-3);
    EXPECT_NEAR(glm::length(within[i].to - middle), 0.36, 2e-3) << "leaves at the surface";
    EXPECT_LT(glm::length(refracted[i].from - within[i].to), 1e-5);
    const glm::dvec3 out = glm::refract(expected, -glm::normalize(within[i].to - middle), 1.5);
    EXPECT_LT(glm::length(glm::normalize(refracted[i].to - refracted[i].from) - out), 2e-2);
    const glm::dvec3 h = refracted[i].to;
    const double off =
        std::min({std::abs(std::abs(h.x) - 3.0), std::abs(h.y), std::abs(h.y - 3.0), std::abs(std::abs(h.z) - 2.5)});
    EXPECT_LT(off, 1e-4) << "ends on the probe's box";
  }
}

TEST(RayGlass, OpaqueThingsHaveNone) {
  Scene scene = loadSceneFile(BOXPROBE_DATA_DIR "/scenes/glass.boxprobe.json");
  scene.materials["ball"].transmission = 0.0f;
  const std::vector<Line> lines = raysOver("ball", scene, {-1.35, 1.25, 0.75});
  EXPECT_TRUE(ofKind(lines, RayKind::Within).empty());
  EXPECT_TRUE(ofKind(lines, RayKind::Refracted).empty());
  EXPECT_FALSE(ofKind(lines, RayKind::Reflected).empty());
}

}  // namespace
}  // namespace boxprobe
