// See render_options.h.
#include "app/cli/options/render_options.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "filters/core/base/errors.h"
#include "filters/math/technique/technique_table.h"

namespace boxprobe {

namespace {

std::string surfaceViewIdList() {
  std::string list;
  for (const SurfaceViewRow& row : surfaceViews()) list += (list.empty() ? "" : ", ") + std::string(row.id);
  return list;
}

std::vector<std::string> fitLightIds() {
  std::vector<std::string> ids;
  for (const FitLight light : allFitLights()) ids.emplace_back(fitLightId(light));
  return ids;
}

}  // namespace

void addFitOptions(CLI::App& command, FitOptions& options) {
  command.add_option("--as", options.kind, "Of a bare model: treat it as object, interior or open (default: as found)")
      ->check(CLI::IsMember({"object", "interior", "open"}).description(""))
      ->type_name("KIND");
  command
      .add_option("--light", options.light,
                  "Of a bare model: file, studio, ceiling, openings or daylight (default: the file's, else by what it "
                  "is)")
      ->check(CLI::IsMember(fitLightIds()).description(""))
      ->type_name("LIGHT");
}

FitWishes parseFitWishes(const FitOptions& options, double aspect) {
  FitWishes wishes;
  wishes.aspect = aspect;
  for (const ModelKind kind : {ModelKind::Object, ModelKind::Interior, ModelKind::Open}) {
    if (options.kind == modelKindId(kind)) wishes.kind = kind;
  }
  for (const FitLight light : allFitLights()) {
    if (options.light == fitLightId(light)) wishes.light = light;
  }
  return wishes;
}

void addRenderOptions(CLI::App& command, RenderOptions& options) {
  command
      .add_option("SCENE", options.scenePath,
                  "Scene file (.boxprobe.json) or bare model (.glb, .gltf, .obj, .ply, .stl, .vtp)")
      ->required();
  command.add_option("-o,--output", options.outputPath, "Picture: .png (display colours) or .exr (linear, float RGBA)")
      ->type_name("FILE")
      ->required();
  command.add_option("--size", options.size, "Width and height in pixels (default 1280x720)")->type_name("WxH");
  command.add_option("--camera", options.camera, "Camera of the scene (default: main, or else the first)")
      ->type_name("NAME");
  command
      .add_option(
          "--technique", options.technique,
          "Technique of every probe (default: the scene's): " + techniqueIdList() +
              "; or a reference: reference-box (the lobe integrated over the capture at exact box hits), "
              "reference-scene (one reflection, ray traced; diffuse light as the picture has it, with lamps in-map the "
              "sky's without shadows), reference-path (all light, path traced; needs no OpenGL)")
      ->type_name("ID");
  command.add_option("--samples", options.samples, "Samples per pixel: 1, 4 or 16 (default 4)")
      ->check(CLI::IsMember({1, 4, 16}).description(""))
      ->type_name("N");
  command
      .add_option("--rays", options.rays,
                  "Reflection rays per pixel of a reference, paths per pixel of reference-path and of the "
                  "view diffuse-error (default 256)")
      ->check(CLI::Range(1, 65536).description(""))
      ->type_name("N");
  command.add_flag("--full", options.full, "reference-scene: reflections also show what the probes do not see");
  command
      .add_option("--bounces", options.bounces,
                  "reference-path, view diffuse-error: how often light goes from surface to surface: 0 to 1000, or all "
                  "(default: the most of "
                  "the scene's probes; without probes all)")
      ->type_name("N|all");
  command
      .add_option("--shard", options.shard,
                  "reference-scene, reference-path: trace share I of N alone into a file beside the picture; who finds "
                  "all of them "
                  "there makes the picture. auto: the place in Slurm's array job or among mpiexec's processes")
      ->type_name("I/N|auto");
  command.add_option("--probes", options.probes, "off: no reflections from probes or sky, VTK's plain shader")
      ->check(CLI::IsMember({"on", "off"}).description(""))
      ->type_name("on|off");
  command
      .add_option("--tone", options.tone,
                  "Tone mapping of a PNG: none, neutral, agx or aces (default: the scene's; of a bare model neutral)")
      ->check(CLI::IsMember({"none", "neutral", "agx", "aces"}).description(""))
      ->type_name("TONE");
  command
      .add_option("--frames", options.frames,
                  "Average N frames (animated techniques); otherwise draw N extra. --stats has their CPU times")
      ->check(CLI::Range(0, 100000).description(""))
      ->type_name("N");
  command
      .add_flag("--refine{256}", options.refine,
                "The picture as the window shows it at rest, whatever the technique: =N by N rays of the whole lobe a "
                "pixel (default 256), =P% until P % are estimated to be left. Prints what is left")
      ->type_name("[=N|P%]");
  command
      .add_option("--view", options.view,
                  "Draw a debug view (PNG: with its scale; EXR: the numbers, -1 where undefined); all: a sheet of "
                  "every view: " +
                      surfaceViewIdList())
      ->type_name("ID");
  command.add_option("--range", options.range, "Range of the scale of --view (default: from the scene)")
      ->type_name("LOW,HIGH");
  command.add_option("--set", options.assignments, "Change a field of the scene: probes.NAME.FIELD=VALUE (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addModelOptions(command, options.assignments);
  addFitOptions(command, options.fit);
  addReportOptions(command, options.report, "Print the JSON that --stats writes");
  addOffscreenOption(command, options.report);
  command.footer(
      "Examples:\n"
      "  boxprobe render data/scenes/building.boxprobe.json -o building.png --size 1920x1080\n"
      "  boxprobe render data/scenes/room.boxprobe.json -o room.exr --technique infinite --set "
      "materials.floor.roughness=0.25\n"
      "  boxprobe render data/scenes/room.boxprobe.json -o truth.exr --technique reference-scene --rays 1024\n"
      "  boxprobe render data/scenes/furnished.boxprobe.json -o light.png --technique reference-path --bounces all\n"
      "  boxprobe render data/scenes/room.boxprobe.json -o still.png --refine=2%");
}

FrameSize parseFrameSize(const std::string& text) {
  constexpr int most = 16384;
  FrameSize size;
  char rest = 0;
  const bool digitsOnly = text.find_first_not_of("0123456789x") == std::string::npos;
  if (!digitsOnly || std::sscanf(text.c_str(), "%5dx%5d%c", &size.width, &size.height, &rest) != 2 || size.width < 1 ||
      size.height < 1 || size.width > most || size.height > most) {
    throw InputError("--size " + text + ": expected WIDTHxHEIGHT in pixels, each from 1 to 16384, as in 1280x720");
  }
  return size;
}

SurfaceViewSettings parseView(const std::string& id, const std::string& range) {
  SurfaceViewSettings settings;
  if (!id.empty() && id != kAllViews) {
    const std::optional<int> view = findSurfaceView(id);
    if (!view) throw InputError("--view " + id + ": no such view; there are: all, " + surfaceViewIdList());
    settings.view = *view;
  }
  if (range.empty()) return settings;
  const SurfaceViewRow& row = surfaceViews()[static_cast<std::size_t>(settings.view)];
  if (row.kind != ViewKind::Scalar) {
    throw InputError("--range " + range + ": only a view of a number has a scale; choose one with --view");
  }
  double low = 0.0, high = 0.0;
  int used = 0;
  const bool two = std::sscanf(range.c_str(), "%lf,%lf%n", &low, &high, &used) == 2;
  if (!two || static_cast<std::size_t>(used) != range.size() || !std::isfinite(low) || !std::isfinite(high) ||
      low >= high) {
    throw InputError("--range " + range + ": expected two numbers, the lower first, as in 0,8");
  }
  settings.low = low;
  settings.high = high;
  return settings;
}

RefineSettings parseRefine(const std::string& text) {
  RefineSettings settings;
  if (text.empty()) return settings;
  const auto refused = [&] {
    return InputError("--refine=" + text + ": expected a number of rays from 1 to " +
                      std::to_string(RefineSettings::kMostRays) +
                      ", or what may be left in percent, above 0 and below 100, as in --refine=256 or --refine=2%");
  };
  const bool percent = text.back() == '%';
  const std::string number = percent ? text.substr(0, text.size() - 1) : text;
  if (number.empty() || number.find_first_not_of(percent ? "0123456789." : "0123456789") != std::string::npos) {
    throw refused();
  }
  const double value = std::strtod(number.c_str(), nullptr);
  if (!(value > 0.0) || value > (percent ? 99.99 : RefineSettings::kMostRays)) throw refused();
  settings.rays = percent ? RefineSettings::kMostRays : static_cast<int>(value);
  if (percent) settings.until = value / 100.0;
  return settings;
}

Camera chooseCamera(const Scene& scene, const std::string& name) {
  const std::string wanted = name.empty() ? "main" : name;
  std::string names;
  for (const Camera& camera : scene.cameras) {
    if (camera.name == wanted) return camera;
    names += (names.empty() ? "" : ", ") + camera.name;
  }
  if (!name.empty()) {
    throw InputError("--camera " + name +
                     ": no camera of that name; the scene has: " + (names.empty() ? "none" : names));
  }
  return scene.cameras.empty() ? Camera{} : scene.cameras.front();
}

void chooseTechnique(Scene& scene, const std::string& id) {
  if (id.empty()) return;
  if (!parseTechnique(id))
    throw InputError("--technique " + id + ": no such technique; there are: " + techniqueIdList());
  for (Probe& probe : scene.probes) probe.technique = id;
}

}  // namespace boxprobe
