// See frame_costs.h.
#include "app/cli/report/frame_costs.h"

#include <vtkOpenGLRenderWindow.h>

#include <algorithm>
#include <chrono>
#include <cstdio>

#include "filters/core/base/errors.h"
#include "filters/core/base/scope_exit.h"
#include "filters/vtk/gl/cpu_time.h"
#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

constexpr std::size_t kMostOfAKind = 16;  // programs and objects that are measured one by one

/// What a frame is drawn without.
struct Kind {
  FrameParts parts = 0;
  std::vector<std::size_t> objects;  ///< of which; empty: of all
  bool withoutSky = false;
  bool ownDepth = false;
};

using Seconds = std::vector<double>;

double quantile(Seconds sorted, double at) {
  std::sort(sorted.begin(), sorted.end());
  const double place = at * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  return sorted[below] + (place - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

Cost costOf(const Seconds& seconds) {
  return {1e3 * quantile(seconds, 0.5), 1e3 * quantile(seconds, 0.25), 1e3 * quantile(seconds, 0.75)};
}

/// What `more` takes beyond `less`, drawn in the same rounds.
Seconds beyond(const Seconds& more, const Seconds& less) {
  Seconds times;
  for (std::size_t i = 0; i < more.size(); ++i) times.push_back(more[i] - less[i]);
  return times;
}

class Measurement {
 public:
  explicit Measurement(SceneRenderer& renderer) : renderer_(renderer) {}

  std::size_t add(Kind kind) {
    kinds_.push_back(std::move(kind));
    return kinds_.size() - 1;
  }

  /// False: stopped.
  bool run(int rounds, const std::function<double()>& timedFrame, const std::function<bool(double)>& progress) {
    without_.assign(kinds_.size(), {});
    times_.assign(kinds_.size(), {});
    const ScopeExit whole([this] { set({}); });
    const double all = static_cast<double>((rounds + 1) * static_cast<int>(kinds_.size()));
    double done = 0.0;
    for (int round = 0; round <= rounds; ++round) {
      for (std::size_t k = 0; k < kinds_.size(); ++k) {
        // The whole frame right beside it, each first in turn: a drift of the machine touches both alike.
        const bool wholeFirst = round % 2 == 0;
        const double first = timed(wholeFirst ? Kind{} : kinds_[k], timedFrame);
        const double second = timed(wholeFirst ? kinds_[k] : Kind{}, timedFrame);
        if (!renderer_.error().empty()) throw WorkError(renderer_.error());
        if (round > 0) {
          whole_.push_back(wholeFirst ? first : second);
          times_[k].push_back(wholeFirst ? second : first);
          without_[k].push_back(whole_.back() - times_[k].back());
        }
        set({});  // whoever draws or captures meanwhile gets whole pictures
        if (progress && !progress(++done / all)) return false;
      }
    }
    return true;
  }

  /// Of whole frames; of frames of a kind; and of what the kind leaves out.
  const Seconds& whole() const { return whole_; }
  const Seconds& of(std::size_t kind) const { return times_[kind]; }
  const Seconds& without(std::size_t kind) const { return without_[kind]; }

 private:
  void set(const Kind& kind) { renderer_.disableParts(kind.parts, kind.objects, kind.withoutSky); }

  double timed(const Kind& kind, const std::function<double()>& timedFrame) {
    set(kind);
    timedFrame();  // makes the programs, and leaves the depth that the next one may keep
    renderer_.keepDepth(kind.ownDepth);
    const double seconds = timedFrame();
    renderer_.keepDepth(false);
    return seconds;
  }

  SceneRenderer& renderer_;
  std::vector<Kind> kinds_;
  Seconds whole_;
  std::vector<Seconds> times_, without_;
};

nlohmann::ordered_json costJson(const Cost& cost, double frame) {
  return {{"milliseconds", cost.median},
          {"low", cost.low},
          {"high", cost.high},
          {"share", frame > 0.0 ? cost.median / frame : 0.0}};
}

std::string joined(const std::vector<std::string>& names) {
  std::string text;
  for (std::size_t i = 0; i < names.size() && i < 4; ++i) text += (i == 0 ? "" : ", ") + names[i];
  return names.size() > 4 ? text + " and " + std::to_string(names.size() - 4) + " more" : text;
}

}  // namespace

FrameCosts measureFrameCosts(SceneRenderer& renderer, int rounds, const std::function<double()>& timedFrame,
                             const std::function<bool(double)>& progress) {
  // Of frames that draw everything, as those of a view that has just changed do.
  renderer.drawHidden(true);
  const ScopeExit leftOutAgain([&renderer] { renderer.drawHidden(false); });
  timedFrame();
  const std::vector<DrawnProgram> programs = renderer.drawnPrograms();
  std::vector<DrawnProgram::Object> objects;
  for (const DrawnProgram& program : programs) {
    objects.insert(objects.end(), program.objects.begin(), program.objects.end());
  }
  objects.resize(std::min(objects.size(), kMostOfAKind));
  Measurement measured(renderer);
  const std::size_t ownDepth = measured.add({0, {}, false, true}), sky = measured.add({0, {}, true});
  const std::size_t reflection = measured.add({kReflectionPart, {}}), lamps = measured.add({kLampsPart, {}});
  const std::size_t material = measured.add({kMaterialPart, {}}), output = measured.add({kOutputPart, {}});
  // Without the sky, which would fill what the objects leave.
  const std::size_t fragment = measured.add({kFragmentPart, {}, true}), raster = measured.add({kRasterPart, {}, true});
  const std::size_t empty = measured.add({kObjectPart, {}, true}), ground = measured.add({kGroundPart, {}});
  const std::size_t openness = measured.add({kOpennessPart, {}});
  std::vector<std::size_t> ofPrograms, ofObjects;
  for (std::size_t i = 0; i < std::min(programs.size(), kMostOfAKind); ++i) {
    Kind kind{kFragmentPart, {}};
    for (const auto& object : programs[i].objects) kind.objects.push_back(object.index);
    ofPrograms.push_back(measured.add(kind));
  }
  for (const auto& object : objects) ofObjects.push_back(measured.add({kFragmentPart, {object.index}}));

  FrameCosts costs;
  costs.cpuTime = drawsOnCpu();
  costs.rounds = rounds;
  if (!measured.run(rounds, timedFrame, progress)) return costs;
  const auto without = [&](std::size_t kind) { return measured.without(kind); };
  costs.frame = costOf(measured.whole());
  costs.overdraw = costOf(without(ownDepth));
  Seconds rest = beyond(without(fragment), without(sky));
  for (const std::size_t kind : {reflection, lamps, material, output}) rest = beyond(rest, without(kind));
  const auto row = [&costs](const char* name, const char* help, const Seconds& times) {
    costs.parts.push_back({name, help, costOf(times)});
  };
  row("reflection", "light of probes and sky: projection, lookups, harmonics, weights", without(reflection));
  row("light loop", "lamps, their shadows by coverage included", without(lamps));
  row("material", "textures and normal maps", without(material));
  row("output", "conversion to display colours", without(output));
  row("other shading", "what is left of the pixels' programs: normals, the view vector, the split sum", rest);
  row("pixels", "pixels found, tested for depth and written, of one colour",
      beyond(without(raster), without(fragment)));
  row("vertices", "vertices and VTK's calls for each object", beyond(without(empty), without(raster)));
  row("sky", "the sky behind everything", without(sky));
  row("ambient occlusion", "what the scene hides of its own sky, if it is asked to", without(openness));
  row("ground shadow", "the soft shadow below everything, if the scene has it", without(ground));
  row("window", "a frame of nothing: cleared, samples resolved, VTK's own work", measured.of(empty));
  for (std::size_t i = 0; i < ofPrograms.size(); ++i) {
    FrameCosts::Program program{{}, costOf(without(ofPrograms[i]))};
    for (const auto& object : programs[i].objects) program.objects.push_back(object.node);
    costs.programs.push_back(std::move(program));
  }
  for (std::size_t i = 0; i < objects.size(); ++i) {
    costs.objects.push_back({objects[i].node, "", costOf(without(ofObjects[i]))});
  }
  const auto more = [](const auto& a, const auto& b) { return a.cost.median > b.cost.median; };
  std::stable_sort(costs.programs.begin(), costs.programs.end(), more);
  std::stable_sort(costs.objects.begin(), costs.objects.end(), more);
  return costs;
}

double timedFrameOf(vtkOpenGLRenderWindow* window) {
  using Clock = std::chrono::steady_clock;
  window->MakeCurrent();
  const bool software = drawsOnCpu();
  const double cpu = processCpuSeconds();
  const auto start = Clock::now();
  window->Render();
  window->WaitForCompletion();
  return software ? processCpuSeconds() - cpu : std::chrono::duration<double>(Clock::now() - start).count();
}

nlohmann::ordered_json frameCostsJson(const FrameCosts& costs) {
  const double frame = costs.frame.median;
  nlohmann::ordered_json json;
  json["clock"] = costs.cpuTime ? "cpu" : "elapsed";
  json["rounds"] = costs.rounds;
  json["frame"] = costJson(costs.frame, frame);
  json["overdraw"] = costJson(costs.overdraw, frame);
  for (const char* list : {"parts", "programs", "objects"}) json[list] = nlohmann::ordered_json::array();
  for (const FrameCosts::Row& row : costs.parts) {
    json["parts"].push_back({{"part", row.name}});
    json["parts"].back().update(costJson(row.cost, frame));
  }
  for (const FrameCosts::Program& program : costs.programs) {
    json["programs"].push_back({{"objects", program.objects}});
    json["programs"].back().update(costJson(program.cost, frame));
  }
  for (const FrameCosts::Row& row : costs.objects) {
    json["objects"].push_back({{"name", row.name}});
    json["objects"].back().update(costJson(row.cost, frame));
  }
  return json;
}

std::string frameCostsText(const FrameCosts& costs) {
  const auto line = [&costs](const Cost& cost, const std::string& name) {
    char text[96];
    const double share = costs.frame.median > 0.0 ? 100.0 * cost.median / costs.frame.median : 0.0;
    std::snprintf(text, sizeof text, "  %8.2f ms  (%.2f to %.2f)  %4.0f %%  ", cost.median, cost.low, cost.high, share);
    return text + name + "\n";
  };
  std::string text = "costs of the frame, " +
                     std::string(costs.cpuTime ? "CPU time of all threads" : "elapsed time on the graphics card") +
                     ": median of " + std::to_string(costs.rounds) + ", and quartiles\n";
  text += line(costs.frame, "the frame");
  for (const FrameCosts::Row& row : costs.parts) text += line(row.cost, row.name + ": " + row.help);
  text += line(costs.overdraw, "of all that, for pixels that something else then covers");
  text += "by program, what its pixels take\n";
  for (const FrameCosts::Program& program : costs.programs) text += line(program.cost, joined(program.objects));
  text += "by object, what its pixels take\n";
  for (const FrameCosts::Row& row : costs.objects) text += line(row.cost, row.name);
  return text;
}

}  // namespace boxprobe
