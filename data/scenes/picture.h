// Pictures painted by formula: a pattern gives the linear colour at a point, `paint` filters it down to texels and
// encodes them as sRGB. Called by the scenes and the GLB writer; knows nothing of geometry.
#pragma once

#include <functional>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "filters/core/scene/model.h"

namespace boxprobe::scenes {

/// Linear colour at (u, v) in [0, 1]², u from the left, v from the top.
using Pattern = std::function<glm::dvec3(double u, double v)>;

/// Each texel is the mean of `samples` x `samples` samples of the pattern.
std::shared_ptr<const ImageRgba8> paint(const std::string& name, int width, int height, const Pattern& pattern,
                                        int samples = 4);

/// Numbers in [0, 1] and no colours, such as roughness: stored as they are, one sample a texel.
std::shared_ptr<const ImageRgba8> paintNumbers(const std::string& name, int width, int height, const Pattern& pattern);

/// RGB when every texel is opaque, else RGBA.
std::string pngBytes(const ImageRgba8& image);

/// JPEG of `quality` 1 to 100; alpha is left out.
std::string jpegBytes(const ImageRgba8& image, int quality);

/// Radiance HDR; `rgb` is linear, rows from the top.
std::string hdrBytes(int width, int height, const std::vector<float>& rgb);

/// 0 below `edge`, 1 above, rising smoothly over `width`: edges that sampling can follow.
double softStep(double edge, double width, double x);

/// 1 within `halfWidth` of the nearest multiple of `period`, soft over `width`.
double softLines(double x, double period, double halfWidth, double width);

/// Uniform in [0, 1), a fixed function of three integers.
double hash(int x, int y, int seed);

/// Smooth noise in [0, 1] with one value each unit, repeating every `periodX` and `periodY` units.
double noise(double x, double y, int periodX, int periodY, int seed);

glm::dvec3 blend(glm::dvec3 from, glm::dvec3 to, double amount);

}  // namespace boxprobe::scenes
