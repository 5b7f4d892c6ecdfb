#include "filters/math/cube/diffuse_lattice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

#include "filters/math/cube/cube_filter.h"
#include "filters/math/cube/openings.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;

// Square of each basis function's constant (it enters in projection and evaluation) times the clamped cosine over pi of
// its band: what shIrradiance leaves to its coefficients.
constexpr double kFolded[9] = {
    0.0795774715459477,     0.238732414637843 * 2.0 / 3.0, 0.238732414637843 * 2.0 / 3.0, 0.238732414637843 * 2.0 / 3.0,
    1.19366207318922 / 4.0, 1.19366207318922 / 4.0,        0.0994718394324346 / 4.0,      1.19366207318922 / 4.0,
    0.298415518297304 / 4.0};

struct LatticeRay {
  glm::vec3 direction;  // unit, probe frame
  glm::vec3 directionWorld;
  std::array<float, 9> basis;  // of the direction in the world, with what is folded and the solid angle
};

// Even over the sphere, in the box's axes, so that a turned box is derived as an upright one.
std::vector<LatticeRay> latticeRays(int count, const glm::mat3& worldFromProbe) {
  std::vector<LatticeRay> rays;
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0), solidAngle = 4.0 * kPi / count;
  for (int i = 0; i < count; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / count, phi = 2.0 * kPi * (i * golden - std::floor(i * golden));
    const double r = std::sqrt(std::max(1.0 - z * z, 0.0));
    LatticeRay ray;
    ray.direction = glm::vec3(glm::dvec3(r * std::cos(phi), r * std::sin(phi), z));
    ray.directionWorld = glm::normalize(worldFromProbe * ray.direction);
    ray.basis = latticeBasis(ray.directionWorld, solidAngle);
    rays.push_back(ray);
  }
  return rays;
}

// All nodes' together: a room of five metres has as many by itself. Beyond that each node has fewer.
constexpr int kRaysInAll = 1 << 18;

int raysOfNode(int wanted, std::size_t nodes) {
  const int share = kRaysInAll / static_cast<int>(std::max<std::size_t>(nodes, 1));
  return std::clamp(share, std::max(wanted / 8, 1), std::max(wanted, 1));
}

// Node i of n between two ends.
float nodeAt(float low, float high, int i, int n) {
  return low + (high - low) * static_cast<float>(i) / static_cast<float>(n - 1);
}

}  // namespace

std::array<float, 9> latticeBasis(const glm::vec3& directionWorld, double solidAngle) {
  const glm::dvec3 n(directionWorld);
  const double polynomials[9] = {
      1.0, n.y, n.z, n.x, n.x * n.y, n.y * n.z, 3.0 * n.z * n.z - 1.0, n.x * n.z, n.x * n.x - n.y * n.y};
  std::array<float, 9> basis{};
  for (std::size_t k = 0; k < 9; ++k) basis[k] = static_cast<float>(polynomials[k] * kFolded[k] * solidAngle);
  return basis;
}

glm::vec4 DiffuseLattice::fetchLattice(const glm::vec3& place, int part) const {
  const bool cut = part >= kParts;
  if (empty() || (cut && cuts.empty())) return glm::vec4(0.0f);
  const std::vector<glm::vec4>& from = cut ? cuts : texels;
  if (cut) part -= kParts;
  glm::ivec3 first(0);
  glm::vec3 share(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const float within = std::clamp(place[axis], 0.0f, static_cast<float>(nodes[axis] - 1));
    first[axis] = std::min(static_cast<int>(within), nodes[axis] - 2);
    share[axis] = within - static_cast<float>(first[axis]);
  }
  glm::vec4 sum(0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    const int x = first.x + (corner & 1), y = first.y + (corner >> 1 & 1), z = first.z + (corner >> 2);
    const float weight = ((corner & 1) != 0 ? share.x : 1.0f - share.x) *
                         ((corner & 2) != 0 ? share.y : 1.0f - share.y) *
                         ((corner & 4) != 0 ? share.z : 1.0f - share.z);
    sum += weight * from[static_cast<std::size_t>(((part * nodes.z + z) * nodes.y + y) * nodes.x + x)];
  }
  return sum;
}

shading::LatticeShape DiffuseLattice::shape() const {
  shading::LatticeShape shape;
  shape.low = low;
  shape.last = glm::vec3(nodes - 1);
  shape.perUnit = shape.last / glm::max(high - low, glm::vec3(1.0e-30f));
  shape.cut = cuts.empty() ? 0.0f : 1.0f;
  shape.slot = this;
  return shape;
}

double metreOf(const glm::vec3& boxSize) {
  const auto shortest = static_cast<double>(std::min({boxSize.x, boxSize.y, boxSize.z}));
  if (!std::isfinite(shortest)) return 1.0;
  return shortest > 100.0 ? shortest / 2.5 : std::max(1.0, 0.1 * shortest);
}

glm::ivec3 latticeNodes(const glm::vec3& size, float spacing) {
  glm::ivec3 nodes(2);
  for (int axis = 0; axis < 3; ++axis) {
    const float steps = size[axis] / spacing;
    if (!(steps > 0.0f) || !(spacing > 0.0f)) continue;
    const float most = static_cast<float>(DiffuseLattice::kMostNodes - 1);
    nodes[axis] = std::clamp(static_cast<int>(std::lround(std::min(steps, most))) + 1, 2, DiffuseLattice::kMostNodes);
  }
  return nodes;
}

CubeMap latticeCapture(const CubeMap& capture) {
  constexpr int kMost = 128;
  const int size = std::min(capture.faceSize(), kMost);
  if (capture.empty() || capture.faceSize() % size != 0) return capture;
  return reducedCube(capture, kMost);
}

CubeMap plainMeans(const CubeMap& capture) {
  const int faceSize = capture.faceSize();
  CubeMap means(faceSize, fullLevels(faceSize));
  const auto count = static_cast<std::size_t>(faceSize) * static_cast<std::size_t>(faceSize) * 4;
  for (int face = 0; face < 6; ++face) std::copy_n(capture.face(0, face), count, means.face(0, face));
  for (int level = 1; level < means.levels(); ++level) {
    const int size = means.levelSize(level), below = means.levelSize(level - 1);
    const auto edge = [below](int i) { return -1.0 + 2.0 * i / below; };
    for (int row = 0; row < size; ++row) {
      for (int column = 0; column < size; ++column) {
        double angles[4], whole = 0.0;
        for (int i = 0; i < 4; ++i) {
          const int x = 2 * column + (i & 1), y = 2 * row + (i >> 1);
          whole += angles[i] = cubeSolidAngle(edge(x), edge(y), edge(x + 1), edge(y + 1));
        }
        for (int face = 0; face < 6; ++face) {
          glm::vec4 sum(0.0f);
          for (int i = 0; i < 4; ++i) {
            sum += static_cast<float>(angles[i] / whole) *
                   means.texel(level - 1, face, 2 * column + (i & 1), 2 * row + (i >> 1));
          }
          means.setTexel(level, face, column, row, sum);
        }
      }
    }
  }
  return means;
}

DiffuseLattice makeDiffuseLattice(const CubeMap& means, const shading::ProbeShape& probe, const glm::mat3& mapFromProbe,
                                  const glm::mat3& worldFromProbe, const LatticeSettings& settings,
                                  const CubeMap* sky) {
  DiffuseLattice lattice;
  if (means.empty()) return lattice;
  const glm::vec3 low = probe.boxMin - settings.reachLow;
  const glm::vec3 size = glm::max(probe.boxMax + settings.reachHigh - low, glm::vec3(0.0f));
  lattice.boxLow = probe.boxMin;
  lattice.boxHigh = probe.boxMax;
  const auto metre = static_cast<float>(metreOf(probe.boxMax - probe.boxMin));
  lattice.nodes = latticeNodes(size, settings.spacing * metre);
  lattice.inset = glm::min(glm::vec3(settings.inset * metre), 0.25f * size);
  lattice.low = low + lattice.inset;
  lattice.high = low + size - lattice.inset;
  const auto nodeCount = static_cast<std::size_t>(lattice.nodes.x * lattice.nodes.y * lattice.nodes.z);
  lattice.texels.resize(DiffuseLattice::kParts * nodeCount);
  const std::vector<LatticeRay> rays = latticeRays(raysOfNode(settings.rays, nodeCount), worldFromProbe);
  const float faceSize = static_cast<float>(means.faceSize());
  // Solid angle of a ray over that of a texel, on average.
  const float texelsPerRay = 6.0f * faceSize * faceSize / static_cast<float>(rays.size());
  const float skySide = sky != nullptr ? static_cast<float>(sky->faceSize()) : 1.0f;
  const float skyLevel = 0.5f * std::log2(std::max(6.0f * skySide * skySide / static_cast<float>(rays.size()), 1.0f));
  tbb::parallel_for(std::size_t(0), nodeCount, [&](std::size_t node) {
    const int x = static_cast<int>(node) % lattice.nodes.x, rest = static_cast<int>(node) / lattice.nodes.x;
    const glm::vec3 place(nodeAt(lattice.low.x, lattice.high.x, x, lattice.nodes.x),
                          nodeAt(lattice.low.y, lattice.high.y, rest % lattice.nodes.y, lattice.nodes.y),
                          nodeAt(lattice.low.z, lattice.high.z, rest / lattice.nodes.y, lattice.nodes.z));
    std::array<glm::vec3, 9> sums{};
    for (const LatticeRay& ray : rays) {
      const shading::ProbeHit hit = shading::projectRay(probe, place, ray.direction, ray.direction);
      const float patch = texelsPerRay * shading::footprintScale(probe, hit, ray.direction);
      const float level = 0.5f * std::log2(std::max(patch, 1.0e-6f));
      const glm::vec4 seen = means.fetch(mapFromProbe * hit.direction, level);
      glm::vec3 light(seen);
      if (sky != nullptr && seen.w < 1.0f)
        light += (1.0f - seen.w) * glm::vec3(sky->fetch(ray.directionWorld, skyLevel));
      for (std::size_t k = 0; k < 9; ++k) sums[k] += ray.basis[k] * light;
    }
    for (std::size_t i = 0; i < 4 * DiffuseLattice::kParts; ++i) {
      const float value = i < 27 ? sums[i / 3][static_cast<int>(i % 3)] : 1.0f;  // the last: its light is its own
      lattice.texels[(i / 4) * nodeCount + node][static_cast<int>(i % 4)] = value;
    }
  });
  return lattice;
}

}  // namespace boxprobe
