/**
 * @class vtkProjectionRays
 * @brief the rays of box projection at given points, as lines that carry the numbers
 *
 * Input 0: points with normals (point data; optional array "roughness", perceptual, 0 without it). Input 1, optional:
 * the scene's triangles, for the true hit. Without it the true hit comes from a probe's own distances, if it has any.
 * Output: two-point lines with the cell arrays of filters/vtk/rays/ray_arrays.h, in double precision:
 *
 *      eye          normal                          per point:  eye ray, normal
 *        \           |      . H  (hit on the box)   per probe:  reflected ray P-H, lookup C-H of every fetch,
 *         \          |   .                                      true hit, error H-T
 *          \_________|.__________  P                            (none reaches P: the reflected ray, to the sky)
 *
 * If some rays of a point are undefined, "status" says why and the others are output; non-finite points give nothing.
 * The mathematics is the shader's own, through filters/math. Works in any pipeline; needs no OpenGL.
 */
#pragma once

#include <vtkPolyDataAlgorithm.h>

#include <memory>
#include <vector>

#include "filters/core/base/export.h"
#include "filters/vtk/rays/ray_arrays.h"

namespace boxprobe {
class CubeMap;
struct Light;
struct Probe;
struct RayGlass;
}  // namespace boxprobe

class BOXPROBE_EXPORT vtkProjectionRays : public vtkPolyDataAlgorithm {
 public:
  static vtkProjectionRays* New();
  // clang-format off
  vtkTypeMacro(vtkProjectionRays, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** Position of the eye, world. */
  vtkSetVector3Macro(Eye, double)
  vtkGetVector3Macro(Eye, double)
  ///@}
  ///@{
  /** Parallel projection: every point is seen along ViewDirection, the camera's direction, instead of from Eye. */
  vtkSetMacro(ParallelProjection, vtkTypeBool)
  vtkGetMacro(ParallelProjection, vtkTypeBool)
  vtkBooleanMacro(ParallelProjection, vtkTypeBool)
  vtkSetVector3Macro(ViewDirection, double)
  vtkGetVector3Macro(ViewDirection, double)
  ///@}
  ///@{
  /** Maximum number of points that get rays; if there are more, an evenly spaced subset of this size. */
  vtkSetClampMacro(MaximumNumberOfRays, int, 0, VTK_INT_MAX)
  vtkGetMacro(MaximumNumberOfRays, int)
  ///@}
  ///@{
  /** Length of lines without an end (rays to the sky, without a proxy, in parallel projection), scene units. */
  vtkSetClampMacro(MaximumLength, double, 0.0, 1.0e30)
  vtkGetMacro(MaximumLength, double)
  ///@}
  ///@{
  /** Length of drawn normals, scene units. */
  vtkSetClampMacro(NormalLength, double, 0.0, 1.0e30)
  vtkGetMacro(NormalLength, double)
  ///@}
  ///@{
  /** On: only probes whose share of the point exceeds 1e-5, which the picture samples. Off: every probe. */
  vtkSetMacro(ContributingProbesOnly, vtkTypeBool)
  vtkGetMacro(ContributingProbesOnly, vtkTypeBool)
  vtkBooleanMacro(ContributingProbesOnly, vtkTypeBool)
  ///@}
      // clang-format on

      /** Objects that transmit light; a point's optional array "glass" names one: 2 x its index, + 1 from inside. */
      void SetGlass(std::vector<boxprobe::RayGlass> glass);

  ///@{
  /** The kinds of lines in the output; all by default. */
  void SetKindEnabled(boxprobe::RayKind kind, bool enabled);
  bool GetKindEnabled(boxprobe::RayKind kind) const;
  ///@}

  ///@{
  /**
   * Probes, by index. AddProbe() appends one of the scene file's defaults (a box from -1 to 1, technique "box") and
   * returns its index. Bounds are xmin, xmax, ymin, ... as everywhere in VTK; the rotation (about world X, then Y, then
   * Z) is about the box's centre. By default a probe's influence is its box. A value out of range is an error and
   * changes nothing.
   */
  int AddProbe();
  void RemoveAllProbes();
  int GetNumberOfProbes() const;
  void SetProbeName(int index, const char* name);
  void SetProbeOrigin(int index, double x, double y, double z);
  void SetProbeBounds(int index, double xMin, double xMax, double yMin, double yMax, double zMin, double zMax);
  void SetProbeRotation(int index, double xDegrees, double yDegrees, double zDegrees);
  void SetProbeInfluence(int index, double xMin, double xMax, double yMin, double yMax, double zMin, double zMax);
  void SetProbeBlendDistance(int index, double distance);
  void SetProbeImportance(int index, double importance);
  void SetProbeTechnique(int index, const char* id);
  /** Last level of the probe's prefiltered chain; by default that of its face size. */
  void SetProbeMaximumLevel(int index, double level);
  ///@}

  ///@{
  /** The same from a scene's probe; `maximumLevel` < 0: that of its face size. */
  int AddProbe(const boxprobe::Probe& probe, double maximumLevel = -1.0);
  /** Replaces all probes, in the scene's order, and removes their distances. */
  void SetProbes(const std::vector<boxprobe::Probe>& probes);
  /** Where the probe's maps were captured, if that differs from its origin. */
  void SetProbeCapturedAt(int index, double x, double y, double z);
  /** Rotation of the axes of its distances (BakedMaps::capturedRotation), degrees; by default the world's axes. */
  void SetProbeCapturedRotation(int index, double xDegrees, double yDegrees, double zDegrees);
  /** Distances from the capture origin (BakedMaps::distance); null: unknown. */
  void SetProbeDistances(int index, std::shared_ptr<const boxprobe::CubeMap> distances);
  /** Its captured radiance and coverage (BakedMaps::radiance), for the transmittance of lights. */
  void SetProbeCoverage(int index, const boxprobe::CubeMap& radiance);
  /** Lights: shadow rays go to those that cast shadows and are outside the probe's box. */
  void SetLights(const std::vector<boxprobe::Light>& lights);
  ///@}

  ///@{
  /** The scene's triangles, input 1. */
  void SetSceneConnection(vtkAlgorithmOutput* output) { this->SetInputConnection(1, output); }
  void SetSceneData(vtkPolyData* scene);
  ///@}

 protected:
  vtkProjectionRays();
  ~vtkProjectionRays() override;
  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** input, vtkInformationVector* output) override;

  double Eye[3] = {0.0, 0.0, 0.0};
  vtkTypeBool ParallelProjection = 0;
  double ViewDirection[3] = {0.0, 0.0, -1.0};
  int MaximumNumberOfRays = 1000;
  double MaximumLength = 100.0;
  double NormalLength = 0.25;
  vtkTypeBool ContributingProbesOnly = 1;

 private:
  vtkProjectionRays(const vtkProjectionRays&) = delete;
  void operator=(const vtkProjectionRays&) = delete;

  struct Internals;
  boxprobe::Probe* EditProbe(int index, bool valid);
  std::unique_ptr<Internals> Internal;
};
