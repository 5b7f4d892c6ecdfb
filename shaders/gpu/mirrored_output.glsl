// How a surface is drawn into a planar mirror's picture: linear colour within what a half float holds, and beside it the height over the
// mirror's plane. Lies within VTK's main(); both are blended by opacity over transparent black, and so come out premultiplied.
  color = min(color, vec3(65504.0));
  gl_FragData[1] = vec4(dot(bpHeightPlane.xyz, vertexVC.xyz) + bpHeightPlane.w, 0.0, 0.0, opacity);
