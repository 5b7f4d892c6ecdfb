// Large objects in pieces: the same surface, cut without a gap, each piece within reach of few probes.
#include <gtest/gtest.h>

#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "filters/core/geometry/divide_model.h"

namespace boxprobe {
namespace {

Model longFloor() {
  Model model;
  model.materials.resize(1);
  Mesh mesh;
  mesh.positions = {{0, 0, 2}, {100, 0, 2}, {100, 0, -2}, {0, 0, -2}};
  mesh.normals.assign(4, glm::vec3(0, 1, 0));
  mesh.uv = {{0, 1}, {50, 1}, {50, 0}, {0, 0}};
  mesh.tangents.assign(4, glm::vec4(1, 0, 0, 1));
  mesh.indices = {0, 1, 2, 0, 2, 3};
  mesh.material = 0;
  model.meshes.push_back(mesh);
  model.instances.push_back({"floor", 0, glm::translate(glm::dmat4(1.0), glm::dvec3(-50, 0, 0))});
  return model;
}

std::vector<Probe> rowOfProbes(int count) {
  std::vector<Probe> probes(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) {
    const double x = -50.0 + 100.0 * i / count;
    probes[static_cast<std::size_t>(i)].name = "probe " + std::to_string(i);
    probes[static_cast<std::size_t>(i)].box = Box{{x - 1.0, -1, -3}, {x + 100.0 / count + 1.0, 3, 3}};
  }
  return probes;
}

double area(const Mesh& mesh) {
  double sum = 0.0;
  for (std::size_t t = 0; t < mesh.indices.size(); t += 3) {
    const glm::dvec3 a(mesh.positions[mesh.indices[t]]), b(mesh.positions[mesh.indices[t + 1]]),
        c(mesh.positions[mesh.indices[t + 2]]);
    const glm::dvec3 n = glm::cross(b - a, c - a);
    EXPECT_GT(n.y, 0.0) << "still wound the same way";
    sum += 0.5 * glm::length(n);
  }
  return sum;
}

TEST(DivideModel, AFloorOfAHundredMetres) {
  const auto model = std::make_shared<const Model>(longFloor());
  const std::vector<Probe> probes = rowOfProbes(16);
  const ProbeIndex index(probes);
  const auto divided = dividedModel(model, glm::dmat4(1.0), probes, index, 4);
  ASSERT_GT(divided->instances.size(), 3u);
  EXPECT_LT(divided->instances.size(), 17u);
  double sum = 0.0;
  std::map<float, int> cuts;  // where pieces end: two of them at each but the ends
  for (const Instance& instance : divided->instances) {
    EXPECT_EQ(instance.node, "floor");
    const Mesh& mesh = divided->meshes[static_cast<std::size_t>(instance.mesh)];
    sum += area(mesh);
    float low = 1e9f, high = -1e9f;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
      low = std::min(low, mesh.positions[i].x);
      high = std::max(high, mesh.positions[i].x);
      EXPECT_NEAR(mesh.uv[i].x, 0.5f * mesh.positions[i].x, 1e-4f);
      EXPECT_EQ(mesh.normals[i], glm::vec3(0, 1, 0));
      EXPECT_EQ(mesh.tangents[i], glm::vec4(1, 0, 0, 1));
    }
    ++cuts[low];
    ++cuts[high];
    EXPECT_LE(index.meeting(Box{{low - 50.0, 0, -2}, {high - 50.0, 0, 2}}).size(), 4u);
  }
  EXPECT_NEAR(sum, 400.0, 1e-3);
  for (const auto& [x, count] : cuts) EXPECT_EQ(count, x == 0.0f || x == 100.0f ? 1 : 2) << x;
}

// No point has more than four, but no cut through the middle of the left half leaves fewer on both sides of it.
TEST(DivideModel, ProbesThatOverlapInTheMiddle) {
  const auto model = std::make_shared<const Model>(longFloor());
  std::vector<Probe> probes(7);
  const Box boxes[] = {{{-50, -1, -3}, {-20, 3, 3}},   {{-50, -1, -3}, {-14, 3, 3}}, {{-52, -1, -3}, {31, 3, 3}},
                       {{-13, -1, -3}, {27, 3, -1.2}}, {{-11, -1, -3}, {44, 3, 3}},  {{29, -1, -3}, {52, 3, 3}},
                       {{-60, -1, -3}, {60, 3, 3}}};
  for (std::size_t i = 0; i < probes.size(); ++i) probes[i].box = boxes[i];
  const ProbeIndex index(probes);
  const auto divided = dividedModel(model, glm::dmat4(1.0), probes, index, 4);
  double contested = 0.0, sum = 0.0;
  for (const Instance& instance : divided->instances) {
    const Mesh& mesh = divided->meshes[static_cast<std::size_t>(instance.mesh)];
    glm::dvec3 low(1e9), high(-1e9);
    for (const glm::vec3& p : mesh.positions) {
      low = glm::min(low, glm::dvec3(p) - glm::dvec3(50, 0, 0));
      high = glm::max(high, glm::dvec3(p) - glm::dvec3(50, 0, 0));
    }
    sum += area(mesh);
    if (index.meeting({low, high}).size() > 4) contested += area(mesh);
  }
  EXPECT_NEAR(sum, 400.0, 1e-3);
  EXPECT_LT(contested, 0.01 * sum);
}

TEST(DivideModel, LeavesAloneWhatDivisionDoesNotHelp) {
  const auto model = std::make_shared<const Model>(longFloor());
  std::vector<Probe> everywhere(50);
  for (Probe& probe : everywhere) probe.box = Box{{-60, -1, -3}, {60, 3, 3}};
  EXPECT_EQ(dividedModel(model, glm::dmat4(1.0), everywhere, ProbeIndex(everywhere), 4), model);
  const std::vector<Probe> few = rowOfProbes(4);
  EXPECT_EQ(dividedModel(model, glm::dmat4(1.0), few, ProbeIndex(few), 4), model);
  // One that covers all of it at a higher importance leaves nothing to the others.
  std::vector<Probe> covered = rowOfProbes(16);
  covered.push_back(everywhere[0]);
  covered.back().importance = 2.0;
  covered.back().blendDistance = BlendDistance{glm::dvec3(0.0), glm::dvec3(0.0)};
  EXPECT_EQ(dividedModel(model, glm::dmat4(1.0), covered, ProbeIndex(covered), 4), model);
}

}  // namespace
}  // namespace boxprobe
