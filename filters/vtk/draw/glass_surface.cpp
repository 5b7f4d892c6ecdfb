#include "filters/vtk/draw/glass_surface.h"

#include <glm/geometric.hpp>
#include <glm/mat4x4.hpp>
#include <glm/matrix.hpp>

namespace boxprobe {

namespace {

glm::dvec3 middleOf(const Mesh& mesh) {
  if (mesh.positions.empty()) return glm::dvec3(0.0);
  glm::vec3 low = mesh.positions.front(), high = low;
  for (const glm::vec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return 0.5 * (glm::dvec3(low) + glm::dvec3(high));
}

// The published form leaves this to the artist; one half favours neither side.
constexpr float kBehindShare = 0.5f;

// A solid whose surface is not visible from its middle, and not thicker than this share of its radius, counts as
// hollow: light passes its walls like sheets, nearly straight.
constexpr float kWallShare = 0.2f;
// A rougher wall shows its own lookup and not what is drawn behind it: only the nearest counts.
constexpr float kClearRoughness = 0.02f;

GlassShell makeShell(const Mesh& mesh, const glm::dvec3& middle, const glm::dmat3& linear) {
  std::vector<glm::vec3> positions, normals;
  const glm::dmat3 normalMatrix = glm::transpose(glm::inverse(linear));
  for (const glm::vec3& p : mesh.positions) positions.emplace_back(linear * (glm::dvec3(p) - middle));
  for (const glm::vec3& n : mesh.normals) normals.emplace_back(normalMatrix * glm::dvec3(n));
  return GlassShell(positions, normals, mesh.indices);
}

}  // namespace

GlassShellTexture::GlassShellTexture(const Mesh& mesh, const glm::dvec3& middle, const glm::dmat3& linear)
    : shell_(makeShell(mesh, middle, linear)) {}

GLuint GlassShellTexture::handle() const {
  if (texture_.allocated()) return texture_.handle();
  const CubeMap& planes = shell_.planes();
  const auto count = static_cast<std::size_t>(planes.faceSize()) * static_cast<std::size_t>(planes.faceSize()) * 4;
  texture_.allocate(planes.faceSize(), 1, GL_RGBA32F);
  for (int face = 0; face < 6; ++face) {
    texture_.writeFace(face, 0, std::vector<float>(planes.face(0, face), planes.face(0, face) + count));
  }
  // As CubeMap::fetch samples it.
  GLint previous = 0;
  glGetIntegerv(GL_TEXTURE_BINDING_CUBE_MAP, &previous);
  glBindTexture(GL_TEXTURE_CUBE_MAP, texture_.handle());
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MAG_FILTER, GL_LINEAR);
  glTexParameteri(GL_TEXTURE_CUBE_MAP, GL_TEXTURE_MIN_FILTER, GL_LINEAR_MIPMAP_NEAREST);
  glBindTexture(GL_TEXTURE_CUBE_MAP, static_cast<GLuint>(previous));
  return texture_.handle();
}

int GlassSurface::variant() const {
  if (!drawn) return 0;
  return sheet ? 4 : static_cast<int>(form);
}

shading::GlassObject GlassSurface::object(const glm::dvec3& eyeWorld) const {
  shading::GlassObject object{};
  object.ior = ior;
  object.form = static_cast<int>(form);
  object.sheet = sheet;
  object.thickness = thickness;
  object.center = glm::vec3(middleWorld - eyeWorld);
  object.radius = radius;
  return object;
}

bool GlassSurface::looksBehind(bool textured) const {
  return drawn && !(sheet && !textured && roughness <= kClearRoughness);
}

float GlassSurface::behindShare() const {
  return form == GlassForm::TwoPass && !sheet ? kBehindShare : 0.0f;
}

ExplainedGlass GlassSurface::explained(const glm::dvec3& eyeWorld, int faceSize) const {
  ExplainedGlass glass;
  glass.form = !sheet ? glassFormName(form) : thickness > 0.0f ? "thin walls" : "thin";
  glass.object = object(eyeWorld);
  glass.shell = shell ? &shell->shell() : nullptr;
  glass.transmission = transmission;
  glass.attenuationDistance = attenuationDistance;
  glass.attenuationColor = attenuationColor;
  glass.straightAngle = straightAngle(faceSize);
  glass.behind = behindShare();
  return glass;
}

void GlassSurface::apply(const Material& material, const Mesh& mesh, const glm::dmat4& worldFromModel) {
  drawn = material.transmits();
  if (!drawn) return;
  sheet = material.thin;
  ior = material.ior;
  transmission = material.transmission;
  roughness = material.roughness;
  thickness = sheet ? 0.0f : material.thickness;
  attenuationDistance = material.attenuationDistance;
  walls = false;
  attenuationColor = material.attenuationColor;
  form = material.glass;
  const glm::dvec3 middle = middleOf(mesh);
  const glm::dmat3 linear(worldFromModel);
  middleWorld = glm::dvec3(worldFromModel * glm::dvec4(middle, 1.0));
  const bool wanted = !sheet && (form == GlassForm::Automatic || form == GlassForm::TwoInterface);
  if (wanted && (!shell || builtFor_ != linear)) {
    shell = std::make_shared<GlassShellTexture>(mesh, middle, linear);
    builtFor_ = linear;
    radius = shell->shell().radius();
  }
  if (form != GlassForm::Automatic) return;
  form = shell && shell->shell().fits() ? GlassForm::TwoInterface : GlassForm::TwoPass;
  const bool hollow = form == GlassForm::TwoPass && thickness > 0.0f && thickness < kWallShare * radius;
  sheet = sheet || hollow;
  walls = hollow && material.roughness <= kClearRoughness;
}

std::string glassFormName(GlassForm form) {
  const char* const names[] = {"auto", "one-pass", "two-pass", "two-interface"};
  return names[static_cast<int>(form)];
}

}  // namespace boxprobe
