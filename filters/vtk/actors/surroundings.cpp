#include "filters/vtk/actors/surroundings.h"

#include <vtkAlgorithm.h>
#include <vtkDataArray.h>
#include <vtkImageData.h>
#include <vtkOpenGLRenderer.h>
#include <vtkPBRPrefilterTexture.h>
#include <vtkPointData.h>
#include <vtkRenderer.h>
#include <vtkTexture.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <optional>

#include "filters/math/cube/srgb.h"
#include "filters/vtk/maps/content_hash.h"

namespace boxprobe {

namespace {

constexpr double kPi = 3.14159265358979323846;

/// The middle of VTK's latitude-longitude pictures is +x, that of ours +z: a quarter turn about +y.
const glm::dmat3 kQuarter(glm::dvec3(0.0, 0.0, 1.0), glm::dvec3(0.0, 1.0, 0.0), glm::dvec3(-1.0, 0.0, 0.0));

/// The axes of VTK's environment lookups: right, up and their cross product.
glm::dmat3 environmentFromWorld(vtkRenderer* renderer) {
  const double* r = renderer->GetEnvironmentRight();
  const double* u = renderer->GetEnvironmentUp();
  const glm::dvec3 right(r[0], r[1], r[2]), up(u[0], u[1], u[2]);
  return glm::transpose(glm::dmat3(right, up, glm::cross(right, up)));
}

glm::vec3 linearOfDisplay(const double* color, Tone tone) {
  glm::vec3 linear;
  for (int i = 0; i < 3; ++i) {
    const double shown = std::max(color[i], 0.0);
    linear[i] = static_cast<float>(tone == Tone::AsVtk ? std::pow(shown, 2.2) : linearOfSrgbValue(shown));
  }
  return linear;
}

/// A texture's input as linear colours, rows from the bottom up as in VTK.
struct Pixels {
  int width = 0, height = 0;
  std::vector<glm::vec3> colors;
  glm::vec3 at(double u, double v, bool around) const;
};

glm::vec3 Pixels::at(double u, double v, bool around) const {
  const double x = u * width - 0.5, y = v * height - 0.5;
  const auto pick = [&](int column, int row) {
    column = around ? (column % width + width) % width : std::clamp(column, 0, width - 1);
    row = std::clamp(row, 0, height - 1);
    return colors[static_cast<std::size_t>(row) * static_cast<std::size_t>(width) + static_cast<std::size_t>(column)];
  };
  const int left = static_cast<int>(std::floor(x)), low = static_cast<int>(std::floor(y));
  const auto s = static_cast<float>(x - left), t = static_cast<float>(y - low);
  return (1.0f - t) * ((1.0f - s) * pick(left, low) + s * pick(left + 1, low)) +
         t * ((1.0f - s) * pick(left, low + 1) + s * pick(left + 1, low + 1));
}

/// How a texture's values become linear light.
enum class Encoding { Linear, Srgb, Gamma };

/// SetEnvironmentTexture(texture, true) tells VTK's filters, but not the texture, that values have a power of 2.2.
Encoding encodingOf(vtkTexture* texture, vtkRenderer* renderer) {
  auto* openGl = vtkOpenGLRenderer::SafeDownCast(renderer);
  if (texture->GetUseSRGBColorSpace()) return Encoding::Srgb;
  return openGl != nullptr && openGl->GetEnvMapPrefiltered()->GetConvertToLinear() ? Encoding::Gamma : Encoding::Linear;
}

float linearOf(float value, Encoding encoding) {
  if (encoding == Encoding::Linear) return value;
  return encoding == Encoding::Srgb ? static_cast<float>(linearOfSrgbValue(value)) : std::pow(value, 2.2f);
}

std::optional<Pixels> pixelsOf(vtkTexture* texture, int port, Encoding encoding) {
  if (texture->GetNumberOfInputPorts() <= port || texture->GetNumberOfInputConnections(port) == 0) return {};
  vtkAlgorithm* source = texture->GetInputAlgorithm(port, 0);
  if (source == nullptr) return {};
  source->Update();
  auto* image = vtkImageData::SafeDownCast(texture->GetInputDataObject(port, 0));
  vtkDataArray* scalars = image != nullptr ? image->GetPointData()->GetScalars() : nullptr;
  if (scalars == nullptr) return {};
  int size[3];
  image->GetDimensions(size);
  Pixels pixels{size[0], size[1], {}};
  const auto count = static_cast<std::size_t>(size[0]) * static_cast<std::size_t>(size[1]);
  const int components = scalars->GetNumberOfComponents();
  if (count == 0 || components < 1 || static_cast<std::size_t>(scalars->GetNumberOfTuples()) < count) return {};
  const int type = scalars->GetDataType();
  const double whole = type == VTK_UNSIGNED_CHAR ? 255.0 : type == VTK_UNSIGNED_SHORT ? 65535.0 : 1.0;
  pixels.colors.resize(count);
  for (std::size_t i = 0; i < count; ++i) {
    for (int c = 0; c < 3; ++c) {
      const double value = scalars->GetComponent(static_cast<vtkIdType>(i), components >= 3 ? c : 0) / whole;
      const auto color = static_cast<float>(std::isfinite(value) ? std::max(value, 0.0) : 0.0);
      pixels.colors[i][c] = linearOf(color, encoding);
    }
  }
  return pixels;
}

std::shared_ptr<ImageRgbaF> blank(int width, int height) {
  auto image = std::make_shared<ImageRgbaF>();
  image->width = width;
  image->height = height;
  image->pixels.assign(static_cast<std::size_t>(width) * static_cast<std::size_t>(height) * 4, 1.0f);
  return image;
}

void put(ImageRgbaF& image, int column, int row, const glm::vec3& color) {
  float* to = &image.pixels[(static_cast<std::size_t>(row) * static_cast<std::size_t>(image.width) +
                             static_cast<std::size_t>(column)) *
                            4];
  for (int c = 0; c < 3; ++c) to[c] = color[c];
}

std::shared_ptr<const ImageRgbaF> turnedOver(const Pixels& pixels) {
  auto image = blank(pixels.width, pixels.height);
  for (int row = 0; row < pixels.height; ++row) {
    for (int column = 0; column < pixels.width; ++column) {
      put(*image, column, row,
          pixels.colors[static_cast<std::size_t>(pixels.height - 1 - row) * static_cast<std::size_t>(pixels.width) +
                        static_cast<std::size_t>(column)]);
    }
  }
  return image;
}

/// Samples OpenGL's faces, as VTK 9.1 does.
glm::vec3 ofCube(const std::array<Pixels, 6>& faces, const glm::dvec3& d) {
  const glm::dvec3 a = glm::abs(d);
  int face = 0;
  double s = 0.0, t = 0.0, along = 1.0;
  if (a.x >= a.y && a.x >= a.z) {
    face = d.x > 0.0 ? 0 : 1;
    along = a.x;
    s = d.x > 0.0 ? -d.z : d.z;
    t = -d.y;
  } else if (a.y >= a.z) {
    face = d.y > 0.0 ? 2 : 3;
    along = a.y;
    s = d.x;
    t = d.y > 0.0 ? d.z : -d.z;
  } else {
    face = d.z > 0.0 ? 4 : 5;
    along = a.z;
    s = d.z > 0.0 ? d.x : -d.x;
    t = -d.y;
  }
  return faces[static_cast<std::size_t>(face)].at(0.5 + 0.5 * s / along, 0.5 + 0.5 * t / along, false);
}

/// In our convention: +z in the middle, +x to its left.
std::shared_ptr<const ImageRgbaF> unrolled(const std::array<Pixels, 6>& faces) {
  const int height = std::min(4 * faces[0].height, 2048);
  auto image = blank(2 * height, height);
  for (int row = 0; row < height; ++row) {
    const double latitude = kPi * (0.5 - (row + 0.5) / height);
    for (int column = 0; column < image->width; ++column) {
      const double longitude = 2.0 * kPi * (0.5 - (column + 0.5) / image->width);
      const double c = std::cos(latitude);
      put(*image, column, row, ofCube(faces, {c * std::sin(longitude), std::sin(latitude), c * std::cos(longitude)}));
    }
  }
  return image;
}

/// Changes with the texture's contents.
std::string keyOf(vtkTexture* texture, vtkRenderer* renderer) {
  ContentHash hash;
  const vtkTexture* address = texture;
  hash.addBytes(&address, sizeof address).add(static_cast<double>(texture->GetMTime()));
  hash.add(static_cast<double>(encodingOf(texture, renderer))).add(static_cast<double>(texture->GetCubeMap()));
  for (int port = 0; port < texture->GetNumberOfInputPorts(); ++port) {
    if (texture->GetNumberOfInputConnections(port) == 0) continue;
    if (vtkAlgorithm* source = texture->GetInputAlgorithm(port, 0)) source->Update();
    if (vtkDataObject* data = texture->GetInputDataObject(port, 0)) hash.add(static_cast<double>(data->GetMTime()));
  }
  return hash.text();
}

}  // namespace

void RendererSurroundings::readTexture(vtkTexture* texture, vtkRenderer* renderer) {
  const Encoding encoding = encodingOf(texture, renderer);
  light_ = {};
  if (texture->GetCubeMap()) {
    std::array<Pixels, 6> faces;
    for (int face = 0; face < 6; ++face) {
      std::optional<Pixels> pixels = pixelsOf(texture, face, encoding);
      if (!pixels) {
        problem_ = "the renderer's environment texture has no image for face " + std::to_string(face) +
                   " of its cube; set its six inputs";
        return;
      }
      faces[static_cast<std::size_t>(face)] = std::move(*pixels);
    }
    light_.image = unrolled(faces);
  } else {
    const std::optional<Pixels> pixels = pixelsOf(texture, 0, encoding);
    if (!pixels) {
      problem_ = "the renderer's environment texture has no image as input; set one with SetInputConnection()";
      return;
    }
    light_.image = turnedOver(*pixels);
  }
}

bool RendererSurroundings::read(vtkRenderer* renderer, Tone tone) {
  vtkTexture* texture = renderer->GetUseImageBasedLighting() ? renderer->GetEnvironmentTexture() : nullptr;
  ContentHash hash;
  const std::string textureKey = texture != nullptr ? keyOf(texture, renderer) : std::string();
  hash.add(textureKey);
  for (const double* axis : {renderer->GetEnvironmentUp(), renderer->GetEnvironmentRight(), renderer->GetBackground(),
                             renderer->GetBackground2()}) {
    for (int i = 0; i < 3; ++i) hash.add(axis[i]);
  }
  hash.add(static_cast<double>(renderer->GetGradientBackground())).add(tone == Tone::AsVtk ? 1.0 : 0.0);
  const std::string key = hash.text();
  if (key == key_) return false;
  key_ = key;

  if (textureKey != textureKey_) {
    textureKey_ = textureKey;
    problem_.clear();
    light_ = {};
    if (texture != nullptr) readTexture(texture, renderer);
  }
  lit_ = light_.image != nullptr;
  const glm::dmat3 axes = environmentFromWorld(renderer);
  if (lit_) light_.pictureFromWorld = texture->GetCubeMap() ? axes : kQuarter * axes;
  background_ = {};
  const glm::vec3 low = linearOfDisplay(renderer->GetBackground(), tone),
                  high = linearOfDisplay(renderer->GetBackground2(), tone);
  background_.sky = SkyColor{low};
  if (renderer->GetGradientBackground()) background_.sky = SkyGradient{high, 0.5f * (low + high), low};
  background_.pictureFromWorld = axes;
  return true;
}

}  // namespace boxprobe
