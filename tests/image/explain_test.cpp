// The CPU's account of a pixel agrees with the pixel: random pixels of every scene, through every camera, with every
// technique, several probes and rotated boxes. And the debug view's numbers in the shader are those of the account.
#include <gtest/gtest.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <glm/vector_relational.hpp>
#include <random>

#include "filters/core/scene/surface_view.h"
#include "filters/explain/explanation_text.h"
#include "filters/explain/surface_value.h"
#include "filters/math/technique/technique_table.h"
#include "filters/vtk/rays/ray_sources.h"
#include "filters/vtk/rays/vtkProjectionRays.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

struct Case {
  std::string name;
  Scene scene;
};

Scene fileScene(const std::string& name) {
  Scene scene = ScenePicture::fromFile("scenes/" + name + ".boxprobe.json", 8, 8).scene;
  for (Probe& probe : scene.probes) {
    probe.faceSize = 128;
    probe.bounces = 1;
  }
  return scene;
}

constexpr const char* kPlain = "room, rough";

/// Three probes of two importances side by side over the building, one of them turned, with different techniques.
Scene manyProbes() {
  Scene scene = fileScene("building");
  const Probe room = scene.probes.front();
  scene.probes.clear();
  Probe left = room, right = room, nested = room;
  left.name = "left";
  left.box.max.x = 0.8;
  left.influence.reset();
  left.origin = {-2.0, 1.5, 0.4};
  left.blendDistance = {glm::dvec3(1.5), glm::dvec3(1.5)};
  right.name = "right";
  right.box.min.x = -0.8;
  right.influence.reset();
  right.origin = {2.2, 1.7, -0.3};
  right.rotationDegrees = {0.0, 20.0, 5.0};
  right.technique = "sphere";
  right.intensity = 1.4;
  nested.name = "nested";
  nested.importance = 2.0;
  nested.box = {{-1.5, -0.1, -1.5}, {1.5, 2.0, 1.5}};
  nested.influence.reset();
  nested.blendDistance = {glm::dvec3(0.7), glm::dvec3(0.7)};
  scene.probes = {left, right, nested};
  scene.lights.push_back({LightType::Point, {0, -1, 0}, {1.0, 3.0, 1.0}, {1.0f, 0.8f, 0.6f}, 6.0f});
  return scene;
}

std::vector<Case> cases() {
  std::vector<Case> result = {{"room", fileScene("room")},
                              {"building", fileScene("building")},
                              {"six-faces", fileScene("six-faces")},
                              {"several probes, one turned, a point light", manyProbes()}};
  Scene rough = fileScene("room");
  for (auto& [name, material] : rough.materials) material.roughness = 0.3f;
  rough.materials["floor"].roughness = 0.4f;
  rough.materials["floor"].coat = 0.8f;
  rough.energy = Energy::Multiple;
  rough.lights.push_back({LightType::Point, {0, -1, 0}, {1.0, 2.0, 0.5}, {1.0f, 0.8f, 0.6f}, 2.0f});
  rough.sky = SkyImage{std::string(BOXPROBE_DATA_DIR) + "/scenes/sky.hdr"};
  rough.probes.front().box.max.y *= 0.8;
  rough.probes.front().influence.reset();
  Scene rounded = manyProbes();
  rounded.materials["mirror"].roughness = 0.3f;
  rounded.probes.resize(2);
  for (Probe& probe : rounded.probes) probe.parameters["fresnel"] = std::string("surface");
  rounded.probes[0].bevel = Bevel{0.4, 0.5};
  rounded.probes[1].bevel = Bevel{0.0, 3.0};
  rounded.probes[1].occlusion = BoxOcclusion{0.3, 0.7, 0.8};
  rounded.probes[0].occlusion = BoxOcclusion{0.8, 1.5, 1.0};
  result.push_back({"two probes with rounded edges and box occlusion", rounded});
  Scene plain = fileScene("room");
  for (auto& [name, material] : plain.materials) material.roughness = 0.3f;
  result.push_back({kPlain, plain});
  result.push_back({"room, rough under a clear coat, a lamp, multiple scattering, sky from a picture", rough});
  result.push_back({"windows: open to the sky, sun by coverage, a globe that moves", fileScene("windows")});
  Scene lamps = fileScene("windows");
  lamps.probes.front().rotationDegrees = {0.0, 8.0, 0.0};
  lamps.probes.front().blendDistance = {glm::dvec3(1.0), glm::dvec3(1.0)};
  lamps.lights.push_back({LightType::Point, {0, -1, 0}, {7.0, 2.5, -1.0}, {1.0f, 0.8f, 0.6f}, 90.0f});
  lamps.lights.back().shadows = LightShadows::CoverageAndMap;
  lamps.lights.back().radius = 0.3;
  lamps.lights.front().shadowLevel = ShadowLevel::Distance;
  result.push_back({"windows: turned, a lamp outside beside the sun", lamps});
  return result;
}

struct Chosen {
  std::string technique;
  bool lastChoices;  // of its parameters; else the defaults
};

void choose(Probe& probe, const Chosen& chosen) {
  probe.technique = chosen.technique;
  probe.parameters.clear();
  // The calculation is the same for any number of rays; few are enough.
  const auto read = parametersOf(*parseTechnique(chosen.technique));
  if (std::any_of(read.begin(), read.end(), [](const auto* p) { return p->name == "samples"; })) {
    probe.parameters["samples"] = 5.0;
  }
  if (!chosen.lastChoices) return;
  for (const ParameterRow* row : parametersOf(*parseTechnique(chosen.technique))) {
    if (row->kind == ParameterKind::Choice) probe.parameters[std::string(row->name)] = std::string(row->choices.back());
  }
}

/// Every projection with the plainest evaluation, and every evaluation with the box and with the last projection, by
/// its defaults and its other choices.
std::vector<Chosen> allTechniques() {
  std::vector<Chosen> ids;
  const std::string plain(evaluationRows().front().id), last(projectionRows().back().id);
  for (const ProjectionRow& row : projectionRows()) ids.push_back({std::string(row.id) + "+" + plain, false});
  for (const EvaluationRow& row : evaluationRows()) {
    // What stands alone combines with none.
    const std::string id(row.id);
    const std::string refined = last + "+" + id;
    ids.push_back({id, false});
    if (parseTechnique(refined) && row.parameters.size() < 3) ids.push_back({refined, false});
    const auto read = parametersOf(*parseTechnique(id));
    const bool choices =
        std::any_of(read.begin(), read.end(), [](const auto* p) { return p->kind == ParameterKind::Choice; });
    if (choices) ids.push_back({id, true});
  }
  return ids;
}

TEST(Explain, AgreesWithThePicture) {
  constexpr int kWidth = 480, kHeight = 270;
  constexpr std::size_t kPixels = 100000;
  const std::vector<Case> all = cases();
  std::mt19937 random(7);
  std::size_t compared = 0, beyond = 0, onBox = 0, offBox = 0;
  double worst = 0.0;
  std::string worstText, worstCase;
  struct Work {
    const Case* of;
    Camera camera;
    std::size_t techniques;  // where in the list the probes' techniques start; past its end: the scene's own
  };
  const std::vector<Chosen> techniques = allTechniques();
  std::vector<Work> work;
  for (const Case& c : all) {
    // Two views of each: an evaluation's program is compiled for every scene, which is what takes the time.
    for (std::size_t i = 0; i < std::min<std::size_t>(2, c.scene.cameras.size()); ++i) {
      work.push_back({&c, c.scene.cameras[i], techniques.size()});
    }
    // Every technique on rough surfaces under one probe; where three overlap each has one of its own, once: programs of
    // several techniques take long to compile.
    const bool alone = c.name == kPlain, several = c.scene.probes.size() > 2;
    const std::size_t step = alone ? 1 : techniques.size();
    for (std::size_t t = 0; (alone || several) && t < techniques.size(); t += step) {
      work.push_back({&c, c.scene.cameras.front(), t});
    }
  }
  const std::size_t each = kPixels / work.size() + 1;
  std::unique_ptr<ScenePicture> picture;
  const Case* shown = nullptr;
  for (const Work& w : work) {
    if (w.of != shown) {
      picture = std::make_unique<ScenePicture>(w.of->scene, kWidth, kHeight);
      shown = w.of;
    }
    picture->scene = w.of->scene;
    for (std::size_t i = 0; i < picture->scene.probes.size() && w.techniques < techniques.size(); ++i) {
      choose(picture->scene.probes[i], techniques[(w.techniques + i) % techniques.size()]);
    }
    picture->show(w.camera);
    const ImageRgbaF image = picture->linear(1);
    std::vector<glm::ivec2> pixels;
    for (std::size_t i = 0; i < each; ++i) {
      pixels.emplace_back(random() % kWidth, random() % kHeight);
    }
    for (const Explanation& e : picture->renderer->explain(pixels, kWidth, kHeight)) {
      if (!e.hit) continue;
      const float* p = &image.pixels[static_cast<std::size_t>(e.y * kWidth + e.x) * 4];
      const glm::vec3 drawn(p[0], p[1], p[2]);
      // Relative to the brightest texel fetched; what no texel lights (direct light, emission) to the colour itself.
      const float scale = std::max({e.brightestTexel, e.color.x, e.color.y, e.color.z, 1.0e-3f});
      const glm::vec3 d = glm::abs(drawn - e.color);
      const double error = std::max({d.x, d.y, d.z}) / scale;
      ++compared;
      if (!(error <= 2.0e-3)) ++beyond;
      if (!(error <= worst)) {
        worst = error;
        worstText = explanationText(e);
        worstCase = w.of->name + ", camera " + w.camera.name;
      }
      for (const ProbeExplanation& probe : e.probes) {
        if (!probe.slabFactors || !probe.hitDistance || probe.boxDistance) continue;
        const glm::vec3 size = probe.boxMax - probe.boxMin;
        const glm::vec3 low = glm::abs(probe.lookupDirection - probe.boxMin);
        const glm::vec3 high = glm::abs(probe.lookupDirection - probe.boxMax);
        const glm::vec3 nearest = glm::min(low, high);
        const bool on = std::min({nearest.x, nearest.y, nearest.z}) <= 1.0e-5f * std::max({size.x, size.y, size.z});
        // A start outside the box is pulled on to it only along the axes it is outside of.
        const glm::vec3 slack = 1.0e-5f * size;
        const bool inside = glm::all(glm::greaterThanEqual(probe.positionProbe, probe.boxMin - slack)) &&
                            glm::all(glm::lessThanEqual(probe.positionProbe, probe.boxMax + slack));
        if (inside) ++(on ? onBox : offBox);
      }
    }
  }
  std::printf("  %zu pixels compared, %zu beyond 2e-3 (%.4f %%), worst %.2e (%s):\n%s", compared, beyond,
              100.0 * static_cast<double>(beyond) / static_cast<double>(compared), worst, worstCase.c_str(),
              worstText.c_str());
  std::printf("  %zu hits within 1e-5 of the box's size from it, %zu not\n", onBox, offBox);
  EXPECT_GT(compared, kPixels / 2);
  EXPECT_LE(static_cast<double>(beyond), 1.0e-3 * static_cast<double>(compared));
  EXPECT_GT(onBox, 10000u);
  EXPECT_EQ(offBox, 0u);
}

// While a box is being turned its maps lie along the axes it had before.
TEST(Explain, AgreesWhileABoxIsTurnedAgainstItsMaps) {
  constexpr int kWidth = 160, kHeight = 90;
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 2000; ++i) pixels.emplace_back((i * 37) % kWidth, (i * 53) % kHeight);
  for (const char* technique : {"box+none", "impostor+raytraced", "impostor+footprint4"}) {
    for (const auto& [before, after] : {std::pair(30.0, 50.0), std::pair(20.0, 0.0)}) {
      Scene scene = fileScene("room");
      scene.materials["floor"].roughness = 0.3f;
      scene.probes[0].rotationDegrees.y = before;
      scene.probes[0].technique = technique;
      if (std::string(technique) == "impostor+raytraced") {
        scene.probes[0].parameters = {{"sampling", std::string("luminance")}, {"samples", 8.0}};
      }
      if (std::string(technique) == "impostor+footprint4") scene.probes[0].parameters = {{"steps", 16.0}};
      ScenePicture picture(scene, kWidth, kHeight);
      picture.show(picture.scene.cameras.front());
      picture.scene.probes[0].rotationDegrees.y = after;
      picture.renderer->sync(picture.scene, difference(scene, picture.scene));  // and no work done
      const ImageRgbaF image = picture.linear(1);
      std::size_t compared = 0, beyond = 0;
      for (const Explanation& e : picture.renderer->explain(pixels, kWidth, kHeight)) {
        if (!e.hit || e.probes.empty()) continue;
        EXPECT_GT(glm::length(e.probes[0].mapFromProbe[0] - glm::dvec3(1.0, 0.0, 0.0)), 0.1);
        const float* p = &image.pixels[static_cast<std::size_t>(e.y * kWidth + e.x) * 4];
        const glm::vec3 d = glm::abs(glm::vec3(p[0], p[1], p[2]) - e.color);
        const float scale = std::max({e.brightestTexel, e.color.x, e.color.y, e.color.z, 1.0e-3f});
        ++compared;
        beyond += std::max({d.x, d.y, d.z}) <= 2.0e-3f * scale ? 0 : 1;
      }
      std::printf("  %s, captured at %g degrees, now at %g: %zu of %zu pixels differ\n", technique, before, after,
                  beyond, compared);
      EXPECT_GT(compared, 500u);
      EXPECT_LE(beyond, compared / 500);
    }
  }
}

// A single pixel, which draws the objects under it alone, gives what the whole picture does.
TEST(Explain, OnePixelAlone) {
  ScenePicture picture = ScenePicture::fromFile("scenes/building.boxprobe.json", 64, 64);
  picture.scene.probes.front().faceSize = 64;
  picture.scene.probes.front().bounces = 1;
  picture.show(cameraNamed(picture.scene, "main"));
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 40; ++i) pixels.emplace_back((i * 37) % 320, (i * 53) % 180);
  const auto together = picture.renderer->explain(pixels, 320, 180);
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const Explanation alone = picture.renderer->explain(pixels[i].x, pixels[i].y, 320, 180);
    EXPECT_EQ(alone.hit, together[i].hit);
    EXPECT_EQ(alone.surface.object, together[i].surface.object) << pixels[i].x << "," << pixels[i].y;
    // Rasterized from another corner: positions differ in their last digits, and textures with them.
    EXPECT_LE(glm::length(alone.color - together[i].color), 5.0e-3f * (1.0f + glm::length(alone.color)));
  }
}

// The shader's number and the account's, over a picture of each scene, for every row of the table.
TEST(Views, SameNumbersAsTheExplanation) {
  constexpr int kWidth = 160, kHeight = 90;
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 2000; ++i) pixels.emplace_back((i * 37) % kWidth, (i * 53) % kHeight);
  std::vector<std::size_t> compared(surfaceViews().size()), different = compared, defined = compared;
  for (const Case& c : {Case{"building", fileScene("building")}, Case{"several", manyProbes()}}) {
    ScenePicture picture(c.scene, kWidth, kHeight);
    for (Probe& probe : picture.scene.probes) probe.faceSize = 64;
    picture.scene.materials["floor"].roughness = 0.3f;
    picture.show(picture.scene.cameras.front());
    ImageRgbaF truth{32, 18, {}};  // of no scene: what counts is that both compare with the same
    for (int i = 0; i < 32 * 18; ++i) {
      const auto n = static_cast<float>(i % 29);
      truth.pixels.insert(truth.pixels.end(), {0.2f + 0.03f * n, 0.5f, 0.9f - 0.02f * n, 1.0e-3f * n});
    }
    picture.renderer->setDiffuseTruth(truth);
    const std::vector<Explanation> explanations = picture.renderer->explain(pixels, kWidth, kHeight);
    for (std::size_t view = 1; view < surfaceViews().size(); ++view) {
      const SurfaceViewRow& row = surfaceViews()[view];
      picture.renderer->setView({static_cast<int>(view), {}, {}});
      keepPicture(picture.display(), "view_" + std::string(row.id) + "_" + c.name);
      const ImageRgbaF image = picture.linear(1);
      for (const Explanation& e : explanations) {
        const float* p = &image.pixels[static_cast<std::size_t>(e.y * kWidth + e.x) * 4];
        if (!e.hit) continue;
        const auto value = surfaceValue(row, e);
        ++compared[view];
        defined[view] += value.has_value();
        const glm::vec3 expected = value.value_or(glm::vec3(-1.0f));
        const glm::vec3 d = glm::abs(glm::vec3(p[0], p[1], p[2]) - expected);
        const float scale = std::max(1.0f, glm::length(expected));
        const bool same = std::max({d.x, d.y, d.z}) <= 2.0e-3f * scale;
        different[view] += !same;
        if (!same && different[view] <= 2) {
          std::printf("  %s at %d,%d: shader %g %g %g, explanation %g %g %g\n", c.name.c_str(), e.x, e.y,
                      static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2]),
                      static_cast<double>(expected.x), static_cast<double>(expected.y),
                      static_cast<double>(expected.z));
        }
      }
    }
  }
  for (std::size_t view = 1; view < surfaceViews().size(); ++view) {
    const std::string id(surfaceViews()[view].id);
    std::printf("  %s: %zu of %zu differ, %zu defined\n", id.c_str(), different[view], compared[view], defined[view]);
    // A third of the rays of these open scenes leaves them, and some end where the capture origin does not see: they
    // have no true hit (true_hit_test judges which).
    const bool ofTrueHit = id == "true-distance" || id == "hit-error" || id == "direction-error";
    // Mirrors scatter nothing, and where no probe lights there are no nodes.
    const bool ofDiffuse = id == "diffuse-light" || id == "node-validity" || id == "diffuse-error";
    EXPECT_GT(defined[view], compared[view] / (ofDiffuse ? 4 : ofTrueHit ? 3 : 2)) << id;
    // Where a ray grazes an edge of the box or of what the probe saw, rounding decides between two answers.
    EXPECT_LE(static_cast<double>(different[view]), 5.0e-3 * static_cast<double>(compared[view])) << id;
  }
}

// The filter that works in any pipeline, given the same points, says what the shader's views show.
TEST(Views, TheRayFilterSaysTheSame) {
  constexpr int kWidth = 160, kHeight = 90;
  ScenePicture picture(fileScene("room"), kWidth, kHeight);
  picture.scene.materials["floor"].roughness = 0.4f;
  picture.show(picture.scene.cameras.front());
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 1500; ++i) pixels.emplace_back((i * 37) % kWidth, (i * 53) % kHeight);
  const auto explanations = picture.renderer->explain(pixels, kWidth, kHeight);
  std::vector<RaySample> samples;
  std::vector<const Explanation*> of;
  for (const Explanation& e : explanations) {
    if (!e.hit || e.dominant < 0) continue;
    samples.push_back(
        {e.surface.object, e.surface.positionWorld, glm::dvec3(e.surface.normalWorld), e.surface.roughness});
    of.push_back(&e);
  }
  ASSERT_GT(samples.size(), 500u);
  vtkNew<vtkProjectionRays> rays;
  rays->SetInputData(rayPoints(samples));
  const glm::dvec3 eye = picture.scene.cameras.front().position;
  rays->SetEye(eye.x, eye.y, eye.z);
  rays->SetProbes(picture.scene.probes);
  rays->SetMaximumNumberOfRays(static_cast<int>(samples.size()));
  const BakedMaps maps = picture.renderer->readMaps(picture.scene.probes.front().name).value();
  rays->SetProbeDistances(0, std::make_shared<const CubeMap>(maps.distance));
  rays->Update();
  vtkCellData* cells = rays->GetOutput()->GetCellData();
  const auto number = [&](const char* name, vtkIdType cell, int component = 0) {
    return cells->GetArray(name)->GetComponent(cell, component);
  };
  std::vector<ImageRgbaF> views;
  for (const char* id : {"hit-distance", "face", "level", "true-distance"}) {
    picture.renderer->setView({findSurfaceView(id).value(), {}, {}});
    views.push_back(picture.linear(1));
  }
  std::size_t compared = 0, different = 0;
  for (vtkIdType cell = 0; cell < rays->GetOutput()->GetNumberOfCells(); ++cell) {
    if (number(ray_array::kKind, cell) != static_cast<int>(RayKind::Lookup)) continue;
    const Explanation& e = *of[static_cast<std::size_t>(number(ray_array::kPoint, cell))];
    const auto shown = [&](std::size_t view) {
      return static_cast<double>(views[view].pixels[static_cast<std::size_t>(e.y * kWidth + e.x) * 4]);
    };
    ++compared;
    const auto same = [&](std::size_t view, double value) {
      return std::abs(shown(view) - value) <= 2e-3 * std::max(1.0, std::abs(value));
    };
    different += !(same(0, number(ray_array::kHitDistance, cell)) && same(1, number(ray_array::kFace, cell)) &&
                   same(2, number(ray_array::kLevel, cell)) && same(3, number(ray_array::kTrueDistance, cell)));
  }
  std::printf("  %zu of %zu points differ between filter and shader\n", different, compared);
  EXPECT_GT(compared, 500u);
  EXPECT_LE(static_cast<double>(different), 0.01 * static_cast<double>(compared));
}

TEST(View, CaptureIsOfTheSceneNotOfTheView) {
  ScenePicture plain = ScenePicture::fromFile("scenes/six-faces.boxprobe.json", 64, 64);
  plain.show(plain.scene.cameras.front());
  ScenePicture viewed = ScenePicture::fromFile("scenes/six-faces.boxprobe.json", 64, 64);
  viewed.renderer->setView({1, {}, {}});
  viewed.show(viewed.scene.cameras.front());
  viewed.renderer->setView({0, {}, {}});
  EXPECT_EQ(plain.display().pixels, viewed.display().pixels);
}

// In a room that is its box the true hit is the box's: the distance cubemap's answer is exact on planes.
TEST(Explain, TrueHitInARoomIsTheBoxHit) {
  ScenePicture picture(fileScene("room"), 64, 64);
  picture.show(picture.scene.cameras.front());
  std::vector<glm::ivec2> pixels;
  for (int i = 0; i < 3000; ++i) pixels.emplace_back((i * 37) % 320, (i * 53) % 180);
  std::vector<float> errors;
  std::size_t unknown = 0;
  for (const Explanation& e : picture.renderer->explain(pixels, 320, 180)) {
    for (const ProbeExplanation& p : e.probes) {
      if (!p.hitDistance) continue;
      if (!p.trueDistance) {
        ++unknown;
        continue;
      }
      errors.push_back(std::abs(*p.hitDistance - *p.trueDistance) / glm::length(p.boxMax - p.boxMin));
    }
  }
  ASSERT_GT(errors.size(), 1000u);
  std::sort(errors.begin(), errors.end());
  std::printf("  true hit against box hit: median %.1e of the box's diagonal, 99 %% %.1e, worst %.1e, %zu unknown\n",
              static_cast<double>(errors[errors.size() / 2]), static_cast<double>(errors[errors.size() * 99 / 100]),
              static_cast<double>(errors.back()), unknown);
  EXPECT_LT(errors[errors.size() / 2], 1.0e-4f);
  EXPECT_LT(errors[errors.size() * 95 / 100], 5.0e-3f);
}

}  // namespace
