// What a model becomes in VTK: points, cells and arrays number by number, each texture in its slot, properties after
// overrides, matrices. No window.
#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkDataArray.h>
#include <vtkIdList.h>
#include <vtkMapper.h>
#include <vtkMatrix4x4.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkProperty.h>

#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "filters/vtk/draw/draw_state.h"
#include "filters/vtk/scene/model_actors.h"

namespace boxprobe {
namespace {

/// Two triangles with every array, each number another one.
Mesh wholeMesh() {
  Mesh mesh;
  mesh.name = "whole";
  for (int i = 0; i < 4; ++i) {
    const auto f = static_cast<float>(i);
    mesh.positions.emplace_back(0.1f + f, 0.2f + 2.0f * f * f, 0.3f - 1.5f * f);
    mesh.normals.emplace_back(0.01f * f, 0.6f, 0.8f - 0.02f * f);
    mesh.uv.emplace_back(0.11f + 0.1f * f, 0.93f - 0.2f * f);
    mesh.uv1.emplace_back(0.37f + 0.03f * f, 0.41f + 0.05f * f);
    mesh.colors.emplace_back(0.2f + 0.1f * f, 0.9f - 0.1f * f, 0.5f, 0.7f + 0.05f * f);
    mesh.tangents.emplace_back(0.9f - 0.1f * f, 0.1f * f, 0.3f, i % 2 == 0 ? 1.0f : -1.0f);
  }
  mesh.indices = {0, 1, 2, 2, 1, 3};
  mesh.material = 0;
  return mesh;
}

/// `green` of its texels.
TextureUse texture(const std::vector<std::uint8_t>& green, int uvSet) {
  auto image = std::make_shared<ImageRgba8>();
  image->width = static_cast<int>(green.size());
  image->height = 1;
  for (const std::uint8_t g : green) image->pixels.insert(image->pixels.end(), {11, g, 200, 255});
  TextureUse use;
  use.image = image;
  use.uvSet = uvSet;
  return use;
}

ModelFile placedFile() {
  ModelFile file;
  file.file = "made.glb";
  return file;
}

std::vector<DrawnObject> made(const Model& model) {
  return makeObjects(model, placedFile(), std::make_shared<DrawState>());
}

vtkPolyData* dataOf(const DrawnObject& object) {
  return vtkPolyData::SafeDownCast(object.actor->GetMapper()->GetInputDataObject(0, 0));
}

template <typename Vector>
void expectTuples(vtkDataArray* array, const std::vector<Vector>& values, int components, const std::string& what) {
  ASSERT_NE(array, nullptr) << what;
  ASSERT_EQ(array->GetNumberOfComponents(), components) << what;
  ASSERT_EQ(array->GetNumberOfTuples(), static_cast<vtkIdType>(values.size())) << what;
  for (std::size_t i = 0; i < values.size(); ++i) {
    for (int c = 0; c < components; ++c) {
      EXPECT_EQ(array->GetComponent(static_cast<vtkIdType>(i), c), static_cast<double>(values[i][c])) << what << i;
    }
  }
}

TEST(DrawnObjects, HaveTheMeshesNumbers) {
  Model model;
  model.meshes = {wholeMesh(), wholeMesh()};
  Mesh& bare = model.meshes[1];
  bare.normals.clear();
  bare.uv.clear();
  bare.uv1.clear();
  bare.colors.clear();
  bare.tangents.clear();
  bare.material = -1;
  model.materials.emplace_back().name = "stone";
  model.instances = {{"first", 0, glm::dmat4(1.0)}, {"second", 1, glm::dmat4(1.0)}, {"third", 0, glm::dmat4(1.0)}};
  const std::vector<DrawnObject> objects = made(model);
  ASSERT_EQ(objects.size(), 3u);
  const Mesh& mesh = model.meshes[0];
  vtkPolyData* whole = dataOf(objects[0]);
  expectTuples(whole->GetPoints()->GetData(), mesh.positions, 3, "points");
  expectTuples(whole->GetPointData()->GetNormals(), mesh.normals, 3, "normals");
  expectTuples(whole->GetPointData()->GetArray("bpUv0"), mesh.uv, 2, "uv");
  expectTuples(whole->GetPointData()->GetArray("bpUv1"), mesh.uv1, 2, "uv1");
  expectTuples(whole->GetPointData()->GetArray("bpColor"), mesh.colors, 4, "colours");
  expectTuples(whole->GetPointData()->GetArray("bpTangent"), mesh.tangents, 4, "tangents");
  ASSERT_EQ(whole->GetNumberOfPolys(), 2);
  for (int cell = 0; cell < 2; ++cell) {
    vtkNew<vtkIdList> ids;
    whole->GetCellPoints(cell, ids);
    ASSERT_EQ(ids->GetNumberOfIds(), 3);
    for (int k = 0; k < 3; ++k) {
      EXPECT_EQ(ids->GetId(k), mesh.indices[static_cast<std::size_t>(3 * cell + k)]);
    }
  }
  EXPECT_EQ(dataOf(objects[2]), whole) << "instances share it";
  EXPECT_EQ(dataOf(objects[1])->GetPointData()->GetNumberOfArrays(), 0);
  EXPECT_EQ(objects[0].node, "first");
  EXPECT_EQ(objects[1].node, "second");
  EXPECT_EQ(objects[0].materialName, "stone");
  EXPECT_EQ(objects[1].materialName, "");
  EXPECT_EQ(objects[0].mesh, &model.meshes[0]);
  EXPECT_TRUE(objects[0].surface->colors);
  EXPECT_FALSE(objects[1].surface->colors);
  const Box box = worldBounds(objects[0]);
  EXPECT_NEAR(box.min.x, 0.1, 1e-6);
  EXPECT_NEAR(box.max.y, 18.2, 1e-5);
  EXPECT_NEAR(box.min.z, -4.2, 1e-6);
  EXPECT_NEAR(box.max.z, 0.3, 1e-6);
}

TEST(DrawnObjects, HaveEachTextureInItsSlot) {
  Model model;
  model.meshes = {wholeMesh()};
  Material& m = model.materials.emplace_back();
  m.transmission = 0.5f;
  m.thicknessMean = 0.4f;
  m.finish.sheenColor = glm::vec3(0.1f);
  m.finish.anisotropy = 0.3f;
  m.finish.iridescence = 0.2f;
  m.finish.specularTint = glm::vec3(0.5f);
  const std::vector<std::pair<SurfaceSlotIndex, TextureUse*>> uses = {
      {kBaseColorSlot, &m.baseColorTexture},
      {kRoughMetalSlot, &m.metallicRoughnessTexture},
      {kNormalSlot, &m.normalTexture},
      {kOcclusionSlot, &m.occlusionTexture},
      {kEmissiveSlot, &m.emissiveTexture},
      {kCoatSlot, &m.coatTexture},
      {kCoatRoughnessSlot, &m.coatRoughnessTexture},
      {kCoatNormalSlot, &m.coatNormalTexture},
      {kTransmissionSlot, &m.transmissionTexture},
      {kThicknessSlot, &m.thicknessTexture},
      {kSpecularSlot, &m.finish.specularTexture},
      {kSpecularColorSlot, &m.finish.specularColorTexture},
      {kSheenColorSlot, &m.finish.sheenColorTexture},
      {kSheenRoughnessSlot, &m.finish.sheenRoughnessTexture},
      {kAnisotropySlot, &m.finish.anisotropyTexture},
      {kIridescenceSlot, &m.finish.iridescenceTexture},
      {kFilmThicknessSlot, &m.finish.filmThicknessTexture}};
  ASSERT_EQ(uses.size(), static_cast<std::size_t>(kSurfaceSlots));
  model.instances = {{"one", 0, glm::dmat4(1.0)}};
  const auto srgb = [](SurfaceSlotIndex slot) {
    return slot == kBaseColorSlot || slot == kEmissiveSlot || slot == kSpecularColorSlot || slot == kSheenColorSlot;
  };
  // One alone each time, of the first and of the second set of coordinates.
  for (const auto& [slot, use] : uses) {
    for (const int set : {0, 1}) {
      *use = texture({70, 190, 120}, set);
      use->wrapS = Wrap::MirroredRepeat;
      use->uvTransform = glm::mat3x2(1.5f, 0.1f, 0.2f, 1.7f, 0.3f, 0.4f);
      const std::vector<DrawnObject> objects = made(model);
      const SurfaceMaterial& surface = *objects[0].surface;
      for (int other = 0; other < kSurfaceSlots; ++other) {
        EXPECT_EQ(surface.slots[static_cast<std::size_t>(other)].texture != nullptr, other == slot) << slot << other;
      }
      const SurfaceSlot& held = surface.slots[slot];
      ASSERT_NE(held.texture, nullptr) << slot;
      EXPECT_EQ(held.texture->srgb(), srgb(slot)) << slot;
      EXPECT_EQ(held.texture->wrap(), Wrap::MirroredRepeat);
      EXPECT_EQ(&held.texture->image(), use->image.get());
      EXPECT_EQ(held.texture->bytes(), 0u) << "not uploaded yet";
      EXPECT_EQ(held.uvSet, set);
      EXPECT_EQ(held.uvTransform, use->uvTransform);
      EXPECT_EQ(surface.uv[0], set == 0);
      EXPECT_EQ(surface.uv[1], set == 1);
      EXPECT_TRUE(surface.tangents) << "it is brushed";
      EXPECT_FLOAT_EQ(surface.thicknessScale, 2.5f);
      EXPECT_EQ(objects[0].textureRoughnessMin, slot == kRoughMetalSlot ? 70.0 / 255.0 : 1.0);
      EXPECT_EQ(objects[0].textureRoughnessMax, slot == kRoughMetalSlot ? 190.0 / 255.0 : 1.0);
      *use = {};
    }
  }
  // All at once: which of them what the surface is leaves over.
  for (const auto& [slot, use] : uses) *use = texture({static_cast<std::uint8_t>(10 + slot)}, 0);
  const auto filled = [&model] {
    std::string slots;
    const std::vector<DrawnObject> objects = made(model);
    for (const SurfaceSlot& slot : objects[0].surface->slots) slots += slot.texture ? '1' : '0';
    return slots + (objects[0].surface->tangents ? " tangents" : "");
  };
  EXPECT_EQ(filled(), "11111111111111111 tangents");
  m.finish.specularTint = glm::vec3(1.0f);
  m.finish.specularTexture = m.finish.specularColorTexture = {};
  EXPECT_EQ(filled(), "11111111110011111 tangents");
  m.finish.sheenColor = glm::vec3(0.0f);
  EXPECT_EQ(filled(), "11111111110000111 tangents");
  m.finish.anisotropy = 0.0f;
  EXPECT_EQ(filled(), "11111111110000011 tangents");
  m.finish.iridescence = 0.0f;
  EXPECT_EQ(filled(), "11111111110000000 tangents");
  m.transmission = 0.0f;
  EXPECT_EQ(filled(), "11111111000000000 tangents");
  model.meshes[0].tangents.clear();
  EXPECT_EQ(filled(), "11011110000000000");
  model.meshes[0].uv.clear();
  EXPECT_EQ(filled(), "00000000000000000");
  m.unlit = true;
  m.baseColorTexture.uvSet = m.emissiveTexture.uvSet = 1;
  EXPECT_EQ(filled(), "10000000000000000");
}

TEST(DrawnObjects, HaveTheMaterialsNumbersAfterOverrides) {
  Model model;
  model.meshes = {wholeMesh()};
  Material& m = model.materials.emplace_back();
  m.name = "paint";
  m.baseColor = {0.21f, 0.32f, 0.43f, 0.54f};
  m.metallic = 0.15f;
  m.roughness = 0.45f;
  m.emissive = {0.61f, 0.72f, 1.83f};
  m.normalScale = 0.9f;
  m.occlusionStrength = 0.35f;
  m.coat = 0.25f;
  m.coatRoughness = 0.65f;
  m.coatNormalScale = 0.8f;
  m.ior = 1.7f;
  m.alphaCutoff = 0.4f;
  m.occlusionTexture = texture({90}, 0);
  m.metallicRoughnessTexture = texture({51, 204}, 0);
  m.doubleSided = true;
  glm::dmat4 placed(1.0);
  placed[0] = {0.0, 0.0, -2.0, 0.0};
  placed[2] = {2.0, 0.0, 0.0, 0.0};
  placed[3] = {3.0, 5.0, 7.0, 1.0};
  model.instances = {{"thing", 0, placed}};
  Scene scene;
  const auto apply = [&] {
    std::vector<DrawnObject> objects = made(model);
    applyOverrides(objects[0], scene);
    return std::move(objects[0]);
  };
  {
    const DrawnObject object = apply();
    vtkProperty* p = object.actor->GetProperty();
    EXPECT_EQ(p->GetInterpolation(), VTK_PBR);
    EXPECT_NEAR(p->GetColor()[0], 0.21, 1e-6);
    EXPECT_NEAR(p->GetColor()[1], 0.32, 1e-6);
    EXPECT_NEAR(p->GetColor()[2], 0.43, 1e-6);
    EXPECT_NEAR(p->GetMetallic(), 0.15, 1e-6);
    EXPECT_NEAR(p->GetRoughness(), 0.45, 1e-6);
    EXPECT_NEAR(p->GetEmissiveFactor()[0], 0.61, 1e-6);
    EXPECT_NEAR(p->GetEmissiveFactor()[1], 0.72, 1e-6);
    EXPECT_NEAR(p->GetEmissiveFactor()[2], 1.83, 1e-6);
    EXPECT_NEAR(p->GetOcclusionStrength(), 0.35, 1e-6);
    EXPECT_NEAR(p->GetBaseIOR(), 1.7, 1e-6);
    EXPECT_NEAR(p->GetCoatStrength(), 0.25, 1e-6);
    EXPECT_NEAR(p->GetCoatRoughness(), 0.65, 1e-6);
    EXPECT_EQ(p->GetCoatIOR(), 1.5);
    EXPECT_EQ(p->GetBackfaceCulling(), 0);
    EXPECT_NEAR(object.surface->alpha, 0.54, 1e-6);
    EXPECT_NEAR(object.surface->normalScale, 0.9, 1e-6);
    EXPECT_NEAR(object.surface->coatNormalScale, 0.8, 1e-6);
    EXPECT_NEAR(object.surface->alphaCutoff, 0.4, 1e-6);
    EXPECT_FALSE(object.allMetal);
    EXPECT_FALSE(object.unlit);
    // 0.2 and 0.8 of the roughness; the coat's is in between the two only of the lower end.
    EXPECT_NEAR(object.roughnessMin, 0.45 * 0.2, 1e-6);
    EXPECT_NEAR(object.roughnessMax, 0.65, 1e-6);
    EXPECT_TRUE(object.actor->GetForceOpaque());
    EXPECT_FALSE(object.actor->GetForceTranslucent());
    EXPECT_TRUE(object.actor->GetVisibility());
    for (int row = 0; row < 4; ++row) {
      for (int column = 0; column < 4; ++column) {
        EXPECT_EQ(object.actor->GetUserMatrix()->GetElement(row, column), placed[column][row]) << row << column;
      }
    }
    EXPECT_EQ(object.placed, placed);
  }
  m.coatRoughness = 0.02f;
  EXPECT_NEAR(apply().roughnessMin, 0.02, 1e-6);
  EXPECT_NEAR(apply().roughnessMax, 0.45 * 0.8, 1e-6);
  m.coat = 0.03f;
  EXPECT_NEAR(apply().roughnessMin, 0.02, 1e-6) << "a thin coat is one, too";
  m.coat = 0.0f;
  EXPECT_NEAR(apply().roughnessMin, 0.45 * 0.2, 1e-6);
  m.metallicRoughnessTexture = {};
  m.metallic = 1.0f;
  EXPECT_NEAR(apply().roughnessMin, 0.45, 1e-6);
  EXPECT_TRUE(apply().allMetal);
  m.finish.sheenColor = glm::vec3(0.1f);
  EXPECT_FALSE(apply().allMetal) << "cloth over metal";
  m.finish = {};
  m.metallicRoughnessTexture = texture({51, 204}, 0);
  EXPECT_FALSE(apply().allMetal) << "a texture may say something else";
  m.occlusionTexture = {};
  EXPECT_EQ(apply().actor->GetProperty()->GetOcclusionStrength(), 0.0);
  m.doubleSided = false;
  EXPECT_EQ(apply().actor->GetProperty()->GetBackfaceCulling(), 1);
  m.alphaMode = AlphaMode::Blend;
  EXPECT_FALSE(apply().actor->GetForceOpaque());
  EXPECT_TRUE(apply().actor->GetForceTranslucent());
  m.alphaMode = AlphaMode::Mask;
  EXPECT_TRUE(apply().actor->GetForceOpaque());

  scene.materials["paint"].roughness = 0.77f;
  scene.materials["paint"].baseColor = glm::vec3(0.9f, 0.8f, 0.7f);
  scene.objects["thing"].visible = false;
  scene.objects["thing"].translation = {0.5, -0.25, 0.125};
  const DrawnObject changed = apply();
  EXPECT_NEAR(changed.actor->GetProperty()->GetRoughness(), 0.77, 1e-6);
  EXPECT_NEAR(changed.actor->GetProperty()->GetColor()[1], 0.8, 1e-6);
  EXPECT_FALSE(changed.actor->GetVisibility());
  EXPECT_NEAR(changed.actor->GetUserMatrix()->GetElement(0, 3), 3.5, 1e-12);
  EXPECT_NEAR(changed.actor->GetUserMatrix()->GetElement(1, 3), 4.75, 1e-12);
  EXPECT_NEAR(changed.actor->GetUserMatrix()->GetElement(2, 3), 7.125, 1e-12);
  EXPECT_EQ(changed.placed, placed);

  m.unlit = true;
  const DrawnObject plain = apply();
  EXPECT_TRUE(plain.unlit);
  EXPECT_EQ(plain.actor->GetProperty()->GetMetallic(), 0.0);
  for (int c = 0; c < 3; ++c) EXPECT_EQ(plain.actor->GetProperty()->GetColor()[c], 0.0);
  EXPECT_NEAR(plain.actor->GetProperty()->GetEmissiveFactor()[0], 0.9, 1e-6);
  EXPECT_NEAR(plain.actor->GetProperty()->GetEmissiveFactor()[2], 0.7, 1e-6);

  DrawnObject bounded = apply();
  bounded.placedBounds = Box{{1, 2, 3}, {4, 5, 6}};
  EXPECT_EQ(worldBounds(bounded), (Box{{1, 2, 3}, {4, 5, 6}}));
  const auto twin = makeTwin(bounded, std::make_shared<DrawState>());
  EXPECT_EQ(twin->GetProperty(), bounded.actor->GetProperty());
  EXPECT_EQ(twin->GetForceOpaque(), bounded.actor->GetForceOpaque());
  EXPECT_EQ(twin->GetForceTranslucent(), bounded.actor->GetForceTranslucent());
  EXPECT_EQ(twin->GetMapper()->GetInputDataObject(0, 0), bounded.actor->GetMapper()->GetInputDataObject(0, 0));
}

}  // namespace
}  // namespace boxprobe
