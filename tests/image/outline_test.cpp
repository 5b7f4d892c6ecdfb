// The outline about what is selected: where it is drawn, and that pictures of other sizes leave it as it was.
#include <gtest/gtest.h>
#include <vtkRenderWindow.h>

#include "filters/vtk/draw/window_view.h"
#include "tests/support/scene_picture.h"

namespace boxprobe::test {
namespace {

class OutlineTest : public ::testing::Test {
 protected:
  void SetUp() override {
    for (Probe& probe : picture_.scene.probes) probe.faceSize = 16;
    picture_.show(cameraNamed(picture_.scene, "main"));
  }
  ImageRgba8 outlined(const std::string& node) {
    WindowView view;
    if (!node.empty()) view.outlined = {node};
    picture_.renderer->setWindowView(view);
    return picture_.display();
  }
  /// Rows of the picture, from the top, in which it differs from one without an outline.
  std::vector<int> rowsWithOutline(const ImageRgba8& image, const ImageRgba8& without) {
    std::vector<int> rows;
    for (int y = 0; y < image.height; ++y) {
      int differing = 0;
      for (int i = 4 * y * image.width; i < 4 * (y + 1) * image.width; ++i) {
        differing += std::abs(image.pixels[i] - without.pixels[i]) > 40;
      }
      if (differing > 0) rows.push_back(y);
    }
    return rows;
  }
  ScenePicture picture_ = ScenePicture::fromFile("scenes/room.boxprobe.json", 301, 203);
};

// The floor is cut by the lower edge of the picture.
TEST_F(OutlineTest, DoesNotComeBackAtTheOppositeEdge) {
  const ImageRgba8 without = outlined(""), with = outlined("floor");
  keepPicture(with, "outline_floor");
  const std::vector<int> rows = rowsWithOutline(with, without);
  ASSERT_FALSE(rows.empty());
  std::printf("  rows %d to %d\n", rows.front(), rows.back());
  EXPECT_GT(rows.front(), 40);
}

TEST_F(OutlineTest, IsTheSameAfterAPictureOfAnotherSize) {
  const ImageRgba8 with = outlined("floor");
  EXPECT_TRUE(outlined("floor").pixels == with.pixels) << "the second frame";
  picture_.window->SetSize(514, 388);
  picture_.display();
  picture_.window->SetSize(301, 203);
  const ImageRgba8 again = picture_.display();
  keepPicture(again, "outline_again");
  EXPECT_TRUE(again.pixels == with.pixels);
  (void)outlined("");
  (void)picture_.renderer->renderLinear(97, 61, 1);
  EXPECT_TRUE(outlined("floor").pixels == with.pixels);
}

}  // namespace
}  // namespace boxprobe::test
