// See explanation_sections.h.
#include "filters/explain/explanation_sections.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

#include "filters/core/base/fixed_text.h"

namespace boxprobe {

namespace {

constexpr const char* kLength = "scene units";
constexpr char kAxes[] = "xyz";
/// Slab factors from here on stand for "never": the ray runs along that plane.
constexpr float kNever = 1e30f;

/// Components that are only rounding beside the largest are shown as 0.
template <typename Vector>
std::vector<std::string> numbers(const Vector& v) {
  constexpr double kRounding = 1e-6;
  const double largest = std::max({std::abs(v[0]), std::abs(v[1]), std::abs(v[2])});
  const auto text = [largest](double x) { return fixedText(std::abs(x) < kRounding * largest ? 0.0 : x); };
  return {text(v[0]), text(v[1]), text(v[2])};
}

std::string percent(double share) {
  constexpr double kSmallestShown = 5e-4;
  return share > 0.0 && share < kSmallestShown ? "<0.1 %" : fixedText(100.0 * share, 1) + " %";
}

/// A number to be subtracted: its own sign in brackets.
std::string subtrahend(double value) {
  return value < 0.0 ? "(" + fixedText(value) + ")" : fixedText(value);
}

ExplanationRow row(std::string symbol, std::vector<std::string> values, std::string unit, std::string meaning) {
  ExplanationRow made;
  made.symbol = std::move(symbol);
  made.numbers = std::move(values);
  made.unit = std::move(unit);
  made.meaning = std::move(meaning);
  return made;
}

ExplanationRow scalar(std::string symbol, double value, std::string unit, std::string meaning) {
  return row(std::move(symbol), {fixedText(value)}, std::move(unit), std::move(meaning));
}

template <typename Vector>
ExplanationRow vector(std::string symbol, const Vector& value, std::string unit, std::string meaning) {
  return row(std::move(symbol), numbers(value), std::move(unit), std::move(meaning));
}

ExplanationRow light(std::string symbol, const glm::vec3& value, std::string meaning) {
  ExplanationRow made = vector(std::move(symbol), value, "", std::move(meaning));
  made.color = value;
  return made;
}

ExplanationSection surfaceSection(const Explanation& e) {
  const SurfacePoint& s = e.surface;
  ExplanationSection section{"Surface: object \"" + s.object + "\", material \"" + s.material + "\"", {}, -1};
  auto& rows = section.rows;
  rows.push_back(vector("P", s.positionWorld, kLength, "shading point"));
  const bool normal = s.normalWorld != glm::vec3(0.0f);
  if (normal) {
    rows.push_back(vector("N", s.normalWorld, "", "shading normal, unit"));
  } else {
    rows.push_back(row("N", {"undefined"}, "", "the surface has no normal here"));
  }
  rows.push_back(vector("V", s.viewWorld, "", "towards the eye, unit"));
  if (normal) {
    rows.push_back(vector("R", e.reflectionWorld, "", "reflected direction, 2 max(N.V, 0) N - V"));
    rows.push_back(scalar("N.V", e.nDotV, "", "cosine of the angle of view"));
  }
  rows.push_back(
      scalar("p", s.roughness, "", "perceptual roughness; alpha = p^2 = " + fixedText(s.roughness * s.roughness)));
  ExplanationRow albedo = vector("albedo", s.albedo, "", "base colour; metallic " + fixedText(s.metallic, 2));
  albedo.color = s.albedo;
  rows.push_back(albedo);
  rows.push_back(vector("F_0", e.f0, "",
                        "reflectance at normal incidence: mix(" + fixedText(s.baseF0, 3) + ", base colour, metallic)"));
  if (s.occlusion < 1.0f)
    rows.push_back(scalar("AO", s.occlusion, "", "the material's occlusion, factor of all but emission"));
  if (s.opacity < 1.0f) rows.push_back(scalar("opacity", s.opacity, "", "of the surface"));
  return section;
}

ExplanationRow slabRow(const ProbeExplanation& p, int axis) {
  const float t = (*p.slabFactors)[axis];
  const float r = p.reflectionProbe[axis];
  const std::string symbol = std::string("t_") + kAxes[axis];
  if (t > kNever) {
    return row(symbol, {"infinite"}, "",
               std::string("R has no part along ") + kAxes[axis] + ": that pair of planes is never met");
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
          p.distanceLookups > 0 ? "along R to where the technique takes the hit to be" : "along R to the rounded edge";
      if (p.distanceLookups > 0) {
        meaning += ", by " + std::to_string(p.distanceLookups) + " lookups of the distances the probe saw";
      }
    }
    rows.push_back(scalar("d", *p.hitDistance, kLength, meaning));
    rows.push_back(vector("H", p.hitWorld, kLength, "hit point, P + d R"));
    rows.push_back(vector("H - C", p.lookupDirection, kLength, "what the cubemap is looked up with"));
  } else {
    rows.push_back(vector("L", p.lookupDirection, "", "what the cubemap is looked up with; nothing is hit"));
  }
  if (p.trueDistance) {
    std::string meaning = "along R to what the probe itself saw";
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

/// What the fetches that are not shown bring together.
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
               std::to_string(rest.size()) + " more fetches, which bring less light: " + percent(share) +
                   " together, their mean; levels " + fixedText(low, 2) + " to " + fixedText(high, 2));
}

void addLookups(const Explanation& e, const ProbeExplanation& p, const ExplanationDetail& detail,
                std::vector<ExplanationRow>& rows) {
  std::vector<std::size_t> order(p.lookups.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::size_t shown = order.size();
  if (order.size() > detail.lookupsPerProbe) {
    // Too many to read: those that bring most of the light.
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
  rows.push_back(light("L_spec", p.specular, "the probe's reflected light: its fetches by their shares"));
  if (p.coverage) {
    rows.push_back(scalar("a", *p.coverage, "", "how much of that the probe covers; the sky shows for 1 - a"));
    rows.push_back(light("L_sky", p.openSky,
                         p.openByLookup ? "the sky each lookup looks out to, their mean"
                                        : "the sky along R, uncorrected, at level " + fixedText(p.openSkyLevel, 2)));
  }
  if (p.occlusion) rows.push_back(scalar("o", *p.occlusion, "", "factor of L_spec: box occlusion by the distance d"));
  rows.push_back(light("E/pi", p.irradiance, "its light from all around N, for the diffuse part"));
}

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
        row("fetch", {}, "", p.captured ? "none: its share cannot show" : "none: not captured yet, it gives no light"));
  } else {
    addLookups(e, p, detail, section.rows);
  }
  return section;
}

ExplanationSection skySection(const Explanation& e) {
  ExplanationSection section{"Sky: " + percent(e.skyWeight) + " of the pixel", {}, -1};
  section.rows.push_back(
      light("L_sky", e.skyValue, "what no probe takes, looked up along R at level " + fixedText(e.skyLevel, 2)));
  return section;
}

ExplanationSection glassSection(const Explanation& e) {
  const GlassExplanation& g = *e.glass;
  ExplanationSection section{"Glass: " + g.form + (g.back ? ", seen from within" : ""), {}, -1};
  auto& rows = section.rows;
  rows.push_back(
      scalar("n_1/n_2", g.eta, "", "index on the eye's side over that beyond; the glass has " + fixedText(g.ior)));
  rows.push_back(scalar("F", g.reflectance, "",
                        g.reflectance >= 1.0f ? "totally reflected: the view is flatter than the critical angle"
                                              : "Fresnel's reflectance at N.V, the exact one of a dielectric"));
  std::string direction = "where the view goes on: what the probes are asked for";
  if (g.form == "two-interface" && !g.back) {
    direction += ", bent at the front and where it leaves";
    if (g.mirrored > 0) direction += "; mirrored within " + std::to_string(g.mirrored) + " times on the way";
  }
  rows.push_back(vector("T", g.directionWorld, "", direction));
  rows.push_back(vector("Q", g.exitWorld, kLength, "from where it is followed to the box"));
  rows.push_back(scalar("x", g.distance, kLength, "the way within"));
  rows.push_back(scalar("p_T", g.roughness, "", "roughness of a mirror that would scatter as far: the level's"));
  rows.push_back(light("Beer", g.transmittance, "left of white light after x"));
  rows.push_back(light("passes", g.passed, "factor: transmission (1 - reflected) base colour Beer"));
  rows.push_back(light("L_T", g.looked, "found along T: " + g.sources));
  return section;
}

ExplanationSection mirrorSection(const Explanation& e) {
  const MirrorExplanation& m = *e.mirror;
  ExplanationSection section{
      "Planar mirror: objects that move take " + percent(m.coverage) + " of the reflection", {}, -1};
  auto& rows = section.rows;
  rows.push_back(scalar("a", m.coverage, "", "coverage of the mirror's picture over the lobe; the probes keep 1 - a"));
  if (m.coverage > 0.0f) {
    rows.push_back(scalar("d_dyn", m.hitDistance, kLength, "along R to what moves, by its height over the mirror"));
    rows.push_back(
        scalar("level", m.level, "",
               "whose texels are as large as the lobe at that distance; " + std::to_string(m.fetches) + " fetches"));
    rows.push_back(light("L_dyn", m.light, "its light, times a"));
  }
  if (m.share != 1.0f) rows.push_back(scalar("s", m.share, "", "factor of L_dyn: share and intensity of the probes"));
  return section;
}

ExplanationSection shadowSection(const LightShadow& shadow) {
  ExplanationSection section{"Light " + std::to_string(shadow.light) + ": what lets it through", {}, -1};
  auto& rows = section.rows;
  rows.push_back(vector("L", shadow.toLight, "", "towards the light"));
  for (const ProbeShadow& p : shadow.probes) {
    rows.push_back(scalar("d", p.distance, kLength, "along L to where it leaves the box of probe \"" + p.name + "\""));
    rows.push_back(vector("H", p.hitWorld, kLength, "there; what the probe's coverage is looked up for"));
    rows.push_back(light("T", p.through, "1 - coverage, coloured by glass, at level " + fixedText(p.level, 2)));
  }
  if (shadow.moving) rows.push_back(scalar("m", *shadow.moving, "", "factor of the shadow map of what moves"));
  rows.push_back(light("through", shadow.through,
                       shadow.facesAway ? "none: the surface faces away from it" : "factor of the light in `direct`"));
  return section;
}

ExplanationSection sumSection(const Explanation& e) {
  ExplanationSection section{"Sum", {}, -1};
  auto& rows = section.rows;
  rows.push_back(light("direct", e.direct, "light sources"));
  rows.push_back(light("emissive", e.emissive, "the surface's own light"));
  rows.push_back(light("diffuse", e.diffuse, "light from all around N, with the base colour"));
  rows.push_back(
      light("specular", e.specular,
            (e.glass ? "reflected light times F (A + B); A = " : "reflected light times F_0 A + F_90 B; A = ") +
                fixedText(e.brdf.x) + ", B = " + fixedText(e.brdf.y) + " of the split sum"));
  if (e.glass) rows.push_back(light("glass", e.glass->light(), "what is looked through: passes times L_T"));
  if (e.coat != glm::vec3(0.0f)) rows.push_back(light("coat", e.coat, "what the clear coat changes"));
  rows.push_back(light("color", e.color, "computed: linear light before exposure"));
  rows.back().sum = true;
  if (e.rendered) {
    const auto difference = relativeDifference(e);
    rows.push_back(light("rendered", *e.rendered,
                         "the pixel as drawn; differs by " + fixedText(*difference, 5) +
                             (e.brightestTexel > 0.0f ? " of the brightest texel" : " of the colour")));
  }
  return section;
}

}  // namespace

std::string boxFaceName(int face) {
  static constexpr std::array<const char*, 6> names = {"-x", "+x", "-y", "+y", "-z", "+z"};
  return face >= 0 && face < 6 ? names[static_cast<std::size_t>(face)] : "none";
}

std::string cubeFaceName(int face) {
  static constexpr std::array<const char*, 6> names = {"+X", "-X", "+Y", "-Y", "+Z", "-Z"};
  return face >= 0 && face < 6 ? names[static_cast<std::size_t>(face)] : "none";
}

std::optional<float> relativeDifference(const Explanation& e) {
  if (!e.rendered) return std::nullopt;
  const auto largest = [](const glm::vec3& v) { return std::max({std::abs(v.x), std::abs(v.y), std::abs(v.z)}); };
  const float difference = largest(*e.rendered - e.color);
  const float scale = e.brightestTexel > 0.0f ? e.brightestTexel : largest(*e.rendered);
  return scale > 0.0f ? difference / scale : difference;
}

std::vector<ExplanationSection> explanationSections(const Explanation& e, const ExplanationDetail& detail) {
  std::vector<ExplanationSection> sections;
  const std::string pixel = "Pixel " + std::to_string(e.x) + ", " + std::to_string(e.y);
  if (!e.hit) {
    ExplanationSection background{pixel + ": the background", {}, -1};
    background.rows.push_back(light("color", e.rendered.value_or(e.color), "what the sky shows there, linear"));
    return {background};
  }
  ExplanationSection head{pixel, {}, -1};
  head.rows.push_back(light("color", e.rendered.value_or(e.color), "linear light before exposure"));
  sections.push_back(head);
  sections.push_back(surfaceSection(e));
  for (std::size_t i = 0; i < e.probes.size(); ++i) sections.push_back(probeSection(e, i, detail));
  if (e.skyWeight > 0.0f) sections.push_back(skySection(e));
  if (e.glass) sections.push_back(glassSection(e));
  if (e.mirror) sections.push_back(mirrorSection(e));
  for (const LightShadow& shadow : e.shadows) sections.push_back(shadowSection(shadow));
  sections.push_back(sumSection(e));
  return sections;
}

}  // namespace boxprobe
