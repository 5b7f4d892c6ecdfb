#include "tests/bench/footprint_form.h"

#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "tests/bench/turned_form.h"

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
  std::vsnprintf(text, sizeof text, format, values);
  va_end(values);
  return std::string("  ") + text + "\n";
}

double d(float x) {
  return static_cast<double>(x);
}

// Bias and the disk's scales and shift, by roughness and view. a: alpha, n: N.V.
struct Common {
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

}  // namespace

FootprintForm footprintForm(int lookups) {
  if (lookups == 1) {
    return {{0, 0.2, -0.2, -0.1, -0.3, -1.2, 1.0, -0.15, 0, 0, 0.14, 0.16, 0.1, -0.5, 1.25, 0.95, -0.4, 0},
            [](const Constants& c) { return study::Technique(OneLookup(c)); },
            [](const Constants&) { return Constants(); },
            [](const Constants& c) { return OneLookup(c).shader(); }};
  }
  return turnedForm(lookups);
}

}  // namespace boxprobe::bench
