// Fits the constants of the footprint techniques to this project's prefilter, and prints them as they stand in
// shaders/technique:
//   fit_footprints 4 [STEPS]
// Rooms of its own; tests judge the result in others. What is minimised: the error of display values and that of linear
// light, each relative to the HDRP form's, and light gained or lost at any roughness and view angle. By random search:
// a child of the best so far, in steps that grow when one succeeds and shrink when it fails. One point has a form of
// its own, which the technique has with the constants it started from: what the fit found kept the light better and the
// display values worse.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <string>

#include "filters/math/technique_table.h"
#include "tests/unit/box_room.h"

namespace {

using namespace boxprobe;

constexpr int kRays = 1024;
constexpr int kPointsEach = 100;
constexpr int kFaceSize = 128;
// Of the light in a bucket may be off without a penalty; one or two points cannot hold more.
constexpr double kLightFreelyFew = 0.06, kLightFreely = 0.02;
constexpr int kBuckets = 12;  // six roughnesses, two ranges of view angle

struct Point {
  shading::ShadingPoint point;
  shading::ProbeShape probe;
  const CubeMap* chain;
  glm::dvec3 truth;
  std::size_t bucket;
};

std::vector<Point> trainingPoints(std::vector<CubeMap>& chains) {
  const std::vector<test::BoxRoom> rooms = {{{-3.0, -1.5, -2.0}, {3.0, 1.5, 4.0}, 8.0, 0.1, 15.0},
                                            {{-1.0, -1.2, -1.5}, {3.5, 1.8, 1.0}, 5.0, 0.2, 5.0},
                                            {{-6.0, -1.7, -2.0}, {5.0, 1.1, 3.0}, 7.0, 0.05, 40.0},
                                            {{-1.5, -2.0, -1.8}, {1.7, 2.2, 1.6}, 3.0, 0.12, 10.0}};
  const std::array<float, 6> roughnesses = {0.07f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f};
  std::mt19937 random(3);
  for (const auto& room : rooms) chains.push_back(test::prefilteredRoom(room, kFaceSize));
  std::vector<Point> points;
  for (std::size_t i = 0; i < rooms.size(); ++i) {
    for (std::size_t r = 0; r < roughnesses.size(); ++r) {
      for (int k = 0; k < kPointsEach; ++k) {
        Point p{};
        p.point = test::pointInRoom(rooms[i], roughnesses[r], k, random);
        p.probe.boxMin = glm::vec3(rooms[i].low);
        p.probe.boxMax = glm::vec3(rooms[i].high);
        p.probe.maxLevel = chains[i].maxLevel();
        p.probe.projection = parseTechnique("box")->projection;
        p.probe.parameters = standardParameters();
        p.chain = &chains[i];
        p.truth = test::reflectedMean(rooms[i], chains[i], p.point, kRays);
        p.bucket = 2 * r + (glm::dot(p.point.normal, p.point.view) < 0.4f ? 1 : 0);
        points.push_back(p);
      }
    }
  }
  return points;
}

// Points on the axis of the disk, and pairs beside it. Constants: size, bias, scale and shift, each linear in alpha;
// then u, v and weight of each point (without u on the axis).
struct Layout {
  int points, single, pairs;
};
constexpr std::array<Layout, 4> kLayouts = {{{2, 2, 0}, {4, 2, 1}, {8, 2, 3}, {16, 2, 7}}};

using Constants = std::vector<double>;

std::vector<double> start(int points) {
  const double size = points == 2 ? 1.9 : points == 4 ? 1.6 : points == 8 ? 1.06 : 1.3;
  Constants c = {size, 0.0, -0.4, -0.2, 1.0, -0.2, 0.0, 0.2};
  const auto add = [&c](std::initializer_list<double> v) { c.insert(c.end(), v); };
  if (points == 2) add({-0.71, 0.57, 0.29, 1.43});
  if (points == 4) add({-0.83, 0.55, 0.62, 1.37, 0.5, -0.2, 1.04});
  if (points == 8) add({-0.91, 0.62, 0.46, 0.84, 0.44, 0.03, 1.13, 0.44, -0.48, 1.04, 0.63, 0.54, 1.09});
  if (points == 16) {
    add({-0.78, 0.85, 0.5, 1.01, 0.2, -0.03, 0.85, 0.24, -0.44, 1.05, 0.39, 0.26, 1.2, 0.7, -0.19, 1.21});
    add({0.4, 0.66, 1.21, 0.83, 0.38, 0.84, 0.6, -0.72, 0.71});
  }
  if (points == 1) c = {1.85, -1.75, 1.55, -0.4, -0.4, 0.0, 0.0};
  return c;
}

glm::dvec3 evaluate(int points, const Constants& c, const Point& p) {
  const auto f = [](double x) { return static_cast<float>(x); };
  const double a = static_cast<double>(p.point.roughness) * static_cast<double>(p.point.roughness);
  if (points == 1) {
    const double nv = std::clamp(static_cast<double>(glm::dot(p.point.normal, p.point.view)), 0.0, 1.0);
    return glm::dvec3(shading::footprintMean(p.chain, p.probe, p.point, f(a * (c[0] + c[1] * nv)),
                                             f(a * a * (c[2] + c[3] * a + c[6] * (1.0 - nv))), f(c[4] + c[5] * a)));
  }
  shading::FootprintLobe lobe = shading::footprintLobe(p.point, static_cast<float>(points));
  lobe.size *= f(c[0] + c[1] * a);
  lobe.bias = f(c[2] + c[3] * a);
  lobe.scale = f(c[4] + c[5] * a);
  lobe.shift = f(c[6] + c[7] * a);
  const auto layout =
      *std::find_if(kLayouts.begin(), kLayouts.end(), [=](const Layout& l) { return l.points == points; });
  shading::FootprintSum sum = shading::footprintStart();
  const double* at = &c[8];
  for (int i = 0; i < layout.single; ++i, at += 2) {
    sum = shading::footprintAdd(p.chain, p.probe, p.point, lobe, sum, 0.0f, f(at[0]), f(at[1]));
  }
  for (int i = 0; i < layout.pairs; ++i, at += 3) {
    sum = shading::footprintAddPair(p.chain, p.probe, p.point, lobe, sum, f(at[0]), f(at[1]), f(at[2]));
  }
  return glm::dvec3(sum.value / sum.weight);
}

struct Judged {
  test::ErrorTally all;
  std::array<test::ErrorTally, kBuckets> buckets;
  double worstLight() const {
    double worst = 0.0;
    for (const auto& b : buckets) worst = std::max(worst, std::abs(b.lightRatio() - 1.0));
    return worst;
  }
};

template <typename Evaluate>
Judged judge(const std::vector<Point>& points, const Evaluate& value) {
  Judged result;
  for (const Point& p : points) {
    const glm::dvec3 v = value(p);
    result.all.add(v, p.truth);
    result.buckets[p.bucket].add(v, p.truth);
  }
  return result;
}

double loss(int points, const Judged& j, const Judged& hdrp) {
  const double freely = points <= 2 ? kLightFreelyFew : kLightFreely;
  double penalty = 0.0;
  for (const auto& b : j.buckets) penalty += std::pow(std::max(std::abs(b.lightRatio() - 1.0) - freely, 0.0), 2.0);
  return std::pow(j.all.rmse() / hdrp.all.rmse(), 2.0) +
         0.5 * std::pow(j.all.relativeRmse() / hdrp.all.relativeRmse(), 2.0) + penalty;
}

void print(const char* what, const Judged& j, const Judged& hdrp) {
  std::printf("%s: error / hdrp %.3f, relative RMSE %.3f, light off by at most %.3f\n", what,
              j.all.rmse() / hdrp.all.rmse(), j.all.relativeRmse(), j.worstLight());
}

}  // namespace

int main(int argc, char** argv) {
  const int points = argc > 1 ? std::atoi(argv[1]) : 0;
  const int steps = argc > 2 ? std::atoi(argv[2]) : 1000;
  if (points != 1 && points != 2 && points != 4 && points != 8 && points != 16) {
    std::fprintf(stderr, "usage: fit_footprints 1|2|4|8|16 [STEPS]\n");
    return 2;
  }
  std::vector<CubeMap> chains;
  const std::vector<Point> training = trainingPoints(chains);
  const auto hdrpRow = evaluationRows()[static_cast<std::size_t>(parseTechnique("hdrp")->evaluation)].evaluate;
  const Judged hdrp = judge(training, [&](const Point& p) { return glm::dvec3(hdrpRow(p.chain, p.probe, p.point)); });
  Constants best = start(points);
  const auto judged = [&](const Constants& c) {
    return judge(training, [&](const Point& p) { return evaluate(points, c, p); });
  };
  print("start", judged(best), hdrp);
  double least = loss(points, judged(best), hdrp);
  double step = 0.1;
  std::mt19937 random(9);
  std::normal_distribution<double> gauss;
  std::uniform_real_distribution<double> unit(0.0, 1.0);
  for (int i = 0; i < steps; ++i) {
    Constants c = best;
    for (double& x : c) {
      if (unit(random) < 0.4) x += step * gauss(random);  // a few at a time: more successes
    }
    const double l = loss(points, judged(c), hdrp);
    if (l < least) {
      least = l;
      best = c;
      step = std::min(step * 1.5, 0.3);
    } else {
      step = std::max(step * 0.93, 0.004);
    }
    if (i % 100 == 99) std::fprintf(stderr, "%d: %.5f\n", i + 1, least);
  }
  print("fitted", judged(best), hdrp);
  for (const double x : best) std::printf("%.3f ", x);
  std::printf("\n");
  return 0;
}
