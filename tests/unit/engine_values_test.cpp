// Everything that an export of a probe without symmetry writes, and everything that imports read: value by value,
// against engine_export_values.txt and engine_import_values.txt.
#include <Imath/half.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <glm/geometric.hpp>
#include <limits>

#include "filters/io/engines/cube_container.h"
#include "filters/io/engines/engine_files.h"
#include "filters/io/engines/export_names.h"
#include "filters/io/engines/probe_export.h"
#include "filters/io/engines/probe_import.h"
#include "filters/io/image/image_file.h"
#include "filters/io/scene/scene_json.h"
#include "tests/support/kept_values.h"
#include "tests/unit/cube_pictures.h"
#include "tests/unit/error_text.h"
#include "tests/unit/temporary_folder.h"

namespace boxprobe {
namespace {

using ::testing::ElementsAre;

class EngineValues : public TemporaryFolder {};

/// Different in every direction and channel, and partly open.
CubeMap oddCube(int faceSize) {
  CubeMap cube = cubeOf(faceSize, 1, [](const glm::vec3& direction) {
    const glm::vec3 d = glm::normalize(direction);
    return glm::vec3(1.3f + 0.9f * d.x - 0.2f * d.y * d.z, 0.8f + 0.5f * d.y + 0.3f * d.x * d.x,
                     2.1f - 1.1f * d.z + 0.4f * d.x * d.y);
  });
  for (int i = 0; i < 6 * faceSize * faceSize; ++i) cube.face(0, 0)[4 * i + 3] = 1.0f - 0.5f * float(i % 13) / 13.0f;
  return cube;
}

ProbeCapture oddCapture(const std::string& name) {
  ProbeCapture capture;
  Probe& probe = capture.probe;
  probe.name = name;
  probe.box = {{-1.1, 0.3, -2.7}, {3.2, 2.9, 4.05}};
  probe.origin = {0.7, 1.37, 0.21};
  probe.rotationDegrees = {10, 35, -5};
  probe.influence = Box{{-1.6, 0.1, -3.0}, {3.3, 3.1, 4.4}};
  probe.nearDistance = 0.07;
  probe.farDistance = 77;
  probe.blendDistance = {{0.1, 0.2, 0.3}, {0.4, 0.5, 0.65}};
  probe.importance = 3;
  probe.intensity = 0.85;
  probe.technique = "box+footprint4";
  probe.faceSize = 32;
  probe.filterSamples = 16;
  capture.level0 = oddCube(32);
  for (std::size_t i = 0; i < 9; ++i) {
    const float t = static_cast<float>(i);
    capture.irradiance[i] = {0.9f - 0.13f * t, 0.4f + 0.07f * t * t, 0.2f + 0.3f * std::sin(t)};
  }
  capture.capturedRotation = {0, 20, 5};
  return capture;
}

std::uint32_t word(const std::string& bytes, std::size_t at) {
  std::uint32_t value = 0;
  for (std::size_t i = 4; i-- > 0;) value = value << 8 | static_cast<unsigned char>(bytes.at(at + i));
  return value;
}

/// Headers as words, the levels of each face as sums; `start`: of the texels. KTX2 has the smallest level first and
/// its faces together, DDS a face with all its levels.
void addCubeFile(test::KeptValues& values, const std::string& bytes, bool ktx2, std::size_t start) {
  std::string row;
  for (std::size_t at = ktx2 ? 12 : 4; at + 4 <= start; at += 4) {
    char text[16];
    std::snprintf(text, sizeof text, " x%x", word(bytes, at));
    row += text;
    if (row.size() > 100 || at + 8 > start) {
      values.add(row);
      row.clear();
    }
  }
  const std::uint32_t size = word(bytes, ktx2 ? 20 : 12), levels = word(bytes, ktx2 ? 40 : 28);
  std::vector<float> texels;
  for (std::size_t at = start; at + 2 <= bytes.size(); at += 2) {
    Imath::half value;
    value.setBits(static_cast<std::uint16_t>(word(bytes + "  ", at) & 0xffff));
    texels.push_back(value);
  }
  std::size_t at = 0;
  const auto take = [&](std::uint32_t level, std::uint32_t face) {
    const std::size_t side = std::max(size >> level, 1u), count = side * side;
    if (4 * (at + count) > texels.size()) return values.add("is cut off");
    values.addTexels("level " + std::to_string(level) + " face " + std::to_string(face) + ":", &texels[4 * at], count);
    at += count;
  };
  if (ktx2) {
    for (std::uint32_t level = levels; level-- > 0;) {
      for (std::uint32_t face = 0; face < 6; ++face) take(level, face);
    }
  } else {
    for (std::uint32_t face = 0; face < 6; ++face) {
      for (std::uint32_t level = 0; level < levels; ++level) take(level, face);
    }
  }
  values.add("texels behind: " + std::to_string(texels.size() / 4 - at));
}

TEST_F(EngineValues, EveryFileOfEveryExport) {
  struct Wish {
    const char *format, *ladder;
    int faceSize;
    bool center;
  };
  ProbeCapture capture = oddCapture("hall"), second = oddCapture("inner room");
  second.probe.mode = ProbeMode::Realtime;
  second.probe.clear = ClearToNone{};
  second.probe.projection = false;
  second.probe.influence.reset();
  second.probe.blendDistance = {{0.9, 0.2, 0.3}, {0.4, 0.5, 0.65}};
  second.capturedRotation = second.probe.rotationDegrees;
  second.level0 = oddCube(16);
  test::KeptValues values;
  for (const Wish& wish :
       {Wish{"ktx2", "own", 0, false}, Wish{"ktx2", "three", 0, true}, Wish{"ktx2", "bevy", 16, false},
        Wish{"dds", "babylon", 16, true}, Wish{"dds", "unity", 0, false}, Wish{"exr", "own", 0, false},
        Wish{"exr", "three", 16, true}, Wish{"hdr", "own", 16, true}}) {
    ExportSettings settings;
    settings.format = wish.format;
    settings.ladder = wish.ladder;
    settings.faceSize = wish.faceSize;
    settings.center = wish.center;
    settings.lossy = true;
    settings.writer = "Boxprobe test";
    values.add(std::string("== ") + wish.format + " " + wish.ladder);
    std::vector<ProbeCapture> captures = {capture};
    if (settings.format == "hdr" || settings.ladder == std::string("babylon")) captures.push_back(second);
    for (const std::string& path : exportProbes(captures, settings, folder_.string())) {
      const std::string name = std::filesystem::path(path).filename().string(),
                        extension = std::filesystem::path(path).extension().string();
      values.add("-- " + name);
      if (extension == ".json") values.addJson("", nlohmann::ordered_json::parse(read(name)));
      if (extension == ".tscn") values.add(read(name));
      if (extension == ".ktx2") {
        const std::string bytes = read(name);
        addCubeFile(values, bytes, true, word(bytes, 80 + 24 * (word(bytes, 40) - 1)));
      }
      if (extension == ".dds") addCubeFile(values, read(name), false, 148);
      if (extension != ".exr" && extension != ".hdr") continue;
      const ImageRgbaF picture = loadHdrImage(path);
      values.add("size", {double(picture.width), double(picture.height)});
      for (int part = 0; part < 4; ++part) {
        const std::size_t texels = picture.pixels.size() / 16;
        values.addTexels("rows " + std::to_string(part) + ":", &picture.pixels[4 * texels * std::size_t(part)], texels);
      }
    }
  }
  values.add("== files of engines");
  ExportedProbe exported;
  exported.file = "a.x";
  for (const LadderRow& ladder : ladderRows()) {
    exported.ladder = &ladder;
    for (const std::string& format : exportFormats()) {
      std::string row = format + " " + std::string(ladder.id) + ":";
      for (const EngineFile& file : engineFiles({exported}, format, ladder.id)) row += " " + file.name;
      values.add(row);
    }
    for (const int size : {16, 64, 2048}) {
      std::vector<double> numbers;
      const int levels = ladder.levels(size);
      for (int level = 0; level < levels; ++level) numbers.push_back(ladder.roughness(level, levels, size));
      values.add("ladder " + std::string(ladder.id) + " " + std::to_string(size) + ":", numbers);
    }
  }
  values.expect("unit/values/engine_export_values.txt");
}

TEST_F(EngineValues, AnExportThatIsStoppedLeavesWholeProbes) {
  ExportSettings settings;
  settings.format = "exr";
  settings.lossy = true;
  std::vector<double> told;
  const auto names = exportProbes({oddCapture("a"), oddCapture("b"), oddCapture("c"), oddCapture("d")}, settings,
                                  folder_.string(), [&](double done) {
                                    told.push_back(done);
                                    return told.size() < 3;
                                  });
  EXPECT_THAT(told, ElementsAre(0.0, 0.25, 0.5));
  EXPECT_THAT(names, ElementsAre(file("a.exr"), file("a.json"), file("b.exr"), file("b.json")));
  EXPECT_EQ(entryCount(), 4u);
}

TEST_F(EngineValues, WhatIsLostIsToldWhole) {
  const auto said = [&](const char* format, const std::function<void(ProbeCapture&)>& change) {
    ProbeCapture capture = oddCapture("hall");
    for (int i = 0; i < 6 * 32 * 32; ++i) capture.level0.face(0, 0)[4 * i + 3] = 1.0f;
    change(capture);
    ExportSettings settings;
    settings.format = format;
    const std::string text = errorText([&] { exportProbes({capture}, settings, folder_.string()); });
    const std::string end = std::string("; --lossy writes the nearest that --format ") + format + " holds";
    EXPECT_EQ(text.substr(text.size() - std::min(text.size(), end.size())), end);
    return text.substr(0, text.size() - std::min(text.size(), end.size()));
  };
  const auto set = [](CubeMap& cube, int face, int channel, float value) {
    cube.face(0, face)[4 * 77 + channel] = value;
  };
  const std::string most = "65504, the largest half float";
  EXPECT_EQ(said("ktx2", [&](ProbeCapture& c) { c.clamped = true; }),
            "probes.hall: its source is brighter than " + most);
  EXPECT_EQ(said("dds",
                 [&](ProbeCapture& c) {
                   set(c.level0, 0, 1, -65504.0f);
                   set(c.level0, 5, 2, 70000.0f);
                   set(c.level0, 3, 0, std::nanf(""));
                   set(c.level0, 3, 1, 1e9f);  // of the same texel, which counts once
                   c.clamped = true;
                 }),
            "probes.hall: 1 texels are no numbers, 2 texels are " + most + ", or more");
  EXPECT_EQ(said("hdr",
                 [&](ProbeCapture& c) {
                   set(c.level0, 5, 3, 0.9994f);
                   set(c.level0, 4, 0, std::numeric_limits<float>::infinity());
                 }),
            "probes.hall: 1 texels are no numbers, its coverage (alpha) has no place in a Radiance picture");
  CubeMap cube = cubeOf(4, 1, [](const glm::vec3&) { return glm::vec3(-1e6f, 65503.0f, 0.5f); });
  EXPECT_EQ(halfLoss(cube).texelsAtLimit, 96u);
  cube.face(0, 5)[4 * 15 + 3] = 0.9996f;
  EXPECT_FALSE(coversPartly(cube));
  Imath::half first;
  first.setBits(static_cast<std::uint16_t>(word(encodeDds(cube), 148) & 0xffff));
  EXPECT_EQ(first, -65504.0f);
}

TEST_F(EngineValues, SettingsEndWhereTheyAreSaidTo) {
  const auto said = [](int size) {
    ExportSettings settings;
    settings.faceSize = size;
    try {
      checkExportSettings(settings);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  for (const int size : {0, 16, 32, 2048}) EXPECT_EQ(said(size), "");
  for (const int size : {-16, 1, 8, 24, 2047, 4096}) {
    EXPECT_EQ(said(size),
              "--size " + std::to_string(size) + ": expected a power of two from 16 to 2048, texels along a face");
  }
  EXPECT_THAT(exportStems({"", "A-b_9", "z z"}), ElementsAre("_", "A-b_9", "z_z"));
}

void addImported(test::KeptValues& values, const std::string& label, const ImportedProbes& imported) {
  values.add("== " + label + " of " + imported.engine);
  Scene scene;
  scene.probes = imported.probes;
  if (!scene.probes.empty()) values.addJson("probes", sceneToJson(scene, "", JsonForm::Minimal)["probes"]);
  for (const std::string& remark : imported.remarks) values.add("remark: " + remark);
}

/// Where a piece of text stands once, another.
std::string exchanged(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  EXPECT_NE(at, std::string::npos) << from;
  return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

std::string unityTransform(int id, int of, int father, const std::string& rest) {
  return "--- !u!4 &" + std::to_string(id) + "\nTransform:\n  m_GameObject: {fileID: " + std::to_string(of) +
         "}\n  m_Father: {fileID: " + std::to_string(father) + "}\n" + rest;
}

std::string unityProbe(int id, int of, const std::string& rest) {
  return "--- !u!215 &" + std::to_string(id) + "\nReflectionProbe:\n  m_GameObject: {fileID: " + std::to_string(of) +
         "}\n" + rest;
}

std::string unityObject(int id, const std::string& name, const std::string& rest = "") {
  return "--- !u!1 &" + std::to_string(id) + "\nGameObject:\n  m_Name: " + name + "\n" + rest;
}

/// A probe below a parent below a grandparent: none turned about an axis, none evenly scaled.
std::string oddUnity(const std::string& probe) {
  return "%YAML 1.1\r\n" + unityProbe(12, 10, probe) + unityObject(10, "Deep one") +
         unityTransform(11, 10, 21,
                        "  m_LocalRotation: {x: 0.1, y: 0.2, z: -0.3, w: 0.9}\n"
                        "  m_LocalPosition: {x: 0.5, y: -1.25, z: 2}\n  m_LocalScale: {x: 1.5, y: 0.5, z: 2}\n") +
         unityObject(20, "Parent") +
         unityTransform(21, 20, 31,
                        "  m_LocalRotation: {x: -0.4, y: 0.3, z: 0.2, w: 1.8}\n"
                        "  m_LocalPosition: {x: 3, y: 0.75, z: -1}\n  m_LocalScale: {x: 0.8, y: 1.25, z: 2.5}\n") +
         unityObject(30, "Top") +
         exchanged(
             unityTransform(31, 30, 0,
                            "  m_LocalRotation: {x: 0.6, y: -0.1, z: 0.5, w: 0.7}\n"
                            "  m_LocalPosition: {x: -7, y: 5, z: 0.125}\n  m_LocalScale: {x: -1, y: 3, z: 1.1}\n"),
             "!u!4", "!u!224");
}

const char* const kOddFields =
    "  m_Type: 1\n  m_Mode: 2\n  m_RefreshMode: 2\n  m_TimeSlicingMode: 2\n  m_Resolution: 200\n"
    "  m_BoxSize: {x: 8.5, y: -3.25, z: 6}\n  m_BoxOffset: {x: 0.5, y: -0.25, z: 0.875}\n  m_NearClip: 0.2\n"
    "  m_FarClip: 450\n  m_ClearFlags: 2\n  m_BackGroundColor: {r: 0.2, g: 0.9, b: 0.04, a: 1}\n"
    "  m_IntensityMultiplier: 0.8\n  m_BlendDistance: 1.5\n  m_BoxProjection: 1\n  m_Importance: 2\n"
    "  m_ShadowDistance: 30\n  m_CullingMask:\n    serializedVersion: 2\n    m_Bits: 7\n";

void addUnity(test::KeptValues& values) {
  const auto read = [](const std::string& text) { return parseUnityProbes(text, "a"); };
  addImported(values, "all fields", read(oddUnity(kOddFields)));
  addImported(values, "no fields", read(oddUnity("")));
  addImported(values, "realtime",
              read(oddUnity("  m_Mode: 1\n  m_RefreshMode: 0\n  m_TimeSlicingMode: 1\n"
                            "  m_BlendDistance: -2\n  m_BoxProjection: 0\n  m_ClearFlags: 1\n")));
  addImported(values, "realtime by script", read(oddUnity("  m_Mode: 1\n  m_RefreshMode: 2\n")));
  addImported(values, "two by their lines, one name",
              read(oddUnity("  m_Resolution: 64\n") + unityProbe(1, 10, "  m_Resolution: 32\n") +
                   unityProbe(5, 99, "  m_Resolution: 16\n")));
  addImported(
      values, "off",
      read(oddUnity("  m_Enabled: 0\n") + unityProbe(40, 20, "") +
           exchanged(unityObject(50, "Dark", "  m_IsActive: 0\n"), "--- ", "--- ") + unityTransform(51, 50, 0, "") +
           unityObject(60, "Child") + unityTransform(61, 60, 51, "") + unityProbe(62, 60, "")));
  for (const char* size : {"15", "16", "22", "23", "45", "46", "181", "182", "1449", "5000"}) {
    const ImportedProbes imported = read(oddUnity(std::string("  m_Resolution: ") + size + "\n"));
    values.add(std::string("resolution ") + size + ":", {double(imported.probes.at(0).faceSize)});
    for (const std::string& remark : imported.remarks) values.add("remark: " + remark);
  }
  const auto refused = [&](const std::string& text) { values.add("refused: " + errorText([&] { read(text); })); };
  refused(oddUnity("  m_BoxOffset: {x: 1, y: 2}\n"));
  refused(oddUnity("  m_BoxOffset: 5\n"));
  refused(oddUnity("  m_ClearFlags: 2\n"));
  refused(oddUnity("  m_ClearFlags: 2\n  m_BackGroundColor: {r: 1, g: -0.5, b: 1}\n"));
  refused(oddUnity("  m_NearClip: far\n"));
  refused(oddUnity("  m_FarClip: inf\n"));
  refused(exchanged(oddUnity(""), "w: 1.8", "w: none"));
  refused(exchanged(oddUnity(""), "{fileID: 0}", "{fileID: 11}"));
}

const char* const kTurned = "0.36, 0.48, -0.8, -0.8, 0.6, 0, 0.48, 0.64, 0.6";

std::string godot(const std::string& parent, const std::string& probe, const char* format = "3") {
  return std::string("[gd_scene load_steps=2 format=") + format +
         " uid=\"uid://x\"]\n\n[node name=\"Root\" type=\"Node3D\"]\n" +
         "transform = Transform3D(1, 0, 0, 0, 0.8, -0.6, 0, 0.6, 0.8, 9, 8, 7)\n"
         "[node name=\"A\" type=\"Node3D\" parent=\".\"]\n" +
         parent + "\n[node name=\"P\" type=\"ReflectionProbe\" parent=\"A\"]\n" + probe;
}

void addGodot(test::KeptValues& values) {
  const auto read = [](const std::string& text) { return parseGodotProbes(text, "a.tscn"); };
  const std::string parent =
      std::string("transform = Transform3D(") + kTurned + ", 1.5, -2.5, 4)\nscale = Vector3(1, 2, 0.5)";
  addImported(
      values, "all fields",
      read(godot(parent,
                 "position = Vector3(0.5, 1, -2)\nrotation_degrees = Vector3(20, -30, 70)\n"
                 "scale = Vector3(1.5, 0.75, 2)\nsize = Vector3(4, -3, 6.5)\norigin_offset = Vector3(0.5, 0.25, "
                 "-1)\nbox_projection = true\ninterior = true\nintensity = 0.5\nblend_distance = 0.25\n"
                 "update_mode = 1\nmax_distance = 55\n")));
  addImported(values, "no fields", read(godot(parent, "")));
  addImported(values, "no fields, Godot 3", read(godot("", "", "2")));
  addImported(values, "half sizes", read(godot("", "extents = Vector3(1, 2, 3)\nmax_distance = 0.005\n", "2")));
  addImported(values, "a mirroring transform", read(godot("scale = Vector3(1, -1, 1)", "blend_distance = -1\n")));
  for (int order = -1; order <= 6; ++order) {
    addImported(
        values, "order " + std::to_string(order),
        read(godot("", "rotation_order = " + std::to_string(order) + "\nrotation = Vector3(0.3, -0.7, 1.1)\n")));
  }
  addImported(values, "a quaternion", read(godot("", "quaternion = Quaternion(0.2, -0.6, 0.3, 1.4)\n")));
  addImported(values, "a basis beside a scale",
              read(godot("", std::string("basis = Basis(") + kTurned + ")\nscale = Vector3(7, 7, 7)\n")));
  addImported(values, "a transform with its parts",
              read(godot("", std::string("transform = Transform3D(0.72, 0.96, -0.8, -1.6, 1.2, 0, 0.96, 1.28, 0.6, 1, "
                                         "2, 3)\ntranslation = Vector3(4, 5, 6)\nrotation = Vector3(0, 0.5, 0)\n"))));
  addImported(values, "alone in the world", read(godot(parent, "top_level = true\nposition = Vector3(1, 2, 3)\n")));
  addImported(values, "hidden",
              read(godot(parent, "visible = false\n") +
                   "[node name=\"P\" type=\"ReflectionProbe\" parent=\"B/C\"]\nlayers = 2\n"
                   "[sub_resource]\nintensity = 9\n"));
  const auto refused = [&](const std::string& text) { values.add("refused: " + errorText([&] { read(text); })); };
  refused(godot("", "size = Vector3(1, 2)\n"));
  refused(godot("", "size = Vector3(1, 2, 3, 4)\n"));
  refused(godot("", "size = 3\n"));
  refused(godot("", "intensity = bright\n"));
  refused(godot("", "quaternion = Quaternion(0, 0, 0, 0)\n"));
  refused(godot("", "scale = Vector3(1, 0, 1)\n"));
  refused(godot("", "box_projection = 1\n"));
}

/// What was changed in Godot since an export counts, and nothing else.
void addEdited(test::KeptValues& values, const Clear& clear, ProbeMode mode) {
  ExportedProbe exported;
  exported.probe = oddCapture("hall \"west\" \\ 2").probe;
  exported.probe.clear = clear;
  exported.probe.mode = mode;
  if (mode == ProbeMode::Custom) exported.probe.image = "/pictures/a.exr";
  exported.file = "hall.exr";
  exported.ladder = findLadder("own");
  std::string scene;
  for (const EngineFile& file : engineFiles({exported}, "exr", "own")) {
    if (file.name == "hall.tscn") scene = file.text;
  }
  const auto withRow = [&](const std::string& key, const std::string& value) {
    const std::size_t at = scene.find("\n" + key + " = ", scene.find("type=\"ReflectionProbe\"")) + 1;
    std::string text = scene;
    return text.replace(at, text.find('\n', at) - at, key + " = " + value);
  };
  addImported(values, "as exported", parseGodotProbes(scene, "a.tscn"));
  for (const auto& [key, value] : std::vector<std::pair<std::string, std::string>>{
           {"transform", std::string("Transform3D(") + kTurned + ", 1.05, 1.6, 0.675)"},
           {"size", "Vector3(4.5, 2.6, 6.75)"},
           {"origin_offset", "Vector3(0.1, 0.2, 0.3)"},
           {"box_projection", "false"},
           {"intensity", "0.5"},
           {"interior", std::holds_alternative<ClearToNone>(clear) ? "false" : "true"},
           {"blend_distance", "0.3"},
           {"max_distance", "88"},
           {"max_distance", "0"},
           {"update_mode", mode == ProbeMode::Realtime ? "0" : "1"}}) {
    addImported(values, key + " = " + value, parseGodotProbes(withRow(key, value), "a.tscn"));
  }
}

TEST_F(EngineValues, EveryFieldOfEveryImport) {
  test::KeptValues values;
  addUnity(values);
  addGodot(values);
  addEdited(values, ClearToSky{}, ProbeMode::Baked);
  addEdited(values, ClearToNone{}, ProbeMode::Realtime);
  addEdited(values, glm::vec3(0.1f, 0.2f, 0.7f), ProbeMode::Custom);
  values.expect("unit/values/engine_import_values.txt");
}

}  // namespace
}  // namespace boxprobe
