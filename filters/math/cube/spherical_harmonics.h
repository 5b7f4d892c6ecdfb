// Diffuse irradiance of a cubemap as nine spherical-harmonic coefficients. CPU only, no VTK: called once a capture with
// a small level (8² to 16² faces hold more than the nine coefficients can).
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

using ShCoefficients = std::array<glm::vec3, 9>;

/// Radiance of six faces (RGBA float, faceSize² texels each, OpenGL face order and orientation) projected on the real
/// spherical harmonics of bands 0 to 2 and convolved with the clamped cosine over pi, constants folded in, so that
/// shIrradiance (shaders/shared/sh.glsl) gives the irradiance over pi: a constant radiance L gives L for every normal.
/// `worldFromMap`: rotation of the faces' axes; normals are the world's.
/// Ramamoorthi and Hanrahan 2001; each texel weighs its exact solid angle.
ShCoefficients irradianceCoefficients(const std::array<std::vector<float>, 6>& faces, int faceSize,
                                      const glm::dmat3& worldFromMap = glm::dmat3(1.0));

}  // namespace boxprobe
