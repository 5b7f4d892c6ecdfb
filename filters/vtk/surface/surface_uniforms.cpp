#include "filters/vtk/surface/surface_uniforms.h"

#include <vtkMatrix3x3.h>
#include <vtkMatrix4x4.h>
#include <vtkOpenGLCamera.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "filters/vtk/surface/glass_draw.h"

namespace boxprobe {

namespace {

void uploadFinish(const UniformUpload& to, const MaterialFinish& finish) {
  to.program->SetUniform3f("bpSpecularTint", &finish.specularTint.x);
  to.program->SetUniformf("bpSpecularEdge", finish.specularEdge);
  to.program->SetUniform3f("bpSheenColor", &finish.sheenColor.x);
  to.program->SetUniformf("bpSheenRoughness", finish.sheenRoughness);
  const float turn = finish.anisotropyRotation;
  const glm::vec3 anisotropy(std::cos(turn), std::sin(turn), finish.anisotropy);
  to.program->SetUniform3f("bpAnisotropy", &anisotropy.x);
  const glm::vec4 film(finish.iridescence, finish.filmIor, finish.filmThicknessMin, finish.filmThicknessMax);
  to.program->SetUniform4f("bpFilm", &film.x);
}

}  // namespace

void uploadMaterial(const UniformUpload& to, const SurfaceMaterial& surface) {
  to.program->SetUniformf("bpAlpha", surface.alpha);
  to.program->SetUniformf("bpAlphaCutoff", surface.alphaCutoff);
  to.program->SetUniformf("bpNormalScale", surface.normalScale);
  to.program->SetUniformf("bpCoatNormalScale", surface.coatNormalScale);
  if (surface.slots[kThicknessSlot].texture && to.used("bpThicknessScale")) {
    to.program->SetUniformf("bpThicknessScale", surface.thicknessScale);
  }
  if (surface.finished()) uploadFinish(to, surface.finish);
  for (std::size_t i = 0; i < surface.slots.size(); ++i) {
    const SurfaceSlot& slot = surface.slots[i];
    if (!slot.texture) continue;
    const std::string name = surfaceSlotNames()[i];
    // A slot that this variant does not read would only take a unit.
    if (!to.used("bpTex" + name)) continue;
    to.texture2d("bpTex" + name, slot.texture->handle());
    if (!to.used("bpUv" + name)) continue;
    const glm::mat3x2& m = slot.uvTransform;
    const float rows[2][3] = {{m[0][0], m[1][0], m[2][0]}, {m[0][1], m[1][1], m[2][1]}};
    to.program->SetUniform3fv(("bpUv" + name).c_str(), 2, rows);
  }
}

void uploadMirror(const UniformUpload& to, const MirrorPicture& mirror, const SceneResources& resources) {
  to.program->SetUniformf("bpMirrorOn", mirror.shown ? 1.0f : 0.0f);
  const GLuint none = resources.brdfTable;  // not read
  to.texture2d("bpMirrorColor", mirror.shown ? mirror.color : none);
  to.texture2d("bpMirrorHeight", mirror.shown ? mirror.height : none);
  const shading::MirrorLook& look = mirror.look;
  const std::array<glm::vec4, 3> places = {look.toU, look.toV, look.toW};
  to.program->SetUniform4fv("bpMirrorPlaces", 3, reinterpret_cast<const float(*)[4]>(&places[0].x));
  const glm::vec4 normal(look.normal, look.farHeight), eye(look.eye, look.texelSize);
  to.program->SetUniform4f("bpMirrorNormal", &normal.x);
  to.program->SetUniform4f("bpMirrorEye", &eye.x);
  const glm::vec3 levels(look.parallel, look.maxLevel, look.sharpLevel);
  to.program->SetUniform3f("bpMirrorLevels", &levels.x);
  const glm::vec2 size(look.sizeX, look.sizeY);
  to.program->SetUniform2f("bpMirrorSize", &size.x);
}

namespace {

// By the very matrix that the vertices are placed with.
void uploadBehind(const UniformUpload& to, const BehindPicture& behind, const SceneResources& resources) {
  if (!to.used("bpBehindOn")) return;
  const bool there = behind.color != 0;
  to.program->SetUniformf("bpBehindOn", there ? 1.0f : 0.0f);
  to.texture2d("bpBehindColor", there ? behind.color : resources.brdfTable);  // else not read
  to.texture2d("bpBehindDepth", there ? behind.depth : resources.brdfTable);
  vtkMatrix4x4 *clipFromWorld = nullptr, *viewFromWorld = nullptr, *clipFromView = nullptr;
  vtkMatrix3x3* normals = nullptr;
  vtkOpenGLCamera::SafeDownCast(to.camera())
      ->GetKeyMatrices(to.renderer, viewFromWorld, normals, clipFromView, clipFromWorld);
  to.program->SetUniformMatrix("bpBehindClip", clipFromView);
  const float size[2] = {static_cast<float>(behind.width), static_cast<float>(behind.height)};
  to.program->SetUniform2f("bpBehindSize", size);
}

}  // namespace

void uploadGlassOf(const UniformUpload& to, const GlassSurface& glass, const ProbeBinding& binding,
                   const SceneResources& resources, const BehindPicture& behind) {
  int faceSize = resources.sky ? resources.sky->radiance.faceSize() : 0;
  for (const auto& probe : binding.probes) {
    if (probe->maps) faceSize = std::max(faceSize, probe->maps->radiance.faceSize());
  }
  const bool followed = glass.shell && to.used("bpGlassShell");
  const int unit = followed ? to.bind(GL_TEXTURE_CUBE_MAP, glass.shell->handle()) : -1;
  uploadGlass(to.program, glass, to.eyeWorld(), faceSize, unit);
  uploadBehind(to, behind, resources);
}

}  // namespace boxprobe
