// Soft shadows of lamps by a lattice of visibilities, against rays: the rooms, what stands in them, their rays and the
// integrals over the lamps are this file's own.
#include "filters/core/geometry/lamp_sight.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <memory>
#include <random>
#include <utility>

#include "filters/core/geometry/lamp_reach.h"

namespace {

using namespace boxprobe;
using glm::dvec3;

struct Block {
  dvec3 low, high;
};

// Boxes seen from outside: the walls' are turned inside out.
struct World : SightLines {
  std::vector<Block> rooms, things;

  static bool slab(const Block& b, const dvec3& from, const dvec3& d, double& in, double& out) {
    in = -1e300;
    out = 1e300;
    for (int a = 0; a < 3; ++a) {
      if (std::abs(d[a]) < 1e-14) {
        if (from[a] < b.low[a] || from[a] > b.high[a]) return false;
        continue;
      }
      const double s = (b.low[a] - from[a]) / d[a], t = (b.high[a] - from[a]) / d[a];
      in = std::max(in, std::min(s, t));
      out = std::min(out, std::max(s, t));
    }
    return in <= out && out > 0.0;
  }
  bool empty() const override { return false; }
  Box bounds() const override {
    Box all{dvec3(1e300), dvec3(-1e300)};
    for (const auto* blocks : {&rooms, &things}) {
      for (const Block& b : *blocks) all = {glm::min(all.min, b.low), glm::max(all.max, b.high)};
    }
    return all;
  }
  std::optional<Met> first(const dvec3& from, const dvec3& d) const override {
    std::optional<Met> nearest;
    const auto add = [&](double t, bool back) {
      if (t > 0.0 && (!nearest || t < nearest->distance)) nearest = Met{t, back, {}, {}};
    };
    double in = 0.0, out = 0.0;
    for (const Block& b : things) {
      if (!slab(b, from, d, in, out)) continue;
      add(in, false);
      if (in <= 0.0) add(out, true);
    }
    for (const Block& b : rooms) {
      if (!slab(b, from, d, in, out)) continue;
      add(in, true);
      if (in <= 0.0) add(out, false);
    }
    return nearest;
  }
  bool blocked(const dvec3& from, const dvec3& to, bool) const override {
    const double length = glm::length(to - from);
    const auto met = first(from, (to - from) / length);
    return met && met->distance < length;
  }
};

struct Rectangle {
  dvec3 middle, u, v, normal;  // half edges
  double radiance = 1.0;
  std::vector<dvec3> corners() const {
    const dvec3 a = glm::dot(glm::cross(u, v), normal) > 0.0 ? u : -u;
    return {middle - a - v, middle + a - v, middle + a + v, middle - a + v};
  }
};

SceneLamp lampOf(const Rectangle& r, std::size_t group) {
  SceneLamp lamp;
  lamp.node = "lamp " + std::to_string(group);
  lamp.corners = r.corners();
  lamp.middle = r.middle;
  lamp.normal = r.normal;
  lamp.radiance = dvec3(r.radiance);
  lamp.area = 4.0 * glm::length(r.u) * glm::length(r.v);
  lamp.power = 3.14159 * lamp.area * r.radiance;
  lamp.group = group;
  return lamp;
}

// Irradiance over pi of a lamp, by the middles of many small pieces of it.
double lampLight(const World* world, const Rectangle& lamp, const dvec3& p, const dvec3& n, int pieces) {
  double sum = 0.0;
  for (int i = 0; i < pieces * pieces; ++i) {
    const dvec3 at = lamp.middle + ((i % pieces + 0.5) * 2.0 / pieces - 1.0) * lamp.u +
                     ((i / pieces + 0.5) * 2.0 / pieces - 1.0) * lamp.v;
    const dvec3 way = at - p;
    const double d2 = glm::dot(way, way);
    const double cosines = std::max(glm::dot(way, n), 0.0) * std::max(-glm::dot(way, lamp.normal), 0.0);
    if (cosines <= 0.0) continue;
    if (world != nullptr) {
      const dvec3 from = p + 1e-4 * n, to = at - from;
      const double length = glm::length(to);
      const auto met = world->first(from, to / length);
      if (met && met->distance < length - 1e-3) continue;
    }
    sum += cosines / (d2 * d2);
  }
  return lamp.radiance * sum * 4.0 * glm::length(lamp.u) * glm::length(lamp.v) / (3.14159265358979 * pieces * pieces);
}

struct FurnishedRoom {
  World world;
  std::vector<Rectangle> lamps;
  Probe probe;
  SceneLamps sceneLamps;
};

FurnishedRoom furnishedRoom(unsigned seed) {
  std::mt19937 random(seed);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  const auto below = [&](int n) { return std::uniform_int_distribution<int>(0, n - 1)(random); };
  FurnishedRoom room;
  const dvec3 size(in(3.0, 7.0), in(2.3, 3.3), in(3.0, 7.0)), low(in(-9, 9), in(-2, 5), in(-9, 9));
  const Block walls{low, low + size};
  room.world.rooms = {walls};
  for (int i = 3 + below(5); i > 0; --i) {
    const dvec3 s(in(0.3, 1.4), in(0.3, 1.6), in(0.3, 1.4));
    const dvec3 at = low + dvec3(in(0.0, size.x - s.x), 0.0, in(0.0, size.z - s.z));
    if (below(3) == 0) {  // a table: a top on legs
      room.world.things.push_back({at + dvec3(0, 0.7, 0), at + dvec3(s.x, 0.76, s.z)});
      for (int leg = 0; leg < 4; ++leg) {
        const dvec3 foot = at + dvec3(leg % 2 * (s.x - 0.06), 0.0, leg / 2 * (s.z - 0.06));
        room.world.things.push_back({foot, foot + dvec3(0.06, 0.7, 0.06)});
      }
    } else {
      room.world.things.push_back({at, at + s});
    }
  }
  for (int i = 1 + below(3); i > 0; --i) {
    Rectangle lamp;
    const dvec3 half(in(0.1, 0.5), 0.0, in(0.1, 0.5));
    lamp.middle =
        low + dvec3(in(half.x + 0.1, size.x - half.x - 0.1), size.y - 0.04, in(half.z + 0.1, size.z - half.z - 0.1));
    lamp.u = {half.x, 0, 0};
    lamp.v = {0, 0, half.z};
    lamp.normal = {0, -1, 0};
    lamp.radiance = in(3.0, 10.0) / (half.x * half.z);
    room.lamps.push_back(lamp);
  }
  room.probe.box = {walls.low, walls.high};
  room.probe.origin = low + dvec3(0.45, 0.8, 0.55) * size;
  for (std::size_t i = 0; i < room.lamps.size(); ++i) room.sceneLamps.lamps.push_back(lampOf(room.lamps[i], i));
  return room;
}

ProbeSight sightOf(const FurnishedRoom& room, double spacing) {
  SightSettings settings;
  settings.spacing = spacing;
  settings.mostNodes = 1000000;
  const std::atomic<bool> cancelled{false};
  return probeSight(room.world, sightTask(Scene{}, room.sceneLamps, room.probe), cancelled, settings);
}

double seen(const ProbeSight& sight, const Probe& probe, int channel, const dvec3& p, const dvec3& n) {
  if (channel < 0) return channel == kSeenByAll ? 1.0 : 0.0;
  const ProbeGeometry geometry = probeGeometry(probe, probe.origin);
  const glm::dmat3 probeFromWorld = glm::transpose(geometry.worldFromProbe);
  const glm::vec3 place = shading::sightPlace(
      sightShape(sight, geometry), glm::vec3(probeFromWorld * (p - probe.origin)), glm::vec3(probeFromWorld * n));
  const float share = sight.lattice.fetchSight(place, channel / 4)[channel % 4];
  return static_cast<double>(shading::sightShare(share, sight.lattice.fetchSight(place, 0).x));
}

double quantile(std::vector<double> values, double share) {
  std::sort(values.begin(), values.end());
  return values[std::min(values.size() - 1, static_cast<std::size_t>(share * static_cast<double>(values.size())))];
}

// Half of all light is the lamps', as where the walls' is exact.
TEST(LampSight, ShadowsInFurnishedRoomsAreNearTheTruth) {
  constexpr int kRooms = 30, kPoints = 150;
  struct Scheme {
    const char* name;
    double spacing;
    std::vector<double> rmse;
  } schemes[] = {{"no shadows", 0.0, {}}, {"nodes every 0.25 m", 0.25, {}}, {"0.125 m", 0.125, {}}};
  for (unsigned seed = 0; seed < kRooms; ++seed) {
    const FurnishedRoom room = furnishedRoom(700 + 13 * seed);
    std::mt19937 random(seed);
    const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    struct Point {
      dvec3 p, n;
      std::vector<double> whole;
      double truth = 0.0;
    };
    std::vector<Point> points;
    double mean = 0.0;
    while (points.size() < kPoints) {  // on what a ray from somewhere in the room meets
      const dvec3 from =
          glm::mix(room.probe.box.min, room.probe.box.max, dvec3(in(0.1, 0.9), in(0.1, 0.9), in(0.1, 0.9)));
      const dvec3 d = glm::normalize(dvec3(in(-1, 1), in(-1, 0.6), in(-1, 1)));
      const auto met = room.world.first(from, d);
      if (!met || met->back) continue;
      Point point;
      point.p = from + met->distance * d;
      double least = 1e300;
      const auto face = [&](const Block& b, double sign) {
        for (int a = 0; a < 3; ++a) {
          for (const double side : {-1.0, 1.0}) {
            const double off = std::abs(point.p[a] - (side < 0 ? b.low[a] : b.high[a]));
            dvec3 n(0.0);
            n[a] = sign * side;
            if (off < least && glm::dot(n, d) < 0.0) {
              least = off;
              point.n = n;
            }
          }
        }
      };
      face(room.world.rooms[0], -1.0);
      for (const Block& b : room.world.things) face(b, 1.0);
      if (least > 1e-9) continue;
      for (const Rectangle& lamp : room.lamps) {
        point.whole.push_back(lampLight(nullptr, lamp, point.p, point.n, 20));
        point.truth += lampLight(&room.world, lamp, point.p, point.n, 20);
      }
      mean += point.truth / kPoints;
      points.push_back(point);
    }
    for (Scheme& scheme : schemes) {
      const ProbeSight sight = scheme.spacing > 0.0 ? sightOf(room, scheme.spacing) : ProbeSight{};
      double square = 0.0;
      for (const Point& point : points) {
        double light = 0.0;
        for (std::size_t i = 0; i < room.lamps.size(); ++i) {
          const double share =
              scheme.spacing > 0.0 ? seen(sight, room.probe, sight.channelOfLamp(i), point.p, point.n) : 1.0;
          light += share * point.whole[i];
        }
        square += (light - point.truth) * (light - point.truth) / kPoints;
      }
      scheme.rmse.push_back(std::sqrt(square) / (2.0 * mean));
    }
  }
  std::printf("| shadows of lamps | relative RMSE of all diffuse light, median | 90 %% |\n|---|---|---|\n");
  for (const Scheme& s : schemes) {
    std::printf("| %s | %.3f | %.3f |\n", s.name, quantile(s.rmse, 0.5), quantile(s.rmse, 0.9));
  }
  EXPECT_LE(quantile(schemes[1].rmse, 0.5), 0.03);
  EXPECT_LE(quantile(schemes[1].rmse, 0.9), 0.08);
  EXPECT_LT(quantile(schemes[2].rmse, 0.5), quantile(schemes[1].rmse, 0.5));
  EXPECT_GT(quantile(schemes[0].rmse, 0.5), 0.05);  // what is judged is hard enough to tell
}

TEST(LampSight, TheSameTwiceAndEndedEarly) {
  const FurnishedRoom room = furnishedRoom(5);
  const ProbeSight once = sightOf(room, 0.3), again = sightOf(room, 0.3);
  EXPECT_EQ(once.lattice.texels, again.lattice.texels);
  EXPECT_EQ(once.rays, again.rays);
  EXPECT_GT(once.rays, 0u);
  const std::atomic<bool> cancelled{true};
  const ProbeSight nothing = probeSight(room.world, sightTask(Scene{}, room.sceneLamps, room.probe), cancelled);
  EXPECT_LT(nothing.rays, once.rays);
}

// A box turned about the world's axes has other nodes, and gives what an upright one gives.
TEST(LampSight, ATurnedBoxSeesTheSame) {
  FurnishedRoom room = furnishedRoom(21);
  const ProbeSight upright = sightOf(room, 0.25);
  Probe turned = room.probe;
  turned.rotationDegrees = {0, 90, 0};
  const dvec3 center = turned.box.center(), half = 0.5 * turned.box.size();
  turned.box = {center - dvec3(half.z, half.y, half.x), center + dvec3(half.z, half.y, half.x)};
  FurnishedRoom other = room;
  other.probe = turned;
  const ProbeSight rotated = sightOf(other, 0.25);
  ASSERT_EQ(rotated.lattice.nodes,
            glm::ivec3(upright.lattice.nodes.z, upright.lattice.nodes.y, upright.lattice.nodes.x));
  std::mt19937 random(3);
  const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
  double worst = 0.0;
  int between = 0;
  for (int i = 0; i < 500; ++i) {
    const dvec3 p = glm::mix(room.probe.box.min, room.probe.box.max, dvec3(in(0, 1), in(0, 1), in(0, 1)));
    const dvec3 n = glm::normalize(dvec3(in(-1, 1), in(-1, 1), in(-1, 1)));
    const double a = seen(upright, room.probe, upright.channelOfLamp(0), p, n);
    const double b = seen(rotated, turned, rotated.channelOfLamp(0), p, n);
    worst = std::max(worst, std::abs(a - b));
    between += a > 0.05 && a < 0.95 ? 1 : 0;
  }
  EXPECT_GT(between, 20);
  EXPECT_LT(worst, 0.02);
}

// Two rooms side by side, 10 cm of wall between them, a lamp in the one; with a doorway, or without.
struct TwoRooms {
  World world;
  SceneLamps lamps;
  Scene scene;
  Probe lit, dark;

  explicit TwoRooms(bool door) {
    const double wall = 0.1;
    world.rooms = {{{-4.0, -1.0, -3.0}, {4.3, 3.0, 3.0}}};  // about both
    const Block between{{0.0, 0.0, -2.1}, {wall, 2.6, 2.4}};
    if (door) {
      world.things = {
          {between.low, {wall, 2.6, -0.5}}, {{0.0, 0.0, 0.4}, between.high}, {{0.0, 2.0, -0.5}, {wall, 2.6, 0.4}}};
    } else {
      world.things = {between};
    }
    // The other walls, as thick.
    const auto shell = [&](double x0, double x1) {
      world.things.push_back({{x0, -0.1, -2.2}, {x1, 0.0, 2.5}});
      world.things.push_back({{x0, 2.6, -2.2}, {x1, 2.7, 2.5}});
      world.things.push_back({{x0, 0.0, -2.2}, {x1, 2.6, -2.1}});
      world.things.push_back({{x0, 0.0, 2.4}, {x1, 2.6, 2.5}});
    };
    shell(-3.2, 3.5);
    world.things.push_back({{-3.2, 0.0, -2.1}, {-3.1, 2.6, 2.4}});
    world.things.push_back({{3.4, 0.0, -2.1}, {3.5, 2.6, 2.4}});
    Rectangle lamp;
    lamp.middle = {1.6, 2.2, 0.1};
    lamp.u = {0.2, 0, 0};
    lamp.v = {0, 0, 0.3};
    lamp.normal = {0, -1, 0};
    lamp.radiance = 40.0;
    lamps.lamps.push_back(lampOf(lamp, 0));
    Light light;
    light.type = LightType::Point;
    light.position = {2.4, 1.4, -0.2};
    light.intensity = 12.0f;
    Light sun;
    scene.lights = {sun, light};
    lit.name = "lit";
    lit.box = {{wall, 0.0, -2.1}, {3.4, 2.6, 2.4}};
    lit.origin = {1.4, 1.2, 0.9};
    dark.name = "dark";
    dark.box = {{-3.1, 0.0, -2.1}, {0.0, 2.6, 2.4}};
    dark.origin = {-1.7, 1.1, 1.3};
  }
  ProbeSight sight(const Probe& probe) const {
    const std::atomic<bool> cancelled{false};
    return probeSight(world, sightTask(scene, lamps, probe), cancelled);
  }
};

TEST(LampSight, AClosedRoomBesideALitOneStaysDark) {
  const TwoRooms rooms(false);
  const ProbeSight lit = rooms.sight(rooms.lit), dark = rooms.sight(rooms.dark);
  EXPECT_EQ(lit.lamps, std::vector<std::size_t>{0});
  EXPECT_NE(lit.channelOfSource(1), kSeenByNone);
  EXPECT_EQ(lit.channelOfSource(0), kSeenByAll) << "suns are not traced";
  EXPECT_TRUE(dark.lamps.empty());
  EXPECT_EQ(dark.channelOfLamp(0), kSeenByNone);
  EXPECT_EQ(dark.channelOfSource(1), kSeenByNone);
  EXPECT_TRUE(dark.lattice.empty());
}

TEST(LampSight, ADoorLetsTheNextRoomsLampIn) {
  const TwoRooms rooms(true);
  const ProbeSight dark = rooms.sight(rooms.dark);
  ASSERT_EQ(dark.lamps, std::vector<std::size_t>{0});
  ASSERT_GE(dark.channelOfLamp(0), 0);
  ASSERT_GE(dark.channelOfSource(1), 0);
  const dvec3 up(0, 1, 0), before(-0.5, 0, -0.05),
      aside(-0.5, 0, 1.9);  // on the floor: before the door, behind the wall
  EXPECT_GT(seen(dark, rooms.dark, dark.channelOfLamp(0), before, up), 0.9);
  EXPECT_LT(seen(dark, rooms.dark, dark.channelOfLamp(0), aside, up), 0.01);
  EXPECT_GT(seen(dark, rooms.dark, dark.channelOfSource(1), before, up), 0.9);
  EXPECT_LT(seen(dark, rooms.dark, dark.channelOfSource(1), aside, up), 0.01);
}

// Of small boxes in the dark room, and in the same turned by 30 degrees: what is said to see nothing of the lamp sees
// nothing anywhere, and little is said to see it that does not.
TEST(LampReach, LeavesOutWhatSeesNothing) {
  const TwoRooms rooms(true);
  for (const double degrees : {0.0, 30.0}) {
    Probe probe = rooms.dark;
    probe.rotationDegrees = {0.0, degrees, 0.0};
    const auto sight = std::make_shared<const ProbeSight>(rooms.sight(probe));
    const int channel = sight->channelOfLamp(0);
    ASSERT_GE(channel, 0);
    std::mt19937 random(11);
    const auto in = [&](double a, double b) { return std::uniform_real_distribution<double>(a, b)(random); };
    LampReach reach;
    int hidden = 0, shown = 0, idle = 0;
    for (int i = 0; i < 300; ++i) {
      const dvec3 low(in(-3.3, -0.4), in(-0.1, 2.2), in(-2.2, 2.0)), size(in(0.0, 0.5), in(0.0, 0.3), in(0.0, 0.6));
      const std::array<double, 6> bounds = {low.x, low.x + size.x, low.y, low.y + size.y, low.z, low.z + size.z};
      const bool said = reach.seen(sight, channel, bounds);
      EXPECT_EQ(said, seenWithin(*sight, channel, bounds));
      EXPECT_EQ(said, reach.seen(sight, channel, bounds)) << "asked again";
      double most = 0.0;
      for (int k = 0; k < 40; ++k) {
        const dvec3 n = glm::normalize(dvec3(in(-1, 1), in(-1, 1), in(-1, 1)));
        most = std::max(most, seen(*sight, probe, channel, low + size * dvec3(in(0, 1), in(0, 1), in(0, 1)), n));
      }
      if (!said) {
        EXPECT_EQ(most, 0.0) << i;
      }
      hidden += said ? 0 : 1;
      shown += most > 0.0 ? 1 : 0;
      idle += said && most <= 0.0 ? 1 : 0;
    }
    std::printf("  %g degrees: %d hidden, %d shown, %d for nothing\n", degrees, hidden, shown, idle);
    EXPECT_GT(hidden, 30);
    EXPECT_GT(shown, 40);
    EXPECT_LT(idle, 100);
    EXPECT_FALSE(reach.seen(sight, kSeenByNone, {-1.0, -0.9, 0.0, 0.1, 0.0, 0.2}));
    EXPECT_TRUE(reach.seen(sight, kSeenByAll, {-1.0, -0.9, 0.0, 0.1, 0.0, 0.2}));
  }
  EXPECT_TRUE(LampReach().seen(nullptr, 1, {-1.0, -0.9, 0.0, 0.1, 0.0, 0.2})) << "nothing is traced";
}

// Nothing stands in the room: no lattice, no fetch.
TEST(LampSight, WhatNothingHidesTakesNoLattice) {
  FurnishedRoom room = furnishedRoom(8);
  room.world.things.clear();
  const ProbeSight sight = sightOf(room, 0.25);
  EXPECT_TRUE(sight.lattice.empty());
  EXPECT_EQ(sight.unshadowed, room.lamps.size());
  for (std::size_t i = 0; i < room.lamps.size(); ++i) EXPECT_EQ(sight.channelOfLamp(i), kSeenByAll);
}

TEST(LampSight, NodesAreBounded) {
  EXPECT_EQ(sightNodes({6.0, 3.0, 5.0}), glm::ivec3(25, 13, 21));
  for (const dvec3& size :
       {dvec3(60.0, 20.0, 80.0), dvec3(4000.0, 3.0, 0.1), dvec3(1e30, 1.0, 2.0), dvec3(9.0, 9.0, 9.0)}) {
    const glm::ivec3 n = sightNodes(size);
    EXPECT_LE(n.x * n.y * n.z, 32768);
    EXPECT_LE(std::max({n.x, n.y, n.z}), SightLattice::kMostNodes);
    EXPECT_GE(std::min({n.x, n.y, n.z}), 2);
  }
  EXPECT_EQ(sightNodes(dvec3(0.0)), glm::ivec3(2));
  EXPECT_EQ(sightNodes(dvec3(std::nan(""))), glm::ivec3(2));
  EXPECT_EQ(sightNodes({0.008, 0.004, 0.006}), glm::ivec3(17, 9, 13));  // a room of millimetres
}

// Where an influence goes on through a door so do the nodes, and only there.
TEST(ProbeReach, GoesThroughOpeningsOnly) {
  TwoRooms rooms(true);
  rooms.lit.influence = {{-0.15, -0.3, -2.25}, {3.7, 2.7, 2.5}};  // beyond by .25, .3, .15; .3, .1, .1
  const SightTask task = sightTask(rooms.scene, rooms.lamps, rooms.lit);
  EXPECT_NEAR(task.reach.low.x, 0.25, 1e-12);
  EXPECT_NEAR(task.reach.low.y, 0.3, 1e-12);
  EXPECT_NEAR(task.reach.low.z, 0.15, 1e-12);
  EXPECT_NEAR(task.reach.high.x, 0.3, 1e-12);
  EXPECT_EQ(task.reach.high.y, 0.0) << "a wall's skin";
  EXPECT_EQ(task.reach.high.z, 0.0);
  const Box open = openBox(rooms.world, task);
  EXPECT_NEAR(open.min.x, -0.15, 1e-12);
  EXPECT_NEAR(open.max.x, 3.4, 1e-12);
  EXPECT_NEAR(open.min.y, 0.0, 1e-12);
  EXPECT_NEAR(open.min.z, -2.1, 1e-12);
  EXPECT_NEAR(open.max.z, 2.4, 1e-12);
  const TwoRooms closed(false);
  EXPECT_EQ(openBox(closed.world, task), rooms.lit.box);

  // A box that is turned about its middle reaches along its own axes.
  rooms.lit.rotationDegrees = {0, 180, 0};
  rooms.lit.influence = {{0.05, 0.0, -2.1}, {3.75, 2.6, 2.4}};
  const Box turned = openBox(rooms.world, sightTask(rooms.scene, rooms.lamps, rooms.lit));
  EXPECT_NEAR(turned.min.x, -0.25, 1e-12);
  EXPECT_NEAR(turned.max.x, 3.4, 1e-12);

  // Farther than a wall is thick there is more to light: as far as there are surfaces, whatever stands between.
  rooms.lit.rotationDegrees = {};
  rooms.lit.influence = {{-5.0, -0.9, -2.1}, {3.4, 2.6, 3.6}};
  for (const World* world : {&std::as_const(rooms.world), &closed.world}) {
    const Box next = openBox(*world, sightTask(rooms.scene, rooms.lamps, rooms.lit));
    EXPECT_NEAR(next.min.x, -4.0, 1e-12) << "the walls around both";
    EXPECT_NEAR(next.max.x, 3.4, 1e-12);
    EXPECT_NEAR(next.min.y, -0.9, 1e-12) << "the influence ends before them";
    EXPECT_NEAR(next.max.z, 3.0, 1e-12);
  }
}

// Nodes that have to light too much would stand too far apart.
TEST(ProbeReach, IsBoundedByTheBox) {
  TwoRooms rooms(false);
  rooms.world.things.push_back({{-40.0, 0.0, -30.0}, {20.0, 0.1, 50.0}});
  rooms.lit.influence = {{-100.0, 0.0, -2.1}, {100.0, 2.6, 100.0}};
  const Box open = openBox(rooms.world, sightTask(rooms.scene, rooms.lamps, rooms.lit));
  // 3.3 x 2.6 x 4.5: five times the shortest side. Of 40.1 and 16.6 along x, both by the same share.
  EXPECT_NEAR(open.size().x, 13.0, 1e-12);
  EXPECT_NEAR(open.size().z, 13.0, 1e-12);
  EXPECT_NEAR((0.1 - open.min.x) / (open.max.x - 3.4), 40.1 / 16.6, 1e-9);
  EXPECT_NEAR(open.min.z, -2.1, 1e-12);
  EXPECT_NEAR(open.size().y, 2.6, 1e-12);
}

// Within the door, between both boxes, nodes tell the lamp's light from its shadow as rays do.
TEST(ProbeReach, ADoorwayHasNodesOfItsOwn) {
  TwoRooms rooms(true);
  // A board hides the lamp from the farther half of the doorway's depth, and not from the nearer one.
  rooms.world.things.push_back({{0.39, 0.88, -0.6}, {0.41, 1.4, 0.55}});
  const auto error = [&](bool reaches) {
    if (reaches) rooms.lit.influence = {{-0.2, 0.0, -2.1}, {3.4, 2.6, 2.4}};
    const std::atomic<bool> cancelled{false};
    SightTask task = sightTask(rooms.scene, rooms.lamps, rooms.lit);
    task.box = openBox(rooms.world, task);
    const ProbeSight sight = probeSight(rooms.world, task, cancelled);
    double sum = 0.0;
    int count = 0;
    for (int i = 0; i < 64; ++i) {
      const dvec3 p(-0.15 + 0.2 * (i % 8) / 7.0, 0.4, -0.45 + 0.8 * static_cast<double>(i / 8) / 7.0);
      const dvec3 towards = rooms.lamps.lamps[0].middle;
      const double due = rooms.world.blocked(p, towards, true) ? 0.0 : 1.0;
      const double share = seen(sight, rooms.lit, sight.channelOfLamp(0), p, {0, 1, 0});
      sum += (share - due) * (share - due);
      ++count;
    }
    return std::sqrt(sum / count);
  };
  const double before = error(false), after = error(true);
  std::printf("  error of the lamp's share within the doorway: %.3f, without nodes of its own %.3f\n", after, before);
  EXPECT_LT(after, 0.85 * before);
}

}  // namespace
