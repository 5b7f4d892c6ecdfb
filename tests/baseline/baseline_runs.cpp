#include "tests/baseline/baseline_runs.h"

#include <utility>

namespace boxprobe::test {

namespace {

using Runs = std::vector<BaselineRun>;
using Rows = std::vector<std::pair<const char*, const char*>>;

/// Values and texts, without OpenGL.
void addPlain(Runs& runs) {
  const Rows rows = {
      {"info-odd", "info odd --json"},
      {"info-inches", "info inches --json"},
      {"info-bare", "info bare --json"},
      {"info-glass", "info glass --json"},
      {"info-mirror-hall", "info mirror-hall --json"},
      {"info-model", "info odd.gltf --json --as interior --light ceiling"},
      {"info-odd-text", "info odd"},
      {"info-mirror-hall-text", "info mirror-hall"},
      {"info-flat-text", "info flat"},
      {"fit-odd", "fit odd --json"},
      {"fit-odd-origin", "fit odd --json --origin propose --yaw keep"},
      {"fit-odd-faces", "fit odd --json --probe a --faces +x,-z --yaw keep"},
      {"fit-turned", "fit odd --json --probe c --set probes.c.rotationDegrees=[0,37,0] --origin propose"},
      {"fit-far", "fit far --json --probe b --origin propose"},
      {"fit-big", "fit big --json --probe a --origin propose"},
      {"fit-small", "fit small --json --probe a --origin propose"},
      {"fit-inches", "fit inches --json"},
      {"fit-building", "fit building --json --origin propose"},
      {"fit-furnished", "fit furnished --json --origin propose"},
      {"fit-windows", "fit windows --json"},
      {"fit-halls", "fit halls --json --origin propose"},
      {"place-halls", "place halls --json"},
      {"place-halls-keep", "place halls --json --keep --gain 0.5 --most 5"},
      {"info-halls-cm", "info halls-cm.gltf --json --as interior --light ceiling"},
      {"info-halls", "info halls.gltf --json --as interior --light openings"},
      {"place-lintel", "place halls --json --set objects.lintel.translation=[0,0.72,0]"},
      {"place-halls-cm", "place halls-cm --json"},
      {"place-odd", "place odd --json --gain 0.7"},
      {"place-halls-angles", "place halls --json --unchecked"},
      {"place-odd-angles", "place odd --json --unchecked --gain 0.7"},
      {"place-windows-angles", "place windows --json --unchecked"},
      {"place-furnished", "place furnished --json --gain 0.1 --most 6"},
      {"place-windows", "place windows --json"},
      {"bake-list", "bake odd --list"},
      {"bake-parallel", "bake odd --emit parallel --shards 3"},
      {"bake-slurm", "bake building --emit slurm --shards 2"},
      {"bake-make", "bake odd --emit make"},
  };
  for (const auto& [name, command] : rows) runs.push_back({name, command, "", false});
  // Scene files that are written.
  runs.push_back({"fit-written", "fit odd --origin propose", "fitted.boxprobe.json", false});
  runs.push_back({"place-written", "place halls --keep", "placed.boxprobe.json", false});
  const Rows references = {
      {"reference-scene", "render odd --technique reference-scene --rays 24"},
      {"reference-scene-full", "render odd --technique reference-scene --rays 8 --camera low --full"},
      {"reference-path", "render odd --technique reference-path --rays 16 --bounces 3"},
      {"reference-path-windows", "render windows --technique reference-path --rays 8 --bounces all"},
  };
  for (const auto& [name, command] : references) runs.push_back({name, command, "picture.exr", false});
  // Compared as what is drawn: on another machine a ray that meets an edge may go elsewhere.
  const Rows traced = {
      {"reference-path-low", "render odd --camera low --technique reference-path --rays 8 --bounces 2"},
      {"reference-path-glass", "render glass --camera ball --technique reference-path --rays 8 --bounces 4"},
      {"reference-path-flat", "render flat --camera doorway --technique reference-path --rays 8 --bounces 2"},
      {"reference-scene-glass", "render glass --camera prism --technique reference-scene --rays 8"},
      {"reference-path-mirrors", "render mirror-hall --camera floor --technique reference-path --rays 8 --bounces 4"},
  };
  for (const auto& [name, command] : traced) runs.push_back({name, command, "picture.exr", true});
}

/// Techniques in the odd room: every pixel is lit by three probes and the sky.
void addTechniques(Runs& runs) {
  for (const char* technique : {"normal",
                                "infinite",
                                "sphere",
                                "box",
                                "impostor",
                                "approximate",
                                "hdrp",
                                "godot",
                                "sphere+hdrp",
                                "sphere+godot",
                                "infinite+footprint4",
                                "footprint1",
                                "footprint2",
                                "footprint4",
                                "footprint8",
                                "footprint16",
                                "sphere+footprint4",
                                "impostor+approximate",

                                "raytraced",
                                "auto",
                                "reference-box"}) {
    const std::string fewer = std::string(technique) == "reference-box" ? " --rays 24" : "";
    runs.push_back({technique, "render plain --technique " + std::string(technique) + fewer, "picture.exr", true});
  }
  const Rows rows = {
      {"curve-unity", "box probes.c.parameters.curve=\"unity\""},
      {"curve-linear", "box probes.c.parameters.curve=\"linear\""},
      {"curve-exact", "box probes.c.parameters.curve=\"exact\""},
      {"curve-marmoset", "box probes.c.parameters.curve=\"marmoset\""},
      {"curve-three-level", "box probes.c.parameters.curve=\"three-level\""},
      {"approximate-power", "approximate probes.c.parameters={\"power\":2.3,\"hardeningLength\":1.7}"},
      {"approximate-surface", "approximate probes.c.parameters.fresnel=\"surface\""},
      {"impostor-1", "impostor probes.c.parameters.steps=1"},
      {"impostor-8", "impostor probes.c.parameters.steps=8"},
      {"raytraced-white", "raytraced probes.c.parameters={\"pattern\":\"white\",\"samples\":7}"},
      {"raytraced-r2", "raytraced probes.c.parameters={\"pattern\":\"r2\",\"samples\":9,\"levelOffset\":true}"},
      {"raytraced-filtered",
       "raytraced probes.c.parameters={\"pattern\":\"deterministic\",\"samples\":5,\"filtered\":true}"},
      {"raytraced-luminance", "raytraced probes.c.parameters={\"sampling\":\"luminance\",\"samples\":11}"},
      {"raytraced-blur", "raytraced probes.c.parameters={\"samples\":3,\"blur\":true}"},
      {"auto-budget", "auto probes.c.parameters.budget=0.011"},
  };
  for (const auto& [name, what] : rows) {
    const std::string text = what;
    const std::size_t blank = text.find(' ');
    runs.push_back({name,
                    "render plain --set materials.floor.roughness=0.34 --technique " + text.substr(0, blank) +
                        " --set " + text.substr(blank + 1),
                    "picture.exr", true});
  }
  runs.push_back({"raytraced-animated",
                  "render plain --frames 3 --technique raytraced --set "
                  "probes.c.parameters={\"animated\":true,\"samples\":4}",
                  "picture.exr", true});
}

/// Fields of the scene.
void addFields(Runs& runs) {
  const Rows rows = {
      {"low", "odd --camera low"},
      {"parallel", "plain --camera level"},
      {"parallel-big", "big --camera level"},
      {"far", "far"},
      {"big", "big"},
      {"small", "small"},
      {"inches", "inches"},
      {"bare", "bare"},
      {"one-sample", "plain --samples 1"},
      {"sixteen-samples", "odd --samples 16 --camera low"},
      {"no-probes", "odd --probes off"},
      {"turned", "plain --set probes.a.rotationDegrees=[7,-19,4] --set probes.c.rotationDegrees=[-11,29,17]"},
      {"footprint8-turned", "plain --technique footprint8 --set probes.c.rotationDegrees=[-11,29,17] --camera low"},
      {"impostor-turned", "plain --technique impostor --set probes.c.rotationDegrees=[-11,29,17] --camera low"},
      {"bevel", "plain --set probes.c.bevel={\"radius\":0.43,\"fromRoughness\":0.37} --set probes.a.bevel=0.27"},
      {"bevel-footprint4", "plain --technique footprint4 --set probes.c.bevel=0.43 --set probes.a.bevel=0.27"},
      {"occlusion", "plain --set probes.c.occlusion={\"multiplier\":0.61,\"power\":0.7,\"strength\":0.83}"},
      {"occlusion-footprint8",
       "plain --technique footprint8 --set probes.c.occlusion={\"multiplier\":0.61,\"power\":0.7}"},
      {"open", "windows --set probes.room.faceSize=64 --set sky.rotationDegrees=37"},
      {"open-floor", "windows --set probes.room.faceSize=32 --camera floor --technique footprint4"},
      {"clear-none", "windows --set probes.room.faceSize=32 --set probes.room.clear=\"none\""},
      {"sky-image", "plain --set sky={\"image\":\"SKY\",\"rotationDegrees\":71} --set probes.c.intensity=0.21"},
      {"sky-turned", "plain --set sky={\"image\":\"SKY\",\"rotationDegrees\":-109} --set probes=[]"},
      {"clear-colour", "plain --set probes.c.clear=[0.7,0.2,0.4] --set probes.c.far=1.9"},
      {"custom", "plain --set probes.c.mode=\"custom\" --set probes.c.image=\"SKY\""},
      {"realtime", "plain --set probes.c.mode=\"realtime\" --set probes.a.mode=\"realtime\""},
      {"gaussian", "plain --set probes.c.filter=\"gaussian\" --set probes.a.filter=\"gaussian\""},
      {"few-samples", "plain --set probes.c.filterSamples=8 --set probes.a.samplesPerPixel=1"},
      {"not-projected", "plain --set probes.c.projection=false --set probes.a.projection=false"},
      {"equal-ranks", "plain --set probes.c.importance=1 --set probes.b.intensity=0.4"},
      {"mode-off", "plain --set objects.floor.probeMode=\"off\" --set objects.pillar.probeMode=\"simple\""},
      {"mode-blend", "plain --set objects.floor.probeMode=\"blend\" --set objects.north.probeMode=\"simple\""},
      {"by-object", "plain --set objects.floor.weights=\"object\" --set objects.pillar.weights=\"object\""},
      {"moved", "plain --set objects.cushion.translation=[0.3,0.4,0.5] --set objects.pillar.rotationDegrees=[5,31,-8]"},
      {"hidden", "odd --set objects.north.visible=false --set objects.cushion.seenByProbes=false"},
      {"multiple", "odd --set energy=\"multiple\""},
      {"multiple-approximate", "plain --set energy=\"multiple\" --technique approximate --camera low"},
      {"shadows", "windows --set probes.room.faceSize=32 --camera top"},
      {"shadows-lamp",
       "windows --set probes.room.faceSize=32 --camera top --set "
       "lights=[{\"type\":\"point\",\"position\":[7.1,4.2,0.8],"
       "\"intensity\":90,\"range\":30,\"radius\":0.4,\"shadows\":\"coverage+map\"}]"},
      {"shadows-spot",
       "windows --set probes.room.faceSize=32 --camera top --set lights=[{\"type\":\"spot\",\"position\":[7.1,4.2,0.8],"
       "\"direction\":[-0.9,-0.5,-0.1],\"intensity\":120,\"outerConeDegrees\":33,\"shadows\":\"coverage\","
       "\"shadowLevel\":\"distance\",\"levelsPerUnit\":0.3}]"},
      {"one-pass", "odd --set materials.glass.glass=\"one-pass\" --set materials.drop.glass=\"one-pass\""},
      {"two-pass", "odd --set materials.glass.glass=\"two-pass\" --set materials.drop.glass=\"two-pass\""},
      {"two-interface",
       "odd --set materials.glass.glass=\"two-interface\" --set materials.drop.glass=\"two-interface\""},
      {"thin", "odd --set materials.glass.thin=true --set materials.glass.roughness=0.23"},
      {"frosted", "odd --set materials.glass.roughness=0.31 --set materials.drop.roughness=0.17"},
      {"dense", "odd --set materials.drop.ior=0.83 --set materials.glass.attenuationDistance=0.21 --camera low"},
      {"glass-ball", "glass --camera ball"},
      {"glass-block", "glass --camera block"},
      {"glass-prism", "glass --camera prism"},
      {"glass-cup", "glass --camera cup"},
      {"glass-ring", "glass --camera ring"},
      {"glass-within", "glass --camera insideX20ball"},
      {"mirrors", "mirror-hall --set objects.figure.translation=[0.7,0,1.9] --set probes.hall.faceSize=64"},
      {"mirrors-floor", "mirror-hall --camera floor --set mirrors.floor.resolution=0.6 --set probes.hall.faceSize=64"},
      {"mirrors-parallel",
       "mirror-hall --camera parallel --set materials.floor.roughness=0.21 --set probes.hall.faceSize=64"},
      {"mirrors-odd",
       "odd --camera low --set objects.mover.translation=[-0.9,0.3,-0.4] --set materials.silver.roughness=0.11"},
      {"building", "building --set probes.room.faceSize=64"},
      {"building-corner", "building --camera corner --technique impostor --set probes.room.faceSize=64"},
      {"flat",
       "flat --set probes.living.faceSize=32 --set probes.kitchen.faceSize=32 --set probes.living.bounces=1 --set "
       "probes.kitchen.bounces=1 --camera doorway"},
      {"gallery", "gallery --technique footprint8 --set probes.gallery.faceSize=64"},
      {"furnished", "furnished --technique impostor+footprint4 --set probes.room.faceSize=64"},
      {"impostor-24",
       "furnished --technique impostor --set probes.room.parameters.steps=24 --set probes.room.faceSize=64"},
      {"impostor-footprint8", "furnished --technique impostor+footprint8 --camera low --set probes.room.faceSize=64"},
      {"impostor-raytraced",
       "furnished --technique impostor+raytraced --camera steep --set probes.room.faceSize=64 --set "
       "probes.room.parameters={\"samples\":5,\"filtered\":true} --set materials.floor.roughness=0.2"},
      {"reveal", "building --camera low --technique impostor --set probes.room.faceSize=64"},
      {"reveal-top", "building --camera top --technique impostor --set probes.room.faceSize=64"},
      {"finish-blurred",
       "finish --technique raytraced --set materials.floor.roughness=0.61 --set "
       "probes.a.parameters={\"samples\":3,\"blur\":true}"},
      {"room", "room --technique hdrp --set materials.floor.roughness=0.27 --set probes.room.faceSize=64"},
      {"six-faces", "six-faces --set probes.cube.faceSize=64"},
      {"materials",
       "odd --set materials.floor.baseColor=[0.3,0.5,0.8] --set materials.north.roughness=0.55 --set "
       "materials.coated.normalScale=1.9 --set materials.east.emissive=[0.1,0.9,0.3] --set materials.toy.coat=0.6"},
      {"finish",
       "odd --set materials.south.metallic=0.35 --set materials.film.roughness=0.42 --set "
       "materials.cloth.roughness=0.29 "
       "--camera low"},
  };
  for (const auto& [name, what] : rows) {
    runs.push_back({name, "render " + std::string(what), "picture.exr", true});
  }
  for (const auto& [name, what] : Rows{{"display", "odd --set exposure=1.63"},
                                       {"display-views", "plain --view all --technique impostor"},
                                       {"display-view", "building --view weights --set probes.room.faceSize=32"}}) {
    runs.push_back({name, "render " + std::string(what), "picture.png", true});
  }
  for (const char* view : {"hit-distance", "true-distance", "hit-error", "direction-error", "level", "roughness",
                           "direction", "weights", "face", "lookups", "diffuse-light", "node-validity"}) {
    runs.push_back({std::string("view-") + view, "render plain --technique footprint4 --view " + std::string(view),
                    "picture.exr", true});
  }
}

/// Explanations, bakes, exports, reports of frames.
void addReports(Runs& runs) {
  const Rows rows = {
      {"explain-box", "explain odd --json --pixel 21,20"},
      {"explain-footprint8", "explain plain --json --pixel 30,22 --technique footprint8"},
      {"explain-impostor", "explain plain --json --pixel 17,23 --technique impostor"},
      {"explain-hdrp", "explain plain --json --pixel 33,19 --technique hdrp"},
      {"explain-glass", "explain odd --json --pixel 26,12 --camera low"},
      {"explain-coat", "explain odd --json --pixel 15,12"},
      {"explain-mirror", "explain mirror-hall --json --pixel 24,13 --set probes.hall.faceSize=32"},
      {"explain-windows", "explain windows --json --pixel 25,20 --technique footprint4 --set probes.room.faceSize=32"},
      {"explain-box-text", "explain odd --pixel 21,20"},
      {"explain-glass-text", "explain odd --pixel 26,12 --camera low"},
      {"explain-mirror-text", "explain mirror-hall --pixel 24,13 --set probes.hall.faceSize=32"},
      {"frame-odd", "info odd --frame --json --size 48x27"},
      {"frame-mirror-hall", "info mirror-hall --frame --json --size 48x27 --set probes.hall.faceSize=32"},
  };
  for (const auto& [name, command] : rows) {
    const bool sized = std::string(command).find("--size") != std::string::npos;
    runs.push_back({name, std::string(command) + (sized ? "" : " --size 48x27"), "", true});
  }
  runs.push_back({"bake", "bake odd", "maps", true});
  runs.push_back({"bake-big", "bake big --probe c", "maps", true});
  runs.push_back({"bake-open", "bake windows --set probes.room.faceSize=32", "maps", true});
  const Rows exports = {
      {"export-three", "export plain --format ktx2 --ladder three --probe c"},
      {"export-bevy", "export plain --format ktx2 --ladder bevy --probe a"},
      {"export-babylon", "export plain --format dds --ladder babylon --size 64 --center --lossy"},
      {"export-own", "export plain --format exr --probe c"},
      {"export-unity", "export plain --format hdr --ladder unity --probe c"},
      {"export-big", "export big --format hdr --probe b"},
  };
  for (const auto& [name, command] : exports) runs.push_back({name, command, "written", true});
}

}  // namespace

const std::vector<BaselineRun>& baselineRuns() {
  static const Runs all = [] {
    Runs runs;
    addPlain(runs);
    addFields(runs);
    addTechniques(runs);
    addReports(runs);
    return runs;
  }();
  return all;
}

}  // namespace boxprobe::test
