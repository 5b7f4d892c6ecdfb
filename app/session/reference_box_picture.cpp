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
  const PicturePart part = size.part.within(size.width, size.height);
  const int columns = (part.right - part.left) * side;
  for (int first = part.top; first < part.bottom; first += bandRows) {
    const int end = std::min(first + bandRows, part.bottom);
    std::vector<glm::ivec2> places;
    for (int y = first * side; y < end * side; ++y) {
      for (int x = part.left * side; x < part.right * side; ++x) places.emplace_back(x, y);
    }
    const std::vector<Explanation> surfaces = renderer.explain(places, size.width * side, size.height * side);
    const auto estimate = [&](int x, int y, int pass) {
      ProgressivePicture::Pixel pixel;
      pixel.exact = true;
      for (int k = 0; k < positions; ++k) {
        const auto row = static_cast<std::size_t>((y - first) * side + k / side);
        const auto column = static_cast<std::size_t>((x - part.left) * side + k % side);
        const LitPoint surface = litPoint(surfaces[row * static_cast<std::size_t>(columns) + column]);
        // Of the place in the whole picture: a part of it is drawn with the same rays.
        const std::uint64_t place =
            (static_cast<std::uint64_t>(y * side + k / side) << 32) + static_cast<std::uint64_t>(x * side + k % side);
        bool exact = true;
        pixel.color += referenceBoxColor(surface, maps, plan.raysPerPass,
                                         hashBits(hashBits(place) + static_cast<std::uint64_t>(pass)), &exact);
        pixel.alpha += surface.hit ? 1.0 : 0.0;
        pixel.exact = pixel.exact && exact;
      }
      pixel.color /= positions;
      pixel.alpha /= positions;
      return pixel;
    };
    const auto share = [&](double done) {
      return !progress || progress((first - part.top + done * (end - first)) / (part.bottom - part.top));
    };
    if (!picture.run({part.left, first, part.right, end}, plan.passes, estimate, share)) break;
  }
  return picture.picture();
}

}  // namespace boxprobe
