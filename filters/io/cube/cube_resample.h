// Resamples environments between layouts while preserving energy: pictures to OpenGL's cubes and back.
#pragma once

#include <functional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/cube/cube_layout.h"

namespace boxprobe {

/// The interpolated value in a direction.
using DirectionSampler = std::function<glm::vec4(const glm::vec3& direction)>;

/// Samples a cube in OpenGL's orientation whose texels lie on the edges of its faces, level 0 of `faces`. `faces` and,
/// below, `picture` must outlive the sampler.
DirectionSampler edgeCubeSampler(const CubeMap& faces);
/// Interpolates across the seam for texels at centres; with texels at the edges the first and last column are the same
/// direction.
DirectionSampler latLongSampler(const ImageRgbaF& picture, TexelPlacement placement);

/// Samples needed along a side of a target texel if the source's texels are `ratio` times as dense: one if it is not
/// denser (interpolation alone preserves the sum), else two per source texel.
int samplesForRatio(double ratio);

/// Takes `samples`² per texel, weighted by solid angle. One level.
CubeMap resampleToCube(const DirectionSampler& source, int faceSize, int samples);

/// One face of `size`² texels in OpenEXR's orientation, as interleaved RGBA rows.
void resampleToOpenExrFace(const DirectionSampler& source, int face, int size, int samples, float* rgba);

/// A latitude-longitude picture in OpenEXR's convention, texels on its edges.
ImageRgbaF resampleToLatLong(const DirectionSampler& source, int width, int height, int samples);

}  // namespace boxprobe
