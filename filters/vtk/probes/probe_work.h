// The probe set's work, one cube map after another: a planned job is begun, made step by step or read from its file,
// and handed to the publisher; then the plan is made again. Called by the probe set; decides neither what is made nor
// what is shown.
#pragma once

#include <memory>

#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/probes/bake_items.h"
#include "filters/vtk/probes/probe_plan.h"
#include "filters/vtk/probes/probe_publisher.h"

namespace boxprobe {

class ProbeWork {
 public:
  /// All pointers must outlive this.
  ProbeWork(BakeRunner* runner, std::shared_ptr<DrawState> state, const ProbeEntries* entries, ProbeKeys* keys,
            ProbePlan* plan, ProbeSources* sources, ProbePrograms* programs, const ProbeItems* items,
            ProbePublisher* publisher)
      : runner_(runner),
        state_(std::move(state)),
        entries_(entries),
        keys_(keys),
        plan_(plan),
        sources_(sources),
        programs_(programs),
        items_(items),
        publisher_(publisher) {}

  /// Shows what is at hand, plans the rest, and ends what is under way unless that plan still wants it.
  void replan();
  bool pending() const { return runner_->pending() || !plan_->jobs().empty(); }
  /// At most a face is captured, a level filtered or a file read; returns whether there was anything to do. Throws
  /// WorkError where the driver refuses; giveUp() is then due.
  bool step();
  /// Faces, levels and files: made since there last was nothing to do, and left of what is planned now.
  int unitsDone() const { return unitsDone_; }
  int unitsLeft() const;
  /// Ends the job under way; the next step begins the first of the plan.
  void abort();
  /// The same, and nothing is left to do until the next plan.
  void giveUp();
  void release();

 private:
  void begin(const ProbeJob& job);
  bool manyDark() const;
  void loadFile(const ProbeJob& job);
  void loadLevels(const ProbeJob& job);
  void finish(MadeMaps made);

  BakeRunner* runner_;
  std::shared_ptr<DrawState> state_;
  const ProbeEntries* entries_;
  ProbeKeys* keys_;
  ProbePlan* plan_;
  ProbeSources* sources_;
  ProbePrograms* programs_;
  const ProbeItems* items_;
  ProbePublisher* publisher_;
  int unitsDone_ = 0;
  bool dark_ = false;  ///< first bounces have programs of their own, until all is done
};

}  // namespace boxprobe
