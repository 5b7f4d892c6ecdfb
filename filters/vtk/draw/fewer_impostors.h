// For drivers that link fewer textures than a draw's impostors need: each of them samples its distances by a sampler of
// its own. Chosen by the pass of a surface, once its program was refused.
#pragma once

#include <cstddef>
#include <memory>

#include "filters/vtk/draw/probe_binding.h"

namespace boxprobe {

/// How many of its probes are drawn by their distances.
std::size_t impostors(const ProbeBinding& binding);
/// The same binding with the least important impostor projected on its probe's box. Null if there is none.
std::shared_ptr<const ProbeBinding> withOneImpostorLess(const ProbeBinding& binding);
/// How many probes of their own technique `impostor` are drawn by their box in `binding`.
std::size_t impostorsLeftOut(const ProbeBinding& binding);

}  // namespace boxprobe
