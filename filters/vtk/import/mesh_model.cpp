#include "filters/vtk/import/mesh_model.h"

#include <filesystem>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/core/base/printable_text.h"
#include "filters/io/image/image_file.h"
#include "filters/io/mesh/polygon_triangles.h"
#include "filters/io/obj/file_beside.h"
#include "filters/io/obj/mtl_material.h"

namespace boxprobe {

void MeshModel::addPicture(const std::string& name) {
  pictures_.emplace_back();
  const FileBeside found = fileBeside(path_, name, path_);
  if (found.path.empty()) {
    model_.warnings.push_back(
        oneLine("has the texture " + printable(name) +
                (found.outside ? ", which lies outside the model's folder; put it inside" : ", which does not exist") +
                "; grey takes its place"));
    return;
  }
  try {
    pictures_.back() = std::make_shared<const ImageRgba8>(loadImage8(found.path));
  } catch (const InputError& error) {
    model_.warnings.push_back(oneLine(std::string(error.what()) + "; grey takes its place"));
  }
}

void MeshModel::add(const Polygons& polygons, std::size_t parts, bool transparent) {
  PolygonMeshes made = meshesOf(polygons, parts, path_);
  if (made.tooHard) model_.warnings.emplace_back(kPolygonsTooHard);
  const std::string name = std::filesystem::path(path_).stem().string();
  for (std::size_t part = 0; part < made.meshes.size(); ++part) {
    Mesh& mesh = made.meshes[part];
    if (mesh.indices.empty()) continue;
    const bool pictured = part < pictures_.size() && pictures_[part], shown = pictured && !mesh.uv.empty();
    Material material = shown || !mesh.colors.empty() ? whiteMaterial() : greyMaterial();
    if (part > 0) material.name += std::to_string(part);
    if (shown) material.baseColorTexture.image = pictures_[part];
    if (pictured && mesh.uv.empty()) {
      model_.warnings.emplace_back("has a texture without texture coordinates, which is not drawn");
    }
    if (transparent) material.alphaMode = AlphaMode::Blend;
    mesh.name = name;
    mesh.material = static_cast<int>(model_.materials.size());
    model_.materials.push_back(std::move(material));
    model_.instances.push_back({name, static_cast<int>(model_.meshes.size()), made.worldFromModel});
    model_.meshes.push_back(std::move(mesh));
  }
  if (model_.instances.empty()) throw InputError(path_ + ": has no triangles to show");
}

std::string leftOutWarning(const std::string& what, const std::string& list) {
  return oneLine(what + list);
}

}  // namespace boxprobe
