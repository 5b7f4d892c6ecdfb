// Techniques as text, word by word: what probes and lamps say in it against technique_text_values.txt, and other
// languages as the same text in other words.
#include "filters/io/engines/technique_text.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <regex>
#include <set>

#include "filters/io/engines/shader_literals.h"
#include "filters/math/shared/shader_source.h"
#include "filters/math/technique/technique_table.h"
#include "tests/support/kept_values.h"
#include "tests/unit/error_text.h"

namespace boxprobe {
namespace {

using ::testing::HasSubstr;
using ::testing::Not;

/// Nothing of it at its default, no two numbers equal.
Probe wordedProbe(const std::string& name) {
  Probe probe;
  probe.name = name;
  probe.box = {{-1.1, 0.3, -2.7}, {3.2, 2.9, 4.05}};
  probe.origin = {0.7, 1.37, 0.21};
  probe.rotationDegrees = {10, 35, -5};
  probe.intensity = 0.85;
  probe.faceSize = 64;
  probe.bevel = Bevel{0.25, 0.5};
  probe.occlusion = BoxOcclusion{2.0, 1.5, 0.75};
  probe.parameters = {{"power", 3.5}, {"samples", 24.0}};
  return probe;
}

std::vector<SceneLamp> oddLamps() {
  std::vector<SceneLamp> lamps(2);
  lamps[0].corners = {{1.5, 2.25, -0.5}, {2.5, 2.0, -0.75}, {2.25, 3, 0.5}, {1, 2, 1.25}};
  lamps[0].radiance = {7.5, 6.25, 3.0};
  lamps[1].corners = {{-1, 0.1, 1e-7}, {1e9, 5, 6}, {7, 8, 9}};
  lamps[1].radiance = {1, 2, 4};
  lamps[1].bothSides = true;
  return lamps;
}

/// The function that begins with `head`, to its closing brace.
std::string functionOf(const std::string& text, const std::string& head) {
  const std::size_t at = text.find(head);
  EXPECT_NE(at, std::string::npos) << head;
  return at == std::string::npos ? "" : text.substr(at, text.find("\n}\n", at) + 3 - at);
}

TEST(TechniqueTextValues, OfProbesAndLamps) {
  test::KeptValues values;
  Probe second = wordedProbe("a/b\n@2");
  second.rotationDegrees = glm::dvec3(0.0);
  second.bevel.reset();
  second.occlusion.reset();
  second.faceSize = 16;
  for (const ShaderLanguage language : {ShaderLanguage::Glsl, ShaderLanguage::Hlsl, ShaderLanguage::Godot}) {
    const std::string text =
        techniqueText({wordedProbe("hall-1"), second}, "box+hdrp", language, "Boxprobe test", oddLamps());
    values.add(text.substr(0, text.find("\n\n")));
    values.add(functionOf(text, "// hall-1\n"));
    values.add(functionOf(text, "// a/b@2\n"));
    values.add(functionOf(text, "BoxprobeLamp boxprobeLamp("));
    const std::size_t count = text.find("const int kBoxprobeLamps");
    values.add(text.substr(count, text.find('\n', count) - count));
  }
  for (const double number : {0.0, 1.0, -2.5, 1e9, 1e-7, 0.1, 16777217.0, 3.4e38}) {
    values.add("number " + shaderNumber(number));
  }
  values.expect("unit/values/technique_text_values.txt");
}

/// The text in HLSL's words, by a list of its own.
std::string inOtherWords(const std::string& text) {
  const std::map<std::string, std::string> plain = {
      {"vec2", "float2"},         {"vec3", "float3"},        {"vec4", "float4"},
      {"ivec2", "int2"},          {"mix", "lerp"},           {"samplerCube", "TextureCube"},
      {"sampler3D", "Texture3D"}, {"point", "surfacePoint"}, {"linear", "linearTerm"}};
  std::string result;
  const std::regex word("[A-Za-z0-9_]+");
  std::size_t at = 0;
  for (std::sregex_iterator it(text.begin(), text.end(), word), end; it != end; ++it) {
    const auto start = static_cast<std::size_t>(it->position());
    std::string own = it->str();
    result += text.substr(at, start - at);
    at = start + own.size();
    if (start == 0 || text[start - 1] != '.') {
      const bool called = at < text.size() && text[at] == '(';
      if (called && (own == "vec2" || own == "vec3" || own == "vec4")) {
        own = "boxprobe" + own.substr(3);
      } else if (const auto found = plain.find(own); found != plain.end()) {
        own = found->second;
      }
    }
    result += own;
  }
  result += text.substr(at);
  for (const std::string texture : {"map", "nodes"}) {
    result = std::regex_replace(result, std::regex("textureLod\\(" + texture + ", "),
                                texture + ".SampleLevel(boxprobeSampler, ");
  }
  return std::regex_replace(result, std::regex("\nconst "), "\nstatic const ");
}

TEST(TechniqueTextValues, HlslIsTheSameTextInItsWords) {
  const auto text = [](ShaderLanguage language) {
    const std::string all =
        techniqueText({wordedProbe("hall")}, "box+footprint4", language, "Boxprobe test", oddLamps());
    return all.substr(all.find("\n\n") + 2);
  };
  const std::string hlsl = text(ShaderLanguage::Hlsl);
  const std::string head = hlsl.substr(0, hlsl.find("\n\n", hlsl.find("float4(float3 a, float b)")) + 0);
  const std::size_t own = hlsl.find("{ return float4(a, b); }\n\n");
  ASSERT_NE(own, std::string::npos) << head;
  const std::string body = hlsl.substr(own + std::string("{ return float4(a, b); }\n\n").size());
  const std::string wanted = inOtherWords(text(ShaderLanguage::Glsl));
  ASSERT_EQ(body.size(), wanted.size());
  EXPECT_TRUE(body == wanted) << "from "
                              << std::mismatch(body.begin(), body.end(), wanted.begin()).first - body.begin();
  EXPECT_EQ(text(ShaderLanguage::Godot), text(ShaderLanguage::Glsl));
}

/// The lines of a file that are left with these names defined, by counting how deep in blocks that are out one is.
std::set<std::string> linesLeft(std::string_view file, const std::set<std::string>& defined) {
  std::set<std::string> lines;
  std::istringstream text{std::string(shaderSource(file))};
  std::vector<bool> in;
  for (std::string line; std::getline(text, line);) {
    std::smatch match;
    if (std::regex_match(line, match, std::regex("#if(n?)def (\\w+).*"))) {
      in.push_back((match[1] == "n") != (defined.count(match[2]) != 0));
    } else if (line.rfind("#endif", 0) == 0) {
      in.pop_back();
    } else if (line.find('#') != 0 && line.find("PROBE_") == std::string::npos &&
               std::count(in.begin(), in.end(), false) == 0) {
      lines.insert(line);
    }
  }
  return lines;
}

TEST(TechniqueTextValues, BlocksThatAreOutAreLeftOutAndNoOthers) {
  for (const bool bevelled : {false, true}) {
    Probe probe = wordedProbe("hall");
    if (!bevelled) probe.bevel.reset();
    const std::string text = techniqueText({probe}, "box+footprint4", ShaderLanguage::Glsl, "Boxprobe test");
    std::set<std::string> there;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) there.insert(line);
    std::set<std::string> defined;
    if (bevelled) defined.insert("BP_BEVEL");
    for (const char* file : {"shared/types.glsl", "shared/slab.glsl", "shared/roughness.glsl"}) {
      const std::set<std::string> left = linesLeft(file, defined);
      for (const std::string& line : left) {
        EXPECT_EQ(there.count(line), 1u) << file << ": " << line;
      }
      for (const std::string& line :
           linesLeft(file, bevelled ? std::set<std::string>{} : std::set<std::string>{"BP_BEVEL"})) {
        if (left.count(line) == 0 && line.size() > 12) {
          EXPECT_EQ(there.count(line), 0u) << file << ": " << line;
        }
      }
    }
    EXPECT_EQ(text.find("roundedBox") != std::string::npos, bevelled);
  }
}

TEST(TechniqueTextValues, WhatIsMissingIsNamed) {
  const std::string end = ", which a function alone does not have; box+footprint4 comes near it";
  const auto said = [](const char* id) {
    return errorText([&] { techniqueText({wordedProbe("hall")}, id, ShaderLanguage::Glsl, ""); });
  };
  EXPECT_EQ(said("impostor"), "--technique impostor: needs the probe's distances" + end);
  EXPECT_EQ(said("auto"), "--technique auto: needs this program to choose for each object" + end);
  EXPECT_EQ(said("raytraced"), "--technique raytraced: needs blue noise and the probe's table of lights" + end);
  EXPECT_THAT(said("nonesuch"), HasSubstr("--technique nonesuch: no such technique; there are: "));
}

TEST(TechniqueTextValues, PiecesAreThoseOfEachTechnique) {
  const TechniquePieces pieces = techniquePieces(true, false), occluded = techniquePieces(false, true);
  std::size_t rows = 0;
  for (const ProjectionRow& projection : projectionRows()) {
    for (const EvaluationRow& evaluation : evaluationRows()) {
      if (projection.distances || evaluation.function.empty() || evaluation.id == "raytraced") continue;
      ASSERT_LT(rows, pieces.rows.size());
      const TechniquePieces::Row& row = pieces.rows[rows++];
      EXPECT_EQ(row.projection, projection.id);
      EXPECT_EQ(row.projectionLabel, projection.label);
      EXPECT_EQ(row.evaluation, evaluation.id);
      EXPECT_EQ(row.evaluationLabel, evaluation.label);
      ASSERT_GE(row.pieces.size(), 9u);
      EXPECT_EQ(row.pieces[0], "shared/types.glsl");
      EXPECT_EQ(row.pieces[4], "shared/rounded_box.glsl");
      EXPECT_EQ(row.pieces.back(), "call " + std::string(evaluation.function));
      EXPECT_EQ(row.pieces[row.pieces.size() - 2], evaluation.shaderFile);
      std::set<std::string> once;
      for (const std::string& piece : row.pieces) {
        EXPECT_TRUE(once.insert(piece).second) << piece;
        EXPECT_EQ(pieces.texts.count(piece), 1u) << piece;
      }
      EXPECT_EQ(once.count("call " + std::string(projection.function)), 1u);
      EXPECT_EQ(once.count("shared/box_occlusion.glsl"), 0u);
    }
  }
  EXPECT_EQ(pieces.rows.size(), rows);
  EXPECT_EQ(occluded.rows[0].pieces[4], "shared/box_occlusion.glsl");
  const std::string last = occluded.rows[0].pieces.back();
  EXPECT_THAT(occluded.texts.at(last), HasSubstr("boxOcclusion(reach, boxprobe.occlusion.x"));
  EXPECT_THAT(occluded.texts.at(last), Not(HasSubstr("shape.bevel =")));
  EXPECT_THAT(pieces.texts.at(last), Not(HasSubstr("boxOcclusion(")));
  EXPECT_THAT(pieces.texts.at(last), HasSubstr("shape.bevel = boxprobe.bevelAndIntensity.x"));
}

}  // namespace
}  // namespace boxprobe
