// What a frame's report says of lookups, against a picture whose every value is another one.
#include <gtest/gtest.h>
#include <vtkRenderer.h>

#include "filters/vtk/inspect/frame_recorder.h"

namespace boxprobe {
namespace {

TEST(FrameReport, LookupsAreOfSurfacesAlone) {
  ImageRgbaF picture;
  picture.width = 5;
  picture.height = 1;
  // The view of lookups writes the number as red; green, blue and alpha are no numbers of lookups.
  picture.pixels = {2.0f,  31.0f, 41.0f, 1.0f,  //
                    7.0f,  53.0f, 61.0f, 0.5f,  //
                    90.0f, 71.0f, 81.0f, 0.0f,  // no surface
                    -3.0f, 91.0f, 17.0f, 1.0f,  // what is below none is none
                    4.0f,  19.0f, 23.0f, 1.0f};
  const FrameReport::Lookups lookups = lookupsOf(picture);
  EXPECT_DOUBLE_EQ(lookups.mean, (2.0 + 7.0 + 0.0 + 4.0) / 4.0);
  EXPECT_EQ(lookups.most, 7.0);
}

TEST(FrameReport, WithoutASurfaceThereAreNone) {
  ImageRgbaF picture;
  picture.width = 2;
  picture.height = 1;
  picture.pixels = {5.0f, 6.0f, 7.0f, 0.0f, 8.0f, 9.0f, 10.0f, 0.0f};
  const FrameReport::Lookups lookups = lookupsOf(picture);
  EXPECT_EQ(lookups.mean, 0.0);
  EXPECT_EQ(lookups.most, 0.0);
}

}  // namespace
}  // namespace boxprobe
