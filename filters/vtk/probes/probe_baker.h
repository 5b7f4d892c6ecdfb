// Makes the maps that the plan asks for, one cubemap after another: captured step by step or read from a file, then
// shown, remembered with what they were made of, and kept for undo. What is made is decided by the plan, and what it
// shows by whoever knows the objects (CaptureInputs).
#pragma once

#include <vtkProp.h>
#include <vtkWeakPointer.h>

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/probe_context.h"
#include "filters/vtk/probes/probe_plan.h"

namespace boxprobe {

/// What captures see: a scene's objects, or those of somebody else's renderer.
struct CaptureInputs {
  CaptureWorld world;
  std::vector<vtkWeakPointer<vtkProp>> props;  ///< that draws each of the world's objects; several may share one
  std::string sky;                             ///< key of the sky's own map; empty: no light comes from there
  int skyColumns = 0;                          ///< of its image; 0: it is none
};

/// The maps of a job, with all that is known of them.
struct MadeMaps {
  ProbeJob job;    ///< with its key, which a realtime probe's is given by its faces
  FaceKeys faces;  ///< empty texts: faces that are not to be used again
  std::shared_ptr<const ProbeMaps> maps;
  bool fromFile = false;
};

class ProbeBaker {
 public:
  /// `with` and all that it points to must outlive this. Maps that nobody shows are kept up to so many bytes.
  ProbeBaker(const ProbeContext& with, std::size_t keptBytes) : with_(with), cache_(keptBytes) {}

  /// Captures draw with this window's context, which step() and what publishes maps need; null: release() first.
  void setWindow(vtkOpenGLRenderWindow* window);
  /// Null without a window.
  CubeCapture* capture() { return graphics_ ? &graphics_->capture : nullptr; }
  const Times& times() const { return times_; }
  MapCache& cache() { return cache_; }
  const MapCache& cache() const { return cache_; }
  /// Another world for captures; replan() follows, once keys were updated.
  void setProps(std::vector<vtkWeakPointer<vtkProp>> props) { props_ = std::move(props); }

  /// Shows what is at hand, plans the rest, and ends what is under way unless that plan still wants it.
  void replan();
  bool pending() const;
  /// Where coarse maps come first (ProbePlan::coarseFirst), probes that show nothing show what stands in for them, all
  /// at once. False: there was none.
  bool standIn();
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
  void publishCoarse(MadeMaps made);
  void publishRealtime(MadeMaps made);
  void publishFinal(MadeMaps made);
  void showCached();
  void show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps);
  void showSky(const std::string& key, std::shared_ptr<const ProbeMaps> maps);

  /// What takes a window to be made.
  struct Graphics {
    Graphics(vtkOpenGLRenderWindow* window, const std::shared_ptr<DrawState>& state, Times* times)
        : capture(window, state), runner(window, state, &capture, times) {}
    CubeCapture capture;
    BakeRunner runner;
  };

  const ProbeContext& with_;
  MapCache cache_;
  Times times_;
  std::unique_ptr<Graphics> graphics_;
  std::vector<vtkWeakPointer<vtkProp>> props_;  ///< in the order of the world's objects
  int unitsDone_ = 0;
  bool firstBouncePrograms_ = false;  ///< until all is done
  /// Maps of earlier bounces are held until all is done, because later ones are made from them.
  std::vector<std::shared_ptr<const ProbeMaps>> earlier_;
};

}  // namespace boxprobe
