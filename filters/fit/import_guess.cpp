#include "filters/fit/import_guess.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/vec4.hpp>

#include "filters/core/base/file_extension.h"
#include "filters/core/base/number_text.h"
#include "filters/core/geometry/model_placement.h"

namespace boxprobe {

namespace {

double largestSide(const Box& bounds) {
  const glm::dvec3 size = bounds.size();
  return std::max({size.x, size.y, size.z});
}

/// Limits in metres for the longest side of typical models.
struct Plausible {
  double most;         ///< larger models probably have the wrong unit
  double centimetres;  ///< up to this size the unit is probably the centimetre
};

Plausible plausibleSize(ModelKind kind, bool saysMetres) {
  if (kind == ModelKind::Interior) return {120.0, 6000.0};
  if (kind == ModelKind::Open) return {3000.0, 6000.0};
  // glTF files are in metres by definition: only extreme sizes are questioned.
  return saysMetres ? Plausible{150.0, 500.0} : Plausible{20.0, 500.0};
}

/// The projected area of all triangles along each world axis.
glm::dvec3 areasAlongAxes(const Scene& scene, const TriangleRays::Models& models) {
  glm::dvec3 areas(0.0);
  for (std::size_t i = 0; i < models.size(); ++i) {
    const glm::dmat4 placement = worldFromFile(scene.models[i]);
    for (const Instance& instance : models[i]->instances) {
      const glm::dmat4 world = placement * instance.worldFromModel;
      const Mesh& mesh = models[i]->meshes[static_cast<std::size_t>(instance.mesh)];
      const auto corner = [&](std::size_t at) {
        return glm::dvec3(world * glm::dvec4(glm::dvec3(mesh.positions[mesh.indices[at]]), 1.0));
      };
      for (std::size_t at = 0; at + 2 < mesh.indices.size(); at += 3) {
        const glm::dvec3 a = corner(at);
        const glm::dvec3 area = 0.5 * glm::cross(corner(at + 1) - a, corner(at + 2) - a);
        if (std::isfinite(area.x + area.y + area.z)) areas += glm::abs(area);
      }
    }
  }
  return areas;
}

/// Does it begin at 0 along this axis, as objects on a floor do?
bool standsOn(const Box& bounds, int axis) {
  return std::abs(bounds.min[axis]) <= 0.02 * bounds.size()[axis];
}

/// Is the file's up axis +Z rather than +Y?
bool zIsUp(const Scene& scene, const TriangleRays::Models& models, const std::string& extension, ModelKind kind,
           const Box& bounds) {
  const glm::dvec3 size = bounds.size();
  const bool onY = standsOn(bounds, 1), onZ = standsOn(bounds, 2);
  const bool saysUp = extension == ".glb" || extension == ".gltf";
  // Stands on z = 0 and extends below y = 0. So does a picture on a wall, but rarely in metres with Y up.
  if (onZ && !onY && bounds.min.y < -0.2 * size.y && (!saysUp || kind == ModelKind::Interior)) return true;
  if (onY && !onZ) return false;
  // Rooms are lower than wide, and have more floor and ceiling than wall along any one axis.
  if (kind != ModelKind::Interior) return false;
  const bool lowest = size.z <= 0.6 * std::min(size.x, size.y);
  if (!lowest) return false;
  const glm::dvec3 areas = areasAlongAxes(scene, models);
  return areas.z >= 1.5 * std::max(areas.x, areas.y);
}

}  // namespace

LengthUnit likelyUnit(const std::string& file, ModelKind kind, double largest) {
  const std::string extension = lowerExtension(file);
  const bool saysMetres = extension == ".glb" || extension == ".gltf";
  const Plausible size = plausibleSize(kind, saysMetres);
  if (largest <= size.most) return LengthUnit::Metre;
  // Models for 3D printing are drawn in millimetres.
  if (extension == ".stl" && kind == ModelKind::Object) return LengthUnit::Millimetre;
  return largest <= size.centimetres ? LengthUnit::Centimetre : LengthUnit::Millimetre;
}

Phrase extentText(const Box& bounds) {
  const double largest = largestSide(bounds);
  const double digits = largest > 0.0 ? std::pow(10.0, std::floor(std::log10(largest)) - 1.0) : 1.0;
  const bool high = bounds.size().y >= largest;
  return (high ? Phrase::tr("%1 m high") : Phrase::tr("%1 m wide"))
      .arg(numberText(std::round(largest / digits) * digits));
}

std::optional<ImportGuess> guessImport(const Scene& scene, const TriangleRays::Models& models, ModelKind kind,
                                       const Box& bounds) {
  if (models.empty() || !(largestSide(bounds) > 0.0)) return std::nullopt;
  const ModelFile& file = scene.models.front();
  if (file.unit != LengthUnit::Metre || file.upAxis != UpAxis::Y || file.scale != 1.0 ||
      file.rotationDegrees != glm::dvec3(0.0)) {
    return std::nullopt;
  }
  const std::string extension = lowerExtension(file.file);
  ImportGuess guess;
  guess.unit = likelyUnit(file.file, kind, largestSide(bounds));
  const bool turned = zIsUp(scene, models, extension, kind, bounds);
  if (turned) guess.upAxis = UpAxis::Z;
  if (guess.unit == LengthUnit::Metre && !turned) return std::nullopt;
  guess.reason = guess.unit == LengthUnit::Metre ? Phrase::tr("It seems to lie on its side")
                 : turned ? Phrase::tr("In metres it would be %1, and it seems to lie on its side")
                          : Phrase::tr("In metres it would be %1");
  guess.reason = guess.reason.arg(extentText(bounds));
  return guess;
}

}  // namespace boxprobe
