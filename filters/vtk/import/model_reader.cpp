#include "filters/vtk/import/model_reader.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCallbackCommand.h>
#include <vtkImageData.h>
#include <vtkMapper.h>
#include <vtkNew.h>
#include <vtkOBJImporter.h>
#include <vtkPLYReader.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>
#include <vtkSTLReader.h>
#include <vtkTexture.h>
#include <vtkXMLPolyDataReader.h>

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <optional>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/vtk/import/file_guards.h"
#include "filters/vtk/import/ply_guard.h"
#include "filters/vtk/import/polydata_mesh.h"
#include "filters/vtk/import/vtk_error_catcher.h"

namespace boxprobe {

namespace {

/// For files that say nothing of it: light grey plastic, seen from both sides, because winding is not reliable there.
Material plainMaterial() {
  Material material;
  material.name = "default";
  material.baseColor = {0.8f, 0.8f, 0.8f, 1.0f};
  material.metallic = 0.0f;
  material.roughness = 0.5f;
  material.doubleSided = true;
  return material;
}

/// A reader's progress as this program's. VTK's readers can be asked to stop; what they have read is then thrown away.
class ReaderProgress {
 public:
  ReaderProgress(vtkAlgorithm* reader, const std::string& path, const LoadProgress& progress)
      : reader_(reader), path_(path), progress_(progress) {
    command_->SetClientData(this);
    command_->SetCallback([](vtkObject*, unsigned long, void* client, void*) {
      auto* self = static_cast<ReaderProgress*>(client);
      if (!self->progress_ || self->progress_(0.8 * self->reader_->GetProgress())) return;
      self->stopped_ = true;
      self->reader_->AbortExecuteOn();
    });
    reader_->AddObserver(vtkCommand::ProgressEvent, command_);
  }
  ~ReaderProgress() { reader_->RemoveObserver(command_); }
  ReaderProgress(const ReaderProgress&) = delete;
  ReaderProgress& operator=(const ReaderProgress&) = delete;

  /// Throws if the progress said so, then or now.
  void check() const {
    if (stopped_ || (progress_ && !progress_(0.8))) throw LoadCancelled(path_ + ": loading was cancelled");
  }

 private:
  vtkAlgorithm* reader_;
  std::string path_;
  const LoadProgress& progress_;
  vtkNew<vtkCallbackCommand> command_;
  bool stopped_ = false;
};

template <typename Reader>
Model readOneMesh(Reader* reader, const std::string& path, const LoadProgress& progress) {
  const VtkErrorCatcher errors;
  const ReaderProgress reported(reader, path, progress);
  reader->Update();
  reported.check();
  if (!errors.error().empty()) throw InputError(path + ": " + errors.error() + "; save it again");
  Model model;
  Mesh mesh = meshFromPolyData(reader->GetOutput(), path);
  if (mesh.indices.empty()) throw InputError(path + ": has no triangles to show");
  mesh.name = std::filesystem::path(path).stem().string();
  mesh.material = 0;
  model.materials.push_back(plainMaterial());
  model.instances.push_back({mesh.name, 0, glm::dmat4(1.0)});
  model.meshes.push_back(std::move(mesh));
  return model;
}

template <typename Reader>
Model readOneMesh(const std::string& path, const LoadProgress& progress) {
  vtkNew<Reader> reader;
  reader->SetFileName(path.c_str());
  return readOneMesh(reader.Get(), path, progress);
}

Model readPly(const std::string& path, const LoadProgress& progress) {
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  if (const std::optional<std::string> text = checkPly(path)) {
    reader->ReadFromInputStringOn();
    reader->SetInputString(*text);
  }
  return readOneMesh(reader.Get(), path, progress);
}

/// MTL's own number, which VTK scales for its older shading: "... specular power 30 ..."
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

/// MTL's colours are taken for linear. Its shininess n becomes the roughness of the microfacet lobe that is as wide as
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
  if (vtkTexture* texture = actor->GetTexture()) {
    texture->Update();
    material.baseColorTexture.image = imageFromVtk(texture->GetInput(), name);
  }
  return material;
}

Model readObj(const std::string& path, const LoadProgress& progress) {
  const ObjNames names = checkObj(path);
  if (progress && !progress(0.2)) throw LoadCancelled(path + ": loading was cancelled");
  const VtkErrorCatcher errors;
  vtkNew<vtkRenderWindow> window;
  vtkNew<vtkRenderer> renderer;
  window->AddRenderer(renderer);
  vtkNew<vtkOBJImporter> importer;
  importer->SetFileName(path.c_str());
  if (!names.materialFile.empty()) {
    importer->SetFileNameMTL(names.materialFile.c_str());
    const std::string folder = std::filesystem::path(names.materialFile).parent_path().string();
    importer->SetTexturePath(folder.empty() ? "." : folder.c_str());
  }
  importer->SetRenderWindow(window);
  importer->Read();
  if (!errors.error().empty()) throw InputError(path + ": " + errors.error() + "; save it again");
  Model model;
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
    model.materials.push_back(materialOf(actor, mesh.name, shininess(importer, output)));
    model.instances.push_back({mesh.name, static_cast<int>(model.meshes.size()), glm::dmat4(1.0)});
    model.meshes.push_back(std::move(mesh));
    if (progress && !progress(0.9)) throw LoadCancelled(path + ": loading was cancelled");
  }
  if (model.instances.empty()) throw InputError(path + ": has no triangles to show");
  return model;
}

}  // namespace

bool isModelFile(const std::string& path) {
  const std::string extension = lowerExtension(path);
  for (const char* known : {".glb", ".gltf", ".obj", ".ply", ".stl", ".vtp"}) {
    if (extension == known) return true;
  }
  return false;
}

const std::string& modelFilePatterns() {
  static const std::string patterns = "*.glb *.gltf *.obj *.ply *.stl *.vtp";
  return patterns;
}

Model readModel(const std::string& path, const LoadProgress& progress) {
  const std::string extension = lowerExtension(path);
  if (extension == ".obj") return readObj(path, progress);
  if (extension == ".ply") return readPly(path, progress);
  if (extension == ".stl") {
    checkStl(path);
    return readOneMesh<vtkSTLReader>(path, progress);
  }
  if (extension == ".vtp") {
    checkVtp(path);
    return readOneMesh<vtkXMLPolyDataReader>(path, progress);
  }
  return loadModelFile(path, progress);
}

}  // namespace boxprobe
