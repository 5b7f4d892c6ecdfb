/**
 * @class vtkReflectionProbes
 * @brief the reflection probes of one vtkRenderer
 *
 *     vtkNew<vtkReflectionProbe> probe;
 *     probe->SetBounds(bounds);
 *     vtkNew<vtkReflectionProbes> probes;
 *     probes->SetRenderer(renderer);
 *     probes->AddProbe(probe);
 *     window->Render();
 *
 * Every physically shaded actor of the renderer (vtkProperty::SetInterpolationToPBR) reflects the probes whose
 * influence it meets, at most four, whatever its mapper: parts of assemblies, composite data, glyphs. All actors with a
 * mapper are captured; those without physically based shading as they look. Where no probe has weight, VTK's own light
 * remains: the renderer's environment texture while UseImageBasedLighting is on, and its lights. Mappers, properties,
 * lights, camera and window are not changed; after deletion of the object VTK draws its own pictures again.
 *
 * Captures show the state of the renderer. Actors or lights that are added, moved, changed or removed, another
 * environment or background, and a probe's origin, orientation or capture settings make maps stale. The next Render()
 * recaptures those, unless AutoUpdate is off. A changed box or technique needs no capture. Lights that follow the
 * camera are captured at its current position; moving the camera makes nothing stale.
 *
 * With RefineAtRest a picture that rests goes on to the truth, in steps, and is the technique's own again as soon as
 * anything moves.
 *
 * Events: StartEvent before and EndEvent after captures, ProgressEvent (double*, 0 to 1) between them, EndRefineEvent
 * when a refined picture is complete, ErrorEvent and WarningEvent with one line. An actor named in an error is drawn
 * without reflections; nothing throws. An actor is lit by one object; other renderers of the window that show it draw
 * the same reflections with their own cameras.
 *
 * Use it in the thread of the window's OpenGL context.
 */
#pragma once

#include <vtkCommand.h>
#include <vtkObject.h>

#include <memory>

#include "filters/core/base/export.h"

class vtkProp;
class vtkReflectionProbe;
class vtkRenderer;

class BOXPROBE_EXPORT vtkReflectionProbes : public vtkObject {
 public:
  static vtkReflectionProbes* New();
  // clang-format off
  vtkTypeMacro(vtkReflectionProbes, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;
  /** Includes the MTime of the probes. */
  vtkMTimeType GetMTime() override;

  ///@{
  /** Null: none; the previous renderer is restored. It must belong to an OpenGL window at the first capture. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  ///@{
  /** Adding null, or a probe twice, is an error; removing another probe does nothing. */
  void AddProbe(vtkReflectionProbe* probe);
  void RemoveProbe(vtkReflectionProbe* probe);
  void RemoveAllProbes();
  int GetNumberOfProbes() const;
  /** In the order in which they were added; null for an invalid index. */
  vtkReflectionProbe* GetProbe(int index) const;
  ///@}

  ///@{
  /** On (default): stale maps are captured at the start of the window's next Render(). */
  vtkSetMacro(AutoUpdate, bool)
  vtkGetMacro(AutoUpdate, bool)
  vtkBooleanMacro(AutoUpdate, bool)
  ///@}
  ///@{
  /** Units of work (a face, a mip level) that AutoUpdate does per Render(); 0 (default): all. For windows that must stay
   * responsive: keep rendering while GetStale(). The previous maps are shown until new ones are complete. */
  vtkSetClampMacro(StepsPerRender, int, 0, VTK_INT_MAX)
  vtkGetMacro(StepsPerRender, int)
  ///@}

  /** Do maps show another state than the renderer's current one, or is their capture in progress? */
  bool GetStale();
  /** Captures everything that is stale. False if that failed: see GetLastError(). */
  bool Update();
  /** One unit of that. True if there is more. */
  bool UpdateStep();
  /** Captures every probe again, stale or not. */
  bool Capture();

  ///@{
  /** Do captures show the prop? On by default; switch it off for instance for a sphere around the origin. An assembly
   * is captured with all of its parts. */
  void SetSeenByProbes(vtkProp* prop, bool seen);
  bool GetSeenByProbes(vtkProp* prop) const;
  ///@}
  ///@{
  /** On by default. Off: the prop is neither lit by probes nor captured. */
  void SetUsed(vtkProp* prop, bool used);
  bool GetUsed(vtkProp* prop) const;
  ///@}

  ///@{
  /** Factor on the linear light of actors with probes before display encoding. 1 by default, as in VTK. */
  vtkSetClampMacro(Exposure, double, 1.0e-6, 1.0e6)
  vtkGetMacro(Exposure, double)
  ///@}
  enum ToneMappings { TONE_AS_VTK = 0, TONE_NONE, TONE_NEUTRAL, TONE_AGX, TONE_ACES };
  ///@{
  /** Tone curve of actors with probes. TONE_AS_VTK (default): VTK's power of 1 / 2.2, as for all other actors, clamped at
   * 1. The others use the sRGB curve: TONE_NONE clamped at 1, TONE_NEUTRAL Khronos PBR Neutral, TONE_AGX AgX, TONE_ACES
   * ACES by Hill's fit. */
  vtkSetClampMacro(ToneMapping, int, TONE_AS_VTK, TONE_ACES)
  vtkGetMacro(ToneMapping, int)
  ///@}
  ///@{
  /** VTK up to 9.1 ignores emissive factors without an emissive texture. Switch this on for actors whose factors are
   * meant, such as vtkGLTFImporter's. Off by default, because vtkProperty's default factor is white. */
  vtkSetMacro(Emission, bool)
  vtkGetMacro(Emission, bool)
  vtkBooleanMacro(Emission, bool)
  ///@}
  ///@{
  /** Adds the light that meets more than one microfacet of a rough surface. Off by default, as in VTK 9.1. */
  vtkSetMacro(MultipleScattering, bool)
  vtkGetMacro(MultipleScattering, bool)
  vtkBooleanMacro(MultipleScattering, bool)
  ///@}

  enum Events { EndRefineEvent = vtkCommand::UserEvent + 52 };
  ///@{
  /** On: a view that rests is refined by rays of the whole lobe, whatever the techniques are, at most 8 a pixel and
   * frame, until RefineRays or RefineSeconds ends it or further changes would not show; then EndRefineEvent is invoked.
   * A Render() that shows anything else, or from elsewhere, draws the techniques' own picture. Steps come from timers of
   * the window's interactor, RefineDelay after the last change; programs without one call RefineStep(). Actors are drawn
   * into float targets for it, at the window's samples per pixel; props without probes are drawn over them. Off by
   * default. */
  void SetRefineAtRest(bool refine);
  vtkGetMacro(RefineAtRest, bool)
  vtkBooleanMacro(RefineAtRest, bool)
  ///@}
  ///@{
  /** Per pixel, 1 to 16384. 256 by default, which ends about .02 of its value off the integral over a lobe. */
  vtkSetClampMacro(RefineRays, int, 1, 16384)
  vtkGetMacro(RefineRays, int)
  ///@}
  ///@{
  /** Longest time from the first refined frame on, in seconds; the picture stays as good as it is then. 0 (default): no
   * limit. */
  vtkSetClampMacro(RefineSeconds, double, 0.0, VTK_DOUBLE_MAX)
  vtkGetMacro(RefineSeconds, double)
  ///@}
  ///@{
  /** Seconds without a change after which the interactor's timer begins. 0.5 by default. */
  vtkSetClampMacro(RefineDelay, double, 0.0, 3600.0)
  vtkGetMacro(RefineDelay, double)
  ///@}
  /** Renders the window once, one step further on the way to the refined picture. True if there are more. False also
   * without RefineAtRest, and where the renderer has a pass of its own, UseSSAO, UseFXAA, UseShadows or peeled layers,
   * which is a warning. */
  bool RefineStep();
  /** Is the window's picture refined? */
  bool GetRefining() const;
  /** 0 to 1; 1 at the end. */
  double GetRefineProgress() const;
  /** The relative error that is estimated to be left, of what rays can change; negative: unknown. */
  double GetRefineLeft() const;

  /** Uses a file of `boxprobe bake` in place of captures of the probe, until ForgetMaps(). False on failure: see
   * GetLastError(). */
  bool LoadMaps(vtkReflectionProbe* probe, const char* file);
  void ForgetMaps(vtkReflectionProbe* probe);

  ///@{
  /** The line of the last ErrorEvent; empty without an error. */
  const char* GetLastError() const;
  void ClearError();
  ///@}

  /** Releases OpenGL resources while the window still exists. Everything is stale afterwards. */
  void ReleaseGraphicsResources();
  // clang-format on

 protected:
  vtkReflectionProbes();
  ~vtkReflectionProbes() override;

  bool AutoUpdate = true;
  int StepsPerRender = 0;
  double Exposure = 1.0;
  int ToneMapping = TONE_AS_VTK;
  bool Emission = false;
  bool MultipleScattering = false;
  bool RefineAtRest = false;
  int RefineRays = 256;
  double RefineSeconds = 0.0;
  double RefineDelay = 0.5;

 private:
  vtkReflectionProbes(const vtkReflectionProbes&) = delete;
  void operator=(const vtkReflectionProbes&) = delete;

  bool Ready(const char* call);
  void Sync();
  void SyncProbes();
  void SyncActors();
  void BeforeFrame();
  void Report();
  void Fail(const std::string& line);
  void Finish(bool done);
  void AfterFrame();
  void FollowInteractor();
  void SetTimer(double seconds);
  void DropTimer();
  void OnTimer(int timer);

  struct Parts;
  std::unique_ptr<Parts> Inside;
};
