// For drivers with few texture units (macOS and old cards have 16 for a fragment program): what a draw goes without,
// one thing after another, until its program links. Chosen by the pass of a surface, once its program was refused.
#pragma once

#include <memory>

#include "filters/core/base/phrase.h"
#include "filters/vtk/draw/probe_binding.h"
#include "filters/vtk/draw/surface_material.h"

namespace boxprobe {

/// The same binding with one thing less, in this order: the least important impostor is projected on its probe's box;
/// rays are chosen without the probes' tables of light; the sky is not occluded; the least important probe is left out,
/// but the last stays; moving objects throw no shadows by maps. What keeps light out of a room stays. Null if nothing
/// is left to give up.
std::shared_ptr<const ProbeBinding> withLess(const ProbeBinding& binding);

/// The same material without the texture that shows least, as if its file did not name it. Null if it has only those
/// without which it would be another material: base colour, roughness and metal, and the shares of what would then be
/// everywhere on it (emission, transmission, coat, sheen, iridescence).
std::shared_ptr<const SurfaceMaterial> withTextureLess(const SurfaceMaterial& surface);

/// As the end of a line: "2 impostors are drawn by box, 1 probe is left out". Empty if nothing was given up.
Phrase givenUpText(const GivenUp& givenUp, std::size_t textures);

}  // namespace boxprobe
