// Godot's scene files: sections "[node name=".." type=".." parent=".."]", each followed by one value per line. Formats
// 2 (Godot 3: half sizes) and 3 (Godot 4: sizes).
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/gtc/quaternion.hpp>
#include <glm/matrix.hpp>
#include <iterator>
#include <map>
#include <utility>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/core/geometry/probe_geometry.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/io/engines/import_detail.h"
#include "filters/io/engines/probe_text.h"

namespace boxprobe {

namespace {

struct GodotNode {
  int line = 0;
  std::string name, type, parent;
  std::map<std::string, std::string> values;
};

/// The value of name="value" in a section's header.
std::string attribute(const std::string& head, const std::string& name) {
  const std::size_t at = head.find(" " + name + "=");
  if (at == std::string::npos) return "";
  const std::size_t start = at + name.size() + 2;
  if (start >= head.size() || head[start] != '"') return head.substr(start, head.find_first_of(" ]", start) - start);
  std::string value;
  for (std::size_t i = start + 1; i < head.size() && head[i] != '"'; ++i) {
    if (head[i] == '\\' && i + 1 < head.size()) ++i;
    value += head[i];
  }
  return value;
}

std::string trimmed(const std::string& text) {
  const std::size_t start = text.find_first_not_of(" \t");
  return start == std::string::npos ? "" : text.substr(start, text.find_last_not_of(" \t") + 1 - start);
}

constexpr LeftOutField kGodotLeftOut[] = {
    {"enable_shadows", "false", "the lights' own `shadows` decide in captures"},
    {"cull_mask", "1048575", "captures see every object but those in `hides`"},
    {"reflection_mask", "1048575", "every object in the influence box is lit"},
    {"layers", "1", "there are no layers"},
    {"ambient_mode", "1", "diffuse light comes from the capture"},
    {"ambient_color", "Color(0, 0, 0, 1)", "diffuse light comes from the capture"},
    {"ambient_color_energy", "1.0", "diffuse light comes from the capture"},
    {"interior_ambient_color", "Color( 0, 0, 0, 1 )", "diffuse light comes from the capture"},
    {"interior_ambient_energy", "1.0", "diffuse light comes from the capture"},
    {"interior_ambient_contrib", "0.0", "diffuse light comes from the capture"},
    {"mesh_lod_threshold", "1.0", "models have no levels of detail"},
};

/// Keys that say nothing about light.
bool saysNothingOfLight(const std::string& key) {
  const char* const known[] = {
      "script",           "editor_description",         "unique_name_in_owner", "process_mode",
      "process_priority", "process_physics_priority",   "process_thread_group", "rotation_edit_mode",
      "pause_mode",       "physics_interpolation_mode", "auto_translate_mode",  "gizmo",
      "visibility_parent"};
  return key.rfind("metadata/", 0) == 0 || key.rfind("__meta__", 0) == 0 ||
         std::find(std::begin(known), std::end(known), key) != std::end(known);
}

/// Those that are read, here or as part of the placement.
bool isRead(const std::string& key) {
  const char* const known[] = {"transform",      "position",   "translation",    "rotation",      "rotation_degrees",
                               "rotation_order", "quaternion", "basis",          "scale",         "top_level",
                               "visible",        "size",       "extents",        "origin_offset", "box_projection",
                               "interior",       "intensity",  "blend_distance", "update_mode",   "max_distance"};
  return std::find(std::begin(known), std::end(known), key) != std::end(known);
}

glm::dmat3 turnAbout(int axis, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  const int next = (axis + 1) % 3, last = (axis + 2) % 3;
  glm::dmat3 m(1.0);
  m[next][next] = m[last][last] = c;
  m[next][last] = s;
  m[last][next] = -s;
  return m;
}

constexpr const char* kExportedProbe = "metadata/boxprobe";

class GodotReader {
 public:
  GodotReader(const std::string& text, std::string name) : name_(std::move(name)) {
    GodotNode* node = nullptr;
    int line = 0;
    for (std::size_t at = 0; at < text.size();) {
      const std::size_t end = std::min(text.find('\n', at), text.size());
      std::string row = text.substr(at, end - at);
      at = end + 1;
      ++line;
      if (!row.empty() && row.back() == '\r') row.pop_back();
      if (row.rfind("[gd_scene", 0) == 0) format_ = leadingNumber(attribute(row, "format")).value_or(3.0);
      if (row.rfind("[node ", 0) == 0) {
        nodes_.push_back({line, attribute(row, "name"), attribute(row, "type"), attribute(row, "parent"), {}});
        node = &nodes_.back();
      } else if (!row.empty() && row[0] == '[') {
        node = nullptr;
      } else if (node != nullptr) {
        const std::size_t equals = row.find('=');
        if (equals != std::string::npos) node->values[trimmed(row.substr(0, equals))] = trimmed(row.substr(equals + 1));
      }
    }
  }

  ImportedProbes probes() const {
    ImportedProbes imported;
    imported.engine = "Godot";
    struct Placed {
      NodePlacement placement;
      bool visible = true;
    };
    std::map<std::string, Placed> placed;  // by path below the root
    checkProbeCount(name_, static_cast<std::size_t>(std::count_if(nodes_.begin(), nodes_.end(), [](const auto& node) {
                      return node.type == "ReflectionProbe";
                    })));
    ProbeNames names{Scene()};
    bool any = false;
    for (const GodotNode& node : nodes_) {
      const bool root = node.parent.empty();
      const std::string path = root ? "." : node.parent == "." ? node.name : node.parent + "/" + node.name;
      Placed own{placement(node), flag(node, "visible", true)};
      const auto parent = placed.find(node.parent);
      if (!root && parent != placed.end()) {
        if (!flag(node, "top_level", false)) own.placement = own.placement.within(parent->second.placement);
        own.visible = own.visible && parent->second.visible;
      }
      placed[path] = own;
      if (node.type != "ReflectionProbe") continue;
      any = true;
      const std::optional<Probe> before = exported(node, imported.remarks);
      const std::string name = uniqueName(names, before ? before->name : node.name);
      if (!own.visible) {
        imported.remarks.push_back("probes." + name + ": is left out, because it or a parent has visible = false");
        continue;
      }
      if (!root && parent == placed.end()) {
        imported.remarks.push_back("probes." + name + ": its parent " + printable(oneLine(node.parent)) +
                                   " is in another file; it is taken to be at the origin");
      }
      imported.probes.push_back(probe(node, name, own.placement, imported.remarks));
      if (before) keepWhatIsEqual(*before, imported.probes.back());
    }
    if (!any) {
      throw InputError(
          name_ + ": has no node of type ReflectionProbe; probes of scenes that it instances stand in their files");
    }
    return imported;
  }

 private:
  [[noreturn]] void fail(const GodotNode& node, const std::string& what) const {
    throw InputError(oneLine(name_ + ":" + std::to_string(node.line) + ": node " + node.name + ": " + what));
  }

  /// The numbers in the brackets of "Vector3(1, 2, 3)"; their count must match.
  std::vector<double> numbers(const GodotNode& node, const std::string& key, const std::string& value,
                              std::size_t count) const {
    std::vector<double> result;
    std::size_t at = value.find('(');
    while (at != std::string::npos && result.size() < count) {
      const auto read = leadingNumber(std::string_view(value).substr(at + 1));
      if (!read) break;
      result.push_back(*read);
      at = value.find(',', at + 1);
    }
    if (result.size() != count || at != std::string::npos) {
      fail(node, key + ": expected " + std::to_string(count) + " numbers in brackets, not " + value);
    }
    return result;
  }

  glm::dvec3 vector(const GodotNode& node, const std::string& key, const glm::dvec3& missing) const {
    const auto found = node.values.find(key);
    if (found == node.values.end()) return missing;
    const std::vector<double> v = numbers(node, key, found->second, 3);
    return {v[0], v[1], v[2]};
  }

  double number(const GodotNode& node, const std::string& key, double missing) const {
    const auto found = node.values.find(key);
    if (found == node.values.end()) return missing;
    const auto read = leadingNumber(found->second);
    if (!read) fail(node, key + ": expected a number, not " + found->second);
    return *read;
  }

  bool flag(const GodotNode& node, const std::string& key, bool missing) const {
    const auto found = node.values.find(key);
    if (found == node.values.end()) return missing;
    if (found->second != "true" && found->second != "false") {
      fail(node, key + ": expected true or false, not " + found->second);
    }
    return found->second == "true";
  }

  static bool has(const GodotNode& node, const std::string& key) { return node.values.count(key) > 0; }

  /// What our own export keeps beside the node, in the words of a scene file.
  std::optional<Probe> exported(const GodotNode& node, std::vector<std::string>& remarks) const {
    const auto found = node.values.find(kExportedProbe);
    if (found == node.values.end()) return {};
    try {
      return probeOfLine(attribute(" v=" + found->second, "v"), kExportedProbe);
    } catch (const InputError& error) {
      remarks.push_back("node " + printable(oneLine(node.name)) + ": " + error.what() +
                        "; only Godot's fields are read");
      return {};
    }
  }

  /// Columns of a basis that the file has by rows.
  static glm::dmat3 fromRows(const std::vector<double>& m) {
    return glm::dmat3(m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]);
  }

  /// Turned as by Godot's Basis::set_euler: the order names the axes from the left, "YXZ" is Y * X * Z.
  glm::dmat3 turnOf(const GodotNode& node, const glm::dvec3& radians) const {
    constexpr int kOrders[6][3] = {{0, 1, 2}, {0, 2, 1}, {1, 0, 2}, {1, 2, 0}, {2, 0, 1}, {2, 1, 0}};
    const double order = number(node, "rotation_order", 2.0);
    const auto row = static_cast<std::size_t>(order >= 0.0 && order <= 5.0 ? order : 2.0);
    glm::dmat3 turn(1.0);
    for (const int axis : kOrders[row]) turn = turn * turnAbout(axis, radians[axis]);
    return turn;
  }

  /// `transform` alone, or position, rotation and scale one by one; what stands beside a transform replaces its part.
  NodePlacement placement(const GodotNode& node) const {
    NodePlacement own;
    if (has(node, "transform")) {
      const std::vector<double> m = numbers(node, "transform", node.values.at("transform"), 12);
      own = {fromRows(m), {m[9], m[10], m[11]}};
    }
    own.position = vector(node, "position", vector(node, "translation", own.position));
    glm::dvec3 scale(1.0);
    glm::dmat3 turn = own.axes;
    for (int axis = 0; axis < 3; ++axis) {
      scale[axis] = glm::length(turn[axis]);
      if (scale[axis] > 0.0) turn[axis] /= scale[axis];
    }
    constexpr double kRadians = 3.14159265358979323846 / 180.0;
    bool parts = true;
    if (has(node, "basis")) {
      own.axes = fromRows(numbers(node, "basis", node.values.at("basis"), 9));
      parts = false;
    } else if (has(node, "quaternion")) {
      turn = turnOfQuaternion(node);
    } else if (has(node, "rotation")) {
      turn = turnOf(node, vector(node, "rotation", glm::dvec3(0.0)));
    } else if (has(node, "rotation_degrees")) {
      turn = turnOf(node, kRadians * vector(node, "rotation_degrees", glm::dvec3(0.0)));
    } else {
      parts = has(node, "scale");
    }
    if (!parts) return own;
    scale = vector(node, "scale", scale);
    for (int axis = 0; axis < 3; ++axis) own.axes[axis] = turn[axis] * scale[axis];
    return own;
  }

  glm::dmat3 turnOfQuaternion(const GodotNode& node) const {
    const std::vector<double> q = numbers(node, "quaternion", node.values.at("quaternion"), 4);
    const double square = q[0] * q[0] + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
    if (!(square > 1e-12)) fail(node, "quaternion: is no rotation");
    const glm::dquat turn(q[3] / std::sqrt(square), q[0] / std::sqrt(square), q[1] / std::sqrt(square),
                          q[2] / std::sqrt(square));
    return glm::mat3_cast(turn);
  }

  void listLeftOut(const GodotNode& node, const std::string& name, std::vector<std::string>& remarks) const {
    for (const auto& [key, value] : node.values) {
      if (isRead(key) || saysNothingOfLight(key)) continue;
      const std::string written = key + " = " + value.substr(0, 80);
      if (auto remark = leftOut(kGodotLeftOut, "probes." + name + ": ", key, value, written))
        remarks.push_back(std::move(*remark));
    }
  }

  Probe probe(const GodotNode& node, const std::string& name, const NodePlacement& placed,
              std::vector<std::string>& remarks) const {
    Probe result;
    result.name = name;
    const glm::dvec3 standard(format_ >= 3 ? 20.0 : 2.0);  // Godot 3 and the first versions of 4 have half sizes
    const glm::dvec3 size = vector(node, "size", 2.0 * vector(node, "extents", 0.5 * standard));
    glm::dmat3 turn = placed.axes;
    glm::dvec3 scale(1.0);
    for (int axis = 0; axis < 3; ++axis) {
      scale[axis] = glm::length(turn[axis]);
      if (!(scale[axis] > 1e-9)) fail(node, "transform: has no size along an axis");
      turn[axis] /= scale[axis];
    }
    if (glm::determinant(turn) < 0.0) {  // a mirrored box is the same box
      turn[0] = -turn[0];
      remarks.push_back("probes." + result.name + ": is mirrored by its transform; its box is the same");
    }
    const glm::dvec3 half = 0.5 * glm::abs(size) * scale;
    result.box = {placed.position - half, placed.position + half};
    result.rotationDegrees = rotationDegreesOf(turn);
    result.origin = placed.position + placed.axes * vector(node, "origin_offset", glm::dvec3(0.0));
    result.projection = flag(node, "box_projection", false);
    result.intensity = number(node, "intensity", 1.0);
    result.blendDistance.min = result.blendDistance.max =
        glm::dvec3(std::max(number(node, "blend_distance", 1.0), 0.0));
    result.mode = number(node, "update_mode", 0.0) == 1.0 ? ProbeMode::Realtime : ProbeMode::Baked;
    if (const double far = number(node, "max_distance", 0.0); far > result.nearDistance) result.farDistance = far;
    if (flag(node, "interior", false)) result.clear = ClearToNone{};
    listLeftOut(node, name, remarks);
    return result;
  }

  /// Godot's fields count where somebody changed them since; all others are as exported, to the last digit.
  static void keepWhatIsEqual(const Probe& before, Probe& probe) {
    const Probe read = probe;
    probe = before;
    probe.name = read.name;
    const auto differs = [](const glm::dvec3& a, const glm::dvec3& b) {
      return glm::length(a - b) > 1e-6 * (1.0 + glm::length(a));
    };
    const auto turn = rotationMatrix(before.rotationDegrees), now = rotationMatrix(read.rotationDegrees);
    const bool turned = differs(turn[0], now[0]) || differs(turn[1], now[1]);
    if (turned) probe.rotationDegrees = read.rotationDegrees;
    if (turned || differs(before.box.min, read.box.min) || differs(before.box.max, read.box.max)) {
      if (probe.influence) {  // moves and grows with the box
        probe.influence->min += read.box.min - before.box.min;
        probe.influence->max += read.box.max - before.box.max;
      }
      probe.box = read.box;
    }
    if (differs(before.origin, read.origin)) probe.origin = read.origin;
    probe.projection = read.projection;
    probe.intensity = read.intensity;
    const auto largest = [](const BlendDistance& blend) {
      const glm::dvec3 both = glm::max(blend.min, blend.max);
      return std::max({both.x, both.y, both.z});
    };
    if (largest(before.blendDistance) != largest(read.blendDistance)) probe.blendDistance = read.blendDistance;
    if (before.farDistance != read.farDistance && read.farDistance != Probe().farDistance) {
      probe.farDistance = read.farDistance;
    }
    const bool interior = std::holds_alternative<ClearToNone>(read.clear);
    if (interior != std::holds_alternative<ClearToNone>(before.clear)) probe.clear = read.clear;
    const bool realtime = read.mode == ProbeMode::Realtime;
    if (realtime != (before.mode == ProbeMode::Realtime)) probe.mode = read.mode;
  }

  double format_ = 3.0;
  std::vector<GodotNode> nodes_;
  std::string name_;
};

}  // namespace

ImportedProbes parseGodotProbes(const std::string& text, const std::string& name) {
  return GodotReader(text, name).probes();
}

}  // namespace boxprobe
