// The parts of a probe set, for those of them that use others. Owned by the probe set.
#pragma once

#include <memory>

namespace boxprobe {

class DrawState;
class ProbeBaker;
class ProbeBinder;
class ProbePlan;
struct SceneContent;

struct ProbeContext {
  SceneContent* content;
  std::shared_ptr<DrawState> state;
  ProbePlan* plan;
  ProbeBinder* binder;
  ProbeBaker* baker;
};

}  // namespace boxprobe
