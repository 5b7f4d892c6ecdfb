// Every row of the debug view's table side by side in one picture: `render --view all`.
#pragma once

#include <functional>

#include "filters/core/scene/model.h"

namespace boxprobe {

class SceneRenderer;

/// Four views a row, each the size of the window, in the table's order. `check` is called before each and may throw.
/// Leaves the picture itself as the active view.
ImageRgba8 renderViewSheet(SceneRenderer& renderer, const std::function<void()>& check);

}  // namespace boxprobe
