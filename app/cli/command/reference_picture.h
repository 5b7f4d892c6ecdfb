// `render --technique reference-box|reference-scene|reference-path`: the truth, in place of a technique's picture.
// Called by `render` once the options that both have in common are checked.
#pragma once

#include <string>

#include "app/cli/options/render_options.h"
#include "app/session/interrupt.h"
#include "app/session/load_scene.h"

namespace boxprobe {

/// Is this --technique a reference?
bool isReference(const std::string& technique);

/// Does this --view need traced diffuse light?
bool comparesDiffuse(const std::string& view);

/// What SceneRenderer::setDiffuseTruth takes: --rays paths per pixel, bounces as of
/// reference-path.
/// Throws WorkError if interrupted.
ImageRgbaF traceDiffuse(const LoadedScene& loaded, const Camera& camera, const RenderOptions& options,
                        const InterruptGuard& interrupt);

/// Options that only a reference has must not be passed over in silence: throws InputError.
void refuseReferenceOptions(const RenderOptions& options);

/// Renders and writes it. An .exr (`linear`) has three more channels, standardError.R, .G and .B. Interrupted, it
/// leaves what it has beside the output, `.partial` appended to the name, and throws WorkError.
void renderReference(const RenderOptions& options, bool linear);

}  // namespace boxprobe
