#include "data/scenes/flat_furniture.h"

#include <algorithm>
#include <cmath>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "data/scenes/flat_pictures.h"
#include "data/scenes/picture.h"
#include "data/scenes/soft_shapes.h"

namespace boxprobe::scenes {
namespace {

constexpr double kTwoPi = 6.283185307179586;

glm::dmat4 turnedBy(const glm::dmat4& placed, double degrees, glm::dvec3 axis) {
  return glm::rotate(placed, glm::radians(degrees), axis);
}

MeshBuilder regular(int corners, double radius, double turn, bool up) {
  MeshBuilder mesh;
  for (int i = 0; i < corners; ++i) {
    const double angle = kTwoPi * (i + turn) / corners;
    mesh.vertex({radius * std::sin(angle), 0.0, radius * std::cos(angle)}, {0.0, up ? 1.0 : -1.0, 0.0}, {0.5, 0.5});
  }
  for (int i = 1; i + 1 < corners; ++i) {
    const auto a = static_cast<std::uint32_t>(i);
    up ? mesh.triangle(0, a, a + 1) : mesh.triangle(0, a + 1, a);
  }
  return mesh;
}

void addLegs(const Pen& pen, glm::dvec2 low, glm::dvec2 high, double height, double spread, double thick) {
  for (int i = 0; i < 4; ++i) {
    const double sx = i % 2 == 0 ? -1.0 : 1.0, sz = i / 2 == 0 ? -1.0 : 1.0;
    const glm::dvec3 top(sx < 0 ? low.x : high.x, height, sz < 0 ? low.y : high.y);
    const glm::dvec3 foot = top + glm::dvec3(sx * spread, -height, sz * spread);
    pen.add(tube({foot, top}, {0.6 * thick, thick}, 12));
    pen.hide(glm::min(foot, top) - glm::dvec3(0.7 * thick, 0.0, 0.7 * thick),
             glm::max(foot, top) + glm::dvec3(0.7 * thick, 0.0, 0.7 * thick));
  }
}

}  // namespace

glm::dmat4 placedAt(glm::dvec3 position, double degrees) {
  return glm::rotate(glm::translate(glm::dmat4(1.0), position), glm::radians(degrees), glm::dvec3(0, 1, 0));
}

void addSofa(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen cloth = home.pen("sofa", m.sofa, placed);
  constexpr double kWidth = 2.24, kDepth = 0.92, kArm = 0.17;
  const double x = 0.5 * kWidth;
  cloth.cushion({-x, 0.14, 0.02}, {x, 0.30, kDepth - 0.03}, 0.035, {0, 0, 0.006}, 4);
  for (double s : {-1.0, 1.0}) {  // arms
    const double outer = s * x, inner = s * (x - kArm);
    cloth.cushion({std::min(outer, inner), 0.135, 0.01}, {std::max(outer, inner), 0.60, kDepth - 0.01}, 0.06,
                  {0.012, 0.012, 0.01}, 7);
  }
  cloth.cushion({-x + kArm - 0.01, 0.15, 0.0}, {x - kArm + 0.01, 0.74, 0.20}, 0.06, {0, 0.008, 0.01}, 6);
  const double seat = (kWidth - 2.0 * kArm) / 2.0;
  for (int i = 0; i < 2; ++i) {
    const double left = -x + kArm + i * seat;
    cloth.cushion({left + 0.004, 0.285, 0.16}, {left + seat - 0.004, 0.455, kDepth + 0.01}, 0.055, {0.0, 0.028, 0.015},
                  11);
    const glm::dmat4 back = turnedBy(glm::translate(placed, {left + 0.5 * seat, 0.44, 0.19}), -11.0 - i, {1, 0, 0});
    home.pen("sofa", m.sofa, back)
        .cushion({-0.5 * seat + 0.008, 0.0, 0.0}, {0.5 * seat - 0.008, 0.42, 0.17}, 0.07, {0.012, 0.02, 0.035}, 10);
  }
  const auto pillow = [&](int material, glm::dvec3 at, double tilt, double turn, double size) {
    glm::dmat4 frame = glm::translate(placed, at);
    frame = turnedBy(turnedBy(frame, turn, {0, 1, 0}), tilt, {1, 0, 0});
    home.pen("cushions", material, frame)
        .cushion({-0.5 * size, 0.0, -0.03}, {0.5 * size, size, 0.03}, 0.028, {-0.015, -0.015, 0.065}, 12);
  };
  pillow(m.pillow1, {-0.72, 0.475, 0.47}, -20.0, 13.0, 0.46);
  pillow(m.pillow2, {-0.45, 0.47, 0.53}, -27.0, -8.0, 0.40);
  pillow(m.pillow1, {0.70, 0.475, 0.48}, -21.0, -15.0, 0.47);
  // A blanket over the arm: thin slabs that follow it.
  const Pen blanket = home.pen("blanket", m.throwBlanket, placed);
  const double left = x - kArm;
  blanket.cushion({left - 0.018, 0.44, 0.38}, {left + 0.01, 0.62, 0.78}, 0.012, {0.004, 0, 0.0}, 7);
  blanket.cushion({left - 0.018, 0.60, 0.38}, {x + 0.026, 0.632, 0.78}, 0.014, {0.0, 0.006, 0.004}, 7);
  blanket.cushion({x + 0.004, 0.24, 0.375}, {x + 0.026, 0.62, 0.785}, 0.010, {0.006, 0, 0.004}, 7);
  addLegs(home.pen("sofa", m.walnut, placed), {-x + 0.14, 0.12}, {x - 0.14, kDepth - 0.14}, 0.15, 0.03, 0.022);
}

void addArmchair(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen wood = home.pen("armchair", m.walnut, placed);
  constexpr double kHalf = 0.34;
  for (double s : {-1.0, 1.0}) {
    const double x = s * kHalf;
    wood.add(tube({{x, 0.0, 0.66}, {x, 0.30, 0.63}, {x, 0.565, 0.60}}, {0.013, 0.018, 0.016}, 12));
    wood.add(tube({{x, 0.0, 0.02}, {x, 0.32, 0.06}, {x, 0.545, 0.05}}, {0.013, 0.018, 0.015}, 12));
    wood.box({x - 0.03, 0.56, -0.02}, {x + 0.03, 0.588, 0.66}, 0.010);
    wood.box({x - 0.013, 0.252, 0.03}, {x + 0.013, 0.297, 0.65}, 0.006);
    wood.hide({x - 0.02, 0.0, 0.60}, {x + 0.02, 0.56, 0.67});
    wood.hide({x - 0.02, 0.0, 0.02}, {x + 0.02, 0.56, 0.08});
  }
  wood.box({-kHalf, 0.255, 0.61}, {kHalf, 0.30, 0.635}, 0.006);
  wood.box({-kHalf, 0.255, 0.06}, {kHalf, 0.30, 0.085}, 0.006);
  home.pen("armchair", m.armchair, turnedBy(glm::translate(placed, {0, 0.30, 0.06}), -4.0, {1, 0, 0}))
      .cushion({-kHalf + 0.03, -0.01, 0.0}, {kHalf - 0.03, 0.13, 0.63}, 0.05, {0.006, 0.025, 0.012}, 11);
  home.pen("armchair", m.armchair, turnedBy(glm::translate(placed, {0, 0.40, 0.03}), -17.0, {1, 0, 0}))
      .cushion({-kHalf + 0.035, 0.0, -0.02}, {kHalf - 0.035, 0.50, 0.11}, 0.05, {0.006, 0.012, 0.03}, 11);
  const Pen back = home.pen("armchair", m.walnut, turnedBy(glm::translate(placed, {0, 0.34, 0.02}), -17.0, {1, 0, 0}));
  for (int i = 0; i < 5; ++i) {
    const double y = 0.08 + 0.095 * i;
    back.box({-kHalf, y, -0.045}, {kHalf, y + 0.035, -0.028}, 0.005);
  }
}

void addCoffeeTable(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen wood = home.pen("coffee table", m.walnut, placed);
  wood.box({-0.58, 0.372, -0.31}, {0.58, 0.40, 0.31}, 0.009);
  wood.box({-0.50, 0.15, -0.24}, {0.50, 0.165, 0.24}, 0.004);
  for (double s : {-1.0, 1.0}) {
    wood.box({s * 0.50 - 0.02, 0.0, -0.26}, {s * 0.50 + 0.02, 0.372, -0.22}, 0.005);
    wood.box({s * 0.50 - 0.02, 0.0, 0.22}, {s * 0.50 + 0.02, 0.372, 0.26}, 0.005);
    wood.box({s * 0.50 - 0.014, 0.325, -0.22}, {s * 0.50 + 0.014, 0.372, 0.22}, 0.003);
  }
  // What lies on it: two books, a bowl of brass, two cups.
  const Pen covers = home.pen("books", m.books, placed);
  const auto lying = [&](glm::dvec3 low, glm::dvec2 size, double thick, double turn, int kind) {
    MeshBuilder book;
    const auto u = (kind + 0.5) / kBookKinds;
    book.add(bevelBox({-0.5 * size.x, 0.0, -0.5 * size.y}, {0.5 * size.x, thick, 0.5 * size.y}, 0.002, 1e6, {u, 0.75}),
             placedAt(low, turn));
    covers.add(book);
    covers.hide(low - glm::dvec3(0.45 * size.x, 0, 0.45 * size.y),
                low + glm::dvec3(0.45 * size.x, thick, 0.45 * size.y));
  };
  lying({-0.27, 0.40, 0.03}, {0.30, 0.23}, 0.028, 8.0, 3);
  lying({-0.26, 0.428, 0.02}, {0.26, 0.20}, 0.022, -7.0, 9);
  lying({0.20, 0.165, 0.0}, {0.31, 0.24}, 0.030, 4.0, 17);
  lying({0.21, 0.195, 0.0}, {0.28, 0.21}, 0.018, 21.0, 20);
  const Pen brass = home.pen("bowl", m.brass, glm::translate(placed, {0.22, 0.40, -0.08}));
  brass.add(turned({{{0.0, 0.0}, {0.045, 0.0}},
                    {{0.045, 0.0}, {0.075, 0.012}, {0.105, 0.032}, {0.122, 0.056}},
                    {{0.122, 0.056}, {0.118, 0.058}, {0.100, 0.035}, {0.070, 0.016}, {0.03, 0.010}, {0.0, 0.009}}},
                   40));
  brass.hide({-0.10, 0.0, -0.10}, {0.10, 0.05, 0.10});
  for (const glm::dvec2 at : {glm::dvec2(0.33, 0.16), glm::dvec2(-0.02, -0.17)}) {
    const Pen cup = home.pen("cups", m.pot, glm::translate(placed, {at.x, 0.40, at.y}));
    cup.add(turned({{{0.0, 0.001}, {0.028, 0.0}},
                    {{0.028, 0.0}, {0.038, 0.012}, {0.041, 0.045}, {0.041, 0.082}},
                    {{0.041, 0.082}, {0.0385, 0.083}, {0.0375, 0.045}, {0.034, 0.014}, {0.0, 0.010}}},
                   28));
    cup.hide({-0.03, 0.0, -0.03}, {0.03, 0.08, 0.03});
  }
}

void addFloorLamp(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  const Pen metal = home.pen("floor lamp", m.brass, placed);
  metal.add(turned({{{0.0, 0.0}, {0.15, 0.0}},
                    {{0.15, 0.0}, {0.152, 0.008}, {0.148, 0.018}},
                    {{0.148, 0.018}, {0.02, 0.024}},
                    {{0.011, 0.024}, {0.011, 0.80}, {0.011, 1.62}},
                    {{0.011, 1.62}, {0.0, 1.625}}},
                   32));
  metal.hide({-0.13, 0.0, -0.13}, {0.13, 0.02, 0.13});
  // A shade of four leaning sides: flat, so that each shines as a shape.
  const double low = 1.34, high = 1.62, wide = 0.235, narrow = 0.165;
  const Pen shade = home.pen("floor lamp shade", m.shade, placed);
  for (int i = 0; i < 4; ++i) {
    MeshBuilder side;
    side.quadrilateral({-wide, low, wide}, {wide, low, wide}, {narrow, high, narrow}, {-narrow, high, narrow});
    shade.add([&] {
      MeshBuilder turnedSide;
      turnedSide.add(side, placedAt({0, 0, 0}, 90.0 * i));
      return turnedSide;
    }());
  }
  for (int i = 0; i < 4; ++i) {
    const glm::dmat4 turn = turnedBy(placed, 90.0 * i, {0, 1, 0});
    home.pen("floor lamp", m.brass, turn).add(tube({{-wide, low, wide}, {wide, low, wide}}, {0.005, 0.005}, 8));
    home.pen("floor lamp", m.brass, turn)
        .add(tube({{-narrow, high, narrow}, {narrow, high, narrow}}, {0.005, 0.005}, 8));
  }
  home.pen("floor lamp light", m.shadeLight, glm::translate(placed, {0, low + 0.006, 0}))
      .add(regular(4, 1.37 * wide, 0.5, false));
  home.pen("floor lamp glow", m.shadeLight, glm::translate(placed, {0, high - 0.006, 0}))
      .add(regular(4, 1.37 * narrow, 0.5, true));
}

void addCeilingLamp(Home& home, const FlatMaterials& m, glm::dvec3 ceiling) {
  const glm::dmat4 placed = placedAt(ceiling);
  const Pen metal = home.pen("ceiling lamp", m.brass, placed);
  metal.add(turned({{{0.0, -0.032}, {0.052, -0.03}}, {{0.052, -0.03}, {0.06, 0.0}}}, 28));
  metal.add(tube({{0, -0.24, 0}, {0, -0.02, 0}}, {0.006, 0.006}, 10));
  metal.add(
      turned({{{0.265, -0.30}, {0.27, -0.30}}, {{0.27, -0.30}, {0.27, -0.235}}, {{0.27, -0.235}, {0.0, -0.23}}}, 48));
  MeshBuilder inner = turned({{{0.262, -0.235}, {0.262, -0.30}}}, 48);  // towards the light
  home.pen("ceiling lamp", m.cream, placed).add(inner);
  home.pen("ceiling lamp light", m.lampLight, glm::translate(placed, {0, -0.285, 0}))
      .add(regular(8, 0.262, 0.5, false));
}

void addBooks(Home& home, const FlatMaterials& m, const glm::dmat4& placed, double width, double most, double depth,
              int seed) {
  const Pen pen = home.pen("books", m.books, placed);
  double x = 0.0;
  for (int i = 0; x < width; ++i) {
    const double thick = 0.016 + 0.034 * hash(i, 0, seed) * hash(i, 1, seed) + 0.006,
                 height = most * (0.68 + 0.3 * hash(i, 2, seed));
    const double deep = depth * (0.72 + 0.22 * hash(i, 3, seed));
    if (x + thick > width) break;
    const int kind = static_cast<int>(kBookKinds * hash(i, 4, seed));
    const glm::dvec3 low(x, 0.0, 0.004 * hash(i, 5, seed)), high(x + thick - 0.001, height, low.z + deep);
    // The back is the picture's column; the other faces show its cloth.
    MeshBuilder book = bevelBox(low, high, 0.002, 1e6, {(kind + 0.5) / kBookKinds, 0.78});
    const UvRectangle back{(kind + 0.02) / kBookKinds, 0.0, (kind + 0.98) / kBookKinds, 0.875};
    book.quad({low.x + 0.002, 0.002, high.z + 0.0006}, {thick - 0.005, 0, 0}, {0, height - 0.004, 0}, back);
    const bool last = i > 2 && hash(i, 6, seed) < 0.10 && x + thick + 0.36 * height < width;
    if (last) {  // leans against its neighbour
      MeshBuilder leaning;
      leaning.add(book, glm::translate(glm::rotate(glm::translate(glm::dmat4(1.0), {x + 0.30 * height * 0.9, 0.0, 0.0}),
                                                   glm::radians(17.0), glm::dvec3(0, 0, 1)),
                                       {-x, 0.0, 0.0}));
      pen.add(leaning);
      x += thick + 0.32 * height;
    } else {
      pen.add(book);
      x += thick;
    }
    pen.hide(low, high);
  }
}

void addBookshelf(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  constexpr double kWidth = 1.06, kHeight = 2.08, kDepth = 0.32, kBoard = 0.024;
  const Pen wood = home.pen("bookshelf", m.oak, placed);
  const double x = 0.5 * kWidth;
  for (double s : {-1.0, 1.0})
    wood.box({s > 0 ? x - kBoard : -x, 0.0, 0.0}, {s > 0 ? x : -x + kBoard, kHeight, kDepth}, 0.003);
  wood.box({-x + kBoard, 0.07, 0.0}, {x - kBoard, kHeight - 0.01, 0.006}, 0.001);
  wood.box({-x + kBoard, 0.0, kDepth - 0.05}, {x - kBoard, 0.07, kDepth - 0.03}, 0.002);
  const double shelves[] = {0.07, 0.46, 0.80, 1.13, 1.45, 1.76, kHeight - kBoard};
  for (double y : shelves) wood.box({-x + kBoard, y, 0.008}, {x - kBoard, y + kBoard, kDepth - 0.004}, 0.003);
  const double left = -x + kBoard + 0.006, inner = kWidth - 2 * kBoard - 0.012;
  const double wide[] = {inner, 0.62 * inner, inner, 0.55 * inner, 0.80 * inner, 0.45 * inner};
  const double from[] = {0.0, 0.0, 0.0, 0.45 * inner, 0.0, 0.0};
  const double most[] = {0.335, 0.29, 0.28, 0.265, 0.25, 0.24};
  for (int i = 0; i < 6; ++i) {
    const glm::dmat4 at = glm::translate(placed, {left + from[i], shelves[i] + kBoard, 0.03 + 0.01 * (i % 3)});
    addBooks(home, m, at, wide[i], most[i], 0.25, 400 + i);
  }
  const auto world = [&](double px, double py, double pz) { return glm::dvec3(placed * glm::dvec4(px, py, pz, 1.0)); };
  addVase(home, m, world(left + 0.80 * inner, shelves[1] + kBoard, 0.17), 0.24, false);
  addVase(home, m, world(left + 0.20 * inner, shelves[3] + kBoard, 0.17), 0.20, false);
  addPlant(home, m, world(left + 0.74 * inner, shelves[5] + kBoard, 0.18), 0.26, 61);
  const Pen box = home.pen("boxes", m.paper, placed);
  box.box({left + 0.86 * inner, shelves[4] + kBoard, 0.05}, {left + 0.99 * inner, shelves[4] + kBoard + 0.12, 0.27},
          0.004);
}

void addSideboard(Home& home, const FlatMaterials& m, const glm::dmat4& placed) {
  constexpr double kWidth = 1.80, kLow = 0.16, kHigh = 0.66, kDepth = 0.42;
  const Pen wood = home.pen("sideboard", m.oak, placed);
  const double x = 0.5 * kWidth;
  wood.box({-x, kHigh - 0.025, 0.0}, {x, kHigh, kDepth}, 0.004);
  wood.box({-x, kLow, 0.0}, {x, kLow + 0.022, kDepth}, 0.003);
  for (double s : {-1.0, 1.0})
    wood.box({s > 0 ? x - 0.022 : -x, kLow + 0.022, 0.0}, {s > 0 ? x : -x + 0.022, kHigh - 0.025, kDepth}, 0.003);
  wood.box({-x + 0.022, kLow + 0.022, 0.0}, {x - 0.022, kHigh - 0.025, 0.30}, 0.002);
  const Pen brass = home.pen("sideboard", m.brass, placed);
  const double edges[] = {-x + 0.026, -0.42, 0.14, x - 0.026};
  for (int i = 0; i < 3; ++i) {
    const double left = edges[i] + 0.002, right = edges[i + 1] - 0.002;
    if (i == 1) {  // drawers
      for (int k = 0; k < 3; ++k) {
        const double low = kLow + 0.027 + 0.149 * k;
        wood.box({left, low, 0.30}, {right, low + 0.145, kDepth - 0.006}, 0.003);
        brass.add(tube({{0.5 * (left + right) - 0.05, low + 0.075, kDepth + 0.018},
                        {0.5 * (left + right) + 0.05, low + 0.075, kDepth + 0.018}},
                       {0.006, 0.006}, 10));
        for (double s : {-0.042, 0.042})
          brass.add(tube({{0.5 * (left + right) + s, low + 0.075, kDepth - 0.008},
                          {0.5 * (left + right) + s, low + 0.075, kDepth + 0.018}},
                         {0.004, 0.004}, 8));
      }
    } else {
      wood.box({left, kLow + 0.027, 0.30}, {right, kHigh - 0.030, kDepth - 0.006}, 0.003);
      const double knob = i == 0 ? right - 0.05 : left + 0.05;
      brass.add([&] {
        MeshBuilder made;
        made.add(
            turned({{{0.006, 0.0}, {0.006, 0.014}, {0.014, 0.018}, {0.015, 0.026}}, {{0.015, 0.026}, {0.0, 0.028}}},
                   20),
            glm::rotate(glm::translate(glm::dmat4(1.0), {knob, 0.46, kDepth - 0.007}), glm::radians(90.0),
                        glm::dvec3(1, 0, 0)));
        return made;
      }());
    }
  }
  addLegs(home.pen("sideboard", m.walnut, placed), {-x + 0.14, 0.07}, {x - 0.14, kDepth - 0.07}, kLow, 0.02, 0.02);
}

void addPlant(Home& home, const FlatMaterials& m, glm::dvec3 position, double height, int seed) {
  const double scale = height / 1.35, pot = std::clamp(0.24 * scale, 0.055, 0.2), deep = 1.5 * pot;
  const Pen clay = home.pen("plants", m.pot, placedAt(position));
  clay.add(turned({{{0.0, 0.0}, {0.72 * pot, 0.0}},
                   {{0.72 * pot, 0.0}, {0.9 * pot, 0.5 * deep}, {pot, deep}},
                   {{pot, deep}, {0.93 * pot, deep}, {0.90 * pot, 0.86 * deep}}},
                  36));
  clay.hide({-0.7 * pot, 0.0, -0.7 * pot}, {0.7 * pot, deep, 0.7 * pot});
  const Pen earth = home.pen("plants", m.bark, placedAt(position));
  earth.add(turned({{{0.90 * pot, 0.86 * deep}, {0.5 * pot, 0.9 * deep}, {0.0, 0.9 * deep}}}, 20));
  const Pen green = home.pen("plants", m.leaf, placedAt(position));
  const int stems = height > 0.6 ? 4 : 3, leaves = height > 0.6 ? 11 : 6;
  for (int s = 0; s < stems; ++s) {
    const double around = kTwoPi * (s + 0.5 * hash(s, 0, seed)) / stems, lean = 0.10 + 0.16 * hash(s, 1, seed);
    const double tall = height * (0.72 + 0.28 * hash(s, 2, seed)) - deep;
    std::vector<glm::dvec3> points;
    for (int i = 0; i <= 6; ++i) {
      const double t = i / 6.0, out = 0.25 * pot + tall * lean * t * (0.4 + t);
      points.emplace_back(out * std::sin(around), 0.88 * deep + tall * t * (1.0 - 0.12 * t), out * std::cos(around));
    }
    const double thick = 0.007 * std::max(scale, 0.4);
    earth.add(tube(points, {thick, thick, 0.9 * thick, 0.8 * thick, 0.7 * thick, 0.6 * thick, 0.4 * thick}, 8));
    for (int k = 0; k < leaves; ++k) {
      const double t = 0.22 + 0.78 * (k + 0.4 * hash(k, s, seed + 1)) / leaves, f = 6.0 * std::min(t, 0.999);
      const auto i = static_cast<std::size_t>(f);
      const glm::dvec3 at = points[i] + (f - static_cast<double>(i)) * (points[i + 1] - points[i]);
      const double turn = around + 2.4 * k + 0.6 * hash(k, s, seed + 2), rise = 0.35 + 0.7 * hash(k, s, seed + 3);
      const double length = scale * (0.20 + 0.13 * hash(k, s, seed + 4)) * (1.15 - 0.45 * t);
      green.add(leaf(at, {std::sin(turn), rise, std::cos(turn)}, {0, -1, 0}, length,
                     (0.42 + 0.1 * hash(k, s, seed + 5)) * length, 1.2 + 0.5 * hash(k, s, seed + 6)));
    }
  }
}

void addVase(Home& home, const FlatMaterials& m, glm::dvec3 position, double height, bool branches) {
  const double h = height;
  const Pen pen = home.pen("vases", m.vase, placedAt(position));
  pen.add(turned({{{0.0, 0.0}, {0.22 * h, 0.0}},
                  {{0.22 * h, 0.0},
                   {0.30 * h, 0.10 * h},
                   {0.36 * h, 0.28 * h},
                   {0.35 * h, 0.46 * h},
                   {0.26 * h, 0.66 * h},
                   {0.14 * h, 0.80 * h},
                   {0.115 * h, 0.90 * h},
                   {0.15 * h, h}},
                  {{0.15 * h, h}, {0.13 * h, 0.995 * h}, {0.095 * h, 0.90 * h}, {0.10 * h, 0.75 * h}}},
                 40));
  pen.hide({-0.26 * h, 0.0, -0.26 * h}, {0.26 * h, 0.8 * h, 0.26 * h});
  if (!branches) return;
  const Pen twig = home.pen("vases", m.bark, placedAt(position));
  const Pen green = home.pen("vases", m.leaf, placedAt(position));
  for (int s = 0; s < 5; ++s) {
    const double around = kTwoPi * (s + 0.6 * hash(s, 0, 501)) / 5, lean = 0.16 + 0.22 * hash(s, 1, 501),
                 tall = 1.7 * h * (0.75 + 0.4 * hash(s, 2, 501));
    std::vector<glm::dvec3> points;
    std::vector<double> radii;
    for (int i = 0; i <= 5; ++i) {
      const double t = i / 5.0, out = 0.02 * h + tall * lean * t * (0.5 + 0.6 * t);
      points.emplace_back(out * std::sin(around), 0.72 * h + tall * t, out * std::cos(around));
      radii.push_back(0.0032 * (1.0 - 0.6 * t));
    }
    twig.add(tube(points, radii, 6));
    for (int k = 0; k < 9; ++k) {
      const double t = 0.30 + 0.68 * k / 9.0, f = 5.0 * t;
      const auto i = static_cast<std::size_t>(f);
      const glm::dvec3 at = points[i] + (f - static_cast<double>(i)) * (points[i + 1] - points[i]);
      const double turn = 2.4 * k + s, length = 0.055 + 0.03 * hash(k, s, 502);
      green.add(leaf(at, {std::sin(turn), 0.5, std::cos(turn)}, {0, -1, 0}, length, 0.6 * length, 0.7));
    }
  }
}

void addPainting(Home& home, const FlatMaterials& m, int which, const glm::dmat4& placed, glm::dvec2 size) {
  const double x = 0.5 * size.x, y = 0.5 * size.y, bar = 0.022, thick = 0.028;
  const Pen frame = home.pen("picture frames", which % 2 == 0 ? m.walnut : m.black, placed);
  frame.box({-x, -y, 0.0}, {-x + bar, y, thick}, 0.003);
  frame.box({x - bar, -y, 0.0}, {x, y, thick}, 0.003);
  frame.box({-x + bar, y - bar, 0.0}, {x - bar, y, thick}, 0.003);
  frame.box({-x + bar, -y, 0.0}, {x - bar, -y + bar, thick}, 0.003);
  MeshBuilder mat, picture;
  const double edge = which == 3 ? 0.0 : 0.14 * size.x;
  mat.quad({-x + bar, -y + bar, 0.010}, {size.x - 2 * bar, 0, 0}, {0, size.y - 2 * bar, 0}, {0.4, 0.4, 0.45, 0.45});
  picture.quad({-x + bar + edge, -y + bar + edge, 0.012}, {size.x - 2 * bar - 2 * edge, 0, 0},
               {0, size.y - 2 * bar - 2 * edge, 0});
  if (edge > 0.0) home.pen("picture frames", m.paper, placed).add(mat);
  home.pen("painting " + std::to_string(which + 1), m.paintings[which], placed).add(picture);
}

void addRoundMirror(Home& home, const FlatMaterials& m, const glm::dmat4& placed, double radius) {
  const glm::dmat4 upright = glm::rotate(placed, glm::radians(90.0), glm::dvec3(1, 0, 0));
  home.pen("mirror", m.mirror, glm::translate(upright, {0, 0.012, 0})).add([&] {
    MeshBuilder disc;
    disc.disc({0, 0, 0}, radius - 0.004, 72, 1.0);
    return disc;
  }());
  home.pen("mirror frame", m.brass, upright)
      .add(turned({{{radius + 0.014, 0.0}, {radius + 0.014, 0.020}},
                   {{radius + 0.014, 0.020}, {radius + 0.011, 0.023}, {radius, 0.023}, {radius - 0.004, 0.019}},
                   {{radius - 0.004, 0.019}, {radius - 0.005, 0.010}}},
                  72));
  home.pen("mirror frame", m.brass, placed)
      .hide({-0.7 * radius, -0.7 * radius, 0.0}, {0.7 * radius, 0.7 * radius, 0.02});
}

void addCurtain(Home& home, const FlatMaterials& m, const glm::dmat4& top, double width, double height, int folds) {
  const Pen pen = home.pen("curtains", m.linen, top);
  const int columns = folds * 14;
  MeshBuilder mesh;
  constexpr int kRows = 6;
  for (int row = 0; row <= kRows; ++row) {
    const double t = static_cast<double>(row) / kRows;
    for (int c = 0; c <= columns; ++c) {
      const double phase = kTwoPi * folds * c / columns, x = width * c / columns;
      const double deep = 0.026 + 0.022 * t + 0.008 * hash(c / 14, 0, 510), swing = 0.12 * std::sin(3.0 * t + c / 14);
      const double slope = deep * kTwoPi * folds / width * std::cos(phase + swing * t);
      mesh.vertex({x, -height * t, deep * std::sin(phase + swing * t)}, glm::normalize(glm::dvec3(-slope, 0.0, 1.0)),
                  {x / 0.35 * 1.6, height * t / 0.35});
    }
  }
  const auto w = static_cast<std::uint32_t>(columns) + 1;
  for (std::uint32_t row = 0; row < kRows; ++row) {
    for (std::uint32_t c = 0; c + 1 < w; ++c) {
      const std::uint32_t a = row * w + c;
      mesh.triangle(a, a + w, a + w + 1);
      mesh.triangle(a, a + w + 1, a + 1);
    }
  }
  pen.add(mesh);
}

}  // namespace boxprobe::scenes
