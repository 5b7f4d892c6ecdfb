#include "data/scenes/flat_pictures.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "data/scenes/picture.h"
#include "data/scenes/scenes.h"

namespace boxprobe::scenes {
namespace {

double inside(double d, double soft) {
  return softStep(0.0, soft, -d);
}

/// Noise of three octaves in [0, 1].
double cloudy(double x, double y, int periodX, int periodY, int seed) {
  return 0.57 * noise(x, y, periodX, periodY, seed) + 0.29 * noise(2 * x, 2 * y, 2 * periodX, 2 * periodY, seed + 1) +
         0.14 * noise(4 * x, 4 * y, 4 * periodX, 4 * periodY, seed + 2);
}

constexpr double kPlankTile = 3.0, kPlankWidth = 0.15;
constexpr int kPlankRows = 20;

struct Plank {
  int row, number;
  double along, across;  ///< metres from its nearest end, from its nearest long edge
  double u;              ///< metres
};

Plank plankAt(double u, double v) {
  const double y = kPlankTile * v / kPlankWidth;
  Plank plank{};
  plank.row = std::min(static_cast<int>(y), kPlankRows - 1);
  plank.across = kPlankWidth * std::min(y - plank.row, plank.row + 1 - y);
  // Two boards a row, cut at other places in each.
  const double first = kPlankTile * hash(plank.row, 1, 200), length = 1.1 + 0.8 * hash(plank.row, 2, 200);
  double x = std::fmod(kPlankTile * u - first + 2.0 * kPlankTile, kPlankTile);
  plank.number = x < length ? 0 : 1;
  if (plank.number == 1) x -= length;
  plank.along = std::min(x, (plank.number == 0 ? length : kPlankTile - length) - x);
  plank.u = kPlankTile * u;
  return plank;
}

double plankGap(const Plank& plank) {
  return 1.0 - softStep(0.0022, 0.0040, std::min(plank.along, plank.across));
}

/// Grain of one board: dark streaks along it, in bows about a heart.
double plankGrain(const Plank& plank, double v) {
  const int board = 2 * plank.row + plank.number;
  const double y = kPlankTile * v, away = 40.0 * hash(board, 3, 201);
  const double bow = cloudy(1.0 * plank.u + away, 6.0 * y, 3, 18, 202);
  const double rings = noise(0.7 * plank.u + away, 60.0 * y + 9.0 * bow + 30.0 * away, 1 << 20, 1 << 20, 205);
  const double fine = noise(9.0 * plank.u, 300.0 * y, 27, 900, 206);
  return 0.62 * rings + 0.2 * bow + 0.18 * fine;
}

}  // namespace

Picture planksPicture() {
  return paint(
      "planks", 1024, 1024,
      [](double u, double v) {
        const Plank plank = plankAt(u, v);
        const int board = 2 * plank.row + plank.number;
        const double grain = plankGrain(plank, v);
        glm::dvec3 color = blend({0.205, 0.118, 0.062}, {0.455, 0.300, 0.182}, 0.05 + 0.95 * grain);
        const double tone = hash(board, 5, 207);
        color *= 0.72 + 0.50 * tone;
        color *= blend(glm::dvec3(1.0), {1.06, 0.97, 0.88}, hash(board, 6, 207));
        return blend(color, {0.05, 0.028, 0.015}, 0.85 * plankGap(plank));
      },
      1);
}

Picture planksRoughness() {
  return paintNumbers("planks' roughness", 512, 512, [](double u, double v) {
    const Plank plank = plankAt(u, v);
    const int board = 2 * plank.row + plank.number;
    const double worn = cloudy(6.0 * u, 6.0 * v, 6, 6, 210);
    const double rough = 0.22 + 0.06 * hash(board, 7, 207) + 0.10 * worn + 0.05 * plankGrain(plank, v);
    return glm::dvec3(0.0, std::min(0.45, rough + 0.25 * plankGap(plank)), 0.0);
  });
}

Picture plasterPicture() {
  return paint(
      "plaster", 512, 512,
      [](double u, double v) {
        const double patch = cloudy(3.0 * u, 3.0 * v, 3, 3, 220), fine = cloudy(60.0 * u, 60.0 * v, 60, 60, 224);
        return glm::dvec3(0.93 + 0.05 * (patch - 0.5) + 0.05 * (fine - 0.5));
      },
      1);
}

Picture grainPicture(const std::string& name, glm::dvec3 dark, glm::dvec3 light) {
  return paint(
      name, 384, 384,
      [=](double u, double v) {
        const double bow = cloudy(2.0 * u, 5.0 * v, 2, 5, 230);
        const double rings = noise(1.0 * u, 48.0 * v + 7.0 * bow, 1, 48, 233),
                     fine = noise(24.0 * u, 256.0 * v, 24, 256, 234);
        return blend(dark, light, std::clamp(0.1 + 0.55 * rings + 0.3 * bow + 0.25 * (fine - 0.5), 0.0, 1.0));
      },
      2);
}

Picture clothPicture() {
  return paint(
      "cloth", 256, 256,
      [](double u, double v) {
        constexpr int kThreads = 64;
        const double x = kThreads * u, y = kThreads * v;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const bool over = (i + j) % 2 == 0;  // the thread that lies on top
        const double across = (over ? y - j : x - i) - 0.5;
        const double thread = hash(over ? j : i, over ? 1 : 2, 240), slub = cloudy(8.0 * u, 8.0 * v, 8, 8, 241);
        return glm::dvec3((1.0 - 1.1 * across * across) * (0.80 + 0.14 * thread + 0.14 * (slub - 0.5)));
      },
      3);
}

Picture rugPicture() {
  return paint(
      "rug", 768, 560,
      [](double u, double v) {
        const double x = 2.6 * u, y = 1.9 * v;
        const double edge = std::min(std::min(x, 2.6 - x), std::min(y, 1.9 - y));
        const double worn = cloudy(9.0 * u, 7.0 * v, 9, 7, 250),
                     tuft = hash(static_cast<int>(650 * u), static_cast<int>(475 * v), 253);
        const glm::dvec3 cream(0.66, 0.59, 0.48), ink(0.115, 0.155, 0.185), rust(0.42, 0.15, 0.075),
            ochre(0.50, 0.32, 0.12);
        // Rows of diamonds within each other, not two rows alike.
        const double cell = 0.325;
        const int column = static_cast<int>(x / cell), row = static_cast<int>(y / 0.38);
        const double dx = std::abs(x / cell - column - 0.5), dy = std::abs(y / 0.38 - row - 0.5);
        const double diamond = dx + dy;
        const double pick = hash(column, row, 254);
        glm::dvec3 color = blend(cream, ink, inside(std::abs(diamond - 0.40) - 0.035, 0.03));
        color = blend(color, pick < 0.36 ? rust : (pick < 0.62 ? ochre : ink), inside(diamond - 0.24, 0.03));
        color = blend(color, cream, inside(diamond - 0.09, 0.03));
        if (edge < 0.22) {
          color = blend(ink, cream, inside(std::abs(edge - 0.15) - 0.012, 0.008));
          const double tooth = std::abs(std::fmod((edge == x || edge == 2.6 - x ? y : x) / 0.08 + 10.0, 1.0) - 0.5);
          color = blend(color, rust, inside(std::max(tooth - 0.28, std::abs(edge - 0.07) - 0.025), 0.03));
        }
        return color * (0.82 + 0.2 * worn + 0.16 * (tuft - 0.5));
      },
      2);
}

Picture glazedTiles() {
  return paint(
      "tiles", 512, 512,
      [](double u, double v) {
        const double x = 8.0 * u, y = 8.0 * v;
        const int i = static_cast<int>(x), j = static_cast<int>(y);
        const double tone = hash(i, j, 260), glaze = cloudy(16.0 * u, 16.0 * v, 16, 16, 261);
        glm::dvec3 color = blend({0.29, 0.40, 0.36}, {0.50, 0.60, 0.54}, 0.75 * tone + 0.35 * (glaze - 0.3));
        const double joint = std::max(softLines(x, 1.0, 0.018, 0.02), softLines(y, 1.0, 0.018, 0.02));
        return blend(color, {0.60, 0.58, 0.54}, joint);
      },
      2);
}

Picture glazedTilesRoughness() {
  return paintNumbers("tiles' roughness", 256, 256, [](double u, double v) {
    const double x = 8.0 * u, y = 8.0 * v;
    const double joint = std::max(softLines(x, 1.0, 0.02, 0.03), softLines(y, 1.0, 0.02, 0.03));
    const double tile = 0.10 + 0.08 * hash(static_cast<int>(x), static_cast<int>(y), 263);
    return glm::dvec3(0.0, tile + (0.8 - tile) * joint, 0.0);
  });
}

Picture terrazzoPicture() {
  return paint(
      "terrazzo", 320, 320,
      [](double u, double v) {
        constexpr int kCells = 28;
        const double x = kCells * u, y = kCells * v;
        glm::dvec3 color = glm::dvec3(0.62, 0.60, 0.56) * (0.94 + 0.1 * cloudy(24.0 * u, 24.0 * v, 24, 24, 270));
        for (int j = static_cast<int>(y) - 1; j <= static_cast<int>(y) + 1; ++j) {
          for (int i = static_cast<int>(x) - 1; i <= static_cast<int>(x) + 1; ++i) {
            const int a = (i + kCells) % kCells, b = (j + kCells) % kCells;
            const double size = 0.12 + 0.4 * hash(a, b, 271) * hash(a, b, 272);
            const double dx = x - i - hash(a, b, 273), dy = y - j - hash(a, b, 274), tilt = hash(a, b, 275) - 0.5;
            const double d =
                std::max({std::abs(dx + tilt * dy), std::abs(dy - tilt * dx), 0.8 * std::abs(dx + dy)}) - size;
            const double kind = hash(a, b, 276);
            const glm::dvec3 chip = kind < 0.4    ? glm::dvec3(0.80, 0.78, 0.74)
                                    : kind < 0.65 ? glm::dvec3(0.26, 0.25, 0.24)
                                    : kind < 0.85 ? glm::dvec3(0.44, 0.35, 0.27)
                                                  : glm::dvec3(0.34, 0.40, 0.37);
            color = blend(color, chip, inside(d, 0.06));
          }
        }
        return color;
      },
      2);
}

Picture leafPicture() {
  return paint("leaf", 64, 128, [](double u, double v) {
    const double across = std::abs(u - 0.5), vein = softLines(v + 0.9 * across, 0.11, 0.008, 0.02);
    glm::dvec3 color = blend({0.030, 0.085, 0.028}, {0.075, 0.17, 0.045}, cloudy(3.0 * u, 6.0 * v, 3, 6, 280));
    color = blend(color, {0.16, 0.27, 0.09}, 0.35 * vein);
    return blend(color, {0.24, 0.34, 0.13}, inside(across - 0.02, 0.02));
  });
}

Picture booksPicture() {
  const std::array<glm::dvec3, 10> cloth = {{{0.36, 0.065, 0.045},
                                             {0.055, 0.12, 0.19},
                                             {0.54, 0.45, 0.31},
                                             {0.065, 0.14, 0.105},
                                             {0.62, 0.585, 0.52},
                                             {0.42, 0.22, 0.055},
                                             {0.085, 0.08, 0.085},
                                             {0.24, 0.30, 0.33},
                                             {0.50, 0.25, 0.17},
                                             {0.72, 0.69, 0.62}}};
  return paint("books", 1024, 256, [cloth](double u, double v) {
    const int kind = static_cast<int>(kBookKinds * u);
    const double x = kBookKinds * u - kind, y = v / 0.875;
    if (y > 1.0) return glm::dvec3(0.68, 0.62, 0.50) * (0.9 + 0.15 * noise(0.5, 60.0 * v, 4, 64, 291));  // paper
    const glm::dvec3 color =
        cloth[static_cast<std::size_t>(10.0 * hash(kind, 0, 290))] * (0.85 + 0.3 * hash(kind, 1, 290));
    const bool dark = color.x + color.y + color.z < 0.75;
    const glm::dvec3 print = dark ? glm::dvec3(0.68, 0.56, 0.30) : glm::dvec3(0.10, 0.09, 0.09);
    const double top = 0.10 + 0.12 * hash(kind, 2, 290), length = 0.25 + 0.25 * hash(kind, 3, 290);
    double ink = 0.0;
    if (hash(kind, 4, 290) < 0.6) {  // bands
      for (double line : {top - 0.04, top + length + 0.04, 0.90})
        ink = std::max(ink, inside(std::abs(y - line) - 0.006, 0.008));
    }
    if (y > top && y < top + length) {  // a title, read along the back
      const double letter = noise(0.5, 46.0 * y + 100.0 * kind, 8, 1 << 20, 292);
      ink = std::max(ink, inside(std::abs(x - 0.5) - 0.17, 0.1) * inside(0.45 - letter, 0.2));
    }
    ink = std::max(
        ink, inside(std::max(std::abs(x - 0.5) - 0.2, std::abs(y - 0.85) - 0.02), 0.02) * (kind % 3 == 0 ? 1.0 : 0.0));
    return blend(color, print, 0.85 * ink) * (0.80 + 0.25 * std::sin(3.14159 * std::clamp(x, 0.05, 0.95)));
  });
}

Picture paintingPicture(int which) {
  const int width = which == 3 ? 384 : 256, height = which == 3 ? 256 : 320;
  return paint(
      "painting " + std::to_string(which + 1), width, height,
      [which](double u, double v) {
        const double stroke = 0.03 * (cloudy(5.0 * u, 40.0 * v, 5, 40, 300 + which) - 0.5);
        const double wash = cloudy(4.0 * u, 5.0 * v, 4, 5, 310 + which);
        const glm::dvec3 paper(0.80, 0.75, 0.66);
        const double x = u + 0.4 * stroke, y = v + stroke;
        if (which == 0) {  // a low sun over three hills
          glm::dvec3 color = blend({0.78, 0.60, 0.42}, {0.80, 0.74, 0.64}, y);
          color = blend(color, {0.62, 0.20, 0.08}, inside(std::hypot(x - 0.60, 1.25 * (y - 0.38)) - 0.19, 0.015));
          color = blend(color, {0.32, 0.36, 0.33}, inside(0.58 + 0.07 * std::sin(6.0 * x) - y, 0.012));
          color = blend(color, {0.13, 0.20, 0.21}, inside(0.72 + 0.06 * std::sin(5.0 * x + 2.0) - y, 0.012));
          return blend(color, {0.07, 0.09, 0.10}, inside(0.86 + 0.04 * std::sin(7.0 * x + 4.0) - y, 0.012)) *
                 (0.85 + 0.3 * wash);
        }
        if (which == 1) {  // arches
          glm::dvec3 color = paper;
          const std::array<glm::dvec3, 4> tints = {
              {{0.10, 0.17, 0.20}, {0.48, 0.20, 0.11}, {0.62, 0.42, 0.18}, {0.74, 0.66, 0.54}}};
          for (int i = 0; i < 4; ++i) {
            const double radius = 0.40 - 0.095 * i;
            const double d = y < 0.5 ? std::hypot(x - 0.5, 1.2 * (y - 0.5)) - radius
                                     : std::max(std::abs(x - 0.5) - radius, y - 0.92);
            color = blend(color, tints[static_cast<std::size_t>(i)], inside(d, 0.012));
          }
          return color * (0.88 + 0.24 * wash);
        }
        if (which == 2) {  // stones on each other
          glm::dvec3 color = blend(paper, {0.70, 0.66, 0.58}, y);
          const double places[4][5] = {{0.50, 0.84, 0.33, 0.10, 0},
                                       {0.46, 0.66, 0.24, 0.085, 1},
                                       {0.54, 0.50, 0.19, 0.08, 2},
                                       {0.49, 0.35, 0.11, 0.075, 3}};
          const glm::dvec3 tints[4] = {{0.12, 0.14, 0.15}, {0.30, 0.37, 0.36}, {0.56, 0.30, 0.17}, {0.66, 0.55, 0.38}};
          for (int i = 0; i < 4; ++i) {
            const double d = std::hypot((x - places[i][0]) / places[i][2], (y - places[i][1]) / places[i][3]) - 1.0;
            color = blend(color, tints[i] * (0.8 + 0.4 * wash), inside(d, 0.06));
          }
          return color;
        }
        // A sea in bands, darker towards the viewer.
        glm::dvec3 color = blend({0.66, 0.62, 0.54}, {0.46, 0.52, 0.52}, softStep(0.35, 0.3, y));
        color = blend(color, {0.20, 0.31, 0.36}, inside(0.52 + 0.01 * std::sin(9.0 * x) - y, 0.01));
        color = blend(color, {0.075, 0.15, 0.20}, inside(0.68 + 0.03 * std::sin(4.0 * x + 1.0) - y, 0.03));
        color = blend(color, {0.55, 0.42, 0.25}, inside(0.86 + 0.05 * std::sin(3.0 * x + 2.5) - y, 0.015));
        color = blend(color, {0.78, 0.46, 0.18}, inside(std::hypot(1.5 * (x - 0.30), y - 0.40) - 0.07, 0.01));
        return color * (0.85 + 0.3 * wash);
      },
      3);
}

std::string flatSkyHdr() {
  constexpr int kWidth = 640, kHeight = 320;
  constexpr double kSkyLight = 0.62;  // so that rooms and sky fit one exposure
  std::vector<float> rgb;
  for (int row = 0; row < kHeight; ++row) {
    const double v = (row + 0.5) / kHeight, height = 90.0 - 180.0 * v;  // degrees
    for (int column = 0; column < kWidth; ++column) {
      const double u = (column + 0.5) / kWidth, around = 360.0 * u;
      glm::dvec3 color;
      const double west = std::exp(-std::pow((around - 252.0) / 45.0, 2));  // where the sun is
      const double up = std::clamp(height / 90.0, 0.0, 1.0);
      color = blend({0.98, 0.86, 0.72}, {0.26, 0.42, 0.72}, std::pow(up, 0.45));
      color += west * std::exp(-std::pow((height - 28.0) / 22.0, 2)) * glm::dvec3(0.55, 0.40, 0.22);
      const double cloud = cloudy(14.0 * u, 30.0 * v, 14, 30, 330);
      color = blend(color, glm::dvec3(1.10, 0.98, 0.86) * (0.9 + 0.4 * west),
                    0.75 * softStep(0.60, 0.22, cloud) * softStep(4.0, 12.0, height));
      const double far = 2.2 + 2.6 * cloudy(9.0 * u, 0.5, 9, 1, 340),
                   near = 0.3 + 1.9 * cloudy(22.0 * u, 0.5, 22, 1, 344);
      const double trees = -1.6 + 2.6 * cloudy(60.0 * u, 0.5, 60, 1, 348);
      color = blend(color, {0.50, 0.52, 0.54}, softStep(0.0, 0.5, far - height));
      color = blend(color, {0.30, 0.36, 0.34}, softStep(0.0, 0.5, near - height));
      const double crown = cloudy(90.0 * u, 45.0 * v, 90, 45, 352);
      const glm::dvec3 wood =
          blend({0.035, 0.055, 0.026}, {0.25, 0.255, 0.13}, softStep(0.5, 0.55, crown)) * (1.0 + 0.5 * west);
      color = blend(color, wood, softStep(0.0, 0.5, trees - height));
      color *= 1.0 - 0.25 * softStep(-30.0, 60.0, -height);
      for (int channel = 0; channel < 3; ++channel) rgb.push_back(static_cast<float>(kSkyLight * color[channel]));
    }
  }
  return hdrBytes(kWidth, kHeight, rgb);
}

}  // namespace boxprobe::scenes
