// All bounces of light where no capture sees: the room, its rays and its path tracer are this file's own.
#include "filters/core/geometry/traced_lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <functional>
#include <glm/geometric.hpp>
#include <memory>
#include <optional>
#include <random>
#include <utility>
#include <vector>

namespace {

using namespace boxprobe;
using glm::dvec3;

constexpr double kPi = 3.14159265358979323846;
const dvec3 kLow(-1.9, -1.1, -1.4), kHigh(2.3, 1.5, 1.7);
const glm::vec3 kAlbedo(0.8f, 0.6f, 0.3f);

// A closed room of one albedo; the place of the capture is walled in, so that it sees nothing of the room.
struct Room : SightLines {
  bool empty() const override { return false; }
  Box bounds() const override { return {kLow, kHigh}; }
  bool blocked(const dvec3& from, const dvec3&, bool) const override { return glm::length(from) < 1e-6; }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    Met met;
    met.distance = 1e300;
    for (int a = 0; a < 3; ++a) {
      const double to = d[a] > 0.0 ? (kHigh[a] - from[a]) / d[a] : d[a] < 0.0 ? (kLow[a] - from[a]) / d[a] : 1e300;
      if (to >= met.distance) continue;
      met.distance = to;
      met.normal = dvec3(0.0);
      met.normal[a] = d[a] > 0.0 ? -1.0 : 1.0;
    }
    met.albedo = kAlbedo;
    return met;
  }
};

// Mean radiance that arrives at a place from all around, the light source itself left out.
dvec3 meanLight(const dvec3& place, const Light& light, int paths) {
  const Room room;
  std::mt19937 random(71);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  dvec3 sum(0.0);
  for (int i = 0; i < paths; ++i) {
    const double z = 1.0 - 2.0 * (i + any(random)) / paths, phi = 2.0 * kPi * any(random);
    dvec3 at = place, d(std::sqrt(1.0 - z * z) * std::cos(phi), std::sqrt(1.0 - z * z) * std::sin(phi), z), share(1.0);
    for (int bounce = 0; bounce < 60; ++bounce) {
      const auto met = room.first(at, d);
      at += (met->distance - 1e-9) * d;
      share *= dvec3(kAlbedo);
      const dvec3 way = light.position - at;
      const double d2 = glm::dot(way, way), cosine = std::max(glm::dot(way, met->normal), 0.0) / std::sqrt(d2);
      sum += share * (static_cast<double>(light.intensity) * cosine / d2 / kPi) * dvec3(light.color);
      const double height = std::sqrt(any(random)), turn = 2.0 * kPi * any(random),
                   r = std::sqrt(1.0 - height * height);
      const dvec3 side = std::abs(met->normal.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
      d = height * met->normal + r * (std::cos(turn) * side + std::sin(turn) * glm::cross(met->normal, side));
    }
  }
  return sum / static_cast<double>(paths);
}

TEST(TracedLattice, WhatNoCaptureSeesHasAllBounces) {
  Light light;
  light.type = LightType::Point;
  light.position = {0.7, 0.4, -0.3};
  light.intensity = 3.0f;
  light.color = {1.0f, 0.8f, 0.5f};
  LatticeSurroundings in;
  in.lines = std::make_shared<const Room>();
  in.lamps = std::make_shared<const SceneLamps>();
  in.lights = std::make_shared<const std::vector<Light>>(std::vector<Light>{light});
  CubeMap dark(8, 1);  // of the walled-in place
  for (int face = 0; face < 6; ++face) std::fill_n(dark.face(0, face), 8 * 8 * 4, 0.0f);
  const CubeMap means = plainMeans(dark);
  shading::ProbeShape shape{};
  shape.boxMin = glm::vec3(kLow);
  shape.boxMax = glm::vec3(kHigh);
  shape.projection = 0;
  const DiffuseLattice lattice = tracedLattice(makeDiffuseLattice(means, shape), means, in);
  ASSERT_FALSE(lattice.empty());
  const glm::ivec3 n = lattice.nodes;
  for (const glm::ivec3 p : {glm::ivec3(1, 1, 1), glm::ivec3(n.x - 1, 0, n.z - 2), glm::ivec3(2, n.y - 1, 0)}) {
    const int index = (p.z * n.y + p.y) * n.x + p.x;
    const auto node = static_cast<std::size_t>(index);
    const glm::vec3 place = lattice.low + glm::vec3(p) * (lattice.high - lattice.low) / glm::vec3(n - 1);
    const dvec3 truth = meanLight(dvec3(place), light, 20000);
    const glm::vec3 first(lattice.texels[node]);
    // The constant band's cosine over pi is 1: the coefficient is the mean of the light.
    std::printf("node %d %d %d: %.4f %.4f %.4f, true %.4f %.4f %.4f\n", p.x, p.y, p.z, static_cast<double>(first.x),
                static_cast<double>(first.y), static_cast<double>(first.z), truth.x, truth.y, truth.z);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(first[c]) / truth[c], 1.0, 0.04) << c;
  }
}

// The same room, whose wall at +x shines, and of whose wall at -z a part is a lamp, single-sided as well.
struct ShiningRoom : Room {
  bool ofLamp(const dvec3& p) const { return p.z < kLow.z + 1e-6 && p.x > 0.2 && p.x < 1.6 && p.y > -0.5 && p.y < 0.8; }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    auto met = Room::first(from, d);
    const dvec3 at = from + met->distance * d;
    if (met->normal.x < -0.5) met->emitted = wall;
    if (ofLamp(at)) met->albedo = glm::vec3(0.0f), met->emitted = lamp;
    return met;
  }
  glm::vec3 wall{0.0f}, lamp{0.0f};
};

// Mean radiance that arrives at a place from all around; the lamp counts by what it lights alone.
dvec3 meanShine(const dvec3& place, const ShiningRoom& room, int paths) {
  std::mt19937 random(59);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  dvec3 sum(0.0);
  for (int i = 0; i < paths; ++i) {
    const double z = 1.0 - 2.0 * (i + any(random)) / paths, phi = 2.0 * kPi * any(random);
    dvec3 at = place, d(std::sqrt(1.0 - z * z) * std::cos(phi), std::sqrt(1.0 - z * z) * std::sin(phi), z), share(1.0);
    for (int bounce = 0; bounce < 60; ++bounce) {
      const auto met = room.first(at, d);
      at += (met->distance - 1e-9) * d;
      if (room.ofLamp(at)) {
        if (bounce > 0) sum += share * dvec3(room.lamp);
        break;
      }
      sum += share * dvec3(met->emitted);
      share *= dvec3(met->albedo);
      const double height = std::sqrt(any(random)), turn = 2.0 * kPi * any(random),
                   r = std::sqrt(1.0 - height * height);
      const dvec3 side = std::abs(met->normal.x) > 0.5 ? dvec3(0, 1, 0) : dvec3(1, 0, 0);
      d = height * met->normal + r * (std::cos(turn) * side + std::sin(turn) * glm::cross(met->normal, side));
    }
  }
  return sum / static_cast<double>(paths);
}

// What shines where no capture sees it lights nodes. A lamp that is drawn as a shape does so by what it lights alone.
TEST(TracedLattice, WhatShinesUnseenLightsNodes) {
  auto room = std::make_shared<ShiningRoom>();
  room->wall = {0.9f, 0.5f, 0.2f};
  room->lamp = {6.0f, 4.0f, 3.0f};
  auto lamps = std::make_shared<SceneLamps>();
  SceneLamp lamp;
  lamp.corners = {{0.2, -0.5, kLow.z}, {1.6, -0.5, kLow.z}, {1.6, 0.8, kLow.z}, {0.2, 0.8, kLow.z}};
  lamp.middle = {0.9, 0.15, kLow.z};
  lamp.normal = {0.0, 0.0, 1.0};
  lamp.radiance = room->lamp;
  lamps->lamps.push_back(lamp);
  LatticeSurroundings in;
  in.lines = room;
  in.lamps = lamps;
  in.drawn = {0};
  CubeMap dark(8, 1);
  for (int face = 0; face < 6; ++face) std::fill_n(dark.face(0, face), 8 * 8 * 4, 0.0f);
  const CubeMap means = plainMeans(dark);
  shading::ProbeShape shape{};
  shape.boxMin = glm::vec3(kLow);
  shape.boxMax = glm::vec3(kHigh);
  shape.projection = 0;
  const DiffuseLattice lattice = tracedLattice(makeDiffuseLattice(means, shape), means, in);
  const glm::ivec3 n = lattice.nodes;
  for (const glm::ivec3 p : {glm::ivec3(1, 1, 1), glm::ivec3(n.x - 1, 0, n.z - 2), glm::ivec3(2, n.y - 1, 0)}) {
    const int index = (p.z * n.y + p.y) * n.x + p.x;
    const auto node = static_cast<std::size_t>(index);
    const glm::vec3 place = lattice.low + glm::vec3(p) * (lattice.high - lattice.low) / glm::vec3(n - 1);
    const dvec3 truth = meanShine(dvec3(place), *room, 20000);
    const glm::vec3 first(lattice.texels[node]);
    std::printf("node %d %d %d: %.4f %.4f %.4f, true %.4f %.4f %.4f\n", p.x, p.y, p.z, static_cast<double>(first.x),
                static_cast<double>(first.y), static_cast<double>(first.z), truth.x, truth.y, truth.z);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(static_cast<double>(first[c]) / truth[c], 1.0, 0.04) << c;
  }
}

// Nodes are half as far apart beside what is bright and drawn by no shape, and as usual beside what is dim, even, or
// drawn.
TEST(TracedLattice, BrightThingsThatAreNotDrawnBringNodesCloser) {
  const auto spacing = [](const glm::vec3& wall, const glm::vec3& lamp, bool drawn, float around) {
    auto room = std::make_shared<ShiningRoom>();
    room->wall = wall;
    room->lamp = lamp;
    auto lamps = std::make_shared<SceneLamps>();
    SceneLamp polygon;
    polygon.corners = {{0.2, -0.5, kLow.z}, {1.6, -0.5, kLow.z}, {1.6, 0.8, kLow.z}, {0.2, 0.8, kLow.z}};
    polygon.middle = {0.9, 0.15, kLow.z};
    polygon.normal = {0.0, 0.0, 1.0};
    polygon.radiance = lamp;
    lamps->lamps.push_back(polygon);
    LatticeSurroundings in;
    in.lines = room;
    in.lamps = lamps;
    if (drawn) in.drawn = {0};
    CubeMap seen(8, 1);
    for (int face = 0; face < 6; ++face) std::fill_n(seen.face(0, face), 8 * 8 * 4, around);
    return tracedSpacing(glm::vec3(kLow), glm::vec3(kHigh), 0.9f, plainMeans(seen), in);
  };
  const glm::vec3 dark(0.0f), bright(6.0f, 4.0f, 3.0f);
  EXPECT_FLOAT_EQ(spacing(dark, bright, false, 0.3f), 0.45f);
  EXPECT_FLOAT_EQ(spacing(dark, bright, true, 0.3f), 0.9f) << "drawn";
  EXPECT_FLOAT_EQ(spacing(dark, glm::vec3(0.02f), false, 0.3f), 0.9f) << "dim";
  EXPECT_FLOAT_EQ(spacing(glm::vec3(0.5f), dark, false, 0.3f), 0.9f) << "as bright as what is around";
}

// A floor without end under the sky; the place of the capture is walled in.
struct Floor : SightLines {
  explicit Floor(double height) : height_(height) {}
  bool empty() const override { return false; }
  Box bounds() const override { return {{-1e9, height_, -1e9}, {1e9, height_, 1e9}}; }
  bool blocked(const dvec3& from, const dvec3& to, bool) const override {
    return glm::length(from) < 1e-6 || (from.y > height_) != (to.y > height_);
  }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    if (d.y >= 0.0) return std::nullopt;
    Met met;
    met.distance = (height_ - from.y) / d.y;
    met.normal = dvec3(0.0, 1.0, 0.0);
    met.albedo = kAlbedo;
    return met;
  }

 private:
  double height_;
};

// Half of what a node sees is the sky, half a floor in the sun and under that sky: within the box, where nodes light
// it, and below the box, where the sky does.
TEST(TracedLattice, SunAndSkyLightWhatNodesSee) {
  const glm::vec3 skyLight(0.4f, 0.7f, 1.3f);
  CubeMap sky(8, 1), dark(8, 1);
  for (int face = 0; face < 6; ++face) {
    std::fill_n(dark.face(0, face), 8 * 8 * 4, 0.0f);
    for (int i = 0; i < 8 * 8; ++i) sky.setTexel(0, face, i % 8, i / 8, glm::vec4(skyLight, 1.0f));
  }
  Light sun;
  sun.direction = {0.6, -0.8, 0.3};
  sun.intensity = 5.0f;
  sun.color = {1.0f, 0.9f, 0.6f};
  const double cosine = 0.8 / glm::length(sun.direction);
  const CubeMap means = plainMeans(dark);
  shading::ProbeShape shape{};
  shape.boxMin = glm::vec3(kLow);
  shape.boxMax = glm::vec3(kHigh);
  shape.projection = 0;
  for (const double height : {kLow.y, kLow.y - 2.5}) {
    LatticeSurroundings in;
    in.lines = std::make_shared<const Floor>(height);
    in.lamps = std::make_shared<const SceneLamps>();
    in.lights = std::make_shared<const std::vector<Light>>(std::vector<Light>{sun});
    in.sky = std::make_shared<const CubeMap>(sky);
    in.open = true;
    const DiffuseLattice lattice = tracedLattice(makeDiffuseLattice(means, shape), means, in);
    const glm::ivec3 n = lattice.nodes;
    const int at = (1 * n.y + n.y - 1) * n.x + 2;
    const glm::vec4 mean = lattice.texels[static_cast<std::size_t>(at)];
    for (int c = 0; c < 3; ++c) {
      const double s = static_cast<double>(skyLight[c]), a = static_cast<double>(kAlbedo[c]);
      const double sunny = static_cast<double>(sun.intensity * sun.color[c]) * cosine / kPi;
      const double truth = 0.5 * s + 0.5 * a * (sunny + s);
      std::printf("floor at %.1f: %.4f, true %.4f\n", height, static_cast<double>(mean[c]), truth);
      EXPECT_NEAR(static_cast<double>(mean[c]) / truth, 1.0, 0.03) << c;
    }
  }
}

// Black beams under a bright sky: an opening between two is as bright as it is wide, however coarse the capture's
// texels.
struct Beams : SightLines {
  static constexpr double kHeight = 1.7, kApart = 0.13, kCovered = 0.6;
  static bool covered(const dvec3& p) {
    const double at = p.x / kApart;
    return at - std::floor(at) < kCovered;
  }
  bool empty() const override { return false; }
  Box bounds() const override { return {{-1e9, kHeight, -1e9}, {1e9, kHeight, 1e9}}; }
  bool blocked(const dvec3&, const dvec3&, bool) const override { return false; }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    if (d.y <= 0.0) return std::nullopt;
    Met met;
    met.distance = (kHeight - from.y) / d.y;
    if (!covered(from + met.distance * d)) return std::nullopt;
    met.normal = dvec3(0.0, -1.0, 0.0);
    return met;
  }
};

TEST(TracedLattice, SkyBetweenBeamsIsNotTheBeams) {
  const auto skyAlong = [](const glm::vec3& d) { return glm::vec3(0.3f, 0.7f, 1.1f) * (1.0f + 0.5f * d.x); };
  const glm::dmat3 worldFromMap(dvec3(0.8, 0.0, -0.6), dvec3(0.0, 1.0, 0.0), dvec3(0.6, 0.0, 0.8));
  constexpr int kSize = 64;
  CubeMap sky(kSize, 1), capture(kSize, 1);
  const Beams beams;
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < kSize * kSize; ++i) {
      const int row = i / kSize, column = i % kSize;
      const glm::vec3 d =
          glm::normalize(shading::cubeDirection(face, 2.0f * (static_cast<float>(column) + 0.5f) / kSize - 1.0f,
                                                2.0f * (static_cast<float>(row) + 0.5f) / kSize - 1.0f));
      const dvec3 world = worldFromMap * dvec3(d);
      sky.setTexel(0, face, column, row, glm::vec4(skyAlong(d), 1.0f));
      const bool beam = beams.first(dvec3(0.0), world).has_value();
      capture.setTexel(0, face, column, row,
                       beam ? glm::vec4(0.0f, 0.0f, 0.0f, 1.0f) : glm::vec4(skyAlong(glm::vec3(world)), 0.0f));
    }
  }
  const CubeMap means = plainMeans(capture);
  shading::ProbeShape shape{};
  shape.boxMin = glm::vec3(kLow);
  shape.boxMax = glm::vec3(kHigh);
  shape.projection = 0;
  LatticeSurroundings in;
  in.lines = std::make_shared<const Beams>(beams);
  in.lamps = std::make_shared<const SceneLamps>();
  in.mapFromProbe = glm::transpose(worldFromMap);
  in.sky = std::make_shared<const CubeMap>(sky);
  const DiffuseLattice lattice = tracedLattice(makeDiffuseLattice(means, shape), means, in, 4096);
  const glm::ivec3 n = lattice.nodes;
  for (const glm::ivec3 p : {glm::ivec3(1, 1, 2), glm::ivec3(n.x - 1, 0, 1)}) {
    const int at = (p.z * n.y + p.y) * n.x + p.x;
    const glm::vec4 mean = lattice.texels[static_cast<std::size_t>(at)];
    const float open = 0.5f + 0.5f * static_cast<float>(1.0 - Beams::kCovered);
    const glm::vec3 truth = open * glm::vec3(0.3f, 0.7f, 1.1f);
    for (int c = 0; c < 3; ++c) EXPECT_NEAR(mean[c] / truth[c], 1.0f, 0.04f) << c;
  }
}

// Two closed rooms with a wall of 0.1 between them, and one box around both. The place of the capture is in the wall.
struct TwoRooms : SightLines {
  static constexpr double kWall = 0.05;  // half of it, about x = 0
  bool empty() const override { return false; }
  Box bounds() const override { return {kLow, kHigh}; }
  static bool within(const dvec3& p) {
    return p.x > kLow.x && p.x < kHigh.x && p.y > kLow.y && p.y < kHigh.y && p.z > kLow.z && p.z < kHigh.z &&
           std::abs(p.x) > kWall;
  }
  bool blocked(const dvec3& from, const dvec3& to, bool) const override {
    return glm::length(from) < 1e-6 || !within(from) || !within(to) || (from.x > 0.0) != (to.x > 0.0);
  }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    const bool east = from.x > 0.0;
    const dvec3 low(east ? kWall : kLow.x, kLow.y, kLow.z), high(east ? kHigh.x : -kWall, kHigh.y, kHigh.z);
    Met met;
    met.distance = 1e300;
    for (int a = 0; a < 3; ++a) {
      const double to = d[a] > 0.0 ? (high[a] - from[a]) / d[a] : d[a] < 0.0 ? (low[a] - from[a]) / d[a] : 1e300;
      if (to >= met.distance) continue;
      met.distance = to;
      met.normal = dvec3(0.0);
      met.normal[a] = d[a] > 0.0 ? -1.0 : 1.0;
    }
    met.albedo = kAlbedo;
    return met;
  }
};

TEST(TracedLattice, NoLightComesThroughAWallInTheBox) {
  Light light;
  light.type = LightType::Point;
  light.position = {-1.1, 0.6, -0.3};
  light.intensity = 3.0f;
  light.color = {1.0f, 0.8f, 0.5f};
  LatticeSurroundings in;
  in.lines = std::make_shared<const TwoRooms>();
  in.lamps = std::make_shared<const SceneLamps>();
  in.lights = std::make_shared<const std::vector<Light>>(std::vector<Light>{light});
  CubeMap dark(8, 1);
  for (int face = 0; face < 6; ++face) std::fill_n(dark.face(0, face), 8 * 8 * 4, 0.0f);
  const CubeMap means = plainMeans(dark);
  shading::ProbeShape shape{};
  shape.boxMin = glm::vec3(kLow);
  shape.boxMax = glm::vec3(kHigh);
  shape.projection = 0;
  DiffuseLattice lattice = tracedLattice(makeDiffuseLattice(means, shape), means, in);
  ASSERT_GT(lattice.cutWays, 0);
  // Mean and most over all walls of a room, its side of the wall between them among these.
  const auto lightOf = [&](bool east) {
    std::mt19937 random(5);
    std::uniform_real_distribution<double> any(0.0, 1.0);
    const dvec3 low(east ? TwoRooms::kWall : kLow.x, kLow.y, kLow.z);
    const dvec3 high(east ? kHigh.x : -TwoRooms::kWall, kHigh.y, kHigh.z);
    double sum = 0.0, most = 0.0;
    constexpr int kPoints = 600;
    for (int i = 0; i < kPoints; ++i) {
      dvec3 p = low + (high - low) * dvec3(any(random), any(random), any(random)), n(0.0);
      const int axis = i % 3;
      p[axis] = i / 3 % 2 == 0 ? low[axis] : high[axis];
      n[axis] = i / 3 % 2 == 0 ? 1.0 : -1.0;
      const glm::vec3 facing(n);
      const glm::vec3 there = shading::latticeIrradiance(lattice.shape(), glm::vec3(p), facing, facing);
      sum += static_cast<double>(there.y);
      most = std::max(most, static_cast<double>(there.y));
    }
    return std::make_pair(sum / kPoints, most);
  };
  const double bright = lightOf(false).first, black = lightOf(true).second;
  lattice.cuts.clear();
  const double leaks = lightOf(true).second;
  std::printf("lit room %.4f, brightest place of the dark one %.6f, without cuts %.4f; %d ways cut\n", bright, black,
              leaks, lattice.cutWays);
  EXPECT_GT(bright, 0.05);
  EXPECT_LT(black, 0.01 * bright);
  EXPECT_GT(leaks, 0.1 * bright) << "nothing is judged";
}

// A round room in a box many times as large: a thirtieth of the nodes stand in it, the others behind its wall.
struct RoundRoom : SightLines {
  static constexpr double kRadius = 1.1;
  const dvec3 middle{0.3, -0.2, 0.1};
  double turnedFrom = 1.1;  ///< from its middle: beyond that the wall turns its back to the room
  bool empty() const override { return false; }
  Box bounds() const override { return {middle - kRadius, middle + kRadius}; }
  bool blocked(const dvec3& from, const dvec3& to, bool) const override {
    const double length = glm::length(to - from);
    const auto met = first(from, (to - from) / length);
    return met && met->distance < length;
  }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    const dvec3 way = from - middle;
    const double along = glm::dot(way, d), square = along * along - glm::dot(way, way) + kRadius * kRadius;
    if (square <= 0.0) return std::nullopt;
    const double in = -along - std::sqrt(square), out = -along + std::sqrt(square);
    if (out <= 0.0) return std::nullopt;
    Met met;
    met.back = in > 0.0;
    met.distance = met.back ? in : out;
    const dvec3 at = way + met.distance * d;
    met.normal = (met.back ? 1.0 : -1.0) * at / kRadius;
    if (at.x > turnedFrom) met.back = !met.back;
    met.albedo = kAlbedo;
    return met;
  }
};

constexpr glm::vec3 kShown(0.4f, 0.7f, 1.1f);  ///< of the wall, everywhere

DiffuseLattice latticeOf(const std::shared_ptr<const RoundRoom>& room) {
  CubeMap capture(8, 1);
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < 64; ++i) capture.setTexel(0, face, i % 8, i / 8, glm::vec4(kShown, 1.0f));
  }
  const CubeMap means = plainMeans(capture);
  LatticeSurroundings in;
  in.lines = room;
  in.lamps = std::make_shared<const SceneLamps>();
  shading::ProbeShape shape{};
  shape.boxMin = {-2.9f, -2.6f, -3.1f};
  shape.boxMax = {2.7f, 2.5f, 3.1f};
  shape.projection = 0;
  LatticeSettings settings;
  settings.spacing = 0.4f;
  return tracedLattice(makeDiffuseLattice(means, shape, glm::mat3(1.0f), glm::mat3(1.0f), settings), means, in);
}

// Its wall shines alike all over, so that each place of it receives just that.
TEST(TracedLattice, NodesBehindTheWallOfARoundRoomAreNotItsLight) {
  const auto room = std::make_shared<const RoundRoom>();
  const DiffuseLattice lattice = latticeOf(room);
  const auto count = lattice.texels.size() / DiffuseLattice::kParts;
  std::size_t inside = 0;
  for (std::size_t node = 0; node < count; ++node) {
    inside += lattice.texels[(DiffuseLattice::kParts - 1) * count + node].w > 0.5f ? 1 : 0;
  }
  std::mt19937 random(17);
  std::uniform_real_distribution<double> any(0.0, 1.0);
  float least = 1e9f, most = 0.0f;
  for (int i = 0; i < 500; ++i) {
    const double z = 1.0 - 2.0 * any(random), phi = 2.0 * kPi * any(random), r = std::sqrt(1.0 - z * z);
    const dvec3 out(r * std::cos(phi), r * std::sin(phi), z);
    const glm::vec3 facing(-out), place(room->middle + RoundRoom::kRadius * out);
    const glm::vec3 there = shading::latticeIrradiance(lattice.shape(), place, facing, facing) / kShown;
    least = std::min({least, there.x, there.y, there.z});
    most = std::max({most, there.x, there.y, there.z});
  }
  std::printf("%zu of %zu nodes inside, light at the wall %.3f to %.3f of the truth\n", inside, count,
              static_cast<double>(least), static_cast<double>(most));
  EXPECT_LT(20 * inside, count) << "nothing is judged";
  EXPECT_GT(least, 0.95f);
  EXPECT_LT(most, 1.05f);
}

// A model's wall of one side may show its back to the room: who stands before it is not within something.
TEST(TracedLattice, NodesThatTheOriginSeesStandInTheOpen) {
  const auto room = std::make_shared<RoundRoom>();
  room->turnedFrom = 0.25;
  const DiffuseLattice lattice = latticeOf(room);
  const auto count = lattice.texels.size() / DiffuseLattice::kParts;
  const glm::vec3 step = (lattice.high - lattice.low) / glm::vec3(lattice.nodes - 1);
  std::size_t inside = 0, before = 0;
  for (std::size_t node = 0; node < count; ++node) {
    const auto i = static_cast<int>(node);
    const glm::ivec3 p(i % lattice.nodes.x, i / lattice.nodes.x % lattice.nodes.y,
                       i / (lattice.nodes.x * lattice.nodes.y));
    const dvec3 off = dvec3(lattice.low + glm::vec3(p) * step) - room->middle;
    if (glm::length(off) > 0.99 * RoundRoom::kRadius) continue;
    ++inside;
    before += off.x > room->turnedFrom ? 1 : 0;
    EXPECT_GT(lattice.texels[(DiffuseLattice::kParts - 1) * count + node].w, 0.5f) << off.x << " " << off.y;
  }
  EXPECT_GT(before, 10u);
  EXPECT_GT(inside, 2 * before);
}

// A lattice is kept while what it was traced from is the same, whichever copy of it.
TEST(TracedLattice, SurroundingsAreTheSameByWhatTheyHold) {
  const auto room = std::make_shared<const Room>();
  const auto lampsOf = [](double red) {
    SceneLamps lamps;
    for (const double x : {0.1, 0.7}) {
      SceneLamp lamp;
      lamp.corners = {{x, 1.0, 0.2}, {x + 0.3, 1.0, 0.2}, {x, 1.0, 0.6}};
      lamp.radiance = {x > 0.5 ? red : 2.0, 3.0, 4.0};
      lamps.lamps.push_back(lamp);
    }
    return std::make_shared<const SceneLamps>(lamps);
  };
  const auto lightsOf = [](float intensity) {
    Light light;
    light.position = {0.3, 0.5, 0.7};
    light.intensity = intensity;
    return std::make_shared<const std::vector<Light>>(1, light);
  };
  const auto made = [&] {
    LatticeSurroundings in;
    in.lines = room;
    in.originWorld = {0.1, 0.2, 0.3};
    in.lamps = lampsOf(5.0);
    in.drawn = {1};
    in.lights = lightsOf(7.0f);
    return in;
  };
  const LatticeSurroundings in = made();
  EXPECT_TRUE(in == made()) << "copies of the lamps and of the lights";
  const std::vector<std::pair<const char*, std::function<void(LatticeSurroundings&)>>> changes = {
      {"another room", [](auto& o) { o.lines = std::make_shared<const Room>(); }},
      {"the origin", [](auto& o) { o.originWorld.y = 0.25; }},
      {"the probe's turn", [](auto& o) { o.worldFromProbe[0][2] = 0.1; }},
      {"the map's turn", [](auto& o) { o.mapFromProbe[1][0] = 0.1; }},
      {"a lamp's colour", [&](auto& o) { o.lamps = lampsOf(5.5); }},
      {"which lamp is drawn", [](auto& o) { o.drawn = {0}; }},
      {"how many lamps are drawn",
       [](auto& o) {
         o.drawn = {0, 1};
       }},
      {"a light's intensity", [&](auto& o) { o.lights = lightsOf(7.5f); }},
      {"no lights", [](auto& o) { o.lights = nullptr; }},
      {"a sky", [](auto& o) { o.sky = std::make_shared<const CubeMap>(4, 1); }},
      {"a capture without sky", [](auto& o) { o.open = true; }},
  };
  for (const auto& [name, change] : changes) {
    LatticeSurroundings other = made();
    change(other);
    EXPECT_FALSE(in == other) << name;
    EXPECT_FALSE(other == in) << name;
  }
  LatticeSurroundings notDrawn = made();
  notDrawn.drawn = {0};
  LatticeSurroundings unseen = notDrawn;
  unseen.lamps = lampsOf(5.5);
  EXPECT_TRUE(notDrawn == unseen) << "the lamp that changed is none of those drawn";
}

}  // namespace
