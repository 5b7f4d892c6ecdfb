// Diffuse light drawn from lamps as shapes and a lattice (`"lamps": "shapes"`), against quadrature over the walls and
// the lamp of a room: long double, of tests/support/lamp_truth.
#include <gtest/gtest.h>
#include <vtkLightCollection.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <set>
#include <string>

#include "tests/image/quad_world.h"
#include "tests/support/lamp_truth.h"

namespace boxprobe::test {
namespace {

using glm::dvec3;
using glm::vec3;

const vec3 kLow(-2.0f, 0.0f, -1.6f), kHigh(2.4f, 2.7f, 1.9f);
const vec3 kAlbedo(0.7f, 0.5f, 0.3f);

struct Panel {
  const char* name;
  vec3 center, right, up;  // half sides; faces along cross(right, up)
  vec3 radiance;
};

// Dim walls, and a lamp that hangs 5 cm below the ceiling and shines down.
std::vector<Panel> panels() {
  const vec3 c = 0.5f * (kLow + kHigh), h = 0.5f * (kHigh - kLow);
  return {{"west", {kLow.x, c.y, c.z}, {0, 0, -h.z}, {0, h.y, 0}, {0.30f, 0.10f, 0.05f}},
          {"east", {kHigh.x, c.y, c.z}, {0, 0, h.z}, {0, h.y, 0}, {0.05f, 0.22f, 0.08f}},
          {"north", {c.x, c.y, kLow.z}, {h.x, 0, 0}, {0, h.y, 0}, {0.12f, 0.14f, 0.31f}},
          {"south", {c.x, c.y, kHigh.z}, {-h.x, 0, 0}, {0, h.y, 0}, {0.21f, 0.18f, 0.02f}},
          {"ceiling", {c.x, kHigh.y, c.z}, {h.x, 0, 0}, {0, 0, h.z}, {0.09f, 0.07f, 0.11f}},
          {"lamp", {-0.6f, kHigh.y - 0.05f, 0.4f}, {0.35f, 0, 0}, {0, 0, 0.22f}, {30.0f, 24.0f, 17.0f}}};
}

Model room(float unit = 1.0f) {
  Model model;
  for (const Panel& p : panels()) {
    Material material = glowing(p.radiance);
    material.doubleSided = false;
    addSquare(model, p.name, unit * p.center, unit * p.right, unit * p.up, material);
  }
  Material floor;
  floor.baseColor = glm::vec4(kAlbedo, 1.0f);
  floor.metallic = 0.0f;
  floor.roughness = 1.0f;
  floor.ior = 1.0f;  // reflects nothing of its own
  const vec3 c = 0.5f * (kLow + kHigh), h = 0.5f * (kHigh - kLow);
  addSquare(model, "floor", unit * vec3(c.x, kLow.y, c.z), {unit * h.x, 0, 0}, {0, 0, -unit * h.z}, floor);
  return model;
}

Scene scene(LampForm form) {
  Scene scene = darkScene();
  scene.lamps = form;
  Probe probe;
  probe.name = "room";
  probe.origin = {0.5, 1.1, -0.3};
  probe.box = {dvec3(kLow), dvec3(kHigh)};
  probe.blendDistance = {dvec3(0.0), dvec3(0.0)};
  probe.faceSize = 128;
  scene.probes = {probe};
  return scene;
}

// Light that a Lambert floor sends up from a point; the lamp hides its part of the ceiling.
dvec3 truth(const dvec3& point, const dvec3& lampMoved = dvec3(0.0)) {
  dvec3 sum(0.0), ceiling(0.0);
  for (const Panel& p : panels()) {
    const bool lamp = std::string(p.name) == "lamp";
    std::vector<LongVec> corners;
    for (const vec3& corner :
         {p.center - p.right - p.up, p.center + p.right - p.up, p.center + p.right + p.up, p.center - p.right + p.up}) {
      corners.emplace_back(dvec3(corner) + (lamp ? lampMoved : dvec3(0.0)) - point);
    }
    const auto share = static_cast<double>(trueFormFactor(corners, LongVec(0.0L, 1.0L, 0.0L)));
    if (std::string(p.name) == "ceiling") ceiling = dvec3(p.radiance);
    sum += share * (dvec3(p.radiance) - (lamp ? ceiling : dvec3(0.0)));
  }
  return dvec3(kAlbedo) * sum;
}

const dvec3 kPoints[] = {{-0.5, 0, 0.3}, {0.4, 0, -0.6}, {1.7, 0, 1.1},
                         {2.2, 0, -1.4}, {-1.8, 0, 1.7}, {-1.1, 0, -0.9}};

dvec3 seen(QuadWorld& world, const dvec3& point) {
  return dvec3(world.look(point + dvec3(0.02, 1.2, 0.01), point, {0.0, 0.0, -1.0}));
}

TEST(ShapesPicture, AFloorIsLitAsItsWallsAndItsLampLightIt) {
  QuadWorld before(scene(LampForm::InMap), {room()}), world(scene(LampForm::Shapes), {room()});
  before.show();
  world.show();
  double worst = 0.0;
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point), drawn = seen(world, point), inMap = seen(before, point);
    std::printf("  (%.1f, %.1f): truth %.3f %.3f %.3f, shapes %.3f %.3f %.3f, in-map %.3f %.3f %.3f\n", point.x,
                point.z, t.x, t.y, t.z, drawn.x, drawn.y, drawn.z, inMap.x, inMap.y, inMap.z);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03) << point.x << " " << point.z;
    worst = std::max(worst, std::abs(inMap.x / t.x - 1.0));
  }
  EXPECT_GT(worst, 0.4);  // what it mends
}

TEST(ShapesPicture, AnExplanationHasTheSameLight) {
  QuadWorld world(scene(LampForm::Shapes), {room()}, 64, 48);
  world.show();
  Camera camera;
  camera.position = {1.2, 1.5, 1.4};
  camera.target = {-0.4, 0.0, -0.2};
  world.renderer->applyCamera(camera);
  int floors = 0;
  for (const glm::ivec2& pixel : {glm::ivec2(20, 10), glm::ivec2(33, 21), glm::ivec2(50, 7), glm::ivec2(8, 18)}) {
    const Explanation e = world.renderer->explain(pixel.x, pixel.y, 64, 48);
    if (e.surface.object != "floor") continue;
    ++floors;
    ASSERT_TRUE(e.rendered.has_value());
    EXPECT_LT(glm::length(e.color - *e.rendered), 2.0e-3f * (1.0f + glm::length(*e.rendered))) << pixel.x;
  }
  EXPECT_GE(floors, 2);
}

// A moved lamp, a box that is dragged, and back again: the picture follows.
TEST(ShapesPicture, EditsAreFollowed) {
  QuadWorld world(scene(LampForm::Shapes), {room()});
  world.show();
  const dvec3 point = kPoints[1], first = seen(world, point), moved(0.9, -0.4, -0.5);
  world.editAndFinish([&](Scene& s) { s.objects["lamp"].translation = moved; });
  const dvec3 t = truth(point, moved), drawn = seen(world, point);
  EXPECT_GT(drawn.x, 1.2 * first.x);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03);
  world.editAndFinish([&](Scene& s) {
    s.objects.clear();
    s.materials["lamp"].emissive = vec3(0.0f);
  });
  const dvec3 dark = seen(world, point);
  EXPECT_LT(dark.x, 0.5 * first.x);
  world.editAndFinish([&](Scene& s) { s.materials.clear(); });
  EXPECT_NEAR(seen(world, point).x, first.x, 1e-4 * first.x);
  world.editAndFinish([&](Scene& s) { s.probes[0].box.max.x += 3.0; });  // walls are farther away, and darker the light
  EXPECT_NE(seen(world, point).x, first.x);
  world.editAndFinish([&](Scene& s) { s.probes[0].box.max.x -= 3.0; });
  EXPECT_NEAR(seen(world, point).x, first.x, 1e-4 * first.x);
  const std::uint64_t faces = world.faces() + world.reused();
  world.editAndFinish([&](Scene& s) { s.lamps = LampForm::InMap; });
  EXPECT_EQ(world.faces() + world.reused(), faces + 6);  // the floor in it is lit otherwise: as by the unlit lamp
  EXPECT_GT(std::abs(seen(world, point).x / first.x - 1.0), 0.1);
}

// The same box, turned a quarter with its sides exchanged, and captured along its own axes.
TEST(ShapesPicture, ATurnedBoxGivesTheSameLight) {
  QuadWorld world(scene(LampForm::Shapes), {room()});
  Probe& probe = world.scene.probes[0];
  const dvec3 center = probe.box.center(), half = 0.5 * probe.box.size();
  probe.rotationDegrees = {0, 90, 0};
  probe.box = {center - dvec3(half.z, half.y, half.x), center + dvec3(half.z, half.y, half.x)};
  world.show();
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point), drawn = seen(world, point);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03) << point.x << " " << point.z;
  }
}

// An explanation names the lamp and the nodes, and what they give adds up.
TEST(ShapesPicture, AnExplanationNamesLampsAndNodes) {
  QuadWorld world(scene(LampForm::Shapes), {room()}, 64, 48);
  world.show();
  Camera camera;
  camera.position = {1.2, 1.5, 1.4};
  camera.target = {-0.4, 0.0, -0.2};
  world.renderer->applyCamera(camera);
  const Explanation e = world.renderer->explain(33, 21, 64, 48);
  ASSERT_EQ(e.surface.object, "floor");
  const DiffuseExplanation& diffuse = e.probes.at(0).diffuse;
  ASSERT_EQ(diffuse.lamps.size(), 1u);
  EXPECT_EQ(diffuse.lamps[0].node, "lamp");
  EXPECT_EQ(diffuse.nodeCount, glm::ivec3(5, 4, 5));  // 4.4 x 2.7 x 3.5 m
  float weights = 0.0f;
  dvec3 place(0.0);
  for (const LatticeNodeAtPoint& node : diffuse.nodes) {
    weights += node.weight;
    place += static_cast<double>(node.weight) * dvec3(node.positionProbe);
  }
  EXPECT_NEAR(weights, 1.0f, 1e-5f);
  // The floor lies below the lowest nodes, which are 15 cm above it; along the other axes the nodes' mean is the point.
  EXPECT_NEAR(place.x, static_cast<double>(e.probes[0].positionProbe.x), 1e-3);
  EXPECT_NEAR(place.y, 0.15 - 1.1, 1e-3);
  EXPECT_NEAR(place.z, static_cast<double>(e.probes[0].positionProbe.z), 1e-3);
  const dvec3 sum = dvec3(diffuse.lamps[0].light) + dvec3(diffuse.lattice), point(e.surface.positionWorld);
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(kAlbedo[c] * sum[c] / truth(point)[c], 1.0, 0.03);
}

// Nodes as close as the scene asks for; none: the whole map's light, as in-map; and back again.
TEST(ShapesPicture, NodesStandAsTheSceneHasThem) {
  QuadWorld before(scene(LampForm::InMap), {room()}), world(scene(LampForm::Shapes), {room()}, 64, 48);
  before.show();
  world.show();
  Camera camera;
  camera.position = {1.2, 1.5, 1.4};
  camera.target = {-0.4, 0.0, -0.2};
  const auto nodes = [&] {
    world.renderer->applyCamera(camera);
    return world.renderer->explain(33, 21, 64, 48).probes.at(0).diffuse.nodeCount;
  };
  for (const double spacing : {0.5, 1.7, 0.01}) {
    world.edit([&](Scene& s) { s.probes[0].lattice = ProbeLattice{true, spacing}; });
    glm::ivec3 expected;  // of 4.4 x 2.7 x 3.5 m
    for (int axis = 0; axis < 3; ++axis) {
      const double steps = static_cast<double>(kHigh[axis] - kLow[axis]) / spacing;
      expected[axis] = static_cast<int>(std::clamp(std::round(steps) + 1.0, 2.0, 16.0));
    }
    EXPECT_EQ(nodes(), expected) << spacing;
    for (const dvec3& point : kPoints) {
      const dvec3 t = truth(point), drawn = seen(world, point);
      for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03) << spacing << ", " << point.x;
    }
  }
  // Without the floor, which lamps as shapes light in a first capture, both capture the same.
  before.editAndFinish([](Scene& s) { s.probes[0].hides = {"floor"}; });
  world.editAndFinish([](Scene& s) {
    s.probes[0].hides = {"floor"};
    s.probes[0].lattice = ProbeLattice{false};
  });
  EXPECT_EQ(nodes(), glm::ivec3(0));
  for (const dvec3& point : kPoints) {
    const dvec3 inMap = seen(before, point), drawn = seen(world, point);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / inMap[c], 1.0, 1.0e-4) << point.x << " " << point.z;
  }
  world.edit([](Scene& s) { s.probes[0].lattice.reset(); });
  EXPECT_EQ(nodes(), glm::ivec3(5, 4, 5));
}

// In scene units, whatever the lattice takes the room's for.
TEST(ShapesPicture, NodesOfARoomInMillimetres) {
  Scene large = scene(LampForm::Shapes);
  Probe& probe = large.probes[0];
  probe.origin *= 1000.0;
  probe.box = {1000.0 * probe.box.min, 1000.0 * probe.box.max};
  probe.farDistance = 1.0e5;
  probe.lattice = ProbeLattice{true, 500.0};
  QuadWorld world(large, {room(1000.0f)}, 64, 48);
  world.show();
  Camera camera;
  camera.position = {1200.0, 1500.0, 1400.0};
  camera.target = {-400.0, 0.0, -200.0};
  world.renderer->applyCamera(camera);
  EXPECT_EQ(world.renderer->explain(33, 21, 64, 48).probes.at(0).diffuse.nodeCount, glm::ivec3(10, 6, 8));
}

// A light at the lamp's place is counted once: by the lamp's shape, or without nodes by itself.
TEST(ShapesPicture, ALightAtALampIsDrawnWhereThereAreNoNodes) {
  Scene lit = scene(LampForm::Shapes);
  Light light;
  light.type = LightType::Point;
  light.position = {-0.6, 2.6, 0.4};
  light.intensity = 7.0f;
  QuadWorld dark(lit, {room()});
  dark.edit([](Scene& s) { s.probes[0].lattice = ProbeLattice{false}; });
  lit.lights = {light};
  QuadWorld world(lit, {room()});
  dark.show();
  world.show();
  const dvec3 below(-0.6, 0.0, 0.4);
  const double shape = seen(world, below).y;
  world.edit([](Scene& s) { s.probes[0].lattice = ProbeLattice{false}; });
  EXPECT_GT(seen(world, below).y, 1.5 * seen(dark, below).y);
  world.edit([](Scene& s) { s.probes[0].lattice.reset(); });
  EXPECT_NEAR(seen(world, below).y / shape, 1.0, 1.0e-3);
}

TEST(ShapesPicture, AnEditOfWhatDoesNotShineLeavesLightsAlone) {
  Scene lit = scene(LampForm::Shapes);
  Light light;
  light.type = LightType::Point;
  light.position = {-0.6, 2.6, 0.4};  // at the lamp's place
  light.intensity = 7.0f;
  lit.lights = {light};
  QuadWorld world(lit, {room()});
  world.show();
  const auto first = [&] { return world.renderer->renderer()->GetLights()->GetItemAsObject(0); };
  const vtkSmartPointer<vtkObject> before = first();
  world.edit([](Scene& s) { s.materials["floor"].roughness = 0.6f; });
  world.edit([](Scene& s) { s.materials["floor"].baseColor = glm::vec3(0.2f, 0.4f, 0.3f); });
  world.edit([](Scene& s) { s.objects["west"].translation = dvec3(0.0, 0.1, 0.0); });
  EXPECT_NE(first(), before.GetPointer()) << "a wall that glows may be a lamp";
  const vtkSmartPointer<vtkObject> moved = first();
  world.edit([](Scene& s) { s.objects["floor"].translation = dvec3(0.0, -0.1, 0.0); });
  EXPECT_EQ(first(), moved.GetPointer());
  world.edit([](Scene& s) { s.materials["lamp"].emissive = vec3(20.0f, 21.0f, 22.0f); });
  EXPECT_NE(first(), moved.GetPointer());
}

// A light source in a lamp's place gives way to the lamp, but only where a probe draws that.
TEST(ShapesPicture, ALightAtALampShinesWhereNoProbeDrawsTheLamp) {
  const auto lit = [](LampForm form, bool withProbe) {
    Scene made = scene(form);
    Light light;
    light.type = LightType::Point;
    light.position = {-0.6, 2.6, 0.4};
    light.intensity = 7.0f;
    made.lights = {light};
    if (!withProbe) made.probes.clear();
    return made;
  };
  QuadWorld without(lit(LampForm::InMap, false), {room()}), world(lit(LampForm::Shapes, true), {room()});
  QuadWorld alone(scene(LampForm::Shapes), {room()});
  without.show();
  world.show();
  alone.show();
  const dvec3 point = kPoints[1], byLight = seen(without, point), byLamp = seen(alone, point);
  ASSERT_GT(std::abs(byLight.x / byLamp.x - 1.0), 0.05) << "to tell them apart";
  EXPECT_NEAR(seen(world, point).x, byLamp.x, 1e-4 * byLamp.x) << "once, not twice";
  world.renderer->setProbesEnabled(false);
  EXPECT_NEAR(seen(world, point).x, byLight.x, 1e-4 * byLight.x);
  world.renderer->setProbesEnabled(true);
  world.renderer->finishWork();
  EXPECT_NEAR(seen(world, point).x, byLamp.x, 1e-4 * byLamp.x);
  const std::vector<Probe> probes = world.scene.probes;
  world.editAndFinish([](Scene& s) { s.probes.clear(); });
  EXPECT_NEAR(seen(world, point).x, byLight.x, 1e-4 * byLight.x);
  world.editAndFinish([&](Scene& s) {
    s.probes = probes;  // a box that the lamp is not in
    s.probes[0].box.min.y -= 9.0;
    s.probes[0].box.max.y -= 9.0;
    s.probes[0].origin.y -= 9.0;
  });
  EXPECT_NEAR(seen(world, point).x, byLight.x, 1e-4 * byLight.x);
  world.editAndFinish([&](Scene& s) { s.probes = probes; });
  EXPECT_NEAR(seen(world, point).x, byLamp.x, 1e-4 * byLamp.x);
}

// Without any lamp the first bounce is the same in both forms, and the second is not: its floor is lit by probes.
TEST(ShapesPicture, LaterBouncesAreLitByLattices) {
  QuadWorld world(scene(LampForm::Shapes), {room()});
  world.scene.materials["lamp"].emissive = vec3(0.2f);
  world.scene.probes[0].bounces = 2;
  world.show();
  const std::uint64_t faces = world.faces() + world.reused();
  EXPECT_EQ(faces, 12u);
  world.editAndFinish([](Scene& s) { s.lamps = LampForm::InMap; });
  EXPECT_EQ(world.faces() + world.reused(), faces + 6);
}

// What a window does: a frame does not wait, and the one after the work has the lattice.
TEST(ShapesPicture, AFrameDoesNotWaitForALattice) {
  QuadWorld plain(scene(LampForm::Shapes), {room()}, 48, 40), window(scene(LampForm::Shapes), {room()}, 48, 40);
  window.renderer->setEditable(true);
  Camera camera;
  camera.position = {1.2, 1.5, 1.4};
  camera.target = {-0.4, 0.0, -0.2};
  for (QuadWorld* world : {&plain, &window}) {
    world->renderer->applyCamera(camera);
    world->show();
  }
  const ImageRgba8 right = plain.renderer->renderDisplay(), early = window.renderer->renderDisplay();
  EXPECT_NE(early.pixels, right.pixels) << "coefficients show";
  EXPECT_TRUE(window.renderer->workPending());
  window.renderer->finishWork();
  EXPECT_EQ(window.renderer->renderDisplay().pixels, right.pixels);
  EXPECT_FALSE(window.renderer->workPending());
  // Another box is lit by the lattice of the one before, until its own is there.
  for (QuadWorld* world : {&plain, &window}) world->edit([](Scene& s) { s.probes[0].box.max.x += 2.5; });
  plain.renderer->finishWork();
  const ImageRgba8 wider = plain.renderer->renderDisplay(), between = window.renderer->renderDisplay();
  EXPECT_NE(wider.pixels, right.pixels);
  EXPECT_EQ(between.pixels, right.pixels);
  window.renderer->finishWork();
  EXPECT_EQ(window.renderer->renderDisplay().pixels, wider.pixels);
}

// Faces of a lamp that is a box are worked out in pairs; an explanation takes each by itself.
TEST(ShapesPicture, ABoxOfALampShinesFromAllItsFaces) {
  Model model = room();
  const vec3 center(0.9f, 1.4f, 0.5f);
  const float h = 0.15f;
  const vec3 axes[3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (int axis = 0; axis < 3; ++axis) {
    for (const float side : {1.0f, -1.0f}) {
      const vec3 n = side * axes[axis], up = axes[(axis + 1) % 3];
      Material material = glowing(vec3(9.0f + static_cast<float>(axis), 8.0f - 2.0f * side, 7.0f));
      material.doubleSided = false;
      addSquare(model, "cube" + std::to_string(2 * axis + (side > 0.0f ? 1 : 0)), center + h * n, h * glm::cross(up, n),
                h * up, material);
    }
  }
  QuadWorld world(scene(LampForm::Shapes), {model}, 64, 48);
  world.show();
  Camera camera;
  camera.position = {-1.2, 2.2, -1.4};
  camera.target = {0.4, 0.0, 0.2};
  world.renderer->applyCamera(camera);
  std::set<std::string> shining;
  for (const glm::ivec2& pixel : {glm::ivec2(30, 24), glm::ivec2(14, 35), glm::ivec2(50, 30), glm::ivec2(32, 44)}) {
    const Explanation e = world.renderer->explain(pixel.x, pixel.y, 64, 48);
    ASSERT_EQ(e.surface.object, "floor") << pixel.x;
    for (const LampAtPoint& lamp : e.probes.at(0).diffuse.lamps) shining.insert(lamp.node);
    EXPECT_LT(glm::length(e.color - *e.rendered), 2.0e-3f * (1.0f + glm::length(*e.rendered))) << pixel.x;
  }
  EXPECT_GE(shining.size(), 4u);
}

TEST(ShapesPicture, ARealtimeProbeHasFewerRaysAndTheSameLight) {
  QuadWorld world(scene(LampForm::Shapes), {room()});
  world.scene.probes[0].mode = ProbeMode::Realtime;
  world.show();
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point), drawn = seen(world, point);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.05) << point.x << " " << point.z;
  }
}

// A sky in the colour of the ceiling, and no ceiling.
TEST(ShapesPicture, TheSkyShinesThroughOpenings) {
  Model open = room();
  open.instances.erase(std::remove_if(open.instances.begin(), open.instances.end(),
                                      [](const Instance& instance) { return instance.node == "ceiling"; }),
                       open.instances.end());
  Scene outside = scene(LampForm::Shapes);
  outside.sky = SkyColor{panels()[4].radiance};
  outside.probes[0].clear = ClearToOpen{};
  QuadWorld world(outside, {open});
  world.show();
  for (const dvec3& point : kPoints) {
    const dvec3 t = truth(point), drawn = seen(world, point);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(drawn[c] / t[c], 1.0, 0.03) << point.x << " " << point.z;
  }
  const dvec3 point = kPoints[2], first = seen(world, point);
  world.editAndFinish([](Scene& s) { s.sky = SkyColor{{2.0f, 1.0f, 0.5f}}; });
  EXPECT_GT(seen(world, point).x, first.x + 0.3);
}

// No lamp, one of a million, one around the probe: finite light, and of the last what its inside sends.
TEST(ShapesPicture, OddLampsGiveFiniteLight) {
  const dvec3 point = kPoints[1];
  QuadWorld world(scene(LampForm::Shapes), {room()});
  world.show();
  const dvec3 usual = seen(world, point);
  world.editAndFinish([](Scene& s) { s.materials["lamp"].emissive = vec3(0.0f); });
  const dvec3 unlit = seen(world, point);
  world.editAndFinish([](Scene& s) { s.materials["lamp"].emissive = vec3(1.0e6f); });
  // The capture's half floats end at 65504; the lamp is drawn from its shape.
  EXPECT_NEAR(seen(world, point).x / (1.0e6 / 30.0 * (usual.x - unlit.x)), 1.0, 0.02);
  world.editAndFinish([](Scene& s) {
    for (const Panel& panel : panels()) s.materials[panel.name].emissive = vec3(0.0f);
  });
  EXPECT_EQ(seen(world, point), dvec3(0.0));
}

TEST(ShapesPicture, AProbeInsideALampShowsWhatIsThere) {
  Model model = room();
  Material material = glowing(vec3(9.0f, 8.0f, 7.0f));
  const vec3 center(0.5f, 1.1f, -0.3f);
  const float h = 0.2f;
  for (const vec3& n : {vec3(1, 0, 0), vec3(-1, 0, 0), vec3(0, 1, 0), vec3(0, -1, 0), vec3(0, 0, 1), vec3(0, 0, -1)}) {
    const vec3 up(n.y, n.z, n.x);
    addSquare(model, "cube" + std::to_string(model.instances.size()), center + h * n, h * glm::cross(up, n), h * up,
              material);
  }
  QuadWorld world(scene(LampForm::Shapes), {model});
  world.show();
  for (const dvec3& at : kPoints) {
    const dvec3 drawn = seen(world, at);
    for (int c = 0; c < 3; ++c) EXPECT_TRUE(std::isfinite(drawn[c]) && drawn[c] > 0.0 && drawn[c] < 10.0) << drawn[c];
  }
}

}  // namespace
}  // namespace boxprobe::test
