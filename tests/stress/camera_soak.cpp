// camera_soak: draws scenes and models through random cameras and says which frame was the slowest, over the median. A
// camera from which one frame takes minutes has been met before; it lay where nobody had looked. Exit status 1 where a
// frame is slower than asked for.
#include <vtkOpenGLRenderWindow.h>

#include <CLI/CLI.hpp>
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <random>

#include "app/cli/options/render_options.h"
#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/core/geometry/model_placement.h"
#include "filters/io/scene/scene_file.h"

namespace {

using namespace boxprobe;

struct SoakOptions {
  std::vector<std::string> scenes, assignments;
  int cameras = 2000;
  unsigned seed = 1;
  std::string size = "320x180";
  double most = 0.0;
  double leastSeconds = 0.0;
};

/// Cameras about and within what is drawn, a third of them a hair above a vertex, along its surface.
class RandomCameras {
 public:
  RandomCameras(const LoadedScene& loaded, const Box& bounds, unsigned seed)
      : loaded_(loaded), bounds_(bounds), random_(seed) {}

  Camera next() {
    Camera camera;
    camera.name = "soak";
    camera.verticalFovDegrees = 20.0 + 90.0 * share();
    const double reach = glm::length(bounds_.size());
    const int way = static_cast<int>(3.0 * share());
    camera.position = way == 0 ? within(0.0) : way == 1 ? within(1.0) : vertex() + 1e-4 * reach * direction();
    camera.target = share() < 0.5 ? within(0.0) : vertex() + 1e-3 * reach * direction();
    if (glm::length(camera.target - camera.position) < 1e-6 * reach) camera.target = camera.position + direction();
    const glm::dvec3 forward = glm::normalize(camera.target - camera.position);
    if (std::abs(forward.y) > 0.999) camera.up = {1.0, 0.0, 0.0};
    return camera;
  }

 private:
  double share() { return std::uniform_real_distribution<double>(0.0, 1.0)(random_); }
  glm::dvec3 within(double margin) {
    const glm::dvec3 at(share(), share(), share());
    return bounds_.min - margin * bounds_.size() + (1.0 + 2.0 * margin) * at * bounds_.size();
  }
  glm::dvec3 direction() {
    std::normal_distribution<double> bell;
    const glm::dvec3 v(bell(random_), bell(random_), bell(random_));
    return v / std::max(glm::length(v), 1e-9);
  }
  glm::dvec3 vertex() {
    const std::size_t which = random_() % loaded_.models.size();
    const Model& model = *loaded_.models[which];
    if (model.instances.empty()) return within(0.0);
    const Instance& instance = model.instances[random_() % model.instances.size()];
    const auto& positions = model.meshes[static_cast<std::size_t>(instance.mesh)].positions;
    if (positions.empty()) return within(0.0);
    const glm::dvec4 position(glm::dvec3(positions[random_() % positions.size()]), 1.0);
    return glm::dvec3(worldFromFile(loaded_.scene.models[which]) * instance.worldFromModel * position);
  }

  const LoadedScene& loaded_;
  Box bounds_;
  std::mt19937 random_;
};

std::string asAssignments(const Camera& camera) {
  const auto vector = [](const glm::dvec3& v) {
    char text[96];
    std::snprintf(text, sizeof text, "[%.17g,%.17g,%.17g]", v.x, v.y, v.z);
    return std::string(text);
  };
  char angle[32];
  std::snprintf(angle, sizeof angle, "%.17g", camera.verticalFovDegrees);
  std::string text;
  for (const auto& [key, value] : {std::pair<const char*, std::string>{"position", vector(camera.position)},
                                   {"target", vector(camera.target)},
                                   {"up", vector(camera.up)},
                                   {"verticalFovDegrees", angle}}) {
    text += std::string(" --set 'cameras.\"soak\".") + key + "=" + value + "'";
  }
  return text + " --camera soak";
}

/// The slowest frame over the median.
double soak(const std::string& path, const SoakOptions& options) {
  const LoadedScene loaded = loadScene(path, options.assignments);
  const FrameSize size = parseFrameSize(options.size);
  OffscreenScene shown({"camera_soak", size.width, size.height, 1, true});
  ShownSettings settings{loaded.scene.cameras.empty() ? Camera{} : loaded.scene.cameras.front()};
  shown.show(loaded.scene, loaded.models, settings);
  shown.capture();
  shown.requireHealthy();
  shown.timedFrame();  // programs are compiled
  RandomCameras cameras(loaded, shown.renderer().bounds(), options.seed);
  std::vector<double> seconds;
  double slowest = 0.0;
  Camera slowestCamera;
  for (int i = 0; i < options.cameras; ++i) {
    const Camera camera = cameras.next();
    shown.renderer().applyCamera(camera);
    // A view that shows something for the first time compiles its program; the second frame is the camera's own.
    double frame = shown.timedFrame();
    if (frame > slowest) frame = shown.timedFrame();
    seconds.push_back(frame);
    if (frame <= slowest) continue;
    slowest = frame;
    slowestCamera = camera;
  }
  shown.requireHealthy();
  const auto median = seconds.begin() + static_cast<std::ptrdiff_t>(seconds.size() / 2);
  std::nth_element(seconds.begin(), median, seconds.end());
  const double ratio = slowest / std::max({*median, options.leastSeconds, 1e-6});
  std::printf(
      "%s: %d cameras, median %.4f s, slowest %.4f s, ratio %.2f\n  boxprobe render %s -o slow.png --size %s%s\n",
      path.c_str(), options.cameras, *median, slowest, ratio, path.c_str(), options.size.c_str(),
      asAssignments(slowestCamera).c_str());
  std::fflush(stdout);
  return ratio;
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Draws scenes through random cameras; says the slowest frame over the median, CPU time",
                   "camera_soak");
  SoakOptions options;
  program.add_option("SCENES", options.scenes, "Scene files and bare models")->required();
  program.add_option("--cameras", options.cameras, "Of each scene")
      ->check(CLI::Range(1, 1000000))
      ->capture_default_str();
  program.add_option("--seed", options.seed, "Of the cameras")->capture_default_str();
  program.add_option("--size", options.size, "WxH")->capture_default_str();
  program.add_option("--set", options.assignments, "As of boxprobe render")->allow_extra_args(false);
  program.add_option("--most", options.most, "Fail where the ratio is larger (0: never)")->capture_default_str();
  program.add_option("--least", options.leastSeconds, "A median below this many seconds counts as this");
  CLI11_PARSE(program, argc, argv);
  int status = 0;
  for (const std::string& path : options.scenes) {
    try {
      if (const double ratio = soak(path, options); options.most > 0.0 && ratio > options.most) status = 1;
    } catch (const std::exception& error) {
      std::printf("%s: %s\n", path.c_str(), error.what());
      status = 1;
    }
  }
  return status;
}
