// See bench_command.h.
#include "app/cli/command/bench_command.h"

#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <memory>

#include "app/cli/command/bench_host.h"
#include "app/cli/command/truth_bench.h"
#include "app/cli/command/whole_bench.h"
#include "app/cli/options/bench_options.h"
#include "app/cli/report/contact_sheet.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"
#include "app/session/messages.h"
#include "app/session/offscreen_window.h"
#include "app/session/output_check.h"
#include "app/session/progress_line.h"
#include "app/session/stats_json.h"
#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/io/files/atomic_file.h"
#include "filters/io/files/data_folder.h"
#include "filters/io/files/read_file.h"
#include "filters/io/image/image_file.h"
#include "filters/reference/bench/bench_text.h"
#include "filters/reference/measure/metrics.h"
#include "filters/vtk/charts/pareto_chart.h"
#include "filters/vtk/gl/cpu_time.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

std::string processorName() {
  std::ifstream stream("/proc/cpuinfo");
  for (std::string line; std::getline(stream, line);) {
    if (line.rfind("model name", 0) == 0) return line.substr(std::min(line.find(':') + 2, line.size()));
  }
  return "unknown";
}

void printSummary(const BenchResult& result, const std::string& folder) {
  std::printf("%-34s %8s %8s %7s %8s %7s\n", "technique", "lookups", "frame", "error", "/ hdrp", "light");
  for (const BenchSummary& s : summaries(result, Truth::Box)) {
    std::printf("%-34s %8.1f %8.2f %7.4f %8.2f %7.3f%s\n", result.techniques[s.technique].label().c_str(), s.lookups,
                s.cpuRatioToBox.value, s.error, s.errorRatioToHdrp, s.brightnessRatio,
                s.onParetoFront ? "  front" : "");
  }
  printResult(folder + ": bench.json, bench.csv, report.md, front.png, front-scene.png, contact.png\n");
}

/// The pictures of one view, kept while they pass by.
class Contacts {
 public:
  explicit Contacts(const BenchPlan& plan) : camera_(plan.cameras.front().name) {
    // A roughness at which techniques differ the most, or the nearest there is.
    constexpr double kWanted = 0.5;
    for (const double r : plan.roughnesses) {
      if (std::abs(r - kWanted) < std::abs(roughness_ - kWanted)) roughness_ = r;
    }
  }
  void take(const BenchPictures& seen) {
    if (seen.camera->name != camera_ || seen.roughness != roughness_) return;
    ContactPicture picture{seen.technique->label(), *seen.picture, {}};
    double squares = 0.0;
    std::size_t count = 0;
    for (std::size_t i = 0; i < seen.mask->size(); ++i) {
      if (!(*seen.mask)[i]) {
        picture.error.push_back(-1.0f);
        continue;
      }
      double sum = 0.0;
      for (std::size_t c = 0; c < 3; ++c) {
        const double d = toneMapped(seen.picture->pixels[4 * i + c]) - toneMapped(seen.truth->pixels[4 * i + c]);
        sum += d * d;
      }
      squares += sum;
      ++count;
      picture.error.push_back(static_cast<float>(std::sqrt(sum / 3.0)));
    }
    char error[32];
    std::snprintf(error, sizeof(error), ": %.4f", std::sqrt(squares / (3.0 * static_cast<double>(count))));
    picture.label += error;
    pictures_.push_back(std::move(picture));
    truth_ = *seen.truth;
  }
  /// Nothing if that view was left out.
  void save(const std::string& path, const std::string& scene, double exposure) const {
    if (pictures_.empty()) return;
    const std::string title = scene + ", camera " + camera_ + ", roughness " + numberText(roughness_);
    savePng(path, contactSheet(title, truth_, pictures_, exposure, 0.15));
  }

 private:
  std::string camera_;
  double roughness_ = 1.0e3;
  ImageRgbaF truth_;
  std::vector<ContactPicture> pictures_;
};

void saveChart(const std::string& path, const BenchResult& result, Truth truth, const ReportOptions& report) {
  FrontChartText text;
  text.title = std::string("Run time against error: ") + result.scene + ", against the " +
               (truth == Truth::Box ? "integral over the box" : "traced scene");
  text.costAxis = "CPU time of a frame relative to plain box projection, " + std::to_string(result.timedWidth) + " x " +
                  std::to_string(result.timedHeight);
  const auto window = openOffscreenWindow({"boxprobe bench", 1400, 900, 1, report.quiet, false, report.offscreen});
  savePng(path, frontChartPicture(paretoPoints(result, truth), text, window));
}

void runBench(const BenchOptions& options) {
  if (!options.report.statsPath.empty()) requireWritable("--stats", options.report.statsPath);
  for (const char* name : {"bench.json", "bench.csv", "report.md", "front.png", "front-scene.png", "contact.png"}) {
    declareOutput("-o", options.folder + "/" + name);
  }
  InterruptGuard interrupt;
  const std::string scenePath =
      options.scenePath.empty() ? dataFile("scenes/gallery.boxprobe.json") : options.scenePath;
  const LoadedScene loaded = loadScene(scenePath, options.assignments);
  const BenchPlan plan = benchPlan(options, loaded.scene);
  if (!options.report.quiet) printWarnings(loaded.warnings);
  interrupt.check();

  const FrameSize timed = timedFrameSize(options);
  VtkBenchHost host(
      {"boxprobe bench", timed.width, timed.height, 1, options.report.quiet, false, options.report.offscreen},
      loaded.models, [] {});
  requireBenchFolder(options.folder, "bench.json");
  Contacts contacts(plan);
  BenchResult result = [&] {
    ProgressLine line("measuring", !options.report.quiet);
    const auto progress = [&](double done) {
      line.show(done);
      if (done > 0.0) interrupt.waitForPartialResults();
      return !interrupt.interrupted();
    };
    return runBenchmark(plan, loaded.scene, loaded.models, host, progress,
                        [&](const BenchPictures& seen) { contacts.take(seen); });
  }();
  const RunStats stats = collectStats(host.renderer(), host.window());
  result.scene = fs::path(scenePath).filename().string();
  result.machine = processorName();
  result.glRenderer = stats.glRenderer;
  result.glVersion = stats.glVersion;
  result.anisotropy = stats.anisotropy;
  result.timedWidth = timed.width;
  result.timedHeight = timed.height;
  const std::string json = benchJson(result);
  if (!result.complete) {
    const std::string partial = options.folder + "/bench.json.partial";
    writeTextAtomically(partial, json);
    throw WorkError("interrupted; partial results are in " + partial);
  }
  writeTextAtomically(options.folder + "/bench.json", json);
  writeTextAtomically(options.folder + "/bench.csv", benchCsv(result));
  writeTextAtomically(options.folder + "/report.md", benchReport(result));
  saveChart(options.folder + "/front.png", result, Truth::Box, options.report);
  saveChart(options.folder + "/front-scene.png", result, Truth::Scene, options.report);
  contacts.save(options.folder + "/contact.png", result.scene, loaded.scene.exposure);
  if (!options.report.statsPath.empty()) writeTextAtomically(options.report.statsPath, statsJson(stats));
  if (!options.report.quiet) {
    for (const std::string& remark : result.remarks) printWarnings({remark});
  }
  if (options.report.json) {
    printDocument(json);
  } else if (!options.report.quiet) {
    printSummary(result, options.folder);
  }
}

}  // namespace

Subcommand addBenchCommand(CLI::App& program) {
  CLI::App* command = program.add_subcommand("bench", "Measure every technique's run time and error");
  const auto options = std::make_shared<BenchOptions>();
  addBenchOptions(*command, *options);
  return {command, [options] {
            if (options->refine > 0 && options->truthPath.empty()) throw InputError("--refine is for --truth alone");
            if (options->whole && !options->truthPath.empty()) {
              throw InputError("--whole is not for --truth: leave one of them out");
            }
            measureWithoutAnisotropy();
            if (options->whole) return runWholeBench(*options);
            options->truthPath.empty() ? runBench(*options) : runTruthBench(*options);
          }};
}

}  // namespace boxprobe
