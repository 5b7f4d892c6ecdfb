// Reads OBJ files with their MTL through VTK's importer, and adds what that ignores: vertex colours, and replacements
// for missing pictures and materials.
#include "filters/vtk/import/obj_reader.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkOBJImporter.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <glm/common.hpp>
#include <map>
#include <memory>

#include "filters/core/base/errors.h"
#include "filters/core/base/one_line.h"
#include "filters/io/files/temporary_file.h"
#include "filters/io/image/image_file.h"
#include "filters/vtk/import/obj_check.h"
#include "filters/vtk/import/obj_materials.h"
#include "filters/vtk/import/polydata_mesh.h"
#include "filters/vtk/import/vtk_error_catcher.h"

namespace boxprobe {

namespace {

/// A temporary file with this text: VTK's importer reads materials only from files.
class TemporaryText {
 public:
  explicit TemporaryText(const std::string& text)
      : file_(std::filesystem::temp_directory_path().string(), "boxprobe-") {
    file_.write(text);
  }
  const std::string& path() const { return file_.name(); }

 private:
  TemporaryFile file_;
};

/// The shininess in the MTL file, which VTK rescales for its older shading: "... specular power 30 ..."
double shininess(vtkOBJImporter* importer, int output) {
  const std::string text = importer->GetOutputDescription(output), from = " specular power ";
  const std::size_t start = text.find(from);
  return start == std::string::npos ? 0.0 : std::max(std::strtod(text.c_str() + start + from.size(), nullptr), 0.0);
}

/// "data output 0 with material named NAME texture file ..."
std::string materialName(vtkOBJImporter* importer, int output) {
  const std::string text = importer->GetOutputDescription(output), from = " with material named ";
  const std::size_t start = text.find(from), end = text.find(" texture file ");
  if (start == std::string::npos || end == std::string::npos || end <= start + from.size()) {
    return "material" + std::to_string(output);
  }
  return text.substr(start + from.size(), end - start - from.size());
}

/// MTL's colours are taken as linear. Its shininess n becomes the roughness of a microfacet lobe of the same width as
/// Blinn's: alpha = sqrt(2 / (n + 2)) (Walter et al. 2007), roughness = sqrt(alpha).
Material materialOf(vtkActor* actor, const std::string& name, double shine) {
  vtkProperty* property = actor->GetProperty();
  Material material = plainMaterial();
  material.name = name;
  const double* color = property->GetDiffuseColor();
  const double opacity = std::clamp(property->GetOpacity(), 0.0, 1.0);
  material.baseColor = glm::vec4(std::clamp(color[0], 0.0, 1.0), std::clamp(color[1], 0.0, 1.0),
                                 std::clamp(color[2], 0.0, 1.0), opacity);
  if (opacity < 1.0) material.alphaMode = AlphaMode::Blend;
  material.roughness = static_cast<float>(std::pow(2.0 / (shine + 2.0), 0.25));
  return material;
}

/// The pictures of a file's materials, each read once.
class ObjPictures {
 public:
  ObjPictures(const ObjMaterials& materials, std::vector<std::string>& warnings)
      : materials_(materials), warnings_(warnings) {}

  void give(Material& material) {
    const auto found = materials_.pictures.find(material.name);
    if (found != materials_.pictures.end()) material.baseColorTexture.image = read(found->second);
    const bool unreadable = found != materials_.pictures.end() && !material.baseColorTexture.image;
    if (!unreadable && materials_.missing.count(material.name) == 0) return;
    constexpr float kGrey = 0.2159f;  // sRGB's middle grey
    material.baseColor = glm::vec4(glm::vec3(kGrey), material.baseColor.a);
  }

 private:
  std::shared_ptr<const ImageRgba8> read(const std::string& path) {
    const auto [entry, isNew] = read_.emplace(path, nullptr);
    if (!isNew) return entry->second;
    try {
      entry->second = std::make_shared<const ImageRgba8>(loadImage8(path));
    } catch (const InputError& error) {
      warnings_.push_back(oneLine(std::string(error.what()) + "; grey takes its place"));
    }
    return entry->second;
  }

  const ObjMaterials& materials_;
  std::vector<std::string>& warnings_;
  std::map<std::string, std::shared_ptr<const ImageRgba8>> read_;
};

/// IEC 61966-2-1.
float linearOf(float srgb) {
  return srgb <= 0.04045f ? srgb / 12.92f : std::pow((srgb + 0.055f) / 1.055f, 2.4f);
}

/// Vertices without a colour are white.
void giveColors(const ObjNames& names, Mesh& mesh) {
  if (names.colors.empty()) return;
  mesh.colors.clear();
  for (const glm::vec3& p : mesh.positions) {
    const auto found = names.colors.find({p.x, p.y, p.z});
    const glm::vec3 color = found == names.colors.end() ? glm::vec3(1.0f) : found->second;
    mesh.colors.emplace_back(linearOf(color.r), linearOf(color.g), linearOf(color.b), 1.0f);
  }
}

}  // namespace

Model readObj(const std::string& path, const LoadProgress& progress) {
  const ObjNames names = checkObj(path);
  const ObjMaterials materials = readObjMaterials(names.materialFile, path, names.materials);
  if (progress && !progress(0.2)) throw LoadCancelled(path + ": loading was cancelled");
  const VtkErrorCatcher errors;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkOBJImporter> importer;
  const TemporaryText respelled(names.text);
  importer->SetFileName(names.text.empty() ? path.c_str() : respelled.path().c_str());
  // Without a file name VTK would read an unchecked .mtl file beside the model.
  const TemporaryText text(materials.text.empty() ? "newmtl _\nKd 0.8 0.8 0.8\n" : materials.text);
  importer->SetFileNameMTL(text.path().c_str());
  importer->SetRenderWindow(window);
  importer->Update();
  if (!errors.error().empty()) throw InputError(path + ": " + errors.error() + "; save it again");
  Model model;
  model.warnings = names.warnings;
  model.warnings.insert(model.warnings.end(), materials.warnings.begin(), materials.warnings.end());
  ObjPictures pictures(materials, model.warnings);
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  int output = 0;
  for (vtkActor* actor = actors->GetNextActor(); actor != nullptr; actor = actors->GetNextActor(), ++output) {
    auto* data = vtkPolyData::SafeDownCast(actor->GetMapper()->GetInputDataObject(0, 0));
    if (data == nullptr) continue;
    Mesh mesh = meshFromPolyData(data, path);
    if (mesh.indices.empty()) continue;
    mesh.name = materialName(importer, output);
    mesh.material = static_cast<int>(model.materials.size());
    giveColors(names, mesh);
    Material material = materialOf(actor, mesh.name, shininess(importer, output));
    pictures.give(material);
    model.materials.push_back(std::move(material));
    model.instances.push_back({mesh.name, static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
    model.meshes.push_back(std::move(mesh));
    if (progress && !progress(0.9)) throw LoadCancelled(path + ": loading was cancelled");
  }
  if (model.instances.empty()) throw InputError(path + ": has no triangles to show");
  return model;
}

}  // namespace boxprobe
