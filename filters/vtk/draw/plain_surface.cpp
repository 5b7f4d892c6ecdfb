#include "filters/vtk/draw/plain_surface.h"

#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>
#include <vtkTexture.h>

#include <cstring>

#include "filters/vtk/gl/software_driver.h"

namespace boxprobe {

namespace {

vtkSmartPointer<vtkTexture> plainTexture(const SurfaceTexture& given) {
  const ImageRgba8& image = given.image();
  vtkNew<vtkImageData> data;
  data->SetDimensions(image.width, image.height, 1);
  data->AllocateScalars(VTK_UNSIGNED_CHAR, 4);
  std::memcpy(data->GetScalarPointer(), image.pixels.data(), image.pixels.size());
  auto texture = vtkSmartPointer<vtkTexture>::New();
  texture->SetInputData(data);
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->SetMaximumAnisotropicFiltering(textureAnisotropy());
  texture->SetUseSRGBColorSpace(given.srgb());
  texture->SetColorModeToDirectScalars();
  texture->SetWrap(given.wrap() == Wrap::ClampToEdge      ? vtkTexture::ClampToEdge
                   : given.wrap() == Wrap::MirroredRepeat ? vtkTexture::MirroredRepeat
                                                          : vtkTexture::Repeat);
  return texture;
}

}  // namespace

void applyPlainSurface(const SurfaceMaterial& surface, vtkProperty* property, vtkPolyData* data) {
  const auto texture = [&](SurfaceSlotIndex slot) { return surface.slots[slot].texture.get(); };
  vtkPointData* points = data->GetPointData();
  if (vtkDataArray* uv = points->GetArray("bpUv0")) points->SetTCoords(uv);
  if (vtkDataArray* tangents = points->GetArray("bpTangent")) points->SetTangents(tangents);
  if (const auto* t = texture(kBaseColorSlot)) {
    // The property of an unlit surface only shows emission.
    surface.unlit ? property->SetEmissiveTexture(plainTexture(*t)) : property->SetBaseColorTexture(plainTexture(*t));
  }
  if (const auto* t = texture(kEmissiveSlot)) property->SetEmissiveTexture(plainTexture(*t));
  if (const auto* t = texture(kNormalSlot); t != nullptr && points->GetTangents() != nullptr) {
    property->SetNormalTexture(plainTexture(*t));
  }
  // VTK reads occlusion, roughness and metallic from one picture.
  if (const auto* t = texture(kRoughMetalSlot)) {
    property->SetORMTexture(plainTexture(*t));
    if (texture(kOcclusionSlot) == nullptr) property->SetOcclusionStrength(0.0);
  }
}

}  // namespace boxprobe
