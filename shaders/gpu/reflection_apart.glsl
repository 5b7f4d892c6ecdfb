// The sampled part of a surface's reflection beside its colour, for a framebuffer with further attachments, so that it can be
// smoothed without the textures it lies on (reflection_blur.glsl). Lies within VTK's main(); BP_APART is 1 for opaque surfaces
// whose technique samples and asks for it, 2 for any other. Those are opaque and overwrite what lay behind them, or are blended:
// then the zeros leave reflection and surface behind as they are, and take from its share what they cover.
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
