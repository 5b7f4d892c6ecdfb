// Soft shadows of a probe's lamps: at each node of a lattice in its box, the share of every lamp that is seen from
// there. A factor of the lamp's light, fetched a third of a node off the surface (shaders/shared/sight.glsl).
// Deterministic; plain values. Called in the background where scenes are drawn.
#pragma once

#include <atomic>
#include <cstdint>
#include <glm/ext/vector_int3.hpp>
#include <glm/mat3x3.hpp>
#include <optional>
#include <vector>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/probe_reach.h"
#include "filters/core/geometry/scene_lamps.h"
#include "filters/core/geometry/sight_lines.h"
#include "filters/math/shared/sight_math.h"

namespace boxprobe {

struct SightSettings {
  double spacing = 0.25;            ///< of the nodes, about, scene units, > 0; at most a sixteenth of the longest side
  int mostNodes = 32768;            ///< of one probe; a larger box has them farther apart
  static constexpr int kRays = 16;  ///< to each lamp from a node; a quarter of them where all nodes around agree
};

/// What nodes see of lamps, a byte each. Channel 0 is a node's say, small within things and where a sheet stands close
/// before the next node; the others are shares of lamps times that (shading::sightShare).
struct SightLattice : shading::SightSampler {
  static constexpr int kMostNodes = 64;  ///< along an axis

  glm::ivec3 nodes{0};  ///< along each axis of the box
  glm::dvec3 low{0.0};  ///< first and last node: relative to the box's middle, along its axes, scene units
  glm::dvec3 high{0.0};
  int channels = 0;
  /// Four channels a node, then the next four: all nodes' first texels, x fastest, then y, then z; then all second
  /// ones.
  std::vector<std::uint8_t> texels;

  bool empty() const { return texels.empty(); }
  int parts() const { return (channels + 3) / 4; }
  glm::vec4 fetchSight(const glm::vec3& place, int part) const override;
  /// In a frame along the box's axes about a point `origin`, given like `low`.
  shading::LatticeShape shape(const glm::dvec3& origin) const;
};

/// How a probe's nodes see a lamp or a light source: a channel of its lattice, 1 and up, or one of these.
constexpr int kSeenByAll = -1, kSeenByNone = -2;

/// What is traced for a probe. Equal tasks in an equal scene have equal results.
struct SightTask {
  struct Lamp {
    std::size_t index = 0;  ///< into SceneLamps::lamps
    std::vector<glm::dvec3> corners;
    glm::dvec3 normal{0.0};
    bool bothSides = false;
    bool operator==(const Lamp& o) const {
      return index == o.index && corners == o.corners && normal == o.normal && bothSides == o.bothSides;
    }
  };
  struct Source {
    std::size_t index = 0;  ///< into Scene::lights
    glm::dvec3 position{0.0};
    double radius = 0.0;
    bool operator==(const Source& o) const { return index == o.index && position == o.position && radius == o.radius; }
  };
  Box box;
  glm::dvec3 rotationDegrees{0.0};
  ProbeReach reach;  ///< of the nodes, where there are surfaces (probe_reach.h)
  /// Of a capture: the box is not given, but what is seen from here (boxSeenFrom).
  std::optional<glm::dvec3> from;
  std::vector<Lamp> lamps;
  std::size_t own = 0;  ///< the first of them are the probe's; the others, of other rooms, are so if they are seen
  std::vector<Source> sources;
  bool operator==(const SightTask& o) const {
    return box == o.box && rotationDegrees == o.rotationDegrees && reach == o.reach && from == o.from &&
           lamps == o.lamps && own == o.own && sources == o.sources;
  }
};

struct ProbeSight {
  glm::dvec3 middleWorld{0.0};  ///< of the box, about which the lattice lies
  glm::dmat3 worldFromBox{1.0};
  std::vector<std::size_t> lamps;  ///< drawn as shapes, ascending; the probe's own and those of other rooms it sees
  std::vector<int> lampChannel;    ///< of each of `lamps`
  std::vector<int> sourceChannel;  ///< of each of Scene::lights up to the last that was traced
  SightLattice lattice;            ///< empty if nothing is seen in part
  std::size_t rays = 0;            ///< that were traced
  std::size_t unshadowed = 0;      ///< lamps and sources that every node sees whole, which need no channel

  /// Of a lamp that is not among `lamps`: kSeenByNone.
  int channelOfLamp(std::size_t lamp) const;
  int channelOfSource(std::size_t light) const {
    return light < sourceChannel.size() ? sourceChannel[light] : kSeenByAll;
  }
};

/// The sight's lattice in the frame of a probe as it is drawn now.
shading::LatticeShape sightShape(const ProbeSight& sight, const ProbeGeometry& probe);

/// The task's box with what of its reach has surfaces. About the same middle where it reaches nothing.
Box openBox(const SightLines& lines, const SightTask& task);

/// Sources traced for a probe at most: the brightest where it is.
constexpr std::size_t kMostSightSources = 8;

/// `lamps`: of the scene. A probe's own lamps (probeLamps) and the brightest of other rooms that shine towards it; of
/// the scene's point and spot lights those that ask for no other shadows and are not counted with a lamp.
SightTask sightTask(const Scene& scene, const SceneLamps& lamps, const Probe& probe);

/// The same for what the probe's capture shows, whatever its box is: captureLamps, and sources by their distance from
/// the capture origin.
SightTask captureSightTask(const Scene& scene, const SceneLamps& lamps, const Probe& probe);
/// What a capture goes by where nothing is traced: those lamps, seen from everywhere.
ProbeSight untracedSight(const SceneLamps& lamps, const Probe& probe);

/// A box along the world's axes around nearly all that is seen from a point: of the few farthest rays not the ends.
Box boxSeenFrom(const SightLines& lines, const glm::dvec3& from);

/// Nodes along each axis of a box of that size, 2 to SightLattice::kMostNodes, settings.mostNodes in all at most.
glm::ivec3 sightNodes(const glm::dvec3& size, const SightSettings& settings = {});

/// Nodes within things, which see the backs of surfaces, take what their neighbours see. `cancelled` ends it early,
/// with a result that is of no use. On all processors.
ProbeSight probeSight(const SightLines& lines, const SightTask& task, const std::atomic<bool>& cancelled,
                      const SightSettings& settings = {});

}  // namespace boxprobe
