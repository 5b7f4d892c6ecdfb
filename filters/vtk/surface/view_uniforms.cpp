#include "filters/vtk/surface/view_uniforms.h"

#include <vtkShaderProgram.h>

#include <array>

#include "filters/core/picture/probe_color.h"
#include "filters/vtk/surface/camera_uniforms.h"

namespace boxprobe {

void uploadView(const UniformUpload& to, const DrawState& state, const ProbeBinding& binding, int object) {
  const DebugView& debug = state.pass().debug;
  to.program->SetUniformi("bpView", debug.view);
  to.program->SetUniformi("bpFinishShown", debug.finish ? 1 : 0);
  const float range[2] = {debug.low, debug.high};
  to.program->SetUniform2f("bpViewRange", range);
  if (state.resources.viewColors != 0) to.texture2d("bpViewColors", state.resources.viewColors);
  const auto& faces = faceColors();
  to.program->SetUniform3fv("bpFaceColors", 6, reinterpret_cast<const float(*)[3]>(&faces[0].x));
  to.program->SetUniformf("bpObject", static_cast<float>(object));
  if (binding.lighting != Lighting::Probes) {
    to.program->SetUniformMatrix3x3("bpViewToWorld", viewToWorldRotation(to.camera()).data());
    return;
  }
  const glm::vec3 sky = skyColor();
  to.program->SetUniform3f("bpSkyColor", &sky.x);
  constexpr std::size_t kMax = ProbeBinding::kMaxProbesPerDraw;
  std::array<glm::vec3, kMax> color;
  std::array<float, kMax> faceSize{};
  const std::size_t count = binding.probes.size();
  for (std::size_t i = 0; i < count; ++i) {
    const DrawnProbe& probe = *binding.probes[i];
    color[i] = probeColor(probe.index);
    const bool known = probe.maps != nullptr && probe.maps->distance.allocated();
    faceSize[i] = known ? static_cast<float>(probe.maps->distance.faceSize()) : 0.0f;
  }
  if (count == 0) return;
  const int n = static_cast<int>(count);
  to.program->SetUniform3fv("bpProbeColor", n, reinterpret_cast<const float(*)[3]>(&color[0].x));
  to.program->SetUniform1fv("bpDistanceFaceSize", n, faceSize.data());
}

}  // namespace boxprobe
