#include "filters/core/geometry/probe_diffuse.h"

#include <glm/matrix.hpp>

namespace boxprobe {

float seenAt(const ProbeSight* sight, int channel, const ProbeGeometry& probe, const glm::dvec3& position,
             const glm::vec3& normal) {
  if (channel < 0 || sight == nullptr) return channel == kSeenByNone ? 0.0f : 1.0f;
  const glm::dmat3 probeFromWorld = glm::transpose(probe.worldFromProbe);
  const glm::vec3 place =
      shading::sightPlace(sightShape(*sight, probe), glm::vec3(probeFromWorld * (position - probe.originWorld)),
                          glm::vec3(probeFromWorld * glm::dvec3(normal)));
  const SightLattice& lattice = sight->lattice;
  return shading::sightShare(lattice.fetchSight(place, channel / 4)[channel % 4], lattice.fetchSight(place, 0).x);
}

glm::vec3 diffuseAt(const ProbeDiffuse& diffuse, const ProbeGeometry& probe, const glm::dvec3& position,
                    const glm::vec3& n) {
  if (!diffuse.lattice) {
    const ShCoefficients& c = diffuse.coefficients;
    return shading::shIrradiance(n, c[0], c[1], c[2], c[3], c[4], c[5], c[6], c[7], c[8]);
  }
  const glm::vec3 inProbe(glm::transpose(probe.worldFromProbe) * (position - probe.originWorld));
  const glm::vec3 facing(glm::transpose(probe.worldFromProbe) * glm::dvec3(n));
  glm::vec3 sum = shading::latticeIrradiance(diffuse.lattice->shape(), inProbe, facing, n);
  for (std::size_t i = 0; i < diffuse.lamps.size(); ++i) {
    const SceneLamp& lamp = diffuse.lamps[i];
    const LampPolygon polygon = lampPolygon(lamp, position);
    const int channel = i < diffuse.lampChannels.size() ? diffuse.lampChannels[i] : kSeenByAll;
    sum += seenAt(diffuse.sight.get(), channel, probe, position, n) *
           shading::lampDiffuse(&polygon, glm::vec3(0.0f), n) * glm::vec3(lamp.radiance);
  }
  return sum;
}

}  // namespace boxprobe
