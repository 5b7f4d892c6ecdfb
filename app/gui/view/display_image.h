// Linear light as the window shows it. Called by what shows pictures beside the view.
#pragma once

#include <QImage>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// In display colours, at the scene's exposure and tone mapping. Null for a picture without pixels.
QImage displayImage(const ImageRgbaF& linear, double exposure, Tone tone);

}  // namespace boxprobe
