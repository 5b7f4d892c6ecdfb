// See display_source.h.
#include "filters/vtk/draw/display_source.h"

#include "filters/vtk/gl/full_screen_pass.h"

namespace boxprobe {

std::string displaySource(Tone tone, bool quick) {
  std::string text;
  if (tone == Tone::AsVtk) text += "#define BP_VTK_CURVE\n";
  if (quick) text += "#define BP_QUICK_OUTPUT\n";
  const std::string function = toneFunction(tone);
  if (!function.empty()) text += "#define BP_TONE " + function + "\n" + joinShaderSources({"shared/tone.glsl"});
  return text + joinShaderSources({"shared/display.glsl", "gpu/output.glsl"});
}

std::string displayKey(Tone tone, bool quick) {
  return std::to_string(static_cast<int>(tone)) + (quick ? "q" : "");
}

}  // namespace boxprobe
