// Makes the maps that the plan requests, one cubemap after another: captured step by step or read from a file, then
// shown, with a record of their inputs, and kept for undo. CaptureInputs describes the objects to capture.
#pragma once

#include <vtkProp.h>
#include <vtkWeakPointer.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "filters/vtk/capture/bake_runner.h"
#include "filters/vtk/maps/map_cache.h"
#include "filters/vtk/probes/probe_context.h"
#include "filters/vtk/probes/probe_plan.h"

namespace boxprobe {

/// What captures see: the objects of a scene, or of another program's renderer.
struct CaptureInputs {
  CaptureWorld world;
  std::vector<vtkWeakPointer<vtkProp>> props;  ///< draw the world's objects; several objects may share one
  std::string sky;                             ///< key of the sky's map; empty: it gives no light
  int skyColumns = 0;                          ///< of its image; 0: no image
};

/// The maps of a job with their properties.
struct MadeMaps {
  ProbeJob job;    ///< with its key, which for a realtime probe follows from its faces
  FaceKeys faces;  ///< empty keys mark faces that must not be reused
  std::shared_ptr<const ProbeMaps> maps;
  bool fromFile = false;
};

class ProbeBaker {
 public:
  /// `with` and everything it points to must outlive this object. Unused maps are kept up to this many bytes.
  ProbeBaker(const ProbeContext& with, std::size_t keptBytes) : with_(with), cache_(keptBytes) {}

  /// Captures draw with this window's context, which step() and publishing maps need; null: call release() first.
  void setWindow(vtkOpenGLRenderWindow* window);
  /// Null without a window.
  CubeCapture* capture() { return graphics_ ? &graphics_->capture : nullptr; }
  const Times& times() const { return times_; }
  MapCache& cache() { return cache_; }
  const MapCache& cache() const { return cache_; }
  /// Another world for captures; replan() must follow, after keys were updated.
  void setProps(std::vector<vtkWeakPointer<vtkProp>> props) { props_ = std::move(props); }

  /// Shows available maps, plans the others, and ends work in progress unless the new plan still needs it.
  void replan();
  bool pending() const;
  /// Where coarse maps come first (ProbePlan::coarseFirst), gives all probes that show nothing a stand-in, at once.
  /// False: there was none.
  bool standIn();
  /// Captures at most one face, filters one level or reads one file; returns whether there was anything to do. Throws
  /// WorkError if the driver refuses; cancelWork() must follow.
  bool step();
  /// Faces, levels and files: done since the last time there was nothing to do; below, those left in the plan.
  int unitsDone() const { return unitsDone_; }
  int unitsLeft() const;
  /// Ends the current job; the next step starts the first job of the plan.
  void abort();
  /// The same, and clears the plan.
  void cancelWork();
  void release();

 private:
  // Converts jobs into items for the runner. The probe of a bounce, a drag or a realtime job must exist.
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

  // Handles finished maps.
  void finish(MadeMaps made);
  void publishDrag(MadeMaps made);
  void publishCoarse(MadeMaps made);
  void publishSharp(MadeMaps made);
  void publishRealtime(MadeMaps made);
  void publishFinal(MadeMaps made);
  void dropEarlier(int bounce);
  bool endBounces();
  void showCached();
  void show(std::size_t index, const std::string& key, std::shared_ptr<const ProbeMaps> maps);
  void showSky(const std::string& key, std::shared_ptr<const ProbeMaps> maps);

  /// Objects that need a window.
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
  /// Of earlier bounces by key: those that the next one is made from, held until all is done.
  std::vector<std::pair<std::string, std::shared_ptr<const ProbeMaps>>> earlier_;
  std::map<std::string, ShCoefficients> firsts_;  ///< irradiance of first bounces by key, as long
};

}  // namespace boxprobe
