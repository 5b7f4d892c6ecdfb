// See view_sheet.h.
#include "app/cli/report/view_sheet.h"

#include <algorithm>

#include "filters/core/scene/surface_view.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

ImageRgba8 renderViewSheet(SceneRenderer& renderer, const std::function<void()>& check) {
  constexpr std::size_t kColumns = 4;
  constexpr std::size_t kGap = 4;
  const std::size_t views = surfaceViews().size();
  const std::size_t rows = (views + kColumns - 1) / kColumns;
  ImageRgba8 sheet;
  for (std::size_t view = 0; view < views; ++view) {
    check();
    renderer.setView({static_cast<int>(view), {}, {}});
    const ImageRgba8 picture = renderer.renderDisplay();
    const auto width = static_cast<std::size_t>(picture.width), height = static_cast<std::size_t>(picture.height);
    if (view == 0) {
      sheet.width = static_cast<int>(kColumns * (width + kGap) - kGap);
      sheet.height = static_cast<int>(rows * (height + kGap) - kGap);
      sheet.pixels.assign(static_cast<std::size_t>(sheet.width) * static_cast<std::size_t>(sheet.height) * 4, 255);
    }
    const std::size_t left = view % kColumns * (width + kGap), top = view / kColumns * (height + kGap);
    for (std::size_t y = 0; y < height; ++y) {
      const auto from = picture.pixels.begin() + static_cast<std::ptrdiff_t>(y * width * 4);
      const std::size_t to = ((top + y) * static_cast<std::size_t>(sheet.width) + left) * 4;
      std::copy(from, from + static_cast<std::ptrdiff_t>(width * 4),
                sheet.pixels.begin() + static_cast<std::ptrdiff_t>(to));
    }
  }
  renderer.setView({});
  return sheet;
}

}  // namespace boxprobe
