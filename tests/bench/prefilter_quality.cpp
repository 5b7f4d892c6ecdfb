// bench_prefilter: error of prefiltered levels against a reference without sampling, and their CPU time, beside VTK's
// own prefilter on the same cubemaps. Prints the Markdown tables of README.md beside it.
#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <memory>

#include "filters/math/cube/cube_filter.h"
#include "filters/math/cube/cube_filter_reference.h"
#include "filters/reference/measure/interleaved.h"
#include "filters/vtk/capture/prefilter.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/maps/cube_transfer.h"
#include "tests/bench/harness.h"
#include "tests/bench/prefilter_cubes.h"
#include "tests/bench/stock_prefilter.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::bench;

struct Options {
  int faceSize = 256;
  std::vector<int> samples = {PrefilterSettings().samples, 160, 400};
  int pairs = 7;
};

/// Root mean square over a level's texels and colours of the difference, relative to that of the reference.
double relativeError(const CubeMap& ours, const CubeMap& reference, int level) {
  double difference = 0.0, size = 0.0;
  const int texels = reference.levelSize(level) * reference.levelSize(level);
  for (int face = 0; face < 6; ++face) {
    for (int i = 0; i < 4 * texels; ++i) {
      if (i % 4 == 3) continue;
      const double r = reference.face(level, face)[i], d = ours.face(level, face)[i] - r;
      difference += d * d;
      size += r * r;
    }
  }
  return std::sqrt(difference / size);
}

/// The same for single lookups.
double lookupError(const CubeMap& chain, float level, const std::vector<glm::vec3>& directions,
                   const std::vector<glm::vec4>& truth) {
  double difference = 0.0, size = 0.0;
  for (std::size_t i = 0; i < directions.size(); ++i) {
    const glm::vec4 value = chain.fetch(directions[i], level);
    for (int c = 0; c < 3; ++c) {
      difference += std::pow(double(value[c]) - truth[i][c], 2.0);
      size += std::pow(double(truth[i][c]), 2.0);
    }
  }
  return std::sqrt(difference / size);
}

/// Ours on the graphics side, for one cubemap.
class Ours {
 public:
  Ours(vtkOpenGLRenderWindow* window, const CubeMap& cube) : window_(window), prefilter_(window, &counters_) {
    source_.allocate(cube.faceSize(), fullLevels(cube.faceSize()), GL_RGBA16F);
    chain_.allocate(cube.faceSize(), prefilterLevels(cube.faceSize()), GL_RGBA16F);
    uploadLevel0(cube, source_);
  }
  ~Ours() { prefilter_.release(); }

  double chain(const PrefilterSettings& settings) {
    return timed([&] {
      prefilter_.begin(source_, chain_, settings);
      for (int level = 1; level < chain_.levels(); ++level) prefilter_.filterLevel(source_, chain_, level, settings);
    });
  }
  /// The levels that VTK makes, for the roughness it makes them for.
  double likeStock(const StockPrefilter& stock, int samples) {
    PrefilterSettings settings;
    settings.samples = samples;
    return timed([&] {
      prefilter_.begin(source_, chain_, settings);
      for (int level = 1; level < stock.levels(); ++level) {
        const float p = stock.bakedRoughness(level);
        prefilter_.filterWith(
            source_, chain_, level,
            lobeTaps({FilterLobe::Kind::Ggx, p * p}, samplesOfLevel(settings, level), source_.faceSize()));
      }
    });
  }
  CubeMap read() const {
    CubeMap result(chain_.faceSize(), chain_.levels());
    for (int level = 0; level < chain_.levels(); ++level) {
      for (int face = 0; face < 6; ++face) {
        const std::vector<float> rgba = chain_.readFace(face, level);
        std::copy(rgba.begin(), rgba.end(), result.face(level, face));
      }
    }
    return result;
  }

 private:
  template <typename Work>
  double timed(const Work& work) {
    window_->WaitForCompletion();
    const double start = processCpuSeconds();
    work();
    window_->WaitForCompletion();
    return processCpuSeconds() - start;
  }
  vtkOpenGLRenderWindow* window_;
  Counters counters_;
  Prefilter prefilter_;
  CubeTexture source_, chain_;
};

/// Errors of the levels VTK makes: VTK's own, and ours for the same roughness.
void levelsLikeStock(const NamedCube& input, const CubeFilterReference& reference, StockPrefilter& stock, Ours& ours,
                     const Options& options) {
  CubeMap truth(input.cube.faceSize(), stock.levels());
  for (int level = 1; level < stock.levels(); ++level) {
    const float p = stock.bakedRoughness(level);
    reference.filterLevel({FilterLobe::Kind::Ggx, p * p}, truth, level);
  }
  stock.filter();
  const CubeMap theirs = stock.read();
  std::vector<CubeMap> chains;
  for (const int samples : options.samples) {
    ours.likeStock(stock, samples);
    chains.push_back(ours.read());
  }
  for (int level = 1; level < stock.levels(); ++level) {
    const double vtk = relativeError(theirs, truth, level);
    std::printf("| %s | %d² at roughness %.1f | %.2f %% |", input.name.c_str(), truth.levelSize(level),
                stock.bakedRoughness(level), 100 * vtk);
    for (const CubeMap& chain : chains) {
      const double error = relativeError(chain, truth, level);
      std::printf(" %.2f %% (%.2f) |", 100 * error, error / vtk);
    }
    std::printf("\n");
  }
  std::fflush(stdout);
}

/// Errors of our own chain, and of the same made on the CPU with the first of the settings.
void ownLevels(const NamedCube& input, const CubeFilterReference& reference, Ours& ours, const Options& options) {
  PrefilterSettings settings;
  std::vector<CubeMap> chains;
  for (const int samples : options.samples) {
    settings.samples = samples;
    ours.chain(settings);
    chains.push_back(ours.read());
  }
  settings.samples = options.samples.front();
  const CubeMap onCpu = prefilterCube(input.cube, settings);
  CubeMap truth(onCpu.faceSize(), onCpu.levels());
  for (int level = 1; level < truth.levels(); ++level) {
    const FilterLobe lobe = lobeOfLevel(settings, level, truth.levels() - 1);
    reference.filterLevel(lobe, truth, level);
    std::printf("| %s | %d: %d² at roughness %.2f |", input.name.c_str(), level, truth.levelSize(level),
                std::sqrt(lobe.width));
    for (const CubeMap& chain : chains) std::printf(" %.2f %% |", 100 * relativeError(chain, truth, level));
    std::printf(" %.2f %% |\n", 100 * relativeError(onCpu, truth, level));
  }
  std::fflush(stdout);
}

/// What a surface of that roughness shows: the level its lookup lands on, interpolated, against the lobe of its own.
void lookups(const NamedCube& input, const CubeFilterReference& reference, StockPrefilter& stock, Ours& ours,
             const Options& options) {
  stock.filter();
  const CubeMap theirs = stock.read();
  PrefilterSettings settings;
  settings.samples = options.samples.front();
  ours.chain(settings);
  const CubeMap chain = ours.read();
  std::vector<glm::vec3> directions;
  constexpr int kCount = 4000;
  for (int i = 0; i < kCount; ++i) {  // a Fibonacci sphere
    const float z = 1.0f - (2.0f * static_cast<float>(i) + 1.0f) / kCount, r = std::sqrt(1.0f - z * z);
    const float a = 2.3999632f * static_cast<float>(i);
    directions.emplace_back(r * std::cos(a), r * std::sin(a), z);
  }
  for (const float p : {0.1f, 0.2f, 0.4f, 0.6f, 0.8f, 1.0f}) {
    std::vector<glm::vec4> truth;
    truth.reserve(directions.size());
    for (const glm::vec3& d : directions) truth.push_back(reference.value({FilterLobe::Kind::Ggx, p * p}, d));
    const double vtk = lookupError(theirs, stock.levelLookedUp(p), directions, truth);
    const double own = lookupError(chain, shading::levelForRoughness(p, chain.maxLevel()), directions, truth);
    std::printf("| %s | %.1f | %.1f %% | %.1f %% |\n", input.name.c_str(), p, 100 * vtk, 100 * own);
  }
  std::fflush(stdout);
}

void printRatio(const char* what, const Samples& samples) {
  const Ratio ratio = ratioOfMedians(samples);
  std::printf("| %s | %.0f ms | %.0f ms | %.2f (%.2f to %.2f) |\n", what, 1e3 * median(samples.a),
              1e3 * median(samples.b), ratio.value, ratio.low, ratio.high);
  std::fflush(stdout);
}

void run(const CLI::App& program, const Options& options) {
  const auto window = openOffscreenWindow(smallWindowSettings(program));
  const std::vector<NamedCube> cubes = prefilterCubes(window, options.faceSize);
  std::vector<std::unique_ptr<StockPrefilter>> stock;
  std::vector<std::unique_ptr<Ours>> ours;
  std::vector<std::unique_ptr<CubeFilterReference>> references;
  for (const NamedCube& input : cubes) {
    stock.push_back(std::make_unique<StockPrefilter>(window, input.cube));
    ours.push_back(std::make_unique<Ours>(window, input.cube));
    references.push_back(std::make_unique<CubeFilterReference>(input.cube));
  }
  std::printf(
      "Root mean square error, relative to the reference's root mean square; in brackets over VTK's. %d² faces, "
      "VTK with 512 samples.\n\n",
      options.faceSize);
  std::string columns, rule;
  for (const int samples : options.samples) {
    columns += " " + std::to_string(samples) + " samples |";
    rule += "---|";
  }
  std::printf("| cubemap | level as VTK makes it | VTK |%s\n|---|---|---|%s\n", columns.c_str(), rule.c_str());
  for (std::size_t i = 0; i < cubes.size(); ++i) {
    levelsLikeStock(cubes[i], *references[i], *stock[i], *ours[i], options);
  }
  std::printf("\n| CPU time | ours | VTK | ratio of medians (95 %% interval) |\n|---|---|---|---|\n");
  const auto theirs = [&] { return stock[0]->filter(); };
  const auto time = [&](const std::string& what, const std::function<double()>& work) {
    work();
    printRatio(what.c_str(), interleave(options.pairs, work, theirs));
  };
  for (const int samples : options.samples) {
    PrefilterSettings settings;
    settings.samples = samples;
    const std::string with = ", " + std::to_string(samples) + " samples";
    time("VTK's levels" + with, [&] { return ours[0]->likeStock(*stock[0], samples); });
    time("our whole chain" + with, [&] { return ours[0]->chain(settings); });
  }
  time("our whole chain without OpenGL, " + std::to_string(options.samples.front()) + " samples", [&] {
    PrefilterSettings settings;
    settings.samples = options.samples.front();
    const double start = processCpuSeconds();
    prefilterCube(cubes[0].cube, settings);
    return processCpuSeconds() - start;
  });

  std::printf("\n| cubemap | level of our chain |%s the first on the CPU |\n|---|---|%s---|\n", columns.c_str(),
              rule.c_str());
  for (std::size_t i = 0; i < cubes.size(); ++i) ownLevels(cubes[i], *references[i], *ours[i], options);
  std::printf("\n| cubemap | roughness of a surface | VTK's lookup | ours |\n|---|---|---|---|\n");
  for (std::size_t i = 0; i < cubes.size(); ++i) lookups(cubes[i], *references[i], *stock[i], *ours[i], options);
}

}  // namespace

int main(int argc, char** argv) {
  CLI::App program("Error and CPU time of the prefilter beside VTK's own", "bench_prefilter");
  Options options;
  // Smaller faces have fewer levels in our chain than VTK makes.
  program.add_option("--face-size", options.faceSize, "Texels")->check(CLI::Range(64, 2048))->capture_default_str();
  program.add_option("--samples", options.samples, "Our settings, a column each")
      ->check(CLI::Range(kMinSamples, kMaxSamples))
      ->capture_default_str();
  program.add_option("--pairs", options.pairs, "Pairs of timings")->check(CLI::Range(2, 1000))->capture_default_str();
  return runProgram(program, argc, argv, [&] { run(program, options); });
}
