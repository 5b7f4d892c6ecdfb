#include "filters/vtk/surface/coverage_uniforms.h"

#include <vtkShaderProgram.h>

#include <algorithm>
#include <array>
#include <glm/ext/matrix_transform.hpp>
#include <glm/vec4.hpp>
#include <string>

namespace boxprobe {

void uploadCoverage(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding) {
  std::vector<glm::vec4> lights;
  for (const int light : binding.shadowLights) {
    const auto i = static_cast<std::size_t>(light);
    const bool known = i < state.resources.shadowLights.size();
    const ShadowLight of = known ? state.resources.shadowLights[i] : ShadowLight{};
    lights.emplace_back(of.size.tangent, of.size.radius, of.levelsPerUnit, 0.0f);
  }
  to.program->SetUniform4fv("bpShadowLight", static_cast<int>(lights.size()),
                            reinterpret_cast<const float(*)[4]>(&lights[0].x));
  std::array<int, ProbeBinding::kMaxProbesPerDraw> masks{};
  for (std::size_t i = 0; i < binding.probes.size(); ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    const std::string slot = std::to_string(i);
    masks[i] = static_cast<int>(probe.shadowLights);
    // Before the first capture nothing is known of openings: nothing comes through.
    const ProbeMaps* maps = state.pass().firstBounce ? nullptr : probe.maps.get();
    if (maps != nullptr) maps->coverage.make(maps->radiance, maps->tint.get(), probe.imported);
    to.cube("bpThroughMap" + slot, maps != nullptr ? maps->coverage.handle() : state.resources.blackCube);
    to.program->SetUniformf(("bpThroughFaceSize" + slot).c_str(),
                            maps != nullptr ? static_cast<float>(maps->radiance.faceSize()) : 1.0f);
    const float maxLevel = maps != nullptr ? maps->coverage.chain()->maxLevel() : 0.0f;
    to.program->SetUniformf(("bpThroughPerUnit" + slot).c_str(),
                            levelsPerUnit(probe.geometry.boxMin, probe.geometry.boxMax, maxLevel));
  }
  to.program->SetUniform1iv("bpShadowMask", static_cast<int>(binding.probes.size()), masks.data());
  for (const int light : binding.movingLights) {
    const auto map = std::find_if(state.resources.movingShadows.begin(), state.resources.movingShadows.end(),
                                  [&](const MovingShadow& shadow) { return shadow.light == light; });
    const bool on = map != state.resources.movingShadows.end() && state.pass().movingShadowsOn;
    const std::string n = std::to_string(light);
    to.program->SetUniformf(("bpMovingOn" + n).c_str(), on ? 1.0f : 0.0f);
    // A sampler of its kind needs a texture of its own kind, read or not.
    const GLuint any = state.resources.movingShadows.empty() ? 0 : state.resources.movingShadows.front().texture;
    to.texture2d("bpMovingMap" + n, on ? map->texture : any);
    glm::mat4 matrix(1.0f);
    if (on) matrix = glm::mat4(glm::translate(map->mapFromWorld, to.eyeWorld()));
    to.program->SetUniformMatrix4x4(("bpMovingFromEye" + n).c_str(), &matrix[0][0]);
  }
}

}  // namespace boxprobe
