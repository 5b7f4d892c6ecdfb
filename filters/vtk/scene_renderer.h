// Draws a scene in VTK with box-projected reflections, in any vtkOpenGLRenderWindow, on screen or off-screen. Owns the
// VTK actors, the probes' textures and the capture work.
//
// Usage:
//   sync(scene, changes)   after every document change; cheap: notes what is stale, updates uniforms and actors
//   workPending() / step() outside of a render, with the window's context current: one unit of capture or filtering
//                          (a face, a level), so that a window stays responsive
//   Render()               the window's own; draws with whatever the probes hold by then
#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <glm/vec2.hpp>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "filters/core/base/counters.h"
#include "filters/core/base/export.h"
#include "filters/core/geometry/sight_lines.h"
#include "filters/core/picture/baked_probe.h"
#include "filters/core/scene/document.h"
#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/core/scene/surface_view.h"
#include "filters/explain/explanation.h"
#include "filters/vtk/capture/work_times.h"
#include "filters/vtk/draw/frame_parts.h"
#include "filters/vtk/draw/tuning_parts.h"
#include "filters/vtk/draw/window_view.h"
#include "filters/vtk/frame/frame_count.h"
#include "filters/vtk/frame/frame_report.h"
#include "filters/vtk/frame/refinement.h"
#include "filters/vtk/inspect/preview_settings.h"
#include "filters/vtk/probes/bake_state.h"

class vtkOpenGLRenderWindow;
class vtkRenderer;

namespace boxprobe {

struct ProbeMaps;
struct ProbesDiffuse;

class BOXPROBE_EXPORT SceneRenderer {
 public:
  /// Adds its renderer to `window` (layer 0). The window must outlive this object's OpenGL resources; see
  /// releaseGraphics.
  explicit SceneRenderer(vtkOpenGLRenderWindow* window);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// Sets the geometry; `models` in the order of scene.models. Replaces all actors.
  void setModels(std::vector<std::shared_ptr<const Model>> models);

  /// Sets what traces the shadows of lamps drawn as shapes (Scene::lamps), and of point and spot lights:
  /// traceSightLines (filters/fit/rays/triangle_sight.h), for programs that link a ray tracer. Call it before sync();
  /// without it these lights pass through everything.
  void setSightLines(SightLinesMaker lines);

  /// Updates actors, lights, uniforms and the list of stale captures for `scene`. Draws nothing.
  void sync(const Scene& scene, const Changes& changes);

  /// While an origin is dragged, faces are captured step by step at its current position and shown when complete; the
  /// final capture is made after the drag (`interactive` false).
  void setInteractive(bool interactive);

  /// For a window in which probes can be dragged: compiles the programs for a drag ahead, as part of the work.
  void setEditable(bool editable);

  /// For a window that is looked at while probes are captured: where a probe has nothing to show yet, the sky stands in
  /// for its surroundings, then a capture of a few texels, until its own maps are there. These are the same either way.
  /// Not with realtime probes, whose captures see whatever is shown. Before sync().
  void showCoarseFirst(bool coarse);

  /// For a window that shows cheap techniques while something moves (see EvaluationRow::standIn): compiles their
  /// programs ahead, as part of the work.
  void allowStandIns(bool allowed);
  /// To be called when the camera or a handle starts or stops moving: surfaces are drawn with cheap techniques whose
  /// programs are ready. Never affects the debug view's colours, explanations and linear pictures. Returns whether any
  /// surface is affected.
  bool setMoving(bool moving);

  /// Nothing is being edited, and many frames are to be drawn: programs that have the numbers of probes and materials
  /// as constants are compiled as part of the work, and drawn with from then on until sync() or setInteractive() is
  /// called next. To be called when no work is pending; what does not compile is drawn as before. The pictures are the
  /// same to 1/255.
  void specializePrograms();

  bool workPending() const;
  /// One unit of work; the OpenGL context must be current (call window->MakeCurrent() first). Returns workPending().
  bool step();
  /// Progress of the work known now, 0 to 1; 1 if none is pending.
  double workProgress() const;
  WorkNow workNow() const;
  /// Calls step() until done; `progress(fraction)` may return false to stop early. Returns false if stopped.
  bool finishWork(const std::function<bool(double)>& progress = {});

  /// false: no reflections of probes or sky; every object is drawn with VTK's plain program.
  void setProbesEnabled(bool enabled);

  /// For comparisons with VTK's own pictures: lamps and coats as in VTK 9.1, and VTK's split-sum `table` (N.V across,
  /// roughness up, texel centres; x scales F0, y scales F90). Permanent.
  void useVtkLighting(int columns, int rows, const std::vector<glm::vec2>& table);

  /// true: general programs that compute everything, whatever the materials. The pictures are the same to 1/255; for
  /// tests and measurements that compare them.
  void useGeneralPrograms(bool generally);
  /// Enables only these parts of the tuning for drivers, to measure their gain; 0 is useGeneralPrograms(true).
  void tune(TuningParts parts);

  /// Measures costs: draws frames without `parts` of these objects (indices, see drawnPrograms(); empty: all) and
  /// without the sky. The pictures are wrong until it is called with nothing omitted.
  void disableParts(FrameParts parts, const std::vector<std::size_t>& objects = {}, bool sky = false);
  /// true: also draws objects known to be hidden; false (default): culls them in a view at rest.
  void drawHidden(bool hidden);
  /// true: the next frames keep the previous depth, so that only visible fragments are shaded.
  void keepDepth(bool keep);
  /// The programs of the last frame's objects, in the order of their first object.
  std::vector<DrawnProgram> drawnPrograms() const;

  /// Sets the active camera; its clipping range follows the scene's bounds at each render.
  void applyCamera(const Camera& camera);
  Camera currentCamera() const;  ///< the current state, after interaction

  vtkRenderer* renderer() const;
  /// Bounds of all visible objects: min, max. A unit box if there are none.
  Box bounds() const;

  /// Renders one frame with VTK's own path into the window's frame buffer and reads it back: display colours. If
  /// techniques average frames, the average of this and the previous frames.
  ImageRgba8 renderDisplay();
  /// In linear scene units (exposure not applied), RGBA float, alpha = coverage; `samplesPerPixel` 1, 4 or 16. One
  /// frame, or the average of `frames` of an animated technique; `beforeFrame` is called before each and may throw.
  ImageRgbaF renderLinear(int width, int height, int samplesPerPixel, int frames = 1,
                          const std::function<void(int)>& beforeFrame = {});

  /// Does a visible object's technique draw another pattern in every frame? Its picture is then the average of the
  /// frames since the last visible change.
  bool averagesFrames() const;
  /// The progress of the window's picture; draws nothing.
  FrameCount frameCount() const;
  /// The next frame starts the picture again although nothing has changed: for timing.
  void restartPicture();
  /// Sets the number of averaged frames; nothing: derived from the techniques' rays (see framesWanted).
  void setFrameLimit(std::optional<int> frames);

  /// Refines a view at rest, whatever its techniques: from the next frame on each frame adds rays of the whole lobe,
  /// until `rays` is reached or further changes would be invisible. Any change starts the picture again; captures come
  /// first. frameCount() gives the progress. `rays` 0: off.
  void refine(const RefineSettings& settings);
  const RefineSettings& refineSettings() const;
  /// The progress of the last picture, including renderRefined()'s.
  RefineState refineState() const;
  /// As renderLinear(), refined. Missing mip levels are made by finishWork() after refine().
  ImageRgbaF renderRefined(int width, int height, int samplesPerPixel, const RefineSettings& settings,
                           const std::function<void(int)>& beforeFrame = {});

  /// Has the probes that mirrors show captured with more texels, until one is a pixel of a picture of so many
  /// `rows` by the current camera: at most four times the scene's faceSize a side, 1024 texels, and a quarter of
  /// the memory for textures. Planned after all other work; to be called when that is done. 0: maps of the scene's size
  /// are shown again.
  void sharpenMirrors(int rows);

  /// Sets what the surfaces are coloured by: a row of surfaceViews(). Row 0, the picture, costs nothing; others compile
  /// further programs when first drawn.
  void setView(const SurfaceViewSettings& settings);
  const SurfaceViewSettings& view() const;
  /// What the view `diffuse-error` compares with: diffuse light by a path tracer for the current camera, as
  /// diffuseTruthImage() makes it, of the picture's shape in any number of pixels. Empty: not traced.
  void setDiffuseTruth(ImageRgbaF light);
  /// The range of the current view; the scene's own unless a range is set.
  std::pair<double, double> viewRange() const;

  /// The calculation of one pixel of a picture of `width` x `height` with the current camera; x, y from the top left.
  /// Draws only that pixel.
  Explanation explain(int x, int y, int width, int height);
  /// Several pixels of one picture: draws the surfaces once.
  std::vector<Explanation> explain(const std::vector<glm::ivec2>& pixels, int width, int height);

  /// Uses baked files of this folder in place of captures if their inputs match the scene's; empty: none. The folder is
  /// read once, in this call.
  void useBakedFiles(const std::string& folder);
  /// Restricts the work to these baked probes, whether or not objects use them; those with a valid file are not even
  /// loaded. Empty (default): everything that the picture needs. `cutShort`: those of them whose later bounces another
  /// run makes, from the files of this one's.
  void setBakeTargets(const std::vector<std::string>& probes, const std::vector<std::string>& cutShort = {});
  /// Makes these probes again although nothing has changed; reads a custom probe's picture again.
  void requestBake(const std::vector<std::string>& probes);
  BakeState bakeState(const std::string& probeName) const;
  /// The keys of a baked probe's maps (see BakeFolder), by bounce; the last are the final ones. Empty for other probes,
  /// and while the probe is not needed.
  std::vector<std::string> bakeKeys(const std::string& probeName) const;
  /// Writes the maps of a baked probe (an empty name: the sky) as an EXR file into `folder`; returns its path, empty if
  /// they are not final. `program` is recorded as the writer; `earlierBounce` as in BakeFolder::save. Throws WorkError.
  std::string saveBaked(const std::string& probeName, const std::string& folder, const std::string& program,
                        int earlierBounce = 0) const;
  /// Files contain every mip level: filters one missing level of this probe. False if none is missing, so that
  /// saveBaked and mapsOnCpu have nothing to filter.
  bool filterMissingLevel(const std::string& probeName);
  /// OpenGL's name of the renderer.
  std::string rendererName() const;
  /// Empty if every custom probe's picture was read; else one line. Such a probe keeps its previous maps.
  const std::string& pictureError() const;

  /// Light that had to be corrected: NaN and infinite texels of pictures and captures, samples beyond half-float range.
  /// One sentence each, for warnings.
  std::vector<std::string> remarks() const;

  /// A probe's current maps, read back; nothing if it has none. An empty name means the sky.
  std::optional<BakedMaps> readMaps(const std::string& probeName) const;
  /// The same, read back once per capture; null if it has none.
  std::shared_ptr<const BakedMaps> mapsOnCpu(const std::string& probeName);
  /// The copy that explain() samples: mip levels that nothing samples stay unfiltered and hold plain means.
  std::shared_ptr<const BakedMaps> explainedMaps(const std::string& probeName);

  /// A probe's current maps on the GPU; a new object after each capture. Null if it has none.
  std::shared_ptr<const ProbeMaps> shownMaps(const std::string& probeName) const;
  /// The probes' diffuse light in the last frame (filters/core/geometry/probe_diffuse.h): lamps and lattices, or
  /// coefficients, including the sky through openings.
  ProbesDiffuse probesDiffuse() const;
  /// A sphere at a probe's origin, lit by its maps alone; not in captures, explanations and renderLinear().
  void showPreviewSphere(const PreviewSphereSettings& settings);
  const PreviewSphereSettings& previewSphere() const;

  /// What the window's own frames leave out and mark; nothing at first. Kept when models change. Pictures of
  /// renderDisplay() have it, too: whoever keeps them sets nothing before.
  void setWindowView(const WindowView& view);
  const WindowView& windowView() const;
  /// World bounds of an object by its node; nothing if no visible object has that name.
  std::optional<Box> objectBounds(const std::string& node) const;

  /// What the last frame drew and omitted. Lookups are counted only by measureLookups, which draws.
  FrameReport frameReport() const;
  /// Lookups per pixel of a picture of that size with the current camera.
  FrameReport::Lookups measureLookups(int width, int height);

  const Counters& counters() const;
  const Times& times() const;
  std::size_t probeMemoryBytes() const;

  /// Empty, or one line about a failure: a missing shader anchor, an incomplete framebuffer. Frames continue without
  /// reflections; programs should report it and fail.
  std::string error() const;

  void releaseGraphics();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxprobe
