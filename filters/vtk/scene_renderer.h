// A scene drawn by VTK with box-projected reflections: owns the VTK actors, the probes' textures and the capture work,
// in any vtkOpenGLRenderWindow (the Qt window's, or an off-screen one). Called by app/session, app/gui; knows neither.
//
// How it is driven:
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
  /// Adds its renderer to `window` (layer 0). The window must outlive this object's GL resources; see releaseGraphics.
  explicit SceneRenderer(vtkOpenGLRenderWindow* window);
  ~SceneRenderer();
  SceneRenderer(const SceneRenderer&) = delete;
  SceneRenderer& operator=(const SceneRenderer&) = delete;

  /// The geometry; `models` in the order of scene.models. Replaces all actors.
  void setModels(std::vector<std::shared_ptr<const Model>> models);

  /// What traces the shadows of lamps drawn as shapes (Scene::lamps), and of point and spot lights beside them: for
  /// programs that link a ray tracer, traceSightLines (filters/fit/rays/triangle_sight.h). Before sync(); without it
  /// they shine through everything.
  void setSightLines(SightLinesMaker lines);

  /// Brings actors, lights, uniforms and the list of stale captures up to `scene`. Draws nothing.
  void sync(const Scene& scene, const Changes& changes);

  /// While an origin is dragged: faces are captured step by step at the newest origin and shown when complete; the
  /// final capture is made once the drag has ended (`interactive` false).
  void setInteractive(bool interactive);

  /// For a window whose probes can be dragged: programs a drag needs are compiled ahead, as part of the work.
  void setEditable(bool editable);

  /// For a window that is looked at while probes are captured: where a probe has nothing to show yet, the sky stands in
  /// for its surroundings, then a capture of a few texels, until its own maps are there. These are the same either way.
  /// Not with realtime probes, whose captures see whatever is shown. Before sync().
  void showCoarseFirst(bool coarse);

  /// For a window that shows cheaper techniques while something moves (see EvaluationRow::standIn): their programs are
  /// compiled ahead, as part of the work.
  void allowStandIns(bool allowed);
  /// The camera or a handle moves: surfaces are drawn by what stands in for their techniques, those whose programs are
  /// ready; the debug view's colours, explanations and linear pictures never are. Returns whether any surface is.
  bool setMoving(bool moving);

  /// Nothing is being edited, and many frames are to be drawn: programs that have the numbers of probes and materials
  /// as constants are compiled as part of the work, and drawn with from then on until sync() or setInteractive() is
  /// called next. To be called when no work is pending; what does not compile is drawn as before. The pictures are the
  /// same to 1/255.
  void foldConstants();

  bool workPending() const;
  /// One unit of work; the GL context must be current (call window->MakeCurrent() first). Returns workPending().
  bool step();
  /// 0..1 of the work known now, for a progress bar; 1 when none is pending.
  double workProgress() const;
  WorkNow workNow() const;
  /// step() until done; `progress(fraction)` may return false to stop early. Returns false if stopped.
  bool finishWork(const std::function<bool(double)>& progress = {});

  /// false: no reflections from probes or sky at all, every object draws with VTK's plain program.
  void setProbesEnabled(bool enabled);

  /// For pictures that are compared with VTK's own: lamps and coats as VTK 9.1 has them, and
  /// the split sum by VTK's `table` (N.V across, roughness up, texel centres; x scales F0, y scales F90). From then on.
  void lightAsVtk(int columns, int rows, const std::vector<glm::vec2>& table);

  /// true: every program works out all there is, whatever its materials make needless. The pictures are the same to
  /// 1/255; this is for tests and measurements that compare them.
  void drawGenerally(bool generally);
  /// Only these parts of what is done for the driver's sake, to find what each gains; 0 is drawGenerally(true).
  void tune(TuningParts parts);

  /// To find what they cost, frames are drawn without `parts` of these objects (their places, see drawnPrograms();
  /// none: of all) and without the sky. The pictures are wrong until it is called with nothing left out.
  void leaveOut(FrameParts parts, const std::vector<std::size_t>& objects = {}, bool sky = false);
  /// true: frames draw what they know to be hidden, too; false, the default: frames of a view that rests leave it out.
  void drawHidden(bool hidden);
  /// true: the next frames keep the depth of the one before, so that only what is seen in the end is worked out.
  void keepDepth(bool keep);
  /// The programs of the last frame's objects, in the order of their first object.
  std::vector<DrawnProgram> drawnPrograms() const;

  /// Places the active camera; clipping range follows the scene's bounds at each render.
  void applyCamera(const Camera& camera);
  Camera currentCamera() const;  ///< as it stands now, after interaction

  vtkRenderer* renderer() const;
  /// Bounds of all visible objects: min, max. A unit box when there is none.
  Box bounds() const;

  /// Renders one frame with VTK's own path into the window's frame buffer and reads it back: display colours. Where
  /// techniques average frames, that is the mean of this frame and those before it.
  ImageRgba8 renderDisplay();
  /// In linear scene units (exposure not applied), RGBA float, alpha = coverage; `samplesPerPixel` 1, 4 or 16. One
  /// frame, or the mean of `frames` of an animated technique; `beforeFrame` is called before each and may throw.
  ImageRgbaF renderLinear(int width, int height, int samplesPerPixel, int frames = 1,
                          const std::function<void(int)>& beforeFrame = {});

  /// Does a visible object's technique draw another pattern every frame? Its picture is then the mean of the frames
  /// since anything that shows was last changed.
  bool averagesFrames() const;
  /// How far the picture in the window is; nothing is drawn unasked.
  FrameCount frameCount() const;
  /// The next frame begins the picture again, although nothing has changed: to time it.
  void restartPicture();
  /// The mean is of so many frames; nothing: of as many as the technique's rays ask for (see framesWanted).
  void setFrameLimit(std::optional<int> frames);

  /// A view that rests goes on to the truth, whatever technique its probes have: from the next frame on each adds rays
  /// of the whole lobe, until there are as many as asked for or nothing more would show. Anything that changes begins
  /// the picture again; captures come first. frameCount() tells how far it is. `rays` 0: frames are the techniques'.
  void refine(const RefineSettings& settings);
  const RefineSettings& refineSettings() const;
  /// How far the picture drawn last has come, renderRefined()'s included.
  RefineState refineState() const;
  /// As renderLinear(), refined. Mip levels that are not filtered yet are made by finishWork() after refine().
  ImageRgbaF renderRefined(int width, int height, int samplesPerPixel, const RefineSettings& settings,
                           const std::function<void(int)>& beforeFrame = {});

  /// What the surfaces are coloured by: a row of surfaceViews(). Row 0, the picture, costs nothing; any other compiles
  /// further programs when it is first drawn.
  void setView(const SurfaceViewSettings& settings);
  const SurfaceViewSettings& view() const;
  /// The range the active view shows, the scene's own where none is locked.
  std::pair<double, double> viewRange() const;

  /// The whole calculation of one pixel of a picture of `width` x `height` through the current camera; x, y from the
  /// top left. Draws that pixel only.
  Explanation explain(int x, int y, int width, int height);
  /// Many pixels of one picture: the surfaces are drawn once.
  std::vector<Explanation> explain(const std::vector<glm::ivec2>& pixels, int width, int height);

  /// Baked files of this folder are used in place of captures where their inputs are those of the scene; empty: none.
  /// Looks at the folder once, at this call.
  void useBakedFiles(const std::string& folder);
  /// The work is to make these baked probes and no more, whether an object uses them or not; those that have a file
  /// that holds are not even loaded. Empty: everything the picture needs, the default.
  void setBakeTargets(const std::vector<std::string>& probes);
  /// Makes these probes again although nothing changed; a custom probe's picture is read again.
  void requestBake(const std::vector<std::string>& probes);
  BakeState bakeState(const std::string& probeName) const;
  /// The keys of a baked probe's maps (see BakeFolder), bounce by bounce, the last those it is to show. Empty for any
  /// other, and while nothing asks for the probe.
  std::vector<std::string> bakeKeys(const std::string& probeName) const;
  /// Writes the maps of a baked probe (an empty name: the sky) as an EXR file into `folder`; returns its path, empty
  /// if they are not final. `program` is what the file names as its writer; `earlierBounce` as in BakeFolder::save.
  /// Throws WorkError.
  std::string saveBaked(const std::string& probeName, const std::string& folder, const std::string& program,
                        int earlierBounce = 0) const;
  /// Files hold every mip level: filters one of this probe's that nothing has sampled so far. False: none is missing,
  /// and saveBaked and mapsOnCpu have nothing to filter.
  bool filterMissingLevel(const std::string& probeName);
  /// OpenGL's name of what draws and captures.
  std::string rendererName() const;
  /// Empty while every custom probe's picture could be read; else one line. Such a probe keeps the maps it had.
  const std::string& pictureError() const;

  /// Light that was put right on its way into the maps, counted: NaN and infinite texels of pictures and captures,
  /// samples beyond what a half float holds. One sentence each, for warnings.
  std::vector<std::string> remarks() const;

  /// The maps a probe shows now, read back; nothing while it has none. An empty name stands for the sky.
  std::optional<BakedMaps> readMaps(const std::string& probeName) const;
  /// The same, read back once for each capture; null while it has none.
  std::shared_ptr<const BakedMaps> mapsOnCpu(const std::string& probeName);
  /// The copy that explain() looks up: mip levels that nothing samples are not filtered for it and hold plain means.
  std::shared_ptr<const BakedMaps> explainedMaps(const std::string& probeName);

  /// What a probe shows now, on the graphics side; another object whenever it was made again. Null while it has none.
  std::shared_ptr<const ProbeMaps> shownMaps(const std::string& probeName) const;
  /// The probes' diffuse light as the last frame drew it (filters/core/geometry/probe_diffuse.h): lamps and lattices,
  /// or coefficients, through openings the sky's as well.
  ProbesDiffuse probesDiffuse() const;
  /// A sphere at a probe's origin, lit by its maps alone; not in captures, explanations and renderLinear().
  void showPreviewSphere(const PreviewSphereSettings& settings);
  const PreviewSphereSettings& previewSphere() const;

  /// What the frame drawn last does and leaves out. Lookups are counted only by measureLookups, which draws.
  FrameReport frameReport() const;
  /// Lookups a pixel of a picture of that size through the current camera.
  FrameReport::Lookups measureLookups(int width, int height);

  const Counters& counters() const;
  const Times& times() const;
  std::size_t probeMemoryBytes() const;

  /// Empty while all is well; else one line: a shader anchor that did not match, a framebuffer that is not complete.
  /// Renders go on without reflections then; a program reports it and fails.
  std::string error() const;

  void releaseGraphics();

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace boxprobe
