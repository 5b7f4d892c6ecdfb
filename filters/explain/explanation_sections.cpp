// See explanation_sections.h.
#include "filters/explain/explanation_sections.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <numeric>

namespace boxprobe {

using namespace explained;

namespace {

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
    if (e.lookupNormal != glm::vec3(0.0f) && e.lookupNormal != s.normalWorld) {
      rows.push_back(vector("N_b", e.lookupNormal, "", "N bent towards the eye across the brushing; R is about it"));
    }
    rows.push_back(vector("R", e.reflectionWorld, "", "reflected direction, 2 max(N.V, 0) N - V"));
    rows.push_back(scalar("N.V", e.nDotV, "", "cosine of the view angle"));
  }
  rows.push_back(
      scalar("p", s.roughness, "", "perceptual roughness; alpha = p^2 = " + fixedText(s.roughness * s.roughness)));
  ExplanationRow albedo = vector("albedo", s.albedo, "", "base colour; metallic " + fixedText(s.metallic, 2));
  albedo.color = s.albedo;
  rows.push_back(albedo);
  rows.push_back(vector("F_0", e.f0, "",
                        "reflectance at normal incidence: mix(" + fixedText(s.baseF0, 3) + ", base colour, metallic)"));
  if (s.occlusion < 1.0f)
    rows.push_back(scalar("AO", s.occlusion, "", "the material's occlusion, a factor of all light but emission"));
  if (s.opacity < 1.0f) rows.push_back(scalar("opacity", s.opacity, "", "of the surface"));
  return section;
}

ExplanationSection skySection(const Explanation& e) {
  ExplanationSection section{"Sky: " + percent(e.skyWeight) + " of the pixel", {}, -1};
  section.rows.push_back(light(
      "L_sky", e.skyValue, "the share that no probe takes, sampled along R at mip level " + fixedText(e.skyLevel, 2)));
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
                                              : "exact Fresnel reflectance of a dielectric at N.V"));
  std::string direction = "refracted view direction, in which the probes are sampled";
  if (g.form == "two-interface" && !g.back) {
    direction += ", bent at the front and where it leaves";
    if (g.mirrored > 0) direction += "; mirrored within " + std::to_string(g.mirrored) + " times on the way";
  }
  rows.push_back(vector("T", g.directionWorld, "", direction));
  rows.push_back(vector("Q", g.exitWorld, kLength, "from where it is followed to the box"));
  rows.push_back(scalar("x", g.distance, kLength, "the way within"));
  rows.push_back(
      scalar("p_T", g.roughness, "", "roughness of a mirror that would scatter as far; gives the mip level"));
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
  const float all = e.color.x + e.color.y + e.color.z;
  const std::string share =
      all > 0.0f ? "; " + percent((e.diffuse.x + e.diffuse.y + e.diffuse.z) / all) + " of the pixel" : std::string();
  rows.push_back(light("diffuse", e.diffuse, "light from all directions around N, times the base colour" + share));
  rows.push_back(
      light("specular", e.specular,
            (e.glass ? "reflected light times F (A + B); A = " : "reflected light times F_0 A + F_90 B; A = ") +
                fixedText(e.brdf.x) + ", B = " + fixedText(e.brdf.y) + " of the split sum"));
  if (e.glass) rows.push_back(light("glass", e.glass->light(), "what is looked through: passes times L_T"));
  if (e.sheen != glm::vec3(0.0f))
    rows.push_back(light("sheen", e.sheen, "the same light, sent back by cloth's fibres"));
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
  std::vector<std::size_t> order(e.probes.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::stable_sort(order.begin(), order.end(),
                   [&e](std::size_t a, std::size_t b) { return e.probes[a].weight > e.probes[b].weight; });
  for (const std::size_t i : order) sections.push_back(probeSection(e, i, detail));
  if (e.skyWeight > 0.0f) sections.push_back(skySection(e));
  if (e.glass) sections.push_back(glassSection(e));
  if (e.mirror) sections.push_back(mirrorSection(e));
  for (const LightShadow& shadow : e.shadows) sections.push_back(shadowSection(shadow));
  sections.push_back(sumSection(e));
  return sections;
}

}  // namespace boxprobe
