#include "filters/vtk/import/obj_check.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <set>
#include <sstream>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/inside_folder.h"
#include "filters/io/files/read_file.h"
#include "filters/vtk/import/obj_materials.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

[[noreturn]] void fail(const std::string& path, std::size_t line, const std::string& reason) {
  throw InputError(oneLine(path + (line > 0 ? ":" + std::to_string(line) : "") + ": " + reason));
}

/// The rest of a line as a name, trimmed.
std::string trimmed(const std::string& text) {
  const std::size_t from = text.find_first_not_of(" \t\r");
  if (from == std::string::npos) return {};
  return text.substr(from, text.find_last_not_of(" \t\r") - from + 1);
}

struct ObjCounts {
  long long positions = 0, uvs = 0, normals = 0;
};

/// Checks the up to three indices of a corner, as in "12/3/-1", against the lists so far.
void checkCorner(const std::string& path, std::size_t line, const std::string& corner, const ObjCounts& counts) {
  const long long most[3] = {counts.positions, counts.uvs, counts.normals};
  const char* at = corner.c_str();
  for (int part = 0; part < 3; ++part) {
    if (*at == '/') {
      ++at;
      continue;
    }
    char* end = nullptr;
    const long long index = std::strtoll(at, &end, 10);
    if (end == at || index == 0) fail(path, line, "\"" + corner + "\" is not a corner; indices start from 1");
    if (std::llabs(index) > most[part]) {
      fail(path, line,
           "\"" + corner + "\" refers to entry " + std::to_string(index) + ", but there are " +
               std::to_string(most[part]) + "; the file is damaged");
    }
    at = *end == '/' ? end + 1 : end;
    if (*at == '\0') return;
  }
  if (*at != '\0') fail(path, line, "\"" + corner + "\" is not a corner");
}

/// Reads "v X Y Z R G B", an extension of several programs; false without a colour.
bool readColor(std::istringstream& numbers, std::array<float, 3>& position, glm::vec3& color) {
  std::string words[6];
  for (std::string& word : words) numbers >> word;
  if (words[5].empty()) return false;
  for (std::size_t i = 0; i < 3; ++i) {
    position[i] = std::strtof(words[i].c_str(), nullptr);
    const float value = std::strtof(words[3 + i].c_str(), nullptr);
    color[static_cast<int>(i)] = value >= 0.0f ? std::min(value, 1.0f) : 0.0f;  // 0 for NaN
  }
  return true;
}

/// Converts indices relative to the end of the list to absolute ones: -1 of 7 becomes 7.
std::string countedForward(const std::string& corner, const ObjCounts& counts) {
  const long long all[3] = {counts.positions, counts.uvs, counts.normals};
  std::istringstream parts(corner);
  std::string result;
  int part = 0;
  for (std::string index; std::getline(parts, index, '/'); ++part) {
    const long long value = std::strtoll(index.c_str(), nullptr, 10);
    if (part > 0) result += '/';
    result += value < 0 && part < 3 ? std::to_string(all[part] + 1 + value) : index;
  }
  return result;
}

/// VTK 9.1 does not match material names that contain spaces or are empty with those of the MTL file. Negative indices
/// of texture coordinates and normals make it read outside its arrays.
std::string asVtkReadsIt(const std::string& obj) {
  std::istringstream text(obj);
  std::string result;
  ObjCounts counts;
  for (std::string line; std::getline(text, line);) {
    std::istringstream words(line);
    std::string word;
    words >> word;
    counts.positions += word == "v" ? 1 : 0;
    counts.uvs += word == "vt" ? 1 : 0;
    counts.normals += word == "vn" ? 1 : 0;
    if (word == "usemtl") {
      result += "usemtl " + materialWord(line);
    } else if ((word == "f" || word == "l" || word == "p") && line.find('-') != std::string::npos) {
      result += word;
      for (std::string corner; words >> corner;) result += " " + countedForward(corner, counts);
    } else {
      result += line;
    }
    result += '\n';
  }
  return result;
}

}  // namespace

ObjNames checkObj(const std::string& path) {
  ObjNames names;
  std::istringstream text(readWholeFile(path));
  ObjCounts counts;
  std::set<std::string> seen;
  std::size_t number = 0, faces = 0;
  bool respelled = false;
  constexpr std::size_t kLongestLine = 4000;  // VTK 9.1 splits longer ones
  for (std::string line; std::getline(text, line);) {
    ++number;
    if (line.find('\0') != std::string::npos) fail(path, number, "is not text; save it as OBJ again");
    std::istringstream words(line);
    std::string word;
    words >> word;
    if (line.size() > kLongestLine && !word.empty() && word[0] != '#') {
      fail(path, number, "the line is longer than " + std::to_string(kLongestLine) + " characters; split the polygon");
    }
    if (word == "v") {
      ++counts.positions;
      std::array<float, 3> position;
      glm::vec3 color;
      if (readColor(words, position, color)) names.colors.emplace(position, color);
    }
    if (word == "usemtl") {
      const std::string material = materialWord(line);
      if (seen.insert(material).second) names.materials.push_back(material);
      respelled = respelled || trimmed(line.substr(line.find("usemtl") + 6)) != material;
    }
    if (word == "vt") ++counts.uvs;
    if (word == "vn") ++counts.normals;
    if (word == "mtllib") {
      const std::string name = trimmed(line.substr(line.find("mtllib") + 6));
      const std::string file = pathBeside(path, name);
      if (!insideFolderOf(file, path)) fail(path, number, name + " lies outside the model's folder; put it inside");
      std::error_code ignored;
      if (fs::is_regular_file(file, ignored)) {
        names.materialFile = file;
      } else {
        names.warnings.push_back(
            oneLine("has the material file " + name + ", which does not exist; grey takes its place"));
      }
      continue;
    }
    if (word != "f" && word != "l" && word != "p") continue;
    faces += word == "f" ? 1 : 0;
    for (std::string corner; words >> corner;) {
      checkCorner(path, number, corner, counts);
      respelled = respelled || corner.find('-') != std::string::npos;
    }
  }
  if (respelled) names.text = asVtkReadsIt(text.str());
  if (faces == 0) fail(path, 0, "has no faces; is it an OBJ file?");
  return names;
}

}  // namespace boxprobe
