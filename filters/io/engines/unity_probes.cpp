// Unity's text serialization: YAML documents, one per object, headed "--- !u!CLASS &ID". Reads only what probes need:
// keys at an indentation of two spaces and their flow maps, {x: 1, y: 2, z: 3}.
#include <algorithm>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <map>
#include <set>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/engines/import_detail.h"

namespace boxprobe {

namespace {

constexpr int kGameObject = 1, kTransform = 4, kRectTransform = 224, kReflectionProbe = 215;

struct UnityObject {
  double kind = 0.0;  // Unity's class number; any number is possible
  int line = 0;
  std::map<std::string, std::string> values;
};
using UnityObjects = std::map<std::string, UnityObject>;  // by ID

UnityObjects unityObjects(const std::string& text) {
  UnityObjects objects;
  UnityObject* object = nullptr;
  int line = 0;
  for (std::size_t at = 0; at < text.size();) {
    const std::size_t end = std::min(text.find('\n', at), text.size());
    std::string row = text.substr(at, end - at);
    at = end + 1;
    ++line;
    if (!row.empty() && row.back() == '\r') row.pop_back();
    if (row.rfind("--- !u!", 0) == 0) {
      const std::size_t id = row.find('&');
      object = nullptr;
      if (id == std::string::npos) continue;
      object = &objects[row.substr(id + 1, row.find(' ', id) - id - 1)];
      object->kind = leadingNumber(row.substr(7)).value_or(0.0);
      object->line = line;
    } else if (object != nullptr && row.size() > 3 && row[0] == ' ' && row[1] == ' ' && row[2] != ' ' &&
               row[2] != '-') {
      const std::size_t colon = row.find(':');
      if (colon != std::string::npos) {
        const std::size_t value = row.find_first_not_of(' ', colon + 1);
        object->values[row.substr(2, colon - 2)] = value == std::string::npos ? "" : row.substr(value);
      }
    }
  }
  return objects;
}

/// The number or word of a key in "{x: 1, y: 2}".
std::string inFlowMap(const std::string& map, const std::string& key) {
  for (std::size_t at = map.find(key + ":"); at != std::string::npos; at = map.find(key + ":", at + 1)) {
    const bool whole = at > 0 && (map[at - 1] == '{' || map[at - 1] == ' ' || map[at - 1] == ',');
    if (!whole) continue;
    const std::size_t start = map.find_first_not_of(' ', at + key.size() + 1);
    if (start == std::string::npos) return "";
    return map.substr(start, map.find_first_of(",}", start) - start);
  }
  return "";
}

class UnityReader {
 public:
  UnityReader(const std::string& text, std::string name) : objects_(unityObjects(text)), name_(std::move(name)) {
    for (const auto& [id, object] : objects_) {
      if (object.kind == kTransform || object.kind == kRectTransform)
        transformOf_[reference(object, "m_GameObject")] = id;
    }
  }

  ImportedProbes probes() const {
    ImportedProbes imported;
    imported.engine = "Unity";
    std::map<int, const UnityObject*> byLine;
    for (const auto& [id, object] : objects_) {
      if (object.kind == kReflectionProbe) byLine[object.line] = &object;
    }
    if (byLine.empty()) {
      throw InputError(name_ +
                       ": has no ReflectionProbe; save the scene or prefab that does as text (Project Settings, "
                       "Editor, Asset Serialization)");
    }
    std::set<std::string> taken;
    for (const auto& [line, object] : byLine) imported.probes.push_back(probe(*object, taken, imported.remarks));
    return imported;
  }

 private:
  [[noreturn]] void fail(const UnityObject& object, const std::string& what) const {
    throw InputError(oneLine(name_ + ":" + std::to_string(object.line) + ": " + what));
  }

  std::string text(const UnityObject& object, const std::string& key) const {
    const auto found = object.values.find(key);
    return found == object.values.end() ? "" : found->second;
  }

  std::string reference(const UnityObject& object, const std::string& key) const {
    return inFlowMap(text(object, key), "fileID");
  }

  double number(const UnityObject& object, const std::string& key, double missing) const {
    const std::string value = text(object, key);
    if (value.empty()) return missing;
    const auto read = leadingNumber(value);
    if (!read) fail(object, key + ": expected a number, not " + value);
    return *read;
  }

  glm::dvec4 vector(const UnityObject& object, const std::string& key, const glm::dvec4& missing) const {
    const std::string map = text(object, key);
    if (map.empty()) return missing;
    glm::dvec4 result = missing;
    const char* const names[] = {"x", "y", "z", "w"};
    for (int i = 0; i < 4; ++i) {
      const std::string value = inFlowMap(map, names[i]);
      if (value.empty() && i == 3) continue;
      const auto read = leadingNumber(value);
      if (!read) fail(object, key + ": expected {x: .., y: .., z: ..}, not " + map);
      result[i] = *read;
    }
    return result;
  }

  NodePlacement placement(const std::string& transformId, int depth) const {
    constexpr int kDeepest = 256;
    const auto found = objects_.find(transformId);
    if (found == objects_.end()) return {};
    const UnityObject& transform = found->second;
    if (depth > kDeepest) fail(transform, "m_Father: the transforms go round in a circle");
    const glm::dvec4 q = vector(transform, "m_LocalRotation", {0, 0, 0, 1});
    const double length2 = glm::dot(q, q);
    if (!(length2 > 1e-12)) fail(transform, "m_LocalRotation: is no rotation");
    const glm::dvec4 s = vector(transform, "m_LocalScale", {1, 1, 1, 0}),
                     p = vector(transform, "m_LocalPosition", glm::dvec4(0.0));
    const double k = 2.0 / length2;
    NodePlacement own;
    own.axes = {
        {s.x * (1 - k * (q.y * q.y + q.z * q.z)), s.x * k * (q.x * q.y + q.z * q.w), s.x * k * (q.x * q.z - q.y * q.w)},
        {s.y * k * (q.x * q.y - q.z * q.w), s.y * (1 - k * (q.x * q.x + q.z * q.z)), s.y * k * (q.y * q.z + q.x * q.w)},
        {s.z * k * (q.x * q.z + q.y * q.w), s.z * k * (q.y * q.z - q.x * q.w),
         s.z * (1 - k * (q.x * q.x + q.y * q.y))}};
    own.position = glm::dvec3(p);
    const std::string father = reference(transform, "m_Father");
    return father.empty() || father == "0" ? own : own.within(placement(father, depth + 1));
  }

  Probe probe(const UnityObject& object, std::set<std::string>& taken, std::vector<std::string>& remarks) const {
    const std::string owner = reference(object, "m_GameObject");
    const auto gameObject = objects_.find(owner);
    const auto transform = transformOf_.find(owner);
    Probe result;
    result.name = uniqueName(taken, gameObject == objects_.end() ? "" : text(gameObject->second, "m_Name"));
    if (transform == transformOf_.end()) {
      remarks.push_back("probes." + result.name +
                        ": its transform is in another file; it is taken to be at the origin");
    }
    const glm::dvec3 position =
        transform == transformOf_.end() ? glm::dvec3(0.0) : placement(transform->second, 0).position;
    const glm::dvec3 size(vector(object, "m_BoxSize", {10, 10, 10, 0})),
        offset(vector(object, "m_BoxOffset", glm::dvec4(0.0)));
    const auto mirrored = [](const glm::dvec3& v) { return glm::dvec3(-v.x, v.y, v.z); };
    // Unity's boxes lie along the world's axes, however the object is rotated, and are relative to its position.
    const glm::dvec3 center = mirrored(position + offset), half = 0.5 * glm::abs(size);
    result.origin = mirrored(position);
    result.box = {center - half, center + half};
    result.blendDistance.min = result.blendDistance.max =
        glm::dvec3(std::max(number(object, "m_BlendDistance", 1.0), 0.0));
    result.nearDistance = number(object, "m_NearClip", 0.3);
    result.farDistance = number(object, "m_FarClip", 1000.0);
    result.importance = number(object, "m_Importance", 1.0);
    result.intensity = number(object, "m_IntensityMultiplier", 1.0);
    result.projection = number(object, "m_BoxProjection", 0.0) != 0.0;
    result.mode = number(object, "m_Mode", 0.0) == 1.0 ? ProbeMode::Realtime : ProbeMode::Baked;
    if (number(object, "m_Mode", 0.0) == 2.0) {
      remarks.push_back("probes." + result.name + ": its custom picture stays in Unity; it is baked here");
    }
    return result;
  }

  UnityObjects objects_;
  std::map<std::string, std::string> transformOf_;  // by game object
  std::string name_;
};

}  // namespace

ImportedProbes parseUnityProbes(const std::string& text, const std::string& name) {
  return UnityReader(text, name).probes();
}

}  // namespace boxprobe
