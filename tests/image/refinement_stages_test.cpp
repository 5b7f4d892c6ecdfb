// How a picture at rest goes on: stages, shares and ends, without graphics.
#include <gtest/gtest.h>

#include "filters/vtk/frame/refinement.h"

namespace {

using namespace boxprobe;

RefineSettings endingAt(int rays, double until = 0.0) {
  RefineSettings settings;
  settings.rays = rays;
  settings.until = until;
  return settings;
}

TEST(Refinement, StagesHaveFourTimesTheRaysAndEndWithThoseAskedFor) {
  for (const auto& [asked, stages] : std::vector<std::pair<int, std::vector<int>>>{
           {256, {64, 256}}, {1, {1}}, {16, {16}}, {100, {64, 100}}, {1025, {64, 256, 1024, 1025}}}) {
    Refinement refinement;
    refinement.begin(endingAt(asked), 5);
    int frames = 1;
    for (const int inAll : stages) {
      ASSERT_TRUE(refinement.more()) << asked;
      EXPECT_EQ(refinement.rays().inAll, inAll) << asked;
      EXPECT_GE(refinement.rays().aFrame * refinement.frames(), inAll) << asked;
      EXPECT_LE(refinement.rays().aFrame, 8) << asked;
      EXPECT_EQ(refinement.framesBefore(), frames);
      frames += refinement.frames();
      refinement.endStage({0.3, 20.0});
      EXPECT_EQ(refinement.raysDone(), inAll);
    }
    EXPECT_FALSE(refinement.more()) << asked;
    EXPECT_EQ(refinement.framesInAll(), frames) << asked;
  }
}

TEST(Refinement, AGoodFrameIsNotReplacedByFewRays) {
  Refinement refinement;
  refinement.begin(endingAt(256), 64);
  EXPECT_EQ(refinement.rays().inAll, 256);
  EXPECT_LT(refinement.share(1), 0.2);
  // A single stage tells by its own frames what is left.
  EXPECT_LT(refinement.framesOfPart(), refinement.frames());
  refinement.endStage({0.2, 9.0}, {0.03, 2.0});
  EXPECT_GE(refinement.left(), 0.01);
  EXPECT_LE(refinement.left(), 0.06);
}

TEST(Refinement, AStageGrowsIntoThePictureAndStandsForItAtItsEnd) {
  Refinement refinement;
  refinement.begin(endingAt(256), 5);
  while (refinement.more()) {
    double last = 0.0;
    for (int done = 1; done <= refinement.frames(); ++done) {
      const double share = refinement.share(done);
      EXPECT_GT(share, last);
      last = share;
    }
    EXPECT_DOUBLE_EQ(last, 1.0);
    // The few rays that have come in do not outweigh those before.
    if (refinement.raysDone() > 0) {
      EXPECT_LT(refinement.share(1), 0.4);
    }
    refinement.endStage({0.2, 9.0});
  }
}

TEST(Refinement, EndsWhereNothingMoreWouldShowOrEnoughIsReached) {
  Refinement refinement;
  refinement.begin(endingAt(4096), 5);
  refinement.endStage({0.2, 9.0});
  EXPECT_LT(refinement.left(), 0.0) << "the first stage replaces a picture of another kind";
  EXPECT_TRUE(refinement.more());
  refinement.endStage({0.004, 0.3});
  EXPECT_FALSE(refinement.more()) << "no step of eight bits";
  EXPECT_EQ(refinement.raysDone(), 256);

  refinement.begin(endingAt(4096, 0.02), 16);
  refinement.endStage({0.2, 9.0});
  refinement.endStage({0.06, 5.0});
  EXPECT_TRUE(refinement.more());
  refinement.endStage({0.015, 2.0});
  EXPECT_FALSE(refinement.more());
  EXPECT_GT(refinement.left(), 0.0);
  EXPECT_LE(refinement.left(), 0.02);
}

TEST(Refinement, TheChangeIsThatOfThePixelsThatDiffer) {
  std::vector<float> before, after;
  for (int i = 0; i < 2000; ++i) {
    const bool changed = i % 4 == 1;
    const float value = 0.3f + 0.0001f * static_cast<float>(i % 7);
    for (int c = 0; c < 3; ++c) {
      before.push_back(value);
      after.push_back(changed ? 1.1f * value : value);
    }
    before.push_back(1.0f);
    after.push_back(1.0f);
  }
  const PictureChange change = pictureChange(before, after, 1.0);
  EXPECT_NEAR(change.relativeRms, 0.1 / 1.1, 1e-4);
  EXPECT_GT(change.stepsOf8Bits, 5.0);
  EXPECT_LT(change.stepsOf8Bits, 8.0);
  EXPECT_EQ(pictureChange(before, before, 1.0), PictureChange{});
}

}  // namespace
