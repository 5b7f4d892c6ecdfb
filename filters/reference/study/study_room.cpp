#include "filters/reference/study/study_room.h"

#include <cmath>
#include <glm/common.hpp>
#include <glm/vec2.hpp>

#include "filters/math/cube/cube_filter.h"

namespace boxprobe::study {

using glm::dvec2;
using glm::dvec3;

namespace {

class Chance {
 public:
  explicit Chance(unsigned seed) : random_(seed) {}
  double in(double low, double high) { return low + (high - low) * std::uniform_real_distribution<double>()(random_); }
  int below(int count) { return std::uniform_int_distribution<int>(0, count - 1)(random_); }
  dvec3 tint(double low, double high) {
    const double r = in(low, high), g = in(low, high);
    return {r, g, in(low, high)};
  }

 private:
  std::mt19937 random_;
};

RoomLamp randomLamp(Chance& chance) {
  const bool panel = chance.in(0, 1) < 0.35;
  const double half = panel ? chance.in(0.3, 0.7) : chance.in(0.06, 0.2);
  RoomLamp lamp{3, !panel, {}, {half, panel ? half * chance.in(0.4, 1) : half}, {}};
  lamp.middle = {chance.in(0.15, 0.85), chance.in(0.1, 0.9)};
  lamp.radiance = (panel ? chance.in(3, 8) : chance.in(8, 40)) * dvec3(1, 0.9, chance.in(0.6, 1));
  return lamp;
}

RoomLamp randomWindow(Chance& chance) {
  constexpr int kSides[] = {0, 1, 4, 5};
  RoomLamp window{kSides[chance.below(4)], false, {}, {}, {}};
  window.middle = {chance.in(0.25, 0.75), chance.in(0.4, 0.6)};
  window.half = {chance.in(0.3, 0.8), chance.in(0.3, 0.7)};
  window.radiance = chance.in(1.5, 6) * dvec3(chance.in(0.6, 0.9), 0.9, 1);
  return window;
}

// A hash of a pattern's cell, in [0, 1).
double cellValue(int i, int j, int wall) {
  std::uint32_t h = static_cast<std::uint32_t>(i) * 374761393u + static_cast<std::uint32_t>(j) * 668265263u +
                    static_cast<std::uint32_t>(wall) * 2246822519u;
  h = (h ^ (h >> 13)) * 1274126177u;
  return static_cast<double>((h ^ (h >> 16)) & 0xffffffu) / 0x1000000;
}

double patternValue(const RoomWall& wall, int number, const dvec2& at) {
  const dvec2 cells = at / wall.period, cell = glm::floor(cells), inside = cells - cell;
  const int i = static_cast<int>(cell.x), j = static_cast<int>(cell.y);
  switch (wall.pattern) {
    case RoomWall::Pattern::Checks:
      return (i + j) % 2 == 0 ? 0.0 : 1.0;
    case RoomWall::Pattern::Stripes:
      return i % 2 == 0 ? 0.0 : 1.0;
    case RoomWall::Pattern::Blocks:
      return cellValue(i, j, number);
    case RoomWall::Pattern::Grid:
      return inside.x < 0.08 || inside.y < 0.08 ? 1.0 : 0.0;
    case RoomWall::Pattern::Waves:
      return 0.5 + 0.5 * std::sin(6.28318531 * cells.x) * std::sin(6.28318531 * cells.y);
  }
  return 0.0;
}

dvec3 roomRadiance(const BoxRoom& room, const dvec3& hit, int wall) {
  const int axis = wall / 2, across = (axis + 1) % 3, along = (axis + 2) % 3;
  const dvec2 size(room.high[across] - room.low[across], room.high[along] - room.low[along]);
  const dvec2 at(hit[across] - room.low[across], hit[along] - room.low[along]);
  for (const RoomLamp& lamp : room.lamps) {
    const dvec2 off = glm::abs(at - lamp.middle * size) / lamp.half;
    if (lamp.wall == wall && (lamp.round ? off.x * off.x + off.y * off.y : std::max(off.x, off.y)) < 1.0) {
      return lamp.radiance;
    }
  }
  const RoomWall& w = room.walls[wall];
  const dvec2 end = at / size - 0.5;
  return glm::mix(w.light, w.dark, patternValue(w, wall, at)) * (1.0 + w.slope.x * end.x + w.slope.y * end.y);
}

struct Exit {
  dvec3 place;
  int wall;
};

Exit exitOf(const BoxRoom& room, const dvec3& p, const dvec3& d) {
  double t = 1e30;
  Exit exit{};
  for (int i = 0; i < 3; ++i) {
    if (d[i] == 0.0) continue;
    const double ti = std::max(((d[i] < 0.0 ? room.low[i] : room.high[i]) - p[i]) / d[i], 0.0);
    if (ti < t) t = ti, exit.wall = 2 * i + (d[i] > 0.0 ? 1 : 0);
  }
  exit.place = glm::clamp(p + t * d, room.low, room.high);
  return exit;
}

}  // namespace

BoxRoom randomRoom(unsigned seed, bool longAndLow) {
  Chance chance(seed);
  BoxRoom room;
  dvec3 size, origin;
  size.x = longAndLow ? chance.in(3, 5) : chance.in(3, 8);
  size.y = longAndLow ? chance.in(2.5, 3.5) : chance.in(2.4, 4);
  size.z = longAndLow ? chance.in(10, 18) : chance.in(3, 8);
  origin.x = chance.in(0.3, 0.7);
  origin.y = chance.in(0.35, 0.65);
  origin.z = chance.in(0.3, 0.7);
  room.low = -origin * size;
  room.high = room.low + size;
  for (RoomWall& wall : room.walls) {
    wall.pattern = static_cast<RoomWall::Pattern>(chance.below(5));
    wall.light = std::exp(chance.in(std::log(0.03), 0.0)) * chance.tint(0.5, 1);
    wall.dark = wall.light * chance.in(0.1, 0.6) * chance.tint(0.7, 1.3);
    wall.period = {chance.in(0.2, 1.2), chance.in(0.2, 1.2)};
    wall.slope = {chance.in(-0.6, 0.6), chance.in(-0.6, 0.6)};
  }
  const int lamps = chance.below(3) == 0 ? 1 : 2 + chance.below(4), windows = chance.below(3);
  for (int i = 0; i < lamps; ++i) room.lamps.push_back(randomLamp(chance));
  for (int i = 0; i < windows; ++i) room.lamps.push_back(randomWindow(chance));
  return room;
}

CubeMap prefilteredRoom(const BoxRoom& room, int faceSize) {
  constexpr int kSide = 4;  // samples per texel side, as in an anti-aliased capture
  CubeMap capture(faceSize, 1);
  const auto coordinate = [faceSize](int texel, int sample) {
    const float inside = (static_cast<float>(sample) + 0.5f) / kSide;
    return 2.0f * (static_cast<float>(texel) + inside) / static_cast<float>(faceSize) - 1.0f;
  };
  for (int face = 0; face < 6; ++face) {
    for (int row = 0; row < faceSize; ++row) {
      for (int column = 0; column < faceSize; ++column) {
        dvec3 sum(0.0);
        for (int i = 0; i < kSide * kSide; ++i) {
          const dvec3 d(shading::cubeDirection(face, coordinate(column, i % kSide), coordinate(row, i / kSide)));
          const Exit exit = exitOf(room, dvec3(0.0), d);
          sum += roomRadiance(room, exit.place, exit.wall);
        }
        capture.setTexel(0, face, column, row, glm::vec4(glm::vec3(sum / double(kSide * kSide)), 1.0f));
      }
    }
  }
  return prefilterCube(capture, PrefilterSettings{});
}

}  // namespace boxprobe::study
