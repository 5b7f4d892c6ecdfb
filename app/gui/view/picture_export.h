// The picture in the window as a file. Called by the window's file commands; asks nobody, and knows no dialog.
#pragma once

#include <string>

class vtkReflectionProbeRepresentation;

namespace boxprobe {

class SceneRenderer;
class Viewport;

/// What the window shows once it is at rest, without handles and preview sphere: display colours, or, for a path that
/// ends in .exr, linear light at four samples per pixel. Throws WorkError if the file cannot be written.
void exportPicture(const std::string& path, SceneRenderer& renderer, Viewport& viewport,
                   vtkReflectionProbeRepresentation& handles);

}  // namespace boxprobe
