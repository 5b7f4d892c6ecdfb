/**
 * @class vtkReflectionProbe
 * @brief a place that is captured into a cubemap, and the box through which surfaces reflect it
 *
 * Lengths and positions are in the world frame and the units of the renderer. Angles are degrees. Defaults follow the
 * bounds: the origin is their centre, the influence is the same box with full weight up to its faces, and the near and
 * far distances of the capture are derived from the box and from what the renderer shows. So two calls are enough:
 *
 *     probe->SetBounds(bounds);
 *     probes->AddProbe(probe);     // vtkReflectionProbes
 *
 * A value out of range causes an ErrorEvent of vtkReflectionProbes, which continues with the previous values. Needs no
 * OpenGL.
 */
#pragma once

#include <vtkObject.h>

#include <memory>
#include <string>

#include "filters/core/base/export.h"

namespace boxprobe {
struct Probe;
}  // namespace boxprobe

class BOXPROBE_EXPORT vtkReflectionProbe : public vtkObject {
 public:
  static vtkReflectionProbe* New();
  // clang-format off
  vtkTypeMacro(vtkReflectionProbe, vtkObject)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Used in messages. Empty: "probe", numbered if there are several; names need not be unique. */
  vtkSetStdStringFromCharMacro(Name)
  vtkGetCharFromStdStringMacro(Name)
  ///@}
  ///@{
  /** Off: lights nothing, is not captured, and releases its maps. On by default. */
  vtkSetMacro(Enabled, bool)
  vtkGetMacro(Enabled, bool)
  vtkBooleanMacro(Enabled, bool)
  ///@}

  ///@{
  /** The box on which reflections are projected: xmin, xmax, ymin, ymax, zmin, zmax; -1 to 1 by default. Fit it to the
   * walls. A changed box needs no new capture. */
  void SetBounds(double xMin, double xMax, double yMin, double yMax, double zMin, double zMax);
  void SetBounds(const double bounds[6]);
  vtkGetVector6Macro(Bounds, double)
  ///@}
  ///@{
  /** Where the cubemap is captured; by default the centre of the bounds. Keep it out of objects, or hide these from
   * probes. */
  void SetOrigin(double x, double y, double z);
  void SetOrigin(const double origin[3]);
  vtkGetVector3Macro(Origin, double)
  ///@}
  ///@{
  /** On: the origin is the centre of the bounds and moves with them. SetOrigin() switches it off. */
  void SetOriginAtCenter(bool atCenter);
  vtkGetMacro(OriginAtCenter, bool)
  vtkBooleanMacro(OriginAtCenter, bool)
  ///@}
  ///@{
  /** Rotates both boxes about the centre of the bounds: degrees about the world's X, then Y, then Z axis. */
  vtkSetVector3Macro(Orientation, double)
  vtkGetVector3Macro(Orientation, double)
  ///@}

  ///@{
  /** The box inside which the probe lights surfaces, if UseInfluenceBounds is on; else the bounds are used. */
  vtkSetVector6Macro(InfluenceBounds, double)
  vtkGetVector6Macro(InfluenceBounds, double)
  vtkSetMacro(UseInfluenceBounds, bool)
  vtkGetMacro(UseInfluenceBounds, bool)
  vtkBooleanMacro(UseInfluenceBounds, bool)
  ///@}
  ///@{
  /** From each face of the influence box inwards, the weight rises from 0 to 1 over this distance. 0 by default: full
   * weight up to the faces. One value for all faces, or six for those at xmin, xmax, ymin, ... */
  void SetBlendDistance(double distance);
  vtkSetVector6Macro(BlendDistances, double)
  vtkGetVector6Macro(BlendDistances, double)
  ///@}
  ///@{
  /** Probes of equal importance share what more important ones leave. 1 by default. */
  vtkSetMacro(Importance, double)
  vtkGetMacro(Importance, double)
  ///@}
  ///@{
  /** Factor of the probe's light. 1 by default. */
  vtkSetMacro(Intensity, double)
  vtkGetMacro(Intensity, double)
  ///@}

  ///@{
  /** How reflections are sampled: "box" (default), "infinite", "sphere", ..., an evaluation after "+", or "auto"; see
   * shaders/technique/README.md. Setting a technique resets its parameters to their defaults. */
  void SetTechnique(const char* technique);
  const char* GetTechnique() const;
  void SetTechniqueNumber(const char* parameter, double value);
  void SetTechniqueChoice(const char* parameter, const char* value);
  ///@}

  ///@{
  /** Texels per side of a face, a power of two from 16 to 2048. 256 by default. */
  vtkSetMacro(FaceSize, int)
  vtkGetMacro(FaceSize, int)
  ///@}
  ///@{
  /** Number of captures, 1 to 5: from the second on they show reflections. 1 by default. All of them: until another
      changes the light that they bring by less than 1 %, at most 16, which is then the value. */
  vtkSetMacro(Bounces, int)
  vtkGetMacro(Bounces, int)
  void SetBouncesToAll();
  ///@}
  ///@{
  /** Samples per texel of the capture: 1, 4 (default) or 16. */
  vtkSetMacro(SamplesPerPixel, int)
  vtkGetMacro(SamplesPerPixel, int)
  ///@}
  ///@{
  /** Clipping distances of the capture. 0 (default): derived from the box and from what the renderer shows. */
  vtkSetMacro(NearDistance, double)
  vtkGetMacro(NearDistance, double)
  vtkSetMacro(FarDistance, double)
  vtkGetMacro(FarDistance, double)
  ///@}
  ///@{
  /** What the probe holds where it saw no surface. SURROUNDINGS (default): the renderer's environment, else its
   * background. COLOR: ClearColor, linear. OPEN: the renderer's current environment shows through. */
  enum ClearMode { SURROUNDINGS = 0, COLOR = 1, OPEN = 2 };
  vtkSetClampMacro(Clear, int, SURROUNDINGS, OPEN)
  vtkGetMacro(Clear, int)
  vtkSetVector3Macro(ClearColor, double)
  vtkGetVector3Macro(ClearColor, double)
  ///@}

  ///@{
  /** Conversion to the libraries' struct, named `name`, without validation; and back, without what this class lacks (a
   * bevel, occlusion, a lattice of its own, pictures in place of captures). */
  boxprobe::Probe ToProbe(const std::string& name) const;
  void FromProbe(const boxprobe::Probe& probe);
  ///@}
  // clang-format on

 protected:
  vtkReflectionProbe();
  ~vtkReflectionProbe() override;

  std::string Name;
  bool Enabled = true;
  double Bounds[6] = {-1.0, 1.0, -1.0, 1.0, -1.0, 1.0};
  double Origin[3] = {0.0, 0.0, 0.0};
  bool OriginAtCenter = true;
  double Orientation[3] = {0.0, 0.0, 0.0};
  double InfluenceBounds[6] = {-1.0, 1.0, -1.0, 1.0, -1.0, 1.0};
  bool UseInfluenceBounds = false;
  double BlendDistances[6] = {0.0, 0.0, 0.0, 0.0, 0.0, 0.0};
  double Importance = 1.0;
  double Intensity = 1.0;
  int FaceSize = 256;
  int Bounces = 1;
  int SamplesPerPixel = 4;
  double NearDistance = 0.0;
  double FarDistance = 0.0;
  int Clear = SURROUNDINGS;
  double ClearColor[3] = {0.0, 0.0, 0.0};

 private:
  vtkReflectionProbe(const vtkReflectionProbe&) = delete;
  void operator=(const vtkReflectionProbe&) = delete;

  struct TechniqueOfProbe;
  std::unique_ptr<TechniqueOfProbe> Chosen;
};
