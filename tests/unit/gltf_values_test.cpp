// All values of a glTF file with no two alike, against files in tests/unit/values: what the reader makes of every
// field, and of every field once it is another one, of another type or missing.
#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <nlohmann/json.hpp>

#include "tests/unit/model_values.h"

namespace boxprobe {
namespace {

using Json = nlohmann::json;

template <typename Number>
void append(std::string& bytes, double value) {
  const auto number = static_cast<Number>(value);
  bytes.append(reinterpret_cast<const char*>(&number), sizeof number);
}

void append(std::string& bytes, int component, double value) {
  if (component == 5120) append<std::int8_t>(bytes, value);
  if (component == 5121) append<std::uint8_t>(bytes, value);
  if (component == 5122) append<std::int16_t>(bytes, value);
  if (component == 5123) append<std::uint16_t>(bytes, value);
  if (component == 5125) append<std::uint32_t>(bytes, value);
  if (component == 5126) append<float>(bytes, value);
}

/// values/whole.json with its "arrays" as accessors, and their bytes.
class WholeGltf {
 public:
  explicit WholeGltf(const std::string& text) {
    json = Json::parse(text);
    const Json arrays = json["arrays"];
    json.erase("arrays");
    for (const auto& [name, array] : arrays.items()) {
      indices_[name] = json["accessors"].size();
      addArray(array);
    }
    json["buffers"] = {{{"uri", "whole.bin"}, {"byteLength", bytes.size()}}};
    nameArrays(json);
  }

  Json json;
  std::string bytes;

 private:
  /// Elements `stride` apart, with other bytes between them.
  std::size_t addView(int component, std::size_t components, const Json& values, std::size_t stride,
                      std::size_t offset = 0) {
    bytes.resize((bytes.size() + 7) / 8 * 8, '\x5a');
    const std::size_t from = bytes.size();
    bytes.append(offset, '\x5a');
    for (std::size_t i = 0; i < values.size(); i += components) {
      const std::size_t element = bytes.size();
      for (std::size_t c = 0; c < components; ++c) append(bytes, component, values[i + c]);
      if (stride > 0) bytes.resize(element + stride, '\x5a');
    }
    json["bufferViews"].push_back({{"buffer", 0}, {"byteOffset", from}, {"byteLength", bytes.size() - from}});
    if (stride > 0) json["bufferViews"].back()["byteStride"] = stride;
    return json["bufferViews"].size() - 1;
  }

  void addArray(const Json& array) {
    const std::map<std::string, std::size_t> types = {
        {"SCALAR", 1}, {"VEC2", 2}, {"VEC3", 3}, {"VEC4", 4}, {"MAT4", 16}};
    const std::size_t components = types.at(array["type"]);
    Json accessor = {{"type", array["type"]}, {"componentType", array["component"]}};
    if (array.contains("values")) {
      accessor["count"] = array["values"].size() / components;
      accessor["bufferView"] = addView(array["component"], components, array["values"], array.value("stride", 0u),
                                       array.value("offset", 0u));
      if (array.contains("offset")) accessor["byteOffset"] = array["offset"];
    } else {
      accessor["count"] = array["count"];
    }
    if (array.value("normalized", false)) accessor["normalized"] = true;
    if (array.contains("max")) accessor["max"] = {array["max"]};
    if (array.contains("sparse")) {
      const Json& sparse = array["sparse"];
      const std::size_t at = addView(sparse["component"], 1, sparse["at"], 0);
      const std::size_t values = addView(array["component"], components, sparse["values"], 0);
      accessor["sparse"] = {{"count", sparse["at"].size()},
                            {"indices", {{"bufferView", at}, {"componentType", sparse["component"]}}},
                            {"values", {{"bufferView", values}}}};
    }
    json["accessors"].push_back(accessor);
  }

  /// "@name" becomes the accessor's number.
  void nameArrays(Json& value) const {
    if (value.is_string()) {
      const std::string text = value;
      if (text.rfind('@', 0) == 0) value = indices_.at(text.substr(1));
      return;
    }
    if (!value.is_structured()) return;
    for (Json& each : value) nameArrays(each);
  }

  std::map<std::string, std::size_t> indices_;
};

class GltfValues : public ModelValues {
 protected:
  GltfValues() { write("whole.bin", gltf.bytes); }
  std::vector<std::string> lines(const Json& json, const ModelState& state = {}) const {
    return linesOf("whole.gltf", json.dump(), state);
  }
  WholeGltf gltf{bytesOf("whole.json")};
};

TEST_F(GltfValues, AreThoseOfTheFile) {
  const std::vector<std::string> rest = lines(gltf.json);
  std::vector<std::string> kept = modelLines(readModel(write("whole.gltf", gltf.json.dump())), folder_.string(), true);
  const auto addState = [&](const std::string& what, const ModelState& state) {
    kept.push_back("== " + what);
    for (const std::string& line : lines(gltf.json, state)) {
      if (std::find(rest.begin(), rest.end(), line) == rest.end()) kept.push_back(line);
    }
  };
  for (const char* variant : {"day", "night", "variant2", "dusk"}) addState(variant, {variant, {}});
  for (const double seconds : {-1.0, 0.25, 0.75, 1.0, 1.5, 2.4, 9.0}) {
    addState("at " + std::to_string(seconds), {"", seconds});
  }
  test::expectKeptValues("unit/values/gltf.txt", kept);
}

/// Visits each member and element once, those of one kind at most `most` times.
class Edits {
 public:
  explicit Edits(const Json& whole) : whole_(whole) { visit(whole_, Json::json_pointer(), ""); }

  struct Edit {
    std::string name;
    Json json;
  };
  std::vector<Edit> list;

 private:
  void visit(const Json& value, const Json::json_pointer& at, const std::string& kind) {
    if (value.is_object()) {
      for (const auto& [key, member] : value.items()) {
        if (key == "asset" || key == "bufferViews" || key == "buffers") continue;
        edit(member, at / key, kind + "/" + key, at, key);
      }
    } else if (value.is_array()) {
      for (std::size_t i = 0; i < value.size(); ++i) {
        if (value[i].is_number() && i > 1) break;
        edit(value[i], at / i, kind + "/*", at, "");
      }
    }
  }

  void edit(const Json& value, const Json::json_pointer& at, const std::string& kind, const Json::json_pointer& above,
            const std::string& key) {
    if (++seen_[kind] <= 2) {
      const std::string name = at.to_string();
      // A light without its number: some versions of the library refuse the file themselves.
      if (!key.empty() && key != "light") {
        Json without = whole_;
        without[above].erase(key);
        list.push_back({name + " missing", without});
      }
      const auto replaced = [&](const Json& by) {
        Json json = whole_;
        json[at] = by;
        list.push_back({name + " = " + by.dump(), json});
      };
      if (value.is_number()) {
        replaced(-1);
        replaced(1000);
      }
      if (value.is_string()) replaced("other");
      if (value.is_boolean()) replaced(!value.get<bool>());
      replaced(value.is_string() ? Json(7) : Json("x"));
    }
    visit(value, at, kind);
  }

  const Json& whole_;
  std::map<std::string, int> seen_;
};

/// Each version of tinygltf has its own words: ours have a place in front.
bool isOfParser(const std::string& line) {
  const std::string start = "! whole.gltf: ", end = "; export it again";
  return line.rfind(start, 0) == 0 && line.find(": ", start.size()) == std::string::npos && line.size() > end.size() &&
         line.compare(line.size() - end.size(), end.size(), end) == 0;
}

TEST_F(GltfValues, ChangeAsTheFileDoes) {
  const Model kept = readModel(write("whole.gltf", gltf.json.dump()));  // keeps the pictures decoded
  const ModelState state{"day", 0.75};
  const std::vector<std::string> before = lines(gltf.json, state);
  std::vector<std::string> told;
  for (const Edits::Edit& edit : Edits(gltf.json).list) {
    const std::vector<std::string> after = lines(edit.json, state);
    told.push_back(edit.name + ": " + (isOfParser(after.front()) ? "refused" : differenceOf(before, after)));
  }
  // Views that end behind their buffer, though neither number alone is beyond it.
  for (const char* path : {"/bufferViews/1/byteOffset", "/bufferViews/1/byteLength", "/bufferViews/0/byteLength"}) {
    Json json = gltf.json;
    json[Json::json_pointer(path)] = gltf.bytes.size();
    told.push_back(path + std::string(" = all: ") + differenceOf(before, lines(json, state)));
  }
  test::expectKeptValues("unit/values/gltf_edits.txt", told);
}

}  // namespace
}  // namespace boxprobe
