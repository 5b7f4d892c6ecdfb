// What placing costs in a whole building: apartments of so many rooms, their meshes divided until there are so many
// triangles, given to `boxprobe place` as a person would. Prints time, memory, how often progress is told, and how soon
// the program ends when it is interrupted.
#include <fcntl.h>
#include <poll.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <glm/geometric.hpp>
#include <numeric>
#include <string>
#include <vector>

#include "data/scenes/glb_writer.h"
#include "data/scenes/scenes.h"
#include "filters/core/base/errors.h"
#include "filters/io/scene/scene_file.h"
#include "tests/bench/harness.h"

namespace {

using namespace boxprobe;
using Clock = std::chrono::steady_clock;

struct Options {
  std::string program = BOXPROBE_PROGRAM;
  int rooms = 50, triangles = 2000000;
  bool unchecked = false;
};

double secondsSince(const Clock::time_point& begun) {
  return std::chrono::duration<double>(Clock::now() - begun).count();
}

/// Every triangle becomes four of the same plane.
void divide(Mesh& mesh) {
  std::vector<std::uint32_t> indices;
  const auto middle = [&mesh](std::uint32_t a, std::uint32_t b) {
    mesh.positions.push_back(0.5f * (mesh.positions[a] + mesh.positions[b]));
    if (!mesh.normals.empty()) mesh.normals.push_back(glm::normalize(mesh.normals[a] + mesh.normals[b]));
    if (!mesh.uv.empty()) mesh.uv.push_back(0.5f * (mesh.uv[a] + mesh.uv[b]));
    return static_cast<std::uint32_t>(mesh.positions.size() - 1);
  };
  for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
    const std::uint32_t a = mesh.indices[i], b = mesh.indices[i + 1], c = mesh.indices[i + 2];
    const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    indices.insert(indices.end(), {a, ab, ca, ab, b, bc, ca, bc, c, ab, bc, ca});
  }
  mesh.indices = std::move(indices);
}

/// Triangles that are drawn of each mesh.
std::vector<std::size_t> drawnTriangles(const Model& model) {
  std::vector<std::size_t> drawn(model.meshes.size());
  for (const Instance& each : model.instances) {
    const auto mesh = static_cast<std::size_t>(each.mesh);
    drawn[mesh] += model.meshes[mesh].indices.size() / 3;
  }
  return drawn;
}

struct Run {
  double seconds = 0.0, first = 0.0, longest = 0.0, stopped = 0.0, mebibytes = 0.0;
  int reports = 0, status = 0;
  std::string output;
};

/// `interruptAt`: seconds; negative: never.
Run runPlace(const Options& options, const std::string& scene, double interruptAt) {
  std::array<int, 2> out{}, told{};
  if (pipe(out.data()) != 0 || pipe(told.data()) != 0) throw WorkError("no pipe");
  std::vector<std::string> words = {options.program, "place", scene};
  if (options.unchecked) words.emplace_back("--unchecked");
  std::vector<char*> pointers;
  pointers.reserve(words.size() + 1);
  for (std::string& word : words) pointers.push_back(word.data());
  pointers.push_back(nullptr);
  setenv("BOXPROBE_PROGRESS", "lines", 1);
  const auto begun = Clock::now();
  const pid_t child = fork();
  if (child == 0) {
    dup2(out[1], STDOUT_FILENO);
    dup2(told[1], STDERR_FILENO);
    for (const int end : {out[0], out[1], told[0], told[1]}) close(end);
    execv(options.program.c_str(), pointers.data());
    _exit(127);
  }
  close(out[1]);
  close(told[1]);
  Run run;
  std::array<pollfd, 2> ends{{{out[0], POLLIN, 0}, {told[0], POLLIN, 0}}};
  auto last = begun, asked = begun;
  bool interrupted = false;
  while (ends[0].fd >= 0 || ends[1].fd >= 0) {
    if (poll(ends.data(), ends.size(), 50) < 0) break;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].fd < 0 || (ends[i].revents & (POLLIN | POLLHUP)) == 0) continue;
      std::array<char, 4096> bytes{};
      const ssize_t count = read(ends[i].fd, bytes.data(), bytes.size());
      if (count <= 0) {
        close(ends[i].fd);
        ends[i].fd = -1;
        continue;
      }
      if (i == 0) {
        run.output.append(bytes.data(), static_cast<std::size_t>(count));
        continue;
      }
      if (run.reports++ == 0) run.first = secondsSince(begun);
      run.longest = std::max(run.longest, secondsSince(last));
      last = Clock::now();
    }
    if (interruptAt >= 0.0 && !interrupted && secondsSince(begun) > interruptAt) {
      interrupted = true;
      asked = Clock::now();
      kill(child, SIGINT);
    }
  }
  rusage usage{};
  wait4(child, &run.status, 0, &usage);
  run.seconds = secondsSince(begun);
  run.stopped = interrupted ? secondsSince(asked) : 0.0;
  run.mebibytes = static_cast<double>(usage.ru_maxrss) / 1024.0;
  return run;
}

/// Meshes are divided in turn, those of the most triangles that are drawn last, until there are so many. Returns how
/// many there are.
std::size_t divideUntil(Model& model, std::size_t triangles) {
  std::vector<std::size_t> drawn = drawnTriangles(model);
  std::vector<std::size_t> order(model.meshes.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return drawn[a] < drawn[b]; });
  std::size_t all = std::accumulate(drawn.begin(), drawn.end(), std::size_t{0});
  for (std::size_t i = 0; all > 0 && all < triangles; ++i) {
    const std::size_t mesh = order[i % order.size()];
    if (drawn[mesh] == 0) continue;
    divide(model.meshes[mesh]);
    all += 3 * drawn[mesh];
    drawn[mesh] *= 4;
  }
  return all;
}

void measure(const Options& options, const std::filesystem::path& folder) {
  scenes::Apartments made = scenes::apartments(options.rooms, 1);
  const std::size_t triangles = divideUntil(made.model, static_cast<std::size_t>(options.triangles));
  const std::string model = (folder / "house.glb").string(), scene = (folder / "house.boxprobe.json").string();
  std::ofstream(model, std::ios::binary) << scenes::glbBytes(made.model);
  made.scene.models = {ModelFile{model}};
  made.scene.probes.clear();  // placed from nothing
  saveSceneFile(made.scene, scene);
  std::printf("%d rooms and their corridors, %zu triangles, a file of %.0f MiB\n", options.rooms, triangles,
              static_cast<double>(std::filesystem::file_size(model)) / 1048576.0);
  std::fflush(stdout);
  const Run whole = runPlace(options, scene, -1.0);
  if (whole.status != 0) throw WorkError("place failed");
  std::printf("placed: %.1f s, at most %.0f MiB; first told after %.1f s, %d times, at most %.1f s apart\n",
              whole.seconds, whole.mebibytes, whole.first, whole.reports, whole.longest);
  // Rooms and their probes are left out: what is told of all of them follows.
  const std::size_t all = whole.output.find(" probes placed, "), line = whole.output.rfind('\n', all);
  if (all != std::string::npos) std::printf("%s", whole.output.substr(line + 1).c_str());
  for (const double share : {0.25, 0.75}) {
    const Run cut = runPlace(options, scene, share * whole.seconds);
    std::printf("interrupted after %.1f s: ended %.2f s later\n", share * whole.seconds, cut.stopped);
  }
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("What placing probes in a whole building costs", "bench_place");
  Options options;
  program.add_option("ROOMS", options.rooms, "Of the building")->check(CLI::Range(1, 8000))->capture_default_str();
  program.add_option("TRIANGLES", options.triangles, "Of the building, at least")->capture_default_str();
  program.add_option("--program", options.program, "The program that places");
  program.add_flag("--unchecked", options.unchecked, "Without pictures");
  const std::filesystem::path folder =
      std::filesystem::temp_directory_path() / ("boxprobe-house-" + std::to_string(::getpid()));
  std::filesystem::create_directories(folder);
  const int status = bench::runProgram(program, argc, argv, [&] { measure(options, folder); });
  std::error_code ignored;
  std::filesystem::remove_all(folder, ignored);
  return status;
}
