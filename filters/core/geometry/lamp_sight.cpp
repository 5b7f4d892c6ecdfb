#include "filters/core/geometry/lamp_sight.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/math/cube/diffuse_lattice.h"

namespace boxprobe {

namespace {

constexpr double kSightPi = 3.14159265358979323846;
constexpr int kRays = SightSettings::kRays, kFewRays = kRays / 4;
// A lamp of another room counts if it could give so much of what the strongest gives.
constexpr double kSightWeakest = 1.0e-3;
constexpr std::size_t kMostCandidates = 16;

// The first four, and all sixteen, are stratified over the unit square: van der Corput's and Sobol's sequences.
glm::dvec2 squarePoint(unsigned i) {
  unsigned second = 0;
  for (unsigned v = 1u << 31, k = i; k != 0; k >>= 1, v ^= v >> 1) second ^= (k & 1u) != 0 ? v : 0;
  double first = 0.0;
  for (double digit = 0.5; i != 0; i >>= 1, digit *= 0.5) first += (i & 1u) != 0 ? digit : 0.0;
  return {first + 0.5 / kRays, second / 4294967296.0 + 0.5 / kRays};
}

std::vector<glm::dvec3> pointsOf(const std::vector<glm::dvec3>& corners) {
  std::vector<double> upTo = {0.0};
  for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
    upTo.push_back(upTo.back() + glm::length(glm::cross(corners[i] - corners[0], corners[i + 1] - corners[0])));
  }
  std::vector<glm::dvec3> points;
  for (unsigned i = 0; i < kRays; ++i) {
    const glm::dvec2 u = squarePoint(i);
    const double at = u.x * upTo.back();
    std::size_t k = 1;
    while (k + 1 < upTo.size() && upTo[k] < at) ++k;
    const double within = std::clamp((at - upTo[k - 1]) / std::max(upTo[k] - upTo[k - 1], 1.0e-300), 0.0, 1.0);
    const double r = std::sqrt(u.y);
    points.push_back(corners[0] +
                     r * ((1.0 - within) * (corners[k] - corners[0]) + within * (corners[k + 1] - corners[0])));
  }
  return points;
}

double nearestInBox(const Probe& probe, const glm::dmat3& boxFromWorld, const glm::dvec3& point) {
  const glm::dvec3 half = 0.5 * probe.box.size(), off = boxFromWorld * (point - probe.box.center());
  return glm::length(off - glm::clamp(off, -half, half));
}

// The lattice's nodes and where they lie.
class Nodes {
 public:
  Nodes(const SightTask& task, const glm::ivec3& count)
      : n(count), middle_(task.box.center()), turn_(rotationMatrix(task.rotationDegrees)) {
    const glm::dvec3 size = task.box.size(), inset = glm::min(glm::dvec3(0.02 * metreOf(size)), 0.01 * size);
    low = -0.5 * size + inset;
    high = 0.5 * size - inset;
    step = (high - low) / glm::dvec3(n - 1);
  }
  std::size_t size() const { return static_cast<std::size_t>(n.x) * static_cast<std::size_t>(n.y * n.z); }
  glm::ivec3 at(std::size_t node) const {
    const auto i = static_cast<int>(node);
    return {i % n.x, i / n.x % n.y, i / (n.x * n.y)};
  }
  glm::dvec3 world(std::size_t node) const { return middle_ + turn_ * (low + glm::dvec3(at(node)) * step); }
  // Directions 0 to 5, world: +X, -X, +Y, -Y, +Z, -Z of the box; and the node that way.
  glm::dvec3 along(int i) const { return (i % 2 == 0 ? 1.0 : -1.0) * turn_[i / 2]; }
  std::optional<std::size_t> next(std::size_t node, int i) const {
    glm::ivec3 p = at(node);
    const int k = p[i / 2] += i % 2 == 0 ? 1 : -1;
    if (k < 0 || k >= n[i / 2]) return std::nullopt;
    return static_cast<std::size_t>((p.z * n.y + p.y) * n.x + p.x);
  }
  double spacing() const { return std::min({step.x, step.y, step.z}); }
  // Calls f(neighbour, squared distance in nodes) for those of the 26 that exist.
  template <typename F>
  void around(std::size_t node, const F& f) const {
    const glm::ivec3 p = at(node);
    for (int z = std::max(p.z - 1, 0); z <= std::min(p.z + 1, n.z - 1); ++z) {
      for (int y = std::max(p.y - 1, 0); y <= std::min(p.y + 1, n.y - 1); ++y) {
        for (int x = std::max(p.x - 1, 0); x <= std::min(p.x + 1, n.x - 1); ++x) {
          const int far = std::abs(x - p.x) + std::abs(y - p.y) + std::abs(z - p.z);
          if (far > 0) f(static_cast<std::size_t>((z * n.y + y) * n.x + x), far);
        }
      }
    }
  }

  const glm::ivec3 n;
  glm::dvec3 low{0.0}, high{0.0}, step{1.0};

 private:
  glm::dvec3 middle_;
  glm::dmat3 turn_;
};

// A node's say where surfaces are lit: 1, less where a sheet between it and its neighbour is close to it, so that it
// does not count on the sheet's other side; kHardly within things.
constexpr float kHardly = 16.0f / 255.0f;

struct NodeStates {
  std::vector<char> valid;
  std::vector<float> say;
};

// Within things are nodes that see more backs than fronts. Where hardly a node is valid, fronts and backs mean nothing
// in this scene, and all are.
NodeStates nodeStates(const SightLines& lines, const Nodes& nodes, std::size_t& rays) {
  NodeStates states{std::vector<char>(nodes.size(), 1), std::vector<float>(nodes.size(), 1.0f)};
  std::vector<std::array<float, 6>> clear(nodes.size());  // how far it is to the next surface each way, in nodes
  tbb::parallel_for(std::size_t(0), nodes.size(), [&](std::size_t node) {
    int met = 0, backs = 0;
    for (int i = 0; i < 6; ++i) {
      const auto hit = lines.first(nodes.world(node), nodes.along(i));
      met += hit ? 1 : 0;
      backs += hit && hit->back ? 1 : 0;
      clear[node][static_cast<std::size_t>(i)] =
          hit ? static_cast<float>(std::min(hit->distance / nodes.step[i / 2], 10.0)) : 10.0f;
    }
    states.valid[node] = 2 * backs <= met ? 1 : 0;
  });
  rays += 6 * nodes.size();
  const auto left = static_cast<std::size_t>(std::count(states.valid.begin(), states.valid.end(), 1));
  if (4 * left < nodes.size()) std::fill(states.valid.begin(), states.valid.end(), static_cast<char>(1));
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    if (states.valid[node] == 0) states.say[node] = kHardly;
    for (int i = 0; i < 6 && states.valid[node] != 0; ++i) {
      const auto other = nodes.next(node, i);
      const float distance = clear[node][static_cast<std::size_t>(i)];
      if (!other || states.valid[*other] == 0 || distance >= 1.0f) continue;
      states.say[node] = std::min(states.say[node], std::max(2.0f * distance, kHardly));
    }
  }
  return states;
}

// What is not known is the mean of what is known around it, layer by layer.
void fillUnknown(const Nodes& nodes, std::vector<char> known, std::vector<float>& values) {
  for (bool more = true; more;) {
    more = false;
    std::vector<char> next = known;
    std::vector<float> filled = values;
    for (std::size_t node = 0; node < nodes.size(); ++node) {
      if (known[node] != 0) continue;
      float sum = 0.0f, weight = 0.0f;
      nodes.around(node, [&](std::size_t other, int far) {
        if (known[other] == 0) return;
        const float w = 1.0f / static_cast<float>(far);
        sum += w * values[other];
        weight += w;
      });
      if (weight <= 0.0f) continue;
      filled[node] = sum / weight;
      next[node] = 1;
      more = true;
    }
    known.swap(next);
    values.swap(filled);
  }
}

struct Seen {
  std::vector<float> shares;  // of all nodes
  int channel = kSeenByNone;  // or 0: to be given one
};

// `points(node, i)`: the i-th point of what is looked at. `faces(place)`: can the node be lit by it at all?
template <typename Points, typename Faces>
Seen seenShares(const SightLines& lines, const Nodes& nodes, const std::vector<char>& valid, const Points& points,
                const Faces& faces, bool shining, std::size_t& rays, const std::atomic<bool>& cancelled) {
  Seen seen;
  const std::size_t count = nodes.size();
  const double margin = 0.01 * nodes.spacing();
  std::vector<char> asked(count, 0);
  std::vector<int> few(count, 0);
  const auto free = [&](const glm::dvec3& from, int i) {
    const glm::dvec3 to = points(from, i), way = to - from;
    const double length = glm::length(way);
    if (length <= 2.0 * margin) return true;
    return !lines.blocked(from, from + way * (1.0 - margin / length), shining);
  };
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t node) {
    const glm::dvec3 from = nodes.world(node);
    if (valid[node] == 0 || cancelled || !faces(from)) return;
    asked[node] = 1;
    for (int i = 0; i < kFewRays; ++i) few[node] += free(from, i) ? 1 : 0;
  });
  seen.shares.assign(count, 0.0f);
  std::atomic<std::size_t> traced{0};
  tbb::parallel_for(std::size_t(0), count, [&](std::size_t node) {
    if (asked[node] == 0 || cancelled) return;
    bool agree = few[node] == 0 || few[node] == kFewRays;
    nodes.around(node, [&](std::size_t other, int) { agree &= asked[other] == 0 || few[other] == few[node]; });
    int free16 = few[node];
    if (agree) {
      traced += kFewRays;
      free16 *= kRays / kFewRays;
    } else {
      traced += kRays;
      const glm::dvec3 from = nodes.world(node);
      for (int i = kFewRays; i < kRays; ++i) free16 += free(from, i) ? 1 : 0;
    }
    seen.shares[node] = static_cast<float>(free16) / kRays;
  });
  rays += traced;
  float least = 1.0f, most = 0.0f;
  for (std::size_t node = 0; node < count; ++node) {
    if (asked[node] == 0) continue;
    least = std::min(least, seen.shares[node]);
    most = std::max(most, seen.shares[node]);
  }
  seen.channel = most <= 0.0f ? kSeenByNone : least >= 1.0f ? kSeenByAll : 0;
  if (seen.channel == 0) fillUnknown(nodes, asked, seen.shares);
  return seen;
}

// A disc across the way to a source of light, as large as the air around the source allows.
double freeRadius(const SightLines& lines, const glm::dvec3& position, double wanted) {
  double radius = wanted;
  for (int i = 0; i < 27; ++i) {
    const glm::dvec3 d(i % 3 - 1, i / 3 % 3 - 1, i / 9 - 1);
    if (i == 13) continue;
    const glm::dvec3 along = glm::normalize(d);
    if (lines.blocked(position, position + radius * along, false)) {
      const auto hit = lines.first(position, along);
      if (hit) radius = std::min(radius, 0.8 * hit->distance);
    }
  }
  return std::max(radius, 0.0);
}

glm::dvec3 discPoint(const glm::dvec3& from, const glm::dvec3& middle, double radius, int i) {
  const glm::dvec3 way = middle - from;
  const double length = glm::length(way);
  if (length < 1.0e-12) return middle;
  const glm::dvec3 w = way / length;
  const glm::dvec3 t = glm::normalize(glm::cross(std::abs(w.y) < 0.8 ? glm::dvec3(0, 1, 0) : glm::dvec3(1, 0, 0), w));
  const glm::dvec2 u = squarePoint(static_cast<unsigned>(i));
  const double r = radius * std::sqrt(u.x), phi = 2.0 * kSightPi * u.y;
  return middle + r * std::cos(phi) * t + r * std::sin(phi) * glm::cross(w, t);
}

SightTask::Lamp taskLamp(const SceneLamps& lamps, std::size_t index) {
  const SceneLamp& lamp = lamps.lamps[index];
  return {index, lamp.corners, lamp.normal, lamp.bothSides};
}

}  // namespace

glm::vec4 SightLattice::fetchSight(const glm::vec3& place, int part) const {
  if (empty() || part < 0 || part >= parts()) return glm::vec4(1.0f);
  glm::ivec3 first(0);
  glm::vec3 t(0.0f);
  for (int axis = 0; axis < 3; ++axis) {
    const float p = glm::clamp(place[axis], 0.0f, static_cast<float>(nodes[axis] - 1));
    first[axis] = std::clamp(static_cast<int>(p), 0, std::max(nodes[axis] - 2, 0));
    t[axis] = p - static_cast<float>(first[axis]);
  }
  glm::vec4 sum(0.0f);
  for (int corner = 0; corner < 8; ++corner) {
    float weight = 1.0f;
    glm::ivec3 node = first;
    for (int axis = 0; axis < 3; ++axis) {
      const int up = corner >> axis & 1;
      weight *= up != 0 ? t[axis] : 1.0f - t[axis];
      node[axis] = std::min(node[axis] + up, nodes[axis] - 1);
    }
    const auto texel = static_cast<std::size_t>(((part * nodes.z + node.z) * nodes.y + node.y) * nodes.x + node.x);
    for (int c = 0; c < 4; ++c) {
      sum[c] += weight * static_cast<float>(texels[4 * texel + static_cast<std::size_t>(c)]) / 255.0f;
    }
  }
  return sum;
}

shading::LatticeShape SightLattice::shape(const glm::dvec3& origin) const {
  shading::LatticeShape shape{};
  shape.low = glm::vec3(low - origin);
  shape.last = glm::vec3(nodes - 1);
  shape.cut = 0.0f;
  shape.perUnit = shape.last / glm::max(glm::vec3(high - low), glm::vec3(1.0e-30f));
  return shape;
}

int ProbeSight::channelOfLamp(std::size_t lamp) const {
  const auto found = std::lower_bound(lamps.begin(), lamps.end(), lamp);
  if (found == lamps.end() || *found != lamp) return kSeenByNone;
  return lampChannel[static_cast<std::size_t>(found - lamps.begin())];
}

shading::LatticeShape sightShape(const ProbeSight& sight, const ProbeGeometry& probe) {
  return sight.lattice.shape(glm::transpose(probe.worldFromProbe) * (probe.originWorld - sight.middleWorld));
}

glm::ivec3 sightNodes(const glm::dvec3& size, const SightSettings& settings) {
  glm::dvec3 sides(0.0);
  for (int axis = 0; axis < 3; ++axis) sides[axis] = std::isfinite(size[axis]) ? std::max(size[axis], 0.0) : 0.0;
  const double longest = std::max({sides.x, sides.y, sides.z});
  double spacing = std::min(settings.spacing, longest / 16.0);
  if (!(spacing > 0.0)) return glm::ivec3(2);
  spacing = std::max(spacing, longest / (SightLattice::kMostNodes - 1));
  glm::ivec3 nodes(2);
  for (;; spacing *= 1.05) {
    for (int axis = 0; axis < 3; ++axis) {
      nodes[axis] = std::clamp(static_cast<int>(std::lround(sides[axis] / spacing)) + 1, 2, SightLattice::kMostNodes);
    }
    if (nodes.x * nodes.y * nodes.z <= std::max(settings.mostNodes, 8)) return nodes;
  }
}

SightTask sightTask(const Scene& scene, const SceneLamps& lamps, const Probe& probe) {
  SightTask task;
  task.box = probe.box;
  task.rotationDegrees = probe.rotationDegrees;
  const Box& influence = probe.influenceBox();
  task.reach = influenceReach(probe.box.min, probe.box.max, influence.min, influence.max);
  const glm::dmat3 boxFromWorld = glm::transpose(rotationMatrix(probe.rotationDegrees));
  const glm::dvec3 center = probe.box.center(), half = 0.5 * probe.box.size();
  std::set<std::size_t> ownGroups;
  double strongest = 0.0;
  const auto strength = [&](double power, double size2, const glm::dvec3& at) {
    const double d = nearestInBox(probe, boxFromWorld, at);
    return power / std::max({d * d, size2, 1.0e-12});
  };
  for (const std::size_t index : probeLamps(lamps.lamps, probe)) {
    const SceneLamp& lamp = lamps.lamps[index];
    task.lamps.push_back(taskLamp(lamps, index));
    ownGroups.insert(lamp.group);
    strongest = std::max(strongest, strength(lamp.power, lamp.area, lamp.middle));
  }
  task.own = task.lamps.size();

  // Those of other rooms, by what they could give at the nearest place of the box.
  struct Group {
    double strength = 0.0;
    std::vector<std::size_t> members;
    bool faces = false, hidden = false;
  };
  std::map<std::size_t, Group> groups;
  for (std::size_t i = 0; i < lamps.lamps.size(); ++i) {
    const SceneLamp& lamp = lamps.lamps[i];
    if (ownGroups.count(lamp.group) != 0) continue;
    Group& group = groups[lamp.group];
    group.strength += strength(lamp.power, lamp.area, lamp.middle);
    group.members.push_back(i);
    const glm::dvec3 n = boxFromWorld * lamp.normal;
    const double height = glm::dot(n, boxFromWorld * (center - lamp.middle)), reach = glm::dot(glm::abs(n), half);
    group.faces |= lamp.bothSides || height + reach > 1.0e-3 * reach;
    group.hidden |= std::find(probe.hides.begin(), probe.hides.end(), lamp.node) != probe.hides.end();
  }
  std::vector<const Group*> order;
  for (const auto& entry : groups) {
    if (!entry.second.faces || entry.second.hidden || entry.second.members.size() > kMostProbeLamps) continue;
    order.push_back(&entry.second);
    strongest = std::max(strongest, entry.second.strength);
  }
  std::stable_sort(order.begin(), order.end(),
                   [](const Group* a, const Group* b) { return a->strength > b->strength; });
  for (const Group* group : order) {
    if (group->strength < kSightWeakest * strongest) break;
    if (task.own >= kMostProbeLamps || task.lamps.size() + group->members.size() > task.own + kMostCandidates) break;
    for (const std::size_t index : group->members) task.lamps.push_back(taskLamp(lamps, index));
  }

  std::set<std::size_t> counted;
  for (const SceneLamp& lamp : lamps.lamps) {
    if (lamp.light) counted.insert(*lamp.light);
  }
  std::vector<std::pair<double, std::size_t>> sources;
  for (std::size_t i = 0; i < scene.lights.size(); ++i) {
    const Light& light = scene.lights[i];
    const bool shines = light.intensity > 0.0f && glm::length(light.color) > 0.0f;
    if (light.type == LightType::Directional || light.shadows != LightShadows::None || !shines) continue;
    if (counted.count(i) != 0) continue;
    sources.emplace_back(-strength(light.intensity, 0.01, light.position), i);
  }
  std::sort(sources.begin(), sources.end());
  if (sources.size() > kMostSightSources) sources.resize(kMostSightSources);
  for (const auto& source : sources) {
    const Light& light = scene.lights[source.second];
    task.sources.push_back({source.second, light.position, light.radius});
  }
  std::sort(task.sources.begin(), task.sources.end(),
            [](const SightTask::Source& a, const SightTask::Source& b) { return a.index < b.index; });
  return task;
}

SightTask captureSightTask(const Scene& scene, const SceneLamps& lamps, const Probe& probe) {
  static const SceneLamps kNone;
  Probe at = probe;
  at.box = {probe.origin, probe.origin};
  at.rotationDegrees = glm::dvec3(0.0);
  at.influence.reset();
  Scene lit;  // what is counted with a lamp has no ray of its own
  lit.lights = scene.lights;
  for (const SceneLamp& lamp : lamps.lamps) {
    if (lamp.light) lit.lights[*lamp.light].intensity = 0.0f;
  }
  SightTask task = sightTask(lit, kNone, at);
  task.from = probe.origin;
  for (const std::size_t index : captureLamps(lamps.lamps, probe, kMostCandidates)) {
    task.lamps.push_back(taskLamp(lamps, index));
  }
  return task;
}

ProbeSight untracedSight(const SceneLamps& lamps, const Probe& probe) {
  ProbeSight sight;
  sight.lamps = captureLamps(lamps.lamps, probe);
  std::sort(sight.lamps.begin(), sight.lamps.end());
  sight.lampChannel.assign(sight.lamps.size(), kSeenByAll);
  return sight;
}

Box openBox(const SightLines& lines, const SightTask& task) {
  if (task.reach.none()) return task.box;
  const glm::dvec3 middle = task.box.center(), half = 0.5 * task.box.size();
  const glm::dmat3 worldFromBox = rotationMatrix(task.rotationDegrees);
  const ProbeReach reach = openReach(task.reach, lines, middle, worldFromBox, -half, half);
  if (reach.none()) return task.box;
  const glm::dvec3 at = middle + worldFromBox * (0.5 * (reach.high - reach.low));
  const glm::dvec3 wider = half + 0.5 * (reach.high + reach.low);
  return {at - wider, at + wider};
}

Box boxSeenFrom(const SightLines& lines, const glm::dvec3& from) {
  constexpr int kDirections = 1024;
  constexpr double kGolden = 2.39996322972865332;
  constexpr double kLeftOut = 0.01;  // at either end of each axis: what lies behind a door ajar
  std::array<std::vector<double>, 3> ends;
  for (int i = 0; i < kDirections; ++i) {
    const double z = 1.0 - (2.0 * i + 1.0) / kDirections, r = std::sqrt(1.0 - z * z);
    const glm::dvec3 along(r * std::cos(kGolden * i), z, r * std::sin(kGolden * i));
    const auto hit = lines.first(from, along);
    if (!hit) continue;
    for (int axis = 0; axis < 3; ++axis) {
      ends[static_cast<std::size_t>(axis)].push_back(from[axis] + hit->distance * along[axis]);
    }
  }
  Box box{from, from};
  for (int axis = 0; axis < 3; ++axis) {
    std::vector<double>& of = ends[static_cast<std::size_t>(axis)];
    if (of.empty()) continue;
    std::sort(of.begin(), of.end());
    const auto skipped = static_cast<std::size_t>(kLeftOut * static_cast<double>(of.size()));
    box.min[axis] = std::min(of[skipped], from[axis]);
    box.max[axis] = std::max(of[of.size() - 1 - skipped], from[axis]);
  }
  return box;
}

ProbeSight probeSight(const SightLines& lines, const SightTask& task, const std::atomic<bool>& cancelled,
                      const SightSettings& settings) {
  ProbeSight sight;
  sight.middleWorld = task.box.center();
  sight.worldFromBox = rotationMatrix(task.rotationDegrees);
  if (!task.sources.empty()) sight.sourceChannel.assign(task.sources.back().index + 1, kSeenByAll);
  const bool nothing = lines.empty() || (task.lamps.empty() && task.sources.empty());
  if (nothing) {
    for (std::size_t i = 0; i < task.own; ++i) sight.lamps.push_back(task.lamps[i].index);
    std::sort(sight.lamps.begin(), sight.lamps.end());
    sight.lampChannel.assign(sight.lamps.size(), kSeenByAll);
    return sight;
  }
  const Nodes nodes(task, sightNodes(task.box.size(), settings));
  const NodeStates states = nodeStates(lines, nodes, sight.rays);
  const std::vector<char>& valid = states.valid;
  std::vector<std::vector<float>> shares;
  const auto channelOf = [&](Seen seen) {
    if (seen.channel == kSeenByAll) ++sight.unshadowed;
    if (seen.channel != 0) return seen.channel;
    shares.push_back(std::move(seen.shares));
    return static_cast<int>(shares.size());  // channel 0 is the nodes' say
  };
  std::map<std::size_t, int> lampChannels;
  for (std::size_t i = 0; i < task.lamps.size() && !cancelled; ++i) {
    const SightTask::Lamp& lamp = task.lamps[i];
    if (i >= task.own && lampChannels.size() >= kMostProbeLamps) break;
    const std::vector<glm::dvec3> points = pointsOf(lamp.corners);
    const double above = 0.01 * nodes.spacing();
    Seen seen = seenShares(
        lines, nodes, valid, [&](const glm::dvec3&, int k) { return points[static_cast<std::size_t>(k)]; },
        [&](const glm::dvec3& at) { return lamp.bothSides || glm::dot(at - lamp.corners[0], lamp.normal) > above; },
        true, sight.rays, cancelled);
    if (seen.channel == kSeenByNone) continue;  // also of its own: it lights nothing here
    lampChannels[lamp.index] = channelOf(std::move(seen));
  }
  for (const auto& entry : lampChannels) {
    sight.lamps.push_back(entry.first);
    sight.lampChannel.push_back(entry.second);
  }
  for (const SightTask::Source& source : task.sources) {
    if (cancelled) break;
    // A point's shadow has no edge that a lattice could hold: it gets a soft one.
    const double radius = freeRadius(lines, source.position, std::max(source.radius, 0.2 * nodes.spacing()));
    sight.sourceChannel[source.index] = channelOf(seenShares(
        lines, nodes, valid, [&](const glm::dvec3& from, int k) { return discPoint(from, source.position, radius, k); },
        [](const glm::dvec3&) { return true; }, false, sight.rays, cancelled));
  }
  if (shares.empty()) return sight;
  SightLattice& lattice = sight.lattice;
  lattice.nodes = nodes.n;
  lattice.low = nodes.low;
  lattice.high = nodes.high;
  lattice.channels = static_cast<int>(shares.size()) + 1;
  lattice.texels.assign(4 * nodes.size() * static_cast<std::size_t>(lattice.parts()), 0);
  const auto put = [&](std::size_t channel, std::size_t node, float value) {
    lattice.texels[4 * nodes.size() * (channel / 4) + 4 * node + channel % 4] =
        static_cast<std::uint8_t>(std::lround(255.0f * std::clamp(value, 0.0f, 1.0f)));
  };
  for (std::size_t node = 0; node < nodes.size(); ++node) {
    put(0, node, states.say[node]);
    for (std::size_t k = 0; k < shares.size(); ++k) put(k + 1, node, states.say[node] * shares[k][node]);
  }
  return sight;
}

}  // namespace boxprobe
