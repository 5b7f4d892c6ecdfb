// CPU time from process start to the first frame that stock VTK draws of `building` with image-based lighting from a
// 256² cube at VTK's defaults: what tests/bench/first_frame.sh compares with. Prints seconds.
#include <vtkOpenGLRenderWindow.h>
#include <vtkOpenGLRenderer.h>

#include <cstdio>
#include <variant>

#include "app/session/load_scene.h"
#include "app/session/offscreen_window.h"
#include "filters/core/base/errors.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/scene_renderer.h"
#include "tests/bench/stock_renderer.h"

int main(int argc, char** argv) {
  using namespace boxprobe;
  try {
    LoadedScene loaded = loadScene(argc > 1 ? argv[1] : BOXPROBE_DATA_DIR "/scenes/building.boxprobe.json");
    const auto window = makeOffscreenWindow(1280, 720, 4);
    SceneRenderer ours(window);
    ours.setModels(loaded.models);
    ours.sync(loaded.scene, Changes::all());
    ours.applyCamera(loaded.scene.cameras.front());
    const auto* sky = std::get_if<SkyGradient>(&loaded.scene.sky);
    const auto stock =
        bench::makeStockRenderer(ours.renderer(), sky != nullptr ? *sky : SkyGradient{}, bench::kVtkIrradianceSize);
    window->RemoveRenderer(ours.renderer());
    window->AddRenderer(stock);
    window->Render();
    window->WaitForCompletion();
    std::printf("%.3f\n", processCpuSeconds());
    window->RemoveRenderer(stock);
    window->AddRenderer(ours.renderer());
    return 0;
  } catch (const Error& error) {
    std::fprintf(stderr, "stock_first_frame: %s\n", error.what());
    return error.exitStatus();
  }
}
