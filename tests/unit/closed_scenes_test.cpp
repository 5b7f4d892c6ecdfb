// The closed scenes, `room`, `gallery` and `six-faces`: that their walls are the probe's box, without a gap, and what
// is painted there.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "filters/core/scene/scene.h"
#include "filters/io/gltf/model_file.h"
#include "filters/io/scene/scene_file.h"
#include "filters/math/shared/shared_math.h"
#include "tests/unit/scene_triangles.h"

namespace boxprobe {
namespace {

const std::string kScenesFolder = scenesFolder();

/// What a scene's probe sees is a closed room: exactly on the box, seen from inside, without a gap.
void expectClosedRoom(const Model& model, const Scene& scene) {
  const Box& box = scene.probes.front().box;
  const auto seen = [&](const Triangle& t) {
    const auto object = scene.objects.find(t.node);
    return object == scene.objects.end() || object->second.seenByProbes;
  };
  double area = 0.0;
  std::map<std::array<double, 6>, int> edges;  // directed; a closed surface has each one once and its reverse once
  for (const Triangle& t : triangles(model)) {
    if (!seen(t)) continue;
    area += glm::length(t.areaVector());
    EXPECT_GT(glm::dot(t.areaVector(), box.center() - t.middle()), 0.0) << t.node << " is seen from outside";
    EXPECT_FALSE(t.surface->doubleSided) << t.node;
    bool inPlane = false;
    for (int axis = 0; axis < 3; ++axis)
      for (double plane : {box.min[axis], box.max[axis]})
        inPlane = inPlane || std::all_of(t.corners.begin(), t.corners.end(),
                                         [&](const glm::dvec3& c) { return c[axis] == plane; });
    ASSERT_TRUE(inPlane) << t.node << " leaves the planes of the box";
    for (std::size_t k = 0; k < 3; ++k) {
      const glm::dvec3 a = t.corners[k], b = t.corners[(k + 1) % 3];
      ++edges[{a.x, a.y, a.z, b.x, b.y, b.z}];
    }
  }
  const glm::dvec3 size = box.size();
  EXPECT_NEAR(area, 2.0 * (size.x * size.y + size.y * size.z + size.z * size.x), 1e-4);
  for (const auto& [edge, count] : edges) {
    ASSERT_EQ(count, 1) << "two triangles lie on each other";
    ASSERT_TRUE(edges.count({edge[3], edge[4], edge[5], edge[0], edge[1], edge[2]}))
        << "a gap along (" << edge[0] << ", " << edge[1] << ", " << edge[2] << ") - (" << edge[3] << ", " << edge[4]
        << ", " << edge[5] << ")";
  }
}

TEST(Room, WallsAreTheBoxAndLeaveNoGap) {
  const Scene scene = loadSceneFile(kScenesFolder + "room.boxprobe.json");
  const Probe& probe = scene.probes.front();
  EXPECT_EQ(probe.box.size(), glm::dvec3(8, 3, 6));
  EXPECT_EQ(probe.blendDistance, (BlendDistance{glm::dvec3(0.0), glm::dvec3(0.0)}));
  EXPECT_EQ(probe.bounces, 2) << "its floor is a mirror, which the balls show";
  EXPECT_THAT(scene.lights, testing::IsEmpty());
  expectClosedRoom(loadModelFile(kScenesFolder + "room.glb"), scene);
}

TEST(Gallery, WhatTheProbeSeesIsTheBoxAndNothingElse) {
  const Scene scene = loadSceneFile(kScenesFolder + "gallery.boxprobe.json");
  EXPECT_EQ(scene.probes.front().box.size(), glm::dvec3(10, 3.5, 7));
  EXPECT_EQ(scene.probes.front().blendDistance, (BlendDistance{glm::dvec3(0.0), glm::dvec3(0.0)}));
  expectClosedRoom(loadModelFile(kScenesFolder + "gallery.glb"), scene);
}

TEST(Room, LampLiesInTheCeilingAndFloorIsPureMetal) {
  const Model model = loadModelFile(kScenesFolder + "room.glb");
  double lamp = 0.0;
  for (const Triangle& t : triangles(model)) {
    if (t.node == "lamp") {
      lamp += glm::length(t.areaVector());
      for (const glm::dvec3& corner : t.corners) EXPECT_EQ(corner.y, 3.0);
      EXPECT_EQ(t.surface->emissive, glm::vec3(50.0f));
      EXPECT_EQ(t.surface->baseColor, glm::vec4(0, 0, 0, 1));
    } else if (t.node == "floor") {
      EXPECT_EQ(t.surface->baseColor, glm::vec4(1.0f));
      EXPECT_EQ(t.surface->metallic, 1.0f);
      EXPECT_EQ(t.surface->roughness, 0.0f);
      EXPECT_FALSE(t.surface->baseColorTexture.image);
    } else if (startsWith(t.node, "wall") || t.node == "ceiling") {
      EXPECT_TRUE(t.surface->unlit) << t.node;
    }
  }
  EXPECT_NEAR(lamp, 1.6 * 1.2, 1e-6);
}

TEST(Room, MuralsAreLinearRadianceInRangeWithSoftEdges) {
  const Model model = loadModelFile(kScenesFolder + "room.glb");
  const auto linear = [](std::uint8_t byte) {
    const double c = byte / 255.0;
    return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
  };
  int pictures = 0;
  for (const Material& material : model.materials) {
    if (!material.baseColorTexture.image) continue;
    ++pictures;
    const ImageRgba8& image = *material.baseColorTexture.image;
    EXPECT_EQ(material.baseColorTexture.wrapS, Wrap::ClampToEdge);
    double least = 1.0, most = 0.0, steepest = 0.0;
    for (int y = 0; y < image.height; ++y) {
      for (int x = 0; x < image.width; ++x) {
        const std::size_t at = static_cast<std::size_t>(y * image.width + x) * 4;
        for (std::size_t channel = 0; channel < 3; ++channel) {
          const double value = linear(image.pixels[at + channel]);
          least = std::min(least, value);
          most = std::max(most, value);
          if (x > 0) steepest = std::max(steepest, std::abs(value - linear(image.pixels[at + channel - 4])));
        }
      }
    }
    EXPECT_GT(least, 0.02) << material.name;
    EXPECT_LT(most, 1.0) << material.name;
    EXPECT_GT(most - least, 0.3) << material.name << ": too flat to show an error";
    EXPECT_LT(steepest, 0.35) << material.name << ": an edge no probe can resolve";
  }
  EXPECT_EQ(pictures, 5);
}

/// What the ray from the room's middle hits, as a material and a place in its picture.
struct Hit {
  const Material* material;
  glm::dvec2 uv;
};
std::optional<Hit> castFromMiddle(const std::vector<Triangle>& scene, const glm::dvec3& direction) {
  for (const Triangle& t : scene) {
    const glm::dvec3 a = t.corners[0], e1 = t.corners[1] - a, e2 = t.corners[2] - a;
    const double determinant = glm::dot(glm::cross(direction, e2), e1);
    if (t.node == "ball" || std::abs(determinant) < 1e-12) continue;
    const double u = glm::dot(glm::cross(direction, e2), -a) / determinant;
    const double v = glm::dot(glm::cross(-a, e1), direction) / determinant;
    const double distance = glm::dot(glm::cross(-a, e1), e2) / determinant;
    if (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && distance > 0.0)
      return Hit{t.surface, (1.0 - u - v) * glm::dvec2(t.uv[0]) + u * glm::dvec2(t.uv[1]) + v * glm::dvec2(t.uv[2])};
  }
  return std::nullopt;
}

TEST(SixFaces, WallsAreTheBoxAndLeaveNoGap) {
  const Scene scene = loadSceneFile(kScenesFolder + "six-faces.boxprobe.json");
  EXPECT_EQ(scene.probes.front().origin, glm::dvec3(0.0));
  EXPECT_EQ(scene.probes.front().box, (Box{glm::dvec3(-2.0), glm::dvec3(2.0)}));
  expectClosedRoom(loadModelFile(kScenesFolder + "six-faces.glb"), scene);
}

TEST(SixFaces, EachWallShowsItsCubeMapFace) {
  // The table of data/scenes/README.md, written out once more on purpose: the generator is what is tested.
  const std::array<glm::dvec3, 6> colors = {{{0.80, 0.08, 0.06},
                                             {0.06, 0.62, 0.66},
                                             {0.10, 0.62, 0.10},
                                             {0.66, 0.08, 0.62},
                                             {0.08, 0.16, 0.85},
                                             {0.85, 0.70, 0.06}}};
  const Model model = loadModelFile(kScenesFolder + "six-faces.glb");
  const std::vector<Triangle> scene = triangles(model);
  const auto expectColor = [&](int face, double s, double t, const glm::dvec3& expected) {
    const glm::vec3 direction = shading::cubeDirection(face, static_cast<float>(s), static_cast<float>(t));
    const std::optional<Hit> hit = castFromMiddle(scene, glm::dvec3(direction));
    ASSERT_TRUE(hit) << "face " << face << ": the ray hits nothing";
    ASSERT_TRUE(hit->material->unlit);
    const ImageRgba8& image = *hit->material->baseColorTexture.image;
    const auto column = static_cast<std::size_t>(hit->uv.x * image.width);
    const auto row = static_cast<std::size_t>(hit->uv.y * image.height);
    const std::size_t texel = 4 * (row * static_cast<std::size_t>(image.width) + column);
    for (std::size_t channel = 0; channel < 3; ++channel) {
      const double byte = image.pixels.at(texel + channel);
      EXPECT_NEAR(std::pow((byte / 255.0 + 0.055) / 1.055, 2.4), expected[static_cast<int>(channel)], 0.01)
          << "face " << face << " at s " << s << ", t " << t << ", channel " << channel;
    }
  };
  for (int face = 0; face < 6; ++face) {
    const glm::dvec3 color = colors[static_cast<std::size_t>(face)];
    for (double a : {0.1, 0.5, 0.95}) {
      expectColor(face, -a, -a, color);
      expectColor(face, a, -a, 0.65 * color);
      expectColor(face, -a, a, 0.4 * color);
      expectColor(face, a, a, 0.2 * color);
    }
    expectColor(face, -0.75, -0.75, glm::dvec3(1.0));
  }
}

TEST(SixFaces, BrightestQuadrantsLieWhereTheReadmeSays) {
  const std::array<glm::dvec3, 6> brightest = {
      {{2, 1, 1}, {-2, 1, -1}, {-1, 2, -1}, {-1, -2, 1}, {-1, 1, 2}, {1, 1, -2}}};
  const Model model = loadModelFile(kScenesFolder + "six-faces.glb");
  const std::vector<Triangle> scene = triangles(model);
  for (const glm::dvec3& point : brightest) {
    const std::optional<Hit> hit = castFromMiddle(scene, point);
    ASSERT_TRUE(hit);
    EXPECT_LT(hit->uv.x, 0.5);
    EXPECT_LT(hit->uv.y, 0.5);
  }
}

}  // namespace
}  // namespace boxprobe
