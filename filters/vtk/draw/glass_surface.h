// What a surface that transmits light adds to its material: numbers for the shader, its shell on the graphics side.
// Filled by model_actors, read by the probe pass (uniforms), the splice (which code a program needs) and explanations.
// Knows no probe.
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

/// A shell and its texture, uploaded when a draw first needs it.
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
  GlassForm form = GlassForm::Automatic;  ///< once resolved: any but Automatic
  bool sheet = false;
  bool walls = false;  ///< a hollow solid, drawn by its walls as sheets, those behind others, too
  float ior = 1.5f;
  float transmission = 0.0f;
  float roughness = 0.0f;
  float thickness = 0.0f;            ///< scene units
  float attenuationDistance = 0.0f;  ///< scene units; 0: nothing is absorbed
  glm::vec3 attenuationColor{1.0f};
  glm::dvec3 middleWorld{0.0};
  float radius = 1.0f;
  std::shared_ptr<const GlassShellTexture> shell;  ///< of form TwoInterface; along the world's axes

  /// What a program is compiled for; 0: no glass.
  int variant() const;
  /// How far light may be turned for what is drawn behind to stand in for it: two texels of the cubemap it would be
  /// looked up in otherwise, radians.
  float straightAngle(int faceSize) const { return 4.0f / static_cast<float>(faceSize > 0 ? faceSize : 256); }
  /// As the shader has it, `eyeWorld` the origin of positions.
  shading::GlassObject object(const glm::dvec3& eyeWorld) const;

  ExplainedGlass explained(const glm::dvec3& eyeWorld, int faceSize) const;
  /// Does it bend or scatter, so that what is drawn behind has to be looked up? `textured`: roughness differs by place.
  bool looksBehind(bool textured) const;
  /// Of two passes: what the front faces leave of the back faces behind them.
  float behindShare() const;

  /// Follows an override, and the object where it stands. `mesh` is the object's own.
  void apply(const Material& material, const Mesh& mesh, const glm::dmat4& worldFromModel);

 private:
  glm::dmat3 builtFor_{0.0};  ///< the linear part of the placement that the shell was made for
};

/// "one-pass" ... as scene files have it.
std::string glassFormName(GlassForm form);

}  // namespace boxprobe
