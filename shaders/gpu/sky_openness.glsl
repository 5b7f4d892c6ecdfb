// How much of the sky is open at a place (shared/sky_openness.glsl before it), looked up a node off the surface, so that no node behind it
// has much of a say.
uniform sampler3D bpOpenMap;
uniform vec3 bpOpenLow;    // lattice's corner minus camera position, world axes
uniform vec3 bpOpenScale;  // 1 / its extent
uniform float bpOpenOff;   // scene units
uniform float bpOpenOn;    // 0 while it is not known

float bpOpenness(vec3 position, vec3 normal)
{
  vec3 place = (position + bpOpenOff * normal - bpOpenLow) * bpOpenScale;
  return mix(1.0f, skyOpenness(texture(bpOpenMap, place), normal), bpOpenOn);
}
