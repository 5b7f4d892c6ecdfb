#include "filters/vtk/draw/surface_facts.h"

#include <vtkProperty.h>

#include <algorithm>
#include <bitset>
#include <map>

namespace boxprobe {

namespace {

bool sameUse(const SurfaceSlot& a, const SurfaceSlot& b) {
  return a.texture && a.texture == b.texture && a.uvSet == b.uvSet && a.uvTransform == b.uvTransform;
}

// A rough estimate of the saving: a lookup or the lamps' lobes cost more than a product.
int worth(SurfaceFacts facts) {
  constexpr SurfaceFacts kMuch = kNoMetal | kAllMetal | kSmooth | kEmissionIsBase | kOcclusionInRoughMetal;
  return static_cast<int>(4 * std::bitset<32>(facts & kMuch).count() + std::bitset<32>(facts & ~kMuch).count());
}

/// For the objects of one program: how many have which facts.
using Kinds = std::map<SurfaceFacts, int>;

SurfaceFacts shared(const Kinds& kinds) {
  SurfaceFacts facts = kAnyFact;
  for (const auto& kind : kinds) facts &= kind.first;
  return facts;
}

int worthOf(const Kinds& kinds) {
  int objects = 0;
  for (const auto& kind : kinds) objects += kind.second;
  return objects * worth(shared(kinds));
}

}  // namespace

SurfaceFacts surfaceFacts(const SurfaceMaterial& surface, vtkProperty* property) {
  if (surface.glass.drawn) return 0;
  const auto& slots = surface.slots;
  SurfaceFacts facts = kQuickOutput;
  const bool plain = std::all_of(slots.begin(), slots.end(), [](const SurfaceSlot& slot) {
    return !slot.texture || slot.uvTransform == SurfaceSlot().uvTransform;
  });
  if (plain) facts |= kPlainUv;
  if (surface.alphaMode == AlphaMode::Opaque && property->GetOpacity() >= 1.0) facts |= kNeverDiscarded;
  if (surface.unlit) return facts;
  const bool textured = slots[kRoughMetalSlot].texture != nullptr;
  if (property->GetMetallic() <= 0.0) facts |= kNoMetal;
  if (property->GetMetallic() >= 1.0 && !textured) facts |= kAllMetal;
  if (property->GetRoughness() <= 0.0 && property->GetCoatStrength() <= 0.0 && !surface.finished()) {
    facts |= kSmooth;
  }
  const double* emission = property->GetEmissiveFactor();
  if (emission[0] == 0.0 && emission[1] == 0.0 && emission[2] == 0.0) {
    facts |= kNoEmission;
  } else if (sameUse(slots[kEmissiveSlot], slots[kBaseColorSlot])) {
    facts |= kEmissionIsBase;
  }
  if (sameUse(slots[kOcclusionSlot], slots[kRoughMetalSlot])) facts |= kOcclusionInRoughMetal;
  return facts;
}

std::vector<SurfaceFacts> planFacts(const std::vector<FactUse>& uses) {
  std::map<std::string, Kinds> whole;
  for (const FactUse& use : uses) ++whole[use.program][use.facts];
  // Parts of programs. Dividing a part removes one kind of objects from it, which becomes a separate part.
  struct Part {
    const std::string* program;
    Kinds kinds;
  };
  std::vector<Part> parts;
  for (const auto& entry : whole) parts.push_back({&entry.first, entry.second});
  for (std::size_t more = whole.size() / 2; more > 0; --more) {
    int best = 0;
    std::size_t from = 0;
    SurfaceFacts kind = 0;
    for (std::size_t i = 0; i < parts.size(); ++i) {
      const Kinds& kinds = parts[i].kinds;
      if (kinds.size() < 2) continue;
      for (const auto& candidate : kinds) {
        Kinds rest = kinds;
        rest.erase(candidate.first);
        const int gain = candidate.second * worth(candidate.first) + worthOf(rest) - worthOf(kinds);
        if (gain <= best) continue;
        best = gain;
        from = i;
        kind = candidate.first;
      }
    }
    if (best == 0) break;
    parts.push_back({parts[from].program, {{kind, parts[from].kinds[kind]}}});
    parts[from].kinds.erase(kind);
  }
  std::map<std::pair<std::string, SurfaceFacts>, SurfaceFacts> planned;
  for (const Part& part : parts) {
    for (const auto& kind : part.kinds) planned[{*part.program, kind.first}] = shared(part.kinds);
  }
  std::vector<SurfaceFacts> facts;
  facts.reserve(uses.size());
  for (const FactUse& use : uses) facts.push_back(planned.at({use.program, use.facts}));
  return facts;
}

}  // namespace boxprobe
