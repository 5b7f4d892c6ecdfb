#include "filters/io/obj/obj_file.h"

#include <algorithm>
#include <map>
#include <set>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/io/mesh/smooth_normals.h"
#include "filters/io/mesh/tangents.h"
#include "filters/io/obj/file_beside.h"
#include "filters/io/obj/mtl_file.h"
#include "filters/io/obj/mtl_material.h"
#include "filters/io/obj/mtl_pictures.h"
#include "filters/io/obj/obj_geometry.h"
#include "filters/io/obj/obj_meshes.h"
#include "filters/io/obj/obj_text.h"

namespace boxprobe {

namespace {

/// The materials of all libraries, and the grey ones of those that no library has.
class Materials {
 public:
  Materials(const std::string& path, std::vector<std::string>& warnings) : path_(path), warnings_(warnings) {}

  void read(const std::vector<std::pair<std::size_t, std::string>>& libraries) {
    for (const auto& [line, text] : libraries) readLibrary(text);
  }

  /// Null for a material that no library has; said if there is a library.
  const MtlMaterial* find(const std::string& name) {
    if (name.empty()) return nullptr;
    const auto exact = materials_.find(name);
    if (exact != materials_.end()) return &exact->second;
    for (const auto& [key, material] : materials_) {
      if (lowerText(key) == lowerText(name)) return &material;
    }
    if (!files_.empty() && told_.insert(name).second) {
      warnings_.push_back(oneLine("uses the material " + printable(name) +
                                  ", which its material file does not define; grey takes its place"));
    }
    return nullptr;
  }

 private:
  /// One name, which may have spaces, or several.
  void readLibrary(const std::string& text) {
    if (take(unquoted(text))) return;
    std::vector<std::string> words;
    std::string_view rest = text;
    for (std::string_view word = nextObjWord(rest); !word.empty(); word = nextObjWord(rest)) words.emplace_back(word);
    constexpr std::size_t kMostWords = 64;
    if (words.size() > kMostWords) words.resize(kMostWords);
    for (std::size_t first = 0; first < words.size();) {
      // The longest run of words that is a file's name.
      std::size_t count = words.size() - first;
      for (; count > 0; --count) {
        std::string name = words[first];
        for (std::size_t i = 1; i < count; ++i) name += " " + words[first + i];
        if (take(unquoted(name))) break;
      }
      if (count == 0) {
        // A name of several words ends with the extension.
        std::string name = words[first];
        count = 1;
        const auto ends = [&] { return name.size() > 4 && lowerText(name.substr(name.size() - 4)) == ".mtl"; };
        while (!ends() && first + count < words.size()) name += " " + words[first + count++];
        warnOfMissing(unquoted(name));
      }
      first += count;
    }
  }

  bool take(const std::string& name) {
    const FileBeside found = fileBeside(path_, name, path_);
    if (found.outside) outside_.insert(name);
    if (found.path.empty()) return false;
    if (!files_.insert(found.path).second) return true;
    MtlFile file = readMtlFile(found.path);
    warnings_.insert(warnings_.end(), file.warnings.begin(), file.warnings.end());
    for (MtlMaterial& material : file.materials) {
      const std::string key = material.name;
      materials_.emplace(key, std::move(material));
    }
    return true;
  }

  void warnOfMissing(const std::string& name) {
    const bool outside = outside_.count(name) > 0;
    warnings_.push_back(
        oneLine("has the material file " + printable(name) +
                (outside ? ", which lies outside the model's folder; put it inside" : ", which does not exist") +
                "; grey takes its place"));
  }

  const std::string& path_;
  std::vector<std::string>& warnings_;
  std::map<std::string, MtlMaterial> materials_;  ///< by name
  std::set<std::string> files_, outside_, told_;
};

class ObjReader {
 public:
  ObjReader(const std::string& path, const LoadProgress& progress) : path_(path), progress_(progress) {}

  Model read() {
    ObjGeometry geometry = readObjGeometry(path_, progress_);
    const ObjParts parts = partsOf(geometry, path_, [this](double done) { report(0.5 + 0.2 * done); });
    model_.warnings = std::move(geometry.warnings);
    Materials materials(path_, model_.warnings);
    materials.read(geometry.libraries);
    std::vector<const MtlMaterial*> used(geometry.materials.size(), nullptr);
    for (const ObjPart& part : parts.parts) {
      const auto index = static_cast<std::size_t>(part.mesh.material);
      if (used[index] == nullptr) used[index] = materials.find(geometry.materials[index]);
    }
    std::vector<const MtlMaterial*> named;
    std::copy_if(used.begin(), used.end(), std::back_inserter(named),
                 [](auto* material) { return material != nullptr; });
    MtlPictures pictures(named, path_, model_.warnings, [this](double done) { report(0.7 + 0.2 * done); });
    for (const ObjPart& part : parts.parts) {
      const auto index = static_cast<std::size_t>(part.mesh.material);
      addPart(part, parts.worldFromModel, materialOf(used[index], geometry.materials[index], part.hasColors, pictures));
      report(0.95);
    }
    if (!leftOut_.empty()) {
      std::string text;
      for (const std::string& what : leftOut_) text += (text.empty() ? "" : ", ") + what;
      model_.warnings.push_back(oneLine("has material statements that are not used as written: " + text));
    }
    if (model_.instances.empty()) throw InputError(path_ + ": has no triangles to show");
    return std::move(model_);
  }

 private:
  void report(double done) const {
    if (progress_ && !progress_(done)) throw LoadCancelled(path_ + ": loading was cancelled");
  }

  /// The index in the model. Grey would darken the colours of vertices.
  int materialOf(const MtlMaterial* source, const std::string& name, bool colored, MtlPictures& pictures) {
    const auto [entry, isNew] =
        indices_.emplace(std::make_pair(name, source == nullptr && colored), static_cast<int>(model_.materials.size()));
    if (!isNew) return entry->second;
    Material material = source != nullptr ? materialOfMtl(*source, pictures, leftOut_)
                        : colored         ? whiteMaterial()
                                          : greyMaterial();
    if (!name.empty()) material.name = name;
    model_.materials.push_back(std::move(material));
    return entry->second;
  }

  void addPart(const ObjPart& part, const glm::dmat4& worldFromModel, int material) {
    Mesh mesh = part.mesh;
    if (mesh.indices.empty()) return;
    const Material& drawn = model_.materials[static_cast<std::size_t>(material)];
    if (!part.hasNormals) computeNormals(mesh);
    const int set = tangentSet(mesh, drawn);
    if (set >= 0) addTangents(mesh, set);
    if (set < 0 && drawn.finish.isAnisotropic()) leftOut_.insert("aniso without texture coordinates");
    const std::vector<const TextureUse*> uses = drawn.textures();
    const bool pictured = std::any_of(uses.begin(), uses.end(), [](auto* use) { return use->image != nullptr; });
    if (mesh.uv.empty() && pictured) {
      leftOut_.insert("pictures of faces without texture coordinates");
    }
    mesh.material = material;
    const std::string node = part.object.empty() ? drawn.name : part.object;
    mesh.name = node;
    model_.instances.push_back({node, static_cast<int>(model_.meshes.size()), worldFromModel});
    model_.meshes.push_back(std::move(mesh));
  }

  const std::string& path_;
  const LoadProgress& progress_;
  Model model_;
  std::map<std::pair<std::string, bool>, int> indices_;
  std::set<std::string> leftOut_;
};

}  // namespace

Model readObj(const std::string& path, const LoadProgress& progress) {
  return ObjReader(path, progress).read();
}

}  // namespace boxprobe
