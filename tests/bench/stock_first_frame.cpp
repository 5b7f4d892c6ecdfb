// CPU time from process start to the first frame that stock VTK draws of `building` with image-based lighting from a
// 256² cube at VTK's defaults: what tests/bench/first_frame.sh and tests/bench/peers compare with. Prints seconds; with
// --filter-time, also those that filtering the environment took.
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRIrradianceTexture.h>
#include <vtkPBRPrefilterTexture.h>

#include <cstdio>
#include <variant>

#include "filters/vtk/gl/cpu_time.h"
#include "tests/bench/harness.h"
#include "tests/bench/stock_renderer.h"

namespace {

using namespace boxprobe;

struct FirstFrameOptions : bench::FrameOptions {
  int irradiance = bench::kVtkIrradianceSize;
  bool filterTime = false;
};

/// CPU seconds to filter the environment once more, as the first frame did.
double filterSeconds(vtkOpenGLRenderer* stock, vtkRenderWindow* window) {
  double seconds = 0.0;
  {
    const CpuTimer timer(seconds);
    stock->GetEnvMapIrradiance()->Modified();
    stock->GetEnvMapPrefiltered()->Modified();
    stock->GetEnvMapIrradiance()->Load(stock);
    stock->GetEnvMapPrefiltered()->Load(stock);
    window->WaitForCompletion();
  }
  return seconds;
}

void run(const CLI::App& program, const FirstFrameOptions& options) {
  const LoadedScene loaded = loadScene(options.scene);
  OffscreenScene ours(windowSettings(program, options));
  ours.show(loaded.scene, loaded.models, {loaded.scene.cameras.front()});  // captures nothing
  const auto* sky = std::get_if<SkyGradient>(&loaded.scene.sky);
  const auto stock = bench::makeStockRenderer(
      ours.renderer().renderer(), bench::gradientSky(sky != nullptr ? *sky : SkyGradient{}), options.irradiance);
  ours.window()->RemoveRenderer(ours.renderer().renderer());
  ours.window()->AddRenderer(stock);
  ours.timedFrame();
  std::printf("%.3f\n", processCpuSeconds());
  if (options.filterTime) std::printf("%.3f\n", filterSeconds(stock, ours.window()));
  ours.window()->RemoveRenderer(stock);
  ours.window()->AddRenderer(ours.renderer().renderer());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU seconds to stock VTK's first frame", "bench_stock_first_frame");
  FirstFrameOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  program.add_option("--size", options.size, "Pixels")->capture_default_str();
  program.add_option("--samples", options.samples, "Samples per pixel")->capture_default_str();
  program.add_option("--irradiance", options.irradiance, "Texels along a face of VTK's irradiance map")
      ->check(CLI::Range(1, 4096))
      ->capture_default_str();
  program.add_flag("--filter-time", options.filterTime, "Also print the CPU seconds of filtering the environment");
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
