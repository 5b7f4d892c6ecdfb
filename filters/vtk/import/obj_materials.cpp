#include "filters/vtk/import/obj_materials.h"

#include <algorithm>
#include <filesystem>
#include <sstream>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/inside_folder.h"
#include "filters/io/files/read_file.h"

namespace boxprobe {

namespace {

namespace fs = std::filesystem;

/// Statements that become part of a material; VTK's reader may stop at others.
constexpr const char* kRead[] = {"Ka", "Kd", "Ks", "Ns", "Tr", "d", "illum"};

class MaterialLines {
 public:
  MaterialLines(const std::string& file, const std::string& modelPath) : file_(file), modelPath_(modelPath) {}

  ObjMaterials read(const std::vector<std::string>& used) {
    if (!file_.empty()) readFile();
    for (const std::string& name : used) {
      if (!defined_.insert(name).second) continue;
      result_.text += "newmtl " + name + "\nKd 0.8 0.8 0.8\n";
      if (!file_.empty()) {
        result_.warnings.push_back(
            oneLine("uses the material " + name + ", which its material file does not define; grey takes its place"));
      }
    }
    return std::move(result_);
  }

 private:
  void readFile() {
    std::istringstream text(readWholeFile(file_));
    for (std::string line; std::getline(text, line);) {
      ++number_;
      std::istringstream words(line);
      std::string word;
      words >> word;
      if (word == "newmtl") {
        material_ = materialWord(line);
        defined_.insert(material_);
        result_.text += "newmtl " + material_ + "\n";
        continue;
      }
      if (word.rfind("map_", 0) == 0 || word == "bump" || word == "norm" || word == "disp" || word == "refl") {
        takePicture(word, words);
      } else if (!material_.empty() &&  // before the first material VTK has none to write to
                 std::find(std::begin(kRead), std::end(kRead), word) != std::end(kRead)) {
        result_.text += line + "\n";
      }
    }
  }

  void takePicture(const std::string& word, std::istringstream& words) {
    std::string name;
    for (std::string last; words >> last;) name = last;  // options may precede it
    if (name.empty()) return;
    const std::string picture = pathBeside(file_, name);
    if (!insideFolderOf(picture, modelPath_)) {
      throw InputError(oneLine(file_ + ":" + std::to_string(number_) + ": " + name +
                               " lies outside the model's folder; put it inside"));
    }
    if (word != "map_Kd") return;
    std::error_code ignored;
    if (fs::is_regular_file(picture, ignored)) {
      result_.pictures[material_] = picture;
      return;
    }
    result_.missing.insert(material_);
    result_.warnings.push_back(oneLine("has the texture " + name + ", which does not exist; grey takes its place"));
  }

  const std::string &file_, &modelPath_;
  ObjMaterials result_;
  std::set<std::string> defined_;
  std::string material_;
  std::size_t number_ = 0;
};

}  // namespace

ObjMaterials readObjMaterials(const std::string& file, const std::string& modelPath,
                              const std::vector<std::string>& used) {
  return MaterialLines(file, modelPath).read(used);
}

std::string materialWord(const std::string& line) {
  constexpr const char* kBetween = " \t\r";
  const std::size_t key = line.find_first_not_of(kBetween);
  const std::size_t space = key == std::string::npos ? key : line.find_first_of(kBetween, key);
  const std::size_t from = space == std::string::npos ? space : line.find_first_not_of(kBetween, space);
  if (from == std::string::npos) return "_";
  std::string name = line.substr(from, line.find_last_not_of(kBetween) - from + 1);
  std::replace_if(
      name.begin(), name.end(), [](char c) { return c == ' ' || c == '\t'; }, '_');
  return name;
}

std::string pathBeside(const std::string& file, std::string name) {
  const fs::path folder = fs::path(file).parent_path();
  std::error_code ignored;
  if (!fs::exists(folder / name, ignored)) std::replace(name.begin(), name.end(), '\\', '/');
  return (folder / name).string();
}

}  // namespace boxprobe
