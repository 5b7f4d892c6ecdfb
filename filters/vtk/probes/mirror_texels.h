// The texels that mirrors ask of the probes that they show.
#pragma once

#include <cstddef>
#include <map>
#include <string>

#include "filters/vtk/scene/scene_content.h"

class vtkCamera;

namespace boxprobe {

/// By the name of each probe that a visible mirror shows and that has too few: the texels a side with which one of them
/// is as large as a pixel in the middle of a picture of `rows` by that camera, seen from as far. Twice the scene's
/// faceSize or four times, at most 1024; all together take at most `bytes`.
std::map<std::string, int> mirrorFaceSizes(const SceneContent& content, vtkCamera* camera, int rows, std::size_t bytes);

}  // namespace boxprobe
