// Probes out of Unity's YAML and Godot's scenes: places through their parents, axes, and what is refused.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/io/engines/engine_files.h"
#include "filters/io/engines/import_detail.h"
#include "filters/io/engines/ladder.h"
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

const char* const kUnityFields[][2] = {
    {"m_HDR: 0", "m_HDR: 0 is left out"},
    {"m_ShadowDistance: 40", "m_ShadowDistance: 40 is left out"},
    {"m_CullingMask:\n    serializedVersion: 2\n    m_Bits: 55", "m_CullingMask: 55 is left out"},
    {"m_RenderDynamicObjects: 1", "m_RenderDynamicObjects: 1 is left out"},
    {"m_UseOcclusionCulling: 0", "m_UseOcclusionCulling: 0 is left out"},
    {"m_RefreshMode: 0", "m_RefreshMode: 0 is left out: Unity captures it once"},
    {"m_TimeSlicingMode: 1", "m_TimeSlicingMode: 1 is left out"},
    {"m_SomethingNew: 3", "m_SomethingNew: 3 is left out: this program does not know it"},
    {"m_Resolution: 100", "m_Resolution: 100 becomes 128"}};

TEST(EngineImport, EachFieldOfUnitysIsCarriedOverOrNamed) {
  const auto with = [](const std::string& field) {
    return parseUnityProbes(replaced(kUnity, "  m_Resolution: 128\n", "  " + field + "\n"), "a");
  };
  const ImportedProbes whole = with(
      "m_Resolution: 512\n  m_ClearFlags: 2\n  m_BackGroundColor: {r: 0.25, g: 0.5, b: 1, a: 0}\n  m_HDR: 1\n"
      "  m_RefreshMode: 1\n  m_ShadowDistance: 100\n  m_CullingMask:\n    serializedVersion: 2\n    m_Bits: "
      "4294967295\n"
      "  m_UseOcclusionCulling: 1\n  m_Enabled: 1");
  EXPECT_THAT(whole.remarks, IsEmpty());
  const Probe& probe = whole.probes.at(0);
  EXPECT_EQ(probe.faceSize, 512);
  EXPECT_EQ(probe.nearDistance, 0.3);
  // The curve of sRGB (IEC 61966-2-1): ((v + 0.055) / 1.055)^2.4.
  const glm::vec3 color = std::get<glm::vec3>(probe.clear);
  EXPECT_NEAR(color.x, std::pow((0.25 + 0.055) / 1.055, 2.4), 1e-5);
  EXPECT_NEAR(color.y, std::pow((0.5 + 0.055) / 1.055, 2.4), 1e-5);
  EXPECT_NEAR(color.z, 1.0, 1e-6);
  EXPECT_TRUE(std::holds_alternative<ClearToSky>(with("m_ClearFlags: 1").probes.at(0).clear));
  for (const auto& [field, said] : kUnityFields) {
    const ImportedProbes imported = with(field);
    ASSERT_THAT(imported.remarks, SizeIs(1)) << field;
    EXPECT_THAT(imported.remarks[0], HasSubstr(std::string("probes.Hall: ") + said));
  }
}

TEST(EngineImport, WhatIsOffInUnityIsLeftOutAndSaid) {
  const ImportedProbes off = parseUnityProbes(replaced(kUnity, "  m_Type: 0", "  m_Enabled: 0\n  m_Type: 0"), "a");
  EXPECT_THAT(off.probes, IsEmpty());
  EXPECT_THAT(off.remarks, testing::ElementsAre("probes.Hall: is left out, because m_Enabled is 0"));
  const ImportedProbes group =
      parseUnityProbes(replaced(kUnity, "m_Name: Group", "m_Name: Group\n  m_IsActive: 0"), "a");
  EXPECT_THAT(group.probes, IsEmpty());
  EXPECT_THAT(group.remarks, testing::ElementsAre("probes.Hall: is left out, because m_IsActive is 0 of \"Group\""));
}

// Each name was looked for from the first number on, and each probe's parents were read anew.
TEST(EngineImport, ThousandsOfOneNameAreReadAndTooManyRefused) {
  const auto unity = [](int count) {
    std::string text = kUnity;
    for (int i = 0; i < count; ++i) {
      const std::string id = std::to_string(1000 + i);
      text += "--- !u!215 &" + id + "\nReflectionProbe:\n  m_GameObject: {fileID: 100}\n";
    }
    return text;
  };
  const ImportedProbes many = parseUnityProbes(unity(9999), "a");
  ASSERT_THAT(many.probes, SizeIs(10000));
  EXPECT_EQ(many.probes[9999].name, "Hall 10000");
  expectNear(many.probes[9999].origin, many.probes[0].origin);
  EXPECT_EQ(errorText([&] { parseUnityProbes(unity(10000), "a"); }),
            "a: has more than 10000 reflection probes, the most that are read; leave some out");
  std::string godot = "[gd_scene format=3]\n[node name=\"Root\" type=\"Node3D\"]\n";
  for (int i = 0; i < 10001; ++i) godot += "[node name=\"P\" type=\"ReflectionProbe\" parent=\".\"]\n";
  EXPECT_EQ(errorText([&] { parseGodotProbes(godot, "b.tscn"); }),
            "b.tscn: has more than 10000 reflection probes, the most that are read; leave some out");
}

/// A probe in a node A, each with the lines given.
ImportedProbes godotPair(const std::string& parent, const std::string& probe) {
  return parseGodotProbes(
      "[gd_scene format=3]\n[node name=\"Root\" type=\"Node3D\"]\n[node name=\"A\" type=\"Node3D\" "
      "parent=\".\"]\n" +
          parent + "\n[node name=\"P\" type=\"ReflectionProbe\" parent=\"A\"]\n" + probe,
      "a.tscn");
}

void expectPlacedAs(const Probe& probe, const Probe& other) {
  expectNear(probe.origin, other.origin);
  expectNear(probe.box.min, other.box.min);
  expectNear(probe.box.max, other.box.max);
  for (const glm::dvec3& axis : {glm::dvec3(1, 0, 0), glm::dvec3(0, 0, 1)}) {
    expectNear(rotationMatrix(probe.rotationDegrees) * axis, rotationMatrix(other.rotationDegrees) * axis);
  }
}

TEST(EngineImport, GodotsPartsOfATransformAreTheTransform) {
  const std::string box = "size = Vector3(4, 3, 6)\norigin_offset = Vector3(0.5, 0, 1)\n";
  // A quarter about Y, twice as large, at (10, 0, 0), by rows; (0, 0, -3) in it stands at (4, 0, 0).
  const Probe right = godotPair("transform = Transform3D(0, 0, 2, 0, 2, 0, -2, 0, 0, 10, 0, 0)",
                                "transform = Transform3D(1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, -3)\n" + box)
                          .probes.at(0);
  expectNear(right.box.center(), {4, 0, 0});
  expectNear(right.box.size(), {8, 6, 12});
  expectNear(right.origin, {6, 0, -1});
  for (const char* turn :
       {"rotation_degrees = Vector3(0, 90, 0)", "rotation = Vector3(0, 1.5707963267948966, 0)",
        "rotation_edit_mode = 1\nquaternion = Quaternion(0, 0.7071067811865476, 0, 0.7071067811865476)",
        "rotation_edit_mode=2\nbasis=Basis(0, 0, 2, 0, 2, 0, -2, 0, 0)"}) {
    const std::string scale = std::string(turn).find("basis") == std::string::npos ? "\nscale = Vector3(2, 2, 2)" : "";
    const ImportedProbes imported =
        godotPair("position = Vector3(10, 0, 0)\n" + std::string(turn) + scale, "position = Vector3(0, 0, -3)\n" + box);
    SCOPED_TRACE(turn);
    EXPECT_THAT(imported.remarks, IsEmpty());
    expectPlacedAs(imported.probes.at(0), right);
  }
  // Godot's order Y, X, Z unless another is given: YXZ of (30, 40, 50) takes +X to Ry Rx (cos 50, sin 50, 0).
  const double d = 3.14159265358979323846 / 180.0;
  const glm::dvec3 z(std::cos(50 * d), std::sin(50 * d), 0);
  const glm::dvec3 x(z.x, z.y * std::cos(30 * d), z.y * std::sin(30 * d));
  const glm::dvec3 y(x.x * std::cos(40 * d) + x.z * std::sin(40 * d), x.y,
                     -x.x * std::sin(40 * d) + x.z * std::cos(40 * d));
  const auto xAxis = [&](const std::string& order) {
    const Probe probe = godotPair("", "rotation_degrees = Vector3(30, 40, 50)\n" + order).probes.at(0);
    return rotationMatrix(probe.rotationDegrees) * glm::dvec3(1, 0, 0);
  };
  expectNear(xAxis(""), y);
  // XYZ: Rx Ry (cos 50, sin 50, 0).
  const glm::dvec3 v(z.x * std::cos(40 * d), z.y, -z.x * std::sin(40 * d));
  expectNear(xAxis("rotation_order = 0"),
             {v.x, v.y * std::cos(30 * d) - v.z * std::sin(30 * d), v.y * std::sin(30 * d) + v.z * std::cos(30 * d)});
  expectNear(
      godotPair("position = Vector3(10, 0, 0)", "top_level = true\nposition = Vector3(1, 2, 3)").probes.at(0).origin,
      {1, 2, 3});
}

TEST(EngineImport, EachFieldOfGodotsIsCarriedOverOrNamed) {
  const ImportedProbes whole = godotPair("",
                                         "size = Vector3(4, 3, 6)\nmax_distance = 55.0\nblend_distance = 0.25\n"
                                         "intensity = 0.5\nupdate_mode = 1\ninterior = true\nbox_projection = true\n"
                                         "enable_shadows = false\ncull_mask = 1048575\nmetadata/x = 3\n");
  EXPECT_THAT(whole.remarks, IsEmpty());
  const Probe& probe = whole.probes.at(0);
  EXPECT_EQ(probe.farDistance, 55.0);
  EXPECT_EQ(probe.blendDistance.min.x, 0.25);
  EXPECT_EQ(probe.mode, ProbeMode::Realtime);
  expectNear(godotPair("", "extents = Vector3(2, 1.5, 3)").probes.at(0).box.size(), {4, 3, 6});
  for (const char* field : {"enable_shadows = true", "cull_mask = 3", "reflection_mask = 5", "ambient_mode = 0",
                            "ambient_color = Color(1, 0, 0, 1)", "ambient_color_energy = 2.0",
                            "mesh_lod_threshold = 4.0", "something_new = 1"}) {
    const ImportedProbes imported = godotPair("", field);
    ASSERT_THAT(imported.remarks, SizeIs(1)) << field;
    EXPECT_THAT(imported.remarks[0], HasSubstr("probes.P: " + std::string(field) + " is left out: "));
  }
  const ImportedProbes hidden = godotPair("visible = false", "");
  EXPECT_THAT(hidden.probes, IsEmpty());
  EXPECT_THAT(hidden.remarks, SizeIs(1));
  EXPECT_THAT(errorText([] { godotPair("", "interior = yes"); }), HasSubstr("expected true or false"));
}

class EngineImportFile : public TemporaryFolder {};

/// A probe of no default and no symmetry.
Probe oddProbe(ProbeMode mode, const Clear& clear) {
  Probe probe;
  probe.name = "hall \"west\" \\ 2";
  probe.box = {{-1.1, 0.3, -2.7}, {3.2, 2.9, 4.05}};
  probe.origin = {0.7, 1.37, 0.21};
  probe.rotationDegrees = {10, 35, -5};
  probe.influence = Box{{-1.6, 0.1, -3.0}, {3.3, 3.1, 4.4}};
  probe.nearDistance = 0.07;
  probe.farDistance = 77;
  probe.clear = clear;
  probe.blendDistance = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.65}};
  probe.importance = 3;
  probe.intensity = 0.85;
  probe.projection = false;
  probe.technique = "box+footprint4";
  probe.faceSize = 128;
  probe.mode = mode;
  probe.bevel = Bevel{0.2, 0.1};
  probe.lattice = ProbeLattice{true, 0.63};
  return probe;
}

std::string exportedScene(const Probe& probe, const std::string& extension) {
  ExportedProbe exported;
  exported.probe = probe;
  exported.file = "hall.exr";
  exported.ladder = findLadder("own");
  for (const EngineFile& file : engineFiles({exported}, "exr", "own")) {
    if (file.name == "hall" + extension) return file.text;
  }
  return "";
}

TEST_F(EngineImportFile, OurOwnExportsComeBackEqual) {
  for (const ProbeMode mode : {ProbeMode::Baked, ProbeMode::Realtime}) {
    for (const Clear& clear :
         {Clear(ClearToSky{}), Clear(ClearToNone{}), Clear(ClearToOpen{}), Clear(glm::vec3(1, 0.5f, 0))}) {
      const Probe probe = oddProbe(mode, clear);
      const ImportedProbes godot = importProbes(write("hall.tscn", exportedScene(probe, ".tscn")));
      ASSERT_THAT(godot.probes, SizeIs(1));
      EXPECT_TRUE(godot.probes[0] == probe);
      EXPECT_THAT(godot.remarks, IsEmpty());
      ExportedProbe exported;
      exported.probe = probe;
      exported.file = "hall.ktx2";
      exported.format = "ktx2";
      exported.ladder = findLadder("unity");
      const ImportedProbes json = importProbes(write("hall.json", probeJson(exported)));
      ASSERT_THAT(json.probes, SizeIs(1));
      EXPECT_TRUE(json.probes[0] == probe);
    }
  }
}

// What was changed in Godot since counts; what Godot has no field for stays.
TEST_F(EngineImportFile, EditsInGodotCount) {
  const Probe probe = oddProbe(ProbeMode::Baked, ClearToSky{});
  std::string scene = exportedScene(probe, ".tscn");
  const std::size_t size = scene.find("\nsize = Vector3(") + 1;
  scene.replace(size, scene.find('\n', size) - size, "size = Vector3(5, 2.6, 6.75)");
  scene = replaced(scene, "update_mode = 0", "update_mode = 1");
  const ImportedProbes imported = importProbes(write("hall.tscn", scene));
  ASSERT_THAT(imported.probes, SizeIs(1));
  const Probe& again = imported.probes[0];
  expectNear(again.box.size(), {5, 2.6, 6.75});
  EXPECT_EQ(again.mode, ProbeMode::Realtime);
  EXPECT_EQ(again.technique, probe.technique);
  EXPECT_EQ(again.rotationDegrees, probe.rotationDegrees);
  EXPECT_EQ(again.blendDistance, probe.blendDistance);
  const ImportedProbes damaged = importProbes(write("hall.tscn", replaced(scene, "box+footprint4", "nonsense")));
  EXPECT_THAT(damaged.probes, SizeIs(1));
  EXPECT_THAT(damaged.remarks, SizeIs(1));
}

TEST_F(EngineImportFile, TheKindIsFoundByItsBeginningOrItsName) {
  EXPECT_EQ(importProbes(write("a.unity", kUnity)).engine, "Unity");
  EXPECT_EQ(importProbes(write("b.tscn", kGodot)).engine, "Godot");
  EXPECT_THAT(errorText([&] { importProbes(write("c.txt", "hello")); }), HasSubstr("neither"));
  EXPECT_THAT(errorText([&] { importProbes(write("d.json", "{\"probe\": {}}")); }), HasSubstr("no probe's .json"));
  EXPECT_THAT(errorText([&] { importProbes(file("none.tscn")); }), HasSubstr("none.tscn"));
}

}  // namespace
}  // namespace boxprobe
