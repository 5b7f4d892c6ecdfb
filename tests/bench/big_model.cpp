// What a large model costs: a generated one of a million triangles and a hundred textures, loaded, loaded again,
// captured and drawn. Prints one line each; `bench_big_model [TRIANGLES [TEXTURES]]`.
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <vector>

#include "filters/io/files/read_file.h"
#include "filters/io/image/image_file.h"
#include "filters/io/image/image_pool.h"
#include "filters/vtk/gl/cpu_time.h"
#include "tests/bench/harness.h"
#include "tests/unit/io_glb_builder.h"

namespace {

using namespace boxprobe;

/// Tiles of a wavy field, each with a picture of its own.
void writeModel(const std::string& path, int triangles, int textures) {
  using Json = nlohmann::json;
  constexpr int kPicture = 512;
  GlbBuilder glb;
  const int side = std::max(1, static_cast<int>(std::ceil(std::sqrt(0.5 * triangles / textures))));
  const int row = static_cast<int>(std::ceil(std::sqrt(textures)));
  const std::string picture = path + ".png";
  for (int t = 0; t < textures; ++t) {
    ImageRgba8 image{kPicture, kPicture, std::vector<std::uint8_t>(std::size_t{4} * kPicture * kPicture, 255), "t"};
    for (int i = 0; i < kPicture * kPicture; ++i) {
      const int x = i % kPicture, y = i / kPicture;
      std::uint8_t* p = &image.pixels[4 * static_cast<std::size_t>(i)];
      p[0] = static_cast<std::uint8_t>((x * (t + 3)) ^ y);
      p[1] = static_cast<std::uint8_t>((x + y * t) / 2);
      p[2] = static_cast<std::uint8_t>(37 * t + ((x / 16 + y / 16) % 2) * 90);
    }
    savePng(picture, image);
    const std::string bytes = readWholeFile(picture);
    glb.json["images"].push_back(
        {{"bufferView", glb.view(std::vector<char>(bytes.begin(), bytes.end()))}, {"mimeType", "image/png"}});
    glb.json["textures"].push_back({{"source", t}});
    glb.json["materials"].push_back(
        {{"name", "m" + std::to_string(t)},
         {"doubleSided", true},
         {"pbrMetallicRoughness",
          {{"baseColorTexture", {{"index", t}}}, {"metallicFactor", 0.2}, {"roughnessFactor", 0.4}}}});
    std::vector<float> positions, normals, uv;
    std::vector<std::uint32_t> indices;
    for (int j = 0; j <= side; ++j) {
      for (int i = 0; i <= side; ++i) {
        const float u = static_cast<float>(i) / static_cast<float>(side),
                    v = static_cast<float>(j) / static_cast<float>(side);
        const float x = static_cast<float>(t % row) + u, z = static_cast<float>(t / row) + v;
        positions.insert(positions.end(), {x, 0.2f * std::sin(5 * x) * std::cos(4 * z), z});
        const float sx = std::cos(5 * x) * std::cos(4 * z), sz = -0.8f * std::sin(5 * x) * std::sin(4 * z);
        const float length = std::sqrt(sx * sx + 1 + sz * sz);
        normals.insert(normals.end(), {-sx / length, 1 / length, -sz / length});
        uv.insert(uv.end(), {u, v});
      }
    }
    const auto stride = static_cast<std::uint32_t>(side + 1);
    for (std::uint32_t j = 0; j + 1 < stride; ++j) {
      for (std::uint32_t i = 0; i + 1 < stride; ++i) {
        const std::uint32_t a = j * stride + i;
        indices.insert(indices.end(), {a, a + stride, a + 1, a + 1, a + stride, a + stride + 1});
      }
    }
    const Json attributes = {{"POSITION", glb.floats("VEC3", 3, positions)},
                             {"NORMAL", glb.floats("VEC3", 3, normals)},
                             {"TEXCOORD_0", glb.floats("VEC2", 2, uv)}};
    const int order = glb.accessor(glb.view(indices), GlbBuilder::UInt, "SCALAR", indices.size());
    glb.node({{"name", "tile " + std::to_string(t)},
              {"mesh", glb.mesh({{"attributes", attributes}, {"indices", order}, {"material", t}})}});
  }
  std::ofstream(path, std::ios::binary) << glb.glb();
  std::filesystem::remove(picture);
}

double mebibytes(std::size_t bytes) {
  return static_cast<double>(bytes) / (1024.0 * 1024.0);
}

double residentMebibytes() {
  rusage used{};
  getrusage(RUSAGE_SELF, &used);
  return static_cast<double>(used.ru_maxrss) / 1024.0;
}

LoadedScene timedLoad(const std::string& path, const char* what) {
  const ImageCounts before = imagePool().counts();
  const double cpu = processCpuSeconds();
  const auto start = std::chrono::steady_clock::now();
  int reports = 0;
  LoadedScene loaded = loadScene(path, {}, [&](double) { return ++reports > 0; });
  const double wall = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  const ImageCounts after = imagePool().counts();
  std::printf("%s: %.2f s of CPU time, %.2f s; %llu pictures decoded, %llu shared; %d progress reports\n", what,
              processCpuSeconds() - cpu, wall, static_cast<unsigned long long>(after.decoded - before.decoded),
              static_cast<unsigned long long>(after.shared - before.shared), reports);
  return loaded;
}

void measure(const CLI::App& program, const std::string& path, int triangles, int textures) {
  writeModel(path, triangles, textures);
  std::printf("file: %.0f MiB; resident so far %.0f MiB\n", mebibytes(std::filesystem::file_size(path)),
              residentMebibytes());
  const LoadedScene loaded = timedLoad(path, "load");
  std::printf("triangles: %zu; resident at most %.0f MiB\n", loaded.models[0]->triangleCount(), residentMebibytes());
  { const LoadedScene again = timedLoad(path, "second load"); }
  bench::FrameOptions options;
  options.samples = 1;
  OffscreenScene drawn(windowSettings(program, options));
  const double cpu = processCpuSeconds();
  bench::prepare(drawn, loaded.scene, loaded.models);
  drawn.window()->WaitForCompletion();
  std::printf("actors, textures, capture and filter: %.2f s of CPU time, %llu faces\n", processCpuSeconds() - cpu,
              static_cast<unsigned long long>(drawn.renderer().counters().facesCaptured));
  const double first = drawn.timedFrame();  // compiles
  std::vector<double> frames;
  for (int i = 0; i < 10; ++i) frames.push_back(drawn.timedFrame());
  std::printf("frame, 1280 x 720: first %.2f s, then median %.3f s of CPU time; resident at most %.0f MiB\n", first,
              bench::median(frames), residentMebibytes());
  drawn.requireHealthy();
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("What a large model costs: loaded, captured and drawn", "bench_big_model");
  int triangles = 1000000, textures = 100;
  program.add_option("TRIANGLES", triangles, "Of the model")->check(CLI::Range(1, 100000000))->capture_default_str();
  program.add_option("TEXTURES", textures, "Of the model")->check(CLI::Range(1, 10000))->capture_default_str();
  const std::string path =
      (std::filesystem::temp_directory_path() / ("boxprobe-big-" + std::to_string(::getpid()) + ".glb")).string();
  const int status = bench::runProgram(program, argc, argv, [&] { measure(program, path, triangles, textures); });
  std::error_code ignored;
  std::filesystem::remove(path, ignored);
  return status;
}
