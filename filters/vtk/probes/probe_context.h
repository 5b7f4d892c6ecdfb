// The parts of a probe set, for those of them that work on others. Filled by the probe set, which owns them all.
#pragma once

#include <memory>

namespace boxprobe {

class CubeCapture;
class DrawState;
class LevelNeeds;
class MapCache;
class ProbeEntries;
class ProbeKeys;
class ProbeLight;
class ProbePlan;
class ProbePrograms;
class ShownProbes;
struct ProbeSources;
struct SceneContent;

struct ProbeContext {
  SceneContent* content;
  std::shared_ptr<DrawState> state;
  CubeCapture* capture;
  MapCache* cache;
  ProbeSources* sources;
  ProbeEntries* entries;
  ProbeKeys* keys;
  ProbePlan* plan;
  ShownProbes* shown;
  LevelNeeds* needs;
  ProbeLight* light;
  ProbePrograms* programs;
};

}  // namespace boxprobe
