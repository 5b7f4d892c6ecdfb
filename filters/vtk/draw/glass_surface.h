// The additional material properties of a surface that transmits light: values for the shader, and the object's shell
// as a texture. Set by model_actors, read for uniforms, shader variants and explanations.
#pragma once

#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>

#include "filters/core/scene/model.h"
#include "filters/explain/explain_glass.h"
#include "filters/math/cube/glass_shell.h"
#include "filters/vtk/gl/gl_objects.h"

namespace boxprobe {

/// A shell and its texture, uploaded at the first draw that needs it.
class GlassShellTexture {
 public:
  GlassShellTexture(const Mesh& mesh, const glm::dvec3& middle, const glm::dmat3& linear);
  const GlassShell& shell() const { return shell_; }
  /// The context must be current.
  GLuint handle() const;
  void release() const { texture_.release(); }

 private:
  GlassShell shell_;
  mutable CubeTexture texture_;
};

struct GlassSurface {
  bool drawn = false;                     ///< does the material transmit light?
  GlassForm form = GlassForm::Automatic;  ///< after resolution: any but Automatic
  bool sheet = false;
  bool walls = false;  ///< a hollow solid, drawn by its walls as sheets, including those behind others
  float ior = 1.5f;
  float transmission = 0.0f;
  float roughness = 0.0f;
  float thickness = 0.0f;            ///< scene units
  float attenuationDistance = 0.0f;  ///< scene units; 0: no absorption
  glm::vec3 attenuationColor{1.0f};
  glm::dvec3 middleWorld{0.0};
  float radius = 1.0f;
  std::shared_ptr<const GlassShellTexture> shell;  ///< for form TwoInterface; along the world's axes

  /// Selects the program; 0: no glass.
  int variant() const;
  /// The angle in radians up to which refracted light may be replaced by what is drawn straight behind: two texels of
  /// the cubemap that would be sampled otherwise.
  float straightAngle(int faceSize) const { return 4.0f / static_cast<float>(faceSize > 0 ? faceSize : 256); }
  /// As in the shader, relative to `eyeWorld`.
  shading::GlassObject object(const glm::dvec3& eyeWorld) const;

  ExplainedGlass explained(const glm::dvec3& eyeWorld, int faceSize) const;
  /// Does it refract or scatter, so that what is behind has to be sampled? `textured`: its roughness varies.
  bool looksBehind(bool textured) const;
  /// For two passes: the fraction of the back faces that shows through the front faces.
  float behindShare() const;

  /// Updates for an override and the object's placement. `mesh`: the object's own.
  void apply(const Material& material, const Mesh& mesh, const glm::dmat4& worldFromModel);

 private:
  glm::dmat3 builtFor_{0.0};  ///< linear part of the placement that the shell was made for
};

/// "one-pass" ... as in scene files.
std::string glassFormName(GlassForm form);

}  // namespace boxprobe
