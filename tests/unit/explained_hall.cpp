#include "tests/unit/explained_hall.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/cube/openings.h"
#include "tests/support/sphere_mesh.h"

namespace boxprobe::test {

namespace {

const Box kWalls{{-2.4, -0.1, -3.0}, {2.2, 3.1, 3.3}};  // of what was captured, no proxy's

double waves(const glm::dvec3& d, double seed) {
  return std::sin(2.3 * d.x + 1.1 * seed) * std::cos(1.7 * d.y - 0.4 * seed) + 0.6 * std::sin(2.9 * d.z + 0.8 * d.x);
}

/// Light that is another one in every direction and level. `covered`: alpha 1 everywhere.
CubeMap madeRadiance(int faceSize, double seed, bool covered) {
  int levels = 1;
  for (int size = faceSize; size > 1; size /= 2) ++levels;
  CubeMap map(faceSize, levels);
  for (int level = 0; level < levels; ++level) {
    const int size = map.levelSize(level);
    for (int i = 0; i < 6 * size * size; ++i) {
      const int face = i / (size * size), row = i / size % size, column = i % size;
      const auto at = [size](int k) { return (2.0f * static_cast<float>(k) + 1.0f) / static_cast<float>(size) - 1.0f; };
      const glm::dvec3 d(glm::normalize(shading::cubeDirection(face, at(column), at(row))));
      const double fade = 1.0 / (1.0 + 0.3 * level);
      const double alpha =
          covered ? 1.0 : std::clamp(0.65 + 0.7 * std::sin(1.9 * d.x + 1.3 * d.y - 2.2 * d.z + seed), 0.0, 1.0);
      const glm::dvec3 light(1.1 + 0.5 * fade * waves(d, seed), 0.9 + 0.4 * fade * waves(d, seed + 1.0),
                             0.8 + 0.45 * fade * waves(d, seed + 2.3));
      map.setTexel(level, face, column, row, glm::vec4(glm::vec3(alpha * light), static_cast<float>(alpha)));
    }
  }
  return map;
}

/// To the walls from `origin`, and to a ball on the way; nothing seen upwards on one side.
CubeMap madeDistance(int faceSize, const glm::dvec3& origin) {
  CubeMap map(faceSize, 1);
  const glm::dvec3 ball = glm::dvec3(1.3, 0.6, 0.9) - origin;
  for (int i = 0; i < 6 * faceSize * faceSize; ++i) {
    const int face = i / (faceSize * faceSize), row = i / faceSize % faceSize, column = i % faceSize;
    const auto at = [&](int k) { return (2.0f * static_cast<float>(k) + 1.0f) / static_cast<float>(faceSize) - 1.0f; };
    const glm::dvec3 d(glm::normalize(shading::cubeDirection(face, at(column), at(row))));
    double distance = 1e9;
    for (int axis = 0; axis < 3; ++axis) {
      if (d[axis] == 0.0) continue;
      distance = std::min(distance, ((d[axis] > 0.0 ? kWalls.max : kWalls.min)[axis] - origin[axis]) / d[axis]);
    }
    const double along = glm::dot(ball, d), beside = glm::dot(ball, ball) - along * along;
    if (along > 0.0 && beside < 0.16) distance = along - std::sqrt(0.16 - beside);
    if (d.y > 0.8 && d.x < -0.1) distance = 0.0;
    map.setTexel(0, face, column, row, glm::vec4(static_cast<float>(distance), 0.0f, 0.0f, 1.0f));
  }
  return map;
}

ShCoefficients madeCoefficients(double seed) {
  ShCoefficients c;
  for (std::size_t i = 0; i < 9; ++i) {
    const double k = static_cast<double>(i);
    c[i] =
        glm::vec3(glm::dvec3(0.9 / (1.0 + k) + 0.05 * std::sin(k + seed), 0.7 / (1.0 + k) + 0.06 * std::cos(k + seed),
                             0.6 / (1.0 + k) + 0.07 * std::sin(2.0 * k + seed)));
  }
  return c;
}

SceneLamp madeLamp(const std::string& node, const glm::dvec3& at, const glm::dvec3& u, const glm::dvec3& v,
                   const glm::dvec3& radiance) {
  SceneLamp lamp;
  lamp.node = node;
  lamp.corners = {at, at + u, at + 1.1 * u + v, at + v};
  for (const glm::dvec3& corner : lamp.corners) lamp.middle += 0.25 * corner;
  lamp.normal = glm::normalize(glm::cross(u, v));
  lamp.radiance = radiance;
  return lamp;
}

Probe hallProbe() {
  Probe p;
  p.name = "hall";
  p.origin = {0.2, 1.1, -0.3};
  p.box = {{-2.1, 0.1, -3.2}, {1.9, 2.9, 2.7}};
  p.influence = Box{{-1.9, -0.1, -2.8}, {2.3, 2.6, 1.6}};
  p.blendDistance = {{0.31, 0.12, 0.53}, {1.1, 0.47, 1.9}};
  p.intensity = 0.9;
  return p;
}

Probe cupboardProbe() {
  Probe p;
  p.name = "cupboard";
  p.origin = {0.9, 0.8, 0.5};
  p.box = {{-0.4, -0.2, -1.1}, {1.8, 1.9, 1.4}};
  p.rotationDegrees = {6.0, 31.0, -9.0};
  p.blendDistance = {{0.41, 0.72, 0.33}, {1.4, 0.25, 0.86}};
  p.intensity = 0.7;
  p.importance = 0.5;
  return p;
}

}  // namespace

HallMaps::HallMaps() {
  const Probe hallAt = hallProbe(), cupboardAt = cupboardProbe();
  hall.radiance = madeRadiance(32, 0.3, true);
  hall.distance = madeDistance(32, hallAt.origin);
  hall.irradiance = madeCoefficients(0.2);
  cupboard.radiance = madeRadiance(16, 1.7, true);
  cupboard.distance = madeDistance(16, cupboardAt.origin);
  cupboard.irradiance = madeCoefficients(1.9);
  sky.radiance = madeRadiance(8, 3.1, true);
  sky.irradiance = madeCoefficients(3.3);
  open.radiance = madeRadiance(32, 0.3, false);
  open.distance = hall.distance;
  open.irradiance = madeCoefficients(0.5);
  lampFree.radiance = madeRadiance(32, 0.9, true);
  for (int level = 0; level < lampFree.radiance.levels(); ++level) {
    const int size = lampFree.radiance.levelSize(level);
    for (int i = 0; i < 6 * size * size; ++i) {
      float* texel = lampFree.radiance.face(level, 0) + 4 * i;
      texel[3] = 0.3f + 0.4f * static_cast<float>(i % 7) / (1.0f + static_cast<float>(level));
    }
  }
  CubeMap tint = madeRadiance(32, 2.2, true);
  through = throughChain(open.radiance, &tint);

  const ProbeGeometry geometry = probeGeometry(hallAt, hallAt.origin);
  LatticeSettings settings;
  settings.spacing = 1.3f;
  settings.rays = 128;
  const shading::ProbeShape shape = probeShape(geometry, 5.0f, 0.0f);
  DiffuseLattice derived =
      makeDiffuseLattice(plainMeans(hall.radiance), shape, glm::mat3(1.0f), glm::mat3(1.0f), settings);
  // One of them is within something.
  const auto nodes = static_cast<std::size_t>(derived.nodes.x * derived.nodes.y * derived.nodes.z);
  for (std::size_t i = 0; i < nodes; i += 3) derived.texels[(DiffuseLattice::kParts - 1) * nodes + i].w = 0.0f;
  lattice = std::make_shared<const DiffuseLattice>(derived);
  derived.cuts.resize(DiffuseLattice::kCutParts * nodes);
  for (std::size_t i = 0; i < derived.cuts.size(); ++i) {
    const float cut = 0.25f * static_cast<float>(i % 4);
    derived.cuts[i] = {cut, 0.3f * cut, (0.5f + 0.04f * static_cast<float>(i % 5)) * cut, 0.0f};
  }
  derived.cutWays = 23;
  cutLattice = std::make_shared<const DiffuseLattice>(derived);

  lamps = {madeLamp("table lamp", {-0.9, 0.9, 0.2}, {0.0, 0.2, 0.5}, {-0.3, 0.25, 0.0}, {9.0, 7.0, 4.0}),
           madeLamp("ceiling lamp", {0.1, 2.7, -0.6}, {1.3, 0.0, 0.1}, {0.1, 0.0, 0.7}, {5.0, 6.0, 8.0}),
           madeLamp("behind", {0.1, -0.7, -0.6}, {1.3, 0.0, 0.1}, {0.1, 0.0, 0.7}, {5.0, 6.0, 8.0})};
  lamps[1].corners[2].x += 0.2;
  lamps[0].bothSides = true;

  ProbeSight seen;
  seen.middleWorld = hallAt.box.center();
  seen.lamps = {0, 1, 2};
  seen.lampChannel = {1, 5, kSeenByAll};
  seen.sourceChannel = {2, 3, kSeenByNone, kSeenByAll};
  seen.lattice.nodes = {3, 4, 5};
  seen.lattice.low = {-1.9, -1.2, -2.7};
  seen.lattice.high = {1.8, 1.3, 2.8};
  seen.lattice.channels = 6;
  for (int part = 0; part < 2; ++part) {
    for (int node = 0; node < 60; ++node) {
      const int say = 140 + node * 37 % 116;
      for (int channel = 0; channel < 4; ++channel) {
        const bool first = part == 0 && channel == 0;
        const int share = first ? say : say * (20 + (node * (13 + 4 * channel) + 31 * part) % 80) / 100;
        seen.lattice.texels.push_back(static_cast<std::uint8_t>(share));
      }
    }
  }
  sight = std::make_shared<const ProbeSight>(seen);

  SkyOpenness around;
  around.low = {-2.0, -0.5, -2.2};
  around.spacing = 0.9;
  around.nodes = {5, 4, 6};
  for (int i = 0; i < 4 * 5 * 4 * 6; ++i) around.texels.push_back(static_cast<std::uint8_t>(40 + i * 53 % 190));
  openness = std::make_shared<const SkyOpenness>(around);

  Mesh egg = sphereMesh(1.0f, 24, 40);
  for (glm::vec3& p : egg.positions) p *= glm::vec3(0.5f, 0.7f, 0.4f);
  for (glm::vec3& n : egg.normals) n /= glm::vec3(0.5f, 0.7f, 0.4f);
  shells.emplace_back(egg.positions, egg.normals, egg.indices, 32);

  for (int size = 16; size > 0; size /= 2) {
    MirrorTexels::Level level;
    level.width = size;
    level.height = std::max(size / 2, 1);
    for (int i = 0; i < level.width * level.height; ++i) {
      const float x = (static_cast<float>(i % level.width) + 0.5f) / static_cast<float>(level.width);
      const float y = (static_cast<float>(i / level.width) + 0.5f) / static_cast<float>(level.height);
      const float cover = std::clamp(0.5f + 0.7f * std::sin(3.0f * x + 2.0f * y), 0.0f, 1.0f);
      level.color.push_back(cover * glm::vec4(0.7f + 0.2f * x, 1.3f - 0.3f * y, 0.4f + 0.3f * x * y, 1.0f));
      level.heights.push_back(cover * glm::vec4(0.2f + 0.4f * x + 0.2f * y, 0.0f, 0.0f, 1.0f));
    }
    mirror.levels.push_back(level);
  }
}

const HallMaps& hallMaps() {
  static const HallMaps maps;
  return maps;
}

HallPixel::HallPixel() {
  scene.probes = {hallProbe(), cupboardProbe()};
  const HallMaps& maps = hallMaps();
  in.probes.resize(2);
  for (std::size_t i = 0; i < 2; ++i) {
    in.probes[i].name = scene.probes[i].name;
    in.probes[i].index = in.probes[i].group = static_cast<int>(i);
    in.probes[i].maps = i == 0 ? &maps.hall : &maps.cupboard;
  }
  in.skyMaps = &maps.sky;
  SurfacePoint& s = in.surface;
  s.object = "floor";
  s.material = "oak";
  s.positionWorld = {0.71, 0.13, 0.37};
  s.normalWorld = glm::normalize(glm::vec3(0.08f, 0.95f, -0.06f));
  s.albedo = {0.62f, 0.47f, 0.31f};
  s.metallic = 0.15f;
  s.roughness = 0.37f;
  s.occlusion = 0.9f;
  s.baseF0 = 0.05f;
  s.emissive = {0.011f, 0.022f, 0.033f};
  s.pixel = {211, 87};
  s.frame = 3;
  seeFrom({-0.6, 1.5, 1.9});
}

void HallPixel::seeFrom(const glm::dvec3& eye) {
  in.surface.eyeWorld = eye;
  in.surface.viewWorld = glm::vec3(glm::normalize(eye - in.surface.positionWorld));
}

void HallPixel::useLamps(bool lattice) {
  const HallMaps& maps = hallMaps();
  ExplainedProbe& p = in.probes[0];
  p.lampFree = &maps.lampFree;
  if (lattice) p.lattice = maps.lattice;
  p.lamps = maps.lamps;
  p.lampGlossy = {{8.1f, 6.2f, 3.3f}, {4.4f, 5.1f, 7.7f}, {1.0f, 1.0f, 1.0f}};
  p.sight = maps.sight;
  p.lampChannels = maps.sight->lampChannel;
}

void HallPixel::useGlass(const std::string& form, int number, bool back) {
  const GlassShell& shell = hallMaps().shells.front();
  ExplainedGlass glass;
  glass.form = form;
  glass.shell = &shell;
  glass.object.ior = 1.47f;
  glass.object.form = number;
  glass.object.thickness = 0.23f;
  glass.object.radius = shell.radius();
  glass.transmission = 0.83f;
  glass.attenuationDistance = 0.9f;
  glass.attenuationColor = {0.8f, 0.5f, 0.9f};
  glass.straightAngle = 0.6f;
  glass.behind = 0.17f;
  in.surface.backSide = back;
  in.surface.transmission = glass.transmission;
  in.surface.roughness = 0.21f;
  // The pixel is on the egg.
  const glm::vec3 middle = glm::vec3(in.surface.positionWorld - in.surface.eyeWorld) -
                           (back ? -1.0f : 1.0f) * glm::vec3(0.03f, 0.69f, -0.05f);
  glass.object.center = middle;
  in.glass = glass;
}

Explanation HallPixel::explain() const {
  ExplainInput input = in;
  for (std::size_t i = 0; i < input.probes.size(); ++i) {
    const Probe& probe = scene.probes[static_cast<std::size_t>(input.probes[i].index)];
    ProbeGeometry& geometry = input.probes[i].geometry;
    geometry = probeGeometry(probe, probe.origin, probe.name == "cupboard" ? capturedRotation : glm::dvec3(0.0));
    // As draws resolve it.
    if (techniqueId(geometry.technique) == "auto") geometry.technique = *parseTechnique("footprint2");
  }
  if (input.mirror != nullptr) input.mirror = &mirror;
  Explanation e = explainPixel(input);
  e.x = 211;
  e.y = 119;
  return e;
}

}  // namespace boxprobe::test
