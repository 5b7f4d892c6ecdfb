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
    return row(
        symbol, {"infinite"}, "",
        Phrase::tr("R has no part along %1: that pair of planes is never met").arg(std::string(1, kAxisNames[axis])));
  }
  const bool positive = r > 0.0f;
  const float plane = positive ? p.boxMax[axis] : p.boxMin[axis];
  if (t == 0.0f && std::abs(r) > 0.0f && (plane - p.positionProbe[axis]) * r < 0.0f) {
    return scalar(symbol, t, kLength, Phrase::tr("counts as 0: P lies beyond that plane"));
  }
  const std::string formula = std::string(positive ? "(max - P)/R = (" : "(min - P)/R = (") + fixedText(plane) + " - " +
                              subtrahend(p.positionProbe[axis]) + ") / " + fixedText(r);
  return scalar(symbol, t, kLength, Phrase::plain(formula));
}

void addProjection(const ProbeExplanation& p, std::vector<ExplanationRow>& rows) {
  rows.push_back(vector("C", p.originWorld, kLength, Phrase::tr("where the probe was captured")));
  const bool rotated = p.worldFromProbe != glm::dmat3(1.0);
  rows.push_back(vector("P - C", p.positionProbe, kLength,
                        rotated ? Phrase::tr("from the capture origin, along the box's own axes")
                                : Phrase::tr("from the capture origin")));
  if (rotated) {
    rows.push_back(vector("R", p.reflectionProbe, "", Phrase::tr("reflected direction along the box's own axes")));
  }
  if (p.slabFactors) {
    rows.push_back(
        vector("min", p.boxMin, kLength,
               rotated ? Phrase::tr("box relative to C, along the box's own axes") : Phrase::tr("box relative to C")));
    rows.push_back(vector("max", p.boxMax, kLength, {}));
    const glm::vec3& t = *p.slabFactors;
    const int smallest = t.x <= t.y && t.x <= t.z ? 0 : t.y <= t.z ? 1 : 2;
    for (int axis = 0; axis < 3; ++axis) {
      rows.push_back(slabRow(p, axis));
      rows.back().marked = axis == smallest;
    }
  }
  if (p.hitDistance) {
    Phrase meaning = p.slabFactors ? Phrase::plain("min(t_x, t_y, t_z)") : Phrase::tr("along R to the proxy");
    if (p.face >= 0) {
      meaning = Phrase::tr("%1: the ray leaves through the face %2").arg(meaning).arg(boxFaceName(p.face));
    }
    if (p.bevel > 0.0f && p.slabFactors) {
      rows.push_back(scalar("r", p.bevel, kLength, Phrase::tr("radius of the box's rounded edges at this roughness")));
    }
    if (p.boxDistance) {
      rows.push_back(scalar("d_box", *p.boxDistance, kLength, meaning));
      meaning = p.distanceLookups > 0 ? Phrase::tr(
                                            "along R to the hit as the technique refines it, by %1 lookups of the "
                                            "captured distances")
                                            .arg(std::to_string(p.distanceLookups))
                                      : Phrase::tr("along R to the rounded edge");
    }
    rows.push_back(scalar("d", *p.hitDistance, kLength, meaning));
    rows.push_back(vector("H", p.hitWorld, kLength, Phrase::tr("hit point, P + d R")));
    rows.push_back(
        vector("H - C", p.lookupDirection, kLength, Phrase::tr("direction in which the cubemap is sampled")));
  } else {
    rows.push_back(
        vector("L", p.lookupDirection, "", Phrase::tr("what the cubemap is looked up with; nothing is hit")));
  }
  if (p.trueDistance) {
    const Phrase meaning = p.hitDistance ? Phrase::tr("along R to the captured surface; the proxy is off by %1")
                                               .arg(fixedText(std::abs(*p.hitDistance - *p.trueDistance)))
                                         : Phrase::tr("along R to the captured surface");
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
    made.symbol = Phrase::plain(percent(share));
    made.meaning = Phrase::tr("texel %1, %2 of face %3, level %4")
                       .arg(std::to_string(t.column))
                       .arg(std::to_string(t.row))
                       .arg(cubeFaceName(t.face))
                       .arg(std::to_string(t.level));
    if (detail.texelValue) made.color = detail.texelValue(p, t);
    if (made.color) made.numbers = numbers(*made.color);
    made.detail = true;
    rows.push_back(made);
  }
  if (texels.size() <= detail.texelsPerLookup) return;
  rows.push_back(row(percent(rest), {}, "",
                     Phrase::tr("%1 more texels").arg(std::to_string(texels.size() - detail.texelsPerLookup))));
  rows.back().detail = true;
}

Phrase levelText(const Lookup& lookup, float maxLevel) {
  return Phrase::tr("level %1 of 0 to %2, baked for roughness %3")
      .arg(fixedText(lookup.level, 2))
      .arg(fixedText(maxLevel, 0))
      .arg(fixedText(lookup.roughness, 3));
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
               Phrase::tr("%1 more lookups, which bring less light: %2 together, their mean; levels %3 to %4")
                   .arg(std::to_string(rest.size()))
                   .arg(percent(share))
                   .arg(fixedText(low, 2))
                   .arg(fixedText(high, 2)));
}

void addDiffuse(const DiffuseExplanation& d, std::vector<ExplanationRow>& rows) {
  if (d.nodes.empty()) return;
  const auto place = [](const glm::ivec3& n) {
    return std::to_string(n.x) + ", " + std::to_string(n.y) + ", " + std::to_string(n.z);
  };
  for (const LampAtPoint& lamp : d.lamps) {
    rows.push_back(light("E_lamp", lamp.light,
                         Phrase::tr("lamp \"%1\" as a shape: it fills %2 of the cosine hemisphere around N")
                             .arg(lamp.node)
                             .arg(percent(lamp.filled))));
  }
  Phrase nodes;
  for (const LatticeNodeAtPoint& node : d.nodes) {
    const Phrase weighed =
        (node.known ? Phrase::tr("%1 by %2") : Phrase::tr("%1 by %2 (within something: filled from its neighbours)"))
            .arg(place(node.node))
            .arg(percent(node.weight));
    nodes = nodes.empty() ? weighed : Phrase::tr("%1; %2").arg(nodes).arg(weighed);
  }
  const Phrase lattice =
      (d.cutWays > 0
           ? Phrase::tr("everything else, from a lattice of %1 x %2 x %3 nodes (%5 ways between them cut): %4")
           : Phrase::tr("everything else, from a lattice of %1 x %2 x %3 nodes: %4"))
          .arg(std::to_string(d.nodeCount.x))
          .arg(std::to_string(d.nodeCount.y))
          .arg(std::to_string(d.nodeCount.z))
          .arg(nodes)
          .arg(std::to_string(d.cutWays));
  rows.push_back(light("E_lattice", d.lattice, lattice));
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
    Phrase meaning = levelText(lookup, p.maxLevel);
    const float change = lookup.roughness - e.surface.roughness;
    constexpr float kSame = 5e-4f;
    if (std::abs(change) > kSame) {
      meaning = (change < 0.0f ? Phrase::tr("%1 (sharper than the surface's %2)")
                               : Phrase::tr("%1 (softer than the surface's %2)"))
                    .arg(meaning)
                    .arg(fixedText(e.surface.roughness, 3));
    }
    const bool single = p.lookups.size() == 1;
    const Phrase symbol = single ? Phrase::tr("fetch") : Phrase::tr("fetch %1").arg(std::to_string(i + 1));
    if (!single) meaning = Phrase::tr("%1, %2").arg(percent(lookup.weight)).arg(meaning);
    rows.push_back(light(symbol, lookup.value, meaning));
    addTexels(p, lookup, detail, rows);
  }
  if (shown < order.size()) rows.push_back(restRow(p, {order.begin() + static_cast<long>(shown), order.end()}));
  rows.push_back(light("L_spec", p.specular, Phrase::tr("the probe's reflected light: its lookups by their shares")));
  if (p.coverage) {
    rows.push_back(
        scalar("a", *p.coverage, "", Phrase::tr("how much of that the probe covers; the sky shows for 1 - a")));
    rows.push_back(light(
        "L_sky", p.openSky,
        p.openByLookup
            ? Phrase::tr("mean of the sky that each lookup sees")
            : Phrase::tr("the sky along R, not box-projected, at mip level %1").arg(fixedText(p.openSkyLevel, 2))));
  }
  if (p.occlusion)
    rows.push_back(scalar("o", *p.occlusion, "", Phrase::tr("factor of L_spec: box occlusion by the distance d")));
  addDiffuse(p.diffuse, rows);
  rows.push_back(
      light("E/pi", p.irradiance, Phrase::tr("its light from all directions around N, for the diffuse part")));
}

}  // namespace

ExplanationSection probeSection(const Explanation& e, std::size_t index, const ExplanationDetail& detail) {
  const ProbeExplanation& p = e.probes[index];
  ExplanationSection section{
      Phrase::tr("Probe \"%1\": %2 of the pixel, technique %3").arg(p.name).arg(percent(p.weight)).arg(p.technique),
      {},
      static_cast<int>(index)};
  const Phrase influence =
      p.intensity != 1.0f ? Phrase::tr("weight of its influence box at P; intensity %1").arg(fixedText(p.intensity, 2))
                          : Phrase::tr("weight of its influence box at P");
  section.rows.push_back(scalar("w", p.influence, "", influence));
  addProjection(p, section.rows);
  if (p.lookups.empty()) {
    section.rows.push_back(row(Phrase::tr("fetch"), {}, "",
                               p.captured ? Phrase::tr("none: its share is too small to show")
                                          : Phrase::tr("none: not captured yet, it gives no light")));
  } else {
    addLookups(e, p, detail, section.rows);
  }
  return section;
}

}  // namespace boxprobe
