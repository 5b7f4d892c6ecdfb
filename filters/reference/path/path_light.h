// The sources of light: emissive triangles, the scene's light sources, the sky. Each can be sampled and gives its
// sampling density in a direction, so that a ray that meets it by chance can be weighted against that.
#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <optional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/core/scene/scene.h"
#include "filters/reference/path/path_surface.h"

namespace boxprobe {

/// Draws indices in proportion to weights; never one of weight 0.
class DiscreteDistribution {
 public:
  explicit DiscreteDistribution(const std::vector<double>& weights);
  bool empty() const { return sums_.empty() || sums_.back() <= 0.0; }
  double whole() const { return sums_.empty() ? 0.0 : sums_.back(); }
  /// The index at `u` in [0, 1); `u` is rescaled to [0, 1) over that index's share.
  std::size_t at(double& u) const;
  double share(std::size_t i) const { return (sums_[i] - (i > 0 ? sums_[i - 1] : 0.0)) / sums_.back(); }

 private:
  std::vector<double> sums_;
};

/// The sky's radiance, sampled by brightness.
class PathSky {
 public:
  PathSky(const Scene& scene, std::shared_ptr<const ImageRgbaF> image);
  glm::dvec3 radiance(const glm::dvec3& direction) const;  ///< unit
  bool black() const { return cells_.empty(); }
  double mean() const { return mean_; }  ///< over all directions
  glm::dvec3 sample(const glm::dvec2& u, double& density) const;
  double density(const glm::dvec3& direction) const;

 private:
  static constexpr int kColumns = 256, kRows = 128;
  double cellAngle() const;  ///< solid angle of a cell: all are equal
  Sky sky_;
  std::shared_ptr<const ImageRgbaF> image_;
  double turn_ = 0.0;  ///< radians
  double mean_ = 0.0;
  DiscreteDistribution cells_;
};

class PathLights {
 public:
  PathLights(const Scene& scene, const PathScene& triangles, std::shared_ptr<const ImageRgbaF> skyImage);

  /// Is there no source of light at all?
  bool dark() const { return kinds_.empty() && !unlit_; }
  const PathSky& sky() const { return sky_; }

  struct Aim {
    glm::dvec3 direction{0.0};  ///< unit, towards the light
    double distance = 0.0;      ///< to it; infinite for the sky and the sun
    glm::dvec3 radiance{0.0};   ///< over `density`
    double density = 0.0;       ///< over directions; 0: a light without a size, which no ray meets by chance
    int object = -1;            ///< of an emissive triangle
    bool source = false;        ///< one of the scene's light sources
  };
  /// Samples light for a point, relative to the anchor; `which` selects the source. Nothing: the sample gives no light
  /// here.
  std::optional<Aim> aim(const glm::dvec3& from, double which, const glm::dvec2& u) const;

  /// The density of aim() at the point of an emissive triangle that a ray has hit, seen from the ray's start.
  double lampDensity(const PathHit& hit, const glm::dvec3& direction) const;
  double skyDensity(const glm::dvec3& direction) const;
  /// Light sources with a size that a ray from `from` of length `distance` meets: their light, and the sampling density
  /// of each.
  struct Met {
    glm::dvec3 radiance{0.0};
    double density = 0.0;
  };
  void meet(const glm::dvec3& from, const glm::dvec3& direction, double distance, std::vector<Met>& met) const;

 private:
  struct Source {
    Light light;
    glm::dvec3 position{0.0};   ///< relative to the anchor
    glm::dvec3 direction{0.0};  ///< unit, in which the light travels
    glm::dvec3 power{0.0};      ///< radiant intensity, or irradiance at normal incidence
    double cosine = 1.0;        ///< of half the angle of a directional light's disc
    bool sized = false;
  };
  struct Lamp {
    int object = 0;
    std::uint32_t triangle = 0;
    glm::dvec3 corner{0.0}, along{0.0}, up{0.0}, normal{0.0};
    double area = 0.0;
    bool both = false;  ///< emits on both sides
  };
  std::optional<Aim> aimLamp(const glm::dvec3& from, double which, const glm::dvec2& u) const;
  std::optional<Aim> aimSource(const glm::dvec3& from, std::size_t index, const glm::dvec2& u) const;
  /// The falloff of a point or spot light besides 1 / d²: its range and its cone.
  static double falloff(const Source& source, const glm::dvec3& toLight, double distance);

  const PathScene& scene_;
  PathSky sky_;
  std::vector<Source> sources_;
  std::vector<Lamp> lamps_;
  DiscreteDistribution byPower_;          ///< lamps
  std::vector<std::vector<int>> lampOf_;  ///< per object and triangle; -1: none
  DiscreteDistribution kinds_;            ///< lamps, sky, each source
  bool unlit_ = false;                    ///< unlit surfaces emit: rays meet them by chance only
};

}  // namespace boxprobe
