// What the renderer and its explanations say of the odd room (tests/support/odd_room.h), held against the formulas
// themselves: written here once more in long double, from their definitions. Shares nothing with shaders/shared, which
// the GPU, the explanation and the references all compile.
#include "tests/support/odd_room.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <vector>

#include "tests/image/quad_world.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

using Real = long double;
using Vec = std::array<Real, 3>;
using ::testing::ElementsAre;

constexpr int kColumns = 48, kRows = 27;
constexpr Real kPi = 3.14159265358979323846264338327950288L;

Vec vec(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}
Real dot(const Vec& a, const Vec& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/// A direction of the world in the axes of a box that was turned about X, then Y, then Z.
Vec unturned(Vec v, const glm::dvec3& degrees) {
  for (const int axis : {2, 1, 0}) {
    const Real angle = -degrees[axis] * kPi / 180.0L, c = std::cos(angle), s = std::sin(angle);
    const int u = (axis + 1) % 3, w = (axis + 2) % 3;
    const Real x = v[static_cast<std::size_t>(u)], y = v[static_cast<std::size_t>(w)];
    v[static_cast<std::size_t>(u)] = c * x - s * y;
    v[static_cast<std::size_t>(w)] = s * x + c * y;
  }
  return v;
}

/// A place of the world in the box's own coordinates: the box turns about its middle.
Vec inBox(const glm::dvec3& world, const Probe& probe) {
  const glm::dvec3 middle = 0.5 * (probe.box.min + probe.box.max);
  Vec v = unturned(vec(world - middle), probe.rotationDegrees);
  for (int i = 0; i < 3; ++i) v[static_cast<std::size_t>(i)] += middle[i];
  return v;
}

/// data/scenes/README.md: the weight rises from 0 to 1 over the blend distance inside each face, smoothly, and the
/// faces' weights multiply. The box is larger by 1/10,000 of its longest side, so that what lies in a face counts.
Real influenceOf(const Probe& probe, const glm::dvec3& world) {
  const Vec at = inBox(world, probe);
  const Box& box = probe.influence ? *probe.influence : probe.box;
  const glm::dvec3 size = box.max - box.min;
  const Real skin = 1e-4L * std::max({size.x, size.y, size.z});
  Real weight = 1.0L;
  for (int i = 0; i < 3; ++i) {
    const Real x = at[static_cast<std::size_t>(i)];
    const std::pair<Real, Real> sides[] = {{x - box.min[i] + skin, probe.blendDistance.min[i]},
                                           {box.max[i] - x + skin, probe.blendDistance.max[i]}};
    for (const auto& [inside, blend] : sides) {
      const Real t = std::clamp(inside / blend, 0.0L, 1.0L);
      weight *= t * t * (3.0L - 2.0L * t);
    }
  }
  return weight;
}

/// The more important takes its share of what is left first; equal ones with a sum s below 1 take s (1 + s - s²) of it
/// in all, in proportion to their weights, and everything from 1 on.
std::map<std::string, Real> sharesOf(const Scene& scene, const glm::dvec3& world, Real& sky) {
  std::map<double, std::vector<const Probe*>, std::greater<>> ranks;
  for (const Probe& probe : scene.probes) ranks[probe.importance].push_back(&probe);
  std::map<std::string, Real> shares;
  sky = 1.0L;
  for (const auto& [rank, probes] : ranks) {
    Real sum = 0.0L;
    for (const Probe* probe : probes) sum += influenceOf(*probe, world);
    const Real taken = sum >= 1.0L ? 1.0L : sum * (1.0L + sum - sum * sum);
    for (const Probe* probe : probes) {
      shares[probe->name] = sum > 0.0L ? sky * taken * influenceOf(*probe, world) / sum : 0.0L;
    }
    sky *= 1.0L - taken;
  }
  return shares;
}

std::vector<Explanation> explained(ScenePicture& picture) {
  std::vector<glm::ivec2> pixels;
  for (int y = 0; y < kRows; ++y) {
    for (int x = 0; x < kColumns; ++x) pixels.emplace_back(x, y);
  }
  return picture.renderer->explain(pixels, kColumns, kRows);
}

ScenePicture shownRoom(const OddRoom& room) {
  ScenePicture picture(room.scene, kColumns, kRows);
  picture.renderer->setModels({room.model});
  picture.renderer->sync(picture.scene, Changes::all());
  picture.renderer->applyCamera(room.scene.cameras.front());
  picture.renderer->finishWork();
  EXPECT_EQ(picture.renderer->error(), "");
  return picture;
}

class OddRoomForms : public ::testing::TestWithParam<LampForm> {};

TEST_P(OddRoomForms, WeightsHitsAndPixelsFollowTheFormulas) {
  OddRoom room = oddRoom();
  room.scene.lamps = GetParam();
  ScenePicture picture = shownRoom(room);
  std::size_t weighed = 0, between = 0, hits = 0;
  Real farthestWeight = 0.0L, farthestShare = 0.0L, farthestHit = 0.0L, farthestRay = 0.0L;
  float farthestColor = 0.0f;
  for (const Explanation& e : explained(picture)) {
    if (!e.hit) continue;
    const glm::dvec3 place = e.surface.positionWorld;
    Real sky = 0.0L;
    std::map<std::string, Real> shares = sharesOf(room.scene, place, sky);
    const Vec n = vec(e.lookupNormal), v = vec(e.surface.viewWorld);
    const Real nv = dot(n, v);
    for (const ProbeExplanation& p : e.probes) {
      const Probe& probe = room.scene.probes[static_cast<std::size_t>(p.index)];
      EXPECT_EQ(probe.name, p.name);
      ++weighed;
      const Real influence = influenceOf(probe, place);
      between += influence > 0.01L && influence < 0.99L ? 1 : 0;
      farthestWeight = std::max(farthestWeight, std::abs(influence - static_cast<Real>(p.influence)));
      farthestShare = std::max(farthestShare, std::abs(shares[p.name] - static_cast<Real>(p.weight)));
      shares.erase(p.name);
      if (nv <= 0.05L || !p.hitDistance) continue;
      // R = 2 (N.V) N - V; the box is left by the nearest of the planes ahead.
      glm::dvec3 reflected;
      for (int i = 0; i < 3; ++i) {
        reflected[i] = static_cast<double>(2.0L * nv * n[static_cast<std::size_t>(i)] - v[static_cast<std::size_t>(i)]);
      }
      farthestRay = std::max(farthestRay, static_cast<Real>(glm::length(reflected - glm::dvec3(e.reflectionWorld))));
      const Vec from = inBox(place, probe), ray = unturned(vec(reflected), probe.rotationDegrees);
      Real distance = 1e30L;
      bool inside = true;
      for (std::size_t i = 0; i < 3; ++i) {
        const int axis = static_cast<int>(i);
        inside = inside && from[i] >= probe.box.min[axis] && from[i] <= probe.box.max[axis];
        const Real wall = ray[i] > 0.0L ? probe.box.max[axis] : probe.box.min[axis];
        if (ray[i] != 0.0L) distance = std::min(distance, (wall - from[i]) / ray[i]);
      }
      if (!inside) continue;
      ++hits;
      farthestHit = std::max(farthestHit, std::abs(distance - static_cast<Real>(*p.hitDistance)));
    }
    // Those that the draw has left out give nothing here.
    for (const auto& [name, share] : shares) farthestShare = std::max(farthestShare, share);
    if (!e.surface.transmission) {
      farthestShare = std::max(farthestShare, std::abs(sky - static_cast<Real>(e.skyWeight)));
      const float scale = std::max({1.0f, e.brightestTexel, e.color.x, e.color.y, e.color.z});
      for (int c = 0; c < 3; ++c) {
        farthestColor = std::max(farthestColor, std::abs(e.color[c] - (*e.rendered)[c]) / scale);
      }
    }
  }
  std::printf("%zu weights, %zu of them between 0 and 1, %zu hits; off by %.1Lg, shares by %.1Lg, hits by %.1Lg m\n",
              weighed, between, hits, farthestWeight, farthestShare, farthestHit);
  EXPECT_GE(between, 700u);
  EXPECT_GE(hits, 1000u);
  EXPECT_LE(farthestWeight, 2e-5L);
  EXPECT_LE(farthestShare, 4e-5L);
  EXPECT_LE(farthestRay, 1e-5L);
  EXPECT_LE(farthestHit, 2e-5L);
  EXPECT_LE(farthestColor, 2e-3f) << "the picture is not what is explained";
}

INSTANTIATE_TEST_SUITE_P(OddRoom, OddRoomForms, ::testing::Values(LampForm::InMap, LampForm::Shapes));

// Of two impostors on one surface the second finds its own distances: where the first has no weight, it shows what it
// shows alone.
TEST(OddRoom, ASecondImpostorHasItsOwnDistances) {
  OddRoom room = oddRoom();
  room.scene.sky = SkyColor{};
  room.scene.probes.pop_back();  // the turned one
  for (Probe& probe : room.scene.probes) {
    probe.technique = "impostor";
    probe.faceSize = 64;
  }
  room.scene.probes[0].importance = 3.0;  // comes first in every draw
  room.scene.probes[0].influence = Box{{-2.5, 0.0, -1.9}, {0.35, 3.1, 2.8}};
  room.scene.probes[1].influence = Box{{-2.5, 0.0, -1.9}, {3.3, 3.1, 2.8}};
  ScenePicture both = shownRoom(room);
  OddRoom single = room;
  single.scene.probes.erase(single.scene.probes.begin());
  ScenePicture alone = shownRoom(single);
  const auto here = explained(both), there = explained(alone);
  int compared = 0;
  float farthest = 0.0f;
  bool moved = false;
  for (std::size_t i = 0; i < here.size(); ++i) {
    const Explanation& e = here[i];
    if (!e.hit || e.glass || e.probes.size() != 2 || e.probes[0].influence > 0.0f || there[i].probes.empty()) continue;
    ++compared;
    moved = moved || (e.probes[1].boxDistance && *e.probes[1].boxDistance != *e.probes[1].hitDistance);
    for (int c = 0; c < 3; ++c) farthest = std::max(farthest, std::abs((*e.rendered)[c] - (*there[i].rendered)[c]));
  }
  EXPECT_GE(compared, 100);
  EXPECT_TRUE(moved) << "no ray is refined: the distances do not show";
  EXPECT_LE(farthest, 1e-4f);
}

// An object that takes one probe of two that suit it alike takes the first by name, whichever order the file has.
TEST(OddRoom, OfEqualProbesTheFirstByNameIsTaken) {
  for (const bool turnedRound : {false, true}) {
    OddRoom room = oddRoom();
    Probe first = room.scene.probes[0];
    first.influence.reset();
    Probe second = first;
    second.name = "aa";
    second.origin.x += 0.7;
    room.scene.probes = {first, second};
    if (turnedRound) std::swap(room.scene.probes[0], room.scene.probes[1]);
    for (const char* node : {"floor", "pillar"}) room.scene.objects[node].probeUsage = ProbeUsage::Simple;
    ScenePicture picture = shownRoom(room);
    int seen = 0;
    for (const Explanation& e : explained(picture)) {
      if (!e.hit || (e.surface.object != "floor" && e.surface.object != "pillar")) continue;
      ++seen;
      ASSERT_EQ(e.probes.size(), 1u);
      ASSERT_EQ(e.probes[0].name, "a");
    }
    EXPECT_GE(seen, 100);
  }
}

/// The split sum of GGX with height-correlated Smith masking by brute force: what F0 and F90 are multiplied by.
std::pair<Real, Real> splitSumOf(Real nv, Real roughness) {
  const Real alpha = roughness * roughness, a2 = alpha * alpha, sine = std::sqrt(1.0L - nv * nv);
  const auto lambda = [a2](Real cosine) {
    const Real c2 = cosine * cosine;
    return (std::sqrt(1.0L + a2 * (1.0L - c2) / c2) - 1.0L) / 2.0L;
  };
  constexpr int kAround = 256, kDown = 512;
  Real a = 0.0L, b = 0.0L;
  for (int i = 0; i < kDown; ++i) {
    // Half vectors in proportion to D (N.H): cos² = (1 - u) / (1 + (a2 - 1) u).
    const Real u = (i + 0.5L) / kDown, nh2 = (1.0L - u) / (1.0L + (a2 - 1.0L) * u), nh = std::sqrt(nh2);
    const Real hSine = std::sqrt(std::max(1.0L - nh2, 0.0L));
    for (int j = 0; j < kAround; ++j) {
      const Real phi = 2.0L * kPi * (j + 0.5L) / kAround;
      const Real vh = sine * hSine * std::cos(phi) + nv * nh;
      const Real nl = 2.0L * vh * nh - nv;
      if (vh <= 0.0L || nl <= 0.0L) continue;
      const Real masking = 1.0L / (1.0L + lambda(nv) + lambda(nl));
      const Real weight = masking * vh / (nv * nh), grazing = std::pow(1.0L - vh, 5.0L);
      a += weight * (1.0L - grazing);
      b += weight * grazing;
    }
  }
  return {a / (kAround * kDown), b / (kAround * kDown)};
}

// In light of 1 from everywhere a coat shows its own split sum and takes Schlick's reflectance from what lies below.
TEST(OddRoom, ACoatInEvenLightFollowsTheFormulasAtEveryAngle) {
  const auto floorOf = [](float coat, float coatRoughness) {
    Material base;
    base.baseColor = {0.53f, 0.31f, 0.17f, 1.0f};
    base.metallic = 1.0f;
    base.roughness = 0.62f;
    base.coat = coat;
    base.coatRoughness = coatRoughness;
    Model model;
    addSquare(model, "floor", glm::vec3(0.0f), {40.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -40.0f}, base);
    return model;
  };
  Scene scene;
  scene.sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  const float coat = 0.83f, roughness = 0.27f;
  QuadWorld bare(scene, {floorOf(0.0f, 0.0f)}), coated(scene, {floorOf(coat, roughness)});
  bare.show();
  coated.show();
  for (const double elevation : {7.0, 19.0, 43.0, 71.0}) {
    SCOPED_TRACE(elevation);
    const double angle = elevation * 3.14159265358979 / 180.0;
    const glm::dvec3 from(6.0 * std::cos(angle), 6.0 * std::sin(angle), 0.0);
    const glm::vec3 below = bare.look(from, {0, 0, 0}), seen = coated.look(from, {0, 0, 0});
    const Real nv = std::sin(static_cast<Real>(angle)), fresnel = 0.04L + 0.96L * std::pow(1.0L - nv, 5.0L);
    const auto [a, b] = splitSumOf(nv, roughness);
    for (int c = 0; c < 3; ++c) {
      const Real expected = static_cast<Real>(below[c]) * (1.0L - coat * fresnel) + coat * (0.04L * a + b);
      EXPECT_NEAR(static_cast<double>(seen[c]), static_cast<double>(expected), 4e-3) << c;
    }
    const auto [baseA, baseB] = splitSumOf(nv, 0.62L);
    EXPECT_NEAR(static_cast<double>(below[0]), static_cast<double>(0.53L * baseA + baseB), 4e-3);
  }
}

}  // namespace
}  // namespace boxprobe::test
