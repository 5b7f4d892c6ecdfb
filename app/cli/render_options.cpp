// See render_options.h.
#include "app/cli/render_options.h"

#include <cstdio>

#include "filters/core/errors.h"
#include "filters/math/technique_table.h"

namespace boxprobe {

void addRenderOptions(CLI::App& command, RenderOptions& options) {
  command.add_option("SCENE", options.scenePath, "Scene file (.boxprobe.json) or bare model (.glb, .gltf)")->required();
  command.add_option("-o,--output", options.outputPath, "Picture: .png (display colours) or .exr (linear, float RGBA)")
      ->type_name("FILE")
      ->required();
  command.add_option("--size", options.size, "Width and height in pixels (default 1280x720)")->type_name("WxH");
  command.add_option("--camera", options.camera, "Camera of the scene (default: main, else the first)")
      ->type_name("NAME");
  command
      .add_option("--technique", options.technique,
                  "Technique of every probe (default: as in the scene): " + techniqueIdList())
      ->type_name("ID");
  command.add_option("--samples", options.samples, "Samples a pixel: 1, 4 or 16 (default 4)")
      ->check(CLI::IsMember({1, 4, 16}).description(""))
      ->type_name("N");
  command.add_option("--probes", options.probes, "off: no reflections of probes or sky, VTK's plain program")
      ->check(CLI::IsMember({"on", "off"}).description(""))
      ->type_name("on|off");
  command.add_option("--frames", options.frames, "Then draw N more frames and report their CPU time in --stats")
      ->check(CLI::Range(0, 100000).description(""))
      ->type_name("N");
  command.add_option("--set", options.assignments, "Change a field of the scene: probes.NAME.FIELD=VALUE (repeatable)")
      ->type_name("FIELD=VALUE")
      ->allow_extra_args(false);
  addReportOptions(command, options.report, "Print what --stats writes");
  command.footer(
      "Examples:\n"
      "  boxprobe render data/scenes/building.boxprobe.json -o building.png --size 1920x1080\n"
      "  boxprobe render data/scenes/room.boxprobe.json -o room.exr --technique infinite --set "
      "materials.floor.roughness=0.25");
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
