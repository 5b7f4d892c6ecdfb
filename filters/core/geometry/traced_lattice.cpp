#include "filters/core/geometry/traced_lattice.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>
#include <glm/vector_relational.hpp>
#include <optional>
#include <utility>

#include "filters/core/geometry/probe_reach.h"
#include "filters/math/shared/shared_math.h"

namespace boxprobe {

namespace {

constexpr double kTracePi = 3.14159265358979323846;
// A node that sees more backs than this, of all it sees, is within something.
constexpr double kMostBacks = 0.3;
// Rays of all nodes together; more nodes have fewer each.
constexpr int kRaysOfAll = 1 << 18, kFewestRays = 128;
// Light goes from node to node until less than this of it changes, and at most so often.
constexpr double kNodesAtRest = 0.002;
constexpr int kMostNodeBounces = 32;
// A texel of the capture tells of a surface if it shows so much of any.
constexpr float kLeastCover = 0.1f;

// The end of a ray that the capture origin does not see: it scatters what the lattice itself has there.
struct FarEnd {
  glm::vec3 place{0.0f};   // probe frame
  glm::vec3 facing{0.0f};  // its normal, probe frame
  glm::vec3 normal{0.0f};  // world
  glm::vec3 albedo{0.0f};
  std::size_t ray = 0;
};

struct TracedNode {
  std::array<glm::vec3, 9> sums{};  // of all light but that
  std::vector<FarEnd> ends;
  bool fronts = true;  // of nearly all surfaces around it
  bool known = true;   // false: within something
};

// A capture with the sky in it, premultiplied by its coverage instead: coarse texels would have the sky between beams
// in the light of the beams, and a ray that meets one has been weighed against the sky before.
CubeMap withoutSky(const CubeMap& means, const LatticeSurroundings& in) {
  const int size = means.faceSize();
  CubeMap surfaces(size, 1);
  const glm::mat3 worldFromMap(in.worldFromProbe * glm::transpose(in.mapFromProbe));
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < size * size; ++i) {
      const int row = i / size, column = i % size;
      const glm::vec4 seen = means.texel(0, face, column, row);
      const float cover = std::clamp(seen.w, 0.0f, 1.0f);
      glm::vec3 light(seen);
      if (cover < 1.0f) {
        const glm::vec3 direction =
            shading::cubeDirection(face, 2.0f * (static_cast<float>(column) + 0.5f) / static_cast<float>(size) - 1.0f,
                                   2.0f * (static_cast<float>(row) + 0.5f) / static_cast<float>(size) - 1.0f);
        light -= (1.0f - cover) * glm::vec3(in.sky->fetch(worldFromMap * direction, 0.0f));
      }
      light = cover > 0.0f ? glm::max(light, glm::vec3(0.0f)) : glm::vec3(0.0f);
      surfaces.setTexel(0, face, column, row, glm::vec4(light, cover));
    }
  }
  return plainMeans(surfaces);
}

// Does a ray along `direction` meet a drawn lamp's shining side there? `at`: world, up to `off` from the lamp's plane.
bool onLamp(const LatticeSurroundings& in, const SightLines::Met& hit, const glm::dvec3& at,
            const glm::dvec3& direction, double off) {
  if (hit.emitted == glm::vec3(0.0f)) return false;
  for (const std::size_t k : in.drawn) {
    const SceneLamp& lamp = in.lamps->lamps[k];
    if (std::abs(glm::dot(at - lamp.middle, lamp.normal)) > off) continue;
    if (!lamp.bothSides && glm::dot(direction, lamp.normal) >= 0.0) continue;
    bool inside = true;
    double farthest = 0.0;
    for (std::size_t i = 0; i < lamp.corners.size(); ++i) {
      const glm::dvec3 &a = lamp.corners[i], &b = lamp.corners[(i + 1) % lamp.corners.size()];
      inside &= glm::dot(glm::cross(b - a, at - a), lamp.normal) >= 0.0;
      farthest = std::max(farthest, glm::length(a - lamp.middle));
    }
    // The polygon of a round lamp leaves some of its rim out.
    const bool round = lamp.corners.size() == shading::kLampCorners && glm::length(at - lamp.middle) <= farthest;
    if (inside || round) return true;
  }
  return false;
}

class NodeTracer {
 public:
  NodeTracer(const DiffuseLattice& base, const CubeMap& means, const LatticeSurroundings& in, int rays)
      : base_(base), means_(means), in_(in) {
    const auto count = static_cast<int>(base.texels.size() / DiffuseLattice::kParts);
    rays_ = std::clamp(kRaysOfAll / std::max(count, 1), std::min(kFewestRays, rays), rays);
    const glm::vec3 size = base.high - base.low;
    margin_ = 3.0e-4 * static_cast<double>(std::max({size.x, size.y, size.z}));
    far_ = 1.0e4 * static_cast<double>(std::max({size.x, size.y, size.z}));
    low_ = base.low - base.inset;
    high_ = base.high + base.inset;
    const glm::vec3 wall(static_cast<float>(kWallThickness * metreOf(base.boxHigh - base.boxLow)));
    wallsLow_ = base.boxLow - wall;
    wallsHigh_ = base.boxHigh + wall;
    for (const std::size_t lamp : in.drawn) {
      polygons_.push_back(lampPolygon(in.lamps->lamps[lamp], in.originWorld));
    }
    const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
    for (int i = 0; i < rays_; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / rays_, phi = 2.0 * kTracePi * (i * golden - std::floor(i * golden));
      const double r = std::sqrt(std::max(1.0 - z * z, 0.0));
      directions_.push_back(glm::normalize(in.worldFromProbe * glm::dvec3(r * std::cos(phi), r * std::sin(phi), z)));
      basis_.push_back(latticeBasis(glm::vec3(directions_.back()), 4.0 * kTracePi / rays_));
    }
    const auto side = static_cast<double>(means.faceSize());
    texelsPerRay_ = 6.0 * side * side / rays_;
    if (!in.sky) return;
    const CubeMap sky = plainMeans(*in.sky);
    const auto skySide = static_cast<double>(sky.faceSize());
    const double level = 0.5 * std::log2(std::max(6.0 * skySide * skySide / rays_, 1.0));
    for (const glm::dvec3& direction : directions_) {
      sky_.emplace_back(sky.fetch(glm::vec3(direction), static_cast<float>(level)));
    }
  }

  TracedNode trace(const glm::vec3& place) const {
    TracedNode node;
    const glm::dvec3 from = in_.originWorld + in_.worldFromProbe * glm::dvec3(place);
    int met = 0, backs = 0;
    for (std::size_t i = 0; i < directions_.size(); ++i) {
      const auto hit = in_.lines->first(from, directions_[i]);
      met += hit ? 1 : 0;
      backs += hit && hit->back ? 1 : 0;
      const glm::vec3 light = hit            ? ofSurface(from, i, *hit, node.ends)
                              : sky_.empty() ? glm::vec3(ofMap(directions_[i], texelsPerRay_))
                                             : sky_[i];
      for (std::size_t k = 0; k < 9; ++k) node.sums[k] += basis_[i][k] * light;
    }
    node.fronts = backs <= kMostBacks * met;
    node.known = node.fronts || originSees(from);
    if (!node.known) node.ends.clear();
    return node;
  }

  // The capture origin stands in the open, and so does what it sees, also among walls that turn their backs to a room.
  bool originSees(const glm::dvec3& world) const {
    const glm::dvec3 way = world - in_.originWorld;
    const double distance = glm::length(way);
    if (distance <= margin_) return true;
    const auto hit = in_.lines->first(in_.originWorld, way / distance);
    return !hit || hit->distance > distance;
  }

  // All light of a node, where `lattice` is what its far ends receive beside lamps and light sources.
  std::array<glm::vec3, 9> lit(const TracedNode& node, const DiffuseLattice& lattice) const {
    std::array<glm::vec3, 9> sums = node.sums;
    const shading::LatticeShape shape = lattice.shape();
    for (const FarEnd& end : node.ends) {
      const glm::vec3 arrives = shading::latticeIrradiance(shape, end.place, end.facing, end.normal);
      const glm::vec3 light = end.albedo * glm::max(arrives, glm::vec3(0.0f));
      for (std::size_t k = 0; k < 9; ++k) sums[k] += basis_[end.ray][k] * light;
    }
    return sums;
  }

 private:
  glm::vec4 ofMap(const glm::dvec3& directionWorld, double texels) const {
    const glm::dvec3 inMap = in_.mapFromProbe * (glm::transpose(in_.worldFromProbe) * directionWorld);
    return means_.fetch(glm::vec3(inMap), static_cast<float>(0.5 * std::log2(std::max(texels, 1.0e-6))));
  }

  // What a surface shows there; nothing where hardly any is to be seen in that texel.
  std::optional<glm::vec3> ofCovered(const glm::dvec3& directionWorld, double texels) const {
    const glm::vec4 seen = ofMap(directionWorld, texels);
    if (!in_.open && !in_.sky) return glm::vec3(seen);
    if (seen.w < kLeastCover) return std::nullopt;
    return glm::vec3(seen) / std::min(seen.w, 1.0f);
  }

  // Irradiance over pi of a sky that nothing hides.
  glm::vec3 underSky(const glm::dvec3& normal) const {
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < sky_.size(); ++i) {
      sum += static_cast<float>(std::max(glm::dot(normal, directions_[i]), 0.0)) * sky_[i];
    }
    return sum * (4.0f / static_cast<float>(rays_));
  }

  bool within(const glm::dvec3& inProbe) const {
    const glm::vec3 p(inProbe), more = glm::vec3(0.01f) * (high_ - low_);
    return glm::all(glm::greaterThanEqual(p, low_ - more)) && glm::all(glm::lessThanEqual(p, high_ + more));
  }

  // Among the nodes, and not in the box, nor in its walls.
  bool beyondWalls(const glm::dvec3& inProbe) const {
    const glm::vec3 p(inProbe);
    return within(inProbe) && (glm::any(glm::lessThan(p, wallsLow_)) || glm::any(glm::greaterThan(p, wallsHigh_)));
  }

  glm::vec3 ofSurface(const glm::dvec3& from, std::size_t ray, const SightLines::Met& hit,
                      std::vector<FarEnd>& ends) const {
    const glm::dvec3& direction = directions_[ray];
    const glm::dvec3 at = from + hit.distance * direction, off = at + margin_ * hit.normal, way = at - in_.originWorld;
    const double length = glm::length(way);
    const glm::dvec3 inProbe = glm::transpose(in_.worldFromProbe) * (off - in_.originWorld);
    if (onLamp(in_, hit, at, direction, 0.1 * margin_)) return glm::vec3(0.0f);  // its shape gives it all
    if (length > 0.0 && glm::dot(way, hit.normal) < 0.0 && !in_.lines->blocked(in_.originWorld, off, true)) {
      const double towards = std::max(-glm::dot(hit.normal, direction), 0.05);
      const double seen = -glm::dot(hit.normal, way) / length, ratio = hit.distance / length;
      // Seen through a door, a coarse texel would have the light of the wall beside it.
      const double most = beyondWalls(inProbe) ? 1.0 : 1.0e300;
      const auto light = ofCovered(way / length, std::min(texelsPerRay_ * ratio * ratio * seen / towards, most));
      if (light) return *light;
    }
    if (const auto seen = throughOpening(from, direction, hit.distance)) {
      if (const auto light = ofCovered(*seen, texelsPerRay_)) return *light;
    }
    if (!sky_.empty() && !within(inProbe) && !in_.lines->first(off, hit.normal)) {
      return hit.emitted + hit.albedo * (arriving(off, hit.normal) + underSky(hit.normal));
    }
    const glm::vec3 facing(glm::transpose(in_.worldFromProbe) * hit.normal);
    ends.push_back({glm::vec3(inProbe), facing, glm::vec3(hit.normal), hit.albedo, ray});
    return hit.emitted + hit.albedo * arriving(off, hit.normal);
  }

  // Of a ray that leaves what the nodes light, through a door: towards where it does, if the origin sees that. Its map
  // has the next room's light there, which nothing else here knows.
  std::optional<glm::dvec3> throughOpening(const glm::dvec3& from, const glm::dvec3& direction, double distance) const {
    const glm::dmat3 probeFromWorld = glm::transpose(in_.worldFromProbe);
    const glm::dvec3 start = probeFromWorld * (from - in_.originWorld), along = probeFromWorld * direction;
    double leaves = 1.0e300;
    for (int axis = 0; axis < 3; ++axis) {
      if (std::abs(along[axis]) < 1.0e-9) continue;
      const auto side = static_cast<double>(along[axis] > 0.0 ? high_[axis] : low_[axis]);
      leaves = std::min(leaves, (side - start[axis]) / along[axis]);
    }
    if (!(leaves > 0.0) || distance < leaves + 20.0 * margin_) return std::nullopt;
    const glm::dvec3 at = from + leaves * direction, way = at - in_.originWorld;
    const double length = glm::length(way);
    if (!(length > 0.0) || in_.lines->blocked(in_.originWorld, at, true)) return std::nullopt;
    return way / length;
  }

  // Irradiance over pi of lamps and light sources at a place that the capture origin does not see.
  glm::vec3 arriving(const glm::dvec3& at, const glm::dvec3& normal) const {
    const glm::vec3 n(normal), position(at - in_.originWorld);
    glm::vec3 sum(0.0f);
    for (std::size_t i = 0; i < polygons_.size(); ++i) {
      const float share = shading::lampDiffuse(&polygons_[i], position, n);
      if (share <= 1.0e-6f) continue;
      const SceneLamp& lamp = in_.lamps->lamps[in_.drawn[i]];
      const glm::dvec3 to = lamp.middle + (at - lamp.middle) * 1.0e-3;
      if (!in_.lines->blocked(at, to, true)) sum += share * glm::vec3(lamp.radiance);
    }
    static const std::vector<Light> kNone;
    for (const Light& light : in_.lights ? *in_.lights : kNone) {
      const bool sun = light.type == LightType::Directional;
      const glm::dvec3 way = sun ? -glm::normalize(light.direction) * far_ : light.position - at;
      const double distance = std::max(glm::length(way), 1.0e-9), cosine = glm::dot(way, normal) / distance;
      if (cosine <= 0.0) continue;
      double falls = 1.0;
      if (!sun) {
        const auto perRange = static_cast<float>(light.range > 0.0 ? 1.0 / light.range : 0.0);
        falls = static_cast<double>(shading::distanceFalloff(static_cast<float>(distance), perRange));
        if (light.type == LightType::Spot) {
          const auto cosineOf = [](double degrees) { return static_cast<float>(std::cos(glm::radians(degrees))); };
          const auto axis = static_cast<float>(-glm::dot(way / distance, glm::normalize(light.direction)));
          falls *= static_cast<double>(
              shading::coneFalloff(axis, cosineOf(light.outerConeDegrees), cosineOf(light.innerConeDegrees)));
        }
      }
      if (falls <= 0.0 || in_.lines->blocked(at, at + 0.999 * way, false)) continue;
      sum += static_cast<float>(falls * cosine / kTracePi) * light.intensity * light.color;
    }
    return sum;
  }

  const DiffuseLattice& base_;
  const CubeMap& means_;
  const LatticeSurroundings& in_;
  int rays_ = 0;
  double margin_ = 0.0, far_ = 0.0, texelsPerRay_ = 1.0;
  glm::vec3 low_{0.0f}, high_{0.0f};            // of what the nodes light, probe frame
  glm::vec3 wallsLow_{0.0f}, wallsHigh_{0.0f};  // of the box with its walls
  std::vector<LampPolygon> polygons_;           // relative to the capture origin, world axes
  std::vector<glm::dvec3> directions_;          // world
  std::vector<std::array<float, 9>> basis_;
  std::vector<glm::vec3> sky_;  // along each direction; empty: the capture shows it
};

// How much of the way from a node to the next along an axis surfaces cut, by rays beside each other both ways, and the
// means of where on the way that begins and ends. Of a node within something, the way out of it is cut.
struct CutWay {
  float cut = 0.0f, begins = 0.0f, ends = 0.0f;
};

CutWay cutWay(const SightLines& lines, const glm::dvec3& from, const glm::dvec3& step, const glm::dvec3& beside,
              const glm::dvec3& above, bool fromKnown, bool toKnown) {
  CutWay way;
  const double length = glm::length(step);
  if ((!fromKnown && !toKnown) || !(length > 0.0)) return way;
  constexpr int kWays[5][2] = {{0, 0}, {1, 0}, {-1, 0}, {0, 1}, {0, -1}};
  for (const auto& k : kWays) {
    const glm::dvec3 start = from + static_cast<double>(k[0]) * beside + static_cast<double>(k[1]) * above;
    const auto there = fromKnown ? lines.first(start, step / length) : std::nullopt;
    const auto back = toKnown ? lines.first(start + step, -step / length) : std::nullopt;
    const double begins = there ? there->distance / length : 1.0, ends = back ? 1.0 - back->distance / length : 0.0;
    const bool cutThere = fromKnown && begins < 1.0, cutBack = toKnown && ends > 0.0;
    if (!cutThere && !cutBack) continue;
    const double low = cutThere ? begins : fromKnown ? ends : 0.0, high = cutBack ? ends : toKnown ? begins : 1.0;
    way.cut += 0.2f;
    way.begins += 0.2f * static_cast<float>(std::min(low, high));
    way.ends += 0.2f * static_cast<float>(std::max(low, high));
  }
  return way;
}

void cutWays(DiffuseLattice& lattice, const std::vector<char>& known, const LatticeSurroundings& in) {
  const glm::ivec3 n = lattice.nodes;
  const std::size_t count = known.size();
  const glm::dvec3 step(glm::dvec3(lattice.high - lattice.low) / glm::dvec3(n - 1));
  std::vector<glm::vec4> cuts(DiffuseLattice::kCutParts * count, glm::vec4(0.0f));
  std::atomic<int> found{0};
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t node) {
    const auto i = static_cast<int>(node);
    const glm::ivec3 p(i % n.x, i / n.x % n.y, i / (n.x * n.y));
    const glm::dvec3 from = glm::dvec3(lattice.low) + glm::dvec3(p) * step;
    for (int axis = 0; axis < 3; ++axis) {
      if (p[axis] + 1 >= n[axis]) continue;
      const std::size_t next = node + static_cast<std::size_t>(axis == 0 ? 1 : axis == 1 ? n.x : n.x * n.y);
      // Beside the way by a tenth of it, and never through a wall that the outermost nodes stand before.
      const auto turned = [&](int of) {
        glm::dvec3 v(0.0);
        v[of] = std::min(0.1 * step[of], 7.0 / 15.0 * static_cast<double>(lattice.inset[of]));
        return in.worldFromProbe * v;
      };
      glm::dvec3 along(0.0);
      along[axis] = step[axis];
      const CutWay way = cutWay(*in.lines, in.originWorld + in.worldFromProbe * from, in.worldFromProbe * along,
                                turned((axis + 1) % 3), turned((axis + 2) % 3), known[node] != 0, known[next] != 0);
      if (way.cut <= 0.0f) continue;
      ++found;
      cuts[static_cast<std::size_t>(axis) * count + node] = glm::vec4(way.cut, way.begins, way.ends, 0.0f);
    }
  });
  lattice.cutWays = found;
  if (lattice.cutWays > 0) lattice.cuts = std::move(cuts);
}

// Nodes that are not known take the mean of those around them that are, layer by layer; all as they were if none is.
void fillNodes(DiffuseLattice& lattice, std::vector<char> known) {
  const glm::ivec3 n = lattice.nodes;
  const std::size_t count = known.size();
  for (bool more = true; more;) {
    more = false;
    std::vector<char> next = known;
    for (std::size_t node = 0; node < count; ++node) {
      if (known[node] != 0) continue;
      const auto i = static_cast<int>(node);
      const glm::ivec3 p(i % n.x, i / n.x % n.y, i / (n.x * n.y));
      std::array<glm::vec4, DiffuseLattice::kParts> sum{};
      float weight = 0.0f;
      for (int k = 0; k < 27; ++k) {
        const glm::ivec3 step(k % 3 - 1, k / 3 % 3 - 1, k / 9 - 1), q = p + step;
        if (q.x < 0 || q.y < 0 || q.z < 0 || q.x >= n.x || q.y >= n.y || q.z >= n.z) continue;
        const int index = (q.z * n.y + q.y) * n.x + q.x;
        const auto other = static_cast<std::size_t>(index);
        if (known[other] == 0) continue;
        const float w = 1.0f / static_cast<float>(std::abs(step.x) + std::abs(step.y) + std::abs(step.z));
        for (std::size_t part = 0; part < sum.size(); ++part) sum[part] += w * lattice.texels[part * count + other];
        weight += w;
      }
      if (weight <= 0.0f) continue;
      for (std::size_t part = 0; part < sum.size(); ++part) lattice.texels[part * count + node] = sum[part] / weight;
      next[node] = 1;
      more = true;
    }
    known.swap(next);
  }
}

// How much of all nodes' mean light is another.
double changedBy(const DiffuseLattice& before, const DiffuseLattice& after) {
  const std::size_t count = after.texels.size() / DiffuseLattice::kParts;
  double change = 0.0, whole = 0.0;
  for (std::size_t node = 0; node < count; ++node) {
    for (int c = 0; c < 3; ++c) {
      change += static_cast<double>(std::abs(after.texels[node][c] - before.texels[node][c]));
      whole += static_cast<double>(std::abs(after.texels[node][c]));
    }
  }
  return whole > 0.0 ? change / whole : 0.0;
}

}  // namespace

bool LatticeSurroundings::operator==(const LatticeSurroundings& o) const {
  if (lines != o.lines || originWorld != o.originWorld || worldFromProbe != o.worldFromProbe ||
      mapFromProbe != o.mapFromProbe || drawn.size() != o.drawn.size() || sky != o.sky || open != o.open) {
    return false;
  }
  if (lights != o.lights && !(lights && o.lights && *lights == *o.lights)) return false;
  if (lamps == o.lamps) return drawn == o.drawn;
  return std::equal(drawn.begin(), drawn.end(), o.drawn.begin(), [&](std::size_t i, std::size_t k) {
    const SceneLamp &a = lamps->lamps[i], &b = o.lamps->lamps[k];
    return a.corners == b.corners && a.radiance == b.radiance && a.bothSides == b.bothSides;
  });
}

float tracedSpacing(const glm::vec3& low, const glm::vec3& high, float usual, const CubeMap& means,
                    const LatticeSurroundings& in) {
  if (!in.lines || in.lines->empty()) return usual;
  // Of the rays of a few places in the box: so much goes out where there is a door, so much where there is hardly a
  // box.
  constexpr double kDoor = 0.01, kNoRoom = 0.5;
  constexpr float kBright = 4.0f;  // what is so many times as bright as the capture's mean is taken for a lamp
  constexpr int kPlaces = 3, kRaysOfPlace = 64;
  const glm::dvec3 size(high - low);
  // Walls are not always where the box has them.
  const glm::dvec3 most = glm::dvec3(high) + glm::dvec3(0.1 * std::max({size.x, size.y, size.z}));
  const glm::dvec3 least = glm::dvec3(low) - glm::dvec3(0.1 * std::max({size.x, size.y, size.z}));
  const double golden = 0.5 * (std::sqrt(5.0) - 1.0);
  const double off = 3.0e-5 * std::max({size.x, size.y, size.z});
  int out = 0, all = 0;
  float brightest = 0.0f;  // of what shines and is not drawn as a shape, sum of the colours
  for (int k = 0; k < kPlaces * kPlaces * kPlaces; ++k) {
    const glm::ivec3 place(k % 3, k / 3 % 3, k / 9);
    const glm::dvec3 share = (glm::dvec3(place) + 0.5) / static_cast<double>(kPlaces);
    const glm::dvec3 from = glm::dvec3(low) + share * size;
    for (int i = 0; i < kRaysOfPlace; ++i) {
      const double z = 1.0 - (2.0 * i + 1.0) / kRaysOfPlace,
                   phi = 2.0 * kTracePi * (i * golden - std::floor(i * golden));
      const double r = std::sqrt(1.0 - z * z);
      const glm::dvec3 along(r * std::cos(phi), r * std::sin(phi), z);
      const glm::dvec3 fromWorld = in.originWorld + in.worldFromProbe * from, alongWorld = in.worldFromProbe * along;
      const auto hit = in.lines->first(fromWorld, alongWorld);
      if (hit && hit->back) continue;  // within something
      if (hit && !onLamp(in, *hit, fromWorld + hit->distance * alongWorld, alongWorld, off)) {
        brightest = std::max(brightest, hit->emitted.x + hit->emitted.y + hit->emitted.z);
      }
      ++all;
      const glm::dvec3 at = from + (hit ? hit->distance : 1.0e3 * glm::length(size)) * along;
      const bool stays = glm::all(glm::greaterThanEqual(at, least)) && glm::all(glm::lessThanEqual(at, most));
      out += stays ? 0 : 1;
    }
  }
  const bool opens = out > kDoor * all && out < kNoRoom * all;
  glm::vec4 mean(0.0f);
  for (int face = 0; face < 6 && !means.empty(); ++face) mean += means.texel(means.maxLevel(), face, 0, 0) / 6.0f;
  const bool shines = brightest > kBright * (mean.x + mean.y + mean.z);
  return opens || shines ? 0.5f * usual : usual;
}

DiffuseLattice tracedLattice(const DiffuseLattice& base, const CubeMap& means, const LatticeSurroundings& in,
                             int rays) {
  DiffuseLattice lattice = base;
  if (base.empty() || means.empty() || !in.lines || in.lines->empty()) return lattice;
  const CubeMap surfaces = in.sky && !in.open ? withoutSky(means, in) : CubeMap();
  const NodeTracer tracer(base, surfaces.empty() ? means : surfaces, in, std::max(rays, 1));
  const std::size_t count = base.texels.size() / DiffuseLattice::kParts;
  std::vector<TracedNode> nodes(count);
  const glm::vec3 step = (base.high - base.low) / glm::vec3(base.nodes - 1);
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t node) {
    const auto i = static_cast<int>(node);
    const glm::ivec3 p(i % base.nodes.x, i / base.nodes.x % base.nodes.y, i / (base.nodes.x * base.nodes.y));
    nodes[node] = tracer.trace(base.low + glm::vec3(p) * step);
  });
  std::vector<char> known(count, 1);
  std::size_t fronts = 0;
  for (std::size_t node = 0; node < count; ++node) {
    known[node] = nodes[node].known ? 1 : 0;
    fronts += nodes[node].fronts ? 1 : 0;
  }
  // Fronts and backs mean something where the capture origin sees fronts, and where many nodes do. Few do of a round
  // room within a large influence.
  const bool fills = tracer.trace(glm::vec3(0.0f)).fronts || 4 * fronts >= count;
  cutWays(lattice, fills ? known : std::vector<char>(count, 1), in);
  // What far ends receive is the light of the nodes around them, which see far ends themselves: again, until that makes
  // no difference. Surfaces scatter less than they receive, so that it ends.
  for (int bounce = 0; bounce < kMostNodeBounces; ++bounce) {
    const DiffuseLattice before = lattice;
    tbb::parallel_for(std::size_t(0), count, [&](std::size_t node) {
      const std::array<glm::vec3, 9> sums = tracer.lit(nodes[node], before);
      for (std::size_t k = 0; k < std::size_t{4} * DiffuseLattice::kParts; ++k) {
        lattice.texels[(k / 4) * count + node][static_cast<int>(k % 4)] =
            k < 27 ? sums[k / 3][static_cast<int>(k % 3)] : 1.0f;
      }
    });
    if (fills) fillNodes(lattice, known);
    if (changedBy(before, lattice) < kNodesAtRest) break;
  }
  for (std::size_t node = 0; node < count; ++node) {
    if (fills && known[node] == 0) lattice.texels[(DiffuseLattice::kParts - 1) * count + node].w = 0.0f;
  }
  return lattice;
}

}  // namespace boxprobe
