// Surroundings from one set of directions to another without losing energy: pictures to OpenGL's cubes and back.
// Called by the readers and writers of cubes; knows no files.
#pragma once

#include <functional>
#include <vector>

#include "filters/core/scene/model.h"
#include "filters/io/cube/cube_layout.h"

namespace boxprobe {

/// The value in a direction, interpolated.
using DirectionSampler = std::function<glm::vec4(const glm::vec3& direction)>;

/// A cube whose texels lie on the edges of its faces, in OpenGL's orientation, level 0 of `faces`. Both must outlive
/// the sampler; so for the next one.
DirectionSampler edgeCubeSampler(const CubeMap& faces);
/// Around the seam for texels at centres; with texels at the edges the first and last column are the same direction.
DirectionSampler latLongSampler(const ImageRgbaF& picture, TexelPlacement placement);

/// How many samples along a side of a target texel a source needs whose texels are `ratio` times as dense there: one
/// where it is not denser (interpolation alone keeps the sum), else two for each of its texels.
int samplesForRatio(double ratio);

/// `samples`² in each texel, each with its solid angle. One level.
CubeMap resampleToCube(const DirectionSampler& source, int faceSize, int samples);

/// The picture of one face of `size`² texels as OpenEXR has it, into interleaved RGBA rows.
void resampleToOpenExrFace(const DirectionSampler& source, int face, int size, int samples, float* rgba);

/// A latitude-longitude picture as OpenEXR has it, texels on its edges.
ImageRgbaF resampleToLatLong(const DirectionSampler& source, int width, int height, int samples);

}  // namespace boxprobe
