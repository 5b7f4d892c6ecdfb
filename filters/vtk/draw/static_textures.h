// The textures draws read whatever the scene: the split-sum table, a black cube that stands in for maps not captured
// yet, and, for techniques that draw samples, the blue-noise mask.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "filters/vtk/draw/frame_counts.h"
#include "filters/vtk/draw/scene_resources.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Once; the context must be current. A driver that filters no seamless cubes is noted in `counts`.
void makeStaticTextures(vtkOpenGLRenderWindow* window, SceneResources& resources, FrameCounts& counts);
/// Another table in place of that of the split sum; see SceneRenderer::lightAsVtk.
void uploadSplitSumTable(vtkOpenGLRenderWindow* window, GLuint texture, int columns, int rows,
                         const std::vector<glm::vec2>& table);
/// Once, and only if a technique wants it; the context must be current.
void makeBlueNoise(vtkOpenGLRenderWindow* window, SceneResources& resources);
void releaseStaticTextures(SceneResources& resources);

}  // namespace boxprobe
