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
 * mapper are captured; what is not shaded physically as it looks. Where no probe has weight, VTK's own light stays: the
 * renderer's environment texture while UseImageBasedLighting is on, its lights always. Mappers, properties, lights,
 * camera and window stay what they are; deleted, the object leaves no trace.
 *
 * Captures go by the state of the renderer. Actors or lights that are added, moved, changed or removed, another
 * environment or background, and a probe's origin, orientation or capture settings make maps stale. The next Render()
 * captures those again, unless AutoUpdate is off. A changed box or technique needs no capture. Lights that follow the
 * camera are captured where it is then; the camera makes nothing stale.
 *
 * Events: StartEvent and EndEvent about captures, ProgressEvent (double*, 0 to 1) within, ErrorEvent and WarningEvent
 * with one line. An actor that an error names is drawn without reflections; nothing throws. An actor is lit by one
 * object; further renderers of the window that show it draw the same reflections by their own cameras.
 *
 * To be used in the thread of the window's OpenGL context.
 */
#pragma once

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
  /** That of the newest probe, if it is newer. */
  vtkMTimeType GetMTime() override;

  ///@{
  /** Null: none; its actors are VTK's own again. It belongs to an OpenGL window by the time of the first capture. */
  void SetRenderer(vtkRenderer* renderer);
  vtkRenderer* GetRenderer() const;
  ///@}

  ///@{
  /** Of one that is there already, and of null, AddProbe() is an error; RemoveProbe() does nothing for others. */
  void AddProbe(vtkReflectionProbe* probe);
  void RemoveProbe(vtkReflectionProbe* probe);
  void RemoveAllProbes();
  int GetNumberOfProbes() const;
  /** In the order in which they were added; null for an index that is none. */
  vtkReflectionProbe* GetProbe(int index) const;
  ///@}

  ///@{
  /** On (default): stale maps are captured at the start of the window's next Render(). */
  vtkSetMacro(AutoUpdate, bool)
  vtkGetMacro(AutoUpdate, bool)
  vtkBooleanMacro(AutoUpdate, bool)
  ///@}
  ///@{
  /** Units of work (a face, a mip level) that AutoUpdate does for each Render(); 0 (default): all of it. For windows that
   * stay live: render on while GetStale(). The maps before stay in the picture until new ones are whole. */
  vtkSetClampMacro(StepsPerRender, int, 0, VTK_INT_MAX)
  vtkGetMacro(StepsPerRender, int)
  ///@}

  /** Do maps show another state than the renderer's now, or is their capture under way? */
  bool GetStale();
  /** Captures what is stale, all of it. False if that failed: see GetLastError(). */
  bool Update();
  /** One unit of that. True while there is more. */
  bool UpdateStep();
  /** Captures every probe again, stale or not. */
  bool Capture();

  ///@{
  /** Do captures show it? On for every prop until it is switched off: for instance for a ball about the origin.
   * An assembly is captured with all of its parts. */
  void SetSeenByProbes(vtkProp* prop, bool seen);
  bool GetSeenByProbes(vtkProp* prop) const;
  ///@}
  ///@{
  /** Is it touched at all? Switched off, it is neither lit nor captured. */
  void SetUsed(vtkProp* prop, bool used);
  bool GetUsed(vtkProp* prop) const;
  ///@}

  ///@{
  /** Factor on the linear light of actors with probes before it is shown. 1 by default, which is VTK's. */
  vtkSetClampMacro(Exposure, double, 1.0e-6, 1.0e6)
  vtkGetMacro(Exposure, double)
  ///@}
  enum ToneMappings { TONE_AS_VTK = 0, TONE_NONE, TONE_NEUTRAL, TONE_AGX, TONE_ACES };
  ///@{
  /** How light of actors with probes is shown. TONE_AS_VTK (default): by VTK's power of 1 / 2.2, as all other actors are,
   * white beyond 1. The others by the curve of sRGB: TONE_NONE white beyond 1, TONE_NEUTRAL Khronos PBR Neutral, TONE_AGX
   * AgX, TONE_ACES the Academy's contrast by Hill's fit. */
  vtkSetClampMacro(ToneMapping, int, TONE_AS_VTK, TONE_ACES)
  vtkGetMacro(ToneMapping, int)
  ///@}
  ///@{
  /** Up to VTK 9.1 emissive factors show only with an emissive texture. On, they show: for actors whose factors are
   * meant, such as vtkGLTFImporter's. Off by default, since vtkProperty's own default factor is white. */
  vtkSetMacro(Emission, bool)
  vtkGetMacro(Emission, bool)
  vtkBooleanMacro(Emission, bool)
  ///@}
  ///@{
  /** Adds the light that meets more than one microfacet of a rough surface. Off by default, as VTK 9.1. */
  vtkSetMacro(MultipleScattering, bool)
  vtkGetMacro(MultipleScattering, bool)
  vtkBooleanMacro(MultipleScattering, bool)
  ///@}

  /** A file that `boxprobe bake` wrote, in place of captures of the probe, until ForgetMaps(). False: see
   * GetLastError(). */
  bool LoadMaps(vtkReflectionProbe* probe, const char* file);
  void ForgetMaps(vtkReflectionProbe* probe);

  ///@{
  /** One line; empty while all is well. The line of the last ErrorEvent. */
  const char* GetLastError() const;
  void ClearError();
  ///@}

  /** Frees what the graphics side holds, with the window still there. Everything is stale afterwards. */
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

  struct Parts;
  std::unique_ptr<Parts> Inside;
};
