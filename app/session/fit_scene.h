// A probe and a camera for a model that came without a scene file. Called by loadScene; the user corrects by hand what
// bounds alone cannot know.
#pragma once

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"

namespace boxprobe {

/// World bounds of all instances; a unit box around the origin if there is no vertex.
Box modelBounds(const Model& model);

/// Probe whose box is `bounds` (a margin wider), captured at the centre.
Probe fittedProbe(const Box& bounds);

/// Camera named "main" outside `bounds`, above and to the right, that sees all of it at any aspect ratio of 1 and
/// above.
Camera fittedCamera(const Box& bounds);

}  // namespace boxprobe
