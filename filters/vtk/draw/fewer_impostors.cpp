// See fewer_impostors.h.
#include "filters/vtk/draw/fewer_impostors.h"

namespace boxprobe {

namespace {

bool isImpostor(const Technique& technique) {
  return projectionRows()[static_cast<std::size_t>(technique.projection)].distances;
}

}  // namespace

std::size_t impostors(const ProbeBinding& binding) {
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < binding.probes.size(); ++slot) {
    count += isImpostor(binding.technique(slot)) ? 1 : 0;
  }
  return count;
}

std::shared_ptr<const ProbeBinding> withOneImpostorLess(const ProbeBinding& binding) {
  static const int box = parseTechnique("box")->projection;
  for (std::size_t slot = binding.probes.size(); slot-- > 0;) {
    if (!isImpostor(binding.technique(slot))) continue;
    auto fewer = std::make_shared<ProbeBinding>(binding);
    fewer->techniques.clear();
    for (std::size_t i = 0; i < binding.probes.size(); ++i) fewer->techniques.push_back(binding.technique(i));
    fewer->techniques[slot].projection = box;
    return fewer;
  }
  return nullptr;
}

std::size_t impostorsLeftOut(const ProbeBinding& binding) {
  std::size_t count = 0;
  for (std::size_t slot = 0; slot < binding.probes.size(); ++slot) {
    count += isImpostor(binding.probes[slot]->geometry.technique) && !isImpostor(binding.technique(slot)) ? 1 : 0;
  }
  return count;
}

}  // namespace boxprobe
