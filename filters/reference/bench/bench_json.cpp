// Writes bench.json and bench.csv.
#include <cmath>
#include <nlohmann/json.hpp>

#include "filters/core/base/number_text.h"
#include "filters/io/json/json_text.h"
#include "filters/reference/bench/bench_text.h"

namespace boxprobe {

namespace {

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
  return {roundedTo(ratio.low, 4), roundedTo(ratio.high, 4)};
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
  json["error"] = roundedTo(row.error, 6);
  json["relativeRmse"] = roundedTo(row.relativeRmse, 6);
  json["meanTruthSquare"] = row.meanTruthSquare;
  json["flip"] = roundedTo(row.flip, 6);
  json["brightnessRatio"] = roundedTo(row.brightnessRatio, 6);
  json["errorRatioToHdrp"] = roundedTo(row.errorRatioToHdrp, 4);
  json["lookups"] = roundedTo(row.lookups, 3);
  if (row.noise) {
    json["lowFrequencyShare"] = roundedTo(row.noise->lowFrequencyShare, 4);
    json["errorAfterBlur"] = roundedTo(row.noise->errorAfterBlur, 6);
  }
  const FrameCost* cost = costOf(result, row);
  json["frameCpuRatioToBox"] = nullptr;
  if (cost != nullptr) {
    const bench::Ratio cpu = bench::ratioOfMedians(cost->cpuSeconds, 400);
    json["frameCpuRatioToBox"] = roundedTo(cpu.value, 4);
    json["frameCpuRatioInterval"] = ratioJson(cpu);
    if (!cost->gpuSeconds.a.empty())
      json["frameGpuRatioToBox"] = roundedTo(bench::ratioOfMedians(cost->gpuSeconds, 400).value, 4);
  }
  return json;
}

Json bucketJson(const BenchResult& result, const EnergyBucket& bucket) {
  Json json = identity(result, bucket.technique);
  json["reference"] = truthName(bucket.truth);
  json["roughness"] = bucket.roughness;
  json["nDotV"] = {bucket.nDotVLow, bucket.nDotVHigh};
  json["brightnessRatio"] = roundedTo(bucket.brightnessRatio, 5);
  json["pixels"] = bucket.pixels;
  return json;
}

Json summaryJson(const BenchResult& result, const BenchSummary& s) {
  Json json = identity(result, s.technique);
  json["reference"] = truthName(s.truth);
  json["error"] = roundedTo(s.error, kErrorDigits);
  json["errorRatioToHdrp"] = roundedTo(s.errorRatioToHdrp, 4);
  json["relativeRmse"] = roundedTo(s.relativeRmse, 6);
  json["flip"] = roundedTo(s.flip, 6);
  json["brightnessRatio"] = roundedTo(s.brightnessRatio, 5);
  json["lookups"] = roundedTo(s.lookups, 3);
  json["frameCpuRatioToBox"] = roundedTo(s.cpuRatioToBox.value, kCostDigits);
  json["frameCpuRatioInterval"] = ratioJson(s.cpuRatioToBox);
  if (s.gpuRatioToBox) {
    json["frameGpuRatioToBox"] = roundedTo(s.gpuRatioToBox->value, 4);
    json["frameGpuRatioInterval"] = ratioJson(*s.gpuRatioToBox);
  }
  json["ownCpuRatioToBox"] = roundedTo(s.ownCpuRatioToBox, 3);
  json["onFront"] = s.onParetoFront;
  for (const auto& [roughness, error] : s.errorByRoughness) {
    json["errorByRoughness"].push_back({{"roughness", roughness}, {"error", roundedTo(error, 6)}});
  }
  for (const auto& [kind, error] : s.errorBySurface)
    json["errorBySurface"][surfaceKindName(kind)] = roundedTo(error, 6);
  if (s.worstEnergy.pixels > 0) {
    json["worstEnergy"] = {{"roughness", s.worstEnergy.roughness},
                           {"nDotV", {s.worstEnergy.nDotVLow, s.worstEnergy.nDotVHigh}},
                           {"brightnessRatio", roundedTo(s.worstEnergy.brightnessRatio, 5)}};
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
    entry["error"] = roundedTo(row.tally.rmse, 6);
    entry["relativeRmse"] = roundedTo(row.tally.relativeRmse, 6);
    for (const double e : row.tally.rmseByRoughness) entry["errorByRoughness"].push_back(roundedTo(e, 6));
    for (const double l : row.tally.light) entry["brightnessRatios"].push_back(roundedTo(l, 4));
    json["rows"].push_back(entry);
  }
  return json;
}

}  // namespace

std::string benchJson(const BenchResult& result) {
  Json json = {
      {"scene", result.scene},
      {"complete", result.complete},
      {"machine",
       {{"processor", result.machine},
        {"glRenderer", result.glRenderer},
        {"glVersion", result.glVersion},
        {"anisotropy", result.anisotropy}}},
      {"pictures", {{"width", result.width}, {"height", result.height}}},
      {"frames", {{"width", result.timedWidth}, {"height", result.timedHeight}, {"camera", result.timedCamera}}},
      {"seed", result.seed},
      {"remarks", result.remarks}};
  json["references"] = Json::array();
  for (const TruthNoise& noise : result.truthNoise) {
    json["references"].push_back({{"camera", noise.camera},
                                  {"roughness", noise.roughness},
                                  {"reference", truthName(noise.truth)},
                                  {"standardError", roundedTo(noise.standardError, 6)},
                                  {"raysPerPixel", roundedTo(noise.raysPerPixel, 1)}});
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
    // Camera names may contain anything: quoted, with doubled quotes.
    std::string camera;
    for (const char c : row.camera) camera += c == '"' ? std::string("\"\"") : std::string(1, c);
    text += t.id + "," + parametersText(t) + ",\"" + camera + "\"";
    add(row.roughness);
    text += std::string(",") + surfaceKindName(row.surface) + "," + truthName(row.truth);
    add(static_cast<double>(row.pixels));
    for (const double value : {row.error, row.relativeRmse, row.flip, row.brightnessRatio}) add(roundedTo(value, 6));
    add(roundedTo(row.errorRatioToHdrp, 4));
    add(roundedTo(row.lookups, 3));
    if (row.noise) {
      add(roundedTo(row.noise->lowFrequencyShare, 4));
      add(roundedTo(row.noise->errorAfterBlur, 6));
    } else {
      text += ",,";
    }
    const FrameCost* cost = costOf(result, row);
    if (cost != nullptr) {
      add(roundedTo(bench::ratioOfMedians(cost->cpuSeconds, 1).value, 4));
    } else {
      text += ",";
    }
    text += "\n";
  }
  return text;
}

}  // namespace boxprobe
