// What each version of VTK writes, brought into 9.1's words and spliced, without OpenGL; and words that no version has
// written so far, each of which has to be an error.
#include <gmock/gmock.h>

#include "filters/vtk/surface/text_replace.h"
#include "filters/vtk/surface/vtk_text_forms.h"
#include "tests/vtk/texts.h"

namespace {

using namespace boxprobe;
using namespace boxprobe::test;
using testing::HasSubstr;

std::map<std::string, int> formsOf(const std::string& version, const std::string& program) {
  std::string fragment = fixture(version, program).fragment;
  AnchorEdits edits;
  normalizeForms(fragment, edits);
  std::map<std::string, int> found;
  for (const AnchorCount& anchor : edits.counts()) {
    if (anchor.found > 0) found[anchor.what] += anchor.found;
  }
  return found;
}

TEST(VtkText, EachVersionHasItsOwnForms) {
  std::map<std::string, int> lamps, surroundings;
  const auto expect = [&](const std::string& version) {
    EXPECT_EQ(formsOf(version, "lamps"), lamps) << version;
    EXPECT_EQ(formsOf(version, "surroundings"), surroundings) << version;
  };
  expect("9.1");
  lamps["9.3: opacity of edges"] = 1;
  expect("9.3");
  for (const char* n : {"0", "1"}) {
    lamps[std::string("9.5: direction of lamp ") + n] = 1;
    lamps[std::string("9.5: falloff of lamp ") + n] = 1;
  }
  expect("9.5");
  lamps["9.6.1: no surroundings"] = 1;
  surroundings["9.6.1: multiple scattering"] = 1;
  expect("9.6.1");
  lamps["9.6.2: encoding after the output"] = 1;
  surroundings["9.6.2: encoding after the output"] = 1;
  expect("9.6.2");
  surroundings["9.7: vertex colours decoded"] = 1;
  expect("9.7");
  expect("master");
}

TEST(VtkText, EveryVersionReadsAs91) {
  for (const char* program : {"lamps", "surroundings"}) {
    std::string reference;
    for (const std::string& version : textVersions()) {
      std::string fragment = fixture(version, program).fragment;
      AnchorEdits edits;
      normalizeForms(fragment, edits);
      const std::string shading = shadingOf(fragment);
      ASSERT_GT(shading.size(), 1000u) << version;
      if (reference.empty()) reference = shading;
      EXPECT_EQ(shading, reference) << version << " " << program;
      EXPECT_EQ(countOf(fragment, "pow(diffuseColor, vec3(2.2))"), 0) << version;
    }
  }
}

int countIn(const std::map<std::string, int>& found, const std::string& anchor) {
  const auto at = found.find(anchor);
  return at == found.end() ? 0 : at->second;
}

TEST(VtkText, EveryProgramIsSplicedAlikeInEveryVersion) {
  for (const char* text : {"lamps", "surroundings"}) {
    const int lights = std::string(text) == "lamps" ? 2 : 1;
    for (const NamedProgram& wanted : programsFor(lights)) {
      std::string reference;
      std::map<std::string, int> anchors;
      for (const std::string& version : textVersions()) {
        SCOPED_TRACE(version + " " + text + " " + wanted.name);
        ShaderSources sources = fixture(version, text);
        const SpliceReport report = splicePbr(sources, wanted.program(), true);
        ASSERT_EQ(report.failure, "");
        EXPECT_TRUE(report.needed);
        std::map<std::string, int> found;
        for (const AnchorCount& anchor : report.anchors) {
          if (anchor.what[0] != '9') found[anchor.what] += anchor.found;
        }
        if (reference.empty()) {
          reference = shadingOf(sources.fragment);
          anchors = found;
          EXPECT_EQ(countIn(found, "output"), 1);
          EXPECT_EQ(countIn(found, "diffuse irradiance"), wanted.program().probes() ? 1 : 0);
          EXPECT_EQ(countIn(found, "direction of a lamp"), lights == 2 ? 2 : 0);
          const auto& shadows = wanted.binding.shadowLights;
          const bool listed = !wanted.lightPlaces.empty();  // its shadow is that of VTK's light alone
          EXPECT_EQ(countIn(found, "light's shadow"),
                    listed && !shadows.empty() ? 1 : static_cast<int>(shadows.size()));
          EXPECT_EQ(countIn(found, "lamps through a clear coat"), lights == 2 && wanted.form != LightForm::Vtk ? 2 : 0);
          EXPECT_EQ(countIn(found, "colour of edges"), lights == 2 ? 1 : 0);
          EXPECT_EQ(countIn(found, "light that lends its code"), wanted.lightPlaces.empty() ? 0 : 1);
          EXPECT_EQ(countIn(found, "end of the lights"), wanted.lightPlaces.empty() ? 0 : 1);
        }
        EXPECT_EQ(found, anchors);
        EXPECT_EQ(shadingOf(sources.fragment), reference);
        // Lit by what the probe shows, whatever VTK itself has for surroundings.
        const int lit = wanted.program().probes() ? 1 : 0;
        EXPECT_EQ(countOf(sources.fragment, "vec3 irradiance = bpLight.irradiance;"), lit);
        EXPECT_EQ(countOf(sources.fragment, "prefilteredSpecularColor * specularBrdf;"), 1);
        EXPECT_EQ(countOf(sources.fragment, "vec3 iblSpecular = vec3(0.0);"), 0);
      }
    }
  }
}

TEST(VtkText, ATextNotNeededIsNoErrorAndAMissingOneIs) {
  const NamedProgram wanted = programsFor(1)[1];
  for (const char* version : {"9.1", "9.6.2"}) {
    const ShaderSources lines = fixture(version, "lines");
    ShaderSources sources = lines;
    SpliceReport report = splicePbr(sources, wanted.program(), false);
    EXPECT_EQ(report.failure, "") << version;
    EXPECT_FALSE(report.needed) << version;
    EXPECT_EQ(sources.fragment, lines.fragment) << version;

    report = splicePbr(sources, wanted.program(), true);
    EXPECT_TRUE(report.needed);
    EXPECT_THAT(report.failure, HasSubstr("physically based shading (0 places in place of 1)")) << version;
    EXPECT_THAT(report.failure, HasSubstr("vec3 specularBrdf = F0 * brdf.r + F90 * brdf.g;"));
    EXPECT_THAT(report.failure, HasSubstr("filters/vtk/surface/vtk_text_forms.cpp"));
    EXPECT_THAT(report.failure, testing::StartsWith("VTK 9."));
    EXPECT_EQ(sources.fragment, lines.fragment) << version;
  }
}

// The text of a version with one line in words of a version to come.
SpliceReport spliced(const std::string& version, const std::string& text, const NamedProgram& wanted,
                     const std::string& from, const std::string& to, bool lit = true) {
  ShaderSources sources = fixture(version, text);
  EXPECT_TRUE(replaceOnce(sources.fragment, from, to)) << version << ": " << from;
  const std::string before = sources.fragment;
  const SpliceReport report = splicePbr(sources, wanted.program(), lit);
  EXPECT_EQ(sources.fragment, before) << "changed in spite of a failure";
  return report;
}

TEST(VtkText, EdgesWithoutTheirColourAreAnError) {
  for (const std::string& version : textVersions()) {
    const SpliceReport report =
        spliced(version, "lamps", programsFor(2)[0], "diffuseColor = mix(diffuseColor, vec3(0.0)",
                "diffuseColor = mix(diffuseColor, vec3(0.1)");
    EXPECT_THAT(report.failure, HasSubstr("colour of edges (0 places")) << version;
  }
}

TEST(VtkText, EdgesDrawnAsTubesKeepVtksColour) {
  ShaderSources sources = fixture("9.3", "lamps");
  ASSERT_TRUE(replaceOnce(sources.fragment, "diffuseColor = mix(diffuseColor, vec3(0.0), emix * edgeOpacity);",
                          "diffuseColor = mix(diffuseColor, diffuseIntensity*edgeColor, emix * edgeOpacity);"));
  const SpliceReport report = splicePbr(sources, programsFor(2)[0].program(), true);
  EXPECT_EQ(report.failure, "");
  EXPECT_EQ(countOf(sources.fragment, "color = mix(color, edgeColor, emix);"), 0);
}

TEST(VtkText, ShadowsOfALampWhoseFalloffIsUnknownAreAnError) {
  for (const std::string& version : textVersions()) {
    const bool apart = version != "9.1" && version != "9.3";
    const SpliceReport report =
        apart ? spliced(version, "lamps", programsFor(2)[2], "radiance *= attenuation;", "radiance *= falloff;")
              : spliced(version, "lamps", programsFor(2)[2], "lightColor0 * attenuation;", "lightColor0 * falloff;");
    EXPECT_THAT(report.failure, HasSubstr("light's shadow (0 places in place of 1): \"radiance = lightColor0 * "))
        << version;
  }
}

TEST(VtkText, UnknownSurroundingsAreAnErrorWhereTheyAreZeroToo) {
  for (const std::string& version : textVersions()) {
    const bool zero = version[2] > '6' || version == "9.6.1" || version == "9.6.2";
    for (const char* text : {"lamps", "surroundings"}) {
      const std::string known = !zero            ? "F0 * brdf.r + F90 * brdf.g"
                                : text[0] == 'l' ? "iblSpecular = vec3(0.0)"
                                                 : "21.0";
      // Told by the functions of shading that the text has, even where the mapper expects no lighting.
      for (const bool lit : {true, false}) {
        const SpliceReport report = spliced(version, text, programsFor(1)[1], known, "unknown", lit);
        EXPECT_THAT(report.failure, HasSubstr("physically based shading (0 places")) << version << " " << text;
      }
    }
  }
}

TEST(VtkText, AnUnknownOutputIsAnError) {
  for (const std::string& version : textVersions()) {
    const SpliceReport report =
        spliced(version, "lamps", programsFor(2)[0], ", vec3(1.0/2.2));", ", vec3(1.0 / 2.2));");
    EXPECT_THAT(report.failure, HasSubstr("output (0 places")) << version;
  }
}

TEST(VtkText, WhatWasEditedInSilenceIsCounted) {
  const std::vector<NamedProgram> programs = programsFor(2);
  const auto failure = [&](std::size_t program, const std::string& from, const std::string& to) {
    return spliced("9.1", "lamps", programs[program], from, to).failure;
  };
  EXPECT_THAT(failure(1, "specular *= (1.0 - Fc) * (1.0 - Fc);", ""),
              HasSubstr("lamps through a clear coat (1 places in place of 2)"));
  EXPECT_THAT(failure(4, "Lo += coatLayer;", "Lo = Lo + coatLayer;"), HasSubstr("in a clear coat (1 places"));
  EXPECT_THAT(failure(4, "Lo += radiance * (diffuse + specular)", "Lo += radiance * (specular + diffuse)"),
              HasSubstr("multiple scattering of lamps (1 places"));
  EXPECT_THAT(failure(6, "if (gl_FragData[0].a <= 0.0)", "if (gl_FragData[0].a == 0.0)"),
              HasSubstr("wholly transparent (0 places"));
  EXPECT_THAT(failure(0, "float ao = 1.0;", "float ao = 1.0;\n  float ao = 1.0;"),
              HasSubstr("ambient occlusion (2 places in place of 1)"));
}

}  // namespace
