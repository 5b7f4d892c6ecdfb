// What output.glsl reads, for programs that do not declare it themselves.
uniform float bpParallel; // 1 under parallel projection
uniform float bpExposure; // negative: linear output; else display colours at this exposure
