#include "filters/vtk/import/model_reader.h"

#include <vtkCallbackCommand.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkPLYReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkUnsignedCharArray.h>

#include <array>
#include <filesystem>
#include <fstream>
#include <vector>

#include "filters/core/base/errors.h"
#include "filters/core/base/file_extension.h"
#include "filters/vtk/import/obj_reader.h"
#include "filters/vtk/import/ply_guard.h"
#include "filters/vtk/import/polydata_mesh.h"
#include "filters/vtk/import/smooth_normals.h"
#include "filters/vtk/import/stl_reader.h"
#include "filters/vtk/import/vtk_error_catcher.h"
#include "filters/vtk/import/vtp_reader.h"

namespace boxprobe {

namespace {

/// Adapts a reader's progress to ours. VTK's readers can be asked to stop; their partial result is then discarded.
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

  /// Throws if the progress callback has cancelled.
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

void setTriangles(vtkPolyData* data, const std::vector<std::uint32_t>& corners) {
  vtkNew<vtkCellArray> cells;
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const vtkIdType triangle[3] = {corners[i], corners[i + 1], corners[i + 2]};
    cells->InsertNextCell(3, triangle);
  }
  data->SetPolys(cells);
}

/// Replaces the colours that VTK has cast to bytes.
void setColors(vtkPolyData* data, const std::vector<std::array<std::uint8_t, 4>>& colors) {
  vtkPointData* points = data->GetPointData();
  for (const char* name : {"RGB", "RGBA", "diffuse_red"}) points->RemoveArray(name);
  if (static_cast<std::size_t>(data->GetNumberOfPoints()) != colors.size()) return;
  vtkNew<vtkUnsignedCharArray> array;
  array->SetName("RGBA");
  array->SetNumberOfComponents(4);
  for (const auto& color : colors) array->InsertNextTypedTuple(color.data());
  points->AddArray(array);
}

Model modelOf(Mesh mesh, const std::string& path) {
  if (mesh.indices.empty()) throw InputError(path + ": has no triangles to show");
  Model model;
  mesh.name = std::filesystem::path(path).stem().string();
  mesh.material = 0;
  model.materials.push_back(plainMaterial());
  model.instances.push_back({mesh.name, 0, glm::dmat4(1.0)});
  model.meshes.push_back(std::move(mesh));
  return model;
}

Model readPly(const std::string& path, const LoadProgress& progress) {
  vtkNew<vtkPLYReader> reader;
  reader->SetFileName(path.c_str());
  const PlyCheck check = checkPly(path);
  if (check.text) {
    reader->ReadFromInputStringOn();
    reader->SetInputString(*check.text);
  }
  const VtkErrorCatcher errors;
  const ReaderProgress reported(reader, path, progress);
  reader->Update();
  reported.check();
  if (!errors.error().empty()) throw InputError(path + ": " + errors.error() + "; save it again");
  vtkPolyData* data = reader->GetOutput();
  if (!check.triangles.empty()) setTriangles(data, check.triangles);
  if (!check.colors.empty()) setColors(data, check.colors);
  return modelOf(meshFromPolyData(data, path), path);
}

Model readStl(const std::string& path, const LoadProgress& progress) {
  Mesh mesh = readStlMesh(path, progress);
  checkPositions(mesh.positions, path);
  computeNormals(mesh);
  return modelOf(std::move(mesh), path);
}

/// Git LFS leaves pointers, three lines of text, in place of large files until they are fetched.
void refusePointer(const std::string& path) {
  constexpr char kFirstLine[] = "version https://git-lfs";
  char start[sizeof(kFirstLine)] = {};
  std::ifstream(path, std::ios::binary).read(start, sizeof(kFirstLine) - 1);
  if (std::string(start) != kFirstLine) return;
  throw InputError(path + ": is a pointer of Git LFS, not the model; fetch it: git lfs pull");
}

}  // namespace

Material plainMaterial() {
  Material material;
  material.name = "default";
  material.baseColor = {0.8f, 0.8f, 0.8f, 1.0f};
  material.metallic = 0.0f;
  material.roughness = 0.5f;
  material.doubleSided = true;
  return material;
}

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

Model readModel(const std::string& path, const LoadProgress& progress, const ModelState& state) {
  refusePointer(path);
  const std::string extension = lowerExtension(path);
  if (!state.variant.empty() && extension != ".glb" && extension != ".gltf") {
    throw InputError(path + ": has no variant \"" + state.variant + "\"; only glTF files have variants");
  }
  if (extension == ".obj") return readObj(path, progress);
  if (extension == ".ply") return readPly(path, progress);
  if (extension == ".stl") return readStl(path, progress);
  if (extension == ".vtp") return modelOf(readVtpMesh(path, progress), path);
  return loadModelFile(path, progress, state);
}

}  // namespace boxprobe
