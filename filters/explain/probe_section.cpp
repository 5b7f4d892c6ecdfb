#include "filters/explain/probe_section.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "filters/explain/explanation_rows.h"

namespace boxprobe {

using namespace explained;

namespace {

constexpr char kAxisNames[] = "xyz";
/// Slab factors from here on mean "never": the ray is parallel to that plane.
constexpr float kNever = 1e30f;

/// A number to be subtracted: negative numbers in brackets.
std::string subtrahend(double value) {
  return value < 0.0 ? "(" + fixedText(value) + ")" : fixedText(value);
}

ExplanationRow slabRow(const ProbeExplanation& p, int axis) {
  const float t = (*p.slabFactors)[axis];
  const float r = p.reflectionProbe[axis];
  const std::string symbol = std::string("t_") + kAxisNames[axis];
  if (t > kNever) {
    return row(symbol, {"infinite"}, "",
               std::string("R has no part along ") + kAxisNames[axis] + ": that pair of planes is never met");
  }
  const bool positive = r > 0.0f;
  const float plane = positive ? p.boxMax[axis] : p.boxMin[axis];
  if (t == 0.0f && std::abs(r) > 0.0f && (plane - p.positionProbe[axis]) * r < 0.0f) {
    return scalar(symbol, t, kLength, "counts as 0: P lies beyond that plane");
  }
  const std::string formula = std::string(positive ? "(max - P)/R = (" : "(min - P)/R = (") + fixedText(plane) + " - " +
                              subtrahend(p.positionProbe[axis]) + ") / " + fixedText(r);
  return scalar(symbol, t, kLength, formula);
}

void addProjection(const ProbeExplanation& p, std::vector<ExplanationRow>& rows) {
  rows.push_back(vector("C", p.originWorld, kLength, "where the probe was captured"));
  const bool rotated = p.worldFromProbe != glm::dmat3(1.0);
  const std::string frame = rotated ? ", along the box's own axes" : "";
  rows.push_back(vector("P - C", p.positionProbe, kLength, "from the capture origin" + frame));
  if (rotated) rows.push_back(vector("R", p.reflectionProbe, "", "reflected direction along the box's own axes"));
  if (p.slabFactors) {
    rows.push_back(vector("min", p.boxMin, kLength, "box relative to C" + frame));
    rows.push_back(vector("max", p.boxMax, kLength, ""));
    const glm::vec3& t = *p.slabFactors;
    const int smallest = t.x <= t.y && t.x <= t.z ? 0 : t.y <= t.z ? 1 : 2;
    for (int axis = 0; axis < 3; ++axis) {
      rows.push_back(slabRow(p, axis));
      rows.back().marked = axis == smallest;
    }
  }
  if (p.hitDistance) {
    std::string meaning = p.slabFactors ? "min(t_x, t_y, t_z)" : "along R to the proxy";
    if (p.face >= 0) meaning += ": the ray leaves through the face " + boxFaceName(p.face);
    if (p.bevel > 0.0f && p.slabFactors) {
      rows.push_back(scalar("r", p.bevel, kLength, "radius of the box's rounded edges at this roughness"));
    }
    if (p.boxDistance) {
      rows.push_back(scalar("d_box", *p.boxDistance, kLength, meaning));
      meaning =
          p.distanceLookups > 0 ? "along R to the hit as the technique refines it" : "along R to the rounded edge";
      if (p.distanceLookups > 0) {
        meaning += ", by " + std::to_string(p.distanceLookups) + " lookups of the captured distances";
      }
    }
    rows.push_back(scalar("d", *p.hitDistance, kLength, meaning));
    rows.push_back(vector("H", p.hitWorld, kLength, "hit point, P + d R"));
    rows.push_back(vector("H - C", p.lookupDirection, kLength, "direction in which the cubemap is sampled"));
  } else {
    rows.push_back(vector("L", p.lookupDirection, "", "what the cubemap is looked up with; nothing is hit"));
  }
  if (p.trueDistance) {
    std::string meaning = "along R to the captured surface";
    if (p.hitDistance) meaning += "; the proxy is off by " + fixedText(std::abs(*p.hitDistance - *p.trueDistance));
    rows.push_back(scalar("d_true", *p.trueDistance, kLength, meaning));
  }
}

void addTexels(const ProbeExplanation& p, const Lookup& lookup, const ExplanationDetail& detail,
               std::vector<ExplanationRow>& rows) {
  std::vector<TexelShare> texels = lookup.texels;
  std::stable_sort(texels.begin(), texels.end(), [](const auto& a, const auto& b) { return a.share > b.share; });
  float rest = 0.0f;
  for (std::size_t i = 0; i < texels.size(); ++i) {
    const TexelShare& t = texels[i];
    const float share = lookup.weight * t.share;
    if (i >= detail.texelsPerLookup) {
      rest += share;
      continue;
    }
    ExplanationRow made;
    made.symbol = percent(share);
    made.meaning = "texel " + std::to_string(t.column) + ", " + std::to_string(t.row) + " of face " +
                   cubeFaceName(t.face) + ", level " + std::to_string(t.level);
    if (detail.texelValue) made.color = detail.texelValue(p, t);
    if (made.color) made.numbers = numbers(*made.color);
    made.detail = true;
    rows.push_back(made);
  }
  if (texels.size() <= detail.texelsPerLookup) return;
  rows.push_back(row(percent(rest), {}, "", std::to_string(texels.size() - detail.texelsPerLookup) + " more texels"));
  rows.back().detail = true;
}

std::string levelText(const Lookup& lookup, float maxLevel) {
  return "level " + fixedText(lookup.level, 2) + " of 0 to " + fixedText(maxLevel, 0) + ", baked for roughness " +
         fixedText(lookup.roughness, 3);
}

/// The sum of the lookups that are not shown.
ExplanationRow restRow(const ProbeExplanation& p, const std::vector<std::size_t>& rest) {
  glm::vec3 sum(0.0f);
  float share = 0.0f, low = p.maxLevel, high = 0.0f;
  for (const std::size_t i : rest) {
    const Lookup& lookup = p.lookups[i];
    sum += lookup.weight * lookup.value;
    share += lookup.weight;
    low = std::min(low, lookup.level);
    high = std::max(high, lookup.level);
  }
  return light("...", share > 0.0f ? sum / share : sum,
               std::to_string(rest.size()) + " more lookups, which bring less light: " + percent(share) +
                   " together, their mean; levels " + fixedText(low, 2) + " to " + fixedText(high, 2));
}

void addDiffuse(const DiffuseExplanation& d, std::vector<ExplanationRow>& rows) {
  if (d.nodes.empty()) return;
  const auto place = [](const glm::ivec3& n) {
    return std::to_string(n.x) + ", " + std::to_string(n.y) + ", " + std::to_string(n.z);
  };
  for (const LampAtPoint& lamp : d.lamps) {
    rows.push_back(light("E_lamp", lamp.light,
                         "lamp \"" + lamp.node + "\" as a shape: it fills " + percent(lamp.filled) +
                             " of the cosine hemisphere around N"));
  }
  std::string nodes;
  for (const LatticeNodeAtPoint& node : d.nodes) {
    nodes += (nodes.empty() ? "" : "; ") + place(node.node) + " by " + percent(node.weight) +
             (node.known ? "" : " (within something: filled from its neighbours)");
  }
  rows.push_back(light("E_lattice", d.lattice,
                       "everything else, from a lattice of " + std::to_string(d.nodeCount.x) + " x " +
                           std::to_string(d.nodeCount.y) + " x " + std::to_string(d.nodeCount.z) + " nodes" +
                           (d.cutWays > 0 ? " (" + std::to_string(d.cutWays) + " ways between them cut)" : "") + ": " +
                           nodes));
}

void addLookups(const Explanation& e, const ProbeExplanation& p, const ExplanationDetail& detail,
                std::vector<ExplanationRow>& rows) {
  std::vector<std::size_t> order(p.lookups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::size_t shown = order.size();
  if (order.size() > detail.lookupsPerProbe) {
    // Too many to list: shows those with most of the light.
    const auto brings = [&p](std::size_t i) {
      const glm::vec3& v = p.lookups[i].value;
      return p.lookups[i].weight * std::max({v.x, v.y, v.z});
    };
    std::stable_sort(order.begin(), order.end(), [&](auto a, auto b) { return brings(a) > brings(b); });
    shown = detail.lookupsOfMany;
  }
  for (std::size_t k = 0; k < shown; ++k) {
    const std::size_t i = order[k];
    const Lookup& lookup = p.lookups[i];
    std::string meaning = levelText(lookup, p.maxLevel);
    const float change = lookup.roughness - e.surface.roughness;
    constexpr float kSame = 5e-4f;
    if (std::abs(change) > kSame) {
      meaning += std::string(change < 0.0f ? " (sharper than" : " (softer than") + " the surface's " +
                 fixedText(e.surface.roughness, 3) + ")";
    }
    const std::string symbol = p.lookups.size() == 1 ? "fetch" : "fetch " + std::to_string(i + 1);
    if (p.lookups.size() > 1) meaning = percent(lookup.weight) + ", " + meaning;
    rows.push_back(light(symbol, lookup.value, meaning));
    addTexels(p, lookup, detail, rows);
  }
  if (shown < order.size()) rows.push_back(restRow(p, {order.begin() + static_cast<long>(shown), order.end()}));
  rows.push_back(light("L_spec", p.specular, "the probe's reflected light: its lookups by their shares"));
  if (p.coverage) {
    rows.push_back(scalar("a", *p.coverage, "", "how much of that the probe covers; the sky shows for 1 - a"));
    rows.push_back(light("L_sky", p.openSky,
                         p.openByLookup
                             ? "mean of the sky that each lookup sees"
                             : "the sky along R, not box-projected, at mip level " + fixedText(p.openSkyLevel, 2)));
  }
  if (p.occlusion) rows.push_back(scalar("o", *p.occlusion, "", "factor of L_spec: box occlusion by the distance d"));
  addDiffuse(p.diffuse, rows);
  rows.push_back(light("E/pi", p.irradiance, "its light from all directions around N, for the diffuse part"));
}

}  // namespace

ExplanationSection probeSection(const Explanation& e, std::size_t index, const ExplanationDetail& detail) {
  const ProbeExplanation& p = e.probes[index];
  ExplanationSection section{
      "Probe \"" + p.name + "\": " + percent(p.weight) + " of the pixel, technique " + p.technique,
      {},
      static_cast<int>(index)};
  std::string influence = "weight of its influence box at P";
  if (p.intensity != 1.0f) influence += "; intensity " + fixedText(p.intensity, 2);
  section.rows.push_back(scalar("w", p.influence, "", influence));
  addProjection(p, section.rows);
  if (p.lookups.empty()) {
    section.rows.push_back(
        row("fetch", {}, "",
            p.captured ? "none: its share is too small to show" : "none: not captured yet, it gives no light"));
  } else {
    addLookups(e, p, detail, section.rows);
  }
  return section;
}

}  // namespace boxprobe
