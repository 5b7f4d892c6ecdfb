// The path tracer against what can be calculated: closed rooms that shine evenly, a lamp over a floor, lights without
// a size, furnaces of every material; and input that breaks path tracers.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <functional>
#include <glm/geometric.hpp>
#include <limits>

#include "filters/reference/path/reference_path.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;
using ::testing::HasSubstr;
using ::testing::IsEmpty;

constexpr double kPi = 3.14159265358979323846;

Material lambert(const glm::vec3& color) {
  Material material;
  material.baseColor = glm::vec4(color, 1.0f);
  material.metallic = 0.0f;
  material.roughness = 1.0f;
  material.specular = 0.0f;
  material.finish.specularEdge = 1.0f;
  return material;
}

void addMesh(Model& model, const std::string& node, std::vector<glm::vec3> positions,
             std::vector<std::uint32_t> indices, const Material& material) {
  Mesh mesh;
  mesh.positions = std::move(positions);
  mesh.indices = std::move(indices);
  mesh.material = static_cast<int>(model.materials.size());
  model.materials.push_back(material);
  model.materials.back().name = node;
  model.instances.push_back({node, static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
  model.meshes.push_back(std::move(mesh));
}

/// Faces along cross(right, up).
void addQuad(Model& model, const std::string& node, const glm::vec3& middle, const glm::vec3& right,
             const glm::vec3& up, const Material& material) {
  addMesh(model, node, {middle - right - up, middle + right - up, middle + right + up, middle - right + up},
          {0, 1, 2, 0, 2, 3}, material);
}

/// Of unequal sides, its faces inwards or outwards.
void addBox(Model& model, const std::string& node, const glm::vec3& low, const glm::vec3& high, bool inwards,
            const Material& material) {
  std::vector<glm::vec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? high.x : low.x, (i & 2) != 0 ? high.y : low.y, (i & 4) != 0 ? high.z : low.z);
  }
  std::vector<std::uint32_t> outwards = {0, 4, 6, 0, 6, 2, 1, 3, 7, 1, 7, 5, 0, 1, 5, 0, 5, 4,
                                         2, 6, 7, 2, 7, 3, 0, 2, 3, 0, 3, 1, 4, 5, 7, 4, 7, 6};
  if (inwards) {
    for (std::size_t i = 0; i < outwards.size(); i += 3) std::swap(outwards[i], outwards[i + 1]);
  }
  addMesh(model, node, corners, outwards, material);
}

/// A ball with normals of its own.
void addBall(Model& model, const std::string& node, const glm::vec3& middle, float radius, const Material& material) {
  constexpr int kRows = 48, kColumns = 96;
  std::vector<glm::vec3> positions;
  std::vector<std::uint32_t> indices;
  for (int r = 0; r <= kRows; ++r) {
    for (int c = 0; c <= kColumns; ++c) {
      const double polar = kPi * r / kRows, around = 2.0 * kPi * c / kColumns;
      positions.push_back(middle + radius * glm::vec3(std::sin(polar) * std::cos(around), std::cos(polar),
                                                      -std::sin(polar) * std::sin(around)));
      if (r == kRows || c == kColumns) continue;
      const auto at = static_cast<std::uint32_t>(r * (kColumns + 1) + c);
      indices.insert(indices.end(), {at, at + kColumns + 1, at + kColumns + 2, at, at + kColumns + 2, at + 1});
    }
  }
  addMesh(model, node, positions, indices, material);
  for (const glm::vec3& p : model.meshes.back().positions) model.meshes.back().normals.push_back((p - middle) / radius);
}

struct World {
  Scene scene;
  Model model;
  World() {
    scene.sky = SkyColor{{0.0f, 0.0f, 0.0f}};
    scene.models.emplace_back();
    scene.models.back().file = "made.glb";
  }
  ReferencePicture see(const glm::dvec3& from, const glm::dvec3& to, int rays, std::optional<int> bounces, int size = 4,
                       double fov = 1.0, std::uint64_t seed = 1, const PicturePart& part = {}) const {
    Camera camera;
    camera.position = from;
    camera.target = to;
    camera.up = std::abs(glm::normalize(to - from).y) > 0.9 ? glm::dvec3(0, 0, 1) : glm::dvec3(0, 1, 0);
    camera.verticalFovDegrees = fov;
    PathSettings settings;
    settings.width = settings.height = size;
    settings.raysPerPixel = rays;
    settings.bounces = bounces;
    settings.seed = seed;
    settings.part = part;
    return ReferencePath(scene, {std::make_shared<const Model>(model)}, sky).render(camera, settings);
  }
  /// Mean over a few pixels.
  glm::dvec3 color(const glm::dvec3& from, const glm::dvec3& to, int rays = 512, std::optional<int> bounces = 0) const {
    const ReferencePicture picture = see(from, to, rays, bounces);
    glm::dvec3 sum(0.0);
    for (std::size_t i = 0; i < picture.color.pixels.size(); i += 4) {
      for (std::size_t c = 0; c < 3; ++c) {
        EXPECT_TRUE(std::isfinite(picture.color.pixels[i + c]));
        sum[static_cast<int>(c)] += picture.color.pixels[i + c];
      }
    }
    return sum / (0.25 * static_cast<double>(picture.color.pixels.size()));
  }
  std::shared_ptr<const ImageRgbaF> sky;
};

void expectColor(const glm::dvec3& found, const glm::dvec3& expected, double relative) {
  for (int c = 0; c < 3; ++c) EXPECT_NEAR(found[c], expected[c], relative * std::max(expected[c], 1e-3)) << c;
}

// Walls that shine e and reflect a: e (1 + a + a² + ...) everywhere, a term for each scattering.
TEST(Path, BouncesOfAClosedRoomAddUpAsTheSeriesSays) {
  World world;
  const glm::dvec3 albedo(0.31, 0.54, 0.77), shine(0.7, 0.4, 0.2);
  Material wall = lambert(glm::vec3(albedo));
  wall.emissive = glm::vec3(shine);
  addBox(world.model, "room", {-1.3f, -0.4f, -2.1f}, {1.9f, 2.2f, 1.1f}, true, wall);
  glm::dvec3 expected = shine, term = shine;
  for (const int bounces : {0, 1, 2, 5}) {
    SCOPED_TRACE(bounces);
    expected = term = shine;
    for (int i = 0; i <= bounces; ++i) expected += (term *= albedo);
    expectColor(world.color({0.2, 0.5, 0.3}, {-0.9, 0.1, -1.0}, 16384, bounces), expected, 0.01);
  }
  expectColor(world.color({0.2, 0.5, 0.3}, {-0.9, 0.1, -1.0}, 32768, std::nullopt), shine / (1.0 - albedo), 0.015);
}

/// Lambert's formula for a polygon: the share of its light that a point with that normal receives, times pi.
double formFactor(const std::vector<glm::dvec3>& corners, const glm::dvec3& point, const glm::dvec3& normal) {
  double sum = 0.0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 a = glm::normalize(corners[i] - point),
                     b = glm::normalize(corners[(i + 1) % corners.size()] - point);
    sum += std::acos(glm::dot(a, b)) * glm::dot(glm::normalize(glm::cross(a, b)), normal);
  }
  return std::abs(sum) / 2.0;
}

TEST(Path, ALampOverAFloorIsItsFormFactor) {
  World world;
  const glm::dvec3 albedo(0.83, 0.52, 0.27), shine(7.0, 11.0, 4.0);
  addQuad(world.model, "floor", glm::vec3(0.0f), {3.7f, 0.0f, 0.0f}, {0.0f, 0.0f, -4.1f}, lambert(glm::vec3(albedo)));
  Material lamp = lambert(glm::vec3(0.0f));
  lamp.emissive = glm::vec3(shine);
  addQuad(world.model, "lamp", {0.4f, 1.7f, -0.3f}, {0.62f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.45f}, lamp);
  const std::vector<glm::dvec3> corners = {
      {-0.22, 1.7, -0.75}, {1.02, 1.7, -0.75}, {1.02, 1.7, 0.15}, {-0.22, 1.7, 0.15}};
  for (const glm::dvec3& place : {glm::dvec3(0.5, 0.0, -0.2), glm::dvec3(-1.9, 0.0, 1.3), glm::dvec3(2.6, 0.0, -2.2)}) {
    const double factor = formFactor(corners, place, {0.0, 1.0, 0.0}) / kPi;
    expectColor(world.color(place + glm::dvec3(-0.9, 0.7, 0.8), place, 32768), albedo * shine * factor, 0.01);
  }
  // Its back is not there, and sends nothing.
  expectColor(world.color({0.4, 2.4, -0.3}, {0.4, 1.0, -0.31}, 32768),
              albedo * shine * formFactor(corners, {0.4, 0.0, -0.31}, {0.0, 1.0, 0.0}) / kPi, 0.01);
}

glm::dvec3 diffuseLight(const World& world, const glm::dvec3& from, const glm::dvec3& to, int bounces) {
  Camera camera;
  camera.position = from;
  camera.target = to;
  camera.verticalFovDegrees = 1.0;
  PathSettings settings;
  settings.width = 5;
  settings.height = 3;
  settings.raysPerPixel = 2048;
  settings.bounces = bounces;
  settings.quantity = PathQuantity::DiffuseLight;
  const ReferencePicture light =
      ReferencePath(world.scene, {std::make_shared<const Model>(world.model)}, nullptr).render(camera, settings);
  const ImageRgbaF truth = diffuseTruthImage(light);
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < 15; ++i) {
    const float *mean = &light.color.pixels[4 * i], *error = &light.standardError.pixels[4 * i];
    const float* kept = &truth.pixels[4 * i];
    for (int c = 0; c < 3; ++c) {
      sum[c] += static_cast<double>(mean[c]) / 15.0;
      EXPECT_EQ(kept[c], mean[c]);
    }
    EXPECT_NEAR(kept[3], error[0] * error[0] + error[1] * error[1] + error[2] * error[2], 1e-9);
    EXPECT_GE(kept[3], 0.0f);
  }
  return sum;
}

// A wall's diffuse light is its radiance over its colour, whatever else lies there; light sources add to what arrives
// by way of other surfaces alone.
TEST(Path, DiffuseLightIsWhatAWhiteMatteSurfaceWouldShow) {
  const glm::dvec3 color(0.7, 0.5, 0.3), from(0.4, 1.1, 0.9), wall(-2.2, 1.3, -0.6), tile(-2.2, 1.3, 0.5);
  World world;
  addBox(world.model, "room", {-2.2f, 0.1f, -1.9f}, {2.1f, 2.7f, 1.5f}, true, lambert(glm::vec3(color)));
  Material lamp = lambert(glm::vec3(0.0f));
  lamp.emissive = glm::vec3(21.0f, 18.0f, 14.0f);
  addQuad(world.model, "lamp", {-0.7f, 2.6f, 0.3f}, {0.3f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.2f}, lamp);
  Material metal;
  metal.metallic = 1.0f;
  metal.roughness = 0.3f;
  metal.emissive = glm::vec3(0.4f);
  addQuad(world.model, "tile", glm::vec3(tile) + glm::vec3(1e-3f, 0.0f, 0.0f), {0.0f, 0.0f, -0.02f},
          {0.0f, 0.02f, 0.0f}, metal);
  for (const int bounces : {0, 2}) {
    const glm::dvec3 seen = world.color(from, wall, 4096, bounces), light = diffuseLight(world, from, wall, bounces);
    EXPECT_LT(glm::length(seen / color - light), 0.015 * glm::length(light)) << bounces;
    EXPECT_GT(light.x, 0.1);
  }
  World bare = world;
  bare.model.instances.pop_back();
  const glm::dvec3 onTile = diffuseLight(world, from, tile, 2), without = diffuseLight(bare, from, tile, 2);
  EXPECT_LT(glm::length(onTile - without), 0.015 * glm::length(without));

  const glm::dvec3 direct = diffuseLight(world, from, wall, 0), once = diffuseLight(world, from, wall, 1);
  Light bulb;
  bulb.type = LightType::Point;
  bulb.position = {1.2, 1.9, -0.7};
  bulb.color = glm::vec3(1.0f);
  bulb.intensity = 9.0;
  bulb.radius = 0.1;
  world.scene.lights = {bulb};
  EXPECT_LT(glm::length(diffuseLight(world, from, wall, 0) - direct), 0.015 * glm::length(direct));
  EXPECT_GT(diffuseLight(world, from, wall, 1).x, 1.1 * once.x);
  EXPECT_GT(world.color(from, wall, 4096, 0).x / color.x, 1.1 * direct.x);
}

TEST(Path, LightSourcesFollowTheirFormulas) {
  const glm::dvec3 albedo(0.64, 0.41, 0.86), power(3.1, 2.2, 5.3);
  const glm::dvec3 from(-1.4, 1.1, 0.9), place(0.3, 0.0, -0.4);
  const auto lit = [&](const Light& light) {
    World world;
    addQuad(world.model, "floor", glm::vec3(0.0f), {3.7f, 0.0f, 0.0f}, {0.0f, 0.0f, -4.1f}, lambert(glm::vec3(albedo)));
    Light own = light;
    own.color = glm::vec3(power);
    own.intensity = 1.0f;
    world.scene.lights = {own};
    return world.color(from, place, 16384);
  };
  Light sun;
  sun.direction = {0.5, -1.2, 0.4};
  const double cosine = 1.2 / std::sqrt(0.25 + 1.44 + 0.16);
  for (const double angle : {0.0, 0.53, 11.0}) {
    sun.angleDegrees = angle;
    expectColor(lit(sun), albedo / kPi * power * cosine, 0.01);
  }
  Light bulb;
  bulb.type = LightType::Point;
  bulb.position = {0.9, 1.6, -1.1};
  const glm::dvec3 to = bulb.position - place;
  const double d2 = glm::dot(to, to), falls = to.y / std::sqrt(d2) / d2;
  for (const double radius : {0.0, 0.02, 0.6}) {
    // Above the horizon a sphere lights a plane as its middle would.
    bulb.radius = radius;
    expectColor(lit(bulb), albedo / kPi * power * falls, 0.01);
  }
  bulb.radius = 0.0;
  bulb.range = 3.0;
  expectColor(lit(bulb), albedo / kPi * power * falls * (1.0 - d2 * d2 / 81.0), 0.01);
  Light spot = bulb;
  spot.type = LightType::Spot;
  spot.range = 0.0;
  spot.direction = {-0.8, -1.0, 0.1};
  spot.innerConeDegrees = 5.0;
  spot.outerConeDegrees = 40.0;
  const double along = glm::dot(glm::normalize(spot.direction), -glm::normalize(to));
  const double inner = std::cos(5.0 * kPi / 180.0), outer = std::cos(40.0 * kPi / 180.0);
  const double within = (along - outer) / (inner - outer);
  ASSERT_GT(within, 0.1);
  ASSERT_LT(within, 0.9);
  expectColor(lit(spot), albedo / kPi * power * falls * within * within, 0.01);
}

/// What white GGX of two alphas reflects of even light, half vectors drawn by D (N.H): masking alone takes light.
double facetAlbedo(double nv, double across, double along) {
  const glm::dvec3 v(std::sqrt(1.0 - nv * nv), 0.0, nv);
  const auto lambda = [&](const glm::dvec3& w) {
    return 0.5 * (std::sqrt(1.0 + (across * across * w.x * w.x + along * along * w.y * w.y) / (w.z * w.z)) - 1.0);
  };
  constexpr int kSteps = 700;
  double sum = 0.0;
  for (int i = 0; i < kSteps * kSteps; ++i) {
    const double u = (i / kSteps + 0.5) / kSteps, turn = 2.0 * kPi * (i % kSteps + 0.5) / kSteps;
    // tan² of the half vector is u / (1 - u) times the square of the ellipse's radius in its direction.
    const glm::dvec2 flat = std::sqrt(u / (1.0 - u)) * glm::dvec2(across * std::cos(turn), along * std::sin(turn));
    const glm::dvec3 h = glm::normalize(glm::dvec3(flat, 1.0));
    const double vh = glm::dot(v, h);
    const glm::dvec3 l = 2.0 * vh * h - v;
    if (vh > 0.0 && l.z > 0.0) sum += vh / (nv * h.z) / (1.0 + lambda(v) + lambda(l));
  }
  return sum / (kSteps * kSteps);
}

// In a white sky metals of white are as bright as masking leaves them, at every angle.
TEST(Path, MetalsLoseWhatMaskingTakes) {
  for (const auto& [roughness, strength] : {std::pair{0.3, 0.0}, {0.6, 0.0}, {1.0, 0.0}, {0.25, 0.8}}) {
    SCOPED_TRACE(roughness);
    World world;
    world.scene.sky = SkyColor{{1.0f, 1.0f, 1.0f}};
    Material material;
    material.roughness = static_cast<float>(roughness);
    material.finish.anisotropy = static_cast<float>(strength);
    addQuad(world.model, "floor", glm::vec3(0.0f), {90.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -90.0f}, material);
    const double alpha = roughness * roughness, along = alpha + (1.0 - alpha) * strength * strength;
    expectColor(world.color({0.0, 1.0, 0.0}, {0.0, 0.0, 0.0}, 16384, std::nullopt),
                glm::dvec3(facetAlbedo(0.99999, along, alpha)), 0.01);
    if (strength > 0.0) continue;
    expectColor(world.color({0.6, 0.8, 0.0}, {0.0, 0.0, 0.0}, 16384, std::nullopt),
                glm::dvec3(facetAlbedo(0.8, alpha, alpha)), 0.01);
  }
}

// In a white sky nothing is brighter than it, what absorbs nothing is as bright, and Lambert's law gives the albedo.
TEST(Path, NoMaterialMakesLight) {
  struct Row {
    const char* name;
    std::function<void(Material&)> make;
    double least, most;
  };
  const std::vector<Row> rows = {
      {"Lambert", [](Material& m) { m = lambert(glm::vec3(0.63f)); }, 0.629, 0.631},
      {"mirror",
       [](Material& m) {
         m.metallic = 1.0f;
         m.roughness = 0.0f;
       },
       0.999, 1.001},
      {"white dielectric",
       [](Material& m) {
         m.metallic = 0.0f;
         m.roughness = 0.2f;
       },
       // glTF weighs diffuse light by 1 - F at the half vector, which is less than what the lobe reflects near grazing.
       0.9, 1.01},
      {"coat",
       [](Material& m) {
         m.metallic = 1.0f;
         m.roughness = 0.2f;
         m.coat = 1.0f;
         m.coatRoughness = 0.1f;
       },
       0.93, 1.001},
      {"cloth",
       [](Material& m) {
         m.metallic = 0.0f;
         m.roughness = 0.8f;
         m.finish.sheenColor = glm::vec3(1.0f);
         m.finish.sheenRoughness = 0.5f;
       },
       0.8, 1.002},
      {"sheet of glass",
       [](Material& m) {
         m.metallic = 0.0f;
         m.roughness = 0.0f;
         m.transmission = 1.0f;
       },
       0.999, 1.001},
      {"rough sheet",
       [](Material& m) {
         m.metallic = 0.0f;
         m.roughness = 0.4f;
         m.transmission = 1.0f;
       },
       0.85, 1.0},
      {"solid glass",
       [](Material& m) {
         m.metallic = 0.0f;
         m.roughness = 0.0f;
         m.transmission = 1.0f;
         m.thin = false;
         m.doubleSided = true;
       },
       0.98, 1.001},
      {"rough solid",
       [](Material& m) {
         m.metallic = 0.0f;
         m.roughness = 0.3f;
         m.transmission = 1.0f;
         m.thin = false;
         m.doubleSided = true;
       },
       0.85, 1.0},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    World world;
    world.scene.sky = SkyColor{{1.0f, 1.0f, 1.0f}};
    Material material;
    row.make(material);
    addBall(world.model, "ball", {0.1f, 0.2f, -0.1f}, 1.0f, material);
    for (const glm::dvec3& to : {glm::dvec3(0.1, 0.2, -0.1), glm::dvec3(0.1, 0.95, -0.1)}) {
      const glm::dvec3 seen = world.color({0.1, 0.2, 5.0}, to, 16384, std::nullopt);
      EXPECT_GE(seen.y, row.least);
      EXPECT_LE(seen.y, row.most);
    }
  }
}

// A texture of one colour multiplies its factor by the channels that glTF names. So it gives the same light as that
// product without a texture: for every texture of a material.
TEST(Path, ATextureOfOneColourIsAFactor) {
  const auto image = std::make_shared<ImageRgba8>();
  image->width = image->height = 1;
  image->pixels = {51, 102, 153, 204};  // 0.2, 0.4, 0.6, 0.8
  const auto linear = [](float srgb) { return std::pow((srgb + 0.055f) / 1.055f, 2.4f); };
  const glm::vec3 colors(linear(0.2f), linear(0.4f), linear(0.6f));
  struct Row {
    const char* name;
    std::function<void(Material&)> make;
    std::function<TextureUse*(Material&)> texture;
    std::function<void(Material&, const glm::vec3&)> multiply;
  };
  const std::vector<Row> rows = {
      {"base colour", [](Material& m) { m.metallic = 0.1f; }, [](Material& m) { return &m.baseColorTexture; },
       [](Material& m, const glm::vec3& c) { m.baseColor *= glm::vec4(c, 0.8f); }},
      {"metallic and roughness", [](Material&) {}, [](Material& m) { return &m.metallicRoughnessTexture; },
       [](Material& m, const glm::vec3&) {
         m.roughness *= 0.4f;
         m.metallic *= 0.6f;
       }},
      {"emissive",
       [](Material& m) {
         m.emissive = {0.3f, 0.7f, 0.5f};
       },
       [](Material& m) { return &m.emissiveTexture; }, [](Material& m, const glm::vec3& c) { m.emissive *= c; }},
      {"coat", [](Material& m) { m.coat = 0.9f; }, [](Material& m) { return &m.coatTexture; },
       [](Material& m, const glm::vec3&) { m.coat *= 0.2f; }},
      {"coat's roughness",
       [](Material& m) {
         m.coat = 1.0f;
         m.coatRoughness = 0.9f;
       },
       [](Material& m) { return &m.coatRoughnessTexture; },
       [](Material& m, const glm::vec3&) { m.coatRoughness *= 0.4f; }},
      {"sheen",
       [](Material& m) {
         m.metallic = 0.0f;
         m.finish.sheenColor = {0.9f, 0.6f, 0.8f};
         m.finish.sheenRoughness = 0.7f;
       },
       [](Material& m) { return &m.finish.sheenColorTexture; },
       [](Material& m, const glm::vec3& c) { m.finish.sheenColor *= c; }},
      {"sheen's roughness",
       [](Material& m) {
         m.metallic = 0.0f;
         m.finish.sheenColor = glm::vec3(1.0f);
         m.finish.sheenRoughness = 0.9f;
       },
       [](Material& m) { return &m.finish.sheenRoughnessTexture; },
       [](Material& m, const glm::vec3&) { m.finish.sheenRoughness *= 0.8f; }},
      {"specular",
       [](Material& m) {
         m.metallic = 0.0f;
         m.ior = 2.1f;
         m.baseColor = {0.05f, 0.1f, 0.07f, 1.0f};
       },
       [](Material& m) { return &m.finish.specularTexture; },
       [](Material& m, const glm::vec3&) { m.specular *= 0.8f; }},
      {"specular's colour",
       [](Material& m) {
         m.metallic = 0.0f;
         m.ior = 2.1f;
         m.baseColor = {0.05f, 0.1f, 0.07f, 1.0f};
         m.finish.specularTint = {0.9f, 0.7f, 0.8f};
       },
       [](Material& m) { return &m.finish.specularColorTexture; },
       [](Material& m, const glm::vec3& c) { m.finish.specularTint *= c; }},
      {"transmission",
       [](Material& m) {
         m.metallic = 0.0f;
         m.transmission = 0.9f;
       },
       [](Material& m) { return &m.transmissionTexture; },
       [](Material& m, const glm::vec3&) { m.transmission *= 0.2f; }},
      {"anisotropy",
       [](Material& m) {
         m.finish.anisotropy = 0.9f;
         m.finish.anisotropyRotation = 0.3f;
       },
       [](Material& m) { return &m.finish.anisotropyTexture; },
       [](Material& m, const glm::vec3&) {
         m.finish.anisotropy *= 0.6f;
         m.finish.anisotropyRotation += std::atan2(2.0f * 0.4f - 1.0f, 2.0f * 0.2f - 1.0f);
       }},
      {"iridescence", [](Material& m) { m.finish.iridescence = 1.0f; },
       [](Material& m) { return &m.finish.iridescenceTexture; },
       [](Material& m, const glm::vec3&) { m.finish.iridescence *= 0.2f; }},
      {"film's thickness", [](Material& m) { m.finish.iridescence = 1.0f; },
       [](Material& m) { return &m.finish.filmThicknessTexture; },
       [](Material& m, const glm::vec3&) { m.finish.filmThicknessMax = 100.0f + 0.4f * 300.0f; }},
  };
  for (const Row& row : rows) {
    SCOPED_TRACE(row.name);
    Material plain;
    plain.baseColor = {0.9f, 0.5f, 0.7f, 1.0f};
    plain.metallic = 0.8f;
    plain.roughness = 0.6f;
    row.make(plain);
    const auto seen = [](const Material& material) {
      World world;
      world.scene.sky = SkyColor{{0.2f, 0.3f, 0.1f}};
      addQuad(world.model, "sheet", {0.0f, 0.0f, 0.0f}, {2.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -2.0f}, material);
      Mesh& sheet = world.model.meshes.back();
      sheet.uv = {{0, 1}, {1, 1}, {1, 0}, {0, 0}};
      sheet.tangents.assign(4, {1.0f, 0.0f, 0.0f, 1.0f});
      sheet.normals.assign(4, {0.0f, 1.0f, 0.0f});
      Material lamp = lambert(glm::vec3(0.0f));
      lamp.emissive = {7.0f, 6.0f, 9.0f};
      addQuad(world.model, "lamp", {-1.1f, 1.3f, 0.4f}, {0.0f, 0.3f, 0.3f}, {0.0f, 0.4f, -0.5f}, lamp);
      return world.color({1.3, 1.6, -0.7}, {0.0, 0.0, 0.0}, 1024);
    };
    Material textured = plain, factors = plain;
    row.texture(textured)->image = image;
    row.multiply(factors, colors);
    const glm::dvec3 expected = seen(factors);
    expectColor(seen(textured), expected, 0.003);
    EXPECT_GT(glm::length(seen(plain) - expected), 0.01 * glm::length(expected)) << "the texture does not matter here";
  }
}

// Half the light that enters is left after the attenuation distance.
TEST(Path, GlassAbsorbsOnTheTrueWay) {
  World world;
  world.scene.sky = SkyColor{{1.0f, 1.0f, 1.0f}};
  Material glass;
  glass.metallic = 0.0f;
  glass.roughness = 0.0f;
  glass.transmission = 1.0f;
  glass.thin = false;
  glass.ior = 1.0001f;  // bends and reflects next to nothing
  glass.doubleSided = true;
  glass.attenuationDistance = 0.7f;
  glass.attenuationColor = {0.5f, 0.8f, 0.2f};
  addBox(world.model, "block", {-1.0f, -1.0f, -0.45f}, {1.0f, 1.0f, 0.75f}, false, glass);
  const glm::dvec3 seen = world.color({0.1, 0.2, 5.0}, {0.1, 0.2, 0.0}, 64, std::nullopt);
  expectColor(seen, {std::pow(0.5, 1.2 / 0.7), std::pow(0.8, 1.2 / 0.7), std::pow(0.2, 1.2 / 0.7)}, 0.01);
}

// A small sun in a picture of a sky: what is aimed at is what is met by chance.
TEST(Path, ASkyThatIsAimedAtIsTheSky) {
  World world;
  auto image = std::make_shared<ImageRgbaF>();
  image->width = 64;
  image->height = 32;
  image->pixels.assign(4 * 64 * 32, 0.3f);
  for (int i = 0; i < 3; ++i)
    image->pixels[4 * static_cast<std::size_t>(7 * 64 + 23) + static_cast<std::size_t>(i)] = 900.0f;
  world.sky = image;
  world.scene.sky = SkyImage{"made.exr"};
  world.scene.skyRotationDegrees = 40.0;
  addQuad(world.model, "floor", glm::vec3(0.0f), {9.0f, 0.0f, 0.0f}, {0.0f, 0.0f, -9.0f}, lambert(glm::vec3(0.5f)));
  // By a sum over the picture: bilinear texels, each the mean over its neighbourhood.
  double irradiance = 0.0;
  constexpr int kFine = 8;
  for (int y = 0; y < 16 * kFine; ++y) {
    for (int x = 0; x < 64 * kFine; ++x) {
      const double u = (x + 0.5) / kFine - 0.5, v = (y + 0.5) / kFine - 0.5;
      const double a = std::max(1.0 - std::abs(u - 23.0), 0.0) * std::max(1.0 - std::abs(v - 7.0), 0.0);
      const double polar = kPi * (y + 0.5) / (32 * kFine);
      irradiance +=
          (0.3 + a * 899.7) * std::cos(polar) * std::sin(polar) * (kPi / (32 * kFine)) * (2.0 * kPi / (64 * kFine));
    }
  }
  expectColor(world.color({0.4, 1.0, 0.2}, {0.1, 0.0, 0.0}, 65536), glm::dvec3(0.5 * irradiance / kPi), 0.01);
}

TEST(Path, TheSameBitsByParts) {
  World world;
  Material wall = lambert(glm::vec3(0.6f, 0.5f, 0.7f));
  wall.emissive = glm::vec3(0.3f, 0.2f, 0.9f);
  addBox(world.model, "room", {-1.3f, -0.4f, -2.1f}, {1.9f, 2.2f, 1.1f}, true, wall);
  const auto seen = [&](const PicturePart& part) {
    return world.see({0.2, 0.5, 0.3}, {-0.9, 0.1, -1.0}, 32, std::nullopt, 24, 60.0, 5, part).color.pixels;
  };
  const std::vector<float> whole = seen({}), again = seen({});
  EXPECT_EQ(whole, again);
  PicturePart upper, lower;
  upper.bottom = lower.top = 11;
  const std::vector<float> a = seen(upper), b = seen(lower);
  for (std::size_t i = 0; i < whole.size(); ++i) ASSERT_EQ(whole[i], i < 4 * 24 * 11 ? a[i] : b[i]);
}

TEST(Path, ASceneWithoutLightIsBlackAndSaysSo) {
  World world;
  addBox(world.model, "room", {-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}, true, lambert(glm::vec3(0.5f)));
  EXPECT_EQ(world.color({0, 0, 0}, {0.5, 0.1, 0.2}, 16, std::nullopt), glm::dvec3(0.0));
  const ReferencePath path(world.scene, {std::make_shared<const Model>(world.model)}, nullptr);
  EXPECT_THAT(path.remarks(), ElementsAre(HasSubstr("nothing in the scene sends light")));
}

// No ray is aimed at an unlit surface; those that meet it bring light.
TEST(Path, AnUnlitSurfaceIsLight) {
  World world;
  Material shining = lambert(glm::vec3(0.25f));
  shining.unlit = true;
  addBox(world.model, "room", {-1.0f, -1.0f, -1.0f}, {1.0f, 1.0f, 1.0f}, true, shining);
  EXPECT_NEAR(world.color({0, 0, 0}, {0.5, 0.1, 0.2}, 16, std::nullopt).g, 0.25, 1e-6);
  const ReferencePath path(world.scene, {std::make_shared<const Model>(world.model)}, nullptr);
  EXPECT_THAT(path.remarks(), IsEmpty());
}

TEST(Path, InputThatBreaksTracersGivesFinitePictures) {
  const float nan = std::numeric_limits<float>::quiet_NaN();
  const std::vector<std::pair<const char*, std::function<void(World&)>>> cases = {
      {"emission of 1e6",
       [](World& w) {
         Material m = lambert(glm::vec3(0.9f));
         m.emissive = glm::vec3(1e6f);
         addBall(w.model, "lamp", {0.0f, 0.5f, 0.0f}, 0.01f, m);
       }},
      {"10,000 lamps",
       [](World& w) {
         Material m = lambert(glm::vec3(0.0f));
         m.emissive = glm::vec3(2.0f, 1.0f, 3.0f);
         for (int i = 0; i < 5000; ++i) {
           const float x = 0.03f * static_cast<float>(i % 100) - 1.5f, z = 0.05f * static_cast<float>(i / 100) - 1.2f;
           addQuad(w.model, "lamp", {x, 0.9f, z}, {0.004f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.003f}, m);
         }
       }},
      {"triangles without area",
       [](World& w) {
         Material m = lambert(glm::vec3(0.5f));
         m.emissive = glm::vec3(1.0f);
         addQuad(w.model, "line", {0.0f, 0.5f, 0.0f}, {0.5f, 0.0f, 0.0f}, {0.0f, 0.0f, 0.0f}, m);
       }},
      {"NaN in a material", [nan](World& w) { w.model.materials[0].emissive = glm::vec3(nan, 1.0f, 2.0f); }},
      {"inverted faces", [](World& w) { std::swap(w.model.meshes[0].indices[0], w.model.meshes[0].indices[1]); }},
      {"a camera within a block",
       [](World& w) {
         addBox(w.model, "block", {-0.9f, -0.9f, -0.9f}, {0.9f, 0.8f, 0.7f}, false, lambert(glm::vec3(0.4f)));
       }},
      {"a room at 1e5 m, in centimetres",
       [](World& w) {
         w.scene.models[0].unit = LengthUnit::Centimetre;
         w.scene.models[0].translation = {1e5, -2e5, 3e5};
       }},
  };
  for (const auto& [name, make] : cases) {
    SCOPED_TRACE(name);
    World world;
    Material wall = lambert(glm::vec3(0.6f, 0.5f, 0.7f));
    wall.emissive = glm::vec3(0.3f, 0.2f, 0.9f);
    addBox(world.model, "room", {-1.6f, -1.0f, -1.3f}, {1.7f, 1.2f, 1.4f}, true, wall);
    make(world);
    const bool far = world.scene.models[0].unit == LengthUnit::Centimetre;
    const glm::dvec3 from = far ? glm::dvec3(1e5, -2e5, 3e5) : glm::dvec3(0.1, 0.2, 0.3);
    const double scale = far ? 0.01 : 1.0;
    const ReferencePicture picture =
        world.see(from, from + scale * glm::dvec3(-0.9, -0.3, -1.0), 8, std::nullopt, 16, 70.0);
    for (const float value : picture.color.pixels) ASSERT_TRUE(std::isfinite(value) && value >= 0.0f);
  }
}

}  // namespace
}  // namespace boxprobe
