// Planar mirrors of things that move, in `mirror-hall`: against the truth (a mirrored camera that sees everything, and
// the ray tracer), what is left out and counted, and the same picture by every way it can be drawn.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <map>

#include "filters/io/model_file.h"
#include "filters/reference/reference_scene.h"
#include "filters/vtk/model_actors.h"
#include "tests/support/scene_picture.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;

constexpr int kWidth = 480, kHeight = 270;
constexpr double kWallMirror = -3.99;  // its z

Scene hall() {
  Scene scene = ScenePicture::fromFile("scenes/mirror-hall.boxprobe.json", 8, 8).scene;
  // As the ray tracer: what mirrors show in mirrors is black.
  scene.probes[0].bounces = 1;
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
ImageRgbaF wallTruth(ScenePicture& picture, const Camera& camera, int samples = 4) {
  const Scene kept = picture.scene;
  picture.scene.objects["wall mirror"].visible = false;
  picture.scene.objects["wall north"].visible = false;  // the mirrored eye stands behind it
  picture.scene.objects["wall mirror"].seenByProbes = true;
  picture.scene.objects["wall north"].seenByProbes = true;
  picture.show(behindTheWall(camera));
  ImageRgbaF image = flippedLeftToRight(picture.linear(samples));
  picture.scene = kept;
  return image;
}

[[maybe_unused]] double difference(const ImageRgbaF& a, const ImageRgbaF& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.pixels.size(); ++i) {
    largest = std::max(largest, static_cast<double>(std::abs(a.pixels[i] - b.pixels[i])));
  }
  return largest;
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
                         {"near", {1.1, 0.2, 0.4}, {-1.9, 0, 0.9}}};

TEST(PlanarMirror, AgainstTheMirroredCameraThatSeesEverything) {
  Scene scene = hall();
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

}  // namespace
