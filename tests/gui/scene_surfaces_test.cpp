// What rays of the pointer meet: triangles of several models, one-sided and not, moved, hidden, locked, behind a cut.
#include "app/gui/handles/scene_surfaces.h"

#include <gtest/gtest.h>

#include <glm/gtc/matrix_transform.hpp>

namespace boxprobe {
namespace {

class SceneSurfacesTest : public ::testing::Test {
 protected:
  SceneSurfacesTest() : surfaces_(document_) {
    Model first;
    first.materials.resize(2);
    first.materials[0].name = "paper";
    first.materials[1].name = "foil";
    first.materials[1].doubleSided = true;
    // Seen from +Z: a right angle at the origin, 4 along x and 3 along y.
    Mesh mesh;
    mesh.positions = {{0, 0, 0}, {4, 0, 0}, {0, 3, 0}};
    mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
    mesh.indices = {0, 1, 2};
    mesh.material = 0;
    first.meshes.push_back(mesh);
    mesh.material = 1;
    first.meshes.push_back(mesh);
    // As readers leave it where the placement mirrors: with its corners in the other order.
    mesh.indices = {0, 2, 1};
    mesh.material = 0;
    first.meshes.push_back(mesh);
    mesh.indices = {0, 1, 2};
    const auto at = [](double x, double y, double z) { return glm::translate(glm::dmat4(1.0), glm::dvec3(x, y, z)); };
    first.instances = {{"near", 0, at(0, 0, 0)},
                       {"far", 1, at(0, 0, -2)},
                       {"mirrored", 2, glm::scale(at(-1, 0, 0), glm::dvec3(-1, 1, 1))}};
    Model second;
    mesh.material = -1;
    second.meshes.push_back(mesh);
    second.instances = {{"plain", 0, at(10, 0, 0)}, {"moved", 0, at(20, 0, 0)}, {"gone", 0, at(30, 0, 0)}};
    models_ = {std::make_shared<const Model>(first), std::make_shared<const Model>(second)};
    Scene scene;
    scene.models.resize(2);
    scene.models[0].file = "first.glb";
    scene.models[1].file = "second.glb";
    scene.models[1].translation = {0.0, 5.0, 0.0};
    scene.models[1].scale = 2.0;
    scene.objects["moved"].translation = {0.5, 0.0, 3.0};
    scene.objects["gone"].visible = false;
    document_.open(scene, "");
    surfaces_.setModels(models_);
  }

  std::string at(const glm::dvec3& origin, const glm::dvec3& direction) {
    const auto picked = surfaces_.objectAt({origin, direction});
    return picked ? picked->node + " of " + picked->material : "sky";
  }
  /// Towards -Z from z = 9, and back from z = -9.
  std::string ahead(double x, double y) { return at({x, y, 9.0}, {0, 0, -1}); }
  std::string back(double x, double y) { return at({x, y, -9.0}, {0, 0, 1}); }

  Document document_;
  TriangleRays::Models models_;
  SceneSurfaces surfaces_;
};

TEST_F(SceneSurfacesTest, TheNearestThatIsSeenIsPicked) {
  EXPECT_EQ(ahead(1.0, 0.5), "near of paper");
  EXPECT_EQ(back(1.0, 0.5), "far of foil") << "paper has one side";
  EXPECT_EQ(at({1.0, 0.5, -1.0}, {0, 0, 1}), "sky");
  EXPECT_EQ(at({1.0, 0.5, -1.0}, {0, 0, -1}), "far of foil");
  EXPECT_EQ(at({1.0, 0.5, -3.0}, {0, 0, -1}), "sky") << "both are behind";
  // Each edge from either side.
  EXPECT_EQ(ahead(0.01, 0.01), "near of paper");
  EXPECT_EQ(ahead(3.9, 0.05), "near of paper");
  EXPECT_EQ(ahead(0.05, 2.9), "near of paper");
  EXPECT_EQ(ahead(1.98, 1.48), "near of paper");
  EXPECT_EQ(ahead(2.02, 1.52), "sky");
  EXPECT_EQ(ahead(-0.01, 1.0), "sky");
  EXPECT_EQ(ahead(1.0, -0.01), "sky");
  EXPECT_EQ(ahead(4.1, 0.0), "sky");
  EXPECT_EQ(ahead(0.0, 3.1), "sky");
  // Its mirror image looks the same way.
  EXPECT_EQ(ahead(-2.0, 0.5), "mirrored of paper");
  EXPECT_EQ(back(-2.0, 0.5), "sky");
  EXPECT_EQ(ahead(-0.99, 0.5), "sky");
  EXPECT_EQ(ahead(-4.9, 0.05), "mirrored of paper");
  EXPECT_EQ(ahead(-5.1, 0.05), "sky");
  // Along the plane nothing is met, aslant it is where it is.
  EXPECT_EQ(at({-3.0, 1.0, 0.0}, {1, 0, 0}), "sky");
  EXPECT_EQ(at({5.0, 0.5, 2.0}, {-2, 0, -1}), "near of paper");
  EXPECT_EQ(at({9.0, 0.5, 2.0}, {-2, 0, -1}), "far of foil");
}

TEST_F(SceneSurfacesTest, ModelsAndObjectsStandWhereTheScenePutsThem) {
  // Twice as large, five higher.
  EXPECT_EQ(ahead(20.1, 5.1), "plain of ");
  EXPECT_EQ(ahead(27.5, 5.2), "plain of ");
  EXPECT_EQ(ahead(20.1, 10.5), "plain of ");
  EXPECT_EQ(ahead(10.5, 5.1), "sky");
  EXPECT_EQ(ahead(20.1, 4.9), "sky");
  EXPECT_EQ(ahead(40.1, 5.1), "sky") << "moved away";
  EXPECT_EQ(ahead(40.6, 5.1), "moved of ");
  EXPECT_EQ(at({40.6, 5.1, 2.9}, {0, 0, -1}), "sky") << "and nearer";
  EXPECT_EQ(back(20.1, 5.1), "plain of ") << "without a material it has two sides";
  EXPECT_EQ(ahead(60.1, 5.1), "sky") << "the scene hides it";
  Scene scene = document_.scene();
  scene.models.resize(1);
  document_.open(scene, "");
  EXPECT_EQ(ahead(20.1, 5.1), "sky") << "of a model that the scene no longer has";
  EXPECT_EQ(ahead(1.0, 0.5), "near of paper");
  EXPECT_EQ(surfaces_.rays(), nullptr);
}

TEST_F(SceneSurfacesTest, HiddenAndLockedPartsAreNotPicked) {
  const auto met = [this](double x, double y) {
    const auto point = surfaces_.meet({{x, y, 9.0}, {0, 0, -1}});
    return point ? point->z : -100.0;
  };
  EXPECT_NEAR(met(1.0, 0.5), 0.0, 1e-6);
  EXPECT_NEAR(met(40.6, 5.1), 3.0, 1e-6);
  EXPECT_EQ(met(-50.0, 0.0), -100.0);
  surfaces_.setView({{"near"}, {}, {}});
  EXPECT_EQ(ahead(1.0, 0.5), "far of foil");
  EXPECT_NEAR(met(1.0, 0.5), -2.0, 1e-6);
  surfaces_.setView({{"far"}, {}, {}});
  EXPECT_EQ(ahead(1.0, 0.5), "near of paper");
  EXPECT_NEAR(met(1.0, 0.5), 0.0, 1e-6);
  surfaces_.setView({{"near", "far"}, {}, {}});
  EXPECT_EQ(ahead(1.0, 0.5), "sky");
  EXPECT_EQ(met(1.0, 0.5), -100.0);
  surfaces_.setView({{}, {"near"}, {}});
  EXPECT_EQ(ahead(1.0, 0.5), "far of foil") << "locked";
  EXPECT_NEAR(met(1.0, 0.5), 0.0, 1e-6) << "and seen";
  EXPECT_NE(surfaces_.rays(), nullptr);
  // An edit is followed.
  surfaces_.setView({});
  document_.commit("Move", [](Scene& scene) { scene.objects["near"].translation = {0.0, 0.0, 1.5}; });
  Changes changes;
  changes.probeShape = true;
  surfaces_.documentChanged(changes);
  EXPECT_NEAR(met(1.0, 0.5), 0.0, 1e-6) << "not told yet";
  changes = {};
  changes.objects = true;
  surfaces_.documentChanged(changes);
  EXPECT_NEAR(met(1.0, 0.5), 1.5, 1e-6);
  document_.commit("Move", [](Scene& scene) { scene.models[0].translation = {0.0, 0.0, 0.25}; });
  changes = {};
  changes.models = true;
  surfaces_.documentChanged(changes);
  EXPECT_NEAR(met(1.0, 0.5), 1.75, 1e-6);
  surfaces_.setModels({});
  EXPECT_EQ(met(1.0, 0.5), -100.0);
  EXPECT_EQ(ahead(1.0, 0.5), "sky");
}

TEST_F(SceneSurfacesTest, RaysBeginBehindTheCut) {
  // About (1, 0.5, 1): 2 wide, 1 high, 6 deep; turned by 90 degrees 6 wide and 2 deep.
  CutBox cut{Box{glm::dvec3(0.0, 0.0, -2.0), glm::dvec3(2.0, 1.0, 4.0)}, {}};
  surfaces_.setView({{}, {}, cut});
  EXPECT_EQ(ahead(1.0, 0.5), "near of paper") << "the cut begins before it";
  EXPECT_EQ(at({1.0, 0.5, 0.5}, {0, 0, -1}), "near of paper") << "from within nothing is cut";
  cut.box = Box{glm::dvec3(0.0, 0.0, -3.0), glm::dvec3(2.0, 1.0, -1.0)};
  surfaces_.setView({{}, {}, cut});
  EXPECT_EQ(ahead(1.0, 0.5), "far of foil") << "what stands before the box is cut away";
  EXPECT_EQ(ahead(2.5, 0.5), "near of paper") << "beside it it is not";
  EXPECT_EQ(ahead(1.0, 1.2), "near of paper");
  EXPECT_EQ(at({1.0, 0.5, -9.0}, {0, 0, -1}), "sky");
  const auto met = surfaces_.meet({{1.0, 0.5, 9.0}, {0, 0, -1}});
  ASSERT_TRUE(met);
  EXPECT_NEAR(met->z, -2.0, 1e-6);
  // Aslant it enters by a side: at x = 2, z = -1.5, behind which it meets the far one at x = 1.
  EXPECT_EQ(at({12.0, 0.5, 3.5}, {-2, 0, -1}), "far of foil");
  EXPECT_EQ(at({9.0, 0.5, 3.0}, {-2, 0, -1}), "sky") << "the near one is cut away, the far one is beside";
  EXPECT_EQ(at({5.0, 0.5, 2.0}, {-2, 0, -1}), "near of paper");
  // Turned it is 2 deep and as wide as it was deep.
  cut.box = Box{glm::dvec3(0.9, 0.0, -4.0), glm::dvec3(1.1, 1.0, 2.0)};
  cut.rotationDegrees = {0.0, 90.0, 0.0};
  surfaces_.setView({{}, {}, cut});
  EXPECT_EQ(ahead(3.0, 0.5), "far of foil");
  EXPECT_EQ(ahead(1.0, 0.5), "far of foil");
  EXPECT_EQ(ahead(1.0, 1.2), "near of paper");
}

}  // namespace
}  // namespace boxprobe
