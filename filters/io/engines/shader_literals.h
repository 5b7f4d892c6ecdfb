// Numbers as the text of a shader.
#pragma once

#include <glm/vec3.hpp>
#include <string>

namespace boxprobe {

/// With a point and the suffix f, as GLSL, HLSL and Godot read it. Rounded to single precision.
std::string shaderNumber(double value);

/// "vec3(x, y, z)".
std::string shaderVector(const glm::dvec3& v);

}  // namespace boxprobe
