#include "data/scenes/mesh_builder.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

namespace boxprobe::scenes {
namespace {

// sin and cos may differ in the last digit from one processor to the next. Rounding to 2^-20 (a micrometre) takes that
// away, so that the files come out the same bytes everywhere.
double rounded(double value) {
  return std::nearbyint(std::ldexp(value, 20)) * std::ldexp(1.0, -20) + 0.0;
}

glm::vec3 rounded(glm::dvec3 v) {
  return glm::vec3(rounded(v.x), rounded(v.y), rounded(v.z));
}

constexpr double kTwoPi = 6.283185307179586;

}  // namespace

FaceUv repeating(double metres) {
  return [metres](unsigned, glm::dvec2 size) { return UvRectangle{0.0, 0.0, size.x / metres, size.y / metres}; };
}

std::uint32_t MeshBuilder::vertex(glm::dvec3 position, glm::dvec3 normal, glm::dvec2 uv) {
  mesh_.positions.push_back(rounded(position));
  mesh_.normals.push_back(rounded(normal));
  mesh_.uv.emplace_back(rounded(uv.x), rounded(uv.y));
  return static_cast<std::uint32_t>(mesh_.positions.size() - 1);
}

void MeshBuilder::triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c) {
  for (std::uint32_t index : {a, b, c}) mesh_.indices.push_back(index);
}

void MeshBuilder::add(const MeshBuilder& part, const glm::dmat4& placed) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (std::size_t i = 0; i < part.mesh_.positions.size(); ++i) {
    vertex(glm::dvec3(placed * glm::dvec4(glm::dvec3(part.mesh_.positions[i]), 1.0)),
           glm::dmat3(placed) * glm::dvec3(part.mesh_.normals[i]), glm::dvec2(part.mesh_.uv[i]));
  }
  for (const std::uint32_t index : part.mesh_.indices) mesh_.indices.push_back(first + index);
}

void MeshBuilder::quad(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, UvRectangle uv) {
  quadGrid(corner, right, up, {0.0, 1.0}, {0.0, 1.0}, uv);
}

void MeshBuilder::quadrilateral(glm::dvec3 a, glm::dvec3 b, glm::dvec3 c, glm::dvec3 d) {
  const glm::dvec3 normal = glm::normalize(glm::cross(b - a, d - a));
  const std::uint32_t first = vertex(a, normal, {0.0, 1.0});
  vertex(b, normal, {1.0, 1.0});
  vertex(c, normal, {1.0, 0.0});
  vertex(d, normal, {0.0, 0.0});
  for (std::uint32_t index : {0u, 1u, 2u, 0u, 2u, 3u}) mesh_.indices.push_back(first + index);
}

void MeshBuilder::quadGrid(glm::dvec3 corner, glm::dvec3 right, glm::dvec3 up, const std::vector<double>& rightCuts,
                           const std::vector<double>& upCuts, UvRectangle uv,
                           const std::function<bool(int, int)>& keep) {
  const glm::dvec3 normal = glm::normalize(glm::cross(right, up));
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  for (double y : upCuts)
    for (double x : rightCuts)
      vertex(corner + x * right + y * up, normal,
             {uv.left + x * (uv.right - uv.left), uv.bottom + y * (uv.top - uv.bottom)});
  const auto width = static_cast<std::uint32_t>(rightCuts.size());
  for (std::uint32_t row = 0; row + 1 < upCuts.size(); ++row) {
    for (std::uint32_t column = 0; column + 1 < width; ++column) {
      if (keep && !keep(static_cast<int>(column), static_cast<int>(row))) continue;
      const std::uint32_t a = first + row * width + column;
      for (std::uint32_t index : {a, a + 1, a + width + 1, a, a + width + 1, a + width}) mesh_.indices.push_back(index);
    }
  }
}

void MeshBuilder::box(glm::dvec3 low, glm::dvec3 high, const FaceUv& uv, unsigned faces) {
  const glm::dvec3 x(high.x - low.x, 0, 0), y(0, high.y - low.y, 0), z(0, 0, high.z - low.z);
  struct Face {
    unsigned bit;
    glm::dvec3 corner, right, up;
  };
  const bool alongX = x.x >= z.z;
  const std::array<Face, 6> all = {{{kPlusX, low + x + z, -z, y},
                                    {kMinusX, low, z, y},
                                    alongX ? Face{kPlusY, low + y + z, x, -z} : Face{kPlusY, high, -z, -x},
                                    alongX ? Face{kMinusY, low, x, z} : Face{kMinusY, low + x, z, -x},
                                    {kPlusZ, low + z, x, y},
                                    {kMinusZ, low + x, -x, y}}};
  for (const Face& face : all)
    if (faces & face.bit)
      quad(face.corner, face.right, face.up, uv(face.bit, {glm::length(face.right), glm::length(face.up)}));
}

void MeshBuilder::lathe(const std::vector<glm::dvec2>& profile, const std::vector<glm::dvec2>& profileNormals,
                        int slices) {
  const auto first = static_cast<std::uint32_t>(mesh_.positions.size());
  const auto width = static_cast<std::uint32_t>(slices) + 1;
  const double bottom = profile.front().y, height = profile.back().y - bottom;
  for (std::size_t i = 0; i < profile.size(); ++i) {
    for (std::uint32_t slice = 0; slice < width; ++slice) {
      const double u = static_cast<double>(slice) / slices;
      const double angle = slice + 1 == width ? 0.0 : kTwoPi * u;  // the seam closes exactly
      const glm::dvec3 out(std::sin(angle), 0.0, std::cos(angle));
      const glm::dvec3 up(0.0, 1.0, 0.0);
      vertex(profile[i].x * out + profile[i].y * up, profileNormals[i].x * out + profileNormals[i].y * up,
             {u, height > 0.0 ? 1.0 - (profile[i].y - bottom) / height : u});
    }
  }
  for (std::uint32_t row = 0; row + 1 < profile.size(); ++row) {
    for (std::uint32_t slice = 0; slice + 1 < width; ++slice) {
      const std::uint32_t a = first + row * width + slice;
      if (profile[row].x > 0.0)
        for (std::uint32_t index : {a, a + 1, a + width + 1}) mesh_.indices.push_back(index);
      if (profile[row + 1].x > 0.0)
        for (std::uint32_t index : {a, a + width + 1, a + width}) mesh_.indices.push_back(index);
    }
  }
}

void MeshBuilder::disc(glm::dvec3 center, double radius, int slices, double metres) {
  const glm::dvec3 up(0.0, 1.0, 0.0);
  const std::uint32_t middle = vertex(center, up, {center.x / metres, center.z / metres});
  for (int slice = 0; slice < slices; ++slice) {
    const double angle = kTwoPi * slice / slices;
    const glm::dvec3 p = center + radius * glm::dvec3(std::sin(angle), 0.0, std::cos(angle));
    vertex(p, up, {p.x / metres, p.z / metres});
    const auto a = static_cast<std::uint32_t>(slice), b = static_cast<std::uint32_t>((slice + 1) % slices);
    for (std::uint32_t index : {middle, middle + 1 + a, middle + 1 + b}) mesh_.indices.push_back(index);
  }
}

Mesh MeshBuilder::finish(std::string name, int material) && {
  mesh_.name = std::move(name);
  mesh_.material = material;
  return std::move(mesh_);
}

MeshBuilder sphere(double radius, int slices) {
  const int stacks = slices / 2;
  std::vector<glm::dvec2> profile, normals;
  for (int stack = 0; stack <= stacks; ++stack) {
    const double angle = 0.5 * kTwoPi * stack / stacks;
    const bool pole = stack == 0 || stack == stacks;
    const glm::dvec2 normal(pole ? 0.0 : std::sin(angle), stack == stacks ? 1.0 : -std::cos(angle));
    normals.push_back(normal);
    profile.push_back(radius * normal);
  }
  MeshBuilder builder;
  builder.lathe(profile, normals, slices);
  return builder;
}

}  // namespace boxprobe::scenes
