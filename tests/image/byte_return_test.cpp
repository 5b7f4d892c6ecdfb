// What is stored is what is shown: bytes of an unlit picture come back from the window as they are in the file.
#include <gtest/gtest.h>

#include "tests/image/gltf_picture.h"

namespace boxprobe::test {
namespace {

class ByteReturn : public GltfPicture {};

// 256 greys in four rows of 64 texels, and under them a row of colours; each texel is a column of pixels wide.
TEST_F(ByteReturn, GreysAndColoursAreShownAsStored) {
  constexpr int kRows = 5, kNearest = 9728;
  const std::array<std::array<std::uint8_t, 3>, 6> colors = {
      {{255, 3, 8}, {16, 201, 32}, {37, 64, 250}, {140, 23, 11}, {1, 187, 222}, {243, 128, 5}}};
  std::vector<std::uint8_t> texels;
  for (int i = 0; i < kRows * kSize; ++i) {
    const std::array<std::uint8_t, 3>& color = colors[static_cast<std::size_t>(i) % colors.size()];
    for (std::size_t c = 0; c < 3; ++c) texels.push_back(i < 256 ? static_cast<std::uint8_t>(i) : color[c]);
    texels.push_back(255);
  }
  const int picture8 = texture(kSize, texels, {{"magFilter", kNearest}, {"minFilter", kNearest}});
  show(square(), merged(unlit(), {{"pbrMetallicRoughness", {{"baseColorTexture", {{"index", picture8}}}}}}));
  for (const bool lit : {true, false}) {
    probes = lit;
    draw();
    picture->scene.tone = Tone::None;  // a bare model has another one
    picture->renderer->sync(picture->scene, Changes::all());
    picture->renderer->finishWork();
    const ImageRgba8 shown = picture->display();
    int wrong = 0;
    for (int row = 0; row < kRows; ++row) {
      const int y = (2 * row + 1) * kSize / (2 * kRows);
      for (int x = 0; x < kSize; ++x) {
        for (int c = 0; c < 3; ++c) {
          const int is = shown.pixels[static_cast<std::size_t>(4 * (y * kSize + x) + c)];
          const int was = texels[static_cast<std::size_t>(4 * (row * kSize + x) + c)];
          if (is != was && ++wrong < 8) ADD_FAILURE() << was << " is shown as " << is << ", row " << row;
        }
      }
    }
    EXPECT_EQ(wrong, 0);
  }
}

}  // namespace
}  // namespace boxprobe::test
