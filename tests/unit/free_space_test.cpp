// The free space of a room that is open on one side, against distances by hand.
#include "filters/fit/rooms/free_space.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "filters/fit/rays/triangle_rays.h"
#include "tests/unit/made_model.h"

namespace boxprobe {
namespace {

const Box kVeranda{glm::dvec3(-2.3, 0.0, -1.7), glm::dvec3(2.1, 2.4, 1.9)};
constexpr double kJamb = 0.1;  ///< from here on in z the side at the greatest x is open

// Is the outdoors as near as the opening, and everything else as near as the walls?
TEST(FreeSpaceTest, DepthIsTheDistanceOfWallsAndOfTheOpening) {
  MadeModel made;
  for (int axis = 0; axis < 3; ++axis) {
    made.side(kVeranda, axis, false);
    if (axis != 0) made.side(kVeranda, axis, true);
  }
  Box wall = kVeranda;
  wall.max.z = kJamb;
  made.side(wall, 0, true);
  Scene scene;
  scene.models = {{"made.glb"}};
  const TriangleRays rays(scene, {std::make_shared<const Model>(made.model)});
  WalledRegion region;
  region.bounds = kVeranda;
  region.bounds.max.x = 4.0;
  region.height = 2.4;
  const std::optional<FreeSpace> space = freeSpace(rays, region, false);
  ASSERT_TRUE(space);
  int indoors = 0, atTheOpening = 0;
  for (std::size_t i = 0; i < space->depth.size(); ++i) {
    const glm::dvec3 p = space->worldPosition(i);
    const bool within = p.x > kVeranda.min.x && p.x < kVeranda.max.x && p.y > kVeranda.min.y && p.y < kVeranda.max.y &&
                        p.z > kVeranda.min.z && p.z < kVeranda.max.z;
    EXPECT_EQ(space->depth[i] > 0.0f, within) << p.x << " " << p.y << " " << p.z;
    if (!within) continue;
    ++indoors;
    const double aside = std::max(kJamb - p.z, 0.0);
    const double opening = std::hypot(kVeranda.max.x - p.x, aside);
    double walls = std::min(
        {p.x - kVeranda.min.x, p.y - kVeranda.min.y, kVeranda.max.y - p.y, p.z - kVeranda.min.z, kVeranda.max.z - p.z});
    if (aside > 0.0) walls = std::min(walls, kVeranda.max.x - p.x);
    const double nearest = std::min(walls, opening);
    EXPECT_GE(space->depth[i], nearest - 1e-4) << p.x << " " << p.y << " " << p.z;
    EXPECT_LE(space->depth[i], std::min(walls + 1e-4, 1.1 * opening + 1.5 * space->cell))
        << p.x << " " << p.y << " " << p.z;
    atTheOpening += opening + 2.0 * space->cell < walls ? 1 : 0;
  }
  EXPECT_GT(indoors, 1000);
  EXPECT_GT(atTheOpening, 50) << "where the opening alone decides";
}

}  // namespace
}  // namespace boxprobe
