// Probes written for engines: which files, what their JSON says, what is refused before anything is written; and
// techniques as text.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>

#include "filters/io/engines/engine_files.h"
#include "filters/io/engines/export_names.h"
#include "filters/io/engines/probe_export.h"
#include "filters/io/engines/technique_text.h"
#include "filters/io/image/image_file.h"
#include "filters/math/technique/technique_table.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::AllOf;
using ::testing::Contains;
using ::testing::HasSubstr;
using ::testing::Not;

class EngineExport : public TemporaryFolder {
 protected:
  std::vector<std::string> exportTo(const ExportSettings& settings, const std::vector<ProbeCapture>& captures) {
    std::vector<std::string> names;
    for (const std::string& path : exportProbes(captures, settings, folder_.string())) {
      EXPECT_TRUE(std::filesystem::exists(path)) << path;
      names.push_back(std::filesystem::path(path).filename().string());
    }
    EXPECT_EQ(names.size(), entryCount());
    return names;
  }
};

ProbeCapture capture(const std::string& name = "room") {
  ProbeCapture result;
  result.probe.name = name;
  result.probe.origin = {0.5, 1.25, 0.0};
  result.probe.box = {{-2, 0, -1}, {2, 3, 1}};
  result.probe.rotationDegrees = {0, 90, 0};
  result.probe.blendDistance = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.6}};
  result.probe.faceSize = 16;
  result.capturedRotation = result.probe.rotationDegrees;
  result.level0 = smoothCube(16);
  return result;
}

ExportSettings settings(const std::string& format, const std::string& ladder) {
  ExportSettings result;
  result.format = format;
  result.ladder = ladder;
  result.writer = "Boxprobe test";
  return result;
}

TEST_F(EngineExport, JsonSaysWhereTheProbeIsAndWhatItsLevelsHold) {
  const auto names = exportTo(settings("ktx2", "three"), {capture()});
  EXPECT_THAT(names, testing::ElementsAre("room.ktx2", "room.json", "boxprobe_three.js", "boxprobe_playcanvas.js"));
  const nlohmann::json description = nlohmann::json::parse(read("room.json"));
  EXPECT_EQ(description["file"], "room.ktx2");
  EXPECT_EQ(description["origin"], nlohmann::json({0.5, 1.25, 0.0}));
  EXPECT_EQ(description["box"]["center"], nlohmann::json({0.0, 1.5, 0.0}));
  EXPECT_EQ(description["box"]["size"], nlohmann::json({4.0, 3.0, 2.0}));
  EXPECT_EQ(description["influence"]["min"], nlohmann::json({-2.0, 0.0, -1.0}));
  EXPECT_EQ(description["blendDistance"]["max"], nlohmann::json({0.4, 0.5, 0.6}));
  EXPECT_NEAR(description["rotationQuaternion"][1], std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(description["rotationQuaternion"][3], std::sqrt(0.5), 1e-12);
  EXPECT_EQ(description["cube"]["lookup"], nlohmann::json({-1, 1, 1}));
  EXPECT_EQ(description["ladder"]["name"], "three");
  ASSERT_EQ(description["ladder"]["levels"].size(), 2u);  // 16 and 8 texels
  EXPECT_EQ(description["ladder"]["levels"][1]["size"], 8);
  EXPECT_EQ(description["ladder"]["levels"][1]["roughness"], 1.0);
}

TEST_F(EngineExport, BevyGetsItsIrradianceAndAnotherCentreMovesTheOrigin) {
  ExportSettings bevy = settings("ktx2", "bevy");
  bevy.center = true;
  EXPECT_THAT(exportTo(bevy, {capture()}), Contains("room_diffuse.ktx2"));
  const nlohmann::json description = nlohmann::json::parse(read("room.json"));
  EXPECT_EQ(description["diffuseFile"], "room_diffuse.ktx2");
  EXPECT_EQ(description["origin"], description["box"]["center"]);
  EXPECT_EQ(description["capturedAt"], nlohmann::json({0.5, 1.25, 0.0}));
}

TEST_F(EngineExport, LatLongPicturesAreReadBackAndGodotsSceneIsFilledIn) {
  for (const std::string format : {"exr", "hdr"}) {
    exportProbes({capture()}, settings(format, "own"), folder_.string());
    const ImageRgbaF picture = loadHdrImage(file("room." + format));
    ASSERT_EQ(picture.width, 64);
    ASSERT_EQ(picture.height, 32);
    const float* middle = picture.pixels.data() + 4 * (16 * 64 + 32);  // +Z
    EXPECT_NEAR(middle[2], 3.1f, 0.03f) << format;
    EXPECT_NEAR(middle[0], 1.6f, 0.1f) << format;
    EXPECT_THAT(read("room.json"), HasSubstr("\"center\": \"+Z\""));
  }
  const std::string scene = read("room.tscn");
  EXPECT_THAT(scene,
              AllOf(HasSubstr("shader_parameter/box_half = Vector3(2, 1.5, 1)"), HasSubstr("path=\"room.hdr\"")));
  EXPECT_EQ(scene.find('@'), std::string::npos);
}

// Names are neither templates nor code of Godot's.
TEST_F(EngineExport, AnEnginesFileHasNamesAsTheyAre) {
  auto named = capture();
  named.probe.name = "@FILE@ @SIZE@ \"] \\";
  exportProbes({named}, settings("hdr", "own"), folder_.string());
  std::string scene;
  for (const auto& entry : std::filesystem::directory_iterator(folder_)) {
    if (entry.path().extension() == ".tscn") scene = read(entry.path().filename().string());
  }
  EXPECT_THAT(scene, HasSubstr(R"([node name="@FILE@ @SIZE@ \"] \\" type="Node3D"])"));
}

TEST_F(EngineExport, AnUnturnedPictureIsTurnedToItsBox) {
  ProbeCapture picture = capture();
  picture.capturedRotation = glm::dvec3(0.0);  // a custom probe's, along the world's axes
  exportProbes({picture}, settings("exr", "own"), folder_.string());
  const ImageRgbaF image = loadHdrImage(file("room.exr"));
  const float* middle = image.pixels.data() + 4 * (16 * 64 + 32);  // the box's +Z, the world's +X
  EXPECT_NEAR(middle[0], 3.1f, 0.03f);
}

TEST_F(EngineExport, WhatTheFormatCannotHoldIsRefusedBeforeAnythingIsWritten) {
  ProbeCapture bright = capture("bright"), open = capture("open");
  bright.level0.setTexel(0, 0, 3, 3, {1e6f, 1.0f, 1.0f, 1.0f});
  open.level0.setTexel(0, 0, 3, 3, glm::vec4(0.5f));
  const auto attempt = [&](const ProbeCapture& second, const std::string& format) {
    return errorText([&] { exportProbes({capture(), second}, settings(format, "own"), folder_.string()); });
  };
  EXPECT_THAT(attempt(bright, "ktx2"), AllOf(HasSubstr("probes.bright: 1 texels"), HasSubstr("--lossy")));
  EXPECT_THAT(attempt(open, "hdr"), HasSubstr("coverage"));
  EXPECT_EQ(entryCount(), 0u);
  ExportSettings lossy = settings("dds", "babylon");
  lossy.lossy = true;
  EXPECT_THAT(exportTo(lossy, {bright}), Contains("bright.dds"));
}

TEST_F(EngineExport, NamesThatClashAndSettingsThatAreUnknownAreRefused) {
  EXPECT_EQ(exportStems({"hall", "a/b c", "\xc3\xa4"}), (std::vector<std::string>{"hall", "a_b_c", "__"}));
  EXPECT_THAT(errorText([] { exportStems({"Room", "room"}); }), HasSubstr("probe \"Room\""));
  EXPECT_THAT(errorText([] { exportStems({"a b", "a/b"}); }), HasSubstr("rename"));
  EXPECT_THAT(errorText([] { checkExportSettings(settings("png", "own")); }), HasSubstr("ktx2, dds, exr, hdr"));
  EXPECT_THAT(errorText([] { checkExportSettings(settings("dds", "quake")); }), HasSubstr("own, three"));
  ExportSettings odd = settings("dds", "own");
  odd.faceSize = 100;
  EXPECT_THAT(errorText([&] { checkExportSettings(odd); }), HasSubstr("power of two"));
}

TEST(EngineFiles, EveryEngineHasAFormatAndALadderThatReachIt) {
  ExportedProbe probe;
  probe.file = "a.ktx2";
  std::size_t found = 0;
  for (const LadderRow& ladder : ladderRows()) {
    probe.ladder = &ladder;
    for (const std::string& format : exportFormats()) {
      found += engineFiles({probe}, format, ladder.id).size();
    }
  }
  EXPECT_GE(found, engineRows().size());
  for (const EngineRow& row : engineRows()) {
    EXPECT_FALSE(row.formats.empty() || row.ladders.empty()) << row.engine;
  }
}

const std::pair<ShaderLanguage, const char*> kLanguages[] = {
    {ShaderLanguage::Glsl, "vec4 boxprobeReflection(samplerCube map"},
    {ShaderLanguage::Hlsl, "float4 boxprobeReflection(TextureCube map"},
    {ShaderLanguage::Godot, "vec4 boxprobeReflection(samplerCube map"}};

TEST(TechniqueText, EveryTechniqueThatNeedsNoOtherTextureIsOneFunction) {
  Probe probe = capture("hall-1").probe;
  probe.bevel = Bevel{0.25, 0.5};
  probe.occlusion = BoxOcclusion{2.0, 1.5, 0.5};
  int written = 0;
  for (const ProjectionRow& projection : projectionRows()) {
    for (const EvaluationRow& evaluation : evaluationRows()) {
      const std::string id = std::string(projection.id) + "+" + std::string(evaluation.id);
      if (projection.distances || evaluation.id == "raytraced" || evaluation.id == "auto") continue;
      for (const auto& [language, signature] : kLanguages) {
        const std::string text = techniqueText({probe}, id, language, "Boxprobe test");
        EXPECT_THAT(text, AllOf(HasSubstr(signature), HasSubstr("BoxprobeProbe boxprobe_hall_1()"), HasSubstr(id)))
            << id;
        EXPECT_THAT(text, AllOf(Not(HasSubstr("\n#")), Not(HasSubstr("PROBE_")), Not(HasSubstr("uniform ")))) << id;
        ++written;
      }
    }
  }
  EXPECT_EQ(written, 4 * 9 * 3);
}

TEST(TechniqueText, ValuesOfTheProbeAreInItAndBevelsOnlyWhereThereAreAny) {
  Probe probe = capture().probe;
  probe.rotationDegrees = {0, 0, 0};
  probe.intensity = 0.75;
  probe.faceSize = 256;
  const std::string text = techniqueText({probe}, "box+footprint4", ShaderLanguage::Glsl, "Boxprobe test");
  EXPECT_THAT(text, HasSubstr("boxprobe.origin = vec3(0.5f, 1.25f, 0.0f);"));
  EXPECT_THAT(text, HasSubstr("boxprobe.shape.boxMin = vec3(-2.5f, -1.25f, -1.0f);"));
  EXPECT_THAT(text, HasSubstr("boxprobe.shape.maxLevel = 6.0f;"));
  EXPECT_THAT(text, HasSubstr("0.75f"));
  EXPECT_THAT(text, Not(HasSubstr("roundedBoxExit")));
  EXPECT_THAT(techniqueText({probe}, "hdrp", ShaderLanguage::Hlsl, ""), Not(HasSubstr("vec3(")));
}

TEST(TechniqueText, WhatAFunctionAloneCannotDoIsRefused) {
  const Probe probe = capture().probe;
  for (const char* id : {"impostor", "raytraced", "auto", "nonesuch"}) {
    EXPECT_THAT(errorText([&] { techniqueText({probe}, id, ShaderLanguage::Glsl, ""); }), HasSubstr(id));
  }
  Probe own = probe;
  own.technique = "godot";
  const ParameterRow* row = findParameter("fresnel");
  ASSERT_NE(row, nullptr);
  own.parameters["fresnel"] = std::string(row->choices[1]);
  EXPECT_THAT(errorText([&] { techniqueText({own}, "godot", ShaderLanguage::Glsl, ""); }), HasSubstr("fresnel"));
}

TEST(TechniqueText, HasLatticesAndTheLampsThatThereAre) {
  const Probe probe = capture().probe;
  SceneLamp lamp;
  lamp.corners = {{1.5, 2.25, -0.5}, {2.5, 2.25, -0.5}, {2.0, 2.25, 0.75}};
  lamp.radiance = {7.5, 6.0, 3.0};
  for (const auto& [language, signature] : kLanguages) {
    const std::string dark = techniqueText({probe}, "box", language, "Boxprobe test");
    EXPECT_THAT(dark, AllOf(HasSubstr(" boxprobeLattice("), Not(HasSubstr("boxprobeLampDiffuse"))));
    const std::string text = techniqueText({probe}, "box", language, "Boxprobe test", {lamp});
    EXPECT_THAT(text, AllOf(HasSubstr(" boxprobeLampDiffuse("), HasSubstr("kBoxprobeLamps = 1;")));
    EXPECT_THAT(text,
                AllOf(HasSubstr("(1.5f, 2.25f, -0.5f);"), HasSubstr("(7.5f, 6.0f, 3.0f);"), HasSubstr("count = 3;")));
    EXPECT_THAT(text, AllOf(Not(HasSubstr("\n#")), Not(HasSubstr("LAMP_SLOT")), Not(HasSubstr("LATTICE_SLOT"))));
  }
}

}  // namespace
}  // namespace boxprobe
