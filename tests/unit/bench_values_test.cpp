// The benchmark's files word by word for a result in which no two numbers are the same, and a small study of random
// rooms, against bench_values.txt.
#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <limits>
#include <sstream>

#include "filters/core/base/errors.h"
#include "filters/reference/bench/bench_result.h"
#include "filters/reference/bench/bench_surfaces.h"
#include "filters/reference/bench/bench_text.h"
#include "tests/support/kept_values.h"

namespace boxprobe {
namespace {

using test::keptNumbers;

BenchResult oddResult() {
  BenchResult result;
  result.scene = "odd \"room\"";
  result.machine = "a processor";
  result.glRenderer = "a renderer";
  result.glVersion = "4.5";
  result.anisotropy = 16;
  result.width = 201;
  result.height = 113;
  result.timedWidth = 641;
  result.timedHeight = 363;
  result.timedCamera = "main";
  result.seed = 5;
  result.cameras = {"main", "a \"low\" one"};
  result.roughnesses = {0.0, 0.05, 0.25, 0.7};
  result.techniques =
      chooseBenchTechniques("godot:power=2,footprint4,auto:budget=0.03,raytraced:samples=16:filtered=true");
  result.remarks = {"what was left out", "and what else"};
  result.complete = true;
  std::size_t number = 0;
  for (std::size_t t = 0; t < result.techniques.size(); ++t) {
    for (std::size_t k = 0; k < result.roughnesses.size(); ++k) {
      for (const Truth truth : kTruths) {
        const double n = static_cast<double>(++number);
        BenchRow row;
        row.technique = t;
        row.camera = result.cameras[number % 2];
        row.roughness = result.roughnesses[k];
        row.surface = number % 3 == 0 ? SurfaceKind::NormalMapped : SurfaceKind::Smooth;
        row.truth = truth;
        row.pixels = 100 + 37 * number;
        // At the second roughness the study's errors are the larger ones.
        row.error = k == 1 ? 0.0001 * n : 0.001 * n + 0.0123 * static_cast<double>(k);
        row.relativeRmse = 0.002 * n;
        row.meanTruthSquare = 0.25 + 0.01 * n;
        row.flip = 0.0031 * n;
        row.brightnessRatio = 0.9 + 0.007 * n;
        row.errorRatioToHdrp = number % 5 == 0 ? std::numeric_limits<double>::quiet_NaN() : 0.4 + 0.03 * n;
        row.lookups = 1.0 + 0.17 * n;
        if (result.techniques[t].sampled()) row.noise = NoiseFigures{0.03 + 0.001 * n, 0.004 + 0.0007 * n};
        result.rows.push_back(row);
        EnergyBucket bucket{t,
                            truth,
                            row.roughness,
                            0.25 * static_cast<double>(k),
                            0.25 * static_cast<double>(k + 1),
                            0.8 + 0.011 * n,
                            150 + 20 * number};
        result.energy.push_back(bucket);
      }
      const double n = static_cast<double>(t + 1) + 0.3 * static_cast<double>(k);
      FrameCost cost{t, result.roughnesses[k], {}, {}};
      for (int i = 0; i < 5; ++i) {
        cost.cpuSeconds.a.push_back(0.1 * n + 0.001 * i);
        cost.cpuSeconds.b.push_back(0.1 + 0.0007 * i);
        if (t % 2 == 1) {
          cost.gpuSeconds.a.push_back(0.02 * n + 0.0003 * i);
          cost.gpuSeconds.b.push_back(0.03 + 0.0002 * i);
        }
      }
      if (t != 3) result.costs.push_back(cost);
    }
  }
  for (std::size_t k = 0; k < result.roughnesses.size(); ++k) {
    PlainFrameCost plain{result.roughnesses[k], {}};
    for (int i = 0; i < 5; ++i) {
      plain.cpuSeconds.a.push_back(0.06 + 0.002 * static_cast<double>(k) + 0.0004 * i);
      plain.cpuSeconds.b.push_back(0.1 + 0.0005 * i);
    }
    result.plainCosts.push_back(plain);
    for (const Truth truth : kTruths) {
      const double n = 1.0 + static_cast<double>(k) + (truth == Truth::Scene ? 0.4 : 0.0);
      result.truthNoise.push_back({result.cameras[k % 2], result.roughnesses[k], truth, 0.00031 * n, 512.0 * n});
    }
  }
  return result;
}

/// Numbers as words of their own.
void addLines(const std::string& title, std::string text, std::vector<std::string>& lines) {
  for (const char c : {',', '|', '(', ')', '[', ']', '{', '}', ':', '"'}) {
    std::string spaced;
    for (const char each : text) spaced += each == c ? std::string(" ") + c + " " : std::string(1, each);
    text = spaced;
  }
  lines.push_back("-- " + title);
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) {
    std::istringstream words(line);
    std::string joined;
    for (std::string word; words >> word;) joined += (joined.empty() ? "" : " ") + word;
    lines.push_back(joined);
  }
}

// The random rooms come from the library's distributions, which are others elsewhere.
#ifdef __GLIBCXX__

TEST(BenchValues, OfFilesAndOfASmallStudy) {
  BenchResult result = oddResult();
  std::vector<std::string> lines;
  addLines("without a study: json", benchJson(result), lines);
  addLines("csv", benchCsv(result), lines);
  addLines("report", benchReport(result), lines);

  StudyPlan plan;
  plan.rooms = 5;
  plan.pointsEach = 8;
  plan.faceSize = 16;
  plan.rays = 96;
  plan.seed = 3;
  std::vector<double> progress;
  result.study = runStudy(plan, result.techniques, [&progress](double done) {
    progress.push_back(done);
    return true;
  });
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_EQ(result.study.points, 5u * 8u * 6u);
  for (const StudyRow& row : result.study.rows) {
    std::string line = "study " + result.techniques[row.technique].label() +
                       keptNumbers(row.tally.rmse, row.tally.relativeRmse, row.tally.worstLight(), row.tally.mostOff());
    for (const double e : row.tally.rmseByRoughness) line += keptNumbers(e);
    for (std::size_t b = 0; b < study::kBuckets; ++b) line += keptNumbers(row.tally.light[b], row.tally.lightError[b]);
    lines.push_back(line);
  }
  // Of the report what the study adds; its numbers are rounded there.
  const std::string report = benchReport(result);
  const std::size_t added = report.find("## In random rooms");
  ASSERT_NE(added, std::string::npos);
  addLines("with a study", report.substr(added), lines);
  for (const Truth truth : kTruths) {
    for (const ParetoPoint& point : paretoPoints(result, truth)) {
      lines.push_back("point " + point.id + " '" + point.label + "'" +
                      keptNumbers(point.cost, point.error, point.ours, point.onParetoFront));
    }
  }
  test::expectKeptValues("unit/values/bench_values.txt", lines, 1e-3);

  // Stopped before anything is measured, and in the middle.
  EXPECT_TRUE(runStudy(plan, result.techniques, [](double) { return false; }).rows.empty());
  EXPECT_EQ(runStudy(plan, result.techniques, [](double done) { return done < 0.6; }).rows.size(), 2u);
  plan.rooms = 0;
  EXPECT_EQ(runStudy(plan, result.techniques, {}).points, 0u);
}

#endif

std::shared_ptr<const Model> paints() {
  const auto model = std::make_shared<Model>();
  const auto add = [&model](const char* name, const std::function<void(Material&)>& set) {
    Material material;
    material.name = name;
    material.metallic = 0.0f;
    material.roughness = 0.9f;
    set(material);
    model->materials.push_back(material);
  };
  const auto metal = [](Material& m, const glm::vec3& color) {
    m.metallic = 1.0f;
    m.baseColor = glm::vec4(color, 1.0f);
  };
  add("matte", [](Material&) {});
  add("gold", [&](Material& m) { metal(m, {1.0f, 0.7f, 0.1f}); });
  add("black metal", [&](Material& m) { metal(m, {0.02f, 0.01f, 0.099f}); });
  add("blue metal", [&](Material& m) { metal(m, {0.0f, 0.0f, 0.101f}); });
  add("half a metal", [&](Material& m) {
    metal(m, {0.15f, 0.15f, 0.15f});
    m.metallic = 0.5f;
    m.roughness = 0.1f;
  });
  add("coated", [](Material& m) { m.coat = 0.01f; });
  add("glossy", [](Material& m) { m.roughness = 0.49f; });
  add("less glossy", [](Material& m) { m.roughness = 0.5f; });
  add("lamp", [&](Material& m) {
    metal(m, {1.0f, 1.0f, 1.0f});
    m.unlit = true;
  });
  add("bumpy", [](Material& m) {
    m.coat = 1.0f;
    m.normalTexture.image = std::make_shared<ImageRgba8>();
  });
  return model;
}

std::string namesOf(const std::map<std::string, SurfaceKind>& materials) {
  std::string names;
  for (const auto& [name, kind] : materials) names += name + (kind == SurfaceKind::Smooth ? ";" : " bumps;");
  return names;
}

TEST(BenchSurfaces, ThatReflectEnoughAreMeasured) {
  Scene scene;
  const auto found = [&] { return namesOf(reflectingMaterials(scene, {paints()})); };
  EXPECT_EQ(found(), "blue metal;bumpy bumps;coated;glossy;gold;");
  scene.materials["matte"].roughness = 0.3f;
  scene.materials["bumpy"].normalScale = 0.0f;
  scene.materials["coated"].coat = 0.0f;
  scene.materials["gold"].metallic = 0.05f;
  scene.materials["black metal"].baseColor = glm::vec3(0.3f, 0.0f, 0.0f);
  EXPECT_EQ(found(), "black metal;blue metal;bumpy;glossy;matte;");
  const auto all = reflectingMaterials(Scene(), {paints()});
  EXPECT_EQ(onlyMaterials(all, {}), all);
  EXPECT_EQ(namesOf(onlyMaterials(all, {"gold", "bumpy"})), "bumpy bumps;gold;");
  try {
    onlyMaterials(all, {"gold", "matte"});
    ADD_FAILURE() << "matte reflects nothing";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "--materials matte: no reflecting material of that name; the scene has: blue metal, bumpy, coated, "
                 "glossy, gold");
  }
}

TEST(BenchSurfaces, HaveOneRoughnessAndTechnique) {
  Scene scene;
  scene.materials["matte"].roughness = 0.9f;
  scene.probes.resize(2);
  scene.probes[1].bounces = 3;
  const Scene rough = withRoughness(scene, {{"gold", SurfaceKind::Smooth}, {"other", SurfaceKind::Smooth}}, 0.35);
  EXPECT_EQ(rough.materials.at("gold").roughness, 0.35f);
  EXPECT_EQ(rough.materials.at("other").roughness, 0.35f);
  EXPECT_EQ(rough.materials.at("matte").roughness, 0.9f);
  EXPECT_EQ(rough.probes[1].bounces, 1);
  const BenchTechnique technique = chooseBenchTechniques("godot:power=2").front();
  const Scene chosen = withTechnique(scene, technique);
  for (const Probe& probe : chosen.probes) {
    EXPECT_EQ(probe.technique, technique.id);
    EXPECT_EQ(probe.parameters, technique.parameters);
  }
}

TEST(BenchSurfaces, ArePixelsMostlyLitByProbes) {
  std::vector<LitPoint> picture;
  const auto add = [&picture](int x, int y, const char* material, bool hit, const std::vector<float>& weights,
                              bool captured = true) {
    LitPoint point;
    point.x = x;
    point.y = y;
    point.hit = hit;
    point.surface.material = material;
    for (const float weight : weights) {
      ProbeAtPoint probe;
      probe.weight = weight;
      probe.captured = captured;
      point.probes.push_back(probe);
    }
    picture.push_back(point);
  };
  add(3, 0, "gold", true, {0.5f});
  add(4, 1, "bumpy", true, {0.3f, 0.3f});
  add(5, 2, "gold", true, {0.49f});
  add(6, 3, "gold", false, {1.0f});
  add(7, 4, "matte", true, {1.0f});
  add(8, 5, "gold", true, {1.0f}, false);
  add(2, 6, "gold", true, {0.2f, 0.9f});
  const auto pixels =
      measuredPixels(picture, 11, {{"gold", SurfaceKind::Smooth}, {"bumpy", SurfaceKind::NormalMapped}});
  ASSERT_EQ(pixels.size(), 3u);
  EXPECT_EQ(pixels[0].index, 3u);
  EXPECT_EQ(pixels[0].kind, SurfaceKind::Smooth);
  EXPECT_EQ(pixels[1].index, 15u);
  EXPECT_EQ(pixels[1].kind, SurfaceKind::NormalMapped);
  EXPECT_EQ(pixels[1].point.probes.size(), 2u);
  EXPECT_EQ(pixels[2].index, 68u);
}

}  // namespace
}  // namespace boxprobe
