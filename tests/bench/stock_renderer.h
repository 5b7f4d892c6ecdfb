// The yardstick: the same geometry, materials, lights and camera drawn by VTK's own mapper and image-based lighting.
#pragma once

#include <vtkSmartPointer.h>

#include <functional>
#include <glm/vec3.hpp>

#include "filters/core/scene/scene.h"

class vtkActor;
class vtkOpenGLRenderer;
class vtkRenderer;

namespace boxprobe::bench {

/// VTK 9.1's default size of the diffuse irradiance map; 32 is enough to time frames after the first.
constexpr int kVtkIrradianceSize = 256;

/// The same geometry, property and place under VTK's own mapper.
vtkSmartPointer<vtkActor> stockActor(vtkActor* ours);

/// Radiance of a sky in a direction of length 1, world.
using StockSky = std::function<glm::vec3(const glm::vec3&)>;
StockSky gradientSky(const SkyGradient& sky);

/// A copy of `ours` for the same window: its actors' geometry and properties under stock mappers, its lights and its
/// camera, a 256² cube map of `sky` as environment and drawn as background.
vtkSmartPointer<vtkOpenGLRenderer> makeStockRenderer(vtkRenderer* ours, const StockSky& sky, int irradianceSize = 32);

}  // namespace boxprobe::bench
