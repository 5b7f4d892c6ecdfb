// CPU time from process start to the first frame that stock VTK draws of `building` with image-based lighting from a
// 256² cube at VTK's defaults: what tests/bench/first_frame.sh compares with. Prints seconds.
#include <vtkOpenGLRenderer.h>

#include <cstdio>
#include <variant>

#include "filters/vtk/gl/cpu_time.h"
#include "tests/bench/harness.h"
#include "tests/bench/stock_renderer.h"

namespace {

using namespace boxprobe;

void run(const CLI::App& program, const bench::FrameOptions& options) {
  const LoadedScene loaded = loadScene(options.scene);
  OffscreenScene ours(windowSettings(program, options));
  ours.show(loaded.scene, loaded.models, {loaded.scene.cameras.front()});  // captures nothing
  const auto* sky = std::get_if<SkyGradient>(&loaded.scene.sky);
  const auto stock = bench::makeStockRenderer(ours.renderer().renderer(), sky != nullptr ? *sky : SkyGradient{},
                                              bench::kVtkIrradianceSize);
  ours.window()->RemoveRenderer(ours.renderer().renderer());
  ours.window()->AddRenderer(stock);
  ours.timedFrame();
  std::printf("%.3f\n", processCpuSeconds());
  ours.window()->RemoveRenderer(stock);
  ours.window()->AddRenderer(ours.renderer().renderer());
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("CPU seconds to stock VTK's first frame", "bench_stock_first_frame");
  bench::FrameOptions options;
  options.scene = BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json";
  program.add_option("SCENE", options.scene, "Scene file")->capture_default_str();
  return bench::runProgram(program, argc, argv, [&] { run(program, options); });
}
