// Everything that is said of pixels of a hall, and drawn of them, against explanation_values.txt; how each technique
// looks its probes up, against technique_values.txt.
#include <gtest/gtest.h>

#include <sstream>

#include "filters/core/scene/surface_view.h"
#include "filters/explain/explain_shadow.h"
#include "filters/explain/explanation_text.h"
#include "filters/explain/schematic.h"
#include "filters/explain/surface_value.h"
#include "tests/support/kept_values.h"
#include "tests/unit/explained_hall.h"

namespace boxprobe::test {
namespace {

using Lines = std::vector<std::string>;

void addText(Lines& lines, const Explanation& e, const Scene& scene) {
  ExplanationDetail detail;
  detail.texelsPerLookup = 2;
  detail.lookupsPerProbe = 2;
  detail.lookupsOfMany = 1;
  detail.texelValue = [](const ProbeExplanation& p, const TexelShare& t) -> std::optional<glm::vec3> {
    if (p.index == 1) return std::nullopt;
    return glm::vec3(hallMaps().hall.radiance.texel(t.level, t.face, t.column, t.row));
  };
  const Verdict verdict = verdictOf(e, scene);
  std::istringstream text(explanationText(e, detail, verdict));
  for (std::string line; std::getline(text, line);) lines.push_back(line);
  if (!verdict.mend) return;
  const Probe& after = verdict.mend->after;
  lines.push_back("mended " + after.name + ": box " + keptVector(after.box.min) + " to " + keptVector(after.box.max) +
                  ", influence " + keptVector(after.influenceBox().min) + " to " +
                  keptVector(after.influenceBox().max) + ", " + after.technique + (after.projection ? " on" : " off"));
}

/// What the text leaves out.
void addRest(Lines& lines, const Explanation& e) {
  lines.push_back("lookups " + std::to_string(e.lookupCount) + ", brightest texel " + keptNumber(e.brightestTexel) +
                  ", dominant " + std::to_string(e.dominant) + ", factor " + keptVector(e.specularFactor));
  for (const ProbeExplanation& p : e.probes) {
    lines.push_back(p.name + ": place " + std::to_string(p.index) + ", lamps F0 " + keptVector(p.lampsF0) + " F90 " +
                    keptVector(p.lampsF90) + " in map " + keptNumber(p.lampsInMap) + ", known " +
                    keptNumber(p.diffuse.known) + ", distances " + std::to_string(p.distanceLookups) + ", sky's " +
                    std::to_string(p.openLookups) + " at " + keptNumber(p.openSkyLevel));
    for (const LatticeNodeAtPoint& node : p.diffuse.nodes)
      lines.push_back("  node at " + keptVector(node.positionProbe));
  }
  for (const SurfaceViewRow& view : surfaceViews()) {
    const std::optional<glm::vec3> value = surfaceValue(view, e);
    lines.push_back("view " + std::string(view.id) + ": " + (value ? keptVector(*value) : "none"));
  }
  const LitPoint point = litPoint(e);
  lines.push_back("lit point " + std::to_string(point.x) + ", " + std::to_string(point.y) + " " + point.surface.object +
                  (point.hit ? " hit" : "") + " " + keptVector(point.direct) + " + " + keptVector(point.emissive) +
                  " + " + keptVector(point.diffuse) + " of " + keptVector(point.color) + ", N.V " +
                  keptNumber(point.nDotV) + ", sky " + keptNumber(point.skyWeight) + ", probes " +
                  std::to_string(point.probes.size()));
}

std::string pair(const glm::dvec2& p) {
  return "(" + keptNumber(p.x, 4) + " " + keptNumber(p.y, 4) + ")";
}

void addView(Lines& lines, const SchematicView& view) {
  lines.push_back("drawing " + view.title.english() + ": axes " + (view.rightFlipped ? "-" : "") +
                  std::to_string(view.right) + " " + (view.upFlipped ? "-" : "") + std::to_string(view.up) + ", " +
                  pair(view.low) + " to " + pair(view.high) +
                  (view.boxLow ? ", box " + pair(*view.boxLow) + " to " + pair(*view.boxHigh) : ", no box") +
                  (view.boxUsed ? "" : ", not used"));
  for (const SchematicView::Line& line : view.lines) {
    lines.push_back("  line " + std::to_string(static_cast<int>(line.kind)) + " " + pair(line.from) + " to " +
                    pair(line.to) + " '" + line.label + "' by " + keptNumber(line.foreshortening, 4));
  }
  for (const SchematicView::Point& point : view.points) {
    lines.push_back("  point " + std::to_string(static_cast<int>(point.kind)) + " " + pair(point.at) + " '" +
                    point.label.english() + "' towards " + pair(point.labelDirection));
  }
  for (const SchematicView::Plane& plane : view.planes) {
    lines.push_back("  plane " + pair(plane.from) + " to " + pair(plane.to) + " met at " + pair(plane.crossing) + " '" +
                    plane.label + "'" + (plane.smallest ? " the smallest" : ""));
  }
}

void addDrawings(Lines& lines, const Explanation& e) {
  const std::optional<Schematic> drawn = schematic(e);
  if (!drawn) return;
  lines.push_back("caption " + drawn->caption.english());
  addView(lines, drawn->plan);
  addView(lines, drawn->elevation);
  for (const bool elevation : {false, true}) addView(lines, *insetView(e, elevation));
}

TEST(ExplanationValues, AreKeptOfEveryKindOfPixel) {
  Lines lines;
  int number = 0;
  for (const HallCase& each : hallCases()) {
    HallPixel pixel;
    each.change(pixel);
    Explanation e = pixel.explain();
    // As drawn, a bit off.
    if (++number % 3 == 0) e.rendered = e.color * glm::vec3(1.02f, 0.97f, 1.01f) + 0.003f;
    if (number % 4 == 0) e.tracedIrradiance = glm::vec4(0.9f, 0.8f, 0.7f, 0.002f);
    lines.push_back("== " + each.name);
    addText(lines, e, pixel.scene);
    addRest(lines, e);
    // Within the maps of what moves, at their edges and beyond.
    for (const MovingMap& map : pixel.in.movingMaps) {
      std::string text = "shadows of light " + std::to_string(map.light) + ":";
      for (int i = 0; i < 75; ++i) {
        const glm::dvec3 at(1.3 * (i % 5) - 2.6, 1.1 * (i / 25) - 1.2, 1.2 * (i / 5 % 5) - 2.4);
        text += " " + keptNumber(static_cast<double>(movingShadowAt(map, at)), 3);
      }
      lines.push_back(text);
    }
  }
  test::expectKeptValues("unit/values/explanation_values.txt", lines);
}

TEST(ExplanationValues, AreDrawnAsTheyAre) {
  Lines lines;
  for (const char* technique : {"box", "infinite", "sphere", "impostor", "normal"}) {
    // Through each pair of walls, and along an axis.
    for (const glm::dvec3& eye : {glm::dvec3(-0.6, 1.5, 1.9), glm::dvec3(1.1, 0.5, 2.9), glm::dvec3(0.5, 2.5, 0.2),
                                  glm::dvec3(0.71, 1.7, -0.9), glm::dvec3(23.0, 1.4, 0.8)}) {
      HallPixel pixel;
      pixel.probe(0).technique = technique;
      pixel.probe(1).technique = technique;
      if (eye.x == 0.71) pixel.in.surface.normalWorld = {0.0f, 1.0f, 0.0f};
      if (eye.x == 1.1) pixel.in.probes.erase(pixel.in.probes.begin());  // the turned one
      pixel.seeFrom(eye);
      lines.push_back("== " + std::string(technique) + " from " + keptVector(eye));
      addDrawings(lines, pixel.explain());
    }
  }
  HallPixel outside;
  outside.in.surface.positionWorld = {2.2, 0.13, 0.37};
  outside.seeFrom({3.4, 1.2, 0.9});
  lines.emplace_back("== outside the box");
  addDrawings(lines, outside.explain());
  test::expectKeptValues("unit/values/schematic_values.txt", lines);
}

/// One line for a probe's answer and one for each of its first lookups.
void addLookups(Lines& lines, const ProbeExplanation& p) {
  std::string line = "  " + p.name + " " + keptVector(p.specular) + ", hit " +
                     (p.hitDistance ? keptNumber(*p.hitDistance) : "none") + " along " + keptVector(p.lookupDirection) +
                     " face " + std::to_string(p.face) + ", " + std::to_string(p.lookups.size()) + " lookups, " +
                     std::to_string(p.distanceLookups) + " of distances";
  if (p.boxDistance) line += ", box " + keptNumber(*p.boxDistance);
  if (p.coverage) line += ", covers " + keptNumber(*p.coverage) + " sky " + keptVector(p.openSky);
  lines.push_back(line);
  for (std::size_t i = 0; i < p.lookups.size() && i < 4; ++i) {
    const Lookup& lookup = p.lookups[i];
    lines.push_back("    " + keptVector(lookup.direction) + " level " + keptNumber(lookup.level) + " for " +
                    keptNumber(lookup.roughness) + " by " + keptNumber(lookup.weight) + ": " +
                    keptVector(lookup.value) + ", covers " + keptNumber(lookup.coverage));
  }
}

TEST(ExplanationValues, OfEveryTechniqueAndParameter) {
  std::vector<std::pair<std::string, std::map<std::string, ParameterValue>>> techniques;
  for (const ProjectionRow& projection : projectionRows()) {
    for (const EvaluationRow& evaluation : evaluationRows()) {
      if (evaluation.id == "auto") continue;
      const bool traced = evaluation.id == "raytraced";
      std::map<std::string, ParameterValue> parameters;
      if (traced) parameters["samples"] = 6.0;
      techniques.emplace_back(std::string(projection.id) + "+" + std::string(evaluation.id), parameters);
    }
  }
  for (const std::string_view curve : findParameter("curve")->choices) {
    techniques.push_back({"box", {{"curve", std::string(curve)}}});
  }
  techniques.push_back({"approximate", {{"hardeningLength", 0.43}}});
  techniques.push_back({"godot", {{"hardeningLength", 1.43}, {"power", 2.1}}});
  techniques.push_back({"godot", {{"fresnel", std::string("surface")}}});
  for (const double steps : {1.0, 2.0, 24.0}) techniques.push_back({"impostor", {{"steps", steps}}});
  techniques.push_back({"impostor+footprint2", {{"steps", 40.0}}});
  for (const char* pattern : {"white", "blue", "r2", "deterministic"}) {
    techniques.push_back({"raytraced", {{"samples", 5.0}, {"pattern", std::string(pattern)}, {"animated", true}}});
  }
  techniques.push_back({"raytraced", {{"samples", 5.0}, {"total", 40.0}, {"levelOffset", true}}});
  techniques.push_back({"raytraced", {{"samples", 5.0}, {"filtered", true}}});
  techniques.push_back({"impostor+raytraced", {{"samples", 6.0}, {"sampling", std::string("luminance")}}});
  Lines lines;
  for (const auto& [technique, parameters] : techniques) {
    HallPixel pixel;
    for (std::size_t i = 0; i < 2; ++i) {
      pixel.probe(i).technique = technique;
      pixel.probe(i).parameters = parameters;
    }
    pixel.in.probes[0].maps = &hallMaps().open;
    pixel.in.probes[0].open = true;
    pixel.probe(0).bevel = Bevel{0.31, 0.24};
    lines.push_back("== " + technique + " " + std::to_string(parameters.size()));
    for (const ProbeExplanation& p : pixel.explain().probes) addLookups(lines, p);
  }
  test::expectKeptValues("unit/values/technique_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe::test
