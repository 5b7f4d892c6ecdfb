// The program's own numbers for the plan in the page of lessons: each line of the input holds P, N, the eye, C and the
// box's corners (18 numbers); each line of the output t_x t_y t_z, d, R, H - C and the axis that wins, by the compiled
// shader files. usage: plan_numbers [RADIUS of the box's edges, 0]
#include <array>
#include <cstdlib>
#include <glm/geometric.hpp>
#include <iostream>
#include <limits>

#include "filters/math/shared/shared_math.h"
#include "filters/math/technique/technique_table.h"

int main(int argc, char** argv) {
  using namespace boxprobe;
  const ProjectionRow& box = projectionRows()[static_cast<std::size_t>(parseTechnique("box")->projection)];
  std::cout.precision(std::numeric_limits<float>::max_digits10);
  for (std::array<double, 18> v; std::cin >> v[0];) {
    for (std::size_t i = 1; i < v.size(); ++i) {
      if (!(std::cin >> v[i])) return 2;
    }
    const auto at = [&v](std::size_t i) { return glm::dvec3(v[3 * i], v[3 * i + 1], v[3 * i + 2]); };
    const glm::dvec3 origin = at(3);  // everything is relative to it before it is rounded, as where the program draws
    const glm::vec3 position(at(0) - origin), normal(at(1)), view(glm::normalize(at(2) - at(0)));
    shading::ProbeShape shape{};
    shape.boxMin = glm::vec3(at(4) - origin);
    shape.boxMax = glm::vec3(at(5) - origin);
    shape.bevel = argc > 1 ? std::strtof(argv[1], nullptr) : 0.0f;
    const glm::vec3 reflection = shading::reflectedView(normal, view);
    const shading::ProbeHit hit = box.project(shape, position, normal, reflection);
    for (const glm::vec3& value : {hit.slabFactors, glm::vec3(hit.distance), reflection, hit.direction}) {
      for (int i = 0; i < 3; ++i) std::cout << value[i] << ' ';
    }
    std::cout << hit.face / 2 << '\n';
  }
}
