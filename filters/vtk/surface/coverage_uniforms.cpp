#include "filters/vtk/surface/coverage_uniforms.h"

#include <vtkOpenGLRenderWindow.h>
#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace boxprobe {

void uploadCoverage(vtkShaderProgram* program, vtkOpenGLRenderWindow* window, const DrawState& state,
                    const ProbeBinding& binding, const glm::dvec3& eyeWorld,
                    std::vector<std::unique_ptr<BoundTexture>>& bound) {
  const auto bind = [&](GLenum target, GLuint handle) {
    bound.push_back(std::make_unique<BoundTexture>(window, target, handle));
    return bound.back()->unit();
  };
  std::vector<glm::vec4> lights;
  for (const int light : binding.shadowLights) {
    const auto i = static_cast<std::size_t>(light);
    const bool known = i < state.shadowLights.size();
    const ShadowLight of = known ? state.shadowLights[i] : ShadowLight{};
    lights.emplace_back(of.size.tangent, of.size.radius, of.levelsPerUnit, 0.0f);
  }
  program->SetUniform4fv("bpShadowLight", static_cast<int>(lights.size()),
                         reinterpret_cast<const float(*)[4]>(&lights[0].x));
  std::array<int, ProbeBinding::kMaxProbesPerDraw> masks{};
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    const std::string slot = std::to_string(i);
    masks[i] = static_cast<int>(probe.shadowLights);
    // Before the first capture nothing is known of openings: nothing comes through.
    const ProbeMaps* maps = state.firstBounce ? nullptr : probe.maps.get();
    if (maps != nullptr) maps->coverage.make(maps->radiance, maps->tint.get(), probe.imported);
    program->SetUniformi(("bpThroughMap" + slot).c_str(),
                         bind(GL_TEXTURE_CUBE_MAP, maps != nullptr ? maps->coverage.handle() : state.blackCube));
    program->SetUniformf(("bpThroughFaceSize" + slot).c_str(),
                         maps != nullptr ? static_cast<float>(maps->radiance.faceSize()) : 1.0f);
    const float maxLevel = maps != nullptr ? maps->coverage.chain()->maxLevel() : 0.0f;
    program->SetUniformf(("bpThroughPerUnit" + slot).c_str(),
                         levelsPerUnit(probe.geometry.boxMin, probe.geometry.boxMax, maxLevel));
  }
  program->SetUniform1iv("bpShadowMask", static_cast<int>(binding.probes.size()), masks.data());
  for (const int light : binding.movingLights) {
    const auto map = std::find_if(state.movingShadows.begin(), state.movingShadows.end(),
                                  [&](const MovingShadow& shadow) { return shadow.light == light; });
    const bool on = map != state.movingShadows.end() && state.movingShadowsOn;
    const std::string n = std::to_string(light);
    program->SetUniformf(("bpMovingOn" + n).c_str(), on ? 1.0f : 0.0f);
    // A sampler of its kind needs a texture of its own kind, read or not.
    const GLuint any = state.movingShadows.empty() ? 0 : state.movingShadows.front().texture;
    program->SetUniformi(("bpMovingMap" + n).c_str(), bind(GL_TEXTURE_2D, on ? map->texture : any));
    glm::mat4 matrix(1.0f);
    if (on) matrix = glm::mat4(glm::translate(map->mapFromWorld, eyeWorld));
    program->SetUniformMatrix4x4(("bpMovingFromEye" + n).c_str(), &matrix[0][0]);
  }
}

}  // namespace boxprobe
