// The command line of `render` as values, checked as far as that goes without reading a file.
#pragma once

#include <string>
#include <vector>

#include "app/cli/options/subcommand.h"
#include "filters/core/scene/scene.h"
#include "filters/core/scene/surface_view.h"
#include "filters/fit/fit_model.h"
#include "filters/vtk/frame/refinement.h"

namespace boxprobe {

struct FrameSize {
  int width = 1280;
  int height = 720;
};

/// How a bare model is to be treated; empty: as it is found.
struct FitOptions {
  std::string kind, light;
};
void addFitOptions(CLI::App& command, FitOptions& options);
/// `aspect`: width over height of the picture.
FitWishes parseFitWishes(const FitOptions& options, double aspect);

/// Reflection rays a pixel of a reference, over all of its samples.
inline constexpr int kDefaultReferenceRays = 256;

struct RenderOptions {
  std::string scenePath;
  std::string outputPath;
  std::string size = "1280x720";
  std::string camera;     ///< empty: "main", else the first
  std::string technique;  ///< empty: as in the scene
  int samples = 4;
  std::string probes = "on";
  std::string tone;  ///< empty: the scene's
  int frames = 0;
  int rays = kDefaultReferenceRays;  ///< of a reference, or of traced diffuse light: rays per pixel
  bool full = false;                 ///< of reference-scene: reflection rays see what the picture shows
  std::string bounces;               ///< of traced light: a number or "all"; empty: the scene's
  std::string shard;   ///< of reference-scene and reference-path: I/N or auto; empty: alone, or as mpiexec says
  std::string refine;  ///< a number of rays or an error in percent; empty: the picture is not refined
  std::string view;    ///< id of a row of surfaceViews(); empty: the picture
  std::string range;   ///< LOW,HIGH; empty: the view's own
  std::vector<std::string> assignments;
  FitOptions fit;
  ReportOptions report;
};

/// Adds the options of `render` to `command`, with their help.
void addRenderOptions(CLI::App& command, RenderOptions& options);

/// "1280x720": two whole numbers from 1 to 16384. Throws InputError.
FrameSize parseFrameSize(const std::string& text);

/// What --view takes for a sheet of all rows.
inline constexpr const char* kAllViews = "all";

/// A row of the debug view's table and its range. Throws InputError listing the ids there are.
SurfaceViewSettings parseView(const std::string& id, const std::string& range);

/// What --refine says; nothing for an empty text. Throws InputError.
RefineSettings parseRefine(const std::string& text);

/// The camera of that name; without a name "main", else the first, else the default camera. Throws InputError listing
/// the names there are.
Camera chooseCamera(const Scene& scene, const std::string& name);

/// Gives every probe this technique; an empty id leaves them alone. Throws InputError listing the ids there are.
void chooseTechnique(Scene& scene, const std::string& id);

}  // namespace boxprobe
