// bench_frame: CPU time of a frame with box-projected reflections over that of stock VTK with image-based lighting,
// (or, with --probes off, of a frame without either), drawn in turn in one process and window. CPU time of all threads:
// software OpenGL draws in this process.
#include <vtkOpenGLRenderer.h>
#include <vtkUnsignedCharArray.h>

#include <algorithm>
#include <cstdio>
#include <string>

#include "app/cli/options/render_options.h"
#include "filters/core/base/errors.h"
#include "filters/io/image/image_file.h"
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
};

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

void run(const CLI::App& program, const BenchOptions& options) {
  LoadedScene loaded = loadScene(options.scene);
  chooseTechnique(loaded.scene, options.technique);
  const SkyGradient* sky = std::get_if<SkyGradient>(&loaded.scene.sky);
  if (sky == nullptr) throw InputError(options.scene + ": sky: this benchmark wants a gradient");
  OffscreenScene ours(windowSettings(program, options));
  bench::prepare(ours, loaded.scene, loaded.models);
  const auto stock = bench::makeStockRenderer(ours.renderer().renderer(), *sky);
  const bool off = options.probes == "off";
  if (off) {
    ours.renderer().setProbesEnabled(false);
    stock->UseImageBasedLightingOff();
  }
  ours.window()->AddRenderer(stock);
  const auto frame = [&](bool drawOurs) {
    ours.setDrawn(drawOurs);
    stock->SetDraw(drawOurs ? 0 : 1);
    return ours.timedFrame();
  };
  for (const bool drawOurs : {true, false, true, false}) frame(drawOurs);  // compiles, filters the environment
  if (!options.pictures.empty()) savePictures(options.pictures, ours, frame);
  const bench::Comparison result = bench::compare(
      0, options.frames, [&] { return frame(true); }, [&] { return frame(false); });
  ours.requireHealthy();
  bench::printHeader(options, ours);
  print(off ? "probes off" : options.technique, result.first, result.samples.a);
  print(off ? "stock, lights only" : "stock image-based lighting", result.second, result.samples.b);
  std::printf("  %s\n", result.ratioText().c_str());
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
  program.add_option("--pictures", options.pictures, "Folder for ours.png and stock.png, to look at");
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
