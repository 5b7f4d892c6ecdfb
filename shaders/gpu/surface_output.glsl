// Writes the surface's properties at a pixel to further attachments: read by filters/vtk/inspect/surface_capture.cpp,
// explained by filters/explain/explain_pixel.cpp. Part of VTK's main(), debug view only.
  gl_FragData[1] = vec4(bpViewToWorld * vertexVC.xyz, bpObject); // relative to the eye, world axes
  gl_FragData[2] = vec4(bpViewToWorld * N, roughness);
  gl_FragData[3] = vec4(albedo, metallic);
  gl_FragData[4] = vec4(emissiveColor, mix(1.0, ao, aoStrengthUniform));
#ifdef CLEAR_COAT
  gl_FragData[5] = vec4(bpViewToWorld * coatN, coatRoughness);
  gl_FragData[6] = vec4(baseF0Uniform, opacity, coatStrength, coatF0Uniform);
#else
  gl_FragData[5] = vec4(0.0);
  gl_FragData[6] = vec4(baseF0Uniform, opacity, 0.0, 0.0);
#endif
#if defined(BP_FINISH) && !defined(BP_GLASS)
  // Finish properties are written in a separate pass.
  if (bpFinishShown != 0)
  {
    gl_FragData[1] = vec4(bpFinish.f0, bpFinish.edge);
    gl_FragData[2] = vec4(bpFinish.sheenColor, bpFinish.sheenRoughness);
    gl_FragData[3] = vec4(bpViewToWorld * bpFinish.across, bpFinish.anisotropy);
    gl_FragData[4] = vec4(bpFinish.film, bpFinish.thickness, 0.0, 0.0);
  }
#endif
#ifdef BP_GLASS
  if (bpFinishShown != 0) { gl_FragData[1] = vec4(1.0f BP_THICKNESS_FACTOR, 1.0f BP_TRANSMISSION_FACTOR, 0.0, 0.0); }
  // Faces refract light depending on the side that is seen.
  gl_FragData[6].y = gl_FrontFacing ? 1.0 : -1.0;
#endif
