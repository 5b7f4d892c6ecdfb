// Diffuse irradiance of a cubemap as nine spherical-harmonic coefficients. A small level is enough: faces of 8² to 16²
// hold more detail than nine coefficients can.
#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <vector>

namespace boxprobe {

using ShCoefficients = std::array<glm::vec3, 9>;

/// Radiance of six faces (RGBA float, faceSize² texels each, OpenGL face order and orientation) projected on the real
/// spherical harmonics of bands 0 to 2 and convolved with the clamped cosine over pi, with the constants folded in:
/// shIrradiance (shaders/shared/sh.glsl) gives irradiance over pi, and a constant radiance L gives L for every normal.
/// `worldFromMap`: rotation from the faces' axes to the world's, which normals are in. Ramamoorthi and Hanrahan 2001;
/// texels are weighted by their exact solid angles.
ShCoefficients irradianceCoefficients(const std::array<std::vector<float>, 6>& faces, int faceSize,
                                      const glm::dmat3& worldFromMap = glm::dmat3(1.0));

}  // namespace boxprobe
