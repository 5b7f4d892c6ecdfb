// A model without a scene, opened as a room: how bright it is.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdint>
#include <cstdio>
#include <string>
#include <vector>

#include "app/session/load_scene.h"
#include "app/session/offscreen_scene.h"
#include "filters/fit/fit_model.h"
#include "tests/support/sphere_mesh.h"
#include "tests/unit/io_glb_builder.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe::test {
namespace {

class BareRoom : public TemporaryFolder {
 protected:
  static constexpr int kWidth = 48, kHeight = 27;

  /// A sphere of 2.3 m seen from within, a lamp in its middle. `share`: of the light that its wall returns.
  std::string sphere(double share) {
    const Mesh mesh = sphereMesh(2.3f, 24, 48);
    std::vector<float> positions, normals;
    std::vector<std::uint16_t> indices;
    for (const glm::vec3& p : mesh.positions) positions.insert(positions.end(), {p.x, p.y, p.z});
    for (const glm::vec3& n : mesh.normals) normals.insert(normals.end(), {-n.x, -n.y, -n.z});
    for (std::size_t i = 0; i < mesh.indices.size(); i += 3) {
      for (const std::size_t k : {i, i + 2, i + 1}) indices.push_back(static_cast<std::uint16_t>(mesh.indices[k]));
    }
    GlbBuilder glb;
    const int at = glb.floats("VEC3", 3, positions), along = glb.floats("VEC3", 3, normals);
    const int corners = glb.accessor(glb.view(indices), GlbBuilder::UShort, "SCALAR", indices.size());
    glb.json["extensionsUsed"] = {"KHR_lights_punctual", "KHR_materials_specular"};
    glb.json["materials"].push_back(
        {{"pbrMetallicRoughness",
          {{"baseColorFactor", {share, share, share, 1}}, {"metallicFactor", 0}, {"roughnessFactor", 1}}},
         {"extensions", {{"KHR_materials_specular", {{"specularFactor", 0}}}}}});
    glb.json["extensions"]["KHR_lights_punctual"]["lights"].push_back({{"type", "point"}, {"intensity", 40}});
    glb.node(
        {{"name", "wall"},
         {"mesh",
          glb.mesh({{"attributes", {{"POSITION", at}, {"NORMAL", along}}}, {"indices", corners}, {"material", 0}})}});
    glb.node({{"name", "lamp"}, {"extensions", {{"KHR_lights_punctual", {{"light", 0}}}}}});
    return write("sphere.glb", glb.glb());
  }

  /// The mean of the picture.
  double light(const LoadedScene& loaded) {
    shown.show(loaded.scene, loaded.models, {loaded.scene.cameras.front()});
    EXPECT_TRUE(shown.capture());
    const ImageRgbaF picture = shown.renderer().renderLinear(kWidth, kHeight, 1);
    shown.requireHealthy();
    double sum = 0.0;
    for (std::size_t i = 0; i < picture.pixels.size(); i += 4) sum += static_cast<double>(picture.pixels[i]);
    return 4.0 * sum / static_cast<double>(picture.pixels.size());
  }

  /// An integrating sphere: what its wall returns lights all of the wall alike, again and again, and all of that
  /// together is the lamp's own light by 1 / (1 - share). Returns how much of this the picture has.
  double shareOfSeries(double share) {
    LoadedScene loaded = loadScene(sphere(share));
    EXPECT_EQ(loaded.fit.value().kind, ModelKind::Interior);
    EXPECT_EQ(loaded.scene.probes.size(), 1u);
    loaded.scene.probes.at(0).faceSize = 64;
    const double all = light(loaded);
    loaded.scene.probes.clear();
    loaded.scene.sky = SkyColor{};
    const double lamp = light(loaded), part = all / lamp * (1.0 - share);
    std::printf("light of the lamp %.4f, of all bounces %.4f: %.3f of the series\n", lamp, all, part);
    return part;
  }

  OffscreenScene shown{{"bare_room_test", kWidth, kHeight, 1, false, true}};
};

// Bounces end when one brings 1 %, which leaves 3 % of the series.
TEST_F(BareRoom, AnIntegratingSphereOpensAsBrightAsItsSeriesEnds) {
  EXPECT_NEAR(shareOfSeries(0.8), 1.0, 0.06);
}

// They end after 16 captures, here of a series that is not done by then.
TEST_F(BareRoom, AWhiterSphereHasSixteenBounces) {
  EXPECT_NEAR(shareOfSeries(0.9), 1.0 - std::pow(0.9, 17), 0.06);
}

}  // namespace
}  // namespace boxprobe::test
