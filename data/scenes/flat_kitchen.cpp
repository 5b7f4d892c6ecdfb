// The kitchen's pieces; see flat_furniture.h.
#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/trigonometric.hpp>

#include "data/scenes/flat_furniture.h"
#include "data/scenes/picture.h"
#include "data/scenes/soft_shapes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kTwoPi = 6.283185307179586;
constexpr double kTop = 0.90, kDepth = 0.61;

void addHandle(const Pen& metal, glm::dvec3 from, glm::dvec3 to, glm::dvec3 out) {
  metal.add(tube({from + out, to + out}, {0.006, 0.006}, 10));
  const glm::dvec3 in = 0.06 * (to - from);
  metal.add(tube({from + in, from + in + out}, {0.0045, 0.0045}, 8));
  metal.add(tube({to - in, to - in + out}, {0.0045, 0.0045}, 8));
}

void addJar(Home& home, int material, int lid, const glm::dmat4& placed, glm::dvec3 at, double radius, double height) {
  const glm::dmat4 frame = glm::translate(placed, at);
  const Pen pen = home.pen("jars", material, frame);
  pen.add(
      turned({{{0.0, 0.0}, {0.94 * radius, 0.0}},
              {{0.94 * radius, 0.0}, {radius, 0.05 * height}, {radius, 0.8 * height}, {0.86 * radius, 0.9 * height}},
              {{0.86 * radius, 0.9 * height}, {0.0, 0.9 * height}}},
             24));
  home.pen("jars", lid, frame)
      .add(turned({{{0.90 * radius, 0.895 * height}, {0.90 * radius, 0.99 * height}},
                   {{0.90 * radius, 0.99 * height}, {0.0, height}}},
                  24));
  pen.hide({-0.8 * radius, 0.0, -0.8 * radius}, {0.8 * radius, height, 0.8 * radius});
}

void addBowl(const Pen& pen, double radius, double height) {
  pen.add(
      turned({{{0.0, 0.0}, {0.45 * radius, 0.0}},
              {{0.45 * radius, 0.0}, {0.76 * radius, 0.25 * height}, {0.94 * radius, 0.6 * height}, {radius, height}},
              {{radius, height},
               {0.96 * radius, height},
               {0.88 * radius, 0.6 * height},
               {0.66 * radius, 0.25 * height},
               {0.0, 0.12 * height}}},
             36));
  pen.hide({-0.7 * radius, 0.0, -0.7 * radius}, {0.7 * radius, 0.8 * height, 0.7 * radius});
}

}  // namespace

void addKitchenCounter(Home& home, const FlatMaterials& m, const glm::dmat4& placed, double length) {
  const Pen fronts = home.pen("kitchen", m.cabinet, placed), dark = home.pen("kitchen", m.black, placed);
  const Pen metal = home.pen("kitchen handles", m.steel, placed);
  dark.box({0.0, 0.0, 0.02}, {length, 0.10, kDepth - 0.08}, 0.002);
  dark.box({0.002, 0.10, 0.01}, {length - 0.002, 0.855, kDepth - 0.035}, 0.002);
  const int units = static_cast<int>(std::lround(length / 0.6));
  const double unit = length / units, oven = units - 2;
  for (int i = 0; i < units; ++i) {
    const double left = unit * i + 0.002, right = unit * (i + 1) - 0.002;
    const auto front = [&](double low, double high) {
      fronts.box({left, low, kDepth - 0.033}, {right, high, kDepth - 0.012}, 0.003);
      addHandle(metal, {0.5 * (left + right) - 0.09, high - 0.05, kDepth - 0.014},
                {0.5 * (left + right) + 0.09, high - 0.05, kDepth - 0.014}, {0, 0, 0.032});
    };
    if (i == oven) {
      home.pen("oven", m.glassBlack, placed).box({left, 0.22, kDepth - 0.033}, {right, 0.70, kDepth - 0.008}, 0.003);
      home.pen("oven", m.steel, placed).box({left, 0.706, kDepth - 0.033}, {right, 0.852, kDepth - 0.010}, 0.003);
      addHandle(metal, {left + 0.04, 0.655, kDepth - 0.010}, {right - 0.04, 0.655, kDepth - 0.010}, {0, 0, 0.042});
      for (int k = 0; k < 4; ++k) {
        MeshBuilder knob;
        knob.add(turned({{{0.018, 0.0}, {0.017, 0.024}, {0.014, 0.026}}, {{0.014, 0.026}, {0.0, 0.026}}}, 20),
                 glm::rotate(glm::translate(glm::dmat4(1.0), {left + 0.12 + 0.115 * k, 0.78, kDepth - 0.011}),
                             glm::radians(90.0), glm::dvec3(1, 0, 0)));
        metal.add(knob);
      }
      fronts.box({left, 0.105, kDepth - 0.033}, {right, 0.216, kDepth - 0.012}, 0.003);
    } else if (i % 2 == 0) {
      front(0.105, 0.852);
    } else {
      front(0.105, 0.400);
      front(0.404, 0.650);
      front(0.654, 0.852);
    }
  }
  // The top, in four pieces about the sink.
  const double sinkLeft = 0.72, sinkRight = 1.22, sinkBack = 0.13, sinkFront = 0.50, low = 0.857;
  const Pen stone = home.pen("counter", m.counter, placed);
  const double front = kDepth + 0.01;
  stone.box({0.0, low, 0.0}, {sinkLeft, kTop, front}, 0.003, 0.8);
  stone.box({sinkRight, low, 0.0}, {length, kTop, front}, 0.003, 0.8);
  stone.box({sinkLeft, low, 0.0}, {sinkRight, kTop, sinkBack}, 0.003, 0.8);
  stone.box({sinkLeft, low, sinkFront}, {sinkRight, kTop, front}, 0.003, 0.8);
  const Pen steel = home.pen("sink", m.steel, placed);
  const double floor = kTop - 0.19;
  MeshBuilder basin;
  constexpr double kSheet = 0.002;  // of steel, before the stone
  const double left = sinkLeft + kSheet, right = sinkRight - kSheet, back = sinkBack + kSheet,
               edge = sinkFront - kSheet;
  const glm::dvec3 deep(0, kTop - 0.004 - floor, 0);
  basin.quad({left, floor, edge}, {right - left, 0, 0}, {0, 0, back - edge});
  basin.quad({left, floor, edge}, {0, 0, back - edge}, deep);
  basin.quad({right, floor, back}, {0, 0, edge - back}, deep);
  basin.quad({left, floor, back}, {right - left, 0, 0}, deep);
  basin.quad({right, floor, edge}, {left - right, 0, 0}, deep);
  steel.add(basin);
  const double tapX = 0.5 * (sinkLeft + sinkRight);
  const Pen tap = home.pen("tap", m.steel, placed);
  tap.add([&] {
    MeshBuilder foot;
    foot.add(turned({{{0.027, 0.0}, {0.027, 0.010}, {0.022, 0.014}},
                     {{0.022, 0.014}, {0.020, 0.10}},
                     {{0.020, 0.10}, {0.0, 0.102}}},
                    24),
             placedAt({tapX, kTop, 0.075}));
    return foot;
  }());
  std::vector<glm::dvec3> neck = {{tapX, kTop + 0.09, 0.075}, {tapX, kTop + 0.26, 0.075}};
  for (int i = 1; i <= 10; ++i) {
    const double angle = 0.5 * kTwoPi * i / 10;
    neck.emplace_back(tapX, kTop + 0.26 + 0.085 * std::sin(angle), 0.16 - 0.085 * std::cos(angle));
  }
  neck.emplace_back(tapX, kTop + 0.20, 0.245);
  tap.add(tube(neck, std::vector<double>(neck.size(), 0.0125), 16));
  tap.add(
      tube({{tapX + 0.018, kTop + 0.06, 0.075}, {tapX + 0.05, kTop + 0.064, 0.077}, {tapX + 0.10, kTop + 0.095, 0.082}},
           {0.008, 0.0065, 0.005}, 10));
  tap.hide({tapX - 0.015, kTop, 0.06}, {tapX + 0.015, kTop + 0.3, 0.09});
  home.pen("hob", m.glassBlack, placed)
      .box({unit * oven + 0.01, kTop, 0.06}, {unit * (oven + 1) - 0.01, kTop + 0.006, 0.55}, 0.002);

  MeshBuilder glazed;
  glazed.quad({0.0, kTop, 0.010}, {length, 0, 0}, {0, 0.60, 0}, {0.0, 0.0, length / 0.8, 0.75});
  glazed.quad({0.0, kTop + 0.60, 0.0}, {0.0, 0, 0.010}, {length, 0, 0}, {0.0, 0.01, 0.01, 0.02});
  home.pen("tiles", m.tiles, placed).add(glazed);
  const Pen board = home.pen("kitchen shelf", m.oak, placed);
  const double shelf = 1.50;
  board.box({0.10, shelf, 0.0}, {length - 0.06, shelf + 0.032, 0.24}, 0.004);
  home.pen("shelf light", m.stripLight, placed).add([&] {
    MeshBuilder strip;
    strip.quad({0.20, shelf - 0.002, 0.10}, {length - 0.36, 0, 0}, {0, 0, 0.022});
    return strip;
  }());
  const double on = shelf + 0.032;
  const int jars[] = {m.cream, m.pot, m.vase, m.cream, m.cabinet, m.pot};
  double x = 0.22;
  for (int i = 0; i < 6; ++i) {
    const double radius = 0.036 + 0.022 * hash(i, 0, 520), height = 0.11 + 0.11 * hash(i, 1, 520);
    addJar(home, jars[i], i % 3 == 1 ? m.brass : m.oak, placed, {x + radius, on, 0.11 + 0.03 * hash(i, 2, 520)}, radius,
           height);
    x += 2.0 * radius + 0.015 + 0.03 * hash(i, 3, 520);
  }
  const auto world = [&](double px, double py, double pz) { return glm::dvec3(placed * glm::dvec4(px, py, pz, 1.0)); };
  addPlant(home, m, world(x + 0.22, on, 0.12), 0.30, 71);
  for (int i = 0; i < 3; ++i)
    addBowl(home.pen("bowls", i == 1 ? m.vase : m.cream, glm::translate(placed, {x + 0.62, on + 0.028 * i, 0.12})),
            0.095 - 0.004 * i, 0.05);
  for (int i = 0; i < 4; ++i) {
    const Pen cup = home.pen("cups", i % 2 == 0 ? m.pot : m.cream,
                             glm::translate(placed, {x + 0.86 + 0.11 * i, on, 0.10 + 0.02 * (i % 2)}));
    addBowl(cup, 0.042, 0.085);
  }
  // On the counter.
  home.pen("cutting board", m.walnut,
           glm::rotate(glm::translate(placed, {0.36, kTop, 0.10}), glm::radians(-11.0), glm::dvec3(1, 0, 0)))
      .box({-0.15, 0.0, -0.011}, {0.15, 0.42, 0.011}, 0.008);
  home.pen("cutting board", m.oak,
           glm::rotate(glm::translate(placed, {0.50, kTop, 0.125}), glm::radians(-13.0), glm::dvec3(1, 0, 0)))
      .box({-0.11, 0.0, -0.009}, {0.11, 0.30, 0.009}, 0.007);
  addJar(home, m.vase, m.oak, placed, {1.42, kTop, 0.16}, 0.058, 0.20);
  addJar(home, m.cream, m.oak, placed, {1.55, kTop, 0.15}, 0.050, 0.15);
  const glm::dmat4 bowl = glm::translate(placed, {1.72, kTop, 0.33});
  if (length > 2.4) {
    addBowl(home.pen("bowls", m.walnut, bowl), 0.15, 0.08);
    const double fruit[5][3] = {
        {-0.05, 0.062, 0.03}, {0.05, 0.06, 0.04}, {0.0, 0.062, -0.055}, {0.005, 0.115, 0.01}, {0.075, 0.068, -0.04}};
    for (int i = 0; i < 5; ++i) {
      MeshBuilder made;
      made.add(sphere(0.036 + 0.004 * hash(i, 0, 530), 20), placedAt({fruit[i][0], fruit[i][1], fruit[i][2]}));
      home.pen("fruit", i % 2 == 0 ? m.fruit1 : m.fruit2, bowl).add(made);
    }
  }
}

void addTallCabinet(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen body = home.pen("kitchen", m.cabinet, placed), metal = home.pen("kitchen handles", m.steel, placed);
  body.box({0.0, 0.10, 0.0}, {0.60, 2.12, kDepth - 0.034}, 0.003);
  home.pen("kitchen", m.black, placed).box({0.01, 0.0, 0.02}, {0.59, 0.10, kDepth - 0.08}, 0.002);
  const double edges[] = {0.105, 1.30, 2.118};
  for (int i = 0; i < 2; ++i) {
    body.box({0.002, edges[i], kDepth - 0.033}, {0.598, edges[i + 1] - 0.004, kDepth - 0.012}, 0.003);
    const double from = i == 0 ? 0.86 : 1.36;
    addHandle(metal, {0.55, from, kDepth - 0.014}, {0.55, from + 0.34, kDepth - 0.014}, {0, 0, 0.032});
  }
}

void addTable(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen wood = home.pen("kitchen table", m.oak, placed);
  wood.box({-0.62, 0.708, -0.38}, {0.62, 0.74, 0.38}, 0.010);
  for (double z : {-0.29, 0.265}) wood.box({-0.50, 0.63, z}, {0.50, 0.708, z + 0.024}, 0.003);
  for (double x : {-0.50, 0.476}) wood.box({x, 0.63, -0.266}, {x + 0.024, 0.708, 0.265}, 0.003);
  for (double x : {-0.50, 0.50})
    for (double z : {-0.29, 0.29}) {
      wood.add(tube({{1.1 * x, 0.0, 1.14 * z}, {x, 0.708, z}}, {0.016, 0.026}, 14));
      wood.hide({x - 0.02, 0.0, z - 0.02}, {x + 0.02, 0.7, z + 0.02});
    }
}

void addChair(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen wood = home.pen("kitchen chairs", m.walnut, placed);
  wood.cushion({-0.21, 0.43, -0.20}, {0.21, 0.457, 0.21}, 0.012, {0.012, -0.006, 0.012}, 8);
  for (double s : {-1.0, 1.0}) {
    wood.add(tube({{s * 0.20, 0.0, 0.205}, {s * 0.165, 0.44, 0.165}}, {0.011, 0.016}, 12));
    wood.add(tube({{s * 0.20, 0.0, -0.235}, {s * 0.175, 0.45, -0.175}, {s * 0.185, 0.80, -0.245}},
                  {0.011, 0.016, 0.011}, 12));
    wood.add(tube({{s * 0.186, 0.20, 0.186}, {s * 0.19, 0.23, -0.204}}, {0.008, 0.008}, 10));
    wood.hide({s * 0.18 - 0.012, 0.0, 0.17}, {s * 0.18 + 0.012, 0.43, 0.20});
    wood.hide({s * 0.18 - 0.012, 0.0, -0.22}, {s * 0.18 + 0.012, 0.78, -0.18});
  }
  wood.box({-0.20, 0.70, -0.250}, {0.20, 0.81, -0.232}, 0.007);
  wood.box({-0.185, 0.56, -0.222}, {0.185, 0.61, -0.206}, 0.006);
}

void addPendant(Home& home, const FlatMaterials& m, glm::dvec3 ceiling, double drop) {
  const glm::dmat4 placed = placedAt(ceiling - glm::dvec3(0, drop, 0));
  const Pen shell = home.pen("pendant", m.vase, placed);
  shell.add(turned({{{0.198, 0.0}, {0.20, 0.002}},
                    {{0.20, 0.002}, {0.185, 0.07}, {0.13, 0.135}, {0.045, 0.175}, {0.018, 0.21}, {0.0, 0.215}}},
                   44));
  home.pen("pendant", m.cream, placed)
      .add(turned({{{0.05, 0.16}, {0.125, 0.13}, {0.18, 0.07}, {0.196, 0.002}, {0.198, 0.0}}}, 44));
  home.pen("pendant", m.black, placed).add(tube({{0, 0.20, 0}, {0, drop, 0}}, {0.003, 0.003}, 8));
  MeshBuilder light;
  constexpr int kCorners = 8;
  for (int i = 0; i < kCorners; ++i) {
    const double angle = kTwoPi * (i + 0.5) / kCorners;
    light.vertex({0.175 * std::sin(angle), 0.0, 0.175 * std::cos(angle)}, {0, -1, 0}, {0.5, 0.5});
  }
  for (std::uint32_t i = 1; i + 1 < kCorners; ++i) light.triangle(0, i + 1, i);
  home.pen("pendant light", m.warmLight, glm::translate(placed, {0, 0.03, 0})).add(light);
}

}  // namespace boxprobe::scenes
