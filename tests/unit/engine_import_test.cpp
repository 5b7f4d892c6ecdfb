// Probes out of Unity's YAML and Godot's scenes: places through their parents, axes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/io/engines/import_detail.h"
#include "filters/io/engines/probe_import.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::AllOf;
using ::testing::HasSubstr;
using ::testing::IsEmpty;
using ::testing::SizeIs;

void expectNear(const glm::dvec3& value, const glm::dvec3& expected) {
  EXPECT_LT(glm::length(value - expected), 1e-6) << value.x << " " << value.y << " " << value.z;
}

// A probe in a group that stands at (1, 2, 3), turned a quarter about Y and twice as large.
const char* const kUnity = R"(%YAML 1.1
%TAG !u! tag:unity3d.com,2011:
--- !u!1 &100
GameObject:
  m_ObjectHideFlags: 0
  m_Component:
  - component: {fileID: 101}
  - component: {fileID: 102}
  m_Name: Hall
--- !u!4 &101
Transform:
  m_GameObject: {fileID: 100}
  m_LocalRotation: {x: 0, y: 0, z: 0, w: 1}
  m_LocalPosition: {x: 0, y: 1, z: 4}
  m_LocalScale: {x: 1, y: 1, z: 1}
  m_Father: {fileID: 201}
--- !u!215 &102
ReflectionProbe:
  m_GameObject: {fileID: 100}
  serializedVersion: 2
  m_Type: 0
  m_Mode: 1
  m_Resolution: 128
  m_BoxSize: {x: 8, y: 3, z: 6}
  m_BoxOffset: {x: 0.5, y: -0.25, z: 0}
  m_NearClip: 0.3
  m_FarClip: 500
  m_Importance: 2
  m_IntensityMultiplier: 0.8
  m_BlendDistance: 1.5
  m_BoxProjection: 1
--- !u!1 &200 stripped
GameObject:
  m_Name: Group
--- !u!4 &201
Transform:
  m_GameObject: {fileID: 200}
  m_LocalRotation: {x: 0, y: 0.70710678, z: 0, w: 0.70710678}
  m_LocalPosition: {x: 1, y: 2, z: 3}
  m_LocalScale: {x: 2, y: 2, z: 2}
  m_Father: {fileID: 0}
)";

TEST(EngineImport, UnitysProbesStandWhereTheirParentsPutThemWithXNegated) {
  const ImportedProbes imported = parseUnityProbes(kUnity, "Hall.unity");
  EXPECT_EQ(imported.engine, "Unity");
  ASSERT_THAT(imported.probes, SizeIs(1));
  const Probe& probe = imported.probes.front();
  EXPECT_EQ(probe.name, "Hall");
  // (0, 1, 4) doubled is (0, 2, 8); a quarter turn about Y takes +Z to +X: (8, 2, 0), and so (9, 4, 3) in Unity.
  expectNear(probe.origin, {-9, 4, 3});
  expectNear(probe.box.center(), {-9.5, 3.75, 3});
  expectNear(probe.box.size(), {8, 3, 6});  // along the world's axes, not scaled
  expectNear(probe.blendDistance.max, glm::dvec3(1.5));
  EXPECT_TRUE(probe.projection);
  EXPECT_EQ(probe.mode, ProbeMode::Realtime);
  EXPECT_EQ(probe.importance, 2.0);
  EXPECT_EQ(probe.intensity, 0.8);
  EXPECT_EQ(probe.farDistance, 500.0);
  EXPECT_THAT(imported.remarks, IsEmpty());
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return text.replace(at, from.size(), to);
}

TEST(EngineImport, DamagedUnityFilesAreRefusedWithTheirLine) {
  const auto refused = [](const std::string& text) { return errorText([&] { parseUnityProbes(text, "Hall.unity"); }); };
  EXPECT_THAT(refused("%YAML 1.1\n"), HasSubstr("has no ReflectionProbe"));
  EXPECT_THAT(refused(replaced(kUnity, "{x: 8, y: 3, z: 6}", "{x: eight, y: 3, z: 6}")),
              AllOf(HasSubstr("Hall.unity:17:"), HasSubstr("m_BoxSize")));
  EXPECT_THAT(refused(replaced(kUnity, "m_Father: {fileID: 0}", "m_Father: {fileID: 101}")), HasSubstr("circle"));
  EXPECT_THAT(refused(replaced(kUnity, "{x: 0, y: 0, z: 0, w: 1}", "{x: 0, y: 0, z: 0, w: 0}")), HasSubstr("rotation"));
  EXPECT_THAT(refused(replaced(kUnity, "m_Importance: 2", "m_Importance: 1e999")), HasSubstr("m_Importance"));
}

TEST(EngineImport, UnitysModesAreOursOrSaid) {
  EXPECT_EQ(parseUnityProbes(replaced(kUnity, "m_Mode: 1", "m_Mode: 0"), "a").probes.at(0).mode, ProbeMode::Baked);
  const ImportedProbes custom = parseUnityProbes(replaced(kUnity, "m_Mode: 1", "m_Mode: 2"), "a");
  EXPECT_EQ(custom.probes.at(0).mode, ProbeMode::Baked);
  ASSERT_THAT(custom.remarks, SizeIs(1));
  EXPECT_EQ(custom.remarks.front(), "probes.Hall: its custom picture stays in Unity; it is baked here");
}

TEST(EngineImport, AProbeWithoutItsTransformIsSaid) {
  const ImportedProbes imported = parseUnityProbes(
      replaced(kUnity, "  m_GameObject: {fileID: 100}\n  serializedVersion", "  serializedVersion"), "a");
  ASSERT_THAT(imported.remarks, SizeIs(1));
  EXPECT_THAT(imported.remarks.front(), HasSubstr("origin"));
}

const char* const kGodot = R"([gd_scene load_steps=2 format=3 uid="uid://x"]

[ext_resource type="PackedScene" path="res://room.glb" id="1"]

[node name="World" type="Node3D"]

[node name="Wing" type="Node3D" parent="."]
transform = Transform3D(0, 0, 1, 0, 1, 0, -1, 0, 0, 10, 0, 0)

[node name="Probe \"A\"" type="ReflectionProbe" parent="Wing"]
transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1.5, 2)
update_mode = 1
intensity = 0.5
size = Vector3(8, 3, 6)
origin_offset = Vector3(1, 0, 0)
box_projection = true
interior = true

[node name="Other" type="ReflectionProbe" parent="."]
)";

TEST(EngineImport, GodotsProbesStandWhereTheirParentsPutThem) {
  const ImportedProbes imported = parseGodotProbes(kGodot, "world.tscn");
  ASSERT_THAT(imported.probes, SizeIs(2));
  const Probe& probe = imported.probes[0];
  EXPECT_EQ(probe.name, "Probe \"A\"");
  // The wing takes +X to -Z, +Z to +X: (0, 1.5, 2) stands at (12, 1.5, 0), and one further along the probe's X at z =
  // -1.
  expectNear(probe.box.center(), {12, 1.5, 0});
  expectNear(probe.origin, {12, 1.5, -1});
  expectNear(probe.box.size(), {8, 3, 6});
  expectNear(rotationMatrix(probe.rotationDegrees) * glm::dvec3(1, 0, 0), {0, 0, -1});
  EXPECT_EQ(probe.mode, ProbeMode::Realtime);
  EXPECT_EQ(probe.intensity, 0.5);
  EXPECT_TRUE(probe.projection);
  EXPECT_TRUE(std::holds_alternative<ClearToNone>(probe.clear));
  expectNear(imported.probes[1].box.size(), glm::dvec3(20));  // Godot 4's default
}

TEST(EngineImport, Godot3GivesHalfSizes) {
  const ImportedProbes imported = parseGodotProbes(
      "[gd_scene format=2]\n[node name=\"R\" type=\"Spatial\"]\n[node name=\"P\" type=\"ReflectionProbe\" "
      "parent=\".\"]\n"
      "transform = Transform( 2, 0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 0 )\nextents = Vector3( 4, 1.5, 3 )\n",
      "a.tscn");
  ASSERT_THAT(imported.probes, SizeIs(1));
  expectNear(imported.probes[0].box.size(), {16, 3, 6});  // scaled by its transform
}

TEST(EngineImport, DamagedGodotFilesAreRefusedWithTheirLine) {
  const auto refused = [](const std::string& text) { return errorText([&] { parseGodotProbes(text, "world.tscn"); }); };
  EXPECT_THAT(refused("[gd_scene format=3]\n"), HasSubstr("no node of type ReflectionProbe"));
  EXPECT_THAT(refused(replaced(kGodot, "0, 1.5, 2)", "0, 1.5)")),
              AllOf(HasSubstr("world.tscn:10:"), HasSubstr("12 numbers")));
  EXPECT_THAT(refused(replaced(kGodot, "Vector3(8, 3, 6)", "Vector3(8, nan, 6)")), HasSubstr("size"));
  EXPECT_THAT(refused(replaced(kGodot, "Transform3D(1, 0, 0, 0", "Transform3D(0, 0, 0, 0")), HasSubstr("no size"));
}

TEST(EngineImport, RotationsComeBackAsDegrees) {
  for (const glm::dvec3& degrees :
       {glm::dvec3(10, 20, 30), glm::dvec3(-170, 85, 5), glm::dvec3(20, 90, 0), glm::dvec3(20, -90, 0)}) {
    const glm::dmat3 m = rotationMatrix(degrees), again = rotationMatrix(rotationDegreesOf(m));
    for (int column = 0; column < 3; ++column) expectNear(again[column], m[column]);
  }
}

class EngineImportFile : public TemporaryFolder {};

TEST_F(EngineImportFile, TheKindIsFoundByItsBeginningOrItsName) {
  EXPECT_EQ(importProbes(write("a.unity", kUnity)).engine, "Unity");
  EXPECT_EQ(importProbes(write("b.tscn", kGodot)).engine, "Godot");
  EXPECT_THAT(errorText([&] { importProbes(write("c.txt", "hello")); }), HasSubstr("neither"));
  EXPECT_THAT(errorText([&] { importProbes(file("none.tscn")); }), HasSubstr("none.tscn"));
}

}  // namespace
}  // namespace boxprobe
