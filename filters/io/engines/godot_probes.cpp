// Godot's scene files: sections "[node name=".." type=".." parent=".."]", each followed by one value per line. Formats
// 2 (Godot 3: half sizes) and 3 (Godot 4: sizes).
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/core/geometry/rotation_degrees.h"
#include "filters/io/engines/import_detail.h"

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
        const std::size_t equals = row.find(" = ");
        if (equals != std::string::npos) node->values[row.substr(0, equals)] = row.substr(equals + 3);
      }
    }
  }

  ImportedProbes probes() const {
    ImportedProbes imported;
    imported.engine = "Godot";
    std::map<std::string, NodePlacement> placed;  // by path below the root
    std::set<std::string> taken;
    for (const GodotNode& node : nodes_) {
      const bool root = node.parent.empty();
      const std::string path = root ? "." : node.parent == "." ? node.name : node.parent + "/" + node.name;
      NodePlacement own = placement(node);
      const auto parent = placed.find(node.parent);
      if (!root && parent != placed.end()) own = own.within(parent->second);
      placed[path] = own;
      if (node.type == "ReflectionProbe") imported.probes.push_back(probe(node, own, taken, imported.remarks));
    }
    if (imported.probes.empty()) {
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

  bool flag(const GodotNode& node, const std::string& key) const {
    const auto found = node.values.find(key);
    return found != node.values.end() && found->second == "true";
  }

  NodePlacement placement(const GodotNode& node) const {
    const auto found = node.values.find("transform");
    if (found == node.values.end())
      return {glm::dmat3(1.0), vector(node, "position", vector(node, "translation", glm::dvec3(0.0)))};
    const std::vector<double> m = numbers(node, "transform", found->second, 12);  // the basis by rows, then the origin
    return {glm::dmat3(m[0], m[3], m[6], m[1], m[4], m[7], m[2], m[5], m[8]), {m[9], m[10], m[11]}};
  }

  Probe probe(const GodotNode& node, const NodePlacement& placed, std::set<std::string>& taken,
              std::vector<std::string>& remarks) const {
    Probe result;
    result.name = uniqueName(taken, node.name);
    const bool four = format_ >= 3;
    const glm::dvec3 size =
        four ? vector(node, "size", glm::dvec3(20.0)) : 2.0 * vector(node, "extents", glm::dvec3(1.0));
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
    result.projection = flag(node, "box_projection");
    result.intensity = number(node, "intensity", 1.0);
    result.blendDistance.min = result.blendDistance.max =
        glm::dvec3(std::max(number(node, "blend_distance", 1.0), 0.0));
    result.mode = number(node, "update_mode", 0.0) == 1.0 ? ProbeMode::Realtime : ProbeMode::Baked;
    if (const double far = number(node, "max_distance", 0.0); far > result.nearDistance) result.farDistance = far;
    if (flag(node, "interior")) result.clear = ClearToNone{};
    return result;
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
