// Each case asks for something of its own; together, for everything that a pixel can have.
#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "tests/unit/explained_hall.h"

namespace boxprobe::test {

namespace {

void finish(HallPixel& p) {
  PointFinish finish;
  finish.f0 = {0.07f, 0.05f, 0.03f};
  finish.edge = 0.8f;
  finish.tinted = true;
  finish.sheenColor = {0.3f, 0.25f, 0.15f};
  finish.sheenRoughness = 0.45f;
  finish.acrossWorld = glm::normalize(glm::vec3(0.9f, -0.05f, 0.4f));
  finish.anisotropy = 0.6f;
  p.in.surface.finish = finish;
}

void film(HallPixel& p) {
  PointFinish finish;
  finish.iridescence = 0.7f;
  finish.filmIor = 1.4f;
  finish.filmThickness = 330.0f;
  p.in.surface.finish = finish;
}

void coat(HallPixel& p) {
  p.in.surface.coatStrength = 0.8f;
  p.in.surface.coatRoughness = 0.12f;
  p.in.surface.coatF0 = 0.045f;
  p.in.surface.coatNormalWorld = glm::normalize(glm::vec3(-0.03f, 0.97f, 0.07f));
}

Light light(LightType type, const glm::dvec3& position, const glm::dvec3& direction) {
  Light l;
  l.type = type;
  l.position = position;
  l.direction = direction;
  l.color = {0.9f, 0.7f, 0.6f};
  l.intensity = 2.3f;
  l.innerConeDegrees = 11.0;
  l.outerConeDegrees = 47.0;
  l.radius = 0.07;
  l.angleDegrees = 3.1;
  l.shadows = LightShadows::Coverage;
  return l;
}

void lights(HallPixel& p) {
  p.in.lights = {light(LightType::Point, {1.6, 2.2, -0.4}, {0.0, -1.0, 0.0}),
                 light(LightType::Spot, {-0.4, 3.6, 1.7}, {0.3, -1.0, -0.35}),
                 light(LightType::Directional, {}, {-0.4, -1.0, 0.3}),
                 light(LightType::Point, {0.9, -2.0, 0.1}, {0.0, -1.0, 0.0})};
  p.in.lights[0].range = 9.0;
}

MovingMap movingMap(int index) {
  MovingMap map;
  map.light = index;
  map.size = 6;
  std::vector<float> depth;
  for (int i = 0; i < 36; ++i) depth.push_back(0.2f + 0.02f * static_cast<float>(i * 17 % 36));
  map.depth = std::make_shared<const std::vector<float>>(depth);
  map.mapFromWorld =
      glm::dmat4(0.21, 0.03, 0.02, 0.01, 0.02, 0.05, 0.23, 0.02, 0.04, 0.19, 0.01, 0.03, 0.31, 0.36, 0.44, 1.0);
  map.apart = {0.11, 0.07};
  map.off = 0.05;
  if (index == 1) map.mapFromWorld[3].w = -2.0;  // behind it
  return map;
}

void shadows(HallPixel& p) {
  lights(p);
  p.in.shadowLights = {0, 1, 2, 3};
  for (ExplainedProbe& probe : p.in.probes) probe.coverage = &hallMaps().through;
  p.in.probes[0].shadowLights = 0xf;
  p.in.probes[1].shadowLights = 0x6;
  p.in.lights[1].shadowLevel = ShadowLevel::Distance;
  p.in.lights[2].shadowLevel = ShadowLevel::Distance;
  p.in.lights[2].levelsPerUnit = 0.63;
}

void mirror(HallPixel& p) {
  p.in.mirror = &p.mirror;
  shading::MirrorLook& look = p.mirror;
  look.toU = {0.13f, 0.02f, 0.03f, 0.41f};
  look.toV = {0.01f, 0.04f, 0.15f, 0.57f};
  look.toW = {0.02f, -0.11f, 0.03f, 1.0f};
  look.normal = {0.0f, 1.0f, 0.0f};
  look.farHeight = 1.7f;
  look.eye = {0.1f, -2.9f, 0.2f};
  look.texelSize = 0.021f;
  look.maxLevel = 4.0f;
  look.sizeX = 16.0f;
  look.sizeY = 8.0f;
  look.sharpLevel = 0.4f;
  look.picture = &hallMaps().mirror;
}

void sky(HallPixel& p) {
  p.in.surface.positionWorld = {3.3, 0.2, 0.9};
  p.seeFrom({1.6, 1.5, 2.9});
}

void technique(HallPixel& p, const char* id) {
  p.probe(0).technique = id;
  p.probe(1).technique = id;
}

void glass(HallPixel& p, const char* form, int number, bool back) {
  p.useGlass(form, number, back);
  p.in.surface.metallic = 0.05f;
}

}  // namespace

const std::vector<HallCase>& hallCases() {
  static const std::vector<HallCase> cases = {
      {"two probes and the sky", [](HallPixel&) {}},
      {"a smooth metal seen flat",
       [](HallPixel& p) {
         p.in.surface.metallic = 1.0f;
         p.in.surface.roughness = 0.03f;
         p.in.diffuse = false;
         p.in.energy = Energy::Multiple;
         p.seeFrom({-2.0, 0.7, 2.4});
       }},
      {"rounded edges, occlusion, maps along the box",
       [](HallPixel& p) {
         p.probe(0).bevel = Bevel{0.21, 0.34};
         p.probe(0).occlusion = BoxOcclusion{0.63, 0.41, 0.82};
         p.probe(1).occlusion = BoxOcclusion{0.31, 0.71, 0.92};
         p.capturedRotation = p.probe(1).rotationDegrees;
         p.seeFrom({-1.2, 1.6, -0.9});
       }},
      {"the sky shows through along R",
       [](HallPixel& p) {
         p.in.probes[0].maps = &hallMaps().open;
         p.in.probes[0].open = true;
         p.in.probes[0].openSky = hallMaps().cupboard.irradiance;
         p.probe(0).occlusion = BoxOcclusion{0.63, 0.41, 0.82};
       }},
      {"the sky shows through by lookups",
       [](HallPixel& p) {
         for (std::size_t i = 0; i < 2; ++i) {
           p.in.probes[i].maps = &hallMaps().open;
           p.in.probes[i].open = true;
           p.probe(i).occlusion = BoxOcclusion{0.63, 0.41, 0.82};
         }
         technique(p, "footprint4");
         p.seeFrom({-0.3, 1.9, -1.1});
       }},
      {"lamps as shapes, rough", [](HallPixel& p) { p.useLamps(true); }},
      {"lamps as shapes, nearly smooth",
       [](HallPixel& p) {
         p.useLamps(true);
         p.in.probes[0].lattice = hallMaps().cutLattice;
         p.in.surface.roughness = 0.15f;
         p.seeFrom({1.1, 1.2, 2.3});
         mirror(p);
       }},
      {"lamps as shapes in glossy light alone",
       [](HallPixel& p) {
         p.useLamps(false);
         p.in.surface.metallic = 1.0f;
         p.in.surface.roughness = 0.6f;
       }},
      {"lights that a sight shadows",
       [](HallPixel& p) {
         lights(p);
         p.useLamps(true);
         p.in.sightLights = {0, 1, 2, 3};
         coat(p);
       }},
      {"shadows by coverage", [](HallPixel& p) { shadows(p); }},
      {"shadows of what moves",
       [](HallPixel& p) {
         shadows(p);
         coat(p);
         p.in.movingMaps = {movingMap(0), movingMap(2), movingMap(1)};
         p.in.sunMaps = {movingMap(2)};
         p.in.movingMaps[1].mapFromWorld[3].x += 0.13;
       }},
      {"a coat over multiple scattering",
       [](HallPixel& p) {
         coat(p);
         p.in.energy = Energy::Multiple;
         p.in.surface.roughness = 0.71f;
         lights(p);
       }},
      {"brushed cloth under a coat",
       [](HallPixel& p) {
         finish(p);
         coat(p);
         lights(p);
       }},
      {"a thin film",
       [](HallPixel& p) {
         film(p);
         lights(p);
         p.in.energy = Energy::Multiple;
       }},
      {"glass, once refracted", [](HallPixel& p) { glass(p, "one-pass", 1, false); }},
      {"glass, its back", [](HallPixel& p) { glass(p, "two-pass", 2, true); }},
      {"glass, followed", [](HallPixel& p) { glass(p, "two-interface", 3, false); }},
      {"glass, followed from within",
       [](HallPixel& p) {
         glass(p, "two-interface", 3, true);
         coat(p);
         technique(p, "footprint2");
       }},
      {"glass, followed from within, seen steeply",
       [](HallPixel& p) {
         glass(p, "two-interface", 3, true);
         p.seeFrom({0.4, 1.7, 0.9});
         p.in.glass->object.center =
             glm::vec3(p.in.surface.positionWorld - p.in.surface.eyeWorld) + glm::vec3(0.03f, 0.69f, -0.05f);
       }},
      {"glass, a sheet",
       [](HallPixel& p) {
         glass(p, "thin", 1, false);
         p.in.glass->object.sheet = true;
         p.in.surface.roughness = 0.03f;
       }},
      {"glass under lamps by the sky",
       [](HallPixel& p) {
         glass(p, "one-pass", 1, false);
         p.in.glass->behind = 0.0f;
         p.in.glass->straightAngle = 0.01f;
         p.useLamps(true);
         p.in.energy = Energy::Multiple;
       }},
      {"a planar mirror",
       [](HallPixel& p) {
         mirror(p);
         p.in.surface.roughness = 0.24f;
         coat(p);
       }},
      {"a flat planar mirror",
       [](HallPixel& p) {
         mirror(p);
         p.in.surface.normalWorld = {0.0f, 1.0f, 0.0f};
         p.in.surface.roughness = 0.0f;
         p.mirror.parallel = 1.0f;
       }},
      {"the sky alone, occluded",
       [](HallPixel& p) {
         sky(p);
         p.in.openness = hallMaps().openness;
       }},
      {"the sky alone", [](HallPixel& p) { sky(p); }},
      {"just short of the box's floor",
       [](HallPixel& p) {
         p.in.surface.positionWorld.y = 0.0997;
         p.seeFrom({-0.6, 1.5, 1.9});
       }},
      {"beside one influence box, near the edge of another side",
       [](HallPixel& p) {
         p.in.probes.resize(1);
         p.scene.probes.resize(1);
         p.in.surface.positionWorld = {2.42, -0.03, 0.9};
         p.seeFrom({1.6, 1.5, 2.2});
       }},
      {"far beside one influence box",
       [](HallPixel& p) {
         p.in.probes.resize(1);
         p.scene.probes.resize(1);
         p.in.surface.positionWorld = {4.4, 0.3, -0.9};
         p.seeFrom({3.6, 1.5, -0.2});
       }},
      {"in the blend distance",
       [](HallPixel& p) {
         p.in.probes.resize(1);
         p.scene.probes.resize(1);
         p.in.surface.positionWorld = {1.97, 0.13, 1.37};
         p.seeFrom({0.6, 1.5, 2.2});
       }},
      {"shares of the object",
       [](HallPixel& p) {
         p.in.shares = {0.31f, 0.44f};
         p.in.skyShare = 0.25f;
         shadows(p);
       }},
      {"one probe without weights",
       [](HallPixel& p) {
         p.in.weights = false;
         p.in.probes.erase(p.in.probes.begin());
         shadows(p);
       }},
      {"probes share the sky's part", [](HallPixel& p) { p.in.onlyProbes = true; }},
      {"no share of the sky",
       [](HallPixel& p) {
         p.in.sky = false;
         p.in.surface.opacity = 0.63f;
       }},
      {"nothing captured",
       [](HallPixel& p) {
         p.in.probes[0].maps = p.in.probes[1].maps = nullptr;
         p.probe(1).technique = "infinite";
       }},
      {"no sky and no probe",
       [](HallPixel& p) {
         p.in.probes.clear();
         p.in.skyMaps = nullptr;
         lights(p);
       }},
      {"unlit", [](HallPixel& p) { p.in.lighting = ExplainInput::Lighting::Unlit; }},
      {"plain light",
       [](HallPixel& p) {
         p.in.lighting = ExplainInput::Lighting::Plain;
         shadows(p);
         finish(p);
       }},
      {"no normal", [](HallPixel& p) { p.in.surface.normalWorld = glm::vec3(0.0f); }},
      {"seen from below its normal",
       [](HallPixel& p) {
         p.seeFrom({-0.6, -0.4, 1.9});
       }},
      {"outside the box, its origin too",
       [](HallPixel& p) {
         p.in.surface.positionWorld = {2.2, 0.13, 0.37};
         p.probe(0).origin = {0.2, 3.2, -0.3};
         p.probe(0).influence = Box{{-3.0, -1.0, -4.0}, {4.0, 4.0, 4.0}};
       }},
      {"from the middle of a box along an axis",
       [](HallPixel& p) {
         p.in.probes.resize(1);
         p.scene.probes.resize(1);
         p.in.surface.normalWorld = {0.0f, 1.0f, 0.0f};
         p.seeFrom({0.71, 1.5, 1.37});
       }},
      {"auto",
       [](HallPixel& p) {
         p.in.probes[1].automatic = true;
         p.probe(1).technique = "auto";
       }},
  };
  return cases;
}

}  // namespace boxprobe::test
