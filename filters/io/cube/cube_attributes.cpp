#include "filters/io/cube/cube_attributes.h"

#include <OpenEXR/ImfDoubleAttribute.h>
#include <OpenEXR/ImfFloatVectorAttribute.h>
#include <OpenEXR/ImfIntAttribute.h>
#include <OpenEXR/ImfStringAttribute.h>
#include <OpenEXR/ImfStringVectorAttribute.h>
#include <OpenEXR/ImfVecAttribute.h>

#include <cmath>

#include "filters/core/base/errors.h"
#include "filters/core/base/number_text.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/read_number.h"
#include "filters/io/scene/scene_json.h"

namespace boxprobe {

namespace {

const std::string kPrefix = "probe.";
const char* const kRenderer = "renderer";  // of OpenGL

bool isVector(const Json& value) {
  return value.is_array() && value.size() == 3 && value[0].is_number() && value[1].is_number() && value[2].is_number();
}

/// The double with the shortest text of a float: 1.6 for 1.6f, not 1.60000002384185791.
double meant(float value) {
  const std::string text = numberText(value);
  double result = value;
  readNumber(text.data(), text.data() + text.size(), result);
  return result;
}

// As v3f if that is exact, as it is for typed values: exrheader prints v3f, but not v3d.
void addVector(Imf::Header& header, const std::string& name, const Imath::V3d& vector) {
  const Imath::V3f narrow(vector);
  if (Imath::V3d(meant(narrow.x), meant(narrow.y), meant(narrow.z)) == vector) {
    header.insert(name, Imf::V3fAttribute(narrow));
  } else {
    header.insert(name, Imf::V3dAttribute(vector));
  }
}

void addValue(Imf::Header& header, const std::string& name, const Json& value) {
  if (value.is_object()) {
    for (const auto& [key, member] : value.items()) addValue(header, name + "." + key, member);
  } else if (value.is_boolean()) {
    header.insert(name, Imf::IntAttribute(value.get<bool>() ? 1 : 0));
  } else if (value.is_number()) {
    header.insert(name, Imf::DoubleAttribute(value.get<double>()));
  } else if (value.is_string()) {
    header.insert(name, Imf::StringAttribute(value.get<std::string>()));
  } else if (isVector(value)) {
    addVector(header, name, {value[0].get<double>(), value[1].get<double>(), value[2].get<double>()});
  } else if (!value.empty()) {
    header.insert(name, Imf::StringVectorAttribute(value.get<Imf::StringVector>()));
  }
}

// Integral values become JSON integers, which the scene reader expects for counts and sizes.
Json numberJson(double value) {
  constexpr double kLargestWhole = 1e15;
  if (std::fabs(value) < kLargestWhole && std::trunc(value) == value) return static_cast<long long>(value);
  return value;
}

std::optional<glm::dvec3> vectorValue(const Imf::Attribute& attribute) {
  if (const auto* wide = dynamic_cast<const Imf::V3dAttribute*>(&attribute)) {
    return glm::dvec3(wide->value().x, wide->value().y, wide->value().z);
  }
  if (const auto* narrow = dynamic_cast<const Imf::V3fAttribute*>(&attribute)) {
    return glm::dvec3(meant(narrow->value().x), meant(narrow->value().y), meant(narrow->value().z));
  }
  return std::nullopt;
}

Json valueJson(const Imf::Attribute& attribute, const std::string& where) {
  if (const auto* flag = dynamic_cast<const Imf::IntAttribute*>(&attribute)) return flag->value() != 0;
  if (const auto* number = dynamic_cast<const Imf::DoubleAttribute*>(&attribute)) return numberJson(number->value());
  if (const auto* text = dynamic_cast<const Imf::StringAttribute*>(&attribute)) return text->value();
  if (const auto* list = dynamic_cast<const Imf::StringVectorAttribute*>(&attribute)) return list->value();
  if (const auto vector = vectorValue(attribute)) {
    return {numberJson(vector->x), numberJson(vector->y), numberJson(vector->z)};
  }
  throw InputError(where + " has the type " + oneLine(attribute.typeName()) + ", which no value has; bake it again");
}

std::string attributeName(const std::string& path, const std::string& name) {
  return path + ": part 0: attribute " + oneLine(name);
}

[[noreturn]] void missing(const std::string& path, const std::string& name) {
  throw InputError(attributeName(path, name) + " is missing: this is not a probe that was baked; bake it again");
}

template <typename Attribute>
const Attribute& require(const Imf::Header& header, const std::string& name, const std::string& path) {
  const auto* attribute = header.findTypedAttribute<Attribute>(name);
  if (attribute == nullptr) missing(path, name);
  return *attribute;
}

}  // namespace

std::string textAttribute(const Imf::Header& header, const std::string& name, const std::string& path) {
  return require<Imf::StringAttribute>(header, name, path).value();
}

glm::dvec3 vectorAttribute(const Imf::Header& header, const std::string& name, const std::string& path) {
  const auto found = header.find(name);
  if (found == header.end()) missing(path, name);
  const auto vector = vectorValue(found.attribute());
  if (!vector) missing(path, name);
  return *vector;
}

void addVectorAttribute(Imf::Header& header, const std::string& name, const glm::dvec3& value) {
  addVector(header, name, {value.x, value.y, value.z});
}

void addProbeAttributes(Imf::Header& header, const BakedProbeInfo& info, const std::string& folder) {
  Scene scene;
  scene.probes.push_back(info.probe);
  const Json probe = sceneToJson(scene, folder, JsonForm::Complete)["probes"][0];
  for (const auto& [key, value] : probe.items()) addValue(header, kPrefix + key, value);
  header.insert("inputHash", Imf::StringAttribute(info.inputHash));
  header.insert("software", Imf::StringAttribute(info.program));
  if (!info.renderer.empty()) header.insert(kRenderer, Imf::StringAttribute(info.renderer));
}

BakedProbeMark readProbeMark(const Imf::Header& header, const std::string& path) {
  BakedProbeMark mark;
  mark.inputHash = textAttribute(header, "inputHash", path);
  mark.program = textAttribute(header, "software", path);
  const auto* renderer = header.findTypedAttribute<Imf::StringAttribute>(kRenderer);
  if (renderer != nullptr) mark.renderer = renderer->value();
  return mark;
}

BakedProbeInfo readProbeAttributes(const Imf::Header& header, const std::string& folder, const std::string& path) {
  BakedProbeInfo info;
  static_cast<BakedProbeMark&>(info) = readProbeMark(header, path);
  Json probe = Json::object();
  for (auto it = header.begin(); it != header.end(); ++it) {
    const std::string name = it.name();
    if (name.rfind(kPrefix, 0) != 0) continue;
    Json* value = &probe;
    for (std::size_t from = kPrefix.size(), dot = 0; dot != std::string::npos; from = dot + 1) {
      dot = name.find('.', from);
      const std::string key = name.substr(from, dot == std::string::npos ? dot : dot - from);
      if (!value->is_null() && !value->is_object()) {
        throw InputError(attributeName(path, name) + " stands below another value; bake it again");
      }
      value = &(*value)[key];
    }
    *value = valueJson(it.attribute(), attributeName(path, name));
  }
  try {
    const Scene scene =
        sceneFromJson({{"format", "boxprobe-scene"}, {"version", 1}, {"probes", Json::array({probe})}}, folder);
    validate(scene);
    info.probe = scene.probes.front();
  } catch (const Error& error) {
    throw InputError(path + ": part 0: attributes: " + error.what() + "; bake it again");
  }
  return info;
}

void addCoefficients(Imf::Header& header, const ShCoefficients& irradiance) {
  Imf::FloatVector values;
  for (const glm::vec3& c : irradiance) values.insert(values.end(), {c.x, c.y, c.z});
  header.insert("irradiance", Imf::FloatVectorAttribute(values));
}

ShCoefficients readCoefficients(const Imf::Header& header, const std::string& path) {
  const Imf::FloatVector values = require<Imf::FloatVectorAttribute>(header, "irradiance", path).value();
  ShCoefficients irradiance{};
  if (values.size() != 3 * irradiance.size()) {
    throw InputError(attributeName(path, "irradiance") + " has " + std::to_string(values.size()) +
                     " values and must have 27; bake it again");
  }
  for (std::size_t i = 0; i < irradiance.size(); ++i) {
    const glm::vec3 c(values[3 * i], values[3 * i + 1], values[3 * i + 2]);
    if (!std::isfinite(c.x) || !std::isfinite(c.y) || !std::isfinite(c.z)) {
      throw InputError(attributeName(path, "irradiance") + " is not finite; bake it again");
    }
    irradiance[i] = c;
  }
  return irradiance;
}

}  // namespace boxprobe
