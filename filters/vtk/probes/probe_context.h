// The parts of a probe set, for those of them that work on others. Owned and filled by the probe set.
#pragma once

#include <memory>

namespace boxprobe {

class DrawState;
class ProbeBaker;
class ProbeBinder;
class ProbePlan;
struct ProbeBinding;
struct SceneContent;

/// Sees to programs beside drawing with them (probe_programs.h). Without one each is compiled when it is first drawn.
class ProgramWork {
 public:
  virtual ~ProgramWork() = default;
  /// May an object that is drawn by `now` be drawn by `next` without waiting for a program?
  virtual bool known(const ProbeBinding& now, const ProbeBinding& next) const = 0;
  /// Objects may have other bindings.
  virtual void assigned() = 0;
  /// Captures may have begun or ended.
  virtual void replanned() = 0;
};

struct ProbeContext {
  SceneContent* content;
  std::shared_ptr<DrawState> state;
  ProbePlan* plan;
  ProbeBinder* binder;
  ProbeBaker* baker;
  ProgramWork* programs;  ///< null: none
};

}  // namespace boxprobe
