// See sky_openness.h.
#include "filters/core/geometry/sky_openness.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>

#include "filters/math/shared/openness_math.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;
constexpr int kNodes = 48;        // along the longest side of what stands there
constexpr int kMargin = 3;        // nodes beyond it
constexpr int kOpenRays = 64;     // from a node
constexpr double kNear = 3.2;     // spacings: no surface looks up a node that has none so near
constexpr double kWithin = 0.6;   // of the rays: so many backs are seen from within a thing only
constexpr double kCracks = 0.1;   // of the rays: if more reach the sky, the backs are the inner sides of open sheets
constexpr double kMoment = 0.75;  // largest along an axis

struct Node {
  enum State { Far, Seen, Within } state = Far;
  glm::dvec3 moment{0.0};
  double open = 1.0;
};

/// Even over the sphere, along a spiral that is turned by `turn` from node to node.
glm::dvec3 evenly(int ray, int of, double turn) {
  const double y = 1.0 - (2.0 * ray + 1.0) / of, r = std::sqrt(std::max(1.0 - y * y, 0.0));
  const double angle = 2.399963229728653 * ray + turn;
  return {r * std::cos(angle), y, r * std::sin(angle)};
}

class Lattice {
 public:
  Lattice(const SightLines& lines, const Box& bounds, SkyOpenness& result) : lines_(lines), result_(result) {
    const glm::dvec3 size = bounds.size();
    result.spacing = std::max({size.x, size.y, size.z}) / kNodes;
    result.nodes = glm::ivec3(glm::ceil(size / result.spacing)) + 1 + 2 * kMargin;
    const glm::dvec3 extent = result.spacing * glm::dvec3(result.nodes - 1);
    result.low = 0.5 * (bounds.min + bounds.max) - 0.5 * extent;
    nodes_.resize(static_cast<std::size_t>(result.nodes.x) * static_cast<std::size_t>(result.nodes.y) *
                  static_cast<std::size_t>(result.nodes.z));
  }

  void trace(const std::function<bool()>& stop) {
    std::atomic<std::size_t> rays{0};
    tbb::parallel_for(0, result_.nodes.z, [&](int z) {
      for (int y = 0; y < result_.nodes.y; ++y) {
        if (stop && stop()) return;
        for (int x = 0; x < result_.nodes.x; ++x) rays += traceNode({x, y, z});
      }
    });
    result_.rays = rays;
  }

  /// Nodes within things take what the nodes around them have, since surfaces between both are lit from outside.
  void spread() {
    for (int round = 0; round < 2; ++round) {
      std::vector<Node> next = nodes_;
      tbb::parallel_for(0, result_.nodes.z, [&](int z) {
        for (int y = 0; y < result_.nodes.y; ++y) {
          for (int x = 0; x < result_.nodes.x; ++x) spreadTo({x, y, z}, next[index({x, y, z})]);
        }
      });
      nodes_ = std::move(next);
    }
  }

  void write() const {
    result_.texels.resize(4 * nodes_.size());
    const auto byte = [](double value) {
      return static_cast<std::uint8_t>(std::lround(255.0 * std::clamp(value, 0.0, 1.0)));
    };
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      for (int axis = 0; axis < 3; ++axis) {
        result_.texels[4 * i + static_cast<std::size_t>(axis)] = byte(0.5 + 0.5 * nodes_[i].moment[axis] / kMoment);
      }
      result_.texels[4 * i + 3] = byte(nodes_[i].open);
    }
  }

 private:
  std::size_t index(const glm::ivec3& at) const {
    return static_cast<std::size_t>((at.z * result_.nodes.y + at.y) * result_.nodes.x + at.x);
  }

  bool nearAnything(const glm::dvec3& place) const {
    for (int x = -1; x <= 1; ++x) {
      for (int y = -1; y <= 1; ++y) {
        for (int z = -1; z <= 1; ++z) {
          if (x == 0 && y == 0 && z == 0) continue;
          const glm::dvec3 away = kNear * result_.spacing * glm::normalize(glm::dvec3(x, y, z));
          if (lines_.blocked(place, place + away, true)) return true;
        }
      }
    }
    return false;
  }

  /// Returns how many rays it took.
  std::size_t traceNode(const glm::ivec3& at) {
    const glm::dvec3 place = result_.low + result_.spacing * glm::dvec3(at);
    // Nodes lie in the sides of `bounds`, where things end: what starts in a surface meets it at once, all around.
    const glm::dvec3 from = place + result_.spacing * glm::dvec3(0.0131, 0.0173, 0.0111);
    if (!nearAnything(from)) return 0;
    Node& node = nodes_[index(at)];
    const double turn =
        2.0 * kPi * std::fmod(0.7548776662466927 * at.x + 0.5698402909980532 * at.y + 0.8191725133961645 * at.z, 1.0);
    int open = 0, backs = 0;
    for (int ray = 0; ray < kOpenRays; ++ray) {
      const glm::dvec3 direction = evenly(ray, kOpenRays, turn);
      const auto met = lines_.first(from, direction);
      if (!met) {
        ++open;
        node.moment += direction;
      } else if (met->back) {
        ++backs;
      }
    }
    node.state = backs > kWithin * kOpenRays && open < kCracks * kOpenRays ? Node::Within : Node::Seen;
    node.open = static_cast<double>(open) / kOpenRays;
    node.moment *= 3.0 / kOpenRays;
    return kOpenRays;
  }

  void spreadTo(const glm::ivec3& at, Node& node) const {
    if (node.state != Node::Within) return;
    Node sum;
    sum.open = 0.0;
    double weights = 0.0;
    const glm::ivec3 from = glm::max(at - 1, glm::ivec3(0)), to = glm::min(at + 1, result_.nodes - 1);
    for (int z = from.z; z <= to.z; ++z) {
      for (int y = from.y; y <= to.y; ++y) {
        for (int x = from.x; x <= to.x; ++x) {
          const Node& other = nodes_[index({x, y, z})];
          if (other.state != Node::Seen) continue;
          const glm::dvec3 away(glm::ivec3(x, y, z) - at);
          const double weight = 1.0 / glm::dot(away, away);
          sum.open += weight * other.open;
          sum.moment += weight * other.moment;
          weights += weight;
        }
      }
    }
    if (weights > 0.0) node = {Node::Seen, sum.moment / weights, sum.open / weights};
  }

  const SightLines& lines_;
  SkyOpenness& result_;
  std::vector<Node> nodes_;
};

}  // namespace

float SkyOpenness::at(const glm::dvec3& position, const glm::vec3& normal) const {
  const glm::dvec3 place =
      glm::clamp((position + off() * glm::dvec3(normal) - low) / spacing, glm::dvec3(0.0), glm::dvec3(nodes - 1));
  const glm::ivec3 first = glm::min(glm::ivec3(place), nodes - 2);
  const glm::vec3 share(place - glm::dvec3(first));
  glm::vec4 texel(0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    const glm::ivec3 step(corner & 1, corner >> 1 & 1, corner >> 2);
    const glm::ivec3 at = first + step;
    const auto node = static_cast<std::size_t>((at.z * nodes.y + at.y) * nodes.x + at.x);
    float weight = 1.0f;
    for (int axis = 0; axis < 3; ++axis) weight *= step[axis] == 1 ? share[axis] : 1.0f - share[axis];
    for (int c = 0; c < 4; ++c) {
      texel[c] += weight * static_cast<float>(texels[4 * node + static_cast<std::size_t>(c)]) / 255.0f;
    }
  }
  return shading::skyOpenness(texel, normal);
}

SkyOpenness tracedSkyOpenness(const SightLines& lines, const Box& bounds, const std::function<bool()>& stop) {
  const glm::dvec3 size = bounds.size();
  const double longest = std::max({size.x, size.y, size.z});
  if (lines.empty() || !(longest > 0.0) || !std::isfinite(longest)) return {};
  SkyOpenness result;
  Lattice lattice(lines, bounds, result);
  lattice.trace(stop);
  if (stop && stop()) return {};
  lattice.spread();
  lattice.write();
  return result;
}

}  // namespace boxprobe
