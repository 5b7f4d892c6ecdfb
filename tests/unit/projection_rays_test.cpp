// The filter that turns points into projection rays: hits on the box, lookups, truth, what is undefined, limits, files.
#include <gtest/gtest.h>
#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkFloatArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <limits>
#include <random>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/scene/scene.h"
#include "filters/math/cube/cube_map.h"
#include "filters/vtk/rays/ray_arrays.h"
#include "filters/vtk/rays/ray_scene.h"
#include "filters/vtk/rays/vtkProjectionRays.h"
#include "tests/unit/temporary_folder.h"

namespace {

using namespace boxprobe;

struct Input {
  glm::dvec3 position, normal;
  float roughness = 0.3f;
};

vtkSmartPointer<vtkPolyData> points(const std::vector<Input>& inputs, bool withNormals = true) {
  vtkNew<vtkPoints> positions;
  positions->SetDataTypeToDouble();
  vtkNew<vtkDoubleArray> normals;
  normals->SetNumberOfComponents(3);
  vtkNew<vtkFloatArray> roughness;
  roughness->SetName("roughness");
  for (const Input& in : inputs) {
    positions->InsertNextPoint(&in.position.x);
    normals->InsertNextTuple(&in.normal.x);
    roughness->InsertNextValue(in.roughness);
  }
  auto data = vtkSmartPointer<vtkPolyData>::New();
  data->SetPoints(positions);
  if (withNormals) data->GetPointData()->SetNormals(normals);
  data->GetPointData()->AddArray(roughness);
  return data;
}

Probe probeOfRoom() {
  Probe probe;
  probe.name = "room";
  probe.origin = {0.7, 1.4, -0.5};
  probe.box = {{-4.0, 0.0, -3.0}, {4.0, 3.0, 3.0}};
  probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
  return probe;
}

// One line of the output, read back.
struct Row {
  RayKind kind;
  int status, point, probe, face;
  glm::dvec3 from, to, hitPoint, direction;
  double hitDistance, level, weight, lookupShare, trueDistance, error;
};

std::vector<Row> rowsOf(vtkPolyData* output) {
  vtkCellData* data = output->GetCellData();
  const auto number = [&](const char* name, vtkIdType i) { return data->GetArray(name)->GetComponent(i, 0); };
  const auto vector = [&](const char* name, vtkIdType i) {
    glm::dvec3 v;
    data->GetArray(name)->GetTuple(i, &v.x);
    return v;
  };
  std::vector<Row> rows;
  for (vtkIdType i = 0; i < output->GetNumberOfCells(); ++i) {
    Row row{};
    row.kind = static_cast<RayKind>(static_cast<int>(number(ray_array::kKind, i)));
    row.status = static_cast<int>(number(ray_array::kStatus, i));
    row.point = static_cast<int>(number(ray_array::kPoint, i));
    row.probe = static_cast<int>(number(ray_array::kProbe, i));
    row.face = static_cast<int>(number(ray_array::kFace, i));
    row.hitPoint = vector(ray_array::kHitPoint, i);
    row.direction = vector(ray_array::kDirection, i);
    row.hitDistance = number(ray_array::kHitDistance, i);
    row.level = number(ray_array::kLevel, i);
    row.weight = number(ray_array::kWeight, i);
    row.lookupShare = number(ray_array::kLookupShare, i);
    row.trueDistance = number(ray_array::kTrueDistance, i);
    row.error = number(ray_array::kError, i);
    vtkIdType count = 0;
    const vtkIdType* ids = nullptr;
    output->GetLines()->GetCellAtId(i, count, ids);
    output->GetPoint(ids[0], &row.from.x);
    output->GetPoint(ids[1], &row.to.x);
    rows.push_back(row);
  }
  return rows;
}

std::vector<Row> run(vtkProjectionRays* filter) {
  filter->Update();
  return rowsOf(filter->GetOutput());
}

std::vector<Row> ofKind(const std::vector<Row>& rows, RayKind kind) {
  std::vector<Row> some;
  for (const Row& row : rows) {
    if (row.kind == kind) some.push_back(row);
  }
  return some;
}

// How far a point is from the surface of a probe's box, over the box's largest side.
double offBox(const Probe& probe, const glm::dvec3& world) {
  const glm::dvec3 center = probe.box.center();
  const glm::dvec3 p = glm::transpose(rotationMatrix(probe.rotationDegrees)) * (world - center);
  const glm::dvec3 half = 0.5 * probe.box.size();
  const glm::dvec3 past = glm::abs(p) - half;
  const double largest = std::max({past.x, past.y, past.z});
  const glm::dvec3 size = probe.box.size();
  return std::abs(largest) / std::max({size.x, size.y, size.z});
}

bool allFinite(vtkPolyData* output) {
  const auto finite = [](vtkDataArray* array) {
    for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) {
      for (int c = 0; c < array->GetNumberOfComponents(); ++c) {
        if (!std::isfinite(array->GetComponent(i, c))) return false;
      }
    }
    return true;
  };
  for (int i = 0; i < output->GetCellData()->GetNumberOfArrays(); ++i) {
    if (!finite(output->GetCellData()->GetArray(i))) return false;
  }
  return output->GetPoints() == nullptr || finite(output->GetPoints()->GetData());
}

class Rays : public testing::Test {
 protected:
  Rays() {
    filter->SetEye(-3.5, 2.1, 2.7);
    filter->AddProbe(probeOfRoom());
  }
  void give(const std::vector<Input>& inputs, bool withNormals = true) {
    filter->SetInputData(points(inputs, withNormals));
  }
  vtkNew<vtkProjectionRays> filter;
  const Input floorPoint{{1.0, 0.0, -1.0}, {0.0, 1.0, 0.0}};
};

TEST_F(Rays, HitsLieOnTheBoxTurnedAndFarAway) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> share(0.0, 1.0), signedShare(-1.0, 1.0);
  double worstOff = 0.0, worstDistance = 0.0;
  for (const double away : {0.0, 1.0e6}) {
    for (const double turn : {0.0, 33.0}) {
      Probe probe = probeOfRoom();
      const glm::dvec3 shift(away, -away, away);
      probe.rotationDegrees = {0.5 * turn, turn, -turn};
      probe.origin += shift;
      probe.box.min += shift;
      probe.box.max += shift;
      const glm::dmat3 r = rotationMatrix(probe.rotationDegrees);
      const auto inside = [&] {
        const glm::dvec3 p = (glm::dvec3(share(random), share(random), share(random)) - 0.5) * probe.box.size();
        return probe.box.center() + r * p;
      };
      std::vector<Input> inputs;
      for (int i = 0; i < 5000; ++i) {
        inputs.push_back({inside(), {signedShare(random), signedShare(random), signedShare(random)}});
      }
      give(inputs);
      filter->RemoveAllProbes();
      filter->AddProbe(probe);
      filter->ContributingProbesOnlyOff();
      filter->SetMaximumNumberOfRays(5000);
      const glm::dvec3 eye = inside();
      filter->SetEye(eye.x, eye.y, eye.z);
      const std::vector<Row> reflected = ofKind(run(filter), RayKind::Reflected);
      ASSERT_EQ(reflected.size(), inputs.size());
      for (const Row& row : reflected) {
        worstOff = std::max(worstOff, offBox(probe, row.hitPoint));
        // The same distance by other means: the first of six planes in double.
        const Input& in = inputs[static_cast<std::size_t>(row.point)];
        // Seen from behind, a surface is seen edge-on: nothing is reflected from below it.
        const glm::dvec3 view = glm::normalize(eye - in.position), normal = glm::normalize(in.normal);
        const glm::dvec3 reflection =
            glm::transpose(r) * glm::normalize(2.0 * std::max(glm::dot(view, normal), 0.0) * normal - view);
        const glm::dvec3 p = glm::transpose(r) * (in.position - probe.box.center());
        double nearest = 1.0e30;
        for (int axis = 0; axis < 3; ++axis) {
          for (const double side : {-0.5, 0.5}) {
            const double t = (side * probe.box.size()[axis] - p[axis]) / reflection[axis];
            if (reflection[axis] * side > 0.0) nearest = std::min(nearest, t);
          }
        }
        worstDistance = std::max(worstDistance, std::abs(nearest - row.hitDistance) / 8.0);
        EXPECT_EQ(row.to, row.hitPoint);
      }
    }
  }
  std::printf("  20000 rays: hits off the box by at most %.1e of its size, distances by %.1e\n", worstOff,
              worstDistance);
  EXPECT_LE(worstOff, 1.0e-6);
  EXPECT_LE(worstDistance, 1.0e-5);
}

TEST_F(Rays, LookupIsFromTheCaptureOriginToTheHit) {
  give({floorPoint});
  const std::vector<Row> rows = run(filter);
  const Row reflected = ofKind(rows, RayKind::Reflected).at(0);
  const std::vector<Row> lookups = ofKind(rows, RayKind::Lookup);
  ASSERT_EQ(lookups.size(), 1u);
  EXPECT_EQ(lookups[0].from, probeOfRoom().origin);
  EXPECT_LE(glm::length(lookups[0].to - reflected.hitPoint), 1.0e-6);
  EXPECT_LE(glm::length(lookups[0].direction - (reflected.hitPoint - probeOfRoom().origin)), 1.0e-6);
  EXPECT_FLOAT_EQ(static_cast<float>(reflected.weight), 1.0f);
  const float level = shading::levelForRoughness(floorPoint.roughness, 6.0f);
  EXPECT_FLOAT_EQ(static_cast<float>(lookups[0].level), level);  // faces of 256 texels: levels 0 to 6
  EXPECT_EQ(reflected.status, 0);
  EXPECT_EQ(ofKind(rows, RayKind::Eye).at(0).to, floorPoint.position);
}

// Any technique: what it fetches shows by itself, and the shares say that a map of one colour comes out as it is.
TEST_F(Rays, EveryTechniqueShowsItsLookups) {
  give({floorPoint});
  for (const ProjectionRow& projection : projectionRows()) {
    for (const EvaluationRow& evaluation : evaluationRows()) {
      const std::string id = std::string(projection.id) + "+" + std::string(evaluation.id);
      filter->SetProbeTechnique(0, id.c_str());
      const std::vector<Row> lookups = ofKind(run(filter), RayKind::Lookup);
      ASSERT_FALSE(lookups.empty()) << id;
      double sum = 0.0;
      for (const Row& row : lookups) {
        sum += row.lookupShare;
        EXPECT_GE(row.level, 0.0) << id;
        EXPECT_LE(row.level, 6.0) << id;
      }
      EXPECT_NEAR(sum, 1.0, 1.0e-4) << id;
      EXPECT_TRUE(allFinite(filter->GetOutput())) << id;
    }
  }
}

TEST_F(Rays, UndefinedPointsSayWhyAndMakeNoNan) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const double infinity = std::numeric_limits<double>::infinity();
  double eye[3];
  filter->GetEye(eye);
  give({{floorPoint.position, glm::dvec3(0.0)},         // 0: no normal
        {floorPoint.position, {nan, 1.0, 0.0}},         // 1: no normal either
        {{eye[0], eye[1], eye[2]}, {0.0, 1.0, 0.0}},    // 2: the eye itself
        {floorPoint.position, {0.0, -1.0, 0.0}},        // 3: seen from behind
        {{nan, 0.0, 0.0}, {0.0, 1.0, 0.0}},             // 4: nowhere
        {{0.0, infinity, 0.0}, {0.0, 1.0, 0.0}},        // 5: nowhere
        {{0.0, -40.0, 0.0}, {0.0, 1.0, 0.0}},           // 6: outside every influence
        {floorPoint.position, {0.0, 1e-200, 0.0}},      // 7: a tiny normal is one
        {floorPoint.position, {0.0, 1.0, 0.0}, NAN}});  // 8: roughness that is none
  const std::vector<Row> rows = run(filter);
  EXPECT_TRUE(allFinite(filter->GetOutput()));
  const auto kinds = [&](int point) {
    std::vector<int> found;
    for (const Row& row : rows) {
      if (row.point == point) found.push_back(static_cast<int>(row.kind));
    }
    return found;
  };
  const auto status = [&](int point) {
    int found = 0;
    for (const Row& row : rows) {
      if (row.point == point) found |= row.status;
    }
    return found;
  };
  EXPECT_EQ(kinds(0), std::vector<int>({0}));
  EXPECT_EQ(status(0), kRayNoNormal);
  EXPECT_EQ(kinds(1), std::vector<int>({0}));
  EXPECT_EQ(kinds(2), std::vector<int>({1}));
  EXPECT_EQ(status(2), kRayEyeOnPoint);
  EXPECT_EQ(kinds(3), std::vector<int>({0, 1, 2, 3}));
  EXPECT_EQ(status(3), kRayFromBehind);
  EXPECT_TRUE(kinds(4).empty());
  EXPECT_TRUE(kinds(5).empty());
  EXPECT_EQ(kinds(6), std::vector<int>({0, 1, 2}));
  EXPECT_EQ(status(6), kRayNoProbe | kRayNoProxy);
  EXPECT_EQ(status(7), 0);
  EXPECT_EQ(kinds(8), std::vector<int>({0, 1, 2, 3}));

  give({floorPoint}, false);
  EXPECT_EQ(run(filter).size(), 1u);
  EXPECT_EQ(run(filter)[0].status, kRayNoNormal);
}

TEST_F(Rays, ProbeWithoutBoxAndPointsOutside) {
  give({floorPoint});
  for (const char* id : {"infinite", "normal"}) {
    filter->SetProbeTechnique(0, id);
    filter->SetMaximumLength(12.0);
    const std::vector<Row> rows = run(filter);
    const Row reflected = ofKind(rows, RayKind::Reflected).at(0);
    EXPECT_EQ(reflected.status, kRayNoProxy) << id;
    EXPECT_EQ(reflected.hitDistance, -1.0) << id;
    EXPECT_EQ(reflected.face, -1) << id;
    EXPECT_NEAR(glm::length(reflected.to - reflected.from), 12.0, 1e-9) << id;
    const Row lookup = ofKind(rows, RayKind::Lookup).at(0);
    EXPECT_NEAR(glm::length(lookup.to - lookup.from), 12.0, 1e-5) << id;
  }
  Probe off = probeOfRoom();
  off.projection = false;
  filter->RemoveAllProbes();
  filter->AddProbe(off);
  EXPECT_EQ(ofKind(run(filter), RayKind::Reflected).at(0).status, kRayNoProxy);

  Probe outside = probeOfRoom();
  outside.origin = {0.0, 9.0, 0.0};
  outside.influence = Box{glm::dvec3(-20.0), glm::dvec3(20.0)};
  filter->RemoveAllProbes();
  filter->AddProbe(outside);
  give({floorPoint, {{6.0, -2.0, 0.0}, {0.0, 1.0, 0.0}}});
  const std::vector<Row> reflected = ofKind(run(filter), RayKind::Reflected);
  ASSERT_EQ(reflected.size(), 2u);
  EXPECT_EQ(reflected[0].status, kRayOriginOutside);
  EXPECT_EQ(reflected[1].status, kRayOriginOutside | kRayPointOutside);
  for (const Row& row : reflected) EXPECT_LE(offBox(outside, row.hitPoint), 1.0e-6);
}

TEST_F(Rays, ParallelProjectionLooksTheSameWayEverywhere) {
  give({floorPoint, {{-2.0, 0.0, 2.0}, {0.0, 1.0, 0.0}}});
  filter->ParallelProjectionOn();
  filter->SetViewDirection(2.0, -2.0, 0.0);
  const std::vector<Row> rows = run(filter);
  for (const Row& row : ofKind(rows, RayKind::Reflected)) {
    const glm::dvec3 r = glm::normalize(row.to - row.from);
    EXPECT_LE(glm::length(r - glm::normalize(glm::dvec3(1.0, 1.0, 0.0))), 1.0e-6);
  }
  for (const Row& row : ofKind(rows, RayKind::Eye)) {
    EXPECT_NEAR(glm::length(row.to - row.from), filter->GetMaximumLength(), 1e-9);
  }
}

// As the shader deals them out: the more important probe first, equals in proportion.
TEST_F(Rays, SharesOfSeveralProbes) {
  Probe first = probeOfRoom(), second = probeOfRoom(), third = probeOfRoom();
  first.importance = 2.0;
  first.blendDistance = {glm::dvec3(4.0), glm::dvec3(4.0)};
  first.box = Box{{-4.0, -3.0, -3.0}, {4.0, 3.0, 3.0}};
  filter->RemoveAllProbes();
  for (const Probe& p : {second, first, third}) filter->AddProbe(p);
  give({floorPoint});
  const std::vector<Row> rows = ofKind(run(filter), RayKind::Reflected);
  ASSERT_EQ(rows.size(), 3u);
  const ProbeGeometry g = probeGeometry(first, first.origin);
  const float weight = shading::influenceWeight(glm::vec3(floorPoint.position - first.origin), g.influenceMin,
                                                g.influenceMax, g.rateMin, g.rateMax);
  const double w = static_cast<double>(weight * shading::groupScale(weight));
  ASSERT_GT(w, 0.05);
  ASSERT_LT(w, 0.95);
  EXPECT_NEAR(rows[1].weight, w, 1e-6);
  EXPECT_NEAR(rows[0].weight, 0.5 * (1.0 - w), 1e-6);
  EXPECT_NEAR(rows[2].weight, 0.5 * (1.0 - w), 1e-6);
}

TEST_F(Rays, LimitsAndKinds) {
  std::vector<Input> inputs;
  for (int i = 0; i < 100; ++i) inputs.push_back({{-3.0 + 0.06 * i, 0.0, 0.0}, {0.0, 1.0, 0.0}});
  give(inputs);
  filter->SetMaximumNumberOfRays(10);
  const std::vector<Row> rows = ofKind(run(filter), RayKind::Reflected);
  ASSERT_EQ(rows.size(), 10u);
  for (std::size_t i = 0; i < rows.size(); ++i) EXPECT_EQ(rows[i].point, static_cast<int>(10 * i));  // spread over all
  filter->SetKindEnabled(RayKind::Reflected, false);
  filter->SetKindEnabled(RayKind::Eye, false);
  const std::vector<Row> fewer = run(filter);
  EXPECT_EQ(fewer.size(), 20u);
  EXPECT_TRUE(ofKind(fewer, RayKind::Eye).empty());
  filter->SetNormalLength(0.5);
  const Row normal = ofKind(run(filter), RayKind::Normal).at(0);
  EXPECT_NEAR(glm::length(normal.to - normal.from), 0.5, 1e-12);
  filter->SetMaximumNumberOfRays(0);
  EXPECT_TRUE(run(filter).empty());
}

// The first 31 lights may throw shadows: a bit of each probe for each.
TEST_F(Rays, GoToTheLightsThatThrowShadows) {
  std::vector<Light> lights(36);
  for (Light& light : lights) {
    light.type = LightType::Directional;
    light.direction = {0.3, -0.9, -0.2};
  }
  const auto throwing = [&](std::size_t i) -> Light& {
    lights[i].shadows = LightShadows::Coverage;
    return lights[i];
  };
  throwing(1).direction = {-0.4, -0.8, 0.1};
  throwing(3).direction = {0.1, 0.7, 0.2};  // from below the floor
  throwing(5).type = LightType::Point;
  lights[5].position = {0.5, 9.0, 0.25};
  throwing(6).type = LightType::Point;  // in the box
  lights[6].position = {0.2, 2.5, 0.3};
  throwing(33);
  throwing(34);  // the bits of 1 and 2, were they counted around
  filter->SetLights(lights);
  give({floorPoint});
  const std::vector<Row> rows = ofKind(run(filter), RayKind::Shadow);
  ASSERT_EQ(rows.size(), 2u);
  const Probe probe = probeOfRoom();
  const glm::dvec3 from = floorPoint.position, toLights[] = {{0.4, 0.8, -0.1}, lights[5].position - from};
  for (std::size_t i = 0; i < 2; ++i) {
    const glm::dvec3 d = glm::normalize(toLights[i]);
    const glm::dvec3 end((d.x > 0.0 ? 4.0 : -4.0), 3.0, d.z > 0.0 ? 3.0 : -3.0);
    const glm::dvec3 far = (end - from) / d;
    const double distance = std::min({far.x, far.y, far.z});
    EXPECT_LT(glm::length(rows[i].to - (from + distance * d)), 1e-5) << i;
    EXPECT_NEAR(rows[i].hitDistance, distance, 1e-5) << i;
    EXPECT_LT(glm::length(rows[i].direction - (from + distance * d - probe.origin)), 1e-5) << i;
    EXPECT_EQ(rows[i].probe, 0);
    EXPECT_EQ(rows[i].point, 0);
  }
  filter->SetKindEnabled(RayKind::Shadow, false);
  EXPECT_TRUE(ofKind(run(filter), RayKind::Shadow).empty());
}

// A table top of 1 m² half way up: rays that would reach the ceiling end there instead.
TEST_F(Rays, TrueHitByTheSceneAndItsError) {
  vtkNew<vtkPoints> corners;
  corners->InsertNextPoint(0.0, 1.0, -3.0);
  corners->InsertNextPoint(3.0, 1.0, -3.0);
  corners->InsertNextPoint(0.0, 1.0, 3.0);
  vtkNew<vtkCellArray> triangle;
  triangle->InsertNextCell({0, 1, 2});
  vtkNew<vtkPolyData> scene;
  scene->SetPoints(corners);
  scene->SetPolys(triangle);
  filter->SetSceneData(scene);
  filter->SetEye(0.5, 2.0, -1.0);
  give({{{0.4, 0.0, -1.0}, {0.0, 1.0, 0.0}}, {{-3.0, 0.0, -1.0}, {0.0, 1.0, 0.0}}});
  const std::vector<Row> rows = run(filter);
  const std::vector<Row> truth = ofKind(rows, RayKind::TrueHit), error = ofKind(rows, RayKind::Error);
  ASSERT_EQ(truth.size(), 1u);  // the second ray meets nothing
  ASSERT_EQ(error.size(), 1u);
  const glm::dvec3 expected(0.35, 1.0, -1.0);
  EXPECT_LE(glm::length(truth[0].to - expected), 1.0e-6);
  EXPECT_NEAR(truth[0].trueDistance, glm::length(expected - truth[0].from), 1.0e-6);
  EXPECT_NEAR(error[0].error, truth[0].hitDistance - truth[0].trueDistance, 1.0e-5);
  EXPECT_EQ(error[0].to, truth[0].to);
  for (const Row& row : ofKind(rows, RayKind::Reflected)) {
    if (row.point == 1) {
      EXPECT_EQ(row.trueDistance, -1.0);
      EXPECT_EQ(row.error, -1.0);
    }
  }
}

// The probe's own distances of an empty room: the true hit is the box's, in a turned box too, with a map along
// the world's axes and one along the box's.
TEST_F(Rays, TrueHitByTheProbesDistances) {
  for (const auto& [turn, mapTurn] : {std::pair(0.0, 0.0), std::pair(25.0, 0.0), std::pair(25.0, 25.0)}) {
    Probe probe = probeOfRoom();
    probe.rotationDegrees = {0.0, turn, 0.0};
    const glm::dvec3 mapRotation(0.0, mapTurn, 0.0);
    const ProbeGeometry g = probeGeometry(probe, probe.origin, mapRotation);
    auto distances = std::make_shared<CubeMap>(256, 1);
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < 256; ++row) {
        for (int column = 0; column < 256; ++column) {
          const glm::dvec3 d = glm::normalize(glm::dvec3(
              shading::cubeDirection(face, -1.0f + (column + 0.5f) / 128.0f, -1.0f + (row + 0.5f) / 128.0f)));
          const glm::vec3 factors =
              shading::slabFactors(glm::vec3(0.0f), glm::vec3(glm::transpose(g.mapFromProbe) * d), g.boxMin, g.boxMax);
          distances->setTexel(0, face, column, row, glm::vec4(std::min({factors.x, factors.y, factors.z})));
        }
      }
    }
    filter->RemoveAllProbes();
    filter->AddProbe(probe);
    filter->SetProbeDistances(0, distances);
    filter->SetProbeCapturedRotation(0, 0.0, mapTurn, 0.0);
    std::vector<Input> inputs;
    for (int i = 0; i < 200; ++i) inputs.push_back({{-2.0 + 0.02 * i, 0.0, 1.0 - 0.01 * i}, {0.0, 1.0, 0.0}});
    give(inputs);
    const std::vector<Row> errors = ofKind(run(filter), RayKind::Error);
    ASSERT_EQ(errors.size(), inputs.size());
    int far = 0;
    for (const Row& row : errors) far += row.error > 1.0e-3 ? 1 : 0;
    EXPECT_LE(far, 4) << "turned by " << turn << ", its map by "
                      << mapTurn;  // at the room's edges a texel sees two walls
  }
}

TEST_F(Rays, BadValuesAreErrorsAndChangeNothing) {
  give({floorPoint});
  const std::vector<Row> before = run(filter);
  int errors = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&errors);
  observer->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  filter->AddObserver(vtkCommand::ErrorEvent, observer);
  filter->SetProbeBounds(0, 1.0, -1.0, 0.0, 3.0, -3.0, 3.0);
  filter->SetProbeBounds(0, NAN, 1.0, 0.0, 3.0, -3.0, 3.0);
  filter->SetProbeOrigin(0, INFINITY, 0.0, 0.0);
  filter->SetProbeBlendDistance(0, -1.0);
  filter->SetProbeTechnique(0, "cylinder");
  filter->SetProbeTechnique(0, nullptr);
  filter->SetProbeMaximumLevel(0, -1.0);
  filter->SetProbeName(1, "no such probe");
  EXPECT_EQ(errors, 8);
  const std::vector<Row> after = run(filter);
  ASSERT_EQ(before.size(), after.size());
  for (std::size_t i = 0; i < before.size(); ++i) EXPECT_EQ(before[i].to, after[i].to);
  filter->SetEye(NAN, 0.0, 0.0);
  filter->Update();
  EXPECT_GT(errors, 8);
}

TEST_F(Rays, ExecutesOnlyWhenSomethingChanged) {
  give({floorPoint});
  int executions = 0;
  vtkNew<vtkCallbackCommand> observer;
  observer->SetClientData(&executions);
  observer->SetCallback([](vtkObject*, unsigned long, void* count, void*) { ++*static_cast<int*>(count); });
  filter->AddObserver(vtkCommand::StartEvent, observer);
  filter->Update();
  filter->Update();
  EXPECT_EQ(executions, 1);
  filter->SetProbeOrigin(0, 0.0, 1.0, 0.0);
  filter->Update();
  EXPECT_EQ(executions, 2);
  filter->SetKindEnabled(RayKind::Normal, true);  // it is
  filter->Update();
  EXPECT_EQ(executions, 2);
}

class SavedRays : public TemporaryFolder {};

TEST_F(SavedRays, ThePlainProgramsFileReadBack) {
  const std::string path = file("rays.vtp");
  ASSERT_EQ(std::system((std::string(BOXPROBE_RAYS_EXAMPLE) + " " + path).c_str()), 0);
  vtkNew<vtkXMLPolyDataReader> reader;
  reader->SetFileName(path.c_str());
  reader->Update();
  vtkPolyData* saved = reader->GetOutput();
  const std::vector<Row> rows = rowsOf(saved);
  ASSERT_EQ(rows.size(), 81u * 4);
  auto* names = vtkStringArray::SafeDownCast(saved->GetFieldData()->GetAbstractArray(ray_array::kProbeNames));
  ASSERT_NE(names, nullptr);
  EXPECT_EQ(names->GetValue(0), "room");
  Probe probe;
  probe.origin = {0.0, 1.5, 0.0};
  probe.box = {{-3.0, 0.0, -2.5}, {3.0, 3.0, 2.5}};
  for (const Row& row : ofKind(rows, RayKind::Reflected)) {
    EXPECT_LE(offBox(probe, row.hitPoint), 1.0e-6);
    EXPECT_NEAR(glm::length(row.hitPoint - row.from), row.hitDistance, 1.0e-5);
    EXPECT_EQ(row.weight, 1.0);
    EXPECT_EQ(row.status, 0);
  }
}

// Points on the edges that two triangles share, on a ground as wide as a planet: rounding puts them beside both.
TEST(RayScene, NoRaySlipsBetweenTwoTrianglesHoweverLarge) {
  constexpr int kSide = 24;
  for (const double scale : {1.0, 1e9}) {
    std::mt19937 chance(5);
    std::uniform_real_distribution<double> between(0.0, 1.0);
    vtkNew<vtkPoints> places;
    places->SetDataTypeToDouble();
    std::vector<glm::dvec3> corners;
    for (int i = 0; i < kSide * kSide; ++i) {
      corners.push_back(scale * glm::dvec3(i % kSide + 0.3 * between(chance), 0.1 * between(chance), i / kSide));
      places->InsertNextPoint(&corners.back().x);
    }
    vtkNew<vtkCellArray> cells;
    std::vector<std::pair<vtkIdType, vtkIdType>> edges;
    for (vtkIdType y = 0; y + 1 < kSide; ++y) {
      for (vtkIdType x = 0; x + 1 < kSide; ++x) {
        const vtkIdType a = y * kSide + x, b = a + 1, c = a + kSide, d = c + 1;
        const vtkIdType first[] = {a, c, b}, second[] = {b, c, d};
        cells->InsertNextCell(3, first);
        cells->InsertNextCell(3, second);
        edges.emplace_back(b, c);
      }
    }
    vtkNew<vtkPolyData> ground;
    ground->SetPoints(places);
    ground->SetPolys(cells);
    RayScene scene(ground);
    const glm::dvec3 eye = scale * glm::dvec3(9.7, 31.3, 13.1);
    int missed = 0;
    for (const auto& [from, to] : edges) {
      for (int i = 0; i < 40; ++i) {
        const double t = between(chance);
        const glm::dvec3 target =
            (1.0 - t) * corners[static_cast<std::size_t>(from)] + t * corners[static_cast<std::size_t>(to)];
        missed += scene.firstHit(eye, glm::normalize(target - eye), 0.0, scene.reachFrom(eye)) ? 0 : 1;
      }
    }
    EXPECT_EQ(missed, 0) << scale;
  }
}

}  // namespace
