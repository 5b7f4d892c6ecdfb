// Lamps as shapes and the lattice, in single precision against exact_lamp. The classes say where the point lies in
// relation to the input's box, so the lamp is one of its faces: points in its plane, on its edges and corners, behind
// it, a float beside it; lamps without area, as thin as a needle, of 1e-30 and of 1e18.
#include "filters/stress/subject_lamp.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/cube/diffuse_lattice.h"
#include "filters/math/shared/lamp_math.h"
#include "filters/stress/exact_lamp.h"
#include "filters/stress/stress_map.h"
#include "filters/stress/stress_subjects.h"

namespace boxprobe::stress {

namespace {

using exact::Real;

struct BoxLamp {
  LampPolygon polygon;
  exact::Lamp exact;
};

// A face of the box, shining inwards: all of it, its middle, or an octagon; of one side or of both.
BoxLamp lampOf(const StressInput& input, const LocalInput& in) {
  const auto draw = static_cast<unsigned>(input.pixel.x), shape = static_cast<unsigned>(input.pixel.y);
  const auto axis = static_cast<int>(draw % 3u);
  const bool high = draw / 3u % 2u == 0u;
  const glm::vec3 size = in.probe.boxMax - in.probe.boxMin;
  const float share = shape % 3u == 1u ? 0.3f : 0.0f;
  std::vector<glm::vec2> outline = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  if (shape % 3u == 2u)
    outline = {{0.3f, 0}, {0.7f, 0}, {1, 0.3f}, {1, 0.7f}, {0.7f, 1}, {0.3f, 1}, {0, 0.7f}, {0, 0.3f}};
  BoxLamp lamp;
  lamp.polygon.count = static_cast<int>(outline.size());
  lamp.polygon.bothSides = lamp.exact.bothSides = shape / 3u % 4u == 0u;
  if (high) std::reverse(outline.begin(), outline.end());
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::vec2 at = share + (1.0f - 2.0f * share) * outline[i];
    glm::vec3 corner(0.0f);
    corner[axis] = high ? in.probe.boxMax[axis] : in.probe.boxMin[axis];
    corner[(axis + 1) % 3] = in.probe.boxMin[(axis + 1) % 3] + at.x * size[(axis + 1) % 3];
    corner[(axis + 2) % 3] = in.probe.boxMin[(axis + 2) % 3] + at.y * size[(axis + 2) % 3];
    lamp.polygon.corners[i] = corner;
    lamp.exact.corners.push_back(exact::vec(corner));
  }
  return lamp;
}

// Is the lamp seen, and could rounding decide it?
struct LampSeen {
  bool seen, certain;
};

LampSeen lampSeen(const BoxLamp& lamp, const LocalInput& in) {
  const Real height = exact::heightOverLamp(lamp.exact, exact::vec(in.point.position));
  const Real away = lamp.exact.bothSides ? std::abs(height) : height;
  return {away > 1, std::abs(away - 1) > kLampSideRounding};
}

// Below this size products of two sides leave a float's range. No scene is that small.
constexpr float kSmallestLamp = 1.0e-15f;

bool large(const BoxLamp& lamp) {
  const auto& corners = lamp.polygon.corners;
  return std::max(glm::length(corners[1] - corners[0]), glm::length(corners[2] - corners[1])) >= kSmallestLamp;
}

void logLamp(const BoxLamp& lamp, const LocalInput& in, TrialLog* log) {
  if (log == nullptr) return;
  logLocal(in, *log);
  for (int i = 0; i < lamp.polygon.count; ++i) log->add("corner", lamp.polygon.corners[static_cast<std::size_t>(i)]);
  log->add("height over lamp", 0.0, exact::heightOverLamp(lamp.exact, exact::vec(in.point.position)));
}

/// Nodes whose light is drawn from the input, so that no two are alike.
DiffuseLattice latticeOf(const StressInput& input, const LocalInput& in) {
  DiffuseLattice lattice;
  lattice.nodes = {2 + input.frame % 3, 2 + input.frame / 3 % 3, 2 + input.frame / 9 % 3};
  const glm::vec3 size = in.probe.boxMax - in.probe.boxMin;
  lattice.low = in.probe.boxMin + 0.1f * size;
  lattice.high = in.probe.boxMax - 0.1f * size;
  const auto count = static_cast<std::size_t>(lattice.nodes.x * lattice.nodes.y * lattice.nodes.z);
  lattice.texels.resize(DiffuseLattice::kParts * count);
  auto state = static_cast<unsigned>(input.pixel.x * 4096 + input.pixel.y) + 1u;
  for (glm::vec4& texel : lattice.texels) {
    for (int i = 0; i < 4; ++i) {
      state = state * 1664525u + 1013904223u;
      texel[i] = static_cast<float>(state >> 8) / 16777216.0f - 0.3f;
    }
  }
  return lattice;
}

// The nodes' blend along three axes, and the polynomial of the normal that the coefficients are folded for; not below
// 0.
exact::Vec irradianceOf(const DiffuseLattice& lattice, const exact::Vec& places, const exact::Vec& n) {
  const Real basis[9] = {
      1, n[1], n[2], n[0], n[0] * n[1], n[1] * n[2], 3 * n[2] * n[2] - 1, n[0] * n[2], n[0] * n[0] - n[1] * n[1]};
  const auto count = static_cast<std::size_t>(lattice.nodes.x * lattice.nodes.y * lattice.nodes.z);
  exact::Vec light{0, 0, 0};
  for (int corner = 0; corner < 8; ++corner) {
    Real weight = 1;
    std::size_t node = 0, stride = 1;
    for (int axis = 0; axis < 3; ++axis) {
      const Real place = places[static_cast<std::size_t>(axis)];
      const Real first = std::min<Real>(std::floor(place), lattice.nodes[axis] - 2);
      const bool further = (corner >> axis & 1) != 0;
      weight *= further ? place - first : 1 - (place - first);
      node += stride * static_cast<std::size_t>(first + (further ? 1 : 0));
      stride *= static_cast<std::size_t>(lattice.nodes[axis]);
    }
    for (std::size_t k = 0; k < 27; ++k) {
      light[k % 3] += weight * basis[k / 3] * lattice.texels[(k / 4) * count + node][static_cast<int>(k % 4)];
    }
  }
  for (Real& x : light) x = std::max<Real>(x, 0);
  return light;
}

}  // namespace

Trial tryLampDiffuse(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const BoxLamp lamp = lampOf(input, in);
  logLamp(lamp, in, log);
  const float share = shading::lampDiffuse(&lamp.polygon, in.point.position, in.point.normal);
  Trial trial;
  trial.require(std::isfinite(share), share >= 0.0f && share <= 1.0f);
  const LampSeen seen = lampSeen(lamp, in);
  if (!seen.certain) return trial;
  const Real exact =
      seen.seen ? exact::formFactor(lamp.exact, exact::vec(in.point.position), exact::vec(in.point.normal)) : 0.0L;
  if (large(lamp)) {
    trial.measure(kRelative, static_cast<double>(std::abs(share - exact)), kLampShare, c.held != Held::Finite);
  }
  if (log != nullptr) log->add("form factor", static_cast<double>(share), exact);
  return trial;
}

Trial tryLampGlossy(const StressInput& input, const StressClass&, TrialLog* log) {
  const LocalInput in = localInput(input);
  const BoxLamp lamp = lampOf(input, in);
  logLamp(lamp, in, log);
  Trial trial;
  // Smoother surfaces show lamps in the map. What they would reflect is a share all the same.
  const float roughness = std::max(in.point.roughness, shading::kLampMapRoughness);
  glm::vec2 share(0.0f);
  for (const float p : {in.point.roughness, roughness}) {
    const shading::LampLobe lobe = shading::lampLobe(in.point.normal, in.point.view, p);
    share = shading::lampGlossy(&lamp.polygon, in.point.position, lobe);
    trial.require(std::isfinite(share.x) && std::isfinite(share.y),
                  share.x >= 0.0f && share.y >= 0.0f && share.x + share.y <= 1.0001f);
  }
  const LampSeen seen = lampSeen(lamp, in);
  if (!seen.certain) return trial;
  double least = 0.0;
  for (const Real tie : {1.0e-6L, -1.0e-6L}) {
    std::array<Real, 2> exact{0, 0};
    if (seen.seen) {
      exact = exact::imageShare(lamp.exact, exact::vec(in.point.position), exact::vec(in.point.normal),
                                exact::vec(in.point.view), roughness, tie);
    }
    const auto off = static_cast<double>(std::max(std::abs(share.x - exact[0]), std::abs(share.y - exact[1])));
    least = tie > 0 ? off : std::min(least, off);
    if (log != nullptr) {
      log->add("share times F0", static_cast<double>(share.x), exact[0]);
      log->add("share times F90", static_cast<double>(share.y), exact[1]);
    }
  }
  // An outline along the horizon, or one split at another place by rounding, has another value: counted, not held.
  if (large(lamp)) trial.measure(kRelative, least, kLampShare, false);
  return trial;
}

Trial tryLattice(const StressInput& input, const StressClass& c, TrialLog* log) {
  const LocalInput in = localInput(input);
  const DiffuseLattice lattice = latticeOf(input, in);
  const shading::LatticeShape shape = lattice.shape();
  const glm::vec3 light = shading::latticeIrradiance(shape, in.point.position, in.point.normal, in.point.normal);
  Trial trial;
  trial.require(finite(light));
  exact::Vec places{};
  for (int axis = 0; axis < 3; ++axis) {
    const Real last = lattice.nodes[axis] - 1, low = lattice.low[axis];
    const Real size = std::max<Real>(lattice.high[axis] - low, 1.0e-30L);
    places[static_cast<std::size_t>(axis)] =
        std::min(std::max((in.point.position[axis] - low) / size * last, Real(0)), last);
  }
  const exact::Vec expected = irradianceOf(lattice, places, exact::vec(in.point.normal));
  trial.measure(kRelative, static_cast<double>(exact::farthest(light, expected)), kLatticeLight,
                c.held != Held::Finite);
  if (log != nullptr) {
    logLocal(in, *log);
    log->add("lattice light", light, expected);
  }
  return trial;
}

}  // namespace boxprobe::stress
