// Lamps of a scene: triangles that shine merged to polygons, and what is no lamp or not quite one.
#include "filters/core/geometry/scene_lamps.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include "filters/core/geometry/flat_polygons.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"

namespace {

using namespace boxprobe;
using glm::dvec3;
using glm::vec3;
using ::testing::ElementsAre;
using ::testing::HasSubstr;

constexpr double kPi = 3.14159265358979323846;

Mesh meshOf(std::vector<vec3> positions, std::vector<std::uint32_t> indices, int material) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.indices = std::move(indices);
  mesh.material = material;
  return mesh;
}

// A rectangle in columns x rows pieces of two triangles, each with vertices of its own as files often have them.
Mesh grid(const vec3& corner, const vec3& along, const vec3& up, int columns, int rows, int material) {
  Mesh mesh;
  mesh.material = material;
  const auto at = [&](int i, int j) {
    return corner + static_cast<float>(i) / static_cast<float>(columns) * along +
           static_cast<float>(j) / static_cast<float>(rows) * up;
  };
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) {
      for (const vec3& p : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
        mesh.positions.push_back(p);
      }
    }
  }
  return mesh;
}

Material shining(const char* name, const vec3& radiance) {
  Material material;
  material.name = name;
  material.emissive = radiance;
  return material;
}

// A dark room of 4 x 2.6 x 3 m, material 0, whose floor and walls make anything bright stand out.
struct World {
  Scene scene;
  Model model;

  World() {
    scene.models.resize(1);
    model.materials.push_back(shining("paint", vec3(0.0f)));
    add("floor", grid({-2, 0, 1.5f}, {4, 0, 0}, {0, 0, -3}, 1, 1, 0));
    add("wall", grid({-2, 0, -1.5f}, {4, 0, 0}, {0, 2.6f, 0}, 1, 1, 0));
    Probe probe;
    probe.name = "room";
    probe.origin = {0.3, 1.1, -0.2};
    probe.box = {{-2, 0, -1.5}, {2, 2.6, 1.5}};
    scene.probes.push_back(probe);
  }

  int material(Material m) {
    model.materials.push_back(std::move(m));
    return static_cast<int>(model.materials.size()) - 1;
  }
  void add(const char* node, Mesh mesh, const glm::dmat4& place = glm::dmat4(1.0)) {
    model.instances.push_back({node, static_cast<int>(model.meshes.size()), place});
    model.meshes.push_back(std::move(mesh));
  }
  SceneLamps lamps() const { return sceneLamps(scene, {std::make_shared<const Model>(model)}); }
};

// In the ceiling, shining down: counterclockwise from below.
Mesh panel(int columns, int rows, int material) {
  return grid({-0.4f, 2.5f, -0.3f}, {1.3f, 0, 0}, {0, 0, 0.7f}, columns, rows, material);
}

TEST(SceneLamps, ATessellatedPanelIsOneRectangle) {
  World world;
  const int lamp = world.material(shining("lamp", {5.0f, 4.0f, 3.0f}));
  world.add("panel", panel(7, 4, lamp));
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 1u);
  const SceneLamp& it = found.lamps[0];
  EXPECT_EQ(it.node, "panel");
  EXPECT_EQ(it.material, "lamp");
  EXPECT_EQ(it.corners.size(), 4u);
  EXPECT_NEAR(it.area, 1.3 * 0.7, 1e-6);
  EXPECT_NEAR(it.power, kPi * 1.3 * 0.7 * 4.0, 1e-5);
  EXPECT_NEAR(glm::length(it.normal - dvec3(0, -1, 0)), 0.0, 1e-9);
  EXPECT_NEAR(glm::length(it.middle - dvec3(0.25, 2.5, 0.05)), 0.0, 1e-6);
  EXPECT_EQ(it.radiance, dvec3(5, 4, 3));
  EXPECT_FALSE(it.bothSides);
  EXPECT_TRUE(found.remarks.empty());
  EXPECT_THAT(probeLamps(found.lamps, world.scene.probes[0]), ElementsAre(0u));
  // As the mathematics takes it: from the capture origin the panel fills what quadrature on paper says, and no floor
  // above it sees it.
  const LampPolygon polygon = lampPolygon(it, world.scene.probes[0].origin);
  EXPECT_GT(shading::lampDiffuse(&polygon, vec3(0.0f), vec3(0, 1, 0)), 0.1f);
  EXPECT_EQ(shading::lampDiffuse(&polygon, vec3(0.0f, 2.0f, 0.0f), vec3(0, -1, 0)), 0.0f);
}

TEST(SceneLamps, PolygonsThatAreNotConvexAreCutIntoFewThatAre) {
  // An L of 5 m², and a frame of 3 x 2 m about a hole of 1.4 x 0.8 m, both in triangles.
  const auto areaOf = [](const std::vector<FlatPolygon>& polygons) {
    double area = 0.0;
    for (const FlatPolygon& p : polygons) {
      area += glm::length(areaVector(p.corners));
      for (std::size_t i = 0; i < p.corners.size(); ++i) {  // each turns left everywhere
        const std::size_t n = p.corners.size();
        const dvec3 in = p.corners[i] - p.corners[(i + n - 1) % n], out = p.corners[(i + 1) % n] - p.corners[i];
        EXPECT_GT(glm::cross(in, out).z, 0.0);
      }
    }
    return area;
  };
  const std::vector<dvec3> l = {{0, 0, 2}, {3, 0, 2}, {3, 1, 2}, {1, 1, 2}, {1, 3, 2}, {0, 3, 2}};
  const std::vector<FlatPolygon> bent = flatPolygons(l, {{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 5}});
  EXPECT_EQ(bent.size(), 2u);
  EXPECT_NEAR(areaOf(bent), 5.0, 1e-12);
  const std::vector<dvec3> frame = {{0, 0, 0},     {3, 0, 0},     {3, 2, 0},     {0, 2, 0},
                                    {0.7, 0.5, 0}, {2.1, 0.5, 0}, {2.1, 1.3, 0}, {0.7, 1.3, 0}};
  const std::vector<FlatPolygon> around =
      flatPolygons(frame, {{0, 1, 5}, {0, 5, 4}, {1, 2, 6}, {1, 6, 5}, {2, 3, 7}, {2, 7, 6}, {3, 0, 4}, {3, 4, 7}});
  EXPECT_EQ(around.size(), 4u);
  EXPECT_NEAR(areaOf(around), 3.0 * 2.0 - 1.4 * 0.8, 1e-12);
  for (const FlatPolygon& p : around) EXPECT_EQ(p.component, around[0].component);
  EXPECT_EQ(polygonCentroid(l).x, polygonCentroid(l).y);
  EXPECT_NEAR(polygonCentroid(l).x, (3.0 * 1.5 + 2.0 * 0.5) / 5.0, 1e-12);
}

TEST(SceneLamps, ADiscIsAnOctagonOfItsArea) {
  std::vector<dvec3> round;
  for (int i = 0; i < 40; ++i) {
    round.emplace_back(0.6 + 0.35 * std::cos(2 * kPi * i / 40), 1.7, -0.2 + 0.35 * std::sin(2 * kPi * i / 40));
  }
  const std::vector<dvec3> fewer = withFewerCorners(round, 8);
  ASSERT_EQ(fewer.size(), 8u);
  EXPECT_NEAR(glm::length(areaVector(fewer)), glm::length(areaVector(round)), 1e-12);
  EXPECT_NEAR(glm::length(polygonCentroid(fewer) - dvec3(0.6, 1.7, -0.2)), 0.0, 1e-12);
  for (const dvec3& corner : fewer) EXPECT_NEAR(glm::length(corner - dvec3(0.6, 1.7, -0.2)), 0.35, 0.035);
}

TEST(SceneLamps, ABoxIsSixFacesOfOneGroup) {
  World world;
  const int lamp = world.material(shining("lamp", vec3(9.0f)));
  const std::vector<vec3> p = {{0.1f, 1, 0},    {0.6f, 1, 0},    {0.6f, 1.2f, 0},    {0.1f, 1.2f, 0},
                               {0.1f, 1, 0.3f}, {0.6f, 1, 0.3f}, {0.6f, 1.2f, 0.3f}, {0.1f, 1.2f, 0.3f}};
  world.add("box", meshOf(p, {0, 2, 1, 0, 3, 2, 4, 5, 6, 4, 6, 7, 0, 1, 5, 0, 5, 4,
                              3, 7, 6, 3, 6, 2, 0, 4, 7, 0, 7, 3, 1, 2, 6, 1, 6, 5},
                          lamp));
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 6u);
  dvec3 sum(0.0);
  for (const SceneLamp& face : found.lamps) {
    EXPECT_EQ(face.group, found.lamps[0].group);
    EXPECT_GT(glm::dot(face.normal, face.middle - dvec3(0.35, 1.1, 0.15)), 0.0);  // outwards
    sum += face.area * face.normal;
  }
  EXPECT_NEAR(glm::length(sum), 0.0, 1e-7);
  EXPECT_GT(found.lamps[0].power, found.lamps[5].power);
  EXPECT_EQ(probeLamps(found.lamps, world.scene.probes[0]).size(), 6u);
  EXPECT_TRUE(probeLamps(found.lamps, world.scene.probes[0], 5).empty());  // together or not at all
}

TEST(SceneLamps, ProbesTakeTheMostPowerfulOfTheirBox) {
  World world;
  for (int i = 0; i < 11; ++i) {
    const int lamp = world.material(shining("lamp", vec3(3.0f + static_cast<float>((7 * i) % 11))));
    world.add(("lamp " + std::to_string(i)).c_str(),
              grid({-1.9f + 0.3f * static_cast<float>(i), 2.5f, 0}, {0.2f, 0, 0}, {0, 0, 0.1f}, 1, 1, lamp));
  }
  const int far = world.material(shining("far", vec3(12.0f)));
  world.add("next door", grid({5, 2.5f, 0}, {0.2f, 0, 0}, {0, 0, 0.1f}, 1, 1, far));
  world.add("outwards", grid({-2, 0.5f, 0}, {0, 0, 1}, {0, 1, 0}, 1, 1, far));  // in the wall, its back to the room
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 13u);
  const Probe& probe = world.scene.probes[0];
  const std::vector<std::size_t> chosen = probeLamps(found.lamps, probe);
  ASSERT_EQ(chosen.size(), kMostProbeLamps);
  double before = 1e300;
  for (const std::size_t i : chosen) {
    EXPECT_EQ(found.lamps[i].material, "lamp");
    EXPECT_LE(found.lamps[i].power, before);
    EXPECT_GE(found.lamps[i].radiance.x, 6.0);  // 3, 4 and 5 are left in the map
    before = found.lamps[i].power;
  }
  Probe hiding = probe;
  hiding.hides = {found.lamps[chosen[0]].node};
  EXPECT_NE(probeLamps(found.lamps, hiding)[0], chosen[0]);
  EXPECT_EQ(probeLamps(found.lamps, hiding).size(), kMostProbeLamps);  // the next one steps in
  Probe turned = probe;  // its box reaches the lamp next door only when it is turned
  turned.box = {{2.5, 0, -2.2}, {3.5, 2.6, 2.2}};
  EXPECT_TRUE(probeLamps(found.lamps, turned).empty());
  turned.rotationDegrees = {0, 90, 0};
  EXPECT_EQ(probeLamps(found.lamps, turned).size(), 3u);  // it, and the two nearest that reach into the box
}

TEST(SceneLamps, WhatIsNoLampIsSaid) {
  World world;
  const int lamp = world.material(shining("lamp", vec3(8.0f)));
  world.add("line", meshOf({{0, 1, 0}, {1, 1, 0}, {0.5f, 1, 0}}, {0, 1, 2}, lamp));
  Mesh sphere;
  sphere.material = lamp;
  const auto at = [](int i, int j) {
    const double a = 2 * kPi * (i % 12) / 12, b = kPi * j / 6;
    return vec3(0.1 * std::sin(b) * std::cos(a), 1.5 + 0.1 * std::cos(b), 0.1 * std::sin(b) * std::sin(a));
  };
  for (int i = 0; i < 12; ++i) {
    for (int j = 0; j < 6; ++j) {
      for (const vec3& p : {at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j), at(i + 1, j + 1), at(i, j + 1)}) {
        sphere.indices.push_back(static_cast<std::uint32_t>(sphere.positions.size()));
        sphere.positions.push_back(p);
      }
    }
  }
  world.add("bulb", sphere);
  const SceneLamps found = world.lamps();
  EXPECT_TRUE(found.lamps.empty());
  EXPECT_THAT(found.remarks,
              ElementsAre(HasSubstr("objects.line: shines and has no area"), HasSubstr("objects.bulb: a curved lamp")));
}

TEST(SceneLamps, TenThousandTrianglesAreTheLimit) {
  World world;
  const int lamp = world.material(shining("lamp", vec3(50.0f)));
  world.add("first", panel(50, 60, lamp));  // 6,000 triangles
  world.add("second", grid({-1.8f, 2.4f, -1}, {0.3f, 0, 0}, {0, 0, 0.4f}, 60, 50, lamp));
  world.add("third", grid({1.2f, 2.4f, -1}, {0.3f, 0, 0}, {0, 0, 0.4f}, 40, 50, lamp));  // 4,000
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 2u);
  EXPECT_EQ(found.lamps[0].node, "first");
  EXPECT_EQ(found.lamps[0].corners.size(), 4u);
  EXPECT_EQ(found.lamps[1].node, "third");
  EXPECT_THAT(found.remarks,
              ElementsAre(HasSubstr("objects.second: with its 6000 triangles lamps would have more than 10000")));
}

TEST(SceneLamps, EmissionMayBeTexturedOrHugeOrNone) {
  World world;
  auto image = std::make_shared<ImageRgba8>();
  image->width = 2;
  image->height = 1;
  image->pixels = {255, 0, 255, 255, 0, 0, 188, 255};
  Material picture = shining("picture", {6.0f, 6.0f, 2.0f});
  picture.emissiveTexture.image = image;
  world.add("screen", panel(1, 1, world.material(picture)));
  world.add("sun",
            grid({1.2f, 2.4f, -1}, {0.01f, 0, 0}, {0, 0, 0.01f}, 1, 1, world.material(shining("hot", vec3(1.0e6f)))));
  Material broken = shining("broken", {std::nanf(""), 1.0f, 1.0f});
  world.add("broken", grid({-1.2f, 2.4f, -1}, {0.1f, 0, 0}, {0, 0, 0.1f}, 1, 1, world.material(broken)));
  const SceneLamps alone = world.lamps();
  ASSERT_EQ(alone.lamps.size(), 1u);  // beside it the screen is dim
  EXPECT_EQ(alone.lamps[0].node, "sun");
  EXPECT_NEAR(alone.lamps[0].power, kPi * 100.0, 1e-3);
  world.scene.materials["hot"].emissive = vec3(0.0f);  // an override is followed
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 1u);
  EXPECT_EQ(found.lamps[0].node, "screen");
  EXPECT_NEAR(found.lamps[0].radiance.x, 6.0 * 0.5, 1e-6);
  EXPECT_EQ(found.lamps[0].radiance.y, 0.0);
  EXPECT_NEAR(found.lamps[0].radiance.z, 2.0 * 0.5 * (1.0 + 0.5029), 2e-3);  // sRGB 188 is half the light
  EXPECT_THAT(found.remarks,
              ElementsAre(HasSubstr("objects.screen: the lamp shines evenly, by the mean of its texture")));
}

TEST(SceneLamps, ALightSourceAtALampsPlaceIsCountedOnce) {
  World world;
  world.add("panel", panel(2, 1, world.material(shining("lamp", vec3(7.0f)))));
  world.add("other",
            grid({-1.8f, 2.5f, -1}, {0.3f, 0, 0}, {0, 0, 0.4f}, 1, 1, world.material(shining("lamp 2", vec3(7.0f)))));
  Light sun, below, far;
  below.type = LightType::Point;
  below.position = {0.3, 2.2, 0.1};
  far.type = LightType::Spot;
  far.position = {0.3, 0.8, 0.1};
  world.scene.lights = {sun, far, below};
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 2u);
  EXPECT_EQ(found.lamps[0].node, "panel");
  EXPECT_EQ(found.lamps[0].light, std::optional<std::size_t>(2));
  EXPECT_FALSE(found.lamps[1].light.has_value());
  EXPECT_THAT(found.remarks, ElementsAre(HasSubstr("lights[2]: stands at the place of the lamp panel")));
}

// A lamp's light in all is pi times radiance and area; a point light's, 4 pi times its intensity.
TEST(SceneLamps, ALightTenTimesAsStrongAsTheLampStandsForItself) {
  World world;
  world.add("panel", panel(2, 1, world.material(shining("lamp", vec3(7.0f)))));
  const double area = world.lamps().lamps.at(0).area;
  Light below;
  below.type = LightType::Point;
  below.position = {0.3, 2.2, 0.1};
  below.color = {0.9f, 0.6f, 0.3f};
  for (const auto& [times, counted] : {std::pair(9.5, true), std::pair(10.5, false)}) {
    below.intensity = static_cast<float>(times * 7.0 * area / (4.0 * 0.6));
    world.scene.lights = {below};
    EXPECT_EQ(world.lamps().lamps.at(0).light.has_value(), counted) << times;
  }
}

TEST(SceneLamps, FacesTurnedOverShineTheOtherWay) {
  World world;
  const int lamp = world.material(shining("lamp", vec3(7.0f)));
  Mesh over = panel(2, 3, lamp);
  for (std::size_t i = 0; i + 2 < over.indices.size(); i += 3) std::swap(over.indices[i], over.indices[i + 1]);
  world.add("panel", over);
  SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 1u);
  EXPECT_NEAR(found.lamps[0].normal.y, 1.0, 1e-9);
  LampPolygon polygon = lampPolygon(found.lamps[0], dvec3(0.0));
  EXPECT_EQ(shading::lampDiffuse(&polygon, vec3(0.2f, 0.1f, 0.0f), vec3(0, 1, 0)), 0.0f);
  EXPECT_GT(shading::lampDiffuse(&polygon, vec3(0.2f, 2.58f, 0.0f), vec3(0, -1, 0)), 0.5f);
  // A double-sided material, or both sides as triangles, shine both ways.
  world.model.materials[static_cast<std::size_t>(lamp)].doubleSided = true;
  found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 1u);
  EXPECT_TRUE(found.lamps[0].bothSides);
  EXPECT_NEAR(found.lamps[0].power, 2 * kPi * 7.0 * 1.3 * 0.7, 1e-4);
  world.model.materials[static_cast<std::size_t>(lamp)].doubleSided = false;
  world.add("panel's front", panel(2, 3, lamp));
  EXPECT_EQ(world.lamps().lamps.size(), 2u);
}

TEST(SceneLamps, LampsLieWhereTheSceneTurnsAndMovesThem) {
  World world;
  world.add("panel", panel(1, 1, world.material(shining("lamp", vec3(7.0f)))),
            glm::translate(glm::dmat4(1.0), dvec3(0.2, -0.4, 0.1)));
  world.scene.models[0].rotationDegrees = {0, 90, 0};
  world.scene.models[0].scale = 2.0;
  world.scene.objects["panel"].translation = {0, 0.5, 0};
  const SceneLamps found = world.lamps();
  ASSERT_EQ(found.lamps.size(), 1u);
  const dvec3 local = dvec3(0.25 + 0.2, 2.5 - 0.4, 0.05 + 0.1) * 2.0;
  EXPECT_NEAR(glm::length(found.lamps[0].middle - dvec3(local.z, local.y + 0.5, -local.x)), 0.0, 1e-6);
  EXPECT_NEAR(found.lamps[0].area, 4.0 * 1.3 * 0.7, 1e-5);
  // In a frame of its own: the same distances.
  const glm::dmat3 turned = rotationMatrix({20, 30, -50});
  const LampPolygon polygon = lampPolygon(found.lamps[0], dvec3(1, 2, 3), turned);
  for (int i = 0; i < 4; ++i) {
    const auto k = static_cast<std::size_t>(i);
    EXPECT_NEAR(glm::length(turned * dvec3(polygon.corners[k]) + dvec3(1, 2, 3) - found.lamps[0].corners[k]), 0.0,
                1e-6);
  }
  world.scene.objects["panel"].dynamic = true;  // baked probes do not see it
  EXPECT_TRUE(world.lamps().lamps.empty());
}

// What the program's own rooms are lit by.
TEST(SceneLamps, OfTheScenesThatComeWithTheProgram) {
  for (const char* name : {"room", "furnished", "gallery"}) {
    const Scene scene = loadSceneFile(std::string(BOXPROBE_DATA_DIR "/scenes/") + name + ".boxprobe.json");
    std::vector<std::shared_ptr<const Model>> models;
    for (const ModelFile& file : scene.models)
      models.push_back(std::make_shared<const Model>(loadModelFile(file.file)));
    const SceneLamps found = sceneLamps(scene, models);
    std::printf("  %s\n", name);
    for (const SceneLamp& lamp : found.lamps) {
      std::printf("    %s: %zu corners, %.3f m2, radiance %.2f %.2f %.2f, power %.2f, %s%s\n", lamp.node.c_str(),
                  lamp.corners.size(), lamp.area, lamp.radiance.x, lamp.radiance.y, lamp.radiance.z, lamp.power,
                  lamp.bothSides ? "both sides" : "one side", lamp.light ? ", with a light source" : "");
    }
    for (const std::string& remark : found.remarks) std::printf("    %s\n", remark.c_str());
    ASSERT_FALSE(found.lamps.empty()) << name;
    for (const SceneLamp& lamp : found.lamps) EXPECT_EQ(lamp.corners.size(), 4u) << name << " " << lamp.node;
    EXPECT_FALSE(probeLamps(found.lamps, scene.probes[0]).empty()) << name;
  }
}

}  // namespace
