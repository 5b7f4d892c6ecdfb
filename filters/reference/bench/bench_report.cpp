// Writes report.md: what was measured and how, and the tables.
#include <algorithm>
#include <cmath>
#include <cstdarg>
#include <cstdio>

#include "filters/core/base/number_text.h"
#include "filters/math/technique/parameter_table.h"
#include "filters/reference/bench/bench_text.h"

namespace boxprobe {

namespace {

std::string joined(const std::vector<std::string>& words) {
  std::string text;
  for (const std::string& word : words) text += (text.empty() ? "" : ", ") + word;
  return text;
}

std::vector<BenchSummary> byError(const BenchResult& result, Truth truth) {
  std::vector<BenchSummary> list = summaries(result, truth);
  std::stable_sort(list.begin(), list.end(), [](const auto& a, const auto& b) { return a.error < b.error; });
  return list;
}

double largestNoise(const BenchResult& result, Truth truth) {
  double most = 0.0;
  for (const TruthNoise& noise : result.truthNoise) {
    if (noise.truth == truth) most = std::max(most, noise.standardError);
  }
  return most;
}

std::string measuredText(const BenchResult& result) {
  std::vector<std::string> roughnesses;
  for (const double r : result.roughnesses) roughnesses.push_back(numberText(r));
  std::string text = "# Run time against error: " + result.scene + "\n\n";
  text += formatted(
      "%zu techniques, cameras %s, roughness %s. Errors over pictures of %d x %d pixels, only where a "
      "surface reflects a probe.\n\n",
      result.techniques.size(), joined(result.cameras).c_str(), joined(roughnesses).c_str(), result.width,
      result.height);
  text +=
      "- **error**: root mean square of the difference of (x / (1 + x))^(1/2.2). **/ hdrp**: over that of `hdrp`.\n"
      "- **relative**: root mean square of the difference of linear values over that of the reference. **FLIP**: mean "
      "of LDR-FLIP.\n"
      "- Reference *box*: the integral of the lobe over the probe's box, of the probe's unfiltered capture. Reference "
      "*scene*: the traced scene, one bounce.\n"
      "- **frame**: CPU time of all threads over that of plain box projection, drawn in turn, ratio of medians, mean "
      "over the roughnesses, its 95 % interval in brackets. **own**: what it adds to a frame without any reflection of "
      "probes, over what plain box projection adds.\n"
      "- **light**: mean over the reference's; **worst**: in the bucket of roughness and N.V that is most off.\n"
      "- Bold: on the front, no other technique is both cheaper and better. \\*: this project's own.\n\n";
  text += formatted("Frames of %d x %d through camera %s. OpenGL: %s, %s; anisotropy %d. Processor: %s.\n",
                    result.timedWidth, result.timedHeight, result.timedCamera.c_str(), result.glRenderer.c_str(),
                    result.glVersion.c_str(), result.anisotropy, result.machine.c_str());
  text += formatted("Standard error of the references, tone-mapped: box at most %.5f, scene at most %.5f.\n",
                    largestNoise(result, Truth::Box), largestNoise(result, Truth::Scene));
  text +=
      "Energy: single-scatter GGX with the split sum; a renderer with multiple scattering is brighter at roughness "
      "0.5 and above.\n";
  for (const std::string& remark : result.remarks) text += "Left out: " + remark + ".\n";
  return text + "\n";
}

std::string nameText(const BenchResult& result, const BenchSummary& s) {
  const BenchTechnique& t = result.techniques[s.technique];
  const std::string name = t.label() + (t.ours ? " \\*" : "");
  return s.onParetoFront ? "**" + name + "**" : name;
}

std::string mainTable(const BenchResult& result, const std::vector<BenchSummary>& list) {
  const bool gpu = std::any_of(list.begin(), list.end(), [](const auto& s) { return s.gpuRatioToBox.has_value(); });
  std::string text = std::string("| technique | lookups | frame | own |") + (gpu ? " GPU |" : "") +
                     " error | / hdrp | relative | FLIP | light | worst (roughness, N.V) |\n|---|---|---|---|" +
                     (gpu ? "---|" : "") + "---|---|---|---|---|---|\n";
  for (const BenchSummary& s : list) {
    text += "| " + nameText(result, s) +
            formatted(" | %.1f | %.2f (%.2f to %.2f) | %.2f |", s.lookups, s.cpuRatioToBox.value, s.cpuRatioToBox.low,
                      s.cpuRatioToBox.high, s.ownCpuRatioToBox);
    if (gpu) text += s.gpuRatioToBox ? formatted(" %.2f |", s.gpuRatioToBox->value) : " |";
    text += formatted(" %.4f | %.2f | %.3f | %.4f | %.3f |", s.error, s.errorRatioToHdrp, s.relativeRmse, s.flip,
                      s.brightnessRatio);
    text += s.worstEnergy.pixels > 0 ? formatted(" %.3f (%s, %.2f to %.2f) |\n", s.worstEnergy.brightnessRatio,
                                                 numberText(s.worstEnergy.roughness).c_str(), s.worstEnergy.nDotVLow,
                                                 s.worstEnergy.nDotVHigh)
                                     : std::string(" |\n");
  }
  return text + "\n";
}

std::string roughnessTable(const BenchResult& result, const std::vector<BenchSummary>& list) {
  std::string text = "| technique |", line = "|---|";
  for (const double r : result.roughnesses) {
    text += " " + numberText(r) + " |";
    line += "---|";
  }
  for (const SurfaceKind kind : kSurfaceKinds) {
    text += std::string(" ") + surfaceKindName(kind) + " |";
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const BenchSummary& s : list) {
    text += "| " + nameText(result, s) + " |";
    for (const double r : result.roughnesses) {
      const auto found = s.errorByRoughness.find(r);
      text += found != s.errorByRoughness.end() ? formatted(" %.4f |", found->second) : " |";
    }
    for (const SurfaceKind kind : kSurfaceKinds) {
      const auto found = s.errorBySurface.find(kind);
      text += found != s.errorBySurface.end() ? formatted(" %.4f |", found->second) : " |";
    }
    text += "\n";
  }
  return text + "\n";
}

std::string energyTable(const BenchResult& result, Truth truth) {
  std::vector<EnergyBucket> buckets;
  for (const EnergyBucket& bucket : result.energy) {
    if (bucket.truth == truth && bucket.pixels >= kLeastBucketPixels) buckets.push_back(bucket);
  }
  std::map<std::pair<double, double>, std::map<std::size_t, double>> columns;
  for (const EnergyBucket& b : buckets) columns[{b.roughness, b.nDotVLow}][b.technique] = b.brightnessRatio;
  std::string text = "| roughness, N.V |", line = "|---|";
  std::vector<std::size_t> shown;
  for (std::size_t i = 0; i < result.techniques.size(); ++i) {
    const BenchTechnique& t = result.techniques[i];
    if (!t.ours && t.id != kErrorBaseline && t.id != kCostBaseline) continue;
    shown.push_back(i);
    text += " " + t.label() + " |";
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const auto& [key, values] : columns) {
    text += "| " + numberText(key.first) + formatted(", %.2f to %.2f |", key.second, key.second + 0.25);
    for (const std::size_t i : shown) {
      const auto found = values.find(i);
      text += found != values.end() ? formatted(" %.3f |", found->second) : " |";
    }
    text += "\n";
  }
  return text + "\n";
}

std::string noiseTable(const BenchResult& result) {
  struct Mean {
    double share = 0.0, error = 0.0, blurred = 0.0, pixels = 0.0;
  };
  std::map<std::size_t, Mean> means;
  for (const BenchRow& row : result.rows) {
    if (!row.noise || row.truth != Truth::Box || row.roughness == 0.0) continue;
    Mean& mean = means[row.technique];
    const auto n = static_cast<double>(row.pixels);
    mean.share += n * row.noise->lowFrequencyShare;
    mean.error += n * row.error * row.error;
    mean.blurred += n * row.noise->errorAfterBlur * row.noise->errorAfterBlur;
    mean.pixels += n;
  }
  if (means.empty()) return {};
  std::string text =
      "## Noise of the sampled techniques\n\nShare of the error's power below an eighth of a cycle per pixel (white "
      "noise: 0.05), and the error before and after a blur of 3 x 3 pixels; roughness 0 apart.\n\n"
      "| technique | low frequencies | error | after blur |\n|---|---|---|---|\n";
  for (const auto& [technique, mean] : means) {
    text += "| " + result.techniques[technique].label() +
            formatted(" | %.3f | %.4f | %.4f |\n", mean.share / mean.pixels, std::sqrt(mean.error / mean.pixels),
                      std::sqrt(mean.blurred / mean.pixels));
  }
  return text + "\n";
}

/// Random rooms: error, linear error and light, by roughness and view.
std::string studyTables(const BenchResult& result) {
  const StudyResult& study = result.study;
  double hdrp = 0.0;
  for (const StudyRow& row : study.rows) {
    const BenchTechnique& t = result.techniques[row.technique];
    if (t.id == kErrorBaseline && t.parameters.empty()) hdrp = row.tally.rmse;
  }
  if (!(hdrp > 0.0)) return {};
  std::vector<const StudyRow*> rows;
  for (const StudyRow& row : study.rows) rows.push_back(&row);
  std::stable_sort(rows.begin(), rows.end(), [](auto a, auto b) { return a->tally.rmse < b->tally.rmse; });
  std::string text = "## In random rooms\n\n" +
                     formatted(
                         "%zu points of floors, walls and things in %d rooms that are boxes, faces of %d texels, "
                         "against the integral over the box (%d rays); none of them used for fitting. Columns: "
                         "error at a roughness near that; **light**: in the bucket most off, in brackets its standard "
                         "error by the rooms' "
                         "scatter.\n\n",
                         study.points, study.plan.rooms, study.plan.faceSize, study.plan.rays) +
                     "| technique | error | / hdrp | relative | 0.07 | 0.2 | 0.4 | 0.6 | 0.8 | 1 | light |\n"
                     "|---|---|---|---|---|---|---|---|---|---|---|\n";
  for (const StudyRow* row : rows) {
    const BenchTechnique& t = result.techniques[row->technique];
    text += "| " + t.label() + (t.ours ? " \\*" : "") +
            formatted(" | %.4f | %.3f | %.3f |", row->tally.rmse, row->tally.rmse / hdrp, row->tally.relativeRmse);
    for (const double e : row->tally.rmseByRoughness) text += formatted(" %.4f |", e);
    const std::size_t off = row->tally.mostOff();
    text += formatted(" %.3f (%.3f) |\n", row->tally.light[off], row->tally.lightError[off]);
  }
  text +=
      "\nLight relative to the reference, seen from above (N.V above 0.7), obliquely and at grazing angles (below "
      "0.35):\n\n| technique |";
  std::string line = "|---|";
  for (const char* roughness : {"0.07", "0.2", "0.4", "0.6", "0.8", "1"}) {
    text += std::string(" ") + roughness + " |";
    line += "---|";
  }
  text += "\n" + line + "\n";
  for (const StudyRow* row : rows) {
    const BenchTechnique& t = result.techniques[row->technique];
    if (!t.ours && t.id != kErrorBaseline && t.id != kCostBaseline) continue;
    text += "| " + t.label() + " |";
    for (std::size_t b = 0; b < row->tally.light.size(); b += study::kAngles)
      text += formatted(" %.3f %.3f %.3f |", row->tally.light[b], row->tally.light[b + 1], row->tally.light[b + 2]);
    text += "\n";
  }
  return text + "\n";
}

}  // namespace

std::string formatted(const char* format, ...) {
  char buffer[512];
  va_list arguments;
  va_start(arguments, format);
  std::vsnprintf(buffer, sizeof(buffer), format, arguments);
  va_end(arguments);
  return buffer;
}

std::string benchReport(const BenchResult& result) {
  std::string text = measuredText(result);
  for (const Truth truth : kTruths) {
    const std::vector<BenchSummary> list = byError(result, truth);
    text += std::string("## Against the ") + truthName(truth) + "\n\n" + mainTable(result, list);
    text += "Error by roughness, and by surface:\n\n" + roughnessTable(result, list);
  }
  text += "## Light against the box reference, by roughness and view angle\n\n" + energyTable(result, Truth::Box);
  return text + studyTables(result) + noiseTable(result) + benchAutomaticText(result) + benchMeasuredRows(result);
}

}  // namespace boxprobe
