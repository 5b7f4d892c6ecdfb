#include "filters/core/scene/surface_view.h"

namespace boxprobe {

// The order is the shader's: shaders/gpu/surface_view.glsl switches on the row's index.
const std::vector<SurfaceViewRow>& surfaceViews() {
  static const std::vector<SurfaceViewRow> rows = {
      {"picture", "Picture", "", "The surfaces as drawn.", ViewKind::Picture, 0, 1},
      {"hit-distance", "Hit distance", "scene units",
       "From the surface along the reflected ray to where it leaves the probe's proxy: the d of the projection.",
       ViewKind::Scalar, 0, 0},
      {"true-distance", "True distance", "scene units",
       "From the surface along the reflected ray to the captured surface, by the probe's distance cubemap.",
       ViewKind::Scalar, 0, 0},
      {"hit-error", "Hit error", "scene units",
       "Distance between the proxy's hit and the true hit: 0 where the scene is the box.", ViewKind::Scalar, 0, 0},
      {"direction-error", "Lookup error", "degrees",
       "Angle at the capture origin between the sampled direction and the direction of the true hit.", ViewKind::Scalar,
       0, 30},
      {"level", "Level", "", "The sampled mip level; the mean if there are several lookups.", ViewKind::Scalar, 0, 0},
      {"roughness", "Effective roughness", "", "The roughness that the sampled mip level was filtered for.",
       ViewKind::Scalar, 0, 1},
      {"direction", "Lookup direction", "", "The sampled direction, x y z from -1 to 1 as red, green and blue.",
       ViewKind::Color, 0, 1},
      {"weights", "Probe weights", "", "Each probe's colour by its share of the pixel; dark grey is the sky's share.",
       ViewKind::Color, 0, 1},
      {"face", "Face hit", "", "The face of the box that the reflected ray hits: -x +x -y +y -z +z.",
       ViewKind::Category, 0, 5},
      {"lookups", "Lookups", "", "Cubemap lookups at this pixel.", ViewKind::Scalar, 0, 8},
      {"diffuse-light", "Diffuse light", "radiance",
       "Irradiance over pi of probes, lamps as shapes and sky: what a white matte surface would show.", ViewKind::Light,
       0, 1},
      {"node-validity", "Node validity", "",
       "Weight of lattice nodes with light of their own: 0 where all nodes around lie within things and are filled.",
       ViewKind::Scalar, 0, 1},
      {"diffuse-error", "Diffuse error", "",
       "Distance between the diffuse light and a path tracer's, over the latter; hatched until it is traced.",
       ViewKind::Scalar, 0, 0.25},
  };
  return rows;
}

std::optional<int> findSurfaceView(std::string_view id) {
  const auto& rows = surfaceViews();
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].id == id) return static_cast<int>(i);
  }
  return std::nullopt;
}

}  // namespace boxprobe
