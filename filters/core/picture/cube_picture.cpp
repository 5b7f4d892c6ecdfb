// See cube_picture.h.
#include "filters/core/picture/cube_picture.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "filters/math/shared/display_math.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// The tile of each face in the cross, in columns and rows of tiles.
constexpr std::array<std::array<int, 2>, 6> kTiles = {{{0, 1}, {2, 1}, {1, 0}, {1, 2}, {1, 1}, {3, 1}}};

glm::vec3 directionOf(const CubePoint& point) {
  return shading::cubeDirection(point.face, point.s, point.t);
}

/// The mean of the texels that a rectangle of a face, in texels, touches; the texel it lies in if it is smaller than
/// one.
glm::vec4 average(const CubeMap& cube, int level, int face, const glm::dvec2& from, const glm::dvec2& to) {
  const int last = cube.levelSize(level) - 1;
  // A pixel that grazes a texel must not count it in full: texels covered by less than half are left out.
  const auto first = [last](double x) { return std::clamp(static_cast<int>(std::floor(x + 0.5)), 0, last); };
  const auto end = [](double x, int begin) { return std::max(static_cast<int>(std::ceil(x - 0.5)), begin + 1); };
  const bool magnified = to.x - from.x <= 1.0;
  const glm::dvec2 middle = 0.5 * (from + to);
  const int c0 = magnified ? std::clamp(static_cast<int>(middle.x), 0, last) : first(from.x);
  const int r0 = magnified ? std::clamp(static_cast<int>(middle.y), 0, last) : first(from.y);
  const int c1 = magnified ? c0 + 1 : std::min(end(to.x, c0), last + 1);
  const int r1 = magnified ? r0 + 1 : std::min(end(to.y, r0), last + 1);
  glm::vec4 sum(0.0f);
  for (int r = r0; r < r1; ++r) {
    for (int c = c0; c < c1; ++c) sum += cube.texel(level, face, c, r);
  }
  return sum / static_cast<float>((c1 - c0) * (r1 - r0));
}

/// Calls `put` for every pixel of a face's tile, from the tile's top left.
template <typename Put>
void drawTile(const CubeMap& cube, int level, int face, int tile, const Put& put) {
  const double texels = static_cast<double>(cube.levelSize(level)) / tile;
  for (int y = 0; y < tile; ++y) {
    for (int x = 0; x < tile; ++x) {
      const int mirrored = tile - 1 - x;
      const glm::dvec2 from(mirrored * texels, y * texels);
      put(x, y, average(cube, level, face, from, from + glm::dvec2(texels)));
    }
  }
}

bool atPole(const glm::vec3& direction) {
  return direction.x == 0.0f && direction.z == 0.0f;
}

/// Samples along each side of a pixel so that no texel at the map's middle is skipped; bounded, because a picture much
/// smaller than its map needs no precision.
int latLongSamples(int faceSize, int width) {
  constexpr int kMost = 8;
  return std::clamp((4 * faceSize + width - 1) / width, 1, kMost);
}

glm::vec4 latLongPixel(const CubeMap& cube, int level, const CubePicture& picture, int x, int y, int samples) {
  if (samples == 1) return cube.fetch(*picture.direction({x + 0.5, y + 0.5}), static_cast<float>(level));
  const int size = cube.levelSize(level);
  const auto index = [size](float s) {
    return std::clamp(static_cast<int>((0.5f * s + 0.5f) * static_cast<float>(size)), 0, size - 1);
  };
  glm::vec4 sum(0.0f);
  for (int i = 0; i < samples * samples; ++i) {
    const glm::dvec2 at(x + (i % samples + 0.5) / samples, y + (i / samples + 0.5) / samples);
    const CubePoint point = cubePoint(*picture.direction(at));
    sum += cube.texel(level, point.face, index(point.s), index(point.t));
  }
  return sum / static_cast<float>(samples * samples);
}

}  // namespace

CubePicture::CubePicture(CubePictureKind kind, int width)
    : kind_(kind), width_(std::max(width & (kind == CubePictureKind::Cross ? ~3 : ~1), 4)) {}

glm::dvec2 CubePicture::facePosition(const CubePoint& point) const {
  if (kind_ == CubePictureKind::LatLong) return position(directionOf(point));
  const double tile = width_ / 4.0;
  const auto& place = kTiles[static_cast<std::size_t>(point.face)];
  return {(place[0] + 0.5 - 0.5 * static_cast<double>(point.s)) * tile,
          (place[1] + 0.5 + 0.5 * static_cast<double>(point.t)) * tile};
}

glm::dvec2 CubePicture::position(const glm::vec3& direction) const {
  if (kind_ == CubePictureKind::Cross) return facePosition(cubePoint(direction));
  const glm::dvec3 d(direction);
  const double longitude = d.x == 0.0 && d.z == 0.0 ? 0.0 : std::atan2(d.x, d.z);
  const double latitude = std::atan2(d.y, std::hypot(d.x, d.z));
  return {(0.5 - longitude / (2.0 * kPi)) * width_, (0.5 - latitude / kPi) * height()};
}

std::optional<glm::vec3> CubePicture::direction(const glm::dvec2& at) const {
  if (!(at.x >= 0.0 && at.y >= 0.0 && at.x <= width_ && at.y <= height())) return std::nullopt;
  if (kind_ == CubePictureKind::LatLong) {
    const double longitude = (0.5 - at.x / width_) * 2.0 * kPi;
    const double latitude = (0.5 - at.y / height()) * kPi;
    const double c = std::cos(latitude);
    return glm::vec3(glm::dvec3(std::sin(longitude) * c, std::sin(latitude), std::cos(longitude) * c));
  }
  const double tile = width_ / 4.0;
  const glm::dvec2 place = at / tile;
  for (std::size_t face = 0; face < kTiles.size(); ++face) {
    const glm::dvec2 inside = place - glm::dvec2(kTiles[face][0], kTiles[face][1]);
    if (inside.x < 0.0 || inside.y < 0.0 || inside.x > 1.0 || inside.y > 1.0) continue;
    return shading::cubeDirection(static_cast<int>(face), static_cast<float>(1.0 - 2.0 * inside.x),
                                  static_cast<float>(2.0 * inside.y - 1.0));
  }
  return std::nullopt;
}

std::vector<glm::dvec2> CubePicture::texelOutline(int faceSize, int face, int column, int row) const {
  const float step = 2.0f / static_cast<float>(faceSize);
  const float s0 = -1.0f + step * static_cast<float>(column), t0 = -1.0f + step * static_cast<float>(row);
  const std::array<glm::vec2, 4> corners = {{{s0, t0}, {s0 + step, t0}, {s0 + step, t0 + step}, {s0, t0 + step}}};
  if (kind_ == CubePictureKind::Cross) {
    std::vector<glm::dvec2> outline;
    for (const glm::vec2& corner : corners) outline.push_back(facePosition({face, corner.x, corner.y}));
    return outline;
  }
  // Great circles are curves on this map; near a pole even a small texel spans a large part of it.
  constexpr int kPieces = 16;
  std::vector<glm::vec3> border;
  for (std::size_t i = 0; i < 4; ++i) {
    for (int k = 0; k < kPieces; ++k) {
      const float along = static_cast<float>(k) / kPieces;
      const glm::vec2 st = corners[i] + along * (corners[(i + 1) % 4] - corners[i]);
      border.push_back(shading::cubeDirection(face, st.x, st.y));
    }
  }
  if (atPole(border.front())) std::rotate(border.begin(), border.begin() + 1, border.end());
  std::vector<glm::dvec2> outline = {position(border.front())};
  const auto add = [&](glm::dvec2 at) {
    at.x += width_ * std::round((outline.back().x - at.x) / width_);
    outline.push_back(at);
  };
  for (std::size_t i = 1; i < border.size(); ++i) {
    if (!atPole(border[i])) {
      add(position(border[i]));
      continue;
    }
    // A pole is the whole edge of the map: follow it from where the outline arrives to where it continues.
    const double edge = position(border[i]).y;
    add({outline.back().x, edge});
    add({position(border[(i + 1) % border.size()]).x, edge});
  }
  return outline;
}

ImageRgba8 drawCubePicture(const CubeMap& cube, int level, const CubePicture& picture, float exposure, Tone tone) {
  ImageRgba8 image{picture.width(), picture.height(), {}, {}};
  image.pixels.resize(static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height) * 4);
  if (cube.empty()) return image;
  const auto put = [&](int x, int y, const glm::vec4& value) {
    std::uint8_t* out = &image.pixels[(static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                                       static_cast<std::size_t>(x)) *
                                      4];
    const std::array<std::uint8_t, 3> shown = displayBytes(glm::vec3(value), exposure, tone);
    std::copy(shown.begin(), shown.end(), out);
    out[3] = 255;
  };
  if (picture.kind() == CubePictureKind::Cross) {
    const int tile = picture.width() / 4;
    for (int face = 0; face < 6; ++face) {
      const auto& place = kTiles[static_cast<std::size_t>(face)];
      drawTile(cube, level, face, tile,
               [&](int x, int y, const glm::vec4& value) { put(place[0] * tile + x, place[1] * tile + y, value); });
    }
    return image;
  }
  const int samples = latLongSamples(cube.levelSize(level), picture.width());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) put(x, y, latLongPixel(cube, level, picture, x, y, samples));
  }
  return image;
}

}  // namespace boxprobe
