// bench.json and bench.csv.
#include <cmath>
#include <nlohmann/json.hpp>

#include "filters/core/base/number_text.h"
#include "filters/io/json/json_text.h"
#include "filters/reference/bench/bench_text.h"

namespace boxprobe {

namespace {

double rounded(double value, int digits) {
  const double scale = std::pow(10.0, digits);
  return std::isfinite(value) ? std::round(value * scale) / scale : value;
}

Json parametersJson(const BenchTechnique& technique) {
  Json json = Json::object();
  for (const auto& [name, value] : technique.parameters) {
    std::visit([&, key = name](const auto& v) { json[key] = v; }, value);
  }
  return json;
}

std::string parametersText(const BenchTechnique& technique) {
  std::string text;
  for (const auto& [name, value] : technique.parameters) {
    text += (text.empty() ? "" : ":") + name + "=";
    if (const double* number = std::get_if<double>(&value)) {
      text += numberText(*number);
    } else if (const bool* on = std::get_if<bool>(&value)) {
      text += *on ? "true" : "false";
    } else {
      text += std::get<std::string>(value);
    }
  }
  return text;
}

Json ratioJson(const bench::Ratio& ratio) {
  return {rounded(ratio.low, 4), rounded(ratio.high, 4)};
}

/// By technique and roughness.
const FrameCost* costOf(const BenchResult& result, const BenchRow& row) {
  for (const FrameCost& cost : result.costs) {
    if (cost.technique == row.technique && cost.roughness == row.roughness && !cost.cpuSeconds.a.empty()) return &cost;
  }
  return nullptr;
}

Json identity(const BenchResult& result, std::size_t technique) {
  const BenchTechnique& t = result.techniques[technique];
  return {{"technique", t.id}, {"parameters", parametersJson(t)}, {"label", t.label()}, {"ours", t.ours}};
}

Json rowJson(const BenchResult& result, const BenchRow& row) {
  Json json = identity(result, row.technique);
  json["camera"] = row.camera;
  json["roughness"] = row.roughness;
  json["surface"] = surfaceKindName(row.surface);
  json["reference"] = truthName(row.truth);
  json["pixels"] = row.pixels;
  json["error"] = rounded(row.error, 6);
  json["relativeRmse"] = rounded(row.relativeRmse, 6);
  json["meanTruthSquare"] = row.meanTruthSquare;
  json["flip"] = rounded(row.flip, 6);
  json["brightnessRatio"] = rounded(row.brightnessRatio, 6);
  json["errorRatioToHdrp"] = rounded(row.errorRatioToHdrp, 4);
  json["lookups"] = rounded(row.lookups, 3);
  if (row.noise) {
    json["lowFrequencyShare"] = rounded(row.noise->lowFrequencyShare, 4);
    json["errorAfterBlur"] = rounded(row.noise->errorAfterBlur, 6);
  }
  const FrameCost* cost = costOf(result, row);
  json["frameCpuRatioToBox"] = nullptr;
  if (cost != nullptr) {
    const bench::Ratio cpu = bench::ratioOfMedians(cost->cpuSeconds, 400);
    json["frameCpuRatioToBox"] = rounded(cpu.value, 4);
    json["frameCpuRatioInterval"] = ratioJson(cpu);
    if (!cost->gpuSeconds.a.empty())
      json["frameGpuRatioToBox"] = rounded(bench::ratioOfMedians(cost->gpuSeconds, 400).value, 4);
  }
  return json;
}

Json bucketJson(const BenchResult& result, const EnergyBucket& bucket) {
  Json json = identity(result, bucket.technique);
  json["reference"] = truthName(bucket.truth);
  json["roughness"] = bucket.roughness;
  json["nDotV"] = {bucket.nDotVLow, bucket.nDotVHigh};
  json["brightnessRatio"] = rounded(bucket.brightnessRatio, 5);
  json["pixels"] = bucket.pixels;
  return json;
}

Json summaryJson(const BenchResult& result, const BenchSummary& s) {
  Json json = identity(result, s.technique);
  json["reference"] = truthName(s.truth);
  json["error"] = rounded(s.error, 6);
  json["errorRatioToHdrp"] = rounded(s.errorRatioToHdrp, 4);
  json["relativeRmse"] = rounded(s.relativeRmse, 6);
  json["flip"] = rounded(s.flip, 6);
  json["brightnessRatio"] = rounded(s.brightnessRatio, 5);
  json["lookups"] = rounded(s.lookups, 3);
  json["frameCpuRatioToBox"] = rounded(s.cpuRatioToBox.value, 4);
  json["frameCpuRatioInterval"] = ratioJson(s.cpuRatioToBox);
  if (s.gpuRatioToBox) {
    json["frameGpuRatioToBox"] = rounded(s.gpuRatioToBox->value, 4);
    json["frameGpuRatioInterval"] = ratioJson(*s.gpuRatioToBox);
  }
  json["ownCpuRatioToBox"] = rounded(s.ownCpuRatioToBox, 3);
  json["onFront"] = s.onParetoFront;
  for (const auto& [roughness, error] : s.errorByRoughness) {
    json["errorByRoughness"].push_back({{"roughness", roughness}, {"error", rounded(error, 6)}});
  }
  for (const auto& [kind, error] : s.errorBySurface) json["errorBySurface"][surfaceKindName(kind)] = rounded(error, 6);
  if (s.worstEnergy.pixels > 0) {
    json["worstEnergy"] = {{"roughness", s.worstEnergy.roughness},
                           {"nDotV", {s.worstEnergy.nDotVLow, s.worstEnergy.nDotVHigh}},
                           {"brightnessRatio", rounded(s.worstEnergy.brightnessRatio, 5)}};
  }
  return json;
}

Json studyJson(const BenchResult& result) {
  const StudyPlan& plan = result.study.plan;
  Json json = {
      {"rooms", plan.rooms}, {"points", result.study.points}, {"faceSize", plan.faceSize}, {"seed", plan.seed}};
  json["rows"] = Json::array();
  for (const StudyRow& row : result.study.rows) {
    Json entry = identity(result, row.technique);
    entry["error"] = rounded(row.tally.rmse, 6);
    entry["relativeRmse"] = rounded(row.tally.relativeRmse, 6);
    for (const double e : row.tally.rmseByRoughness) entry["errorByRoughness"].push_back(rounded(e, 6));
    for (const double l : row.tally.light) entry["brightnessRatios"].push_back(rounded(l, 4));
    json["rows"].push_back(entry);
  }
  return json;
}

}  // namespace

std::string benchJson(const BenchResult& result) {
  Json json = {
      {"scene", result.scene},
      {"complete", result.complete},
      {"machine", {{"processor", result.machine}, {"glRenderer", result.glRenderer}, {"glVersion", result.glVersion}}},
      {"pictures", {{"width", result.width}, {"height", result.height}}},
      {"frames", {{"width", result.timedWidth}, {"height", result.timedHeight}, {"camera", result.timedCamera}}},
      {"seed", result.seed},
      {"remarks", result.remarks}};
  json["references"] = Json::array();
  for (const TruthNoise& noise : result.truthNoise) {
    json["references"].push_back({{"camera", noise.camera},
                                  {"roughness", noise.roughness},
                                  {"reference", truthName(noise.truth)},
                                  {"standardError", rounded(noise.standardError, 6)},
                                  {"raysPerPixel", rounded(noise.raysPerPixel, 1)}});
  }
  json["summary"] = Json::array();
  for (const Truth truth : kTruths) {
    for (const BenchSummary& s : summaries(result, truth)) json["summary"].push_back(summaryJson(result, s));
  }
  json["rows"] = Json::array();
  for (const BenchRow& row : result.rows) json["rows"].push_back(rowJson(result, row));
  json["energy"] = Json::array();
  for (const EnergyBucket& bucket : result.energy) json["energy"].push_back(bucketJson(result, bucket));
  if (!result.study.rows.empty()) json["study"] = studyJson(result);
  return formatJson(json);
}

std::string benchCsv(const BenchResult& result) {
  std::string text =
      "technique,parameters,camera,roughness,surface,reference,pixels,error,relativeRmse,flip,brightnessRatio,"
      "errorRatioToHdrp,lookups,lowFrequencyShare,errorAfterBlur,frameCpuRatioToBox\n";
  for (const BenchRow& row : result.rows) {
    const BenchTechnique& t = result.techniques[row.technique];
    const auto add = [&text](double value) {
      text += "," + (std::isfinite(value) ? numberText(value) : std::string());
    };
    // A camera may be named anything: quoted, quotes doubled.
    std::string camera;
    for (const char c : row.camera) camera += c == '"' ? std::string("\"\"") : std::string(1, c);
    text += t.id + "," + parametersText(t) + ",\"" + camera + "\"";
    add(row.roughness);
    text += std::string(",") + surfaceKindName(row.surface) + "," + truthName(row.truth);
    add(static_cast<double>(row.pixels));
    for (const double value : {row.error, row.relativeRmse, row.flip, row.brightnessRatio}) add(rounded(value, 6));
    add(rounded(row.errorRatioToHdrp, 4));
    add(rounded(row.lookups, 3));
    if (row.noise) {
      add(rounded(row.noise->lowFrequencyShare, 4));
      add(rounded(row.noise->errorAfterBlur, 6));
    } else {
      text += ",,";
    }
    const FrameCost* cost = costOf(result, row);
    if (cost != nullptr) {
      add(rounded(bench::ratioOfMedians(cost->cpuSeconds, 1).value, 4));
    } else {
      text += ",";
    }
    text += "\n";
  }
  return text;
}

}  // namespace boxprobe
