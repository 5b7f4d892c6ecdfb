// Writes the sampled part of a surface's reflection to further attachments, so that it can be smoothed separately from
// the textures (reflection_blur.glsl). Part of VTK's main(). BP_APART is 1 for opaque surfaces whose technique samples
// and requests this, 2 for others. Those are opaque and overwrite what is behind, or are blended: then the zeros
// preserve reflection and surface behind, and reduce its share by their coverage.
#if BP_APART == 1
  gl_FragData[1] = vec4(bpLight.sampled, roughness);
#ifdef CLEAR_COAT
  gl_FragData[2] = vec4(specularBrdf * coatColorFactor * mix(1.0, ao, aoStrengthUniform), 1.0);
#else
  gl_FragData[2] = vec4(specularBrdf * mix(1.0, ao, aoStrengthUniform), 1.0);
#endif
  gl_FragData[3] = vec4(N, -vertexVC.z); // view space
#else
  gl_FragData[1] = vec4(0.0);
  gl_FragData[2] = vec4(0.0, 0.0, 0.0, opacity);
  gl_FragData[3] = vec4(0.0);
#endif
