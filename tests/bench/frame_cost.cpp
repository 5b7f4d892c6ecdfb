// bench_frame: CPU time of a frame with box-projected reflections over that of stock VTK with image-based lighting,
// (or, with --probes off, of a frame without either), or over our own general programs, those without constants, or
// without light over lit; with --tuning, over frames without each part of the tuning for drivers; drawn in turn in one
// process and window. CPU time of all threads: software OpenGL draws in this process.
#include <vtkOpenGLRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "filters/core/base/errors.h"
#include "filters/core/geometry/lamp_sight.h"
#include "filters/core/geometry/probe_diffuse.h"
#include "filters/core/geometry/scene_lamps.h"
#include "filters/io/image/image_file.h"
#include "filters/math/cube/diffuse_lattice.h"
#include "filters/vtk/gl/cpu_time.h"
#include "tests/bench/harness.h"
#include "tests/bench/stock_renderer.h"

namespace {

using namespace boxprobe;

/// What the window shows now, its rows turned to run from the top down.
ImageRgba8 windowPicture(vtkRenderWindow* window) {
  ImageRgba8 image;
  image.width = window->GetSize()[0];
  image.height = window->GetSize()[1];
  vtkNew<vtkUnsignedCharArray> rows;
  window->GetRGBACharPixelData(0, 0, image.width - 1, image.height - 1, 0, rows);
  const std::size_t stride = 4 * static_cast<std::size_t>(image.width);
  for (int y = image.height - 1; y >= 0; --y) {
    const unsigned char* row = rows->GetPointer(0) + static_cast<std::size_t>(y) * stride;
    image.pixels.insert(image.pixels.end(), row, row + stride);
  }
  for (std::size_t i = 3; i < image.pixels.size(); i += 4) image.pixels[i] = 255;
  return image;
}

struct BenchOptions : bench::FrameOptions {
  std::string technique = "box";
  std::string pictures;
  std::string probes = "on";
  std::string against = "stock";
  bool noConstants = false;
  bool drawHidden = false;
  bool tuning = false;
  bool panels = false;
  int lamps = 0;
};

/// Point lights on a circle under the ceiling of what there is, in place of the scene's own.
void placeLamps(Scene& scene, const Box& bounds, int lamps) {
  scene.lights.clear();
  const glm::dvec3 center = bounds.center(), half = 0.3 * bounds.size();
  for (int i = 0; i < lamps; ++i) {
    const double angle = 6.283185307179586 * (i + 0.5) / lamps;
    Light light;
    light.type = LightType::Point;
    light.position = center + glm::dvec3(half.x * std::cos(angle), half.y, half.z * std::sin(angle));
    light.intensity = 5.0f;
    scene.lights.push_back(light);
  }
}

/// Square panels that shine downwards, on a circle under the ceiling, in place of the lamps there are.
Model lampPanels(const Box& bounds, int count) {
  Model model;
  Material shining;
  shining.name = "panel";
  shining.baseColor = {0.0f, 0.0f, 0.0f, 1.0f};
  shining.metallic = 0.0f;
  shining.emissive = glm::vec3(12.0f);
  model.materials.push_back(shining);
  const glm::dvec3 center = bounds.center(), around = 0.3 * bounds.size();
  const double half = 0.02 * std::max(bounds.size().x, bounds.size().z);
  for (int i = 0; i < count; ++i) {
    const double angle = 6.283185307179586 * (i + 0.5) / count;
    const glm::vec3 at(center + glm::dvec3(around.x * std::cos(angle), 1.4 * around.y, around.z * std::sin(angle)));
    const glm::vec3 x(half, 0.0f, 0.0f), z(0.0f, 0.0f, half);
    Mesh mesh;
    mesh.positions = {at - x - z, at + x - z, at + x + z, at - x + z};
    mesh.normals.assign(4, glm::vec3(0.0f, -1.0f, 0.0f));
    mesh.indices = {0, 1, 2, 0, 2, 3};
    mesh.material = 0;
    model.instances.push_back({"panel " + std::to_string(i), i, glm::dmat4(1.0)});
    model.meshes.push_back(std::move(mesh));
  }
  return model;
}

OffscreenScene::Models unlit(const OffscreenScene::Models& models) {
  OffscreenScene::Models all;
  for (const auto& model : models) {
    auto copy = std::make_shared<Model>(*model);
    for (Material& material : copy->materials) material.unlit = true;
    all.push_back(std::move(copy));
  }
  return all;
}

void savePictures(const std::string& folder, OffscreenScene& ours, const std::function<double(bool)>& frame) {
  frame(true);
  savePng(folder + "/ours.png", windowPicture(ours.window()));
  frame(false);
  savePng(folder + "/stock.png", windowPicture(ours.window()));
}

void print(const std::string& what, double milliseconds, const std::vector<double>& seconds) {
  std::printf("  %-28s median %8.2f   min %8.2f\n", what.c_str(), milliseconds,
              1e3 * *std::min_element(seconds.begin(), seconds.end()));
}

void compareAndPrint(const BenchOptions& options, OffscreenScene& ours, const std::string& first,
                     const std::string& second, const std::function<double(bool)>& frame) {
  for (const bool drawFirst : {true, false, true, false}) frame(drawFirst);  // compiles, filters the environment
  if (!options.pictures.empty()) savePictures(options.pictures, ours, frame);
  const bench::Comparison result = bench::compare(
      0, options.frames, [&] { return frame(true); }, [&] { return frame(false); });
  ours.requireHealthy();
  bench::printHeader(options, ours);
  print(first, result.first, result.samples.a);
  print(second, result.second, result.samples.b);
  std::printf("  %s\n", result.ratioText().c_str());
}

/// As OffscreenScene::rest(), and how long a window would not answer meanwhile.
void restAndPrint(OffscreenScene& scene) {
  SceneRenderer& renderer = scene.renderer();
  scene.window()->MakeCurrent();
  const std::uint64_t programs = renderer.counters().programsCompiled;
  renderer.specializePrograms();
  double longest = 0.0;
  while (renderer.workPending()) {
    const double start = processCpuSeconds();
    renderer.step();
    longest = std::max(longest, processCpuSeconds() - start);
  }
  std::printf("constants: %d programs compiled, the longest step took %.0f ms\n",
              static_cast<int>(renderer.counters().programsCompiled - programs), 1e3 * longest);
}

/// Ours against ourselves: general programs, those without constants, or the lit scene where `ours` has no light.
void runAgainstOurs(const CLI::App& program, const BenchOptions& options, const LoadedScene& loaded) {
  const bool lit = options.against == "lit", general = options.against == "general";
  OffscreenScene ours(windowSettings(program, options));
  bench::prepare(ours, loaded.scene, lit ? unlit(loaded.models) : loaded.models);
  OffscreenScene other{vtkSmartPointer<vtkOpenGLRenderWindow>(ours.window())};
  other.renderer().useGeneralPrograms(general);
  bench::prepare(other, loaded.scene, loaded.models);
  if (!options.noConstants) restAndPrint(ours);
  if (!options.noConstants && lit) other.rest();
  const char* second = lit ? "as the scene is" : general ? "general programs" : "numbers as uniforms";
  compareAndPrint(options, ours, lit ? "no surface lit" : "programs for what is there", second, [&](bool first) {
    bench::drawOnly(first ? ours : other, {&ours, &other});
    return ours.timedFrame();
  });
}

/// What a scene's captures take, programs compiled anew.
double captureSeconds(const CLI::App& program, const BenchOptions& options, const LoadedScene& loaded,
                      TuningParts parts) {
  OffscreenScene captured(windowSettings(program, options));
  captured.renderer().tune(parts);
  const double start = processCpuSeconds();
  bench::prepare(captured, loaded.scene, loaded.models);
  return processCpuSeconds() - start;
}

/// What each part of the tuning for drivers gains: with all of it over without the part, as rows of a table.
void printTuning(const CLI::App& program, const BenchOptions& options, const LoadedScene& loaded) {
  const auto row = [](const char* name, const bench::Comparison& result) {
    std::printf("| %s | %.2f (%.2f to %.2f) |\n", name, result.ratio.value, result.ratio.low, result.ratio.high);
    std::fflush(stdout);
  };
  const std::pair<const char*, TuningParts> frames[] = {{"material's facts", kTunedFacts},
                                                        {"constants at rest, flat maps with them", kTunedConstants},
                                                        {"flat maps alone", kTunedFlatMaps},
                                                        {"what a view at rest hides", kTunedHidden},
                                                        {"all of it", kAllTuning}};
  OffscreenScene tuned(windowSettings(program, options));
  bench::prepare(tuned, loaded.scene, loaded.models);
  tuned.rest();
  bench::printHeader(options, tuned);
  std::printf("| part | time with it over without |\n|---|---|\n");
  for (const auto& [name, part] : frames) {
    OffscreenScene without{vtkSmartPointer<vtkOpenGLRenderWindow>(tuned.window())};
    without.renderer().tune(kAllTuning & ~part);
    bench::prepare(without, loaded.scene, loaded.models);
    without.rest();
    const auto frame = [&](bool all) {
      bench::drawOnly(all ? tuned : without, {&tuned, &without});
      return tuned.timedFrame();
    };
    row(name, bench::compare(
                  3, options.frames, [&] { return frame(true); }, [&] { return frame(false); }));
    tuned.requireHealthy();
    without.requireHealthy();
  }
  constexpr int kCaptures = 5;  // pairs
  row("first captures without lookups",
      bench::compare(
          1, kCaptures, [&] { return captureSeconds(program, options, loaded, kAllTuning); },
          [&] { return captureSeconds(program, options, loaded, kAllTuning & ~kTunedFirstBounce); }));
}

/// A picture's texels are taken as they are: only the time is of interest.
bench::StockSky stockSky(const Scene& scene) {
  if (const auto* color = std::get_if<SkyColor>(&scene.sky)) {
    return bench::gradientSky({color->color, color->color, color->color});
  }
  if (const auto* gradient = std::get_if<SkyGradient>(&scene.sky)) return bench::gradientSky(*gradient);
  return [picture = loadSkyImage(scene)](const glm::vec3& direction) {
    const double across = 0.5 - std::atan2(direction.x, direction.z) / 6.283185307179586;
    const double down = 0.5 - std::asin(std::clamp(direction.y, -1.0f, 1.0f)) / 3.141592653589793;
    const int column = std::clamp(static_cast<int>(across * picture->width), 0, picture->width - 1);
    const int row = std::clamp(static_cast<int>(down * picture->height), 0, picture->height - 1);
    const float* texel =
        &picture->pixels[4 * (static_cast<std::size_t>(row) * static_cast<std::size_t>(picture->width) +
                              static_cast<std::size_t>(column))];
    return glm::vec3(texel[0], texel[1], texel[2]);
  };
}

/// Kilobytes of graphics memory, a mean over the probes.
struct MemoryPerProbe {
  double maps = 0.0;      ///< filtered chains, with those without lamps, and distances
  double lattices = 0.0;  ///< of diffuse light, in half floats, and of the lamps' visibilities
};

MemoryPerProbe memoryPerProbe(const SceneRenderer& renderer) {
  constexpr double kTexelBytes = 8.0;  // four half floats
  MemoryPerProbe sum;
  for (const auto& probe : renderer.probesDiffuse().probes) {
    if (!probe) continue;
    if (probe->lattice) {
      sum.lattices += kTexelBytes * static_cast<double>(probe->lattice->texels.size() + probe->lattice->cuts.size());
    }
    if (probe->sight) sum.lattices += static_cast<double>(probe->sight->lattice.texels.size());
  }
  const FrameReport report = renderer.frameReport();
  for (const FrameReport::ProbeUse& probe : report.probes) sum.maps += static_cast<double>(probe.bytes);
  const double toMean = 1e-3 / static_cast<double>(std::max<std::size_t>(report.probes.size(), 1));
  return {sum.maps * toMean, sum.lattices * toMean};
}

/// What lamps drawn as shapes cost: a frame with none, one, four and eight of them over stock VTK's, a row each as it
/// is known. Compiling takes longer than the frames: the driver compiles the lamps' programs for a minute.
void printPanels(const CLI::App& program, const BenchOptions& options, const LoadedScene& loaded) {
  OffscreenScene measured(windowSettings(program, options));
  measured.show(loaded.scene, loaded.models);
  const Box bounds = measured.renderer().bounds();
  bench::printHeader(options, measured);
  std::printf(
      "| lamps | maps, kB a probe | lattices, kB a probe | ours | stock | over stock |\n|---|---|---|---|---|---|\n");
  for (const int count : {0, 1, 4, 8}) {
    std::fflush(stdout);
    LoadedScene lit = loaded;
    lit.scene.lamps = LampForm::Shapes;
    for (const SceneLamp& lamp : sceneLamps(lit.scene, lit.models).lamps) {
      lit.scene.materials[lamp.material].emissive = glm::vec3(0.0f);
    }
    if (count > 0) {
      lit.scene.models.emplace_back();
      lit.scene.models.back().file = "panels.glb";
      lit.models.push_back(std::make_shared<const Model>(lampPanels(bounds, count)));
    }
    OffscreenScene ours(windowSettings(program, options));
    ours.renderer().drawHidden(options.drawHidden);
    bench::prepare(ours, lit.scene, lit.models);
    const auto stock = bench::makeStockRenderer(ours.renderer().renderer(), stockSky(lit.scene));
    if (!options.noConstants) ours.rest();
    ours.window()->AddRenderer(stock);
    const auto frame = [&](bool drawOurs) {
      ours.setDrawn(drawOurs);
      stock->SetDraw(drawOurs ? 0 : 1);
      return ours.timedFrame();
    };
    const bench::Comparison result = bench::compare(
        2, options.frames, [&] { return frame(true); }, [&] { return frame(false); });
    ours.requireHealthy();
    const MemoryPerProbe memory = memoryPerProbe(ours.renderer());
    std::printf("| %d | %.0f | %.0f | %.1f | %.1f | %.3f (%.3f to %.3f) |\n", count, memory.maps, memory.lattices,
                result.first, result.second, result.ratio.value, result.ratio.low, result.ratio.high);
    ours.window()->RemoveRenderer(stock);
  }
}

void run(const CLI::App& program, const BenchOptions& options) {
  LoadedScene loaded = loadScene(options.scene);
  chooseTechnique(loaded.scene, options.technique);
  if (options.lamps > 0) {
    OffscreenScene measured(windowSettings(program, options));
    measured.show(loaded.scene, loaded.models);
    placeLamps(loaded.scene, measured.renderer().bounds(), options.lamps);
  }
  if (options.tuning) {
    printTuning(program, options, loaded);
    return;
  }
  if (options.panels) {
    printPanels(program, options, loaded);
    return;
  }
  if (options.against != "stock") {
    runAgainstOurs(program, options, loaded);
    return;
  }
  const bench::StockSky sky = stockSky(loaded.scene);
  OffscreenScene ours(windowSettings(program, options));
  ours.renderer().drawHidden(options.drawHidden);
  bench::prepare(ours, loaded.scene, loaded.models);
  const auto stock = bench::makeStockRenderer(ours.renderer().renderer(), sky);
  const bool off = options.probes == "off";
  if (off) {
    ours.renderer().setProbesEnabled(false);
    stock->UseImageBasedLightingOff();
  }
  if (!options.noConstants) restAndPrint(ours);
  ours.window()->AddRenderer(stock);
  const auto frame = [&](bool drawOurs) {
    ours.setDrawn(drawOurs);
    stock->SetDraw(drawOurs ? 0 : 1);
    return ours.timedFrame();
  };
  compareAndPrint(options, ours, off ? "probes off" : options.technique,
                  off ? "stock, lights only" : "stock image-based lighting", frame);
  ours.window()->RemoveRenderer(stock);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame: box projection over stock VTK image-based lighting", "bench_frame");
  BenchOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  options.frames = 60;
  addFrameOptions(program, options);
  program.add_option("--technique", options.technique, "Technique of every probe")->capture_default_str();
  program.add_option("--probes", options.probes, "off: without probes and sky, against stock VTK without them")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  program
      .add_option("--against", options.against,
                  "general: our own programs without facts or constants; uniforms: those without constants; lit: no "
                  "surface lit, against the same scene as it is")
      ->check(CLI::IsMember({"stock", "general", "uniforms", "lit"}))
      ->capture_default_str();
  program.add_flag("--draw-hidden", options.drawHidden, "Frames draw what nothing shows of, too, as after each move");
  program.add_flag("--tuning", options.tuning, "What each part of the tuning for drivers gains, as a table");
  program.add_flag("--no-constants", options.noConstants, "Numbers of probes and materials stay uniforms");
  program.add_option("--lamps", options.lamps, "That many point lights in place of the scene's lights");
  program.add_flag("--panels", options.panels, "With 0, 1, 4 and 8 lamps as shapes in place of the scene's lamps");
  program.add_option("--pictures", options.pictures, "Folder for ours.png and stock.png, to look at");
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
