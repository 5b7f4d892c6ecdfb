// bench_nodes: what nodes of diffuse light, what they see of lamps, and bounces cost where there are many rooms or many
// triangles: CPU seconds and memory, a row for each scene, each made in a process of its own. `--shadows` compares
// frames instead: with all that is traced and drawn for shadows, and without.
#include <sys/wait.h>
#include <unistd.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <memory>
#include <string>

#include "app/session/stats_json.h"
#include "data/scenes/scenes.h"
#include "filters/core/base/errors.h"
#include "filters/core/geometry/probe_diffuse.h"
#include "filters/platform/process.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/map_bytes.h"
#include "filters/vtk/maps/lattice_maker.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;

constexpr unsigned kSeed = 1;

template <typename T>
void blend(std::vector<T>& values, std::size_t a, std::size_t b, std::size_t c, float u, float v) {
  if (!values.empty()) values.push_back(values[a] * (1.0f - u - v) + values[b] * u + values[c] * v);
}

/// Each triangle in parts x parts equal ones, of which no two share corners.
void split(Mesh& mesh, int parts) {
  const std::vector<std::uint32_t> before = std::move(mesh.indices);
  mesh.indices.clear();
  const auto corner = [&](std::size_t t, int i, int j) {
    const float u = static_cast<float>(i) / static_cast<float>(parts);
    const float v = static_cast<float>(j) / static_cast<float>(parts);
    const std::size_t a = before[t], b = before[t + 1], c = before[t + 2];
    mesh.indices.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    blend(mesh.positions, a, b, c, u, v);
    blend(mesh.normals, a, b, c, u, v);
    blend(mesh.tangents, a, b, c, u, v);
    blend(mesh.uv, a, b, c, u, v);
    blend(mesh.uv1, a, b, c, u, v);
    blend(mesh.colors, a, b, c, u, v);
  };
  for (std::size_t t = 0; t + 2 < before.size(); t += 3) {
    for (int i = 0; i < parts; ++i) {
      for (int j = 0; i + j < parts; ++j) {
        corner(t, i, j);
        corner(t, i + 1, j);
        corner(t, i, j + 1);
        if (i + j + 1 == parts) continue;
        corner(t, i + 1, j);
        corner(t, i + 1, j + 1);
        corner(t, i, j + 1);
      }
    }
  }
}

struct Row {
  const char* name;
  int rooms;
  std::size_t triangles;  ///< at least; 0: as they are
};

double mebibytes(std::size_t bytes) {
  return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

struct Made {
  Scene scene;
  std::shared_ptr<const Model> model;
};

Made make(int rooms, std::size_t triangles) {
  scenes::Apartments apartments = scenes::apartments(rooms, kSeed);
  const double over = static_cast<double>(triangles) / static_cast<double>(apartments.model.triangleCount());
  const auto parts = static_cast<int>(std::ceil(std::sqrt(over)));
  for (Mesh& mesh : apartments.model.meshes) {
    if (parts > 1) split(mesh, parts);
  }
  apartments.scene.models = {ModelFile{"apartments.glb"}};  // a name alone, nothing is read
  return {std::move(apartments.scene), std::make_shared<const Model>(std::move(apartments.model))};
}

/// Everything of all probes, as `bake` makes it with two bounces, for which lattices of the first are derived.
void measure(const CLI::App& program, const Row& row) {
  Made made = make(row.rooms, row.triangles);
  ShownSettings shown;
  for (Probe& probe : made.scene.probes) {
    probe.bounces = 2;
    shown.bakeTargets.push_back(probe.name);
  }
  bench::FrameOptions options;
  options.size = "320x180";
  options.samples = 1;
  OffscreenScene drawn(bench::windowSettings(program, options));
  SceneRenderer& renderer = drawn.renderer();
  shown.camera = made.scene.cameras.front();
  drawn.show(made.scene, {made.model}, shown);
  double sights = 0.0;
  while (renderer.workPending()) {
    double other = 0.0;
    const bool shadows = renderer.workNow().what == WorkNow::What::Shadows;
    const CpuTimer timer(shadows ? sights : other);
    renderer.step();
  }
  const LatticeCosts costs = latticeCosts();
  std::size_t sightBytes = 0;
  for (const auto& probe : renderer.probesDiffuse().probes) {
    if (probe && probe->sight) sightBytes += probe->sight->lattice.texels.size();
  }
  const auto& bounces = renderer.times().bounces;
  std::printf("| %s | %zu | %zu | %.2f | %.2f, %.2f | %.2f | %zu | %.1f, %.1f | %.1f | %.0f | %.0f |\n", row.name,
              made.model->triangleCount(), made.scene.probes.size(), sights, bounces[0].cpuSeconds,
              bounces[1].cpuSeconds, costs.cpuSeconds, costs.nodes, mebibytes(costs.bytes),
              mebibytes(latticeAtlasBytes(costs.lattices)), mebibytes(sightBytes),
              mebibytes(renderer.probeMemoryBytes()), mebibytes(peakResidentBytes()));
  drawn.requireHealthy();
}

/// In a process of its own, whose peak memory is the row's.
void measureApart(const CLI::App& program, const Row& row) {
  std::fflush(stdout);
  const pid_t child = ::fork();
  if (child < 0) throw WorkError("no process for a row");
  if (child == 0) {
    int status = 0;
    try {
      measure(program, row);
    } catch (const std::exception& error) {
      std::fprintf(stderr, "%s\n", error.what());
      status = 1;
    }
    std::fflush(stdout);
    std::_Exit(status);
  }
  int status = 0;
  if (::waitpid(child, &status, 0) != child || status != 0) throw WorkError(std::string(row.name) + ": not measured");
}

void printRows(const CLI::App& program) {
  std::printf(
      "| scene | triangles | probes | visibilities, s | bounces 1, 2, s | of which nodes, s | nodes "
      "| lattices, texture, MiB | visibilities, MiB | maps, MiB | peak, MiB |\n"
      "|---|---|---|---|---|---|---|---|---|---|---|\n");
  for (const Row& row :
       {Row{"apartments of 8 rooms", 8, 0}, Row{"50 rooms", 50, 0}, Row{"2 million triangles", 8, 2'000'000}}) {
    measureApart(program, row);
  }
}

/// The same picture twice in one window, once without what traces shadows and draws those of suns.
void compareFrames(const CLI::App& program, const bench::FrameOptions& options, const std::string& name,
                   const Scene& scene, const OffscreenScene::Models& models) {
  const auto window = openOffscreenWindow(bench::windowSettings(program, options));
  OffscreenScene with(window), without(window);
  without.renderer().setSightLines({});
  bench::prepare(with, scene, models, options.camera);
  bench::prepare(without, scene, models, options.camera);
  const auto frame = [&](OffscreenScene& drawn) {
    bench::drawOnly(drawn, {&with, &without});
    return drawn.timedFrame();
  };
  const bench::Comparison result = bench::compare(
      3, options.frames, [&] { return frame(with); }, [&] { return frame(without); });
  with.requireHealthy();
  const Counters& counters = with.renderer().counters();
  std::printf("%s: %.2f ms with shadows, %.2f without: %s; %llu lattices of visibilities, %llu shadow maps\n",
              name.c_str(), result.first, result.second, result.ratioText().c_str(),
              static_cast<unsigned long long>(counters.sightsTraced),
              static_cast<unsigned long long>(counters.shadowMapsDrawn));
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("What nodes of diffuse light and bounces cost in large scenes, or shadows in a frame",
                   "bench_nodes");
  bench::FrameOptions options;
  bool shadows = false;
  options.size = "640x360";
  options.samples = 1;
  options.frames = 20;
  addFrameOptions(program, options);
  addCameraOption(program, options);
  program.add_flag("--shadows", shadows, "Frames of SCENE, or of apartments, with shadows and without");
  return bench::runProgram(program, argc, argv, [&] {
    if (!shadows) return printRows(program);
    if (options.scene.empty()) {
      const Made made = make(8, 0);
      return compareFrames(program, options, "apartments of 8 rooms", made.scene, {made.model});
    }
    const LoadedScene loaded = loadScene(options.scene);
    compareFrames(program, options, options.scene, loaded.scene, loaded.models);
  });
}
