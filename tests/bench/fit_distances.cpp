// The fit from captured distances alone, without triangles: `fit_distances [COUNT]`. For faces of 128 and 256 texels
// squared the CPU time of a fit, the memory of the distances and of the process, and the error of the box over that of
// the box fitted with triangles, on rays that neither was fitted with.
#include <sys/resource.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <glm/trigonometric.hpp>
#include <vector>

#include "filters/fit/box/fit_box.h"
#include "filters/fit/rays/distance_rays.h"
#include "filters/fit/rays/triangle_rays.h"
#include "tests/support/distance_cube.h"
#include "tests/support/random_room.h"

namespace boxprobe {
namespace {

double middleOf(std::vector<double> values) {
  std::sort(values.begin(), values.end());
  return values[values.size() / 2];
}

int run(int count) {
  std::printf("%-8s %14s %14s %12s %12s %14s\n", "faces", "s, median", "s, most", "MiB of map", "MiB of all",
              "over triangles");
  for (const int size : {128, 256}) {
    std::vector<double> seconds, ratios;
    for (int i = 0; i < count; ++i) {
      const test::RandomRoom room = test::randomRoom(1000u + static_cast<std::uint32_t>(i));
      const TriangleRays triangles(room.scene, {room.model});
      const FitPlace truth{triangles, triangles, room.scene.cameras};
      const Probe& probe = room.scene.probes.front();
      const CubeMap distances = test::distanceCube(triangles, probe.origin, glm::dmat3(1.0), size);
      const DistanceRays marched(distances, probe.origin, glm::dmat3(1.0));
      const std::clock_t begun = std::clock();
      const std::optional<BoxFit> fit = fitBox({marched, marched, room.scene.cameras}, probe);
      seconds.push_back(static_cast<double>(std::clock() - begun) / CLOCKS_PER_SEC);

      constexpr double kSmall = 0.035;  // degrees: a tenth of a texel of 256² faces
      const ReflectedRays judge = reflectedRays(truth, probe, 4096, 0.5);
      const LookupRays rays = lookupRays(truth, judge, probe.origin, glm::dmat3(1.0));
      const auto errorOf = [&](const Probe& fitted) {
        OffsetBox box = offsetBox(fitted);
        box.yaw = glm::radians(fitted.rotationDegrees.y);
        return std::max(meanError(rays, box), kSmall);
      };
      ratios.push_back(errorOf(fit->probe) / errorOf(fitBox(truth, probe)->probe));
    }
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double map = 6.0 * size * size * sizeof(glm::vec4) / 1048576.0;
    std::printf("%-8d %14.2f %14.2f %12.1f %12.1f %14.3f\n", size, middleOf(seconds),
                *std::max_element(seconds.begin(), seconds.end()), map, static_cast<double>(usage.ru_maxrss) / 1024.0,
                middleOf(ratios));
  }
  return 0;
}

}  // namespace
}  // namespace boxprobe

int main(int argc, char** argv) {
  return boxprobe::run(argc > 1 ? std::max(1, std::atoi(argv[1])) : 16);
}
