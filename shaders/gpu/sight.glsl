// What is seen from here of the lamps and light sources of the draw's probes: shares from lattices of visibilities (shared/sight.glsl), all
// in one texture, four a texel; a lattice's further fours lie its depth apart. Needs gpu/probe_shares.glsl. The host defines
//   BP_SIGHT_LIGHTS   light sources that some probe's nodes do not see whole
uniform sampler3D bpSights;
uniform vec3 bpSightTexel;             // 1 / size of the texture
uniform vec3 bpSightAt[BP_SLOTS];      // first texel
uniform vec3 bpSightLow[BP_SLOTS];
uniform vec3 bpSightPerUnit[BP_SLOTS];
uniform vec3 bpSightLast[BP_SLOTS];
uniform int bpSightParts[BP_SLOTS];    // fours; 0: the probe sees all of its lamps or nothing of them, everywhere
#if BP_ROTATED
uniform mat3 bpSightTurn[BP_SLOTS];    // from the lattice's axes to the world's
#endif
uniform float bpSightWhole;            // 1 in a first capture: slot 0 has what is seen from the capture origin, and counts alone

vec4 bpSeenShares[4 * BP_SLOTS];

// `position`: relative to the eye; it and the normal along the world's axes. Before bpSeen.
void bpFindSights(vec3 position, vec3 normal)
{
  for (int slot = 0; slot < BP_SLOTS; ++slot)
  {
    LatticeShape lattice;
    lattice.low = bpSightLow[slot];
    lattice.perUnit = bpSightPerUnit[slot];
    lattice.last = bpSightLast[slot];
    lattice.cut = 0.0f;
    lattice.slot = slot;
    vec3 from = position - bpOrigin[slot];
    vec3 n = normal;
#if BP_ROTATED
    from = transpose(bpSightTurn[slot]) * from;
    n = transpose(bpSightTurn[slot]) * n;
#endif
    // As bpTexelSteps: wherever in the texture the lattice lies.
    vec3 texel = bpSightAt[slot] + floor(sightPlace(lattice, from, n) * 8192.0f + 0.5f) / 8192.0f + vec3(0.5f);
    for (int part = 0; part < bpSightParts[slot]; ++part)
    {
      bpSeenShares[4 * slot + part] = textureLod(bpSights, texel * bpSightTexel, 0.0f);
      texel.z += bpSightLast[slot].z + 1.0f;
    }
  }
}

// Of channel 1 and up its share, which the nodes' say divides, channel 0; -1: all of it, -2: nothing.
float bpSeen(int slot, float channel)
{
  int c = int(channel);
  if (c < 0 || bpSightParts[slot] == 0) { return c == -2 ? 0.0f : 1.0f; }  // the texture had no room left
  return sightShare(bpSeenShares[4 * slot + c / 4][c - 4 * (c / 4)], bpSeenShares[4 * slot].x);
}

#if BP_SIGHT_LIGHTS > 0
uniform vec4 bpSightChannel[BP_SIGHT_LIGHTS];  // of each light source in the draw's probes

float bpUnsighted;  // share of the pixel that no probe has: there all is seen

void bpFindLightSights(vec3 positionView, vec3 normalView)
{
  vec3 position = finiteOr(bpViewToWorld * positionView, vec3(0.0f));
  bpUnsighted = (1.0f - bpSightWhole) * bpShareOut(position);
  bpFindSights(position, directionOr(bpViewToWorld * normalView, vec3(0.0f, 1.0f, 0.0f)));
}

float bpLightSeen(int light)
{
  float seen = bpUnsighted;
  for (int slot = 0; slot < BP_SLOTS; ++slot)
  {
    float share = mix(bpShareOf[slot], slot == 0 ? 1.0f : 0.0f, bpSightWhole);
    seen += share * bpSeen(slot, bpSightChannel[light][slot]);
  }
  return seen;
}
#endif
