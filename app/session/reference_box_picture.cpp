// See reference_box_picture.h.
#include "app/session/reference_box_picture.h"

#include <algorithm>

#include "filters/reference/light/reference_scene.h"
#include "filters/reference/trace/visible_normal_lobe.h"
#include "filters/vtk/scene_renderer.h"

namespace boxprobe {

ReferenceBoxMaps boxMaps(SceneRenderer& renderer, const Scene& scene) {
  ReferenceBoxMaps maps;
  for (const Probe& probe : scene.probes) maps.probes.push_back(renderer.mapsOnCpu(probe.name));
  maps.sky = renderer.mapsOnCpu("");
  maps.energy = scene.energy;
  maps.findBright();
  return maps;
}

/// What the surfaces are comes from the shader itself, a band of rows at a time: explanations are large.
ReferencePicture integrateBox(SceneRenderer& renderer, const ReferenceBoxMaps& maps, const BoxPictureSize& size,
                              const ReferenceProgress& progress) {
  const int side = positionsPerSide(size.samplesPerPixel), positions = side * side;
  const RayPlan plan = planRays(size.raysPerPixel, positions);
  constexpr int kBandPositions = 1 << 17;
  const int bandRows = std::clamp(kBandPositions / (size.width * positions), 1, size.height);
  ProgressivePicture picture(size.width, size.height);
  for (int first = 0; first < size.height; first += bandRows) {
    const int end = std::min(first + bandRows, size.height);
    std::vector<glm::ivec2> places;
    for (int y = first * side; y < end * side; ++y) {
      for (int x = 0; x < size.width * side; ++x) places.emplace_back(x, y);
    }
    const std::vector<Explanation> surfaces = renderer.explain(places, size.width * side, size.height * side);
    const auto estimate = [&](int x, int y, int pass) {
      ProgressivePicture::Pixel pixel;
      pixel.exact = true;
      for (int k = 0; k < positions; ++k) {
        const auto row = static_cast<std::size_t>((y - first) * side + k / side);
        const std::size_t at =
            row * static_cast<std::size_t>(size.width * side) + static_cast<std::size_t>(x * side + k % side);
        const LitPoint surface = litPoint(surfaces[at]);
        const std::uint64_t place = static_cast<std::uint64_t>(first) << 32;
        bool exact = true;
        pixel.color += referenceBoxColor(surface, maps, plan.raysPerPass,
                                         stirred(stirred(place + at) + static_cast<std::uint64_t>(pass)), &exact);
        pixel.alpha += surface.hit ? 1.0 : 0.0;
        pixel.exact = pixel.exact && exact;
      }
      pixel.color /= positions;
      pixel.alpha /= positions;
      return pixel;
    };
    const auto share = [&](double done) { return !progress || progress((first + done * (end - first)) / size.height); };
    if (!picture.run(first, end, plan.passes, estimate, share)) break;
  }
  return picture.picture();
}

}  // namespace boxprobe
