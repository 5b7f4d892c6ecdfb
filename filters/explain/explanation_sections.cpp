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
  ExplanationSection section{
      Phrase::tr("Surface: object \"%1\", material \"%2\"").arg(s.object).arg(s.material), {}, -1};
  auto& rows = section.rows;
  rows.push_back(vector("P", s.positionWorld, kLength, Phrase::tr("shading point")));
  const bool normal = s.normalWorld != glm::vec3(0.0f);
  if (normal) {
    rows.push_back(vector("N", s.normalWorld, "", Phrase::tr("shading normal, unit")));
  } else {
    rows.push_back(row("N", {"undefined"}, "", Phrase::tr("the surface has no normal here")));
  }
  rows.push_back(vector("V", s.viewWorld, "", Phrase::tr("towards the eye, unit")));
  if (normal) {
    if (e.lookupNormal != glm::vec3(0.0f) && e.lookupNormal != s.normalWorld) {
      rows.push_back(
          vector("N_b", e.lookupNormal, "", Phrase::tr("N bent towards the eye across the brushing; R is about it")));
    }
    rows.push_back(vector("R", e.reflectionWorld, "", Phrase::tr("reflected direction, 2 max(N.V, 0) N - V")));
    rows.push_back(scalar("N.V", e.nDotV, "", Phrase::tr("cosine of the view angle")));
  }
  rows.push_back(
      scalar("p", s.roughness, "",
             Phrase::tr("perceptual roughness; alpha = p^2 = %1").arg(fixedText(s.roughness * s.roughness))));
  ExplanationRow albedo =
      vector(Phrase::tr("albedo"), s.albedo, "", Phrase::tr("base colour; metallic %1").arg(fixedText(s.metallic, 2)));
  albedo.color = s.albedo;
  rows.push_back(albedo);
  rows.push_back(vector(
      "F_0", e.f0, "",
      Phrase::tr("reflectance at normal incidence: mix(%1, base colour, metallic)").arg(fixedText(s.baseF0, 3))));
  if (s.occlusion < 1.0f)
    rows.push_back(
        scalar("AO", s.occlusion, "", Phrase::tr("the material's occlusion, a factor of all light but emission")));
  if (s.opacity < 1.0f) rows.push_back(scalar(Phrase::tr("opacity"), s.opacity, "", Phrase::tr("of the surface")));
  return section;
}

ExplanationSection skySection(const Explanation& e) {
  ExplanationSection section{Phrase::tr("Sky: %1 of the pixel").arg(percent(e.skyWeight)), {}, -1};
  section.rows.push_back(light(
      "L_sky", e.skyValue,
      Phrase::tr("the share that no probe takes, sampled along R at mip level %1").arg(fixedText(e.skyLevel, 2))));
  return section;
}

ExplanationSection glassSection(const Explanation& e) {
  const GlassExplanation& g = *e.glass;
  const Phrase title = g.back ? Phrase::tr("Glass: %1, seen from within") : Phrase::tr("Glass: %1");
  ExplanationSection section{title.arg(g.form), {}, -1};
  auto& rows = section.rows;
  rows.push_back(
      scalar("n_1/n_2", g.eta, "",
             Phrase::tr("index on the eye's side over that beyond; the glass has %1").arg(fixedText(g.ior))));
  rows.push_back(scalar("F", g.reflectance, "",
                        g.reflectance >= 1.0f
                            ? Phrase::tr("totally reflected: the view is flatter than the critical angle")
                            : Phrase::tr("exact Fresnel reflectance of a dielectric at N.V")));
  Phrase direction = Phrase::tr("refracted view direction, in which the probes are sampled");
  if (g.form == "two-interface" && !g.back) {
    direction = Phrase::tr("%1, bent at the front and where it leaves").arg(direction);
    if (g.mirrored > 0) {
      direction = Phrase::tr("%1; mirrored within %2 times on the way").arg(direction).arg(std::to_string(g.mirrored));
    }
  }
  rows.push_back(vector("T", g.directionWorld, "", direction));
  rows.push_back(vector("Q", g.exitWorld, kLength, Phrase::tr("from where it is followed to the box")));
  rows.push_back(scalar("x", g.distance, kLength, Phrase::tr("the way within")));
  rows.push_back(scalar("p_T", g.roughness, "",
                        Phrase::tr("roughness of a mirror that would scatter as far; gives the mip level")));
  rows.push_back(light("Beer", g.transmittance, Phrase::tr("left of white light after x")));
  rows.push_back(
      light(Phrase::tr("passes"), g.passed, Phrase::tr("factor: transmission (1 - reflected) base colour Beer")));
  rows.push_back(light("L_T", g.looked, Phrase::tr("found along T: %1").arg(g.sources)));
  return section;
}

ExplanationSection mirrorSection(const Explanation& e) {
  const MirrorExplanation& m = *e.mirror;
  ExplanationSection section{
      Phrase::tr("Planar mirror: objects that move take %1 of the reflection").arg(percent(m.coverage)), {}, -1};
  auto& rows = section.rows;
  rows.push_back(
      scalar("a", m.coverage, "", Phrase::tr("coverage of the mirror's picture over the lobe; the probes keep 1 - a")));
  if (m.coverage > 0.0f) {
    rows.push_back(
        scalar("d_dyn", m.hitDistance, kLength, Phrase::tr("along R to what moves, by its height over the mirror")));
    rows.push_back(scalar(Phrase::tr("level"), m.level, "",
                          Phrase::tr("whose texels are as large as the lobe at that distance; %1 fetches")
                              .arg(std::to_string(m.fetches))));
    rows.push_back(light("L_dyn", m.light, Phrase::tr("its light, times a")));
  }
  if (m.share != 1.0f)
    rows.push_back(scalar("s", m.share, "", Phrase::tr("factor of L_dyn: share and intensity of the probes")));
  return section;
}

ExplanationSection shadowSection(const LightShadow& shadow) {
  ExplanationSection section{Phrase::tr("Light %1: what lets it through").arg(std::to_string(shadow.light)), {}, -1};
  auto& rows = section.rows;
  rows.push_back(vector("L", shadow.toLight, "", Phrase::tr("towards the light")));
  for (const ProbeShadow& p : shadow.probes) {
    rows.push_back(
        scalar("d", p.distance, kLength, Phrase::tr("along L to where it leaves the box of probe \"%1\"").arg(p.name)));
    rows.push_back(vector("H", p.hitWorld, kLength, Phrase::tr("there; what the probe's coverage is looked up for")));
    rows.push_back(
        light("T", p.through, Phrase::tr("1 - coverage, coloured by glass, at level %1").arg(fixedText(p.level, 2))));
  }
  if (shadow.moving)
    rows.push_back(scalar("m", *shadow.moving, "", Phrase::tr("factor of the shadow map of what moves")));
  rows.push_back(light(Phrase::tr("through"), shadow.through,
                       shadow.facesAway ? Phrase::tr("none: the surface faces away from it")
                                        : Phrase::tr("factor of the light in `direct`")));
  return section;
}

ExplanationSection sumSection(const Explanation& e) {
  ExplanationSection section{Phrase::tr("Sum"), {}, -1};
  auto& rows = section.rows;
  rows.push_back(light(Phrase::tr("direct"), e.direct, Phrase::tr("light sources")));
  rows.push_back(light(Phrase::tr("emissive"), e.emissive, Phrase::tr("the surface's own light")));
  const float all = e.color.x + e.color.y + e.color.z;
  const Phrase diffuse = all > 0.0f
                             ? Phrase::tr("light from all directions around N, times the base colour; %1 of the pixel")
                                   .arg(percent((e.diffuse.x + e.diffuse.y + e.diffuse.z) / all))
                             : Phrase::tr("light from all directions around N, times the base colour");
  rows.push_back(light(Phrase::tr("diffuse"), e.diffuse, diffuse));
  const Phrase specular = e.glass ? Phrase::tr("reflected light times F (A + B); A = %1, B = %2 of the split sum")
                                  : Phrase::tr("reflected light times F_0 A + F_90 B; A = %1, B = %2 of the split sum");
  rows.push_back(light(Phrase::tr("specular"), e.specular, specular.arg(fixedText(e.brdf.x)).arg(fixedText(e.brdf.y))));
  if (e.glass) {
    rows.push_back(
        light(Phrase::tr("glass"), e.glass->light(), Phrase::tr("what is looked through: passes times L_T")));
  }
  if (e.sheen != glm::vec3(0.0f)) {
    rows.push_back(light(Phrase::tr("sheen"), e.sheen, Phrase::tr("the same light, sent back by cloth's fibres")));
  }
  if (e.coat != glm::vec3(0.0f)) {
    rows.push_back(light(Phrase::tr("coat"), e.coat, Phrase::tr("what the clear coat changes")));
  }
  rows.push_back(light(Phrase::tr("color"), e.color, Phrase::tr("computed: linear light before exposure")));
  rows.back().sum = true;
  if (e.rendered) {
    const auto difference = relativeDifference(e);
    const Phrase drawn = e.brightestTexel > 0.0f
                             ? Phrase::tr("the pixel as drawn; differs by %1 of the brightest texel")
                             : Phrase::tr("the pixel as drawn; differs by %1 of the colour");
    rows.push_back(light(Phrase::tr("rendered"), *e.rendered, drawn.arg(fixedText(*difference, 5))));
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
  const Phrase title = e.hit ? Phrase::tr("Pixel %1, %2") : Phrase::tr("Pixel %1, %2: the background");
  const Phrase meaning =
      e.hit ? Phrase::tr("linear light before exposure") : Phrase::tr("what the sky shows there, linear");
  ExplanationSection head{title.arg(std::to_string(e.x)).arg(std::to_string(e.y)), {}, -1};
  head.rows.push_back(light(Phrase::tr("color"), e.rendered.value_or(e.color), meaning));
  if (!e.hit) return {head};
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
