#include "filters/math/cube/cube_filter_reference.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace boxprobe {

namespace {

constexpr int kParts = 2;  // along each side of a texel

std::size_t place(int size, int face, int column, int row) {
  return (static_cast<std::size_t>(face) * static_cast<std::size_t>(size) + static_cast<std::size_t>(row)) *
             static_cast<std::size_t>(size) +
         static_cast<std::size_t>(column);
}

float brightness(const glm::vec4& c) {
  return c.x + c.y + c.z;
}

}  // namespace

CubeFilterReference::CubeFilterReference(const CubeMap& source, float tolerance)
    : faceSize_(source.faceSize()), tolerance_(tolerance) {
  int size = kParts * faceSize_;
  const auto allocate = [&] {
    sizes_.push_back(size);
    levels_.emplace_back(6 * static_cast<std::size_t>(size) * static_cast<std::size_t>(size));
  };
  allocate();
  tbb::parallel_for(tbb::blocked_range<int>(0, 6 * size), [&](const tbb::blocked_range<int>& lines) {
    for (int line = lines.begin(); line < lines.end(); ++line) {
      const int face = line / size, row = line % size;
      for (int column = 0; column < size; ++column) {
        const double step = 2.0 / size, s0 = -1.0 + step * column, t0 = -1.0 + step * row;
        Patch& patch = levels_[0][place(size, face, column, row)];
        const glm::vec3 d =
            shading::cubeDirection(face, static_cast<float>(s0 + 0.5 * step), static_cast<float>(t0 + 0.5 * step));
        patch.direction = glm::normalize(d);
        patch.solidAngle = static_cast<float>(cubeSolidAngle(s0, t0, s0 + step, t0 + step));
        patch.flux = patch.solidAngle * source.fetch(d, 0.0f);
        patch.width = 0.0f;  // never split
      }
    }
  });
  while (size > 1) {
    const int parts = size == kParts * faceSize_ ? kParts : 2;
    const int children = size;
    size /= parts;
    allocate();
    const std::vector<Patch>& fine = levels_[levels_.size() - 2];
    std::vector<Patch>& coarse = levels_.back();
    for (int face = 0; face < 6; ++face) {
      for (int row = 0; row < size; ++row) {
        for (int column = 0; column < size; ++column) {
          Patch sum{glm::vec3(0.0f), 0.0f, glm::vec4(0.0f), 0.0f};
          glm::vec3 bright(0.0f), plain(0.0f);
          for (int i = 0; i < parts * parts; ++i) {
            const Patch& part = fine[place(children, face, column * parts + i % parts, row * parts + i / parts)];
            sum.solidAngle += part.solidAngle;
            sum.flux += part.flux;
            bright += brightness(part.flux) * part.direction;
            plain += part.solidAngle * part.direction;
          }
          // The centroid of radiance, so that a small lamp stays where it is however large its patch.
          sum.direction = glm::normalize(brightness(sum.flux) > 0.0f ? bright : plain);
          sum.width = 2.0f / static_cast<float>(size);  // in the middle of a face, where it is largest
          coarse[place(size, face, column, row)] = sum;
        }
      }
    }
  }
}

glm::vec4 CubeFilterReference::value(const FilterLobe& lobe, const glm::vec3& middle) const {
  glm::dvec4 sum(0.0);
  double norm = 0.0;
  // The kernel's own scale in its middle; farther out it falls with a power of the angle.
  const float core = lobe.kind == FilterLobe::Kind::Ggx ? 2.0f * lobe.width : 1.5f * lobe.width;
  const float tolerance2 = tolerance_ * tolerance_;
  struct Place {
    int level, face, column, row;
  };
  std::vector<Place> open;
  for (int face = 0; face < 6; ++face) open.push_back({static_cast<int>(levels_.size()) - 1, face, 0, 0});
  while (!open.empty()) {
    const Place at = open.back();
    open.pop_back();
    const int size = sizes_[static_cast<std::size_t>(at.level)];
    const Patch& patch = levels_[static_cast<std::size_t>(at.level)][place(size, at.face, at.column, at.row)];
    const glm::vec3 apart = patch.direction - middle;
    const float apart2 = glm::dot(apart, apart);
    const float scale2 = lobe.kind == FilterLobe::Kind::Ggx ? apart2 + core * core : core * core;
    if (at.level == 0 || patch.width * patch.width < tolerance2 * scale2) {
      const double k = lobeKernel(lobe, 0.5f * apart2);
      sum += k * glm::dvec4(patch.flux);
      norm += k * patch.solidAngle;
      continue;
    }
    // Entirely beyond the horizon or the kernel's support.
    const float chord = std::sqrt(apart2) - patch.width;
    if (chord > 0.0f && lobeKernel(lobe, 0.5f * chord * chord) <= 0.0f) continue;
    const int parts = at.level == 1 ? kParts : 2;
    for (int i = 0; i < parts * parts; ++i) {
      open.push_back({at.level - 1, at.face, at.column * parts + i % parts, at.row * parts + i / parts});
    }
  }
  return glm::vec4(sum / std::max(norm, 1.0e-300));
}

void CubeFilterReference::filterLevel(const FilterLobe& lobe, CubeMap& chain, int level) const {
  const int size = chain.levelSize(level);
  tbb::parallel_for(tbb::blocked_range<int>(0, 6 * size), [&](const tbb::blocked_range<int>& lines) {
    for (int line = lines.begin(); line < lines.end(); ++line) {
      const int face = line / size, row = line % size;
      for (int column = 0; column < size; ++column) {
        const float s = (2.0f * static_cast<float>(column) + 1.0f) / static_cast<float>(size) - 1.0f;
        const float t = (2.0f * static_cast<float>(row) + 1.0f) / static_cast<float>(size) - 1.0f;
        chain.setTexel(level, face, column, row, value(lobe, glm::normalize(shading::cubeDirection(face, s, t))));
      }
    }
  });
}

}  // namespace boxprobe
