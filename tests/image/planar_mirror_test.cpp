// Planar mirrors of things that move, in `mirror-hall`: against the truth (a mirrored camera that sees everything, and
// the ray tracer), what is left out and counted, and the same picture by every way it can be drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>

#include "filters/explain/explanation_sections.h"
#include "filters/io/gltf/model_file.h"
#include "filters/reference/light/reference_scene.h"
#include "tests/support/scene_picture.h"
#include "tests/support/shown_light.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 480, kHeight = 270;
constexpr double kWallMirror = -3.99;  // its z

Scene hall(int faceSize = 128) {
  Scene scene = ScenePicture::fromFile("scenes/mirror-hall.boxprobe.json", 8, 8).scene;
  // As the ray tracer: what mirrors show in mirrors is black.
  scene.probes[0].bounces = 1;
  scene.probes[0].faceSize = faceSize;
  return scene;
}

/// One mirror alone: what is left of the others could only be black.
void leaveOneMirror(Scene& scene, const std::string& kept) {
  for (const char* node : {"wall mirror", "floor", "far mirror", "rough plate"}) {
    if (node == kept) continue;
    scene.objects[node].visible = false;
    scene.objects[node].seenByProbes = false;
  }
}

/// Where a node is seen, without its border: it alone is made to glow, and nothing reflects it.
std::vector<bool> pixelsOf(ScenePicture& picture, const Camera& camera, const std::string& material) {
  const Scene kept = picture.scene;
  picture.scene.materials[material].emissive = glm::vec3(1000.0f, 0.0f, 1000.0f);
  picture.renderer->setProbesEnabled(false);
  picture.show(camera);
  const ImageRgbaF image = picture.linear(4);
  picture.scene = kept;
  picture.renderer->setProbesEnabled(true);
  std::vector<bool> inner(image.pixels.size() / 4);
  // All of the pixel's samples, and its neighbours'.
  const auto whole = [&](int x, int y) {
    const std::size_t i = 4 * (static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x));
    return image.pixels[i] > 999.0f && image.pixels[i + 2] > 999.0f;
  };
  for (int y = 1; y + 1 < kHeight; ++y) {
    for (int x = 1; x + 1 < kWidth; ++x) {
      inner[static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x)] =
          whole(x, y) && whole(x - 1, y) && whole(x + 1, y) && whole(x, y - 1) && whole(x, y + 1);
    }
  }
  return inner;
}

ImageRgbaF flippedLeftToRight(const ImageRgbaF& image) {
  ImageRgbaF flipped = image;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (std::size_t c = 0; c < 4; ++c) {
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width);
        flipped.pixels[4 * (row + static_cast<std::size_t>(x)) + c] =
            image.pixels[4 * (row + static_cast<std::size_t>(image.width - 1 - x)) + c];
      }
    }
  }
  return flipped;
}

/// The camera mirrored in the wall mirror. Its picture has left and right exchanged.
Camera behindTheWall(Camera camera) {
  camera.position.z = 2.0 * kWallMirror - camera.position.z;
  camera.target.z = 2.0 * kWallMirror - camera.target.z;
  return camera;
}

/// All of the hall through the mirror, as white as the mirror is.
ImageRgbaF wallTruth(ScenePicture& picture, const Camera& camera) {
  const Scene kept = picture.scene;
  picture.scene.objects["wall mirror"].visible = false;
  picture.scene.objects["wall north"].visible = false;  // the mirrored eye stands behind it
  picture.scene.objects["wall mirror"].seenByProbes = true;
  picture.scene.objects["wall north"].seenByProbes = true;
  picture.show(behindTheWall(camera));
  ImageRgbaF image = flippedLeftToRight(picture.fineLinear());
  picture.scene = kept;
  return image;
}

std::size_t countOf(const std::vector<bool>& mask) {
  return static_cast<std::size_t>(std::count(mask.begin(), mask.end(), true));
}

/// The part of a mask where two pictures differ visibly.
std::vector<bool> where(const std::vector<bool>& mask, const ImageRgbaF& a, const ImageRgbaF& b) {
  std::vector<bool> result(mask.size());
  for (std::size_t i = 0; i < mask.size(); ++i) {
    float most = 0.0f;
    for (std::size_t c = 0; c < 3; ++c) most = std::max(most, std::abs(a.pixels[4 * i + c] - b.pixels[4 * i + c]));
    result[i] = mask[i] && most > 0.01f;
  }
  return result;
}

struct Place {
  const char* camera;
  glm::dvec3 figure, crate;
};

const Place kPlaces[] = {{"main", {0, 0, 0}, {0, 0, 0}},
                         {"main", {1.2, 0, 2.4}, {-2.6, 0, -0.2}},
                         {"near", {-0.4, 0, -1.5}, {-0.6, 0.3, 0.4}},
                         {"near", {1.1, 0.2, 0.4}, {-1.9, 0, 0.9}},
                         {"parallel", {0.3, 0, 0.8}, {-0.5, 0, 0.6}}};

TEST(PlanarMirror, AgainstTheMirroredCameraThatSeesEverything) {
  Scene scene = hall(512);
  leaveOneMirror(scene, "wall mirror");
  ScenePicture picture(scene, kWidth, kHeight);
  for (const Place& place : kPlaces) {
    const Camera camera = cameraNamed(picture.scene, place.camera);
    picture.scene.objects["figure"].translation = place.figure;
    picture.scene.objects["crate"].translation = place.crate;
    const std::vector<bool> mask = pixelsOf(picture, camera, "wall mirror");
    ImageRgbaF truth = wallTruth(picture, camera);
    for (std::size_t i = 0; i < truth.pixels.size(); ++i) truth.pixels[i] *= i % 4 == 3 ? 1.0f : 0.95f;
    picture.show(camera);
    const ImageRgbaF planar = picture.linear();
    EXPECT_EQ(picture.renderer->counters().mirrors.drawn, 1u);
    picture.scene.mirrors["wall mirror"].enabled = false;
    picture.show(camera);
    const ImageRgbaF local = picture.linear();
    EXPECT_EQ(picture.renderer->counters().mirrors.drawn, 0u);
    picture.scene.mirrors["wall mirror"].enabled = true;

    const std::vector<bool> moving = where(mask, planar, local);
    ASSERT_GT(countOf(moving), 800u) << "hardly anything moves in the mirror";
    const double value = psnr(planar, truth, mask), alone = psnr(local, truth, mask);
    std::printf(
        "  camera %-5s %6zu pixels, %5zu of what moves: planar + local %5.2f dB, local alone %5.2f dB; of what "
        "moves %5.2f against %5.2f dB\n",
        place.camera, countOf(mask), countOf(moving), value, alone, psnr(planar, truth, moving),
        psnr(local, truth, moving));
    const std::string name = std::string("planar_") + place.camera + (place.figure.x > 0.5 ? "_2" : "_1");
    keepPicture(truth, name + "_truth");
    keepPicture(planar, name + "_planar");
    keepPicture(local, name + "_local");
    EXPECT_GE(value, 38.0) << place.camera;
    EXPECT_GE(value, alone + 6.0) << place.camera;
  }
}

/// Sum of squared differences of neighbours where both pixels count: falls where edges are blurred.
double sharpness(const ImageRgbaF& image, const std::vector<bool>& mask) {
  double sum = 0.0;
  for (int y = 0; y + 1 < kHeight; ++y) {
    for (int x = 0; x + 1 < kWidth; ++x) {
      const auto at = static_cast<std::size_t>(y) * kWidth + static_cast<std::size_t>(x);
      for (const std::size_t other : {at + 1, at + static_cast<std::size_t>(kWidth)}) {
        if (!mask[at] || !mask[other]) continue;
        for (std::size_t c = 0; c < 3; ++c) {
          const double d = image.pixels[4 * at + c] - image.pixels[4 * other + c];
          sum += d * d;
        }
      }
    }
  }
  return sum;
}

// Where a mirror's lobe is narrower than a pixel, what moves has edges as sharp in it as in the mirrored camera's
// picture.
TEST(PlanarMirror, EdgesOfWhatMovesAreAsSharpAsInTheMirroredCamera) {
  Scene scene = hall(128);
  leaveOneMirror(scene, "wall mirror");
  scene.materials["wall mirror"].roughness = 0.03f;
  ScenePicture picture(scene, kWidth, kHeight);
  const Camera camera = cameraNamed(picture.scene, "near");
  picture.scene.objects["figure"].translation = {-0.4, 0, -1.5};
  picture.scene.objects["crate"].translation = {-0.6, 0.3, 0.4};
  const std::vector<bool> mask = pixelsOf(picture, camera, "wall mirror");
  const auto truthOf = [&](ScenePicture& of) {
    const Scene kept = of.scene;
    for (const char* node : {"wall mirror", "wall north"}) {
      of.scene.objects[node].visible = false;
      of.scene.objects[node].seenByProbes = true;
    }
    of.show(behindTheWall(camera));
    ImageRgbaF image = flippedLeftToRight(of.linear(1));
    of.scene = kept;
    return image;
  };
  const ImageRgbaF truth = truthOf(picture);
  picture.show(camera);
  const ImageRgbaF planar = picture.linear(1);
  picture.scene.mirrors["wall mirror"].enabled = false;
  picture.show(camera);
  const std::vector<bool> moving = where(mask, planar, picture.linear(1));
  ASSERT_GT(countOf(moving), 800u);
  const double ratio = sharpness(planar, moving) / sharpness(truth, moving);
  std::printf("  squared steps over the mirrored camera's: %.3f\n", ratio);
  EXPECT_GE(ratio, 0.75);
  EXPECT_LE(ratio, 1.25);
}

/// What is lit as the ray tracer has it: lights and its own glow, no light from around.
void lightAsTraced(Scene& scene) {
  for (const char* node : {"figure", "crate", "golden ball"}) scene.objects[node].probeUsage = ProbeUsage::Off;
}

ReferenceScene tracerOf(const Scene& scene) {
  std::vector<std::shared_ptr<const Model>> models;
  for (const ModelFile& file : scene.models) models.push_back(std::make_shared<Model>(loadModelFile(file.file)));
  return ReferenceScene(scene, models, nullptr);
}

/// Of a rough mirror's pixel, ray traced: its noise is then below what is compared.
const int kRays = std::getenv("BOXPROBE_TEST_RAYS") != nullptr ? std::atoi(std::getenv("BOXPROBE_TEST_RAYS")) : 64;

struct TracedCase {
  const char* camera;
  const char* mirror;
  float roughness;
  double atLeast, aboveLocal;
};

TEST(PlanarMirror, AgainstTheRayTracer) {
  const TracedCase cases[] = {
      {"main", "wall mirror", 0.0f, 38.0, 10.0}, {"near", "wall mirror", 0.0f, 38.0, 10.0},
      {"floor", "floor", 0.0f, 38.0, 10.0},      {"floor", "floor", 0.1f, 33.0, 8.0},
      {"floor", "floor", 0.3f, 30.5, 2.5},
  };
  for (const TracedCase& c : cases) {
    Scene scene = hall(512);
    leaveOneMirror(scene, c.mirror);
    lightAsTraced(scene);
    scene.materials[c.mirror].roughness = c.roughness;
    ScenePicture picture(scene, kWidth, kHeight);
    const Camera camera = cameraNamed(scene, c.camera);
    ReferenceSettings settings;
    settings.width = kWidth;
    settings.height = kHeight;
    settings.samplesPerPixel = c.roughness > 0.0f ? 1 : 4;
    settings.raysPerPixel = c.roughness > 0.0f ? kRays : 4;
    settings.full = true;
    const ImageRgbaF truth = tracerOf(scene).render(camera, settings).color;
    const std::vector<bool> mask = pixelsOf(picture, camera, c.mirror);
    picture.show(camera);
    const ImageRgbaF planar = picture.linear(settings.samplesPerPixel);
    picture.scene.mirrors[c.mirror].enabled = false;
    picture.show(camera);
    const ImageRgbaF local = picture.linear(settings.samplesPerPixel);
    const std::vector<bool> moving = where(mask, planar, local);
    ASSERT_GT(countOf(moving), 800u);
    const double value = psnr(planar, truth, mask), alone = psnr(local, truth, mask);
    std::printf(
        "  camera %-5s %-11s roughness %.1f: planar + local %5.2f dB, local alone %5.2f dB; of %5zu pixels of "
        "what moves %5.2f against %5.2f dB\n",
        c.camera, c.mirror, c.roughness, value, alone, countOf(moving), psnr(planar, truth, moving),
        psnr(local, truth, moving));
    const std::string name = std::string("traced_") + c.camera + std::to_string(static_cast<int>(10 * c.roughness));
    keepPicture(truth, name + "_truth");
    keepPicture(planar, name + "_planar");
    keepPicture(local, name + "_local");
    EXPECT_GE(value, c.atLeast) << c.camera << " at roughness " << c.roughness;
    EXPECT_GE(value, alone + c.aboveLocal) << c.camera << " at roughness " << c.roughness;
  }
}

// What stands before a figure, seen through the mirror, hides it: the same pixels show it as do in the mirrored
// camera's picture. What the pillars themselves look like there is the probe's business.
TEST(PlanarMirror, WhatStandsStillHidesWhatMoves) {
  Scene scene = hall();
  leaveOneMirror(scene, "wall mirror");
  for (const char* node : {"crate", "golden ball"}) scene.objects[node].visible = false;
  ScenePicture picture(scene, kWidth, kHeight);
  const Camera camera = cameraNamed(scene, "pillars");
  const std::vector<bool> mask = pixelsOf(picture, camera, "wall mirror");
  // Behind the southern pillar as the mirrored eye sees it, and beside it.
  for (const double z : {2.69, 2.2}) {
    picture.scene.objects["figure"].translation = {5.85, 0.0, z};
    picture.scene.objects["figure"].visible = false;
    const ImageRgbaF nobody = wallTruth(picture, camera);
    picture.scene.objects["figure"].visible = true;
    const ImageRgbaF truth = wallTruth(picture, camera);
    picture.scene.mirrors["wall mirror"].enabled = false;
    picture.show(camera);
    const ImageRgbaF local = picture.linear();
    picture.scene.mirrors["wall mirror"].enabled = true;
    picture.scene.objects["pillars"].visible = false;
    picture.scene.objects["pillars"].seenByProbes = true;
    picture.show(camera);
    const std::size_t whole = countOf(where(mask, picture.linear(), local));
    picture.scene.objects.erase("pillars");
    picture.show(camera);
    const ImageRgbaF planar = picture.linear();
    keepPicture(planar, z > 2.5 ? "hidden_planar" : "beside_planar");
    const std::vector<bool> expected = where(mask, truth, nobody), shown = where(mask, planar, local);
    std::size_t wrong = 0;
    for (std::size_t i = 0; i < mask.size(); ++i) wrong += expected[i] != shown[i] ? 1 : 0;
    std::printf("  %zu pixels of the figure without pillars; with them %zu, by the mirrored camera %zu, %zu differ\n",
                whole, countOf(shown), countOf(expected), wrong);
    EXPECT_GT(whole, 200u);
    EXPECT_LE(wrong, 10u);
    if (z > 2.5) {
      EXPECT_LT(countOf(shown), whole / 3);
    }
  }
}

// Every reason not to draw one, each counted.
TEST(PlanarMirror, IsLeftOutWhereItCannotShow) {
  ScenePicture picture(hall(), kWidth, kHeight);
  const Camera camera = cameraNamed(picture.scene, "main");
  const auto drawn = [&] {
    picture.show(camera);
    picture.display();
    return picture.renderer->counters().mirrors;
  };
  MirrorCounters c = drawn();
  EXPECT_EQ(c.drawn, 2u);  // wall mirror and floor
  EXPECT_EQ(c.rough, 1u);
  EXPECT_EQ(c.facingAway + c.notInView, 1u);  // the far one
  EXPECT_GT(c.texels, 0u);
  EXPECT_GT(picture.renderer->frameReport().mirrorBytes, 0u);

  picture.scene.mirrors["floor"].enabled = false;
  c = drawn();
  EXPECT_EQ(c.drawn, 1u);
  EXPECT_EQ(c.disabled, 1u);
  picture.scene.mirrors["floor"].enabled = true;

  // Half of what both take: the larger one on the screen, the floor, is drawn; then not even a coarse one.
  picture.scene.mirrorBudget = 0.6 * static_cast<double>(drawn().texels);
  picture.scene.mirrors["wall mirror"].resolution = 1.0;
  const std::uint64_t both = drawn().texels;
  EXPECT_LE(static_cast<double>(both), picture.scene.mirrorBudget * 1.02);
  picture.scene.mirrorBudget = 100.0;
  c = drawn();
  EXPECT_EQ(c.drawn, 0u);
  EXPECT_EQ(c.overBudget, 2u);
  picture.scene.mirrorBudget = Scene().mirrorBudget;

  // Behind the mirror, and out of its view, nothing moves in it.
  for (const char* node : {"figure", "crate", "golden ball"})
    picture.scene.objects[node].translation = {0.0, 0.0, -40.0};
  picture.scene.mirrors.erase("floor");
  c = drawn();
  EXPECT_EQ(c.drawn, 0u);
  EXPECT_EQ(c.nothingDynamic, 1u);
  EXPECT_EQ(c.texels, 0u);
}

TEST(PlanarMirror, CostsNothingWhereNothingMoves) {
  std::uint64_t programs[2] = {};
  ImageRgba8 shown[2];
  for (const int mirrors : {0, 1}) {
    Scene scene = hall();
    for (const char* node : {"figure", "crate", "golden ball"}) scene.objects[node].dynamic = false;
    if (mirrors == 0) scene.mirrors.clear();
    ScenePicture picture(scene, kWidth, kHeight);
    picture.show(cameraNamed(scene, "main"));
    shown[mirrors] = picture.display();
    programs[mirrors] = picture.renderer->counters().programsCompiled;
    EXPECT_EQ(picture.renderer->counters().mirrors.drawn, 0u);
    EXPECT_EQ(picture.renderer->frameReport().mirrorBytes, 0u);
  }
  EXPECT_EQ(programs[0], programs[1]);
  EXPECT_EQ(shown[0].pixels, shown[1].pixels);
}

TEST(PlanarMirror, MovingCapturesNothingAndIsSeenAtOnce) {
  Scene scene = hall();
  ScenePicture picture(scene, kWidth, kHeight);
  const Camera camera = cameraNamed(scene, "main");
  picture.show(camera);
  const ImageRgba8 before = picture.display();
  const Counters at = picture.renderer->counters();
  for (int step = 1; step <= 4; ++step) {
    Scene next = picture.scene;
    next.objects["figure"].translation.x = 0.2 * step;
    next.objects["crate"].rotationDegrees.y = 10.0 * step;
    picture.renderer->sync(next, difference(picture.scene, next));
    picture.scene = next;
    EXPECT_FALSE(picture.renderer->workPending());
    picture.display();
  }
  EXPECT_NE(picture.display().pixels, before.pixels);
  const Counters& now = picture.renderer->counters();
  EXPECT_EQ(now.facesCaptured, at.facesCaptured);
  EXPECT_EQ(now.levelsFiltered, at.levelsFiltered);
  EXPECT_EQ(now.programsCompiled, at.programsCompiled);
  EXPECT_EQ(now.mirrors.drawn, 2u);
}

// The window, a linear picture of one sample per pixel and of four.
TEST(PlanarMirror, LooksTheSameHoweverItIsDrawn) {
  Scene scene = hall(64);
  scene.probes.push_back(scene.probes[0]);  // two of the same: blended, every pixel looks up both
  scene.probes[1].name = "again";
  scene.probes[1].origin.x += 0.8;
  ScenePicture picture(scene, kWidth, kHeight, 4);
  picture.show(cameraNamed(scene, "main"));
  const ImageRgba8 window = picture.display();
  const ImageRgbaF fine = picture.linear(4), coarse = picture.linear(1);
  double sum = 0.0;
  for (std::size_t i = 0; i < fine.pixels.size(); ++i) {
    if (i % 4 == 3) continue;
    const double d = shownLight(fine.pixels[i]) - window.pixels[i] / 255.0;
    sum += d * d;
  }
  const double shown = -10.0 * std::log10(sum / (0.75 * static_cast<double>(fine.pixels.size())));
  const double sampled = psnr(fine, coarse, {});
  std::printf("  window against linear %.1f dB, one sample against four %.1f dB\n", shown, sampled);
  EXPECT_GE(shown, 36.0);
  EXPECT_GE(sampled, 28.0);
}

TEST(PlanarMirror, IsExplained) {
  Scene scene = hall();
  scene.probes[0].intensity = 0.8;
  for (const char* camera : {"main", "floor", "parallel"}) {
    ScenePicture picture(scene, kWidth, kHeight);
    picture.show(cameraNamed(scene, camera));
    std::vector<glm::ivec2> pixels;
    for (int y = 1; y < kHeight; y += 8) {
      for (int x = 1; x < kWidth; x += 8) pixels.emplace_back(x, y);
    }
    int covered = 0;
    float worst = 0.0f;
    for (const Explanation& e : picture.renderer->explain(pixels, kWidth, kHeight)) {
      if (!e.mirror || e.mirror->coverage < 0.05f) continue;
      ++covered;
      worst = std::max(worst, relativeDifference(e).value_or(0.0f));
    }
    std::printf("  camera %-8s %d pixels with something that moves, computed against rendered %.4f at most\n", camera,
                covered, static_cast<double>(worst));
    EXPECT_GT(covered, 30) << camera;
    EXPECT_LT(worst, 0.02f) << camera;
  }
}

}  // namespace
