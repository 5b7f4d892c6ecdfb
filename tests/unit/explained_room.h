// A pixel of a known room, explained: a floor point of a box whose faces each have one colour. What tests of the
// explanation's text, JSON and drawings start from.
#pragma once

#include "filters/explain/explain_pixel.h"

namespace boxprobe {

struct ExplainedRoom {
  ExplainedRoom() {
    probe.name = "room";
    probe.origin = {0.0, 1.0, 0.0};
    probe.box = {{-2.0, 0.0, -3.0}, {2.0, 3.0, 3.0}};
    probe.blendDistance = {glm::dvec3(0.0), glm::dvec3(0.0)};
    maps.radiance = CubeMap(16, 5);
    for (int level = 0; level < 5; ++level) {
      const int size = maps.radiance.levelSize(level);
      for (int face = 0; face < 6; ++face) {
        for (int i = 0; i < size * size; ++i) {
          maps.radiance.setTexel(level, face, i % size, i / size, glm::vec4(0.1f + 0.1f * face, 0.5f, 0.25f, 1.0f));
        }
      }
    }
    surface.object = "floor";
    surface.material = "tiles";
    surface.positionWorld = {0.5, 0.0, 0.0};
    surface.eyeWorld = {-0.7, 1.2, 0.0};
    surface.normalWorld = {0.0f, 1.0f, 0.0f};
    surface.viewWorld = glm::normalize(glm::vec3(surface.eyeWorld - surface.positionWorld));
    surface.albedo = {0.5f, 0.4f, 0.3f};
    surface.roughness = 0.25f;
  }

  Explanation explain() const {
    ExplainInput input;
    input.surface = surface;
    input.probes.push_back({probe.name, 0, 0, probeGeometry(probe, probe.origin), captured ? &maps : nullptr});
    Explanation e = explainPixel(input);
    e.x = 640;
    e.y = 360;
    e.rendered = e.color + glm::vec3(0.001f, 0.0f, 0.0f);
    return e;
  }

  Probe probe;
  BakedMaps maps;
  SurfacePoint surface;
  bool captured = true;
};

}  // namespace boxprobe
