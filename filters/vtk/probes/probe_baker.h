// Makes the maps that the plan asks for, one cubemap after another: captured step by step or read from a file, then
// shown, remembered with what they were made of, and kept for undo. Owned by the probe set; what is made is decided by
// the plan.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/probe_context.h"
#include "filters/vtk/probes/probe_job.h"

namespace boxprobe {

/// The maps of a job, with all that is known of them.
struct MadeMaps {
  ProbeJob job;    ///< with its key, which a realtime probe's is given by its faces
  FaceKeys faces;  ///< empty texts: faces that are not to be used again
  std::shared_ptr<const ProbeMaps> maps;
  bool fromFile = false;
};

class ProbeBaker {
 public:
  /// `with` and all that it points to must outlive this.
  ProbeBaker(const ProbeContext& with, vtkOpenGLRenderWindow* window, Times* times)
      : with_(with), runner_(window, with.state, with.capture, times) {}

  /// Shows what is at hand, plans the rest, and ends what is under way unless that plan still wants it.
  void replan();
  bool pending() const;
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
  // From a job to what the runner makes. The probe of a bounce, a drag or a realtime job must exist.
  void begin(const ProbeJob& job);
  BakeItem itemOf(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces);
  BakeItem sky() const;
  BakeItem picture(const ProbeJob& job) const;
  BakeItem bounce(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces);
  BakeItem realtime(const ProbeJob& job, const std::shared_ptr<FaceKeys>& faces);
  FaceSource faceSource(const Probe& probe, int face) const;
  void seeBounce(const ProbeJob& job) const;
  bool manyFirstBounces() const;
  void load(const ProbeJob& job);

  // What becomes of finished maps.
  void finish(MadeMaps made);
  void publishDrag(MadeMaps made);
  void publishRealtime(MadeMaps made);
  void publishFinal(MadeMaps made);
  void showCached();
  void show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps);
  void showSky(const std::string& key, std::shared_ptr<const ProbeMaps> maps);

  const ProbeContext& with_;
  BakeRunner runner_;
  int unitsDone_ = 0;
  bool firstBouncePrograms_ = false;  ///< until all is done
  /// Maps of earlier bounces are held until all is done, because later ones are made from them.
  std::vector<std::shared_ptr<const ProbeMaps>> earlier_;
};

}  // namespace boxprobe
