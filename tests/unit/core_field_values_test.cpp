// Every row of the scene's fields with what it allows just within and just beyond its bounds, and the small functions
// that read, shorten and compare texts, against field_values.txt.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <limits>

#include "filters/core/base/file_extension.h"
#include "filters/core/base/fixed_text.h"
#include "filters/core/base/nearest_name.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/core/base/read_number.h"
#include "filters/core/scene/bounces.h"
#include "filters/core/scene/material_override.h"
#include "filters/core/scene/scene_fields.h"
#include "filters/core/scene/technique_parameters.h"
#include "filters/core/surface/direct_light.h"
#include "filters/core/surface/surface_fresnel.h"
#include "filters/math/technique/technique_table.h"
#include "tests/support/kept_values.h"

namespace boxprobe::test {
namespace {

using Lines = std::vector<std::string>;

std::string vectorText(const glm::dvec3& v) {
  return numberText(v.x) + " " + numberText(v.y) + " " + numberText(v.z);
}

struct Text {
  std::string operator()(std::monostate) const { return "left out"; }
  std::string operator()(bool value) const { return value ? "true" : "false"; }
  std::string operator()(int value) const { return std::to_string(value); }
  std::string operator()(float value) const { return numberText(value); }
  std::string operator()(double value) const { return numberText(value); }
  std::string operator()(const std::string& value) const { return "'" + value + "'"; }
  std::string operator()(const glm::dvec2& value) const { return numberText(value.x) + " " + numberText(value.y); }
  std::string operator()(const glm::vec3& v) const {
    return numberText(v.x) + " " + numberText(v.y) + " " + numberText(v.z);
  }
  std::string operator()(const glm::dvec3& value) const { return vectorText(value); }
  std::string operator()(const std::vector<std::string>& names) const {
    return std::to_string(names.size()) + " names";
  }
  std::string operator()(const Box& box) const { return vectorText(box.min) + " to " + vectorText(box.max); }
  std::string operator()(const BlendDistance& blend) const {
    return vectorText(blend.min) + " and " + vectorText(blend.max);
  }
  std::string operator()(const Bevel& bevel) const {
    return numberText(bevel.radius) + " " + numberText(bevel.fromRoughness);
  }
  std::string operator()(const BoxOcclusion& o) const {
    return numberText(o.multiplier) + " " + numberText(o.power) + " " + numberText(o.strength);
  }
  std::string operator()(const ProbeLattice& lattice) const {
    return numberText(lattice.spacing) + (lattice.used ? "" : " unused");
  }
  std::string operator()(const Clear& clear) const { return "clear " + std::to_string(clear.index()); }
  std::string operator()(const std::map<std::string, ParameterValue>& all) const {
    return std::to_string(all.size()) + " parameters";
  }
};

std::string verdictOn(const FieldInfo& field, const FieldValue& value) {
  std::string problem;
  try {
    checkField(field, value, {"part"});
  } catch (const FieldError& error) {
    problem = error.what();
  }
  return std::visit(Text(), value) + ": " + (problem.empty() ? "good" : problem);
}

std::string rangeOf(const FieldRange& range) {
  return (range.aboveLowest ? "above " : "") + numberText(range.lowest) + " to " +
         (range.belowHighest ? "below " : "") + numberText(range.highest);
}

/// What is near a bound, as the field's own type.
void addTries(Lines& lines, const FieldInfo& field, const FieldValue& standard) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  const auto add = [&](const FieldValue& value) { lines.push_back("  " + verdictOn(field, value)); };
  std::vector<double> numbers = {-1.0, -0.25, 0.0, 0.25, 1.0, 3.0, 2e18, -2e18, kInfinity, -kInfinity, std::nan("")};
  for (const double bound : {field.range.lowest, field.range.highest}) {
    if (!std::isfinite(bound)) continue;
    const double step = std::max(std::abs(bound) * 1e-3, 1e-3);
    for (const double off : {-step, 0.0, step}) numbers.push_back(bound + off);
  }
  switch (field.kind) {
    case FieldKind::Number:
      for (const double number : numbers) {
        if (field.singlePrecision) add(FieldValue(std::in_place_type<float>, static_cast<float>(number)));
        if (!field.singlePrecision) add(FieldValue(std::in_place_type<double>, number));
      }
      break;
    case FieldKind::Integer:
      for (const int number :
           {-2147483647 - 1, -1, 0, 1, 2, 4, 5, 6, 7, 8, 9, 15, 16, 17, 32, 767, 768, 769, 2047, 2048, 4096}) {
        add(FieldValue(std::in_place_type<int>, number));
      }
      break;
    case FieldKind::Vector:
    case FieldKind::Direction:
      for (const double number : numbers) add(FieldValue(std::in_place_type<glm::dvec3>, 0.5, number, 0.25));
      add(FieldValue(std::in_place_type<glm::dvec3>, 0.0, 0.0, 0.0));
      break;
    case FieldKind::Color:
      for (const double number : numbers) {
        add(FieldValue(std::in_place_type<glm::vec3>, 0.5f, 0.25f, static_cast<float>(number)));
      }
      break;
    case FieldKind::Text:
    case FieldKind::File:
      if (!std::holds_alternative<std::monostate>(standard)) add(FieldValue(std::in_place_type<std::string>));
      break;
    case FieldKind::Decode:
      for (const double number : numbers) {
        add(FieldValue(std::in_place_type<glm::dvec2>, number, 1.0));
        add(FieldValue(std::in_place_type<glm::dvec2>, 1.0, number));
      }
      break;
    case FieldKind::Box:
      add(Box{{0.0, 1.0, 2.0}, {3.0, 0.5, 4.0}});
      add(Box{{0.0, 1.0, 2.0}, {3.0, 1.0, 1.0}});
      add(Box{{0.0, 1.0, 2.0}, {0.0, 1.0, 2e18}});
      break;
    case FieldKind::BlendDistance:
      add(BlendDistance{{0.0, 1.0, 2.0}, {3.0, -0.5, 4.0}});
      add(BlendDistance{{0.0, 0.0, 2e18}, {0.0, 0.0, 0.0}});
      break;
    case FieldKind::Bevel:
      add(Bevel{-0.1, 0.0});
      add(Bevel{0.0, -0.1});
      add(Bevel{0.0, 0.0});
      break;
    case FieldKind::Occlusion:
      for (const double n : {-0.1, 0.0, 1.0, 1.1}) {
        add(BoxOcclusion{n, 1.0, 1.0});
        add(BoxOcclusion{1.0, n, 1.0});
        add(BoxOcclusion{1.0, 1.0, n});
      }
      break;
    case FieldKind::ClearTo:
      add(Clear(glm::vec3(0.0f, -1.0f, 0.0f)));
      add(Clear(glm::vec3(0.0f, 7.0f, 2e18f)));
      break;
    default:
      break;
  }
}

void addFields(Lines& lines) {
  for (const FieldPart& part : fieldParts()) {
    lines.push_back("== part '" + std::string(part.path) + "'");
    const auto kinds = [](const std::vector<bool Changes::*>& changes) {
      std::string text;
      for (const ChangeRow& row : changeRows()) {
        if (std::find(changes.begin(), changes.end(), row.member) != changes.end()) text += " " + std::string(row.id);
      }
      return text;
    };
    lines.push_back("changes" + kinds(part.changes));
    for (const FieldPart::Entry& entry : part.fields) {
      const FieldInfo& field = *entry.field;
      std::string line = std::string(field.key) + " [" + std::string(field.unit) + "] kind " +
                         std::to_string(static_cast<int>(field.kind)) + (field.singlePrecision ? " single" : "") +
                         " is " + std::visit(Text(), entry.standard) + ", " + rangeOf(field.range) + " as '" +
                         rangeText(field) + "', form " + rangeOf(formRange(field)) + ", types " +
                         std::to_string(field.types & 7u) + (field.alwaysWritten ? ", always" : "") +
                         (field.powerOfTwo ? ", power" : "") + ", changes" + kinds(field.changes) + ";";
      for (const FieldChoice& choice : field.choices) line += " " + std::string(choice.id);
      for (const int value : field.values) line += " " + std::to_string(value);
      for (const std::string_view text :
           {field.required, field.ifEmpty, field.written, field.ifLeftOut, field.otherTypes}) {
        if (!text.empty()) line += " (" + std::string(text) + ")";
      }
      lines.push_back(line);
      addTries(lines, field, entry.standard);
    }
  }
}

void addTechniques(Lines& lines) {
  lines.emplace_back("== techniques");
  for (const ParameterRow& row : parameterRows()) {
    Probe probe;
    std::string line = std::string(row.name) + " " + numberText(row.min) + " to " + numberText(row.max) + " is " +
                       numberText(parameterNumber(probe, row)) + ":";
    for (const double number : {0.0, 1.0, 0.5, 2.0, row.standard}) {
      if (row.kind == ParameterKind::Choice && (number != std::floor(number) || number >= row.choices.size())) continue;
      setParameter(probe, row, number);
      line += " " + numberText(parameterNumber(probe, row)) + " of " + std::to_string(probe.parameters.size());
    }
    lines.push_back(line);
    const std::string name(row.name);
    for (const ParameterValue& value : {ParameterValue(row.min), ParameterValue(row.max), ParameterValue(row.min - 0.5),
                                        ParameterValue(row.max + 1.0), ParameterValue(true),
                                        ParameterValue(std::string("blue")), ParameterValue(1.5)}) {
      lines.push_back("  " + parameterProblem(name, value));
    }
  }
  lines.push_back(parameterProblem("sampels", 1.0));
  for (const ProjectionRow& projection : projectionRows()) {
    for (const EvaluationRow& evaluation : evaluationRows()) {
      const std::string id = std::string(projection.id) + "+" + std::string(evaluation.id);
      const std::optional<Technique> parsed = parseTechnique(id);
      if (!parsed) lines.push_back(id + " is none");
      if (!parsed) continue;
      const Technique& t = *parsed;
      std::string line = techniqueId(t) + " short " + shortTechniqueId(t) + " still " + techniqueId(standInFor(t)) +
                         " off " + techniqueId(withoutProjection(t)) + (looksUpPieces(t) ? " pieces" : "") + ":";
      for (const ParameterRow* row : parametersOf(t)) line += " " + std::string(row->name);
      lines.push_back(line);
    }
  }
  for (const char* id : {"box", "footprint4", "box+", "+none", "auto", "auto+none", "box+auto", "none+box", ""}) {
    const auto technique = parseTechnique(id);
    lines.push_back(std::string("'") + id + "' is " + (technique ? techniqueId(*technique) : "unknown"));
  }
  lines.push_back(techniqueIdList());
}

void addTexts(Lines& lines) {
  lines.emplace_back("== texts");
  for (const char* text : {"1",     "-2.5", "+1",   "1.", ".5",    ".",        "1e3",      "1E+3x",  "1e-2",
                           "1e",    "1e+",  "1e+x", "e5", "-inf",  "infinity", "Infinite", "nan(1)", "-NAN",
                           "1e999", "0x10", "",     "-",  "12 13", "1,5",      "-.5e1"}) {
    for (const bool stream : {false, true}) {
      double value = 7.0;
      const char* end = text + std::strlen(text);
      const auto result = stream ? readNumberByStream(text, end, value) : readNumber(text, end, value);
      const std::string what = result.ec == std::errc()                   ? "good"
                               : result.ec == std::errc::invalid_argument ? "none"
                                                                          : "far";
      lines.push_back(std::string("number '") + text + "' " + what + " " +
                      keptNumber(std::isnan(value) ? -1.0 : value) + (std::signbit(value) ? " negative" : "") +
                      " rest '" + result.ptr + "'");
    }
  }
  for (const double value : {0.00005, 0.000049, -0.00005, 9999999.0, 1e7, -1e7, 0.0, -0.0, 123.45678, 5e-324, 1e300}) {
    lines.push_back("fixed " + fixedText(value) + " " + fixedText(value, 0) + " " + fixedText(value, 2) +
                    ", decimals " + decimalText(value, 3));
  }
  for (const std::uint64_t bytes : {0ull, 999ull, 1234567890ull, 99999999999ull}) lines.push_back(gigabytesText(bytes));
  const std::string accents = "a\xc3\xa9\xe2\x82\xac\xf0\x9f\x98\x80z";
  for (std::size_t most = 0; most < 13; ++most) lines.push_back("elided " + elided(accents, most));
  lines.push_back("one line " + oneLine("tab\tline\nbell\x7f end"));
  const std::string longLine = oneLine(std::string(700, 'a') + std::string(700, 'b'));
  lines.push_back("long " + std::to_string(longLine.size()) + " " + longLine.substr(495, 12));
  const char* const sequences[] = {"plain",
                                   "\x1b[31m",
                                   "a\nb",
                                   "\xc2\x80",
                                   "\xc2\xa0",
                                   "\xc1\xbf",
                                   "\xc3\xa9",
                                   "\xc3",
                                   "\xe0\x9f\xbf",
                                   "\xe0\xa0\x80",
                                   "\xe2\x80\xa7",
                                   "\xe2\x80\xa8",
                                   "\xe2\x80\xae",
                                   "\xe2\x80\xaf",
                                   "\xe2\x81\xa5",
                                   "\xe2\x81\xa6",
                                   "\xe2\x81\xa9",
                                   "\xe2\x81\xaa",
                                   "\xed\x9f\xbf",
                                   "\xed\xa0\x80",
                                   "\xee\x80\x80",
                                   "\xf0\x8f\xbf\xbf",
                                   "\xf0\x90\x80\x80",
                                   "\xf4\x8f\xbf\xbf",
                                   "\xf4\x90\x80\x80",
                                   "\xf5\x80\x80\x80",
                                   "\x7f",
                                   "\xef\xbf"};
  for (const char* text : sequences) {
    std::string line = "printable";
    for (const bool keep : {false, true}) {
      for (const unsigned char c : printable(text, keep)) line += " #" + std::to_string(c);
      line += " ;";
    }
    lines.push_back(line);
  }
  const std::vector<std::string> names = {"floor", "flour", "Wall lamp", "ab", "", "ceiling"};
  for (const char* name :
       {"floor", "flor", "folor", "flxxr", "WALLLAMP", "wall", "ba", "a", "xyz", "ceilings", "cieling"}) {
    lines.push_back(std::string("near ") + name + ": '" + nearestName(name, names) + "'" + didYouMean(name, names));
  }
  for (const std::size_t limit : {0, 1, 5, 6, 12}) lines.push_back("list " + nameList(names, limit));
  lines.push_back("list " + nameList({}));
  lines.push_back("extension " + lowerExtension("/a.b/Sky.EXR") + lowerExtension("none") + lowerExtension("a.TAR.gz"));
  for (const KeyPath& path :
       {KeyPath{"a", "[2]", "b"}, KeyPath{"[0]", "c"}, KeyPath{}, KeyPath{"a", "b", "[1]", "[2]"}}) {
    lines.push_back("path '" + keyPathText(path) + "'");
  }
}

void addMaterials(Lines& lines) {
  lines.emplace_back("== materials");
  Scene scene;
  MaterialOverride over;
  over.baseColor = {0.1f, 0.2f, 0.3f};
  over.metallic = 0.4f;
  over.roughness = 0.45f;
  over.emissive = {0.5f, 0.6f, 0.7f};
  over.normalScale = 0.8f;
  over.coat = 0.9f;
  over.ior = 1.3f;
  over.transmission = 0.35f;
  over.attenuationDistance = 1.2f;
  over.attenuationColor = {0.15f, 0.25f, 0.35f};
  over.glass = GlassForm::TwoPass;
  scene.materials["all"] = over;
  scene.materials["thick"].thickness = 0.3f;
  scene.materials["flat"].thickness = 0.0f;
  scene.materials["both"].thickness = 0.3f;
  scene.materials["both"].thin = true;
  for (const char* name : {"all", "thick", "flat", "both", "none"}) {
    for (const bool thin : {false, true}) {
      Material material;
      material.name = name;
      material.thin = thin;
      material.thickness = 0.7f;
      material.transmission = 0.2f;
      const Material m = overriddenMaterial(material, scene);
      lines.push_back(m.name + " " + keptVector(m.baseColor) + " " + keptNumber(m.baseColor.w) + " " +
                      keptNumber(m.metallic) + " " + keptNumber(m.roughness) + " " + keptVector(m.emissive) + " " +
                      keptNumber(m.normalScale) + " " + keptNumber(m.coat) + " " + keptNumber(m.ior) + " " +
                      keptNumber(m.transmission) + " " + keptNumber(m.thickness) + " " +
                      keptNumber(m.attenuationDistance) + " " + keptVector(m.attenuationColor) +
                      (m.thin ? " thin" : " solid") + " " + std::to_string(static_cast<int>(m.glass)) +
                      (m.transmits() ? " transmits " : " ") + keptNumber(m.reflectedIor()));
    }
  }
  Material specular;
  for (const float factor : {0.0f, 0.4f, 1.0f, 3.0f, 40.0f}) {
    specular.specular = factor;
    lines.push_back("reflected " + keptNumber(specular.reflectedIor()) + " of " +
                    std::to_string(specular.textures().size()) + " textures");
  }
  for (const int bounces : {0, 1, 3, 5, 16}) {
    Scene bouncing;
    bouncing.probes.resize(2);
    bouncing.probes[1].bounces = bounces;
    const auto most = mostBounces(bouncing);
    lines.push_back("bounces " + (most ? std::to_string(*most) : std::string("all")));
  }
}

void addLight(Lines& lines) {
  lines.emplace_back("== direct light");
  Light sun, bulb, spot, below;
  sun.direction = {-0.3, -1.0, 0.2};
  sun.color = {0.9f, 0.8f, 0.7f};
  sun.intensity = 2.3f;
  bulb.type = LightType::Point;
  bulb.position = {1.3, 1.7, -0.4};
  bulb.range = 4.0;
  spot = bulb;
  spot.type = LightType::Spot;
  spot.position = {-0.8, 1.1, 0.9};
  spot.direction = {0.7, -1.0, -0.9};
  spot.innerConeDegrees = 9.0;
  spot.outerConeDegrees = 31.0;
  spot.range = 0.0;
  below = bulb;
  below.position = {0.2, -1.0, 0.3};
  SurfacePoint s;
  s.positionWorld = {0.1, 0.2, 0.3};
  s.normalWorld = glm::normalize(glm::vec3(0.1f, 1.0f, -0.05f));
  s.viewWorld = glm::normalize(glm::vec3(-0.5f, 0.8f, 0.4f));
  s.albedo = {0.6f, 0.5f, 0.3f};
  s.metallic = 0.2f;
  s.occlusion = 0.5f;
  const auto add = [&](const std::string& name) {
    const float nDotV = glm::dot(s.normalWorld, s.viewWorld);
    const SurfaceFresnel fresnel = surfaceFresnel(s, nDotV);
    lines.push_back(name + ": F0 " + keptVector(fresnel.f0) + " F90 " + keptVector(fresnel.f90) + " under sheen " +
                    keptNumber(passesSheen(s, nDotV)));
    for (const Light& light : {sun, bulb, spot, below}) {
      lines.push_back("  " + keptVector(directLight(s, fresnel.f0, fresnel.f90, {light})));
    }
    const std::vector<glm::vec3> through = {{0.5f, 0.4f, 0.3f}, {0.2f, 0.6f, 0.9f}};
    const Scattering scattering{{1.1f, 1.2f, 1.3f}, {1.4f, 1.5f, 1.6f}};
    lines.push_back("  together " +
                    keptVector(directLight(s, fresnel.f0, fresnel.f90, {sun, spot}, &through, scattering)));
  };
  for (const float roughness : {0.0f, 0.03f, 0.35f, 1.0f}) {
    s.roughness = roughness;
    add("roughness " + numberText(roughness));
  }
  s.roughness = 0.4f;
  s.coatStrength = 0.7f;
  s.coatRoughness = 0.15f;
  s.coatF0 = 0.06f;
  s.coatNormalWorld = glm::normalize(glm::vec3(-0.1f, 1.0f, 0.2f));
  add("coat");
  PointFinish finish;
  finish.f0 = {0.08f, 0.06f, 0.05f};
  finish.edge = 0.7f;
  finish.tinted = true;
  finish.sheenColor = {0.4f, 0.3f, 0.2f};
  finish.sheenRoughness = 0.5f;
  s.finish = finish;
  add("sheen under the coat");
  s.coatStrength = 0.0f;
  finish.sheenColor = glm::vec3(0.0f);
  finish.tinted = false;
  finish.acrossWorld = glm::normalize(glm::cross(s.normalWorld, glm::vec3(0.3f, 0.1f, 1.0f)));
  finish.anisotropy = 0.8f;
  s.finish = finish;
  add("brushed");
  finish.anisotropy = 0.0f;
  finish.iridescence = 0.9f;
  finish.filmIor = 1.45f;
  finish.filmThickness = 410.0f;
  s.finish = finish;
  add("film");
}

TEST(FieldValues, AreKept) {
  Lines lines;
  addFields(lines);
  addTechniques(lines);
  addTexts(lines);
  addMaterials(lines);
  addLight(lines);
  test::expectKeptValues("unit/values/field_values.txt", lines);
}

}  // namespace
}  // namespace boxprobe::test
