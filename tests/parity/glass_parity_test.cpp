// Glass on the GPU and as C++: the same way through an ellipsoid for random normals, views and indices.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <glm/geometric.hpp>
#include <random>

#include "filters/math/shared/refraction.h"
#include "filters/math/shared/shader_source.h"
#include "tests/support/gpu_window.h"

namespace {

using namespace boxprobe;
using glm::vec3;
using glm::vec4;

constexpr std::size_t kGlassCount = 65536;

// The same formula on both sides, smooth, so that only the way through is compared.
constexpr const char* kShell =
    "#define GLASS_SHELL int\n"
    "vec4 fetchGlassShell(int shell, vec3 d)\n{\n  vec3 u = d / max(length(d), 1e-30);\n"
    "  vec3 n = normalize(u * vec3(1.0, 0.7, 1.3));\n  return vec4(n, 1.0 + 0.2 * u.x * u.y);\n}\n";
struct Shell : shading::ShellSampler {
  vec4 fetchShell(const vec3& d) const override {
    const vec3 u = d / std::max(glm::length(d), 1e-30f);
    return vec4(glm::normalize(u * vec3(1.0f, 0.7f, 1.3f)), 1.0f + 0.2f * u.x * u.y);
  }
};

TEST(GlassParity, TheWayThroughIsTheSame) {
  const auto window = test::makeWindow();
  std::mt19937 random(12);
  std::normal_distribution<float> gauss;
  std::uniform_real_distribution<float> unit(0.0f, 1.0f);
  const auto direction = [&] { return glm::normalize(vec3(gauss(random), gauss(random), gauss(random))); };
  std::vector<vec4> position, normal, view;
  for (std::size_t i = 0; i < kGlassCount; ++i) {
    const vec3 n = direction();
    vec3 v = direction();
    if (glm::dot(n, v) < 0.0f && i % 16 != 0) v = -v;
    position.emplace_back(0.9f * n, unit(random));                           // roughness
    normal.emplace_back(n, i % 9 == 0 ? 1.0f : 0.6f + 1.8f * unit(random));  // index
    view.emplace_back(v, static_cast<float>(i % 2));                         // from within
  }
  for (int form = 1; form <= 3; ++form) {
    const auto gpu = test::evaluateOnGpu(
        window,
        kShell + std::string(shaderSource("shared/glass_types.glsl")) +
            std::string(shaderSource("shared/refraction.glsl")),
        "  GlassObject glass; glass.ior = in1.w; glass.form = " + std::to_string(form) +
            "; glass.sheet = false; glass.thickness = 0.3; glass.center = vec3(0.0); glass.radius = 1.3;\n"
            "  GlassView seen = lookThroughGlass(0, glass, in0.xyz, in1.xyz, in2.xyz, in0.w, in2.w > 0.5, 2.0);\n"
            "  out0 = vec4(seen.through.direction, seen.through.distance);\n"
            "  out1 = vec4(seen.through.position, seen.reflectance);\n"
            "  out2 = vec4(seen.mirrored.direction, seen.through.alpha);\n",
        {position, normal, view}, 3);
    const Shell shell;
    std::size_t beyond = 0;
    float worst = 0.0f;
    for (std::size_t i = 0; i < kGlassCount; ++i) {
      shading::GlassObject glass{};
      glass.ior = normal[i].w;
      glass.form = form;
      glass.thickness = 0.3f;
      glass.radius = 1.3f;
      const shading::GlassView seen = shading::lookThroughGlass(&shell, glass, vec3(position[i]), vec3(normal[i]),
                                                                vec3(view[i]), position[i].w, view[i].w > 0.5f, 2.0f);
      const float off = std::max(
          {glm::length(vec3(gpu[0][i]) - seen.through.direction), glm::length(vec3(gpu[1][i]) - seen.through.position),
           glm::length(vec3(gpu[2][i]) - seen.mirrored.direction), std::abs(gpu[0][i].w - seen.through.distance),
           std::abs(gpu[1][i].w - seen.reflectance), std::abs(gpu[2][i].w - seen.through.alpha)});
      ASSERT_TRUE(std::isfinite(off)) << i;
      // At the critical angle and where two planes are equally near rounding decides.
      beyond += off > 1.0e-3f ? 1 : 0;
      if (off <= 1.0e-3f) worst = std::max(worst, off);
    }
    std::printf("  form %d: worst difference %.2g, %zu of %zu beyond 1e-3\n", form, static_cast<double>(worst), beyond,
                kGlassCount);
    EXPECT_LE(beyond, kGlassCount / 1000) << form;
  }
}

}  // namespace
