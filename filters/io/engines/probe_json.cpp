#include "filters/io/engines/probe_json.h"

#include <algorithm>
#include <glm/gtc/quaternion.hpp>
#include <nlohmann/json.hpp>

#include "filters/core/geometry/probe_geometry.h"
#include "filters/io/engines/probe_text.h"

namespace boxprobe {

namespace {

using OrderedJson = nlohmann::ordered_json;

OrderedJson numbers(const glm::dvec3& v) {
  return {v.x, v.y, v.z};
}

OrderedJson axisSigns(const glm::vec3& v) {
  return {static_cast<int>(v.x), static_cast<int>(v.y), static_cast<int>(v.z)};
}

OrderedJson boxJson(const Box& box) {
  return {{"min", numbers(box.min)},
          {"max", numbers(box.max)},
          {"center", numbers(box.center())},
          {"size", numbers(box.size())}};
}

OrderedJson quaternion(const glm::dvec3& rotationDegrees) {
  const glm::dquat q = glm::quat_cast(rotationMatrix(rotationDegrees));
  return {q.x, q.y, q.z, q.w};
}

OrderedJson levelsJson(const ExportedProbe& exported) {
  OrderedJson levels = OrderedJson::array();
  for (int level = 0; level < exported.levels; ++level) {
    levels.push_back({{"level", level},
                      {"size", std::max(exported.faceSize >> level, 1)},
                      {"roughness", exported.ladder->roughness(level, exported.levels, exported.faceSize)}});
  }
  return levels;
}

}  // namespace

std::string probeJson(const ExportedProbe& exported) {
  const Probe& probe = exported.probe;
  const bool cube = exported.format == "ktx2" || exported.format == "dds";
  OrderedJson json = {{"format", "boxprobe-export"}, {"version", 1},          {"writer", exported.writer},
                      {"name", probe.name},          {"file", exported.file}, {"container", exported.format}};
  if (!exported.diffuseFile.empty()) json["diffuseFile"] = exported.diffuseFile;
  json["units"] = {{"length", "metres"}, {"angle", "degrees"}, {"colour", "linear Rec. 709 radiance"}};
  json["axes"] = {{"handedness", "right"}, {"up", "+Y"}, {"like", "glTF"}};
  json["origin"] = numbers(probe.origin);
  json["capturedAt"] = numbers(exported.capturedAt);
  json["box"] = boxJson(probe.box);
  json["rotationDegrees"] = numbers(probe.rotationDegrees);
  json["rotationQuaternion"] = quaternion(probe.rotationDegrees);
  json["influence"] = boxJson(probe.influenceBox());
  json["blendDistance"] = {{"min", numbers(probe.blendDistance.min)}, {"max", numbers(probe.blendDistance.max)}};
  json["importance"] = probe.importance;
  json["intensity"] = probe.intensity;
  json["projection"] = probe.projection;
  json["technique"] = probe.technique;
  if (cube) {
    json["cube"] = {{"frame", "the box's axes, turned by rotationQuaternion"},
                    {"faces", {"+X", "-X", "+Y", "-Y", "+Z", "-Z"}},
                    {"orientation", "OpenGL, Direct3D, Vulkan and Metal: rows from the top of each face"},
                    {"lookup", axisSigns(exported.ladder->lookup)},
                    {"alpha", "coverage; colours are multiplied by it"}};
    json["ladder"] = {{"name", exported.ladder->id},
                      {"roughness", exported.ladder->formula},
                      {"faceSize", exported.faceSize},
                      {"levels", levelsJson(exported)}};
  } else {
    const bool z = exported.ladder->latLongCentre.z > 0.5f;
    json["latLong"] = {{"frame", "the box's axes, turned by rotationQuaternion"},
                       {"center", z ? "+Z" : "+X"},
                       {"rightQuarter", z ? "-X" : "+Z"},
                       {"top", "+Y"},
                       {"texels", "at cell centres"}};
    json["ladder"] = {{"name", exported.ladder->id}, {"roughness", "level 0 alone: the engine filters"}};
  }
  json["probe"] = OrderedJson::parse(probeLine(probe));
  return json.dump(2) + "\n";
}

}  // namespace boxprobe
