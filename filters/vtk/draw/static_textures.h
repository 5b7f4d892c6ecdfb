// Textures that do not depend on the scene: the split-sum table, a black cube in place of maps that are not captured
// yet, and the blue-noise mask for sampling techniques.
#pragma once

#include <glm/vec2.hpp>
#include <vector>

#include "filters/vtk/draw/frame_counts.h"
#include "filters/vtk/draw/scene_resources.h"

class vtkOpenGLRenderWindow;

namespace boxprobe {

/// Makes them once; the context must be current. A driver without seamless cubemap filtering is reported in `counts`.
void makeStaticTextures(vtkOpenGLRenderWindow* window, SceneResources& resources, FrameCounts& counts);
/// Replaces the split-sum table; see SceneRenderer::useVtkLighting.
void uploadSplitSumTable(vtkOpenGLRenderWindow* window, GLuint texture, int columns, int rows,
                         const std::vector<glm::vec2>& table);
/// Makes it once, only if a technique needs it; the context must be current.
void makeBlueNoise(vtkOpenGLRenderWindow* window, SceneResources& resources);
void releaseStaticTextures(SceneResources& resources);

}  // namespace boxprobe
