#include "filters/vtk/scene/model_actors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTypeInt64Array.h>

#include <algorithm>
#include <glm/matrix.hpp>
#include <map>
#include <tuple>

#include "filters/core/geometry/model_placement.h"
#include "filters/core/scene/coat.h"
#include "filters/core/scene/material_override.h"

namespace boxprobe {

namespace {

template <typename Vector>
vtkSmartPointer<vtkFloatArray> floatArray(const std::vector<Vector>& values, int components, const char* name) {
  auto array = vtkSmartPointer<vtkFloatArray>::New();
  array->SetName(name);
  array->SetNumberOfComponents(components);
  array->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  for (std::size_t i = 0; i < values.size(); ++i) array->SetTypedTuple(static_cast<vtkIdType>(i), &values[i].x);
  return array;
}

vtkSmartPointer<vtkPolyData> makePolyData(const Mesh& mesh) {
  auto data = vtkSmartPointer<vtkPolyData>::New();
  vtkNew<vtkPoints> points;
  points->SetData(floatArray(mesh.positions, 3, "Points"));
  data->SetPoints(points);
  if (!mesh.normals.empty()) data->GetPointData()->SetNormals(floatArray(mesh.normals, 3, "Normals"));
  const auto add = [&](const auto& values, int components, const char* name) {
    if (!values.empty()) data->GetPointData()->AddArray(floatArray(values, components, name));
  };
  add(mesh.uv, 2, "bpUv0");
  add(mesh.uv1, 2, "bpUv1");
  add(mesh.colors, 4, "bpColor");
  add(mesh.tangents, 4, "bpTangent");

  const auto triangles = static_cast<vtkIdType>(mesh.indices.size() / 3);
  vtkNew<vtkTypeInt64Array> offsets, connectivity;
  offsets->SetNumberOfValues(triangles + 1);
  for (vtkIdType i = 0; i <= triangles; ++i) offsets->SetValue(i, 3 * i);
  connectivity->SetNumberOfValues(3 * triangles);
  for (vtkIdType i = 0; i < 3 * triangles; ++i) connectivity->SetValue(i, mesh.indices[static_cast<std::size_t>(i)]);
  vtkNew<vtkCellArray> polys;
  polys->SetData(offsets, connectivity);
  data->SetPolys(polys);
  return data;
}

// The range of roughness in a metallic-roughness texture, which has it in its green channel.
std::pair<double, double> roughnessRange(const ImageRgba8& image) {
  std::uint8_t low = 255, high = 0;
  for (std::size_t i = 1; i < image.pixels.size(); i += 4) {
    low = std::min(low, image.pixels[i]);
    high = std::max(high, image.pixels[i]);
  }
  return {low / 255.0, std::max(low, high) / 255.0};
}

/// Textures of one model: an image used twice in the same way is uploaded once.
class TextureCache {
 public:
  std::shared_ptr<const SurfaceTexture> get(const TextureUse& use, bool srgb) {
    auto& texture = textures_[std::make_tuple(use.image.get(), srgb, use.wrapS, use.wrapT, use.nearest)];
    if (texture == nullptr) texture = std::make_shared<const SurfaceTexture>(use, srgb, mips_);
    return texture;
  }

 private:
  std::map<std::tuple<const ImageRgba8*, bool, Wrap, Wrap, bool>, std::shared_ptr<const SurfaceTexture>> textures_;
  std::shared_ptr<MipLevels> mips_ = std::make_shared<MipLevels>();
};

/// `fill` sets a slot's texture.
template <typename Fill>
void fillFinish(SurfaceMaterial& surface, const MaterialFinish& finish, const Fill& fill) {
  surface.finish = finish;
  if (finish.tintsSpecular()) {
    fill(kSpecularSlot, finish.specularTexture, false);
    fill(kSpecularColorSlot, finish.specularColorTexture, true);
  }
  if (finish.hasSheen()) {
    fill(kSheenColorSlot, finish.sheenColorTexture, true);
    fill(kSheenRoughnessSlot, finish.sheenRoughnessTexture, false);
  }
  if (finish.isAnisotropic()) fill(kAnisotropySlot, finish.anisotropyTexture, false);
  if (finish.hasFilm()) {
    fill(kIridescenceSlot, finish.iridescenceTexture, false);
    fill(kFilmThicknessSlot, finish.filmThicknessTexture, false);
  }
}

std::shared_ptr<SurfaceMaterial> makeSurface(const Material& material, const Mesh& mesh, TextureCache& cache) {
  auto surface = std::make_shared<SurfaceMaterial>();
  surface->unlit = material.unlit;
  surface->alphaMode = material.alphaMode;
  surface->alphaCutoff = material.alphaCutoff;
  surface->coatNormalScale = material.coatNormalScale;
  surface->colors = !mesh.colors.empty();
  const auto fill = [&](SurfaceSlotIndex index, const TextureUse& use, bool srgb) {
    // A texture without coordinates would have one colour everywhere, which the specification leaves open: it is
    // ignored.
    const bool second = use.uvSet == 1;
    if (!use.image || (second ? mesh.uv1 : mesh.uv).empty()) return;
    surface->slots[index] = {cache.get(use, srgb), use.uvSet, use.uvTransform};
    surface->uv[second ? 1 : 0] = true;
  };
  fill(kBaseColorSlot, material.baseColorTexture, true);
  if (material.unlit) return surface;
  fill(kRoughMetalSlot, material.metallicRoughnessTexture, false);
  fill(kOcclusionSlot, material.occlusionTexture, false);
  fill(kEmissiveSlot, material.emissiveTexture, true);
  fill(kCoatSlot, material.coatTexture, false);
  fill(kCoatRoughnessSlot, material.coatRoughnessTexture, false);
  if (material.transmits()) {
    fill(kTransmissionSlot, material.transmissionTexture, false);
    fill(kThicknessSlot, material.thicknessTexture, false);
    surface->thicknessScale = 1.0f / std::max(material.thicknessMean, 1.0e-6f);
  }
  fillFinish(*surface, material.finish, fill);
  if (mesh.tangents.empty()) return surface;
  fill(kNormalSlot, material.normalTexture, false);
  fill(kCoatNormalSlot, material.coatNormalTexture, false);
  surface->tangents =
      surface->slots[kNormalSlot].texture || surface->slots[kCoatNormalSlot].texture || surface->finish.isAnisotropic();
  return surface;
}

void setWorldFromModel(DrawnObject& object, const glm::dmat4& worldFromModel) {
  if (object.actor->GetUserMatrix() != nullptr && object.worldFromModel == worldFromModel) return;
  object.worldFromModel = worldFromModel;
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, object.worldFromModel[column][row]);
  }
  object.actor->SetUserMatrix(matrix);
}

}  // namespace

std::vector<DrawnObject> makeObjects(const Model& model, const ModelFile& placement,
                                     const std::shared_ptr<DrawState>& state) {
  std::vector<vtkSmartPointer<vtkPolyData>> data;
  data.reserve(model.meshes.size());
  for (const Mesh& mesh : model.meshes) data.push_back(makePolyData(mesh));
  TextureCache textures;
  std::map<const ImageRgba8*, std::pair<double, double>> roughnessOf;  // several objects may share a texture

  std::vector<DrawnObject> objects;
  for (const Instance& instance : model.instances) {
    const Mesh& mesh = model.meshes[static_cast<std::size_t>(instance.mesh)];
    DrawnObject object;
    object.node = instance.node;
    if (mesh.material >= 0) object.material = model.materials[static_cast<std::size_t>(mesh.material)];
    object.materialName = object.material.name;
    if (const auto* image = object.material.metallicRoughnessTexture.image.get()) {
      const auto known = roughnessOf.find(image);
      const auto range = known != roughnessOf.end() ? known->second : roughnessRange(*image);
      roughnessOf[image] = range;
      object.textureRoughnessMin = range.first;
      object.textureRoughnessMax = range.second;
    }
    object.unlit = object.material.unlit;
    object.surface = makeSurface(object.material, mesh, textures);
    object.mesh = &mesh;
    const auto actor = vtkSmartPointer<vtkProbeActor>::New();
    actor->SetShape(data[static_cast<std::size_t>(instance.mesh)], object.surface);
    actor->GetPass()->SetDrawState(state);
    object.actor = actor;
    object.pass = actor->GetPass();
    placeObject(object, instance, placement);

    vtkProperty* property = object.actor->GetProperty();
    property->SetInterpolationToPBR();
    object.actor->SetForceOpaque(object.material.alphaMode != AlphaMode::Blend);
    object.actor->SetForceTranslucent(object.material.alphaMode == AlphaMode::Blend);
    // Meshes under a mirroring transform are already wound the other way, so front faces are consistent.
    property->SetBackfaceCulling(!object.material.doubleSided);
    objects.push_back(std::move(object));
  }
  return objects;
}

vtkSmartPointer<vtkProbeActor> makeTwin(const DrawnObject& object, std::shared_ptr<DrawState> state) {
  auto twin = vtkSmartPointer<vtkProbeActor>::New();
  twin->SetShape(vtkPolyData::SafeDownCast(object.actor->GetMapper()->GetInputDataObject(0, 0)), object.surface);
  twin->GetPass()->SetDrawState(std::move(state));
  twin->SetProperty(object.actor->GetProperty());
  twin->SetForceOpaque(object.actor->GetForceOpaque());
  twin->SetForceTranslucent(object.actor->GetForceTranslucent());
  return twin;
}

void placeObject(DrawnObject& object, const Instance& instance, const ModelFile& placement) {
  object.placed = worldFromFile(placement) * instance.worldFromModel;
  setWorldFromModel(object, object.placed);
}

void applyOverrides(DrawnObject& object, const Scene& scene) {
  const Material material = overriddenMaterial(object.material, scene);
  const auto it = scene.objects.find(object.node);
  object.settings = it != scene.objects.end() ? it->second : ObjectOverride{};
  setWorldFromModel(object, movedInstance(object.placed, object.settings));

  // Sheen scatters light from the whole hemisphere, whatever is below it.
  object.allMetal =
      material.metallic == 1.0f && !material.metallicRoughnessTexture.image && !material.finish.hasSheen();

  vtkProperty* property = object.actor->GetProperty();
  const glm::dvec3 base(material.baseColor);
  object.surface->alpha = material.baseColor.a;
  object.surface->normalScale = material.normalScale;
  if (material.unlit) {
    property->SetColor(0.0, 0.0, 0.0);
    property->SetMetallic(0.0);
    property->SetEmissiveFactor(base.x, base.y, base.z);
  } else {
    property->SetColor(base.x, base.y, base.z);
    property->SetMetallic(material.metallic);
    property->SetEmissiveFactor(material.emissive.x, material.emissive.y, material.emissive.z);
  }
  object.roughnessMin = material.roughness * object.textureRoughnessMin;
  object.roughnessMax = material.roughness * object.textureRoughnessMax;
  if (material.coat > 0.0f) {
    object.roughnessMin = std::min(object.roughnessMin, static_cast<double>(material.coatRoughness));
    object.roughnessMax = std::max(object.roughnessMax, static_cast<double>(material.coatRoughness));
  }
  object.surface->glass.apply(material, *object.mesh, object.worldFromModel);
  // Drawn after all opaque objects, in separate passes (glass_draw.h): VTK's passes for translucent surfaces would mix
  // faces.
  const bool blended = object.material.alphaMode == AlphaMode::Blend && !object.surface->glass.drawn;
  object.actor->SetForceOpaque(!blended);
  object.actor->SetForceTranslucent(blended);
  property->SetRoughness(material.roughness);
  property->SetOcclusionStrength(material.occlusionTexture.image ? material.occlusionStrength : 0.0);
  property->SetBaseIOR(material.reflectedIor());
  property->SetCoatStrength(material.coat);
  property->SetCoatRoughness(material.coatRoughness);
  property->SetCoatIOR(kCoatIor);
  object.actor->SetVisibility(object.settings.visible ? 1 : 0);
}

Box worldBounds(const DrawnObject& object) {
  if (object.placedBounds) return *object.placedBounds;
  const double* b = object.actor->GetBounds();
  if (b == nullptr) return Box{glm::dvec3(0.0), glm::dvec3(0.0)};
  return Box{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

}  // namespace boxprobe
