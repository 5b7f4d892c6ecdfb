// bench_frame: CPU time of a frame with box-projected reflections over that of stock VTK with image-based lighting,
// (or, with --probes off, of a frame without either), drawn in turn in one process and window. CPU time of all threads:
// software OpenGL draws in this process.
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "app/session/display_check.h"
#include "app/session/load_scene.h"
#include "app/session/offscreen_window.h"
#include "app/session/vtk_messages.h"
#include "filters/core/base/errors.h"
#include "filters/io/image/image_file.h"
#include "filters/reference/measure/interleaved.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/bench/exit_status.h"
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

struct BenchOptions {
  std::string scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  std::string size = "1280x720";
  std::string technique = "box";
  int samples = 4;
  int frames = 60;
  std::string pictures;
  std::string probes = "on";
};

void run(const BenchOptions& options) {
  const FrameSize size = parseFrameSize(options.size);
  LoadedScene loaded = loadScene(options.scene);
  chooseTechnique(loaded.scene, options.technique);
  const SkyGradient* sky = std::get_if<SkyGradient>(&loaded.scene.sky);
  if (sky == nullptr) throw InputError(options.scene + ": sky: this benchmark wants a gradient");
  requireDisplay("bench_frame");
  installVtkMessages(false, true);
  const auto window = makeOffscreenWindow(size.width, size.height, options.samples);
  SceneRenderer ours(window);
  ours.setModels(loaded.models);
  ours.sync(loaded.scene, Changes::all());
  ours.applyCamera(chooseCamera(loaded.scene, ""));
  ours.finishWork();
  const auto stock = bench::makeStockRenderer(ours.renderer(), *sky);
  const bool off = options.probes == "off";
  if (off) {
    ours.setProbesEnabled(false);
    stock->UseImageBasedLightingOff();
  }
  window->AddRenderer(stock);

  const auto frame = [&](bool drawOurs) {
    ours.renderer()->SetDraw(drawOurs ? 1 : 0);
    stock->SetDraw(drawOurs ? 0 : 1);
    const double start = processCpuSeconds();
    window->Render();
    window->WaitForCompletion();
    return processCpuSeconds() - start;
  };
  for (const bool drawOurs : {true, false, true, false}) frame(drawOurs);  // compiles, filters the environment
  if (!options.pictures.empty()) {
    frame(true);
    savePng(options.pictures + "/ours.png", windowPicture(window));
    frame(false);
    savePng(options.pictures + "/stock.png", windowPicture(window));
  }
  const bench::Samples samples = bench::interleave(
      options.frames, [&] { return frame(true); }, [&] { return frame(false); });
  if (!ours.error().empty()) throw WorkError(ours.error());
  const bench::Ratio ratio = bench::ratioOfMedians(samples);
  std::printf("%s: %d x %d, %d samples a pixel, %d pairs of frames, CPU milliseconds\n", options.scene.c_str(),
              size.width, size.height, std::max(window->GetMultiSamples(), 1), options.frames);
  std::printf("  %-28s median %8.2f   min %8.2f\n", off ? "probes off" : options.technique.c_str(),
              1e3 * bench::median(samples.a), 1e3 * *std::min_element(samples.a.begin(), samples.a.end()));
  std::printf("  %-28s median %8.2f   min %8.2f\n", off ? "stock, lights only" : "stock image-based lighting",
              1e3 * bench::median(samples.b), 1e3 * *std::min_element(samples.b.begin(), samples.b.end()));
  std::printf("  ratio %.3f, 95 %% interval %.3f to %.3f\n", ratio.value, ratio.low, ratio.high);
  window->RemoveRenderer(stock);
  ours.releaseGraphics();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU time of a frame: box projection over stock VTK image-based lighting", "bench_frame");
  BenchOptions options;
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  program.add_option("--size", options.size, "Pixels")->capture_default_str();
  program.add_option("--technique", options.technique, "Technique of every probe")->capture_default_str();
  program.add_option("--samples", options.samples, "Samples a pixel")->capture_default_str();
  program.add_option("--frames", options.frames, "Pairs of frames")
      ->check(CLI::Range(2, 100000))
      ->capture_default_str();
  program.add_option("--probes", options.probes, "off: without probes and sky, against stock VTK without them")
      ->check(CLI::IsMember({"on", "off"}))
      ->capture_default_str();
  program.add_option("--pictures", options.pictures, "Folder for ours.png and stock.png, to look at");
  CLI11_PARSE(program, argc, argv);
  return exitStatusOf([&] { run(options); });
}
