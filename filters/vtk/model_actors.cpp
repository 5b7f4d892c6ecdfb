#include "filters/vtk/model_actors.h"

#include <vtkCellArray.h>
#include <vtkFloatArray.h>
#include <vtkImageData.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLTexture.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTypeInt64Array.h>
#include <vtkUnsignedCharArray.h>

#include <cstring>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/matrix.hpp>
#include <map>
#include <tuple>

#include "filters/core/probe_geometry.h"

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
  // VTK's row 0 is the bottom of a picture and glTF's is the top; uploading rows in glTF's order makes v agree as it
  // is.
  if (!mesh.uv.empty()) data->GetPointData()->SetTCoords(floatArray(mesh.uv, 2, "TCoords"));
  if (!mesh.tangents.empty()) data->GetPointData()->SetTangents(floatArray(mesh.tangents, 3, "Tangents"));

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

// VTK's combined map holds occlusion in R beside roughness (G) and metallic (B); glTF may keep occlusion in another
// image.
std::shared_ptr<const ImageRgba8> combineOcclusion(const ImageRgba8* roughMetal, const ImageRgba8* occlusion) {
  auto result = std::make_shared<ImageRgba8>();
  const ImageRgba8& size = roughMetal != nullptr ? *roughMetal : *occlusion;
  result->width = size.width;
  result->height = size.height;
  result->name = size.name;
  result->pixels.resize(static_cast<std::size_t>(size.width) * static_cast<std::size_t>(size.height) * 4, 255);
  for (int y = 0; y < size.height; ++y) {
    for (int x = 0; x < size.width; ++x) {
      const auto at = [&](const ImageRgba8& image, int channel) {
        const auto column =
            static_cast<std::size_t>(x) * static_cast<std::size_t>(image.width) / static_cast<std::size_t>(size.width);
        const auto row = static_cast<std::size_t>(y) * static_cast<std::size_t>(image.height) /
                         static_cast<std::size_t>(size.height);
        return image
            .pixels[(row * static_cast<std::size_t>(image.width) + column) * 4 + static_cast<std::size_t>(channel)];
      };
      std::uint8_t* texel = &result->pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(size.width) +
                                             static_cast<std::size_t>(x)) *
                                            4];
      if (occlusion != nullptr) texel[0] = at(*occlusion, 0);
      if (roughMetal != nullptr) {
        texel[1] = at(*roughMetal, 1);
        texel[2] = at(*roughMetal, 2);
      }
    }
  }
  return result;
}

// Smallest and largest roughness of a metallic-roughness texture, whose green channel it is.
std::pair<double, double> roughnessRange(const ImageRgba8& image) {
  std::uint8_t low = 255, high = 0;
  for (std::size_t i = 1; i < image.pixels.size(); i += 4) {
    low = std::min(low, image.pixels[i]);
    high = std::max(high, image.pixels[i]);
  }
  return {low / 255.0, std::max(low, high) / 255.0};
}

class TextureCache {
 public:
  vtkSmartPointer<vtkTexture> get(const TextureUse& use, bool srgb) {
    const auto key = std::make_tuple(use.image.get(), srgb, use.wrapS, use.wrapT);
    auto& texture = textures_[key];
    if (texture == nullptr) texture = make(use, srgb);
    return texture;
  }

 private:
  static vtkSmartPointer<vtkTexture> make(const TextureUse& use, bool srgb) {
    vtkNew<vtkImageData> data;
    data->SetDimensions(use.image->width, use.image->height, 1);
    data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
    std::memcpy(data->GetScalarPointer(), use.image->pixels.data(), use.image->pixels.size());
    auto texture = vtkSmartPointer<vtkTexture>::New();
    texture->SetInputData(data);
    texture->InterpolateOn();
    texture->MipmapOn();
    texture->SetMaximumAnisotropicFiltering(8.0f);
    texture->SetUseSRGBColorSpace(srgb);
    texture->SetColorModeToDirectScalars();
    // VTK 9.1 has one wrap mode for both axes.
    texture->SetWrap(use.wrapS == Wrap::ClampToEdge      ? vtkTexture::ClampToEdge
                     : use.wrapS == Wrap::MirroredRepeat ? vtkTexture::MirroredRepeat
                                                         : vtkTexture::Repeat);
    return texture;
  }

  std::map<std::tuple<const ImageRgba8*, bool, Wrap, Wrap>, vtkSmartPointer<vtkTexture>> textures_;
};

void setTextures(vtkProperty* property, const Material& material, bool hasTangents, TextureCache& cache) {
  if (material.unlit) {
    // Emission alone is shown; the colour texture takes its place, and brings its alpha as base colour.
    if (material.baseColorTexture.image) property->SetEmissiveTexture(cache.get(material.baseColorTexture, true));
    return;
  }
  if (material.baseColorTexture.image) property->SetBaseColorTexture(cache.get(material.baseColorTexture, true));
  if (material.emissiveTexture.image) property->SetEmissiveTexture(cache.get(material.emissiveTexture, true));
  if (material.normalTexture.image && hasTangents) property->SetNormalTexture(cache.get(material.normalTexture, false));
  const auto& roughMetal = material.metallicRoughnessTexture.image;
  const auto& occlusion = material.occlusionTexture.image;
  if (roughMetal || occlusion) {
    TextureUse combined = roughMetal ? material.metallicRoughnessTexture : material.occlusionTexture;
    if (occlusion != roughMetal) combined.image = combineOcclusion(roughMetal.get(), occlusion.get());
    property->SetORMTexture(cache.get(combined, false));
  }
}

}  // namespace

glm::dmat4 placementMatrix(const ModelFile& file) {
  return glm::translate(glm::dmat4(1.0), file.translation) * glm::dmat4(rotationMatrix(file.rotationDegrees)) *
         glm::scale(glm::dmat4(1.0), glm::dvec3(file.scale));
}

std::vector<DrawnObject> makeObjects(const Model& model, const ModelFile& placement,
                                     const std::shared_ptr<DrawState>& state) {
  std::vector<vtkSmartPointer<vtkPolyData>> data;
  data.reserve(model.meshes.size());
  for (const Mesh& mesh : model.meshes) data.push_back(makePolyData(mesh));
  TextureCache textures;
  std::map<const ImageRgba8*, std::pair<double, double>> roughnessOf;  // a texture may serve many objects

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
    object.mapper = vtkSmartPointer<vtkProbePolyDataMapper>::New();
    object.mapper->SetInputData(data[static_cast<std::size_t>(instance.mesh)]);
    object.mapper->ScalarVisibilityOff();
    object.mapper->SetDrawState(state);
    object.actor = vtkSmartPointer<vtkActor>::New();
    object.actor->SetMapper(object.mapper);
    placeObject(object, instance, placement);

    vtkProperty* property = object.actor->GetProperty();
    property->SetInterpolationToPBR();
    setTextures(property, object.material, !mesh.tangents.empty(), textures);
    // Meshes under a mirroring transform come wound the other way already, so front faces are always the same.
    property->SetBackfaceCulling(!object.material.doubleSided);
    objects.push_back(std::move(object));
  }
  return objects;
}

void placeObject(DrawnObject& object, const Instance& instance, const ModelFile& placement) {
  object.worldFromModel = placementMatrix(placement) * instance.worldFromModel;
  vtkNew<vtkMatrix4x4> matrix;
  for (int row = 0; row < 4; ++row) {
    for (int column = 0; column < 4; ++column) matrix->SetElement(row, column, object.worldFromModel[column][row]);
  }
  object.actor->SetUserMatrix(matrix);
}

void applyOverrides(DrawnObject& object, const Scene& scene) {
  Material material = object.material;
  if (const auto it = scene.materials.find(object.materialName); it != scene.materials.end()) {
    const MaterialOverride& o = it->second;
    if (o.baseColor) material.baseColor = glm::vec4(*o.baseColor, material.baseColor.a);
    if (o.metallic) material.metallic = *o.metallic;
    if (o.roughness) material.roughness = *o.roughness;
    if (o.emissive) material.emissive = *o.emissive;
    if (o.normalScale) material.normalScale = *o.normalScale;
    if (o.coat) material.coat = *o.coat;
    if (o.ior) material.ior = *o.ior;
  }
  const auto it = scene.objects.find(object.node);
  object.settings = it != scene.objects.end() ? it->second : ObjectOverride{};

  object.allMetal = material.metallic == 1.0f && !material.metallicRoughnessTexture.image;

  vtkProperty* property = object.actor->GetProperty();
  const glm::dvec3 base(material.baseColor);
  property->SetOpacity(material.baseColor.a);
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
  property->SetRoughness(material.roughness);
  property->SetNormalScale(material.normalScale);
  property->SetOcclusionStrength(material.occlusionTexture.image ? material.occlusionStrength : 0.0);
  property->SetBaseIOR(material.ior);
  property->SetCoatStrength(material.coat);
  property->SetCoatRoughness(material.coatRoughness);
  object.actor->SetVisibility(object.settings.visible ? 1 : 0);
}

Box worldBounds(const DrawnObject& object) {
  const double* b = object.actor->GetBounds();
  if (b == nullptr) return Box{glm::dvec3(0.0), glm::dvec3(0.0)};
  return Box{{b[0], b[2], b[4]}, {b[1], b[3], b[5]}};
}

}  // namespace boxprobe
