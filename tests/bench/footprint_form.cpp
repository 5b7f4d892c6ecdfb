#include "tests/bench/footprint_form.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdarg>
#include <cstdio>
#include <sstream>

#include "filters/math/shared/shader_source.h"

namespace boxprobe::bench {

namespace {

using Constants = std::vector<double>;

// As they stand in the shader; a fit found to more digits than it has is an error of another kind.
float rounded(double x) {
  return static_cast<float>(std::round(x * 1000.0) / 1000.0);
}

std::string line(const char* format, ...) __attribute__((format(printf, 1, 2)));
std::string line(const char* format, ...) {
  char text[200];
  va_list values;
  va_start(values, format);
  std::vsnprintf(text, sizeof text, format,
                 values);  // NOLINT(clang-analyzer-valist.Uninitialized): it is started above
  va_end(values);
  return std::string("  ") + text + "\n";
}

double d(float x) {
  return static_cast<double>(x);
}

// What the lobe of a surface that reflects all has added where straight on it reflects less, by g = 1 - F0 (of
// ShadingPoint): its flat side counts more. Constants: shift 1 a n, scales of u and v by a and n, bias 1 a, and how
// fast a piece's reflectance rises, a n.
struct Edge {
  float shift = 0, shiftA = 0, shiftN = 0, scaleUA = 0, scaleUN = 0, scaleVA = 0, scaleVN = 0, bias = 0, biasA = 0;
  float riseA = 0, riseN = 0;

  void set(shading::FootprintLobe& lobe, float f0) const {
    const float a = lobe.alpha, n = lobe.view.z, g = 1.0f - std::min(f0, 1.0f);
    lobe.bias += g * (bias + biasA * a);
    lobe.scaleU += g * (scaleUA * a + scaleUN * n);
    lobe.scaleV += g * (scaleVA * a + scaleVN * n);
    lobe.shift += g * lobe.view.x * (shift + shiftA * a + shiftN * n);
    lobe.rise = std::max(1.0f + riseA * a + riseN * n, 0.1f);
  }
  std::string shader() const {
    return line("float g = 1.0f - min(point.f0, 1.0f);") +
           line("lobe.bias = lobe.bias + g * (%.3ff + (%.3ff) * a);", d(bias), d(biasA)) +
           line("lobe.scaleU = lobe.scaleU + g * (%.3ff * a + (%.3ff) * n);", d(scaleUA), d(scaleUN)) +
           line("lobe.scaleV = lobe.scaleV + g * (%.3ff * a + (%.3ff) * n);", d(scaleVA), d(scaleVN)) +
           line("lobe.shift = lobe.shift + g * lobe.view.x * (%.3ff + (%.3ff) * a + (%.3ff) * n);", d(shift), d(shiftA),
                d(shiftN)) +
           line("lobe.rise = max(1.0f + (%.3ff) * a + (%.3ff) * n, 0.1f);", d(riseA), d(riseN));
  }
};

Edge edgeOf(const Constants& c, std::size_t base) {
  Edge e;
  float* const to[kEdgeConstants] = {&e.shift,   &e.shiftA, &e.shiftN, &e.scaleUA, &e.scaleUN, &e.scaleVA,
                                     &e.scaleVN, &e.bias,   &e.biasA,  &e.riseA,   &e.riseN};
  for (std::size_t i = 0; i < kEdgeConstants && base + i < c.size(); ++i) *to[i] = rounded(c[base + i]);
  return e;
}

// What all forms share: bias, size and the disk's scales and shift, by roughness and view. a: alpha, n: N.V.
struct Common {
  float size = 1.0f, sizeA = 0.0f, sizeN = 0.0f;  // alone; the pieces' are relative to it
  float bias, biasA, biasN;
  float scaleUA, scaleUN, scaleVA, scaleVN;
  float shift, shiftA, shiftN;  // times the sine of the view's angle: nothing leans where N = V

  void set(shading::FootprintLobe& lobe) const {
    const float a = lobe.alpha, n = lobe.view.z;
    lobe.bias = bias + biasA * a + biasN * n;
    lobe.scaleU = 1.0f + scaleUA * a + scaleUN * n;
    lobe.scaleV = 1.0f + scaleVA * a + scaleVN * n;
    lobe.shift = lobe.view.x * (shift + shiftA * a + shiftN * n);
  }
  std::string shader() const {
    return line("FootprintLobe lobe = footprintLobe(point, 1.0f);") + line("float a = lobe.alpha;") +
           line("float n = lobe.view.z;") +
           line("lobe.bias = %.3ff + (%.3ff) * a + (%.3ff) * n;", d(bias), d(biasA), d(biasN)) +
           line("lobe.scaleU = 1.0f + (%.3ff) * a + (%.3ff) * n;", d(scaleUA), d(scaleUN)) +
           line("lobe.scaleV = 1.0f + (%.3ff) * a + (%.3ff) * n;", d(scaleVA), d(scaleVN)) +
           line("lobe.shift = lobe.view.x * (%.3ff + (%.3ff) * a + (%.3ff) * n);", d(shift), d(shiftA), d(shiftN));
  }
};

Common commonOf(const double* c) {
  Common r{};
  r.bias = rounded(c[0]), r.biasA = rounded(c[1]), r.biasN = rounded(c[2]);
  r.scaleUA = rounded(c[3]), r.scaleUN = rounded(c[4]), r.scaleVA = rounded(c[5]), r.scaleVN = rounded(c[6]);
  r.shift = rounded(c[7]), r.shiftA = rounded(c[8]), r.shiftN = rounded(c[9]);
  return r;
}
constexpr std::size_t kCommon = 10;

// --- One lookup by three rays, one on the axis and a pair. Constants: Common; narrow 1 a n an, wide; u of the pair, v
// and weight (its logarithm) of the one on the axis.
struct OneLookup {
  Common common;
  float narrow, narrowA, narrowN, narrowAN, wide, u, v, weight;

  explicit OneLookup(const Constants& c) : common(commonOf(c.data())) {
    const double* p = &c[kCommon];
    narrow = rounded(p[0]), narrowA = rounded(p[1]), narrowN = rounded(p[2]), narrowAN = rounded(p[3]);
    wide = rounded(p[4]), u = rounded(p[5]), v = rounded(p[6]), weight = rounded(std::exp(p[7]));
  }
  float pairV() const { return rounded(-0.5 * d(weight) * d(v)); }  // the mean v is 0
  glm::dvec3 operator()(const study::RoomPoint& p) const {
    shading::FootprintLobe lobe = shading::footprintLobe(p.point, 1.0f);
    common.set(lobe);
    const float a = lobe.alpha, n = lobe.view.z;
    shading::FootprintPatch seen = shading::footprintPatch(p.probe, p.point, lobe, 0.0f, v, weight);
    seen = shading::footprintExtend(p.probe, p.point, lobe, seen, u, pairV(), 1.0f);
    seen = shading::footprintExtend(p.probe, p.point, lobe, seen, -u, pairV(), 1.0f);
    return glm::dvec3(shading::footprintMean(p.chain, p.probe, seen,
                                             narrow + narrowA * a + narrowN * n + narrowAN * a * n, wide, lobe.bias));
  }
  std::string shader() const {
    return common.shader() +
           line("FootprintPatch seen = footprintPatch(probe, point, lobe, 0.0f, %.3ff, %.3ff);", d(v), d(weight)) +
           line("seen = footprintExtend(probe, point, lobe, seen, %.3ff, %.3ff, 1.0f);", d(u), d(pairV())) +
           line("seen = footprintExtend(probe, point, lobe, seen, %.3ff, %.3ff, 1.0f);", -d(u), d(pairV())) +
           line("float narrow = %.3ff + (%.3ff) * a + (%.3ff) * n + (%.3ff) * a * n;", d(narrow), d(narrowA),
                d(narrowN), d(narrowAN)) +
           line("return footprintMean(map, probe, seen, narrow, %.3ff, lobe.bias);", d(wide));
  }
};

// --- Lookups by a ray each, on the axis and in pairs. Constants: Common; size (its logarithm), size by a and n; then
// of each piece u 1 a (pairs only), v 1 a, the weight's logarithms at a = 0 and a = 1, and the size's.
struct Layout {
  int single, pairs;
};
Layout layoutOf(int lookups) {
  return {2, (lookups - 2) / 2};
}
constexpr std::size_t kSingle = 5, kPair = 7;

struct Piece {
  bool pair;
  float u, uA, v, vA, weight, weightA, size;
};

struct ManyLookups {
  Common common;
  Edge edge;
  std::vector<Piece> pieces;
  float centreA = 0.0f, centreA2 = 0.0f,
        weightA = 0.0f;  // the mean v, kept at 0: (centreA a + centreA2 a²) / (1 + weightA a)

  ManyLookups(int lookups, const Constants& c) : common(commonOf(c.data())) {
    const double* p = &c[kCommon];
    common.size = rounded(std::exp(p[0])), common.sizeA = rounded(p[1]), common.sizeN = rounded(p[2]);
    p += 3;
    const auto add = [&](bool pair) {
      Piece piece{pair, 0, 0, 0, 0, 0, 0, 0};
      if (pair) piece.u = rounded(p[0]), piece.uA = rounded(p[1]), p += 2;
      piece.v = static_cast<float>(p[0]), piece.vA = static_cast<float>(p[1]);
      piece.weight = static_cast<float>(std::exp(p[2]));
      piece.weightA = static_cast<float>(std::exp(p[3]) - std::exp(p[2]));
      piece.size = rounded(std::exp(p[4]));
      p += kSingle;
      pieces.push_back(piece);
    };
    for (int i = 0; i < layoutOf(lookups).single; ++i) add(false);
    for (int i = 0; i < layoutOf(lookups).pairs; ++i) add(true);
    edge = edgeOf(c, static_cast<std::size_t>(p - c.data()));
    centre();
  }
  // Weights of sum 1 where a = 0, and points whose mean is 0 there.
  void centre() {
    double sum = 0.0, mean = 0.0;
    for (const Piece& q : pieces) sum += d(q.weight) * (q.pair ? 2 : 1);
    for (const Piece& q : pieces) mean += d(q.weight) * d(q.v) * (q.pair ? 2 : 1) / sum;
    double a = 0.0, a2 = 0.0, w = 0.0;
    for (Piece& q : pieces) {
      q.weight = rounded(d(q.weight) / sum), q.weightA = rounded(d(q.weightA) / sum);
      q.v = rounded(d(q.v) - mean), q.vA = rounded(d(q.vA));
      const double count = q.pair ? 2.0 : 1.0;
      a += count * (d(q.weight) * d(q.vA) + d(q.weightA) * d(q.v));
      a2 += count * d(q.weightA) * d(q.vA);
      w += count * d(q.weightA);
    }
    centreA = rounded(a), centreA2 = rounded(a2), weightA = rounded(w);
  }
  glm::dvec3 operator()(const study::RoomPoint& p) const {
    shading::FootprintLobe lobe = shading::footprintLobe(p.point, 1.0f);
    common.set(lobe);
    edge.set(lobe, p.point.f0);
    const float a = lobe.alpha, n = lobe.view.z;
    lobe.shift -= lobe.scaleV * a * (centreA + centreA2 * a) / (1.0f + weightA * a);
    lobe.size *= common.size * std::max(1.0f + common.sizeA * a + common.sizeN * n, 0.1f);
    shading::FootprintSum sum = shading::footprintStart();
    for (const Piece& q : pieces) {
      const auto add = q.pair ? shading::footprintAddPair : shading::footprintAdd;
      sum = add(p.chain, p.probe, p.point, lobe, sum, q.u + q.uA * a, q.v + q.vA * a, q.weight + q.weightA * a, q.size);
    }
    return glm::dvec3(sum.value / sum.weight);
  }
  std::string shader() const {
    std::string text = common.shader() + edge.shader();
    text += line("lobe.shift = lobe.shift - lobe.scaleV * a * (%.3ff + (%.3ff) * a) / (1.0f + (%.3ff) * a);",
                 d(centreA), d(centreA2), d(weightA));
    text += line("lobe.size = lobe.size * %.3ff * max(1.0f + (%.3ff) * a + (%.3ff) * n, 0.1f);", d(common.size),
                 d(common.sizeA), d(common.sizeN));
    text += line("FootprintSum sum = footprintStart();");
    for (const Piece& q : pieces) {
      const std::string u = q.pair ? line("%.3ff + (%.3ff) * a", d(q.u), d(q.uA)) : "  0.0f\n";
      text += line("sum = %s(map, probe, point, lobe, sum, %.*s, %.3ff + (%.3ff) * a, %.3ff + (%.3ff) * a, %.3ff);",
                   q.pair ? "footprintAddPair" : "footprintAdd", static_cast<int>(u.size()) - 3, u.c_str() + 2, d(q.v),
                   d(q.vA), d(q.weight), d(q.weightA), d(q.size));
    }
    return text + line("return sum.value / sum.weight;");
  }
};

// The numbers of a line of a shader, each with its sign.
Constants numbersOf(const std::string& text) {
  Constants numbers;
  for (std::size_t at = 0; at < text.size(); ++at) {
    const bool starts = std::isdigit(static_cast<unsigned char>(text[at])) != 0 && at > 0 &&
                        std::isalnum(static_cast<unsigned char>(text[at - 1])) == 0;
    if (!starts) continue;
    std::size_t length = 0;
    const double value = std::stod(text.substr(at), &length);
    const std::size_t before = text.find_last_not_of(' ', at - 1);
    numbers.push_back(text[before] == '-' ? -value : value);
    at += length - 1;
  }
  return numbers;
}

// Where the fit starts: as the shader stands, but for what it has for non-metals.
Constants startOf(int lookups) {
  std::istringstream lines(
      std::string(shaderSource("technique/evaluation_footprint" + std::to_string(lookups) + ".glsl")));
  Constants start;
  for (std::string text; std::getline(lines, text);) {
    const auto starts = [&](const char* with) { return text.rfind(with, 0) == 0; };
    const Constants n = numbersOf(text);
    const bool whole =
        starts("  lobe.shift = lobe.view.x") || (starts("  lobe.bias = ") && text.find("g *") == std::string::npos);
    if (whole) {
      start.insert(start.end(), n.begin(), n.end());
    } else if (starts("  lobe.scaleU = 1") || starts("  lobe.scaleV = 1")) {
      start.insert(start.end(), {n.at(1), n.at(2)});
    } else if (starts("  lobe.size = ")) {
      start.insert(start.end(), {std::log(n.at(0)), n.at(2), n.at(3)});
    } else if (starts("  sum = footprintAdd")) {
      const std::size_t first = starts("  sum = footprintAddPair") ? 0 : 1;  // the axis is at u = 0
      if (first == 0) start.insert(start.end(), {n.at(0), n.at(1)});
      const double* v = &n.at(first == 0 ? 2 : 1);
      start.insert(start.end(), {v[0], v[1], std::log(v[2]), std::log(v[2] + v[3]), std::log(v[4])});
    }
  }
  return start;
}

Constants plainOf(int lookups, const Constants& c) {
  constexpr double kSizes = 0.06, kRest = 0.004;
  Constants r;
  for (std::size_t i = 0; i < kCommon; ++i) r.push_back(kRest * c[i]);
  std::size_t at = kCommon + 3;
  const Layout layout = layoutOf(lookups);
  for (int i = 0; i < layout.single + layout.pairs; ++i) {
    const bool pair = i >= layout.single;
    const double* v = &c[at + (pair ? 2 : 0)];
    r.insert(r.end(), {kRest * v[1], kRest * v[2], kRest * v[3], kSizes * v[4]});
    if (pair) r.push_back(kRest * c[at + 1]);
    at += pair ? kPair : kSingle;
  }
  return r;
}

}  // namespace

FootprintForm footprintForm(int lookups) {
  if (lookups == 1) {
    return {{0, 0.2, -0.2, -0.1, -0.3, -1.2, 1.0, -0.15, 0, 0, 0.14, 0.16, 0.1, -0.5, 1.25, 0.95, -0.4, 0},
            [](const Constants& c) { return study::Technique(OneLookup(c)); },
            [](const Constants&) { return Constants(); },
            [](const Constants& c) { return OneLookup(c).shader(); }};
  }
  return {startOf(lookups), [lookups](const Constants& c) { return study::Technique(ManyLookups(lookups, c)); },
          [lookups](const Constants& c) { return plainOf(lookups, c); },
          [lookups](const Constants& c) { return ManyLookups(lookups, c).shader(); }};
}

}  // namespace boxprobe::bench
