// Unity's text serialization: YAML documents, one per object, headed "--- !u!CLASS &ID". Reads only what probes need:
// keys at an indentation of two spaces and their flow maps, {x: 1, y: 2, z: 3}.
#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <iterator>
#include <map>
#include <utility>

#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/io/engines/import_detail.h"
#include "filters/math/cube/srgb.h"

namespace boxprobe {

namespace {

constexpr int kGameObject = 1, kTransform = 4, kRectTransform = 224, kReflectionProbe = 215;

struct UnityObject {
  double kind = 0.0;  // Unity's class number; any number is possible
  int line = 0;
  std::map<std::string, std::string> values;
  std::string last;  ///< the key read last, to which deeper lines belong
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
    } else if (object != nullptr && row.rfind("    m_Bits:", 0) == 0 && !object->last.empty()) {
      const std::size_t value = row.find_first_not_of(' ', 11);  // of a mask, on a line of its own
      if (value != std::string::npos) object->values[object->last] = row.substr(value);
    } else if (object != nullptr && row.size() > 3 && row[0] == ' ' && row[1] == ' ' && row[2] != ' ' &&
               row[2] != '-') {
      const std::size_t colon = row.find(':');
      if (colon != std::string::npos) {
        const std::size_t value = row.find_first_not_of(' ', colon + 1);
        object->last = row.substr(2, colon - 2);
        object->values[object->last] = value == std::string::npos ? "" : row.substr(value);
      }
    }
  }
  return objects;
}

constexpr LeftOutField kUnityLeftOut[] = {
    {"m_Type", "0", "every probe is a cube"},
    {"m_HDR", "1", "captures keep their whole range"},
    {"m_ShadowDistance", "100", "the lights' own `shadows` decide in captures"},
    {"m_CullingMask", "4294967295", "captures see every object but those in `hides`"},
    {"m_RenderDynamicObjects", "0", "what moves is named in `objects` by `dynamic`"},
    {"m_UseOcclusionCulling", "1", "it changes no picture"},
    {"m_UpdateFrequency", "0", "a realtime probe draws one face per frame"},
};

/// Keys that say nothing about light: links between objects, and what Unity writes for itself.
bool isUnitysOwn(const std::string& key) {
  const char* const known[] = {"m_ObjectHideFlags",    "m_CorrespondingSourceObject",
                               "m_PrefabInstance",     "m_PrefabAsset",
                               "m_PrefabParentObject", "m_PrefabInternal",
                               "m_GameObject",         "serializedVersion",
                               "m_BakedTexture",       "m_BakedRenderPassCount",
                               "m_UseMipMap"};
  return std::find(std::begin(known), std::end(known), key) != std::end(known);
}

bool isReadFromUnity(const std::string& key) {
  const char* const known[] = {"m_Enabled",       "m_Mode",          "m_RefreshMode",     "m_TimeSlicingMode",
                               "m_Resolution",    "m_BoxSize",       "m_BoxOffset",       "m_NearClip",
                               "m_FarClip",       "m_ClearFlags",    "m_BackGroundColor", "m_IntensityMultiplier",
                               "m_BlendDistance", "m_BoxProjection", "m_Importance",      "m_CustomBakedTexture"};
  return std::find(std::begin(known), std::end(known), key) != std::end(known);
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
    checkProbeCount(name_, byLine.size());
    ProbeNames names{Scene()};
    for (const auto& [line, object] : byLine) {
      const std::string owner = reference(*object, "m_GameObject");
      const auto gameObject = objects_.find(owner);
      const std::string name =
          uniqueName(names, gameObject == objects_.end() ? "" : text(gameObject->second, "m_Name"));
      if (const std::string off = whyOff(*object, owner); !off.empty()) {
        imported.remarks.push_back("probes." + name + ": is left out, because " + off);
        continue;
      }
      imported.probes.push_back(probe(*object, name, imported.remarks));
    }
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
    if (const auto known = placed_.find(transformId); known != placed_.end()) return known->second;
    const auto found = objects_.find(transformId);
    if (found == objects_.end()) return {};
    const UnityObject& transform = found->second;
    if (depth > kDeepest) {
      fail(transform, "m_Father: the transforms go round in a circle, or are more than " + std::to_string(kDeepest) +
                          " levels deep");
    }
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
    if (!father.empty() && father != "0") own = own.within(placement(father, depth + 1));
    placed_.emplace(transformId, own);
    return own;
  }

  /// Empty if Unity shows the probe: it, its object and the object's parents are all on.
  std::string whyOff(const UnityObject& object, const std::string& owner) const {
    if (number(object, "m_Enabled", 1.0) == 0.0) return "m_Enabled is 0";
    std::string id = owner;
    constexpr int kDeepest = 256;  // circles are refused where placements are read
    for (int depth = 0; depth < kDeepest; ++depth) {
      const auto gameObject = objects_.find(id);
      if (gameObject == objects_.end()) return "";
      if (number(gameObject->second, "m_IsActive", 1.0) == 0.0) {
        return "m_IsActive is 0 of \"" + printable(oneLine(text(gameObject->second, "m_Name"))) + "\"";
      }
      const auto transform = transformOf_.find(id);
      if (transform == transformOf_.end()) return "";
      const auto father = objects_.find(reference(objects_.at(transform->second), "m_Father"));
      if (father == objects_.end()) return "";
      id = reference(father->second, "m_GameObject");
    }
    return "";
  }

  /// Unity keeps colours as the display shows them.
  glm::vec3 linearColor(const UnityObject& object, const std::string& key) const {
    const std::string map = text(object, key);
    glm::vec3 color(0.0f);
    const char* const names[] = {"r", "g", "b"};
    for (int i = 0; i < 3; ++i) {
      const auto read = leadingNumber(inFlowMap(map, names[i]));
      if (!read || *read < 0.0) fail(object, key + ": expected {r: .., g: .., b: ..}, not " + map);
      color[i] = linearOfSrgbValue(*read);
    }
    return color;
  }

  int faceSizeOf(const UnityObject& object, const std::string& place, std::vector<std::string>& remarks) const {
    constexpr int kLeast = 16, kMost = 2048;  // of a scene file
    const double wanted = number(object, "m_Resolution", 128.0);
    int size = kLeast;
    while (size < kMost && size * std::sqrt(2.0) < wanted) size *= 2;
    if (size != wanted) {
      remarks.push_back(place + "m_Resolution: " + numberText(wanted) + " becomes " + std::to_string(size) +
                        ", a power of two from 16 to 2048");
    }
    return size;
  }

  /// How often a realtime probe is captured in Unity.
  void tellRefresh(const UnityObject& object, const std::string& place, std::vector<std::string>& remarks) const {
    if (number(object, "m_Mode", 0.0) != 1.0) return;
    const double refresh = number(object, "m_RefreshMode", 1.0);
    if (refresh != 1.0) {
      remarks.push_back(place + "m_RefreshMode: " + numberText(refresh) + " is left out: Unity captures it " +
                        (refresh == 0.0 ? "once, when it wakes" : "when a script asks") +
                        ", here it is captured continuously");
    }
    if (const double slicing = number(object, "m_TimeSlicingMode", 0.0); slicing != 0.0) {
      remarks.push_back(place + "m_TimeSlicingMode: " + numberText(slicing) +
                        " is left out: a realtime probe draws one face per frame");
    }
  }

  void listLeftOut(const UnityObject& object, const std::string& place, std::vector<std::string>& remarks) const {
    for (const auto& [key, value] : object.values) {
      if (isReadFromUnity(key) || isUnitysOwn(key)) continue;
      const std::string written = key + ": " + value.substr(0, 80);
      if (auto remark = leftOut(kUnityLeftOut, place, key, value, written)) remarks.push_back(std::move(*remark));
    }
  }

  Probe probe(const UnityObject& object, const std::string& name, std::vector<std::string>& remarks) const {
    const auto transform = transformOf_.find(reference(object, "m_GameObject"));
    Probe result;
    result.name = name;
    const std::string place = "probes." + name + ": ";
    if (transform == transformOf_.end()) {
      remarks.push_back(place + "its transform is in another file; it is taken to be at the origin");
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
      remarks.push_back(place + "its custom picture stays in Unity; it is baked here");
    }
    result.faceSize = faceSizeOf(object, place, remarks);
    if (number(object, "m_ClearFlags", 1.0) == 2.0) result.clear = linearColor(object, "m_BackGroundColor");
    tellRefresh(object, place, remarks);
    listLeftOut(object, place, remarks);
    return result;
  }

  UnityObjects objects_;
  std::map<std::string, std::string> transformOf_;       // by game object
  mutable std::map<std::string, NodePlacement> placed_;  // by transform: many probes may share a chain of parents
  std::string name_;
};

}  // namespace

ImportedProbes parseUnityProbes(const std::string& text, const std::string& name) {
  return UnityReader(text, name).probes();
}

}  // namespace boxprobe
