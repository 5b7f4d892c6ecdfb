#include "filters/io/engines/engine_files.h"

#include <algorithm>
#include <filesystem>
#include <glm/common.hpp>
#include <iterator>
#include <sstream>
#include <utility>
#include <variant>

#include "filters/core/base/number_text.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/engines/engine_source.h"
#include "filters/io/engines/probe_text.h"

namespace boxprobe {

namespace {

bool listed(std::string_view list, std::string_view word) {
  std::istringstream words{std::string(list)};
  for (std::string each; words >> each;) {
    if (each == word) return true;
  }
  return false;
}

std::string vector3(const glm::dvec3& v) {
  return numberText(v.x) + ", " + numberText(v.y) + ", " + numberText(v.z);
}

/// Godot has one distance for all faces.
double largest(const BlendDistance& blend) {
  const glm::dvec3 both = glm::max(blend.min, blend.max);
  return std::max({both.x, both.y, both.z});
}

/// A double-quoted string literal of GDScript, C and similar languages.
std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) {
    if (c == '"' || c == '\\') result += '\\';
    if (static_cast<unsigned char>(c) >= 0x20) result += c;
  }
  return result;
}

std::string filledIn(const std::string& text, const ExportedProbe& exported) {
  const Probe& probe = exported.probe;
  const glm::dmat3 turn = rotationMatrix(probe.rotationDegrees);
  const auto rows = [](const glm::dmat3& m) {
    const glm::dmat3 t = glm::transpose(m);
    return vector3(t[0]) + ", " + vector3(t[1]) + ", " + vector3(t[2]);
  };
  const std::pair<const char*, std::string> fields[] = {
      {"@NAME@", escaped(probe.name)},
      {"@FILE@", escaped(exported.file)},
      {"@ORIGIN@", vector3(probe.origin)},
      {"@CENTER@", vector3(probe.box.center())},
      {"@SIZE@", vector3(probe.box.size())},
      {"@HALF@", vector3(0.5 * probe.box.size())},
      {"@ORIGIN_OFFSET@", vector3(glm::transpose(turn) * (probe.origin - probe.box.center()))},
      {"@BASIS_ROWS@", rows(turn)},
      {"@PROJECTION@", probe.projection ? "true" : "false"},
      {"@PROBE_X@", vector3(turn[0])},
      {"@PROBE_Y@", vector3(turn[1])},
      {"@PROBE_Z@", vector3(turn[2])},
      {"@INTENSITY@", numberText(probe.intensity)},
      {"@FAR@", numberText(probe.farDistance)},
      {"@INTERIOR@", std::holds_alternative<ClearToNone>(probe.clear) ? "true" : "false"},
      {"@UPDATE@", probe.mode == ProbeMode::Realtime ? "1" : "0"},
      {"@BLEND@", numberText(largest(probe.blendDistance))},
      {"@PROBE@", escaped(probeLine(probe))},
      {"@LATLONG_SHIFT@", exported.ladder->latLongCentre.x > 0.5f ? "0.25" : "0.0"},
  };
  // In one pass: a probe may be called "@FILE@", and substituted text is not a template.
  std::string filled;
  for (std::size_t at = 0; at < text.size();) {
    const auto found = std::find_if(std::begin(fields), std::end(fields), [&](const auto& field) {
      return text.compare(at, std::string_view(field.first).size(), field.first) == 0;
    });
    if (found == std::end(fields)) {
      filled += text[at++];
      continue;
    }
    filled += found->second;
    at += std::string_view(found->first).size();
  }
  return filled;
}

}  // namespace

const std::vector<EngineRow>& engineRows() {
  static const std::vector<EngineRow> rows = {
      {"three.js", "boxprobe_three.js", "ktx2", "three"},
      {"Babylon.js", "boxprobe_babylon.js", "dds", "babylon", true},
      {"PlayCanvas", "boxprobe_playcanvas.js", "ktx2", "three", true},
      {"Bevy", "boxprobe_bevy.rs", "ktx2", "bevy", true},
      {"Unity", "BoxprobeImport.cs", "dds", "unity"},
      {"Unreal", "boxprobe_unreal.py", "hdr exr dds", "own"},
      {"Godot", "boxprobe.gdshader", "exr hdr", "own three"},
      {"Godot", "boxprobe.tscn", "exr hdr", "own three", false, true},
      {"Blender", "boxprobe_blender.py", "exr hdr", "own three"},
  };
  return rows;
}

std::vector<EngineFile> engineFiles(const std::vector<ExportedProbe>& probes, std::string_view format,
                                    std::string_view ladder) {
  std::vector<EngineFile> files;
  for (const EngineRow& row : engineRows()) {
    if (!listed(row.formats, format) || !listed(row.ladders, ladder)) continue;
    const std::string text(engineSource(row.file));
    if (!row.perProbe) {
      files.push_back({std::string(row.file), text});
      continue;
    }
    const std::string extension = std::filesystem::path(row.file).extension().string();
    for (const ExportedProbe& exported : probes) {
      files.push_back({std::filesystem::path(exported.file).stem().string() + extension, filledIn(text, exported)});
    }
  }
  return files;
}

}  // namespace boxprobe
