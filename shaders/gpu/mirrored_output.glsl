// Output of a surface in a planar mirror's picture: linear colour in half-float range, and the height over the mirror's
// plane. Part of VTK's main(); both are blended by opacity over transparent black, and so are premultiplied.
  color = min(color, vec3(65504.0));
  gl_FragData[1] = vec4(dot(bpHeightPlane.xyz, vertexVC.xyz) + bpHeightPlane.w, 0.0, 0.0, opacity);
